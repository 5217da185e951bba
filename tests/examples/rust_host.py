# SPDX-License-Identifier: MIT
"""Compiles the host in Rust and runs it: exact flips end in a Delaunay mesh, those of doubles do not.
rust_host.py SOURCE LIBRARY WORK.  Exit status 77, skipped, where there is no rustc."""
import pathlib
import shutil
import subprocess
import sys


def main():
    source, library, work = (pathlib.Path(a) for a in sys.argv[1:4])
    rustc = shutil.which("rustc")
    if not rustc:
        print("skipped: no rustc here (Debian: rustc, 375 MB with LLVM; ASTERISM_LARGE_PACKAGES=1 scripts/test "
              "installs it)")
        sys.exit(77)
    work.mkdir(parents=True, exist_ok=True)
    program = work / "flips"
    subprocess.run([rustc, "--edition", "2018", "-O", "-D", "warnings", "-L", f"native={library.parent}",
                    "-l", "static=asterism_predicates", "-l", "gmp", "-l", "stdc++",
                    source / "examples/embedding/rust/flips.rs", "-o", program], check=True)
    for arithmetic, status in (("exact", 0), ("double", 1)):
        done = subprocess.run([program, "30", arithmetic], capture_output=True, text=True, timeout=60,
                              check=False)
        print(done.stdout + done.stderr, end="")
        if done.returncode != status:
            sys.exit(f"{arithmetic}: status {done.returncode}, not {status}")
    if subprocess.run([program, "0", "exact"], capture_output=True, check=False).returncode != 2:
        sys.exit("a bad size is not refused")


if __name__ == "__main__":
    main()
