# SPDX-License-Identifier: MIT
"""given_sites.py COMMAND MEASURE DELAUNAY_BENCH WORK: what it costs to mesh sites that are given. Prints a
Markdown page; scripts/bench-given runs it."""
import argparse
import json
import math
import pathlib
import statistics
import subprocess
import sys

sys.path.insert(0, str(pathlib.Path(__file__).parent.parent))
from page import table, wrapped  # noqa: E402

HEAD = ["sites given", "metric", "bound", "sites of the mesh", "processor", "wall", "CGAL alone", "ratio", "memory"]


def noisy_ring(path, count):
    """Writes a ring of `count` vertices. Their distance from the centre varies by as much as neighbours are apart."""
    state = 1
    with open(path, "w", encoding="ascii") as out:
        out.write(f"{count} 2 0 0\n")
        for i in range(count):
            state = (state * 6364136223846793005 + 1442695040888963407) % 2**64
            radius = 1 + (state / 2**64 - 0.5) * 2 * math.pi / count
            turn = 2 * math.pi * i / count
            out.write(f"{i + 1} {radius * math.cos(turn)!r} {radius * math.sin(turn)!r}\n")
        out.write(f"{count} 0\n")
        for i in range(count):
            out.write(f"{i + 1} {i + 1} {(i + 1) % count + 1}\n")
        out.write("0\n")


class Bench:
    def __init__(self, asked):
        self.asked = asked
        self.mesh = asked.work / "given.mesh"

    def call(self, options):
        command = [str(self.asked.measure), str(self.asked.limit), str(self.asked.command), "mesh", *options, "--threads", "1",
                   "--quiet", "-o", str(self.mesh)]
        done = subprocess.run(command, capture_output=True, text=True, check=True, cwd=self.asked.work)
        run = json.loads(done.stdout)
        if run["status"] != 0:
            raise RuntimeError(f"{' '.join(command)}: status {run['status']}, see output.txt")
        return run

    def delaunay(self):
        done = subprocess.run([str(self.asked.delaunay), str(self.mesh)], capture_output=True, text=True, check=True)
        return float(done.stdout.split()[0])

    def row(self, name, metric, bound, options):
        """Times the mesher and CGAL's triangulation of the resulting vertices, in turns."""
        ours, theirs = [], []
        for _ in range(self.asked.calls):
            ours.append(self.call([*options, "--metric", metric, "--angle-bound", str(bound)]))
            theirs.append(self.delaunay())
        claim = json.loads(self.mesh.with_suffix(".certificate.json").read_text(encoding="utf-8"))
        if not claim["audit"]["certified"]:
            raise RuntimeError(f"{name} in {metric}: not certified")
        processor = statistics.median(r["processor"] for r in ours)
        alone = statistics.median(theirs)
        return [name, metric, str(bound), str(claim["mesh"]["vertices"]), f"{processor:.3g} s",
                f"{statistics.median(r['seconds'] for r in ours):.3g} s", f"{alone:.3g} s",
                f"{processor / alone:.1f}", f"{max(r['megabytes'] for r in ours):.0f} MB"]


def main():
    parser = argparse.ArgumentParser()
    for name in ["command", "measure", "delaunay", "work"]:
        parser.add_argument(name, type=pathlib.Path)
    parser.add_argument("--sites", nargs="*", type=int, default=[10000, 100000, 1000000])
    parser.add_argument("--calls", type=int, default=3)
    parser.add_argument("--limit", type=int, default=600, help="seconds a call")
    asked = parser.parse_args()
    bench = Bench(asked)
    rows = []
    for count in asked.sites:
        at_random = ["square", "--random-points", str(count), "--max-sites", str(10 * count)]
        rows.append(bench.row(f"{count} at random", "identity", 0, at_random))
        if count <= 100000:
            for bound in (0, 20):
                rows.append(bench.row(f"{count} at random", "swirl:12", bound, at_random))
    ring = asked.work / "ring.poly"
    noisy_ring(ring, 50000)
    rows.append(bench.row("a noisy ring of 50000", "identity", 20, [str(ring), "--max-sites", "1000000"]))
    print("# Sites that are given\n\nWritten by `scripts/bench-given`.\n")
    print(wrapped("Sites at random in the square, or on a ring, are meshed without a size by the whole command on one "
                  "thread: reading, meshing, audit, certificate, files. Beside it, in turns, CGAL's Delaunay "
                  "triangulation of the vertices that came out, without reading or writing, in the plane whatever "
                  f"the metric. Processor times, medians of {asked.calls}; all meshes are certified.") + "\n")
    print(table(HEAD, rows))


if __name__ == "__main__":
    main()
