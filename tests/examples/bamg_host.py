# SPDX-License-Identifier: MIT
"""Builds BAMG with and without the exact swap and compares them on two metrics, if the source of gmsh is
there already: tests fetch nothing.  bamg_host.py SOURCE BUILD.  Exit status 77: skipped."""
import pathlib
import subprocess
import sys


def main():
    source, build = (pathlib.Path(a) for a in sys.argv[1:3])
    work = build / "gmsh-source"
    if not (work / "gmsh/contrib/bamg").is_dir():
        print(f"skipped: no source of gmsh; examples/embedding/fetch-gmsh-source {work} gets it")
        sys.exit(77)
    done = subprocess.run([sys.executable, source / "examples/embedding/bamg/compare.py", work, "--build",
                           build, "--metrics", "swirl-12", "tilted-100", "--rounds", "2"],
                          capture_output=True, text=True, timeout=600, check=False)
    print(done.stdout + done.stderr)
    if done.returncode != 0:
        sys.exit(f"status {done.returncode}")
    rows = [[c.strip() for c in line.strip("|").split("|")] for line in done.stdout.splitlines()[2:]]
    worst = {(row[0], row[1]): float(row[5]) for row in rows}
    if not worst["tilted-100", "exact"] > 3 * worst["tilted-100", "plain"]:
        sys.exit("the exact swap did not better the worst angle of the tilted metric")


if __name__ == "__main__":
    main()
