# SPDX-License-Identifier: MIT
"""The scripts of examples/freefem by asterism and by adaptmesh, at several numbers of vertices: the table of true
errors of docs/results/adaptation.md, and its picture. What was measured is kept in the folder of work.

  freefem_loops.py --asterism COMMAND [--vertices N...] [--picture OUT.svg]
"""
import argparse
import json
import os
import pathlib
import re
import shutil
import subprocess
import sys

sys.path.insert(0, str(pathlib.Path(__file__).parent))
import pictures  # noqa: E402

PROBLEMS = {"l_shape": "Poisson, L-shape, singular corner (`--norm inf`)",
            "inner_layer": "Poisson, curved layer inside",
            "boundary_layer": "advection and diffusion, layer of 0.01 at the boundary"}
EXAMPLES = pathlib.Path(__file__).resolve().parents[2] / "examples" / "freefem"


def measured(script, by, wanted, options):
    """Returns vertices and true error of the last round."""
    folder = pathlib.Path(options.work) / script / str(wanted) / by
    kept = folder / "measured.json"
    if kept.exists():
        return json.loads(kept.read_text(encoding="utf-8"))
    folder.mkdir(parents=True, exist_ok=True)
    macro = EXAMPLES.parents[1] / "apps" / "freefem" / "asterism.idp"
    for file in [macro, *EXAMPLES.glob("*.[ei]d*p")]:
        shutil.copy(file, folder)
    done = subprocess.run([options.freefem, "-v", "0", script + ".edp", "-by", by, "-vertices", str(wanted)],
                          cwd=folder, text=True, capture_output=True, timeout=options.limit, check=True,
                          env={**os.environ, "ASTERISM": options.asterism})
    count, error = re.findall(r"vertices (\d+) error (\S+)", done.stdout)[-1]
    made = [int(count), float(error)]
    kept.write_text(json.dumps(made), encoding="utf-8")
    return made


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
    parser.add_argument("--limit", type=float, default=900)
    parser.add_argument("--picture")
    options = parser.parse_args()
    options.asterism = os.path.abspath(options.asterism)
    found = {}
    print("| problem | wanted | adaptmesh: vertices, error | asterism: vertices, error | error x vertices, adaptmesh = 1 |\n"
          "|---|---|---|---|---|")
    for script, title in PROBLEMS.items():
        found[script] = {by: [measured(script, by, n, options) for n in options.vertices]
                         for by in ("adaptmesh", "asterism")}
        for wanted, (n, e), (k, f) in zip(options.vertices, found[script]["adaptmesh"], found[script]["asterism"]):
            print(f"| {title} | {wanted} | {n}, {e:.2e} | {k}, {f:.2e} | {k * f / (n * e):.2f} |".replace("e-0", "e-"))
    if options.picture:
        draw(found, options.picture)


if __name__ == "__main__":
    main()
