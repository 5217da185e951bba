# SPDX-License-Identifier: MIT
"""Drag of the cylinder of DFG benchmark 2D-1 in an adaptation loop with FreeFEM: the table of
docs/results/adaptation.md. The boundary of the next mesh is that of the domain file, whose cylinder is a circle, or
that of the mesh before, whose cylinder is a polygon.

  cylinder.py --asterism COMMAND [--vertices N...] [--rounds N]
"""
import argparse
import os
import pathlib
import re
import shutil
import subprocess

REFERENCE = 5.57953523384  # drag coefficient, from the benchmark's page at featflow.de
# Markers: 1 below, 2 outflow, 3 above, 4 inflow, 5 the cylinder.
DOMAIN = """5 2
1 0 0
2 2.2 0
3 2.2 0.41
4 0 0.41
5 0.25 0.2
4 1
1 1 2 1
2 2 3 2
3 3 4 3
4 4 1 4
1
1 0.2 0.2
0
curves 1
1 circle 5  0.2 0.2  5
"""
WAYS = {"circle": ["--domain", "cylinder.poly"], "polygon": [],
        "short-chords": ["--domain", "cylinder.poly", "--chord-tolerance", "1e-5"]}


def run(options, folder, *words):
    done = subprocess.run([*words], cwd=folder, text=True, capture_output=True, timeout=options.limit, check=False)
    if done.returncode != 0:
        raise SystemExit(f"{' '.join(words)}: status {done.returncode}\n{done.stdout[-400:]}{done.stderr[-400:]}")
    return done.stdout


def loop(options, way, wanted):
    """Returns vertices, edges on the cylinder and drag of the last round."""
    folder = pathlib.Path(options.work) / way / str(wanted)
    folder.mkdir(parents=True, exist_ok=True)
    shutil.copy(pathlib.Path(__file__).with_name("cylinder.edp"), folder)
    (folder / "cylinder.poly").write_text(DOMAIN, encoding="utf-8")
    run(options, folder, options.asterism, "mesh", "cylinder.poly", "--vertices", "800", "-o", "0.mesh", "--quiet")
    for k in range(options.rounds + 1):
        told = run(options, folder, options.freefem, "-v", "0", "cylinder.edp", "-mesh", f"{k}.mesh",
                   "-speed", f"{k}.bb")
        if k < options.rounds:
            run(options, folder, options.asterism, "adapt", f"{k}.mesh", "--solution", f"{k}.bb", "--vertices",
                str(wanted), *WAYS[way], "-o", f"{k + 1}.mesh", "--quiet")
    found = re.search(r"vertices (\d+) edges (\d+) drag (\S+)", told)
    return int(found[1]), int(found[2]), float(found[3])


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--asterism", required=True)
    parser.add_argument("--freefem", default="FreeFem++-nw")
    parser.add_argument("--work", default="/tmp/bench-cylinder")
    parser.add_argument("--vertices", nargs="+", type=int, default=[1500, 3000, 6000, 12000])
    parser.add_argument("--ways", nargs="+", choices=WAYS, default=["circle", "polygon"])
    parser.add_argument("--rounds", type=int, default=3)
    parser.add_argument("--limit", type=float, default=1800)
    options = parser.parse_args()
    options.asterism = os.path.abspath(options.asterism)
    print("| boundary of the next mesh | wanted | vertices | edges on the cylinder | drag | error, relative |\n"
          "|---|---|---|---|---|---|")
    for way in options.ways:
        for wanted in options.vertices:
            vertices, edges, drag = loop(options, way, wanted)
            print(f"| {way} | {wanted} | {vertices} | {edges} | {drag:.8f} | {(drag - REFERENCE) / REFERENCE:+.1e} |",
                  flush=True)


if __name__ == "__main__":
    main()
