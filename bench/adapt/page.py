# SPDX-License-Identifier: MIT
"""Makes docs/results/metrics_on_meshes.md of what scripts/bench-adapt --json has appended to files.

  page.py FILE... > PAGE     the last line for a function and a number of vertices counts
"""
import json
import sys

import numpy as np

HEAD = """# Metrics on meshes, in loops beside BAMG

Made by `scripts/bench-adapt --json FILE` and `bench/adapt/page.py`. L2-optimal metrics of functions on [-1,1]^2, exact
Hessians at the vertices of the mesh before (`~`: recovered from values, `~~`: with noise of 1e-4 in them), five passes
from a grid, both programs on the same functions in loops of their own, one thread, Debian 12's BAMG (`freefem++`), two
shared cores. mmg2d is not in Debian and was not run.

*Error*: L2 interpolation error times vertices, over BAMG's, each the median of the last three passes. *Time*: user
seconds of a pass over BAMG's, start, files and audit included; the median of the last three passes, then the worst of
all five. *v*: vertices over those wanted, least and greatest of all passes, and BAMG's. *Within 10 %*: vertices whose
tensor is the one wanted, in lengths. *Status 0*: certified, no angle below 20 degrees from any of the
three vertices, in the metric delivered.
"""


def load(paths):
    found = {}
    for path in paths:
        with open(path, encoding="utf-8") as lines:
            for line in lines:
                row = json.loads(line)
                found[row["function"], row["vertices"]] = row
    return found


def median(rows, key):
    return float(np.nanmedian([row.get(key, np.nan) for row in rows[-3:]]))


def line_of(name, row):
    ours, bamg = row["Asterism"], row["BAMG"]
    seconds = median(bamg, "seconds")
    v = [r.get("v", np.nan) for r in ours]
    return (f"| {name} | {sum(r['status'] == 0 for r in ours)}/{len(ours)} "
            f"| {median(ours, 'error') / median(bamg, 'error'):.2f} "
            f"| {median(ours, 'seconds') / seconds:.1f}, {max(r['seconds'] for r in ours) / seconds:.1f} "
            f"| {np.nanmin(v):.3f}-{np.nanmax(v):.3f} | {median(bamg, 'v'):.2f} "
            f"| {100 - 100 * median(ours, 'changed'):.0f} % |")


def main():
    found = load(sys.argv[1:])
    print(HEAD)
    sizes = sorted({n for _, n in found})
    for size in sizes:
        print(f"## {size} vertices\n\n| function | status 0 | error | time | v | BAMG's v | within 10 % |\n"
              "|---|---|---|---|---|---|---|")
        rows = {name: row for (name, n), row in found.items() if n == size}
        for name, row in rows.items():
            print(line_of(name, row))
        errors = [median(r["Asterism"], "error") / median(r["BAMG"], "error") for r in rows.values()]
        times = [median(r["Asterism"], "seconds") / median(r["BAMG"], "seconds") for r in rows.values()]
        print(f"\nErrors: mean {np.mean(errors):.2f}, worst {max(errors):.2f}. Time: median {np.median(times):.1f}, "
              f"worst {max(times):.1f}.\n")
    if len(sizes) < 2:
        return
    low, high = sizes[-2:]
    print(f"## Slope of the error in the number of vertices, {low} to {high}\n\n| function | ours | BAMG's |\n|---|---|---|")
    for name in [n for n, size in found if size == high and (n, low) in found]:
        slopes = [np.log(median(found[name, high][who], "error") / median(found[name, low][who], "error"))
                  / np.log(high / low) - 1 for who in ("Asterism", "BAMG")]
        print(f"| {name} | {slopes[0]:.2f} | {slopes[1]:.2f} |")


if __name__ == "__main__":
    main()
