#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Counts what the seams of a mesh in pieces cost: seams.py DIR."""
import json
import pathlib
import sys

import numpy as np


def section(lines, keyword, columns):
    at = next(i for i, line in enumerate(lines) if line.startswith(keyword))
    more = 1 if keyword == "SolAtVertices" else 0
    count = int(lines[at + 1])
    rows = " ".join(lines[at + 2 + more:at + 2 + more + count]).split()
    return np.array(rows, dtype=float).reshape(count, columns)


def lines_of(path):
    return [line for line in path.read_text().split("\n") if not line.startswith("#")]


def lengths(metric, way):
    x, y = way[:, 0], way[:, 1]
    return np.sqrt(metric[:, 0] * x * x + 2 * metric[:, 1] * x * y + metric[:, 2] * y * y)


def least_angles(points, metric, triangles):
    """Returns the least angle of each triangle in degrees, over its corners and the metrics of all three vertices."""
    least = np.full(len(triangles), 180.0)
    for seen_by in range(3):
        m11, m12, m22 = metric[triangles[:, seen_by]].T
        for corner in range(3):
            at = points[triangles[:, corner]]
            a = points[triangles[:, (corner + 1) % 3]] - at
            b = points[triangles[:, (corner + 2) % 3]] - at
            dot = (m11 * a[:, 0] * b[:, 0] + m12 * (a[:, 0] * b[:, 1] + a[:, 1] * b[:, 0])
                   + m22 * a[:, 1] * b[:, 1])
            cross = np.sqrt(m11 * m22 - m12 * m12) * (a[:, 0] * b[:, 1] - a[:, 1] * b[:, 0])
            least = np.minimum(least, np.degrees(np.arctan2(cross, dot)))
    return least


def main():
    folder = pathlib.Path(sys.argv[1])
    index = json.loads((folder / "index.json").read_text())
    edge_lengths = {"on seams": [], "ending on seams": [], "others": []}
    angles = {"on seams": [], "others": []}
    for piece in index["pieces"]:
        lines = lines_of(folder / piece["mesh"])
        points = section(lines, "Vertices", 3)[:, :2]
        triangles = section(lines, "Triangles", 4)[:, :3].astype(int) - 1
        boundary = section(lines, "Edges", 3).astype(int)
        metric = section(lines_of((folder / piece["mesh"]).with_suffix(".sol")), "SolAtVertices", 3)
        seams = np.sort(boundary[boundary[:, 2] == index["cut"]["marker"]][:, :2] - 1, axis=1)
        on_seam = np.zeros(len(points), bool)
        on_seam[seams.ravel()] = True
        edges = np.unique(np.sort(np.concatenate([triangles[:, [0, 1]], triangles[:, [1, 2]],
                                                  triangles[:, [2, 0]]]), axis=1), axis=0)
        way = points[edges[:, 1]] - points[edges[:, 0]]
        length = (lengths(metric[edges[:, 0]], way) + lengths(metric[edges[:, 1]], way)) / 2
        is_seam = np.isin(edges @ [len(points), 1], seams @ [len(points), 1])
        touches = on_seam[edges].any(axis=1) & ~is_seam
        edge_lengths["on seams"].append(length[is_seam])
        edge_lengths["ending on seams"].append(length[touches])
        edge_lengths["others"].append(length[~is_seam & ~touches])
        least = least_angles(points, metric, triangles)
        beside = on_seam[triangles].any(axis=1)
        angles["on seams"].append(least[beside])
        angles["others"].append(least[~beside])
    for name, all_of in edge_lengths.items():
        one = np.concatenate(all_of)
        unit = ((one >= 0.5 ** 0.5) & (one <= 2 ** 0.5)).mean() if len(one) else 0
        print(f"edges {name}: {len(one)}, mean {one.mean():.3f}, unit {100 * unit:.2f} %")
    for name, all_of in angles.items():
        one = np.concatenate(all_of)
        print(f"triangles {name}: {len(one)}, worst angle {one.min():.2f}, mean {one.mean():.2f}")
    counts = np.array([p["triangles"] for p in index["pieces"]])
    print(f"triangles of a piece over the mean: {counts.min() / counts.mean():.3f} to "
          f"{counts.max() / counts.mean():.3f}")


if __name__ == "__main__":
    main()
