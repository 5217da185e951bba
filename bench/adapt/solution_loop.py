# SPDX-License-Identifier: MIT
"""Adaptation loops from the solution: values at the vertices in, the next mesh out, beside BAMG's own
loop from the same values. Prints a table row for each function: error times vertices over BAMG's.

  solution_loop.py --asterism COMMAND [--functions NAME...] [--vertices N...] [--rounds N]
"""
import argparse
import os
import pathlib
import re
import resource
import subprocess
import sys

import numpy as np

sys.path.insert(0, str(pathlib.Path(__file__).parent))
import functions  # noqa: E402
import meshes  # noqa: E402

TEN = ["blconv", "circle", "shock", "tanhp", "bl", "crossing", "spiral", "waves", "front", "rings"]


def run(command, folder, limit):
    before = resource.getrusage(resource.RUSAGE_CHILDREN).ru_utime
    done = subprocess.run(command, cwd=folder, capture_output=True, text=True, timeout=limit,
                          check=False)
    return done, resource.getrusage(resource.RUSAGE_CHILDREN).ru_utime - before


def write_values(folder, mesh, name):
    values = functions.values(name, mesh.points)
    lines = "\n".join(f"{x:.17g}" for x in values)
    (folder / "u.sol").write_text("MeshVersionFormatted 2\nDimension 2\nSolAtVertices\n"
                                  f"{len(values)}\n1 1\n{lines}\nEnd\n", encoding="utf-8")
    (folder / "u.bb").write_text(f"2 1 {len(values)} 2\n{lines}\n", encoding="utf-8")


class Bamg:
    """A round of BAMG with its own Hessian and metric. BAMG takes an error and no count, so the error is searched for
    in each round until the count is within 2 %; the last try and its time count. With --free-counts the error is
    corrected from round to round instead, as the count falls as its inverse."""
    name = "BAMG"

    def __init__(self, options, wanted):
        self.options, self.wanted, self.error = options, wanted, 0.01

    def once(self, folder):
        for old in folder.glob("new*"):
            old.unlink()
        done, seconds = run([self.options.bamg, "-b", "old.mesh", "-Mbb", "u.bb", "-AbsError", "-err",
                             repr(self.error), "-nbv", str(20 * self.wanted + 2000), "-o", "new.mesh",
                             "-v", "1"], folder, self.options.limit)
        made = folder / "new.mesh"
        return done.returncode, seconds, len(meshes.read(made).points) if made.exists() else 0

    def step(self, folder):
        bounds = {}  # error and count of the last try with too many and with too few
        for tried in range(14):
            status, seconds, count = self.once(folder)
            if self.options.free_counts or count == 0 or abs(count / self.wanted - 1) <= 0.02:
                break
            bounds[count > self.wanted] = (np.log(self.error), np.log(count))
            if len(bounds) == 2:
                (x, n), (y, m) = bounds[True], bounds[False]
                part = 0.5 if tried % 4 == 3 else np.clip((n - np.log(self.wanted)) / (n - m), 0.1, 0.9)
                self.error = float(np.exp(x + part * (y - x)))
            else:
                self.error *= min(16, max(1 / 16, count / self.wanted))
        return status, seconds

    def learn(self, vertices):
        if self.options.free_counts:
            self.error *= min(4, max(0.25, vertices / self.wanted))


class Asterism:
    name = "Asterism"

    def __init__(self, options, wanted):
        self.options, self.wanted = options, wanted

    def step(self, folder):
        done, seconds = run([self.options.asterism, "adapt", "old.mesh", "--solution", "u.sol",
                             "--vertices", str(self.wanted), "--threads", "1", *self.options.with_options.split(), "-o", "new.mesh"],
                            folder, self.options.limit)
        if done.returncode != 0:
            print("   ", done.stderr.strip()[-300:])
        return done.returncode, seconds

    def learn(self, vertices):
        del vertices


def loop(contender, name, folder, options):
    mesh, rows = meshes.grid(max(10, int(np.sqrt(contender.wanted / 2)))), []
    for _ in range(options.rounds):
        meshes.write(folder / "old.mesh", mesh)
        write_values(folder, mesh, name)
        for old in folder.glob("new*"):
            old.unlink()
        try:
            status, seconds = contender.step(folder)
        except subprocess.TimeoutExpired:
            rows.append((None, float("nan"), float("nan"), options.limit))
            break
        if not (folder / "new.mesh").exists():
            rows.append((status, float("nan"), float("nan"), seconds))
            break
        mesh = meshes.read(folder / "new.mesh")
        error = meshes.l2_error(mesh, lambda p: functions.values(name, p))
        rows.append((status, len(mesh.points), error, seconds))
        contender.learn(len(mesh.points))
    return rows


def last(rows, options):
    """Returns error times vertices, vertices and error, as geometric means over the last three rounds (BAMG's loops
    often alternate between two errors), and the median of the seconds."""
    tail = rows[-3:] if len(rows) == options.rounds else []
    if not tail:
        return (float("nan"),) * 4
    mean = lambda of: float(np.exp(np.mean(np.log(of))))  # noqa: E731
    return (mean([n * e for _, n, e, _ in tail]), round(mean([n for _, n, _, _ in tail])),
            mean([e for _, _, e, _ in tail]), float(np.median([s for *_, s in tail])))


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--asterism", required=True)
    parser.add_argument("--bamg", default="ffbamg")
    parser.add_argument("--work", default="/tmp/bench-solution-loop")
    parser.add_argument("--functions", nargs="+", default=TEN)
    parser.add_argument("--vertices", nargs="+", type=int, default=[2000])
    parser.add_argument("--rounds", type=int, default=6)
    parser.add_argument("--free-counts", action="store_true", help="of BAMG")
    parser.add_argument("--with-options", default="")
    parser.add_argument("--limit", type=float, default=120)
    options = parser.parse_args()
    options.asterism = os.path.abspath(options.asterism)
    ratios = []
    print("| function | vertices | error BAMG | status | vertices | error | error x vertices, BAMG = 1 "
          "| time, BAMG = 1 |\n|---|---|---|---|---|---|---|---|")
    for wanted in options.vertices:
        for name in options.functions:
            found = {}
            for kind in (Bamg, Asterism):
                folder = pathlib.Path(options.work) / name / str(wanted) / kind.name
                folder.mkdir(parents=True, exist_ok=True)
                rows = loop(kind(options, wanted), name, folder, options)
                found[kind.name] = (rows, *last(rows, options))
            b, a = found["BAMG"], found["Asterism"]
            statuses = "".join(str(row[0]) for row in a[0])
            ratios.append(a[1] / b[1])
            print(f"| {name} | {b[2]} | {b[3]:.3g} | {statuses} | {a[2]} | {a[3]:.3g} | {ratios[-1]:.2f} "
                  f"| {a[4] / b[4]:.1f} |", flush=True)
    good = [r for r in ratios if np.isfinite(r)]
    print(f"\nMean of the ratios {np.mean(good):.3f}, greatest {max(good):.3f}, of {len(ratios)}.")


if __name__ == "__main__":
    main()
