# SPDX-License-Identifier: MIT
"""Runs the loops of examples/solver_loops, shortened, and holds what they print against what must be so.
solver_loops.py PYTHON EXAMPLES FOLDER. Skipped (77) without scipy; the one that needs dolfinx says that it is."""
import os
import pathlib
import re
import subprocess
import sys
import unittest

PYTHON, EXAMPLES, FOLDER = sys.argv[1:4]


def has(module):
    return subprocess.run([PYTHON, "-c", f"import {module}"], check=False, capture_output=True).returncode == 0


def numbers_of(script, *words):
    """The numbers named in each line of what the script prints."""
    command = [PYTHON, str(pathlib.Path(EXAMPLES) / script), *words]
    done = subprocess.run(command, cwd=FOLDER, text=True, capture_output=True, timeout=600, check=False,
                          env={**os.environ, "OMP_NUM_THREADS": "1", "XDG_CACHE_HOME": FOLDER})
    if done.returncode != 0:
        raise AssertionError(" ".join(command) + "\n" + done.stdout[-2000:] + done.stderr[-2000:])
    print(" ".join(words), "\n" + done.stdout, end="", flush=True)
    return [{name: float(value) for name, value in re.findall(r"([a-z]+) (-?[\d.]+(?:e[+-]\d+)?)\b", line)}
            for line in done.stdout.splitlines()]


class LoopTest(unittest.TestCase):
    def test_gray_scott_keeps_what_there_is(self):
        picture = pathlib.Path(FOLDER) / "gray_scott.png"
        picture.unlink(missing_ok=True)
        last = numbers_of("gray_scott.py", "--adaptations", "5", "--vertices", "600", "--steps", "20", "--picture",
                          str(picture))[-1]
        self.assertLess(abs(last["vertices"] / 600 - 1), 0.05)
        self.assertLess(last["drift"], 1e-13)
        self.assertGreaterEqual(last["least"], 0)
        self.assertTrue(picture.exists())

    def test_step_at_mach_3(self):
        """In front of the step the pressure is that at rest behind a normal shock, 12.06; the scheme is of the first
        order."""
        last = numbers_of("mach_3_step.py", "--adaptations", "3", "--vertices", "700", "--iterations", "250")[-1]
        self.assertLess(abs(last["vertices"] / 700 - 1), 0.05)
        self.assertLess(last["drift"], 1e-13)
        self.assertLess(abs(last["rest"] / 12.06 - 1), 0.1)
        self.assertGreater(last["least"], 0)

    def test_layers_do_not_drift(self):
        """Neither with a bound that is named nor with that of the solution's own steepness; in equations that are
        their own adjoints, too."""
        for wishes in (("--thickness", "1e-2", "--aspect", "20"), ("--thickness", "1e-3", "--aspect", "100"),
                       ("--thickness", "1e-2"), ("--thickness", "1e-3"),
                       ("--thickness", "1e-2", "--equation", "reaction")):
            last = numbers_of("two_layers.py", *wishes)[-1]
            self.assertLess(last["ratio"], 1.1, wishes)
            self.assertLess(last["last"], 1.6e-4, wishes)

    @unittest.skipUnless(has("dolfinx"), "dolfinx is not installed (python3-dolfinx)")
    def test_goal_oriented(self):
        """Less than half the error of a uniform mesh and less than a loop after the solution has; the estimate is
        within a third of the error."""
        options = ("--vertices", "500", "--rounds", "4")
        goal, solution, uniform = (numbers_of("goal_oriented.py", *options, "--by", by)[-1]
                                   for by in ("goal", "solution", "uniform"))
        self.assertLess(abs(goal["error"]), 0.9 * abs(solution["error"]))
        self.assertLess(abs(goal["error"]), 0.5 * abs(uniform["error"]))
        self.assertLess(abs(goal["estimated"] / goal["error"] - 1), 1 / 3)


if __name__ == "__main__":
    if not has("scipy, matplotlib"):
        print("skipped: scipy or matplotlib is missing")
        sys.exit(77)
    pathlib.Path(FOLDER).mkdir(parents=True, exist_ok=True)
    unittest.main(argv=sys.argv[:1])
