# SPDX-License-Identifier: MIT
"""Time of one pass with a metric given on a mesh, by one thread and by two: the part of it in which one thread works
alone, and its growth with the number of vertices.

By the wall times T1 and T2 of one thread and two that part is 2 T2 / T1 - 1, which contains waits and work that is not
even. The growth is the ratio of the times of each number of vertices and of the one before. Commands take turns:
medians. A command may find memory that the last one has freed a moment ago; where a system gives freed memory away, a
pause of some seconds before each command takes that from the smaller mesh, as the larger one never finds enough.

  threads.py --asterism COMMAND [--beside COMMAND] [--functions NAME...] [--vertices N...] [--runs N] [--pause SECONDS]
"""
import argparse
import os
import pathlib
import statistics
import subprocess
import sys
import time

import numpy as np

sys.path.insert(0, str(pathlib.Path(__file__).parent))
import functions  # noqa: E402
import meshes  # noqa: E402

THREADS = (1, 2)


def command(asterism, threads, out):
    return [asterism, "mesh", "square", "--metric", "own.mesh", "--size", "1", "--max-sites", "10000000",
            "--threads", str(threads), "--quiet", "-o", out]


def write_background(folder, name, mesh, vertices):
    meshes.write(folder / "own.mesh", mesh)
    meshes.write_sol(folder / "own.sol", meshes.l2_metric(mesh, functions.hessians(name, mesh.points), vertices))


def prepare(name, vertices, options):
    """Makes the background of the last pass, a mesh of the passes before with the metric of the function on it."""
    folder = pathlib.Path(options.work) / f"{name}-{vertices}"
    folder.mkdir(parents=True, exist_ok=True)
    write_background(folder, name, meshes.grid(int(np.sqrt(vertices / 2))), vertices)
    for _ in range(options.passes - 1):
        subprocess.run(command(options.asterism, max(THREADS), "next.mesh"), cwd=folder, check=True)
        write_background(folder, name, meshes.read(folder / "next.mesh"), vertices)
    return folder


def seconds(asterism, threads, folder, options):
    time.sleep(options.pause)
    start = time.perf_counter()
    subprocess.run(command(asterism, threads, "made.mesh"), cwd=folder, check=True)
    return time.perf_counter() - start


def measure(folder, commands, options):
    """Returns the median wall seconds of each command, by one thread and by two."""
    taken = {}
    for run in range(options.runs):
        for asterism in commands if run % 2 == 0 else commands[::-1]:
            for threads in THREADS:
                taken.setdefault((asterism, threads), []).append(seconds(asterism, threads, folder, options))
    return {key: statistics.median(times) for key, times in taken.items()}


def row(name, vertices, asterism, now, before):
    """Returns a row of the table; `before` has the times of the number of vertices before, if there is one."""
    one, two = (now[asterism, threads] for threads in THREADS)
    growth = [f"{now[asterism, threads] / before[asterism, threads]:.2f}" if before else "" for threads in THREADS]
    return (f"| {name} | {vertices} | {asterism} | {one:.3f} | {two:.3f} | {200 * two / one - 100:.1f} % "
            f"| {' | '.join(growth)} |")


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--asterism", required=True)
    parser.add_argument("--beside", help="another build of the command, which takes turns with the first")
    parser.add_argument("--work", default="/tmp/bench-threads")
    parser.add_argument("--functions", nargs="+", default=["circle", "spiral", "bl", "front", "waves"],
                        choices=list(functions.FUNCTIONS), metavar="NAME")
    parser.add_argument("--vertices", nargs="+", type=int, default=[100000])
    parser.add_argument("--passes", type=int, default=4)
    parser.add_argument("--runs", type=int, default=9)
    parser.add_argument("--pause", type=float, default=0)
    options = parser.parse_args()
    options.asterism = os.path.abspath(options.asterism)
    commands = [options.asterism] + ([os.path.abspath(options.beside)] if options.beside else [])
    print("| function | vertices | command | T1, s | T2, s | alone | growth, one thread | two |")
    print("|---|---|---|---|---|---|---|---|", flush=True)
    for name in options.functions:
        before = None
        for vertices in options.vertices:
            now = measure(prepare(name, vertices, options), commands, options)
            for asterism in commands:
                print(row(name, vertices, asterism, now, before), flush=True)
            before = now


if __name__ == "__main__":
    main()
