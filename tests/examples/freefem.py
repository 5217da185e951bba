# SPDX-License-Identifier: MIT
"""Runs the scripts of examples/freefem, asterism in place of adaptmesh, and holds their true errors
against what a uniform mesh, or adaptmesh, has.  freefem.py FREEFEM ASTERISM EXAMPLES"""
import os
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile
import unittest

FREEFEM, ASTERISM, EXAMPLES = sys.argv[1:4]


def lines_of(script, *words):
    with tempfile.TemporaryDirectory(prefix="asterism-freefem-") as name:
        folder = pathlib.Path(name)
        macro = pathlib.Path(EXAMPLES).parents[1] / "apps/freefem/asterism.idp"
        for file in [macro, *pathlib.Path(EXAMPLES).glob("*.[ei]d*p")]:
            shutil.copy(file, folder)
        done = subprocess.run([FREEFEM, "-v", "0", script, *words], cwd=folder, text=True,
                              capture_output=True, timeout=200, check=False,
                              env={**os.environ, "ASTERISM": ASTERISM})
        found = re.findall(r"vertices (\d+) error (\S+)(?: transfer (\S+))?", done.stdout)
        if done.returncode != 0 or not found:
            raise AssertionError(done.stdout[-2000:] + done.stderr[-2000:])
        return [(int(n), float(e), float(t) if t else None) for n, e, t in found]


class LoopTest(unittest.TestCase):
    def compare(self, script, factor):
        """Compares the last errors of both programs, each times its number of vertices, as errors
        fall with its inverse: ours is at most `factor` times that with adaptmesh."""
        n, ours, _ = lines_of(script, "-vertices", "600", "-rounds", "5")[-1]
        k, theirs, _ = lines_of(script, "-vertices", "600", "-rounds", "5", "-by", "adaptmesh")[-1]
        self.assertLess(abs(n / 600 - 1), 0.1)
        self.assertLess(ours * n, factor * theirs * k)

    def test_singular_corner(self):
        self.compare("l_shape.edp", 1.5)

    def test_layer_inside(self):
        self.compare("inner_layer.edp", 1.5)

    def test_layer_at_the_boundary(self):
        self.compare("boundary_layer.edp", 1.5)

    def test_periodic_space(self):
        """FreeFEM refuses the space where the sides do not match."""
        rounds = lines_of("periodic.edp", "-vertices", "1000", "-rounds", "4")
        self.assertEqual(len(rounds), 4)
        n, error, _ = rounds[-1]
        self.assertLess(abs(n / 1000 - 1), 0.1)
        self.assertLess(error, rounds[0][1] / 5)

    def test_twenty_steps_keep_the_integral(self):
        _, error, drift = lines_of("moving_bump.edp", "-vertices", "400")[-1]
        self.assertLess(drift, 1e-11)  # FreeFEM's own sums, and numbers as text, are part of it
        self.assertLess(error, 0.06)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
