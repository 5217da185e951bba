# SPDX-License-Identifier: MIT
"""Inputs of the recorded runs. Coordinates are written out or are quotients of small integers, so
that every machine makes the same files."""

SQUARE = """4 2 0 0
1 0 0
2 1 0
3 1 1
4 0 1
4 1
1 1 2 1
2 2 3 2
3 3 4 3
4 4 1 4
0
"""

# A frame with a square hole, an inclusion, a crack from the upper side and a point on no segment.
FRAME = """13 2 0 0
1 0 0
2 3 0
3 3 2
4 0 2
5 0.5 0.5
6 1.25 0.5
7 1.25 1.25
8 0.5 1.25
9 1.75 0.5
10 2.5 0.625
11 2 1.125
12 2.25 1.375
13 1.5 1.625
12 1
1 1 2 1
2 2 3 2
3 3 4 3
4 4 1 4
5 5 6 5
6 6 7 5
7 7 8 5
8 8 5 5
9 9 10 6
10 10 11 6
11 11 9 6
12 3 12 7
1
1 0.75 0.75
2
1 0.125 0.125 1
2 2 0.75 2
"""

# Two provinces that touch, one with a lake.
PROVINCES = """{"type": "FeatureCollection", "features": [
{"type": "Feature", "properties": {"name": "west"}, "geometry": {"type": "Polygon", "coordinates":
[[[0, 0], [1, 0], [1, 1], [0, 1], [0, 0]], [[0.25, 0.25], [0.25, 0.75], [0.75, 0.5], [0.25, 0.25]]]}},
{"type": "Feature", "properties": {"name": "east"}, "geometry": {"type": "Polygon", "coordinates":
[[[1, 0], [2, 0.25], [2, 0.75], [1, 1], [1, 0]]]}}]}
"""
WKT = "MULTIPOLYGON (((0 0, 2 0, 2 1, 0 1, 0 0), (0.5 0.25, 0.5 0.75, 1.5 0.5, 0.5 0.25)), ((3 0, 4 0, 3 1, 3 0)))"

# A domain of the same kind, numbered from 0, with its vertices in a file of their own.
NODES = """# the vertices
5 2 1 1
0 0 0 0.5 1
1 2 0 0.5 1
2 2.5 1.5 0.5 1
3 1 2.25 0.5 1
4 -0.25 1.25 0.5 1
"""
NODES_POLY = """0 2 0 0
5 1
0 0 1 1
1 1 2 1
2 2 3 2
3 3 4 3
4 4 0 1
0
"""

# Faults that are mended with a note: a point twice, a segment without length, segments that overlap, a vertex on a
# segment, parts outside, a limit on areas.
REPAIRED = """10 2 0 0
1 0 0
2 2 0
3 2 2
4 0 2
5 1 0
6 0 0
7 5 5
8 0.5 0.5
9 1.5 0.5
10 1 1.5
9 1
1 1 2 1
2 2 3 0
3 3 4 3
4 4 6 4
5 5 2 9
6 8 8 5
7 8 9 6
8 3 2 7
9 9 8 6
0
1
1 1 0.25 3 0.01
"""

# Two parts, one of them a ring with an island in its hole.
PARTS = """15 2 0 0
1 0 0
2 4 0
3 4 4
4 0 4
5 1 1
6 3 1
7 3 3
8 1 3
9 1.5 1.5
10 2.5 1.5
11 2 2.5
12 5 0
13 7 0
14 7 2
15 5 1
15 1
1 1 2 1
2 2 3 1
3 3 4 1
4 4 1 1
5 5 6 2
6 6 7 2
7 7 8 2
8 8 5 2
9 9 10 3
10 10 11 3
11 11 9 3
12 12 13 4
13 13 14 4
14 14 15 4
15 15 12 4
1
1 1.25 1.25
"""

# Corners of about 4 and 8 degrees.
SHARP = """4 2 0 0
1 0 0
2 4 0
3 4 2
4 3.75 0.25
4 0
1 1 2
2 2 3
3 3 4
4 4 1
0
"""

