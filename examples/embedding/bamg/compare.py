#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""compare.py WORK --build BUILD [--metrics NAME ...] [--rounds 3] [--repeats 1] [--page README.md]

Builds BAMG out of Debian's source package of gmsh twice in the folder WORK, as it is and with the exact
swap, runs both on the metrics and prints the table; --page also puts it between the marks of a page. Of
several repeats, done by turns, the least seconds are told.
BUILD is a build tree of Asterism with the predicates and the command. Exit status 1 if an exact run
fails or has an inverted triangle, 3 if the source cannot be had."""
import argparse
import math
import os
import pathlib
import resource
import shutil
import signal
import subprocess
import sys

HERE = pathlib.Path(__file__).resolve().parent
UNITS = ["Mesh2", "MeshGeom", "MeshRead", "Metric", "R2", "MeshDraw", "MeshQuad", "MeshWrite", "Meshio",
         "QuadTree", "SetOfE4"]
METRICS = ["uniform", "swirl-12", "swirl-60", "swirl-400", "layer", "rays", "tilted-100",
           "tilted-10000", "circle-shock", "curved-shock"]
VARIANTS = {"plain": ["count_flips.patch"], "exact": ["count_flips.patch", "exact_swap.patch"]}
SECONDS = 30  # seconds of processor time, after which a run counts as endless


def compiled(work, build_tree, tree, unit):
    """Returns the object file of a unit of BAMG, or of the host. It is kept if nothing that it depends on is
    newer."""
    sources = tree / "contrib/bamg/bamglib"
    made = tree / f"{unit.stem}.o"
    newest = max(f.stat().st_mtime for f in [*HERE.iterdir(), unit])
    if made.exists() and made.stat().st_mtime > newest:
        return made
    compiler = ["ccache", "g++"] if shutil.which("ccache") else ["g++"]
    quiet = [] if unit.parent == HERE else ["-w"]
    subprocess.run([*compiler, "-std=c++17", "-O2", "-DNDEBUG", f"-isystem{sources}", f"-I{work / 'empty'}",
                    f"-I{HERE}", f"-I{build_tree / 'include'}", *quiet, "-c", unit, "-o", made], check=True)
    return made


def build(work, build_tree):
    """Builds the variants' programs from patched copies below WORK. They differ in Mesh2.cpp alone."""
    empty = work / "empty"  # stands for a header of gmsh that is included and not used
    empty.mkdir(exist_ok=True)
    (empty / "MElement.h").write_text("")
    programs = {}
    for variant, patches in VARIANTS.items():
        tree = work / variant
        if not tree.exists():
            shutil.copytree(work / "gmsh/contrib/bamg", tree / "contrib/bamg")
        original = work / "gmsh/contrib/bamg/bamglib/Mesh2.cpp"
        shutil.copy(original, tree / "contrib/bamg/bamglib/Mesh2.cpp")
        for patch in patches:
            subprocess.run(["patch", "-s", "-p1", "-i", HERE / patch], cwd=tree, check=True)
        os.utime(tree / "contrib/bamg/bamglib/Mesh2.cpp", (original.stat().st_mtime,) * 2)
        shared = work / "plain"
        objects = [compiled(work, build_tree, tree, tree / "contrib/bamg/bamglib/Mesh2.cpp"),
                   compiled(work, build_tree, shared, HERE / "bamg_host.cpp")]
        objects += [compiled(work, build_tree, shared, shared / f"contrib/bamg/bamglib/{u}.cpp")
                    for u in UNITS if u != "Mesh2"]
        programs[variant] = work / f"bamg_{variant}"
        library = [build_tree / "kernels/libasterism_predicates.a", "-lgmp"] if variant == "exact" else []
        subprocess.run(["g++", *objects, *library, "-o", programs[variant]], check=True)
    return programs


def numbers_after(path, word, skip):
    words = path.read_text().split(word, 1)[1].split()
    count = int(words[0])
    return count, words[1 + skip:]


def read(stem):
    count, words = numbers_after(stem.with_suffix(".mesh"), "Vertices", 0)
    points = [(float(words[3 * i]), float(words[3 * i + 1])) for i in range(count)]
    count, words = numbers_after(stem.with_suffix(".mesh"), "Triangles", 0)
    triangles = [tuple(int(w) - 1 for w in words[4 * i:4 * i + 3]) for i in range(count)]
    count, words = numbers_after(stem.with_suffix(".sol"), "SolAtVertices", 2)
    metrics = [tuple(map(float, words[3 * i:3 * i + 3])) for i in range(count)]
    return points, triangles, metrics


