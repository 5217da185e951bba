# SPDX-License-Identifier: MIT
"""Loops from the solution, `asterism adapt --solution`, beside BAMG's mesher with the exact Hessian at the vertices of
the mesh before: errors of linear interpolation times vertices, medians of the last three of five passes.

  exact_beside_recovered.py --asterism COMMAND [--functions NAME...] [--vertices N]
"""
import argparse
import os
import pathlib
import statistics
import sys

sys.path.insert(0, str(pathlib.Path(__file__).parent))
import adapt  # noqa: E402
import functions  # noqa: E402
import solution_loop  # noqa: E402


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--asterism", required=True)
    parser.add_argument("--bamg", default="ffbamg")
    parser.add_argument("--work", default="/tmp/bench-exact-beside-recovered")
    parser.add_argument("--functions", nargs="+", default=list(functions.FUNCTIONS))
    parser.add_argument("--vertices", type=int, default=2000)
    parser.add_argument("--passes", type=int, default=5)
    parser.add_argument("--limit", type=float, default=120)
    parser.set_defaults(with_options="")
    options = parser.parse_args()
    options.asterism, options.rounds = os.path.abspath(options.asterism), options.passes
    print("| function | BAMG, exact Hessian | from the solution | ratio |\n|---|---|---|---|", flush=True)
    for name in options.functions:
        exact = [row["error"] for row in adapt.loop(adapt.Bamg(options), name, options.vertices, options)]
        folder = pathlib.Path(options.work) / name / "values"
        folder.mkdir(parents=True, exist_ok=True)
        found = solution_loop.loop(solution_loop.Asterism(options, options.vertices), name, folder, options)
        ours, theirs = statistics.median(n * e for _, n, e, _ in found[-3:]), statistics.median(exact[-3:])
        print(f"| {name} | {theirs:.4g} | {ours:.4g} | {ours / theirs:.2f} |", flush=True)


if __name__ == "__main__":
    main()