RECORDS = """# one of each, then ties and near ties
orientation 0 0  1 0  0x1p-3 1
orientation 0 0  1 1  2 2
orientation 0.1 0.1  0.2 0.2  0.30000000000000004 0.3
is_spd 1 2 1
is_spd 2 1 2
compare_distance 0 0 1 0 1  2 0 1 0 1  1 5
compare_distance 0 0 1 0 1  2 0 4 1 3  0.75 0.5
in_wedge 0 0 1 0 1  2 0 4 1 3  1 0.25
dominates 0 0 1 0 1  2 0 4 1 3  3 0.5
voronoi_vertex_count 0 0 1 0 1  2 0 4 1 3  1 2 2 0.5 1
arc_intersection_count 0 0 1 0 1  2 0 4 1 3  1 2 2 0.5 1
encroaches 0 0 1 0 1  2 0 1 0 1  1 0.5 1 0 1
encroaches 0 0 1 0 1  2 0 1 0 1  1 1.5 1 0 1
insertion_test 0 0 1 0 1  0.5 0 1 0 1  1 0.25 3 0.5 1  0.25 1 1 0 2
edge_test 0 0 1 0 1  1 1 1 0 1  1 0 1 0 1  0 1 1 0 1
edge_test 0 0 1 0 1  0.5 0.25 1 0 1  1 0 3 0.5 1  0 1 1 0 2

"""
BAD_RECORDS = """orientation 0 0  1 0  1
orientation 0 0  1 0  0 one
is_spd 1 2 nan
is_spd 1 0 1e999
left_turn 0 0  1 0  0 1
in_wedge 0 0 1 2 1  2 0 4 1 3  1 0.25
compare_distance 1 1 1 0 1  1 1 2 0 1  0 0
is_spd 1 0 1
"""


def changed(text, old, new):
    """Returns `text` with the first `old` replaced. Raises if there is none."""
    if old not in text:
        raise ValueError(f"{old!r} is not in the text")
    return text.replace(old, new, 1)


def section(name, rows):
    return [name, str(len(rows)), *(" ".join(map(str, row)) for row in rows)]


def medit(vertices, triangles, edges=()):
    """Returns a .mesh file. Each row ends in a reference."""
    lines = ["MeshVersionFormatted 1", "Dimension 2", *section("Vertices", vertices)]
    lines += section("Triangles", triangles)
    if edges:
        lines += section("Edges", edges)
    return "\n".join([*lines, "End", ""])


def solution(tensors):
    """Returns a .sol file of tensors m11, m12, m22."""
    lines = ["MeshVersionFormatted 1", "Dimension 2", *section("SolAtVertices", tensors), "End", ""]
    return "\n".join([*lines[:4], "1 3", *lines[4:]])


def values(numbers):
    """Returns a .sol file of a number at each vertex."""
    lines = ["MeshVersionFormatted 1", "Dimension 2", *section("SolAtVertices", [(u,) for u in numbers]), "End", ""]
    return "\n".join([*lines[:4], "1 1", *lines[4:]])


def tensors_of_bamg(rows):
    """Returns a .mtr file. Each row is a tensor, or one length."""
    return "\n".join([f"{len(rows)} {len(rows[0])}", *(" ".join(map(str, r)) for r in rows), ""])


def grid_places(n):
    return [(i / n, j / n) for j in range(n + 1) for i in range(n + 1)]


def grid(n):
    """Returns a square of n by n cells, each cut along its rising diagonal. Lists no edges."""
    at = [[i + j * (n + 1) + 1 for i in range(n + 1)] for j in range(n + 1)]
    cells = [(i, j) for j in range(n) for i in range(n)]
    triangles = [t for i, j in cells for t in ((at[j][i], at[j][i + 1], at[j + 1][i + 1], 7),
                                               (at[j][i], at[j + 1][i + 1], at[j + 1][i], 7))]
    return medit([(x, y, 0) for x, y in grid_places(n)], triangles)


def grid_tensors(n, tensor):
    return [tensor(x, y) for x, y in grid_places(n)]


def grid_values(n):
    """Returns values of a front along a parabola: quotients, the same on every machine."""
    return [1 / (1 + 400 * (y - x * x) ** 2) for x, y in grid_places(n)]


def slanted(_x, _y):
    """Returns a tensor in which all triangles of a grid are equilateral."""
    return 1, -0.5, 1


def varying(x, y):
    """Returns a tensor in which the triangles of a grid have small angles."""
    return 30 * (1 + 2 * x), 9 * x * y, 25 * (1 + 8 * y * y)


def reaching(x, y):
    """Changes the middle site's metric so that its cell reaches over its neighbours' cells, between the corners of
    these."""
    return (0.05, 0, 2) if x == y == 0.5 else (1, 0, 1)


TRIANGLE = medit([(0, 0, 0), (1, 0, 0), (0, 1, 0)], [(1, 2, 3, 0)])
TRIANGLE_SOLUTION = solution([(1, 0, 1)] * 3)
INVERTED = medit([(0, 0, 0), (1, 0, 0), (1, 1, 0), (0, 1, 0)], [(1, 2, 3, 0), (1, 4, 3, 0)])
