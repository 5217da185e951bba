#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Adapts meshes with periodic sides that bend: bent_sides.py --asterism PROGRAM [--jobs channels rings] [--list]
[--no-pairs] [-- OPTIONS].

*channels*: sides that are bent lines, one the other shifted; *rings*: quarters of rings whose straight sides are bent,
one the other turned. Prints how many jobs are complete with the number of vertices wanted, to a tenth, how many with
another number, and how many are not complete. --list prints a line for each job, --no-pairs leaves sides without
partners, and OPTIONS are the command's."""
import argparse
import itertools
import pathlib
import re
import resource
import subprocess
import sys
import tempfile

import numpy as np

sys.path.insert(0, str(pathlib.Path(__file__).parent))
import meshes  # noqa: E402

sin, cos, tanh, TURN = np.sin, np.cos, np.tanh, 2 * np.pi
# Functions of x and y, the bend of the sides at y taken from x in the last one.
FRONTS = {"leaning": lambda x, y, bend: tanh(20 * sin(TURN * (x - 0.3 * y))),
          "diagonal": lambda x, y, bend: tanh(16 * sin(TURN * (x - y))),
          "level": lambda x, y, bend: tanh(20 * sin(TURN * y)) + 0 * x,
          "along": lambda x, y, bend: tanh(20 * sin(TURN * (x - bend - 0.25)))}
# Functions of the radius and the angle, the same after a quarter turn.
TURNED = {"spokes": lambda r, a: tanh(20 * sin(4 * a)) + 0 * r,
          "spiral": lambda r, a: tanh(8 * sin(4 * a + 4 * r)),
          "circle": lambda r, a: tanh(20 * (r - 2)) + 0 * a}


def grid(columns, rows):
    """Points of the unit square, triangles cut along x = y, and edges of the sides 1 to 4 with their markers."""
    points = np.array([(i / columns, j / rows) for j in range(rows + 1) for i in range(columns + 1)])
    up = columns + 1
    corners = [j * up + i for j in range(rows) for i in range(columns)]
    triangles = np.array([t for a in corners for t in ((a, a + 1, a + up + 1), (a, a + up + 1, a + up))])
    edges = [(i, i + 1, 1) for i in range(columns)] + [(rows * up + i + 1, rows * up + i, 3) for i in range(columns)]
    edges += [e for j in range(rows) for e in (((j + 1) * up - 1, (j + 2) * up - 1, 2), ((j + 1) * up, j * up, 4))]
    return points, triangles, edges


def write(folder, points, triangles, edges, values):
    with open(folder / "old.mesh", "w", encoding="utf-8") as out:
        out.write(f"MeshVersionFormatted 2\nDimension 2\nVertices\n{len(points)}\n")
        out.writelines(f"{x:.17g} {y:.17g} 0\n" for x, y in points)
        out.write(f"Edges\n{len(edges)}\n")
        out.writelines(f"{a + 1} {b + 1} {marker}\n" for a, b, marker in edges)
        out.write(f"Triangles\n{len(triangles)}\n")
        out.writelines(f"{a + 1} {b + 1} {c + 1} 1\n" for a, b, c in triangles)
        out.write("End\n")
    with open(folder / "u.sol", "w", encoding="utf-8") as out:
        out.write(f"MeshVersionFormatted 2\nDimension 2\nSolAtVertices\n{len(values)}\n1 1\n")
        out.writelines(f"{v:.17g}\n" for v in values)
        out.write("End\n")


def adapt(options, folder, wanted, pair):
    """Returns the status, the number of vertices, seconds of processor time and what was printed."""
    (folder / "new.mesh").unlink(missing_ok=True)
    before = resource.getrusage(resource.RUSAGE_CHILDREN)
    done = subprocess.run([options.asterism, "adapt", "old.mesh", "--solution", "u.sol", "--vertices", str(wanted),
                           *([] if options.no_pairs else ["--periodic", pair]), *options.more, "-o", "new.mesh"],
                          cwd=folder, capture_output=True, text=True, check=False)
    after = resource.getrusage(resource.RUSAGE_CHILDREN)
    made = folder / "new.mesh"
    count = len(meshes.read(made).points) if made.exists() else 0
    return (done.returncode, count, after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime,
            done.stdout + done.stderr)


def summarise(name, options, done):
    complete = [d for d in done if d[1] == 0]
    near = [d for d in complete if abs(d[2] - d[3]) <= 0.1 * d[3]]
    others = ", ".join(f"{count:,} of {wanted:,}" for _, _, count, wanted, *_ in complete
                       if abs(count - wanted) > 0.1 * wanted)
    print(f"{name}: {len(near)} of {len(done)} jobs complete with the number wanted, {len(complete) - len(near)} with "
          f"another number ({others or '-'}), {len(done) - len(complete)} not complete; at most "
          f"{max(d[4] for d in complete):.1f} s of processor time for a complete one, "
          f"{max(d[4] for d in done):.1f} for any", flush=True)
    for job, status, count, wanted, seconds, text in done:
        if options.list:
            reason = re.search(r"(?m)^asterism: .*", text)
            words = f"; {reason[0]}" if reason else ""
            print(f"  {job}: status {status}, {count} of {wanted}, {seconds:.1f} s{words}")


def channels(options, folder):
    done = []
    for part, rows, (name, front), wanted in itertools.product((20, 8), (40, 80), FRONTS.items(), (400, 1500)):
        points, triangles, edges = grid(rows, rows)
        bend = sin(TURN * points[:, 1]) / part
        points[:, 0] += bend
        write(folder, points, triangles, edges, front(*points.T, bend))
        status, count, seconds, text = adapt(options, folder, wanted, "4,2")
        done.append((f"bend 1/{part}, {rows} rows, {name}", status, count, wanted, seconds, text))
    summarise("channels", options, done)


def rings(options, folder):
    done = []
    for part, rows, (name, front), wanted in itertools.product((20, 8), (20, 40), TURNED.items(), (400, 1500)):
        # The radius, along a row, is from 1 to 3.
        points, triangles, edges = grid(rows, 2 * rows)
        radius = 1 + 2 * points[:, 0]
        angle = np.pi / 2 * points[:, 1] + sin(np.pi * (radius - 1)) / part
        points = np.stack([radius * cos(angle), radius * sin(angle)], axis=1)
        write(folder, points, triangles, edges, front(radius, angle))
        status, count, seconds, text = adapt(options, folder, wanted, "1,3")
        done.append((f"bend 1/{part}, {rows} rings, {name}", status, count, wanted, seconds, text))
    summarise("rings", options, done)


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--asterism", required=True)
    parser.add_argument("--jobs", nargs="+", default=["channels", "rings"], choices=["channels", "rings"])
    parser.add_argument("--list", action="store_true")
    parser.add_argument("--no-pairs", action="store_true")
    parser.add_argument("more", nargs="*", help="more options of the command")
    options = parser.parse_args()
    options.asterism = str(pathlib.Path(options.asterism).resolve())
    for job in options.jobs:
        with tempfile.TemporaryDirectory() as folder:
            {"channels": channels, "rings": rings}[job](options, pathlib.Path(folder))


if __name__ == "__main__":
    main()