def least_angle(points, metric):
    """Returns the least angle of a triangle in degrees, in one metric."""
    m11, m12, m22 = metric

    def dot(u, v):
        return m11 * u[0] * v[0] + m12 * (u[0] * v[1] + u[1] * v[0]) + m22 * u[1] * v[1]
    least = 180.0
    for k in range(3):
        a, b, c = points[k], points[k - 1], points[k - 2]
        u, v = (b[0] - a[0], b[1] - a[1]), (c[0] - a[0], c[1] - a[1])
        area = math.sqrt(max(m11 * m22 - m12 * m12, 0)) * abs(u[0] * v[1] - u[1] * v[0])
        least = min(least, math.degrees(math.atan2(area, dot(u, v))))
    return least


def judged(stem, command):
    """Returns the worst angle over the metrics of all three vertices, and the number of triangles that an exact test
    finds inverted."""
    points, triangles, metrics = read(stem)
    worst = min(least_angle([points[v] for v in t], metrics[w]) for t in triangles for w in t)
    records = "".join("orientation " + " ".join(f"{x!r} {y!r}" for x, y in (points[v] for v in t)) + "\n"
                      for t in triangles)
    signs = subprocess.run([command, "eval"], input=records, text=True, capture_output=True,
                           check=True).stdout.split()
    return worst, sum(s != "1" for s in signs)


def run(program, metric, rounds, stem, command):
    """Returns a row's cells for one variant, and whether the run ended well."""
    def limited():
        resource.setrlimit(resource.RLIMIT_CPU, (SECONDS, SECONDS))
    done = subprocess.run([program, metric, str(rounds), stem], capture_output=True, text=True,
                          preexec_fn=limited, check=False)
    if done.returncode in (-signal.SIGXCPU, -signal.SIGKILL):
        return ["-", "-", "-", "-", "-", f"not in {SECONDS} s"], False
    if done.returncode != 0:
        return ["-", "-", "-", "-", "-", f"status {done.returncode}"], False
    lines = [line.split() for line in done.stdout.splitlines()]
    worst, inverted = judged(stem, command)
    flips = sum(int(line[2]) for line in lines)
    asked = flips + sum(int(line[3]) for line in lines)
    seconds = sum(float(line[4]) for line in lines)
    return [lines[-1][1], f"{flips} / {asked}", f"{seconds:.3f}", f"{worst:.2f}", str(inverted),
            "yes"], inverted == 0


def seconds_of(cells):
    return math.inf if cells[2] == "-" else float(cells[2])


def table(rows):
    head = ["metric", "swap", "triangles", "flips / asked", "s", "worst angle", "inverted", "ends well"]
    text = "| " + " | ".join(head) + " |\n|---|---|" + "--:|" * 5 + "---|\n"
    return text + "".join("| " + " | ".join(row) + " |\n" for row in rows)


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("work", type=pathlib.Path)
    parser.add_argument("--build", type=pathlib.Path, required=True)
    parser.add_argument("--metrics", nargs="+", default=METRICS)
    parser.add_argument("--rounds", type=int, default=3)
    parser.add_argument("--repeats", type=int, default=1)
    parser.add_argument("--page", type=pathlib.Path)
    options = parser.parse_args()
    work, build_tree = options.work.resolve(), options.build.resolve()
    fetched = subprocess.run([HERE.parent / "fetch-gmsh-source", work], check=False)
    if fetched.returncode != 0:
        sys.exit(fetched.returncode)
    programs = build(work, build_tree)
    rows, good = [], True
    for metric in options.metrics:
        of_metric = {}
        for _ in range(options.repeats):
            for variant, program in programs.items():
                cells, well = run(program, metric, options.rounds, work / f"{variant}-{metric}",
                                  build_tree / "apps/asterism")
                before = of_metric.setdefault(variant, cells)
                if seconds_of(cells) < seconds_of(before):
                    of_metric[variant] = cells
                good = good and (well or variant == "plain")
        rows += [[metric, variant, *cells] for variant, cells in of_metric.items()]
    text = table(rows)
    print(text, end="")
    if options.page:
        page = options.page.read_text(encoding="utf-8")
        before, after = page.split("<!-- table -->\n")[0], page.split("<!-- end of table -->")[1]
        options.page.write_text(f"{before}<!-- table -->\n{text}<!-- end of table -->{after}",
                                encoding="utf-8")
    sys.exit(0 if good else 1)


if __name__ == "__main__":
    main()
