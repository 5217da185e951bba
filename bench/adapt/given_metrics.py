# SPDX-License-Identifier: MIT
"""Metrics given by formulas, as the acceptance tests of NASA's refine have them in two dimensions, on the
unit square: loops of `asterism adapt --metric`, the metric at the vertices of the mesh before. Prints the
least and the greatest length of an edge beside the limits that those tests have; exit status 1 where a loop
is outside or a run is not certified.

  given_metrics.py --asterism COMMAND [--metrics NAME...] [--rounds N]
"""
import argparse
import os
import pathlib
import subprocess
import sys

import numpy as np

sys.path.insert(0, str(pathlib.Path(__file__).parent))
import meshes  # noqa: E402


def along_axes(across_x, across_y):
    """Returns tensors with these lengths along the axes."""
    zero = np.zeros_like(across_x)
    return np.stack([np.stack([across_x**-2, zero], -1), np.stack([zero, across_y**-2], -1)], -2)


def around(x, y, radial, tangential):
    """Returns tensors with these lengths along and across rays from the origin, which is outside of the domain."""
    r = np.hypot(x, y)
    ray = np.stack([x / r, y / r], -1)
    turned = np.stack([-ray[:, 1], ray[:, 0]], -1)
    return (np.einsum("n,ni,nj->nij", radial**-2, ray, ray)
            + np.einsum("n,ni,nj->nij", tangential**-2, turned, turned))


def around_origin(x, y, radial, tangential):
    """Returns the same where the origin is a point of the domain. There the direction is that of x."""
    return around(np.where(np.hypot(x, y) > 0, x, 1), y, radial, tangential)


def side(x, y):
    return along_axes(0.1 + 0 * x, 0.01 + 0.09 * y)


def masabl(x, y):
    return along_axes(0.01 + 0.2 * np.cos(np.pi * (x - 0.5)), 0.001 * np.exp(6 * y))


def radial_1(x, y):
    return around(x + 0.5, y - 0.5, 0.01 + 0 * x, 0.1 + 0 * x)


def across_layer(distance):
    return 0.001 + 0.198 * distance


def linear(x, y):
    return along_axes(0.1 + 0 * x, across_layer(np.abs(y - 0.5)))


def polar_2(x, y):
    distance = np.abs(np.hypot(x, y) - 0.5)
    part = np.minimum(10 * distance, 1)
    return around_origin(x, y, across_layer(distance), 0.1 * part + 0.025 * (1 - part))


def circle_1(x, y):
    x, y = x + 0.5, y - 0.5
    r = np.hypot(x, y)
    return around_origin(x, y, 0.0005 + 1.5 * np.abs(1 - r), 0.1 * r + 1.5 * np.abs(1 - r))


# Formula, limits of the lengths, options of the command.
METRICS = {
    "linear": (linear, 0.40, 1.8),
    "polar-2": (polar_2, 0.20, 3.0),
    "circle-1": (circle_1, 0.30, 3.5, "--gradation", "1.5"),
    "side": (side, 0.50, 1.6),
    "masabl": (masabl, 0.40, 1.8),
    "radial-1": (radial_1, 0.25, 1.6),
}


def unit_grid(n):
    mesh = meshes.grid(n)
    return meshes.Mesh((mesh.points + 1) / 2, mesh.triangles)


def write_with_corners(path, mesh):
    """Writes the mesh with the corners of the unit square, and the square's sides as edges."""
    full = meshes.Mesh(2 * mesh.points - 1, mesh.triangles)
    edges, sides = meshes.border(full)
    corners = [int(np.argmin(np.hypot(*(mesh.points - c).T))) for c in ((0, 0), (1, 0), (1, 1), (0, 1))]
    with open(path, "w", encoding="utf-8") as out:
        out.write(f"MeshVersionFormatted 2\nDimension 2\nVertices\n{len(mesh.points)}\n")
        out.writelines(f"{x:.17g} {y:.17g} 0\n" for x, y in mesh.points)
        out.write(f"Edges\n{len(edges)}\n")
        out.writelines(f"{a + 1} {b + 1} {s}\n" for (a, b), s in zip(edges, sides))
        out.write(f"Triangles\n{len(mesh.triangles)}\n")
        out.writelines(f"{a + 1} {b + 1} {c + 1} 0\n" for a, b, c in mesh.triangles)
        out.write("Corners\n4\n" + "".join(f"{c + 1}\n" for c in corners) + "End\n")


def lengths_of(mesh, edges, tensors):
    """Returns the length of each edge, the logarithmic mean of the lengths in the metrics of its two ends."""
    d = mesh.points[edges[:, 1]] - mesh.points[edges[:, 0]]
    a, b = (np.sqrt(np.einsum("ni,nij,nj->n", d, tensors[edges[:, k]], d)) for k in (0, 1))
    ratio = np.log(b / a)
    alike = np.abs(ratio) < 1e-6
    return np.where(alike, (a + b) / 2, (b - a) / np.where(alike, 1, ratio))


def loop(name, options, folder):
    """Returns status of the last round, number of vertices, and lengths in the metric of the formula, or in the
    graded one."""
    formula, _, _, *grading = METRICS[name]
    mesh, status = unit_grid(options.start), None
    for _ in range(options.rounds):
        write_with_corners(folder / "old.mesh", mesh)
        tensors = formula(*mesh.points.T)
        meshes.write_sol(folder / "wanted.sol", tensors)
        done = subprocess.run([options.asterism, "adapt", "old.mesh", "--metric", "wanted.sol", *grading,
                               "--threads", "1", "--quiet", "-o", "new.mesh"], cwd=folder, check=False)
        status = done.returncode
        mesh = meshes.read(folder / "new.mesh")
    t = mesh.triangles
    edges = np.unique(np.sort(np.concatenate([t[:, [0, 1]], t[:, [1, 2]], t[:, [2, 0]]]), axis=1), axis=0)
    tensors = formula(*mesh.points.T)
    if grading:  # the graded metric, on the mesh before
        tensors = meshes.read_sol(folder / "new.sol")
    return status, len(mesh.points), lengths_of(mesh, edges, tensors)


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--asterism", required=True)
    parser.add_argument("--work", default="/tmp/bench-given-metrics")
    parser.add_argument("--metrics", nargs="+", default=list(METRICS), choices=list(METRICS))
    parser.add_argument("--rounds", type=int, default=8)
    parser.add_argument("--start", type=int, default=4, help="cells along a side, of the first grid")
    options = parser.parse_args()
    options.asterism = os.path.abspath(options.asterism)
    outside = 0
    print("| metric | status | vertices | least, greatest | limits |\n|---|---|---|---|---|")
    for name in options.metrics:
        folder = pathlib.Path(options.work) / name
        folder.mkdir(parents=True, exist_ok=True)
        status, count, lengths = loop(name, options, folder)
        _, low, high, *_ = METRICS[name]
        good = status == 0 and low <= lengths.min() and lengths.max() <= high
        outside += 0 if good else 1
        print(f"| {name} | {status} | {count} | {lengths.min():.2f}, {lengths.max():.2f} "
              f"| {low:.2f}, {high:.2f} |{'' if good else ' outside'}", flush=True)
    return 1 if outside else 0


if __name__ == "__main__":
    sys.exit(main())
