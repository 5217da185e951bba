#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Measures the heights of the first cells along walls with --layers, as docs/results/layers.md has them.

    bench/layers/first_cells.py build/release/apps/asterism

A first cell is a triangle with a side on the wall; its height is the distance of the third vertex from that
side. Prints a row of the table for each mesh, which `verify` has judged."""
import math
import pathlib
import resource
import subprocess
import sys
import tempfile

# The channel of the benchmark "flow around a cylinder" of Schaefer and Turek, 1996; the cylinder's marker is 2.
CHANNEL = ("5 2\n1 0 0\n2 2.2 0\n3 2.2 0.41\n4 0 0.41\n5 0.25 0.2\n4 1\n1 1 2 1\n2 2 3 3\n3 3 4 1\n4 4 1 4\n"
           "1\n1 0.2 0.2\n0\ncurves 1\n1 circle 5 0.2 0.2 2\n")
JOBS = [("channel.poly", 0.05, 1e-3, 1.2, 2), ("channel.poly", 0.05, 1e-4, 1.2, 2), ("channel.poly", 0.05, 2e-5, 1.2, 2),
        ("channel.poly", 0.05, 1e-3, 1.2, 1), ("airfoil", 0.3, 1e-3, 1.2, 2), ("airfoil", 0.3, 1e-4, 1.2, 2),
        ("airfoil", 0.3, 1e-4, 1.4, 2), ("airfoil", 0.3, 2e-5, 1.2, 2), ("square", 0.2, 1e-4, 1.2, 1)]


def tables(path):
    words = path.read_text().split()

    def table(name, columns, kind):
        at = words.index(name)
        return [tuple(map(kind, words[at + 2 + columns * i:at + 2 + columns * (i + 1)])) for i in range(int(words[at + 1]))]
    return table("Vertices", 3, float), table("Edges", 3, int), table("Triangles", 4, int)


def first_heights(path, marker):
    vertices, edges, triangles = tables(path)
    wall = {frozenset(edge[:2]) for edge in edges if edge[2] == marker}
    found = []
    for a, b, c, _ in triangles:
        for p, q, r in ((a, b, c), (b, c, a), (c, a, b)):
            if frozenset((p, q)) in wall:
                (px, py, _), (qx, qy, _), (rx, ry, _) = vertices[p - 1], vertices[q - 1], vertices[r - 1]
                found.append(((qx - px) * (ry - py) - (qy - py) * (rx - px)) / math.hypot(qx - px, qy - py))
    return sorted(found)


def main():
    program = pathlib.Path(sys.argv[1]).resolve()
    with tempfile.TemporaryDirectory() as folder:
        pathlib.Path(folder, "channel.poly").write_text(CHANNEL)
        for domain, size, height, growth, marker in JOBS:
            before = resource.getrusage(resource.RUSAGE_CHILDREN).ru_utime
            made = subprocess.run([program, "mesh", domain, "--size", str(size), "--layers",
                                   f"{marker}:{height},{growth}", "--max-sites", "1000000", "--quiet", "-o", "m.mesh"],
                                  cwd=folder, check=False)
            seconds = resource.getrusage(resource.RUSAGE_CHILDREN).ru_utime - before
            verified = subprocess.run([program, "verify", "m.mesh"], cwd=folder, check=False, stdout=subprocess.DEVNULL)
            path = pathlib.Path(folder, "m.mesh")
            ratios = [h / height for h in first_heights(path, marker)]
            within = sum(abs(r - 1) <= 0.2 for r in ratios) / len(ratios)
            at = [ratios[min(len(ratios) - 1, int(part * len(ratios)))] for part in (0, 0.05, 0.5, 0.95, 1)]
            print(f"| {domain} | {marker} | {height:g} | {growth} | {len(tables(path)[0])} | "
                  f"{made.returncode}, {verified.returncode} | {len(ratios)} | "
                  + " | ".join(f"{r:.3f}" for r in at) + f" | {100 * within:.1f} | {seconds:.1f} |", flush=True)


main()
