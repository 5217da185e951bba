# SPDX-License-Identifier: MIT
"""Error of adaptation loops against the number of vertices, beside BAMG's own loop: the table of slopes of
docs/results/adaptation.md, and its picture. What was measured is kept in the folder of work and not measured
again, so that an interrupted run goes on.

  slopes.py --asterism COMMAND [--vertices N...] [--functions NAME...] [--picture OUT.svg]
"""
import argparse
import json
import os
import pathlib
import sys

import numpy as np

sys.path.insert(0, str(pathlib.Path(__file__).parent))
import pictures  # noqa: E402
import solution_loop  # noqa: E402


def measured(kind, name, wanted, options):
    """Returns vertices, and error times vertices, of the last rounds."""
    folder = pathlib.Path(options.work) / name / str(wanted) / kind.name
    kept = folder / "measured.json"
    if kept.exists():
        return json.loads(kept.read_text(encoding="utf-8"))
    if options.kept_only:
        return None
    folder.mkdir(parents=True, exist_ok=True)
    rows = solution_loop.loop(kind(options, wanted), name, folder, options)
    product, vertices, _, seconds = solution_loop.last(rows, options)
    if not np.isfinite(product):
        return None
    made = {"vertices": vertices, "product": product, "seconds": seconds,
            "statuses": [row[0] for row in rows]}
    kept.write_text(json.dumps(made), encoding="utf-8")
    return made


def slope_of(points, least):
    """Returns the slope of log error in log vertices, by least squares over the counts from `least` on."""
    used = [p for p in points if p and p["vertices"] > 0.9 * least]
    if len(used) < 2:
        return float("nan")
    n = np.log([p["vertices"] for p in used])
    e = np.log([p["product"] / p["vertices"] for p in used])
    return float(np.polyfit(n, e, 1)[0])


def draw(found, path):
    import matplotlib
    matplotlib.use("svg")
    matplotlib.rcParams["svg.hashsalt"] = "asterism"
    from matplotlib import pyplot
    names = list(found)
    rows = (len(names) + 4) // 5
    figure, axes = pyplot.subplots(rows, 5, figsize=(13, 2.7 * rows), squeeze=False)
    for axis in axes.flat[len(names):]:
        axis.axis("off")
    for axis, name in zip(axes.flat, names):
        for kind, style in (("BAMG", "s--"), ("Asterism", "o-")):
            points = [p for p in found[name][kind] if p]
            axis.loglog([p["vertices"] for p in points], [p["product"] / p["vertices"] for p in points],
                        style, label=kind, markersize=4, linewidth=1)
        points = [p for p in found[name]["Asterism"] if p]
        if points:
            n = np.array([points[0]["vertices"], points[-1]["vertices"]])
            axis.loglog(n, points[-1]["product"] / n, ":", color="grey", linewidth=1, label="slope -1")
        pictures.dress(axis, name)
    pictures.save(figure, axes.flat[0], "error in the mean square", path)


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--asterism", required=True)
    parser.add_argument("--bamg", default="ffbamg")
    parser.add_argument("--work", default="/tmp/bench-slopes")
    parser.add_argument("--functions", nargs="+", default=solution_loop.TEN)
    parser.add_argument("--vertices", nargs="+", type=int, default=[500, 2000, 8000])
    parser.add_argument("--rounds", type=int, default=6)
    parser.add_argument("--free-counts", action="store_true", help="of BAMG")
    parser.add_argument("--with-options", default="")
    parser.add_argument("--limit", type=float, default=900)
    parser.add_argument("--resolved", type=int, default=2000, help="least count that slopes are taken from")
    parser.add_argument("--kept-only", action="store_true", help="measure nothing, show what is there")
    parser.add_argument("--picture")
    options = parser.parse_args()
    options.asterism = os.path.abspath(options.asterism)
    found = {name: {"BAMG": [], "Asterism": []} for name in options.functions}
    for wanted in options.vertices:
        for name in options.functions:
            for kind in (solution_loop.Bamg, solution_loop.Asterism):
                found[name][kind.name].append(measured(kind, name, wanted, options))
        print(f"{wanted} vertices are done", file=sys.stderr, flush=True)
    counts = " | ".join(str(n) for n in options.vertices)
    print(f"| function | {counts} | slope, BAMG | slope, asterism |")
    print("|---" * (len(options.vertices) + 3) + "|")
    for name, both in found.items():
        ratios = [f"{a['product'] / b['product']:.2f}" if a and b else "-"
                  for a, b in zip(both["Asterism"], both["BAMG"])]
        slopes = [f"{slope_of(both[kind], options.resolved):.2f}" for kind in ("BAMG", "Asterism")]
        print(f"| {name} | {' | '.join(ratios)} | {' | '.join(slopes)} |")
    if options.picture:
        draw(found, options.picture)


if __name__ == "__main__":
    main()
