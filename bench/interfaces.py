# SPDX-License-Identifier: MIT
"""interfaces.py INTERFACE_BENCH BUILD PAGE [--repeats N] [--metrics NAME ...]

Runs the programs that measure the library's borders and writes the page. BUILD is a build tree with the
Python package, the predicates and the command. Times are of the processor, the least of N (9) repeats;
repeats of all contenders are interleaved."""
import argparse
import datetime
import json
import os
import pathlib
import platform
import subprocess
import sys

TOP = pathlib.Path(__file__).resolve().parents[1]
PREDICATES = ["orientation", "in_circle", "compare_distance", "edge_test"]
METRICS = ["uniform", "swirl-12", "swirl-60", "tilted-100", "circle-shock"]

PAGE = """# Cost of calls from C and Python

Written by `scripts/bench-interfaces` on {date}: {machine}, release build, one thread, load {load}. Times are
of the processor, the least of {repeats} interleaved repeats. Other work on the machine raises them by a third;
ratios suffer less.

## C and C++

Random questions of a smooth metric, four sites near each other; nanoseconds a question.

{c}
A C function checks preconditions that C++ functions assume: every number is finite, every metric is positive
definite, and no two sites of a question have the same position. It does so in doubles, and exactly only where
doubles do not decide. The checks and the copy of the arguments are the difference. `asterism_ask` takes its
arguments by pointers, and counts the tier that decided. A batch in C copies its rows into columns, so that one
register holds several questions.

Edge tests here have their sites in any order and four metrics; those of a mesh generator, which knows its
neighbours' order, are many times cheaper ([performance](../results/performance.md)).

## numpy

The same questions as arrays; nanoseconds a row. A call from Python takes {call} ns for any predicate, so
single questions are slow there.

{numpy}
{bamg}"""

BAMG = """
## BAMG, plain and patched

[BAMG with the exact in-circle test](../../examples/embedding/bamg/README.md) in its flips against BAMG as
Debian's gmsh has it: three rounds from a grid of 64 by 64 cells, seconds of processor time in BAMG.

{table}
The patched program asks more questions where it ends with more triangles; "a question" is the time of the
whole run by the flips asked for, in nanoseconds.
"""


def row(cells):
    return "| " + " | ".join(cells) + " |\n"


def of_c(program, repeats):
    """Returns nanoseconds by predicate and route."""
    done = subprocess.run([program, "--benchmark_min_time=0.05", f"--benchmark_repetitions={repeats}",
                           "--benchmark_enable_random_interleaving=true", "--benchmark_format=json"],
                          capture_output=True, text=True, check=True)
    found = {}
    for run in json.loads(done.stdout)["benchmarks"]:
        if run["run_type"] == "iteration":
            name = run["name"].split("/")[0]
            found[name] = min(found.get(name, float("inf")), 1e9 / run["items_per_second"])
    return found


def number(x):
    return "-" if x is None else f"{x:.1f}" if x < 100 else f"{x:.0f}"


def table_of_c(found):
    text = row(["predicate", "C++ `filtered_kernel`", "C function", "`asterism_ask`, counted",
                "C batch of 1000", "C less C++"]) + "|---|--:|--:|--:|--:|--:|\n"
    for name in PREDICATES:
        plain, c, asked, batch = (found.get(f"{name}_{way}") for way in ("cpp", "c", "counted", "batch"))
        text += row([f"`{name}`", number(plain), number(c), number(asked), number(batch), number(c - plain)])
    return text


def table_of_numpy(rows, c):
    text = row(["predicate", *rows, "C batch of 1000", "C++"]) + "|---|" + "--:|" * (len(rows) + 2) + "\n"
    for name in PREDICATES:
        text += row([f"`{name}`", *(number(found[name]) for found in rows.values()),
                     number(c[f"{name}_batch"]), number(c[f"{name}_cpp"])])
    return text


def of_bamg(build, metrics, repeats):
    """Returns the page's part on BAMG; "" where its source cannot be had."""
    program = TOP / "examples/embedding/bamg/compare.py"
    done = subprocess.run([sys.executable, program, build / "gmsh-source", "--build", build, "--metrics",
                           *metrics, "--repeats", str(repeats)], capture_output=True, text=True, check=False)
    if done.returncode == 3:
        print(f"interfaces: BAMG is left out: {done.stderr.strip()}", file=sys.stderr)
        return ""
    if done.returncode != 0:
        sys.exit(f"interfaces: BAMG: {done.stdout}{done.stderr}")
    rows = [[c.strip() for c in line.strip("|").split("|")] for line in done.stdout.splitlines()[2:]]
    text = row(["metric", "s plain", "s patched", "ratio", "asked plain", "asked patched",
                "a question plain", "patched"]) + "|---|" + "--:|" * 7 + "\n"
    for plain, exact in zip(rows[::2], rows[1::2]):
        seconds = [float(plain[4]), float(exact[4])]
        asked = [int(r[3].split("/")[1]) for r in (plain, exact)]
        text += row([plain[0], *(f"{s:.3f}" for s in seconds), f"{seconds[1] / seconds[0]:.2f}",
                     *map(str, asked), *(f"{s / n * 1e9:.0f}" for s, n in zip(seconds, asked))])
    return BAMG.format(table=text)


def machine():
    for line in pathlib.Path("/proc/cpuinfo").read_text(encoding="ascii").splitlines():
        if line.startswith("model name"):
            return line.split(": ")[1]
    return platform.machine()


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("program", type=pathlib.Path)
    parser.add_argument("build", type=pathlib.Path)
    parser.add_argument("page", type=pathlib.Path)
    parser.add_argument("--repeats", type=int, default=9)
    parser.add_argument("--metrics", nargs="+", default=METRICS)
    asked = parser.parse_args()
    load = os.getloadavg()[0]
    c = of_c(asked.program, asked.repeats)
    environment = {**os.environ, "PYTHONPATH": str(asked.build / "python")}
    done = subprocess.run([sys.executable, TOP / "bench/interface_bench.py", str(asked.repeats)], env=environment,
                          capture_output=True, text=True, check=True)
    numpy = json.loads(done.stdout)
    call = next(iter(numpy.values()))["one question"]
    text = PAGE.format(date=datetime.date.today(), machine=machine(), load=f"{load:.1f}", repeats=asked.repeats,
                       c=table_of_c(c), numpy=table_of_numpy(numpy, c), call=round(call, -2),
                       bamg=of_bamg(asked.build, asked.metrics, asked.repeats))
    asked.page.write_text(text, encoding="utf-8")


if __name__ == "__main__":
    main()
