# SPDX-License-Identifier: MIT
"""Each adapter of examples/challenge is asked what it should be right about, and what it is known to be
wrong about.  challenge_adapters.py ASTERISM FOLDER_OF_ADAPTERS SOURCE"""
import pathlib
import subprocess
import sys

PYTHON = "/usr/bin/python3"  # Debian's, which has numpy


def status(program, command, classes, predicates):
    wanted = [word for p in predicates for word in ("--predicate", p)]
    return subprocess.run([program, "challenge", "--count", "25", "--classes", classes, *wanted, *command],
                          capture_output=True, text=True, check=False)


def main():
    program, folder, source = sys.argv[1], pathlib.Path(sys.argv[2]), pathlib.Path(sys.argv[3])
    numpy = [PYTHON, source / "examples/challenge/numpy_linalg.py"]
    plane, metric = ["orient2d", "incircle"], ["in_circle"]
    cases = [
        # command, predicates, classes it is right about, classes it is wrong about
        ([folder / "challenge_plain_doubles"], plane + metric, "random,grid,tangent", "kettner,scaled"),
        ([folder / "challenge_cgal"], plane, "random,kettner,scaled,extreme,subnormal", None),
        ([folder / "challenge_cgal"], metric, "random", "cocircular"),
        ([folder / "challenge_cgal", "--inexact"], plane, "random,grid", "kettner"),
        ([folder / "challenge_boost_geometry"], ["orient2d"], "random,grid", "kettner"),
    ]
    if subprocess.run([PYTHON, "-c", "import numpy"], check=False, capture_output=True).returncode == 0:
        cases.append((numpy, plane, "random", "cocircular,collinear"))
    else:
        print("no numpy: its adapter is not asked")
    failures = 0
    for command, predicates, right, wrong in cases:
        for classes, expected in ((right, 0), (wrong, 1)):
            if classes is None:
                continue
            done = status(program, command, classes, predicates)
            if done.returncode != expected:
                failures += 1
                print(f"{command} {classes}: status {done.returncode}\n{done.stdout}{done.stderr}")
    sys.exit(1 if failures else 0)


if __name__ == "__main__":
    main()
