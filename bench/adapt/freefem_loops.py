# SPDX-License-Identifier: MIT
"""The scripts of examples/freefem by asterism and by adaptmesh, at several numbers of vertices: the table of true
errors of docs/results/adaptation.md, and its picture. Numbers are geometric means over the last rounds of a loop: errors
differ from round to round, and adaptmesh, which is asked for an error, takes some rounds to meet the number of vertices.
What was measured is kept in the folder of work.

  freefem_loops.py --asterism COMMAND [--vertices N...] [--rounds N] [--last N] [--picture OUT.svg]
"""
import argparse
import json
import math
import os
import pathlib
import re
import shutil
import statistics
import subprocess
import sys

sys.path.insert(0, str(pathlib.Path(__file__).parent))
import pictures  # noqa: E402

PROBLEMS = {"l_shape": "Poisson, L-shape, singular corner (`--norm inf`)",
            "inner_layer": "Poisson, curved layer inside",
            "boundary_layer": "advection and diffusion, layer of 0.01 at the boundary"}
EXAMPLES = pathlib.Path(__file__).resolve().parents[2] / "examples" / "freefem"


def measured(script, by, wanted, options):
    """Returns vertices and true error of each round."""
    folder = pathlib.Path(options.work) / script / str(wanted) / by
    kept = folder / "measured.json"
    if kept.exists():
        return json.loads(kept.read_text(encoding="utf-8"))
    folder.mkdir(parents=True, exist_ok=True)
    macro = EXAMPLES.parents[1] / "apps" / "freefem" / "asterism.idp"
    for file in [macro, *EXAMPLES.glob("*.[ei]d*p")]:
        shutil.copy(file, folder)
    done = subprocess.run([options.freefem, "-v", "0", script + ".edp", "-by", by, "-vertices", str(wanted),
                           "-rounds", str(options.rounds)],
                          cwd=folder, text=True, capture_output=True, timeout=options.limit, check=True,
                          env={**os.environ, "ASTERISM": options.asterism})
    made = [[int(count), float(error)] for count, error in re.findall(r"vertices (\d+) error (\S+)", done.stdout)]
    kept.write_text(json.dumps(made), encoding="utf-8")
    return made


def geometric_mean(numbers):
    return math.exp(statistics.fmean(map(math.log, numbers)))


def means(rounds, last):
    """Returns the geometric means of vertices and error over the last rounds."""
    return [geometric_mean(column) for column in zip(*rounds[-last:])]


def deviation(rounds, last):
    """Returns the standard deviation of log(error x vertices) over the last rounds."""
    return statistics.stdev(math.log(count * error) for count, error in rounds[-last:])


def draw(found, path):
    import matplotlib
    matplotlib.use("svg")
    matplotlib.rcParams["svg.hashsalt"] = "asterism"
    from matplotlib import pyplot
    figure, axes = pyplot.subplots(1, len(found), figsize=(10, 3.2), squeeze=False)
    for axis, (script, by) in zip(axes.flat, found.items()):
        for name, style in (("adaptmesh", "s--"), ("asterism", "o-")):
            axis.loglog(*zip(*by[name]), style, label=name, markersize=4, linewidth=1)
        pictures.dress(axis, script.replace("_", " "))
    pictures.save(figure, axes.flat[0], "true error in the mean square", path)


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--asterism", required=True)
    parser.add_argument("--freefem", default="FreeFem++-nw")
    parser.add_argument("--work", default="/tmp/bench-freefem")
    parser.add_argument("--vertices", nargs="+", type=int, default=[400, 800, 1600])
    parser.add_argument("--rounds", type=int, default=15)
    parser.add_argument("--last", type=int, default=8, help="number of rounds whose mean is taken")
    parser.add_argument("--limit", type=float, default=900)
    parser.add_argument("--picture")
    options = parser.parse_args()
    options.asterism = os.path.abspath(options.asterism)
    found = {}
    print("| problem | wanted | adaptmesh: vertices, error, spread | asterism: vertices, error, spread | "
          "error x vertices, adaptmesh = 1 |\n"
          "|---|---|---|---|---|")
    for script, title in PROBLEMS.items():
        loops = {by: [measured(script, by, n, options) for n in options.vertices] for by in ("adaptmesh", "asterism")}
        found[script] = {by: [means(rounds, options.last) for rounds in of] for by, of in loops.items()}
        for i, wanted in enumerate(options.vertices):
            (n, e), (k, f) = found[script]["adaptmesh"][i], found[script]["asterism"][i]
            spread = [deviation(loops[by][i], options.last) for by in ("adaptmesh", "asterism")]
            print(f"| {title} | {wanted} | {n:.0f}, {e:.2e}, {spread[0]:.0%} | {k:.0f}, {f:.2e}, {spread[1]:.0%} | "
                  f"{k * f / (n * e):.2f} |".replace("e-0", "e-").replace("%", " %"))
    if options.picture:
        draw(found, options.picture)


if __name__ == "__main__":
    main()
