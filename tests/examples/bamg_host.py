# SPDX-License-Identifier: MIT
"""Builds BAMG with and without the exact swap and compares them on two metrics, if the source of gmsh is
there already, or may be fetched: tests use no network, unless ASTERISM_LARGE_PACKAGES asks for what is
large.  bamg_host.py SOURCE BUILD.  Exit status 77: skipped."""
import os
import pathlib
import subprocess
import sys


def skip_without_source(source, work):
    if (work / "gmsh/contrib/bamg").is_dir():
        return
    fetch = source / "examples/embedding/fetch-gmsh-source"
    if os.environ.get("ASTERISM_LARGE_PACKAGES", "0") == "0":
        print(f"skipped: gmsh's source, 16 MB, is not here; {fetch} {work} gets it from Debian, and so does "
              "this test with ASTERISM_LARGE_PACKAGES=1")
        sys.exit(77)
    if subprocess.run([fetch, work], check=False).returncode != 0:
        print("skipped: gmsh's source is not here, and Debian's mirror cannot be reached")
        sys.exit(77)


def main():
    source, build = (pathlib.Path(a) for a in sys.argv[1:3])
    work = build / "gmsh-source"
    skip_without_source(source, work)
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
