# SPDX-License-Identifier: MIT
"""Makes docs/results/metrics_on_meshes.md, but for the remarks there, of what scripts/bench-adapt --json has
appended to files. `scripts/bench-adapt --page PAGE` measures and calls this.

  page.py [--picture OUT.svg] FILE... > PAGE     the last line for a function and a number of vertices counts
"""
import argparse
import json
import os

import numpy as np

import pictures

HEAD = """# Metrics on meshes, in loops beside BAMG

Tables made by `scripts/bench-adapt --page PAGE.md --vertices 500 2000 8000 32000`. L2-optimal metrics of functions on
[-1,1]^2, exact Hessians at the vertices of the mesh before (`~`: recovered from values, `~~`: with noise of
1e-4 in them), five passes from a grid, both programs on the same functions in loops of their own, in the same
run, one thread, Debian 12's BAMG (`freefem++`), two shared cores. mmg2d is not in Debian and was not run.

*Error*: L2 interpolation error times vertices, over BAMG's, each the median of the last three passes. *Time*:
user seconds of a pass over BAMG's, start, files and audit included; the median of the last three passes, then
the worst of all five. *v*: vertices over those wanted, least and greatest of all passes, and BAMG's. *Within
10 %*: vertices whose tensor is the one wanted, in lengths; the median of the last three passes, at the top
the mean of all. *Status 0*: certified, no angle below 20 degrees from any of the three vertices, in the
metric delivered.
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


def ratio(row, key):
    return median(row["Asterism"], key) / median(row["BAMG"], key)


def line_of(name, row):
    ours, bamg = row["Asterism"], row["BAMG"]
    if not any("v" in r for r in ours):
        return f"| {name} | 0/{len(ours)} | no mesh | {ratio(row, 'seconds'):.1f} | - | {median(bamg, 'v'):.2f} | - |"
    seconds = median(bamg, "seconds")
    v = [r.get("v", np.nan) for r in ours]
    return (f"| {name} | {sum(r['status'] == 0 for r in ours)}/{len(ours)} | {ratio(row, 'error'):.2f} "
            f"| {ratio(row, 'seconds'):.1f}, {max(r['seconds'] for r in ours) / seconds:.1f} "
            f"| {np.nanmin(v):.3f}-{np.nanmax(v):.3f} | {median(bamg, 'v'):.2f} "
            f"| {100 - 100 * median(ours, 'changed'):.0f} % |")


def summary_line(size, rows):
    """Returns one row of the table at the top."""
    ours = [r["Asterism"] for r in rows]
    passes = [p for each in ours for p in each]
    v = [p.get("v", np.nan) for p in passes]
    errors, times = [ratio(r, "error") for r in rows], [ratio(r, "seconds") for r in rows]
    within = [100 - 100 * p["changed"] for p in passes if p.get("changed") is not None]
    return (f"| {size} | {len(rows)} | {sum(p['status'] == 0 for p in passes)}/{len(passes)} | {np.nanmin(v):.3f}-{np.nanmax(v):.3f} "
            f"| {np.nanmean(errors):.2f}, {np.nanmax(errors):.2f} | {np.median(times):.1f}, {max(times):.1f} "
            f"| {np.mean(within):.0f} %, {np.nanmin([100 - 100 * median(each, 'changed') for each in ours]):.0f} % |")


def slope(low, high, who, times):
    """Returns the slope of log error in log vertices from one row to the row of `times` as many vertices."""
    return np.log(median(high[who], "error") / median(low[who], "error")) / np.log(times) - 1


def print_slopes(found, sizes):
    pairs = list(zip(sizes, sizes[1:]))
    heads = " | ".join(f"{low} to {high}" for low, high in pairs)
    print("## Slope of the error in the number of vertices\n\nOurs, then BAMG's, between medians of the last three "
          f"passes.\n\n| function | {heads} |\n|---{'|---' * len(pairs)}|")
    columns = {pair: [] for pair in pairs}
    for name in dict.fromkeys(n for n, _ in found):
        cells = []
        for low, high in pairs:
            if (name, low) not in found or (name, high) not in found:
                cells.append("-")
                continue
            both = [slope(found[name, low], found[name, high], who, high / low) for who in ("Asterism", "BAMG")]
            columns[low, high].append(both)
            cells.append(", ".join(f"{each:.2f}" for each in both))
        print(f"| {name} | {' | '.join(cells)} |")
    means = [", ".join(f"{each:.2f}" for each in np.nanmean(columns[pair], axis=0)) for pair in pairs]
    print(f"| mean | {' | '.join(means)} |")


def draw(found, sizes, path):
    import matplotlib
    matplotlib.use("svg")
    matplotlib.rcParams["svg.hashsalt"] = "asterism"
    from matplotlib import pyplot
    names = list(dict.fromkeys(n for n, _ in found))
    rows = (len(names) + 4) // 5
    figure, axes = pyplot.subplots(rows, 5, figsize=(13, 2.6 * rows), squeeze=False)
    for axis in axes.flat[len(names):]:
        axis.axis("off")
    for axis, name in zip(axes.flat, names):
        there = [n for n in sizes if (name, n) in found]
        for who, style in (("BAMG", "s--"), ("Asterism", "o-")):
            axis.loglog(there, [median(found[name, n][who], "error") / n for n in there], style, label=who,
                        markersize=4, linewidth=1)
        last = median(found[name, there[-1]]["Asterism"], "error")
        axis.loglog(there, [last / n for n in there], ":", color="grey", linewidth=1, label="slope -1")
        pictures.dress(axis, name)
    pictures.save(figure, axes.flat[0], "L2 interpolation error", path)


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("files", nargs="+")
    parser.add_argument("--picture", help="draws error against vertices to this file")
    options = parser.parse_args()
    found = load(options.files)
    sizes = sorted({n for _, n in found})
    print(HEAD)
    print("| vertices | functions | status 0 | v | error: mean, worst | time: median, worst | within 10 %: mean, worst "
          "|\n|---|---|---|---|---|---|---|")
    of_size = {size: {name: row for (name, n), row in found.items() if n == size} for size in sizes}
    for size in sizes:
        print(summary_line(size, list(of_size[size].values())))
    if options.picture:
        draw(found, sizes, options.picture)
        print("\n![Error against the number of vertices, a diagram for each function: ours, BAMG's, and the slope -1]"
              f"({os.path.basename(options.picture)})")
    for size in sizes:
        print(f"\n## {size} vertices\n\n| function | status 0 | error | time | v | BAMG's v | within 10 % |\n"
              "|---|---|---|---|---|---|---|")
        for name, row in of_size[size].items():
            print(line_of(name, row))
    if len(sizes) > 1:
        print()
        print_slopes(found, sizes)


if __name__ == "__main__":
    main()
