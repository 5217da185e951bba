# SPDX-License-Identifier: MIT
"""other_libm.py COMMAND LIBRARY: what the command writes does not depend on the last digits of the C
library's elementary functions. LIBRARY is other_libm.c, preloaded."""
import os
import pathlib
import subprocess
import sys
import tempfile

COMMAND, LIBRARY = map(os.path.abspath, sys.argv[1:])
FORMULA = ("expr:1+9*(1+x*x)^1.3+2^y+exp(x)*sin(y)^2; 0.1*x*y*tanh(x); "
           "1+abs(y)^2.5+sqrt(2+cos(x))+log(2+x)+atan2(y,3+x)+cosh(x)^0.5")
JOBS = [["--metric", FORMULA, "--size", "0.4"],
        ["--metric", "swirl:12", "--size", "0.5", "--gradation", "1.3"],
        ["--metric", "shock:10", "--size", "2.5", "--gradation", "1.3"],
        ["--metric", "swirl:3", "--random-points", "12", "--refine", "darts", "--angle-bound", "10"]]


def written(job, **environment):
    """Returns what a job writes, and how often it called the preloaded library."""
    with tempfile.TemporaryDirectory() as name:
        count = pathlib.Path(name) / "count"
        words = [COMMAND, "mesh", "square", *job, "--quiet", "-o", "m.mesh", "-o", "m.vtu"]
        subprocess.run(words, cwd=name, check=True, timeout=240,
                       env={**os.environ, **environment, "OTHER_LIBM_COUNT": str(count)})
        asked = count.read_text(encoding="utf-8").split() if count.exists() else []
        made = {p.name: p.read_bytes() for p in pathlib.Path(name).iterdir() if p != count}
    return made, asked


def main():
    for job in JOBS:
        usual, none = written(job)
        other, asked = written(job, LD_PRELOAD=LIBRARY)
        if none or not asked:
            sys.exit("the other library was not loaded")
        if usual != other:
            sys.exit(f"{job}: {[name for name in usual if usual[name] != other[name]]} differ")
    # Checks that the preloaded library is in effect: Python's own functions are those of the C library.
    digits = subprocess.run([sys.executable, "-c", "import math; print(math.exp(1).hex())"], check=True, text=True,
                            capture_output=True, env={**os.environ, "LD_PRELOAD": LIBRARY}).stdout
    if digits.strip() == "0x1.5bf0a8b145769p+1":
        sys.exit("the other library answers like the usual one")


if __name__ == "__main__":
    main()
