# SPDX-License-Identifier: MIT
"""Reads a mesh in pieces onto the ranks of MPI, without gathering it anywhere.

Each rank reads its own pieces and the index, which knows the vertices on seams. A vertex belongs to the
least rank that has it; numbers are global, those of a rank in a row.
"""
import json
import pathlib

import numpy


def _section(lines, keyword, columns):
    at = lines.index(keyword)
    count = int(lines[at + 1])
    rows = " ".join(lines[at + 2:at + 2 + count]).split()
    return numpy.array(rows, dtype=object).reshape(count, columns)


def read_piece(path):
    """Returns coordinates, triangles (from 0), their regions, and edges of the boundary with their markers."""
    lines = [line for line in pathlib.Path(path).read_text(encoding="utf-8").split("\n")
             if not line.startswith("#")]
    points = _section(lines, "Vertices", 3)[:, :2].astype(float)
    triangles = _section(lines, "Triangles", 4).astype(int)
    edges = _section(lines, "Edges", 3).astype(int)
    return points, triangles[:, :3] - 1, triangles[:, 3], edges - [1, 1, 0]


def seam_vertices(index):
    """Returns, for the vertices on seams by their coordinates, the numbers from 0 of the pieces that have them."""
    given = index["domain"]["vertices"] + index["cut"]["vertices"]
    points = {seam["edge"]: seam["points"] for seam in index["seams"]}
    shared = {}
    for number, edge in enumerate(index["cut"]["edges"], 1):
        pieces = {p - 1 for p in edge[6:8] if p}
        for x, y in [given[edge[0] - 1], given[edge[1] - 1], *points.get(number, [])]:
            shared.setdefault((x, y), set()).update(pieces)
    return {q: pieces for q, pieces in shared.items() if len(pieces) > 1}


class DistributedMesh:
    """The part of a rank: `points` it owns, whose global numbers begin with `first`; `cells` by global numbers;
    `regions` of these; `edges` of the boundary by global numbers, with `markers`."""

    def __init__(self, comm, folder):
        folder = pathlib.Path(folder)
        index = json.loads((folder / "index.json").read_text(encoding="utf-8"))
        pieces = index["pieces"]
        self.vertices = index["outcome"]["vertices"]
        self.cut_marker = index["cut"]["marker"]
        share = [p * comm.size // len(pieces) for p in range(len(pieces))]  # the rank of each piece
        shared = seam_vertices(index)
        mine = [p for p in range(len(pieces)) if share[p] == comm.rank]
        read = [read_piece(folder / pieces[p]["mesh"]) for p in mine]
        ranks_of = {q: sorted({share[p] for p in at}) for q, at in shared.items()}

        owned, number = [], {}  # global numbers of owned vertices on seams, by coordinates
        local = []  # for each piece the number of each vertex, -1 where another rank owns it
        for points, *_ in read:
            numbers = numpy.full(len(points), -1, dtype=numpy.int64)
            for v, q in enumerate(map(tuple, points)):
                if q in ranks_of and (ranks_of[q][0] != comm.rank or q in number):
                    numbers[v] = number.get(q, -1)
                    continue
                numbers[v] = len(owned)
                owned.append(q)
                if q in ranks_of:
                    number[q] = numbers[v]
            local.append(numbers)
        self.points = numpy.array(owned, dtype=float).reshape(-1, 2)
        self.first = sum(comm.allgather(len(owned))[:comm.rank])

        # Owners send the numbers of seam vertices to the ranks that share them.
        tell = [{} for _ in range(comm.size)]
        for q, n in number.items():
            for rank in ranks_of[q]:
                tell[rank][q] = self.first + int(n)
        told = {}
        for one in comm.alltoall(tell):
            told.update(one)
        cells, regions, edges, markers = [], [], [], []
        for (points, triangles, of_cells, sides), numbers in zip(read, local):
            there = numpy.where(numbers >= 0, numbers + self.first, -1)
            for v in numpy.flatnonzero(numbers < 0):
                there[v] = told[tuple(points[v])]
            cells.append(there[triangles])
            regions.append(of_cells)
            edges.append(there[sides[:, :2]])
            markers.append(sides[:, 2])
        self.cells = numpy.concatenate(cells or [numpy.empty((0, 3), dtype=numpy.int64)])
        self.regions = numpy.concatenate(regions or [numpy.empty(0, dtype=int)])
        self.edges = numpy.concatenate(edges or [numpy.empty((0, 2), dtype=numpy.int64)])
        self.markers = numpy.concatenate(markers or [numpy.empty(0, dtype=int)])
