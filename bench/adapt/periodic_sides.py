# SPDX-License-Identifier: MIT
"""First meshes of functions on a torus, without periodic sides, with one pair and with two: vertices, and errors of
linear interpolation in the mean square times 1,000. The table of docs/results/solvers.md. Needs the Python package.

  periodic_sides.py [--vertices N...]
"""
import argparse
import pathlib
import sys

import numpy as np

import asterism

sys.path.insert(0, str(pathlib.Path(__file__).parent))
import meshes  # noqa: E402

CELLS = 14
BELOW, RIGHT, ABOVE, LEFT = 1, 2, 3, 4
PAIRS = {"no pair": [], "one pair": [(LEFT, RIGHT)], "two pairs": [(LEFT, RIGHT), (BELOW, ABOVE)]}
FUNCTIONS = {"front": lambda p: np.tanh(8 * np.sin(2 * np.pi * (p[:, 0] - p[:, 1]))),
             "waves": lambda p: np.sin(2 * np.pi * p[:, 0]) * np.cos(2 * np.pi * p[:, 1])}


def square():
    """Returns a grid of the unit square with marked sides. The diagonals of its cells run along the front."""
    row = CELLS + 1
    points = np.array([(i / CELLS, j / CELLS) for j in range(row) for i in range(row)])
    first = [j * row + i for j in range(CELLS) for i in range(CELLS)]
    triangles = np.array([t for a in first for t in ((a, a + 1, a + row + 1), (a, a + row + 1, a + row))])
    edges, markers = [], []
    for i in range(CELLS):
        edges += [(i, i + 1), (CELLS * row + i, CELLS * row + i + 1), (i * row, (i + 1) * row),
                  (i * row + CELLS, (i + 1) * row + CELLS)]
        markers += [BELOW, ABOVE, LEFT, RIGHT]
    return asterism.Mesh(points, triangles, edges=np.array(edges), edge_markers=np.array(markers))


def cell(function, vertices, pairs):
    mesh = square()
    made = asterism.adapt(mesh, function(mesh.points), vertices=vertices, **({"periodic": pairs} if pairs else {})).mesh
    error = meshes.l2_error(meshes.Mesh(made.points, made.triangles), function)
    return f"{len(made.points):,}, {1000 * error:.3g}"


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--vertices", nargs="+", type=int, default=[200, 400, 1000, 4000])
    options = parser.parse_args()
    print("| wanted | " + " | ".join(f"{name}, {pair}" for name in FUNCTIONS for pair in PAIRS) + " |")
    print("|---" * (1 + len(FUNCTIONS) * len(PAIRS)) + "|")
    for vertices in options.vertices:
        cells = [cell(function, vertices, pairs) for function in FUNCTIONS.values() for pairs in PAIRS.values()]
        print(f"| {vertices:,} | {' | '.join(cells)} |", flush=True)


if __name__ == "__main__":
    main()
