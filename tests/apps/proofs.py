# SPDX-License-Identifier: MIT
"""Proofs through the real command, and tools/check_mesh.py as a stranger runs it."""
import pathlib
import subprocess
import sys
import unittest

import command

CHECKER = pathlib.Path(__file__).resolve().parents[2] / "tools/check_mesh.py"
SQUARE = "4 2 0 0\n1 0 0\n2 1 0\n3 1 1\n4 0 1\n4 1\n1 1 2 1\n2 2 3 2\n3 3 4 3\n4 4 1 4\n0\n0\n"
# A hole, an island in it, a segment inside that is split by the end of another, a region, a point.
ROOMS = ("15 2 0 0\n1 0 0\n2 6 0\n3 6 4\n4 0 4\n5 1 1\n6 3 1\n7 3 3\n8 1 3\n9 1.75 1.75\n10 2.25 1.75\n"
         "11 2 2.25\n12 4 0\n13 4.25 4\n14 5 1.5\n15 4.125 2\n13 1\n1 1 2 1\n2 2 3 1\n3 3 4 1\n4 4 1 1\n"
         "5 5 6 2\n6 6 7 2\n7 7 8 2\n8 8 5 2\n9 9 10 3\n10 10 11 3\n11 11 9 3\n12 12 13 4\n13 14 15 5\n"
         "1\n1 1.25 1.25\n2\n1 5.5 3.5 7\n2 2 2 9\n")
CURVE = "1 2\n1 1 0\n0\n0\n0\ncurves 1\n1 circle 1 0 0\n"


class Proofs(command.CommandTest):
    def make(self, domain, *words, status=0):
        self.write("d.poly", domain)
        done = self.run_command("mesh", "d.poly", *words, "--quiet", "-o", "m.mesh", "--proof", "m.proof")
        self.assertEqual(done.returncode, status, done.stderr)
        return done

    def check(self, status, *words, domain="d.poly", metric="m.sol", bound="20"):
        arguments = ["m.mesh", "m.proof", "--angle-bound", bound, "--metric", metric, *words]
        arguments += ["--domain", domain] if domain else []
        done = subprocess.run([sys.executable, str(CHECKER), *arguments], cwd=self.folder,
                              capture_output=True, text=True, check=False)
        self.assertEqual(done.returncode, status, done.stdout + done.stderr)
        same = self.run_command("check", *arguments)
        self.assertEqual(same.returncode, status, same.stdout + same.stderr)
        return done.stdout + done.stderr

    def test_meshes_of_many_metrics_are_proved(self):
        for metric, size in (("swirl:12", "0.1"), ("sink:24", "0.2"), ("shock:9", "0.1"), ("identity", "0.1"),
                             ("layer:0.02,0.3", "1"), ("expr:1+9*x^2;0.5*x*y;1+y^2", "0.1")):
            with self.subTest(metric=metric):
                self.make(SQUARE, "--metric", metric, "--size", size)
                self.assertRegex(self.check(0), r"^proved: \d+ sites, \d+ triangles, no angle below 20")
                self.check(0, domain=None)

    def test_holes_regions_points_and_segments_inside(self):
        self.make(ROOMS, "--metric", "sink:3", "--size", "0.4")
        self.check(0)
        for old, new in (("1 1.25 1.25\n", "1 2 2\n"),            # another hole
                         ("1\n1 1.25 1.25\n", "0\n"),             # none
                         ("1 5.5 3.5 7", "1 5.5 3.5 8"),          # another region
                         ("12 12 13 4", "12 12 13 5"),            # another marker
                         ("15 4.125 2", "15 4.125 2.0001")):      # another point
            self.assertIn(old, ROOMS)
            self.write("d.poly", ROOMS.replace(old, new))
            self.assertIn("NOT proved: ", self.check(1))
        self.write("d.poly", ROOMS.replace("2\n13 1\n", "2\n12 1\n").replace("13 14 15 5\n", ""))
        self.assertIn("are no segment's", self.check(1))

    def test_a_corner_below_the_bound_is_exempt_and_no_other(self):
        self.make("3 2 0 0\n1 0 0\n2 4 0\n3 4 1\n3 0\n1 1 2\n2 2 3\n3 3 1\n0\n0\n", "--size", "0.3")
        self.check(0)
        self.assertIn("has an angle below the bound", self.check(1, domain="d.poly", bound="35"))

    def test_what_cannot_be_said(self):
        self.make(SQUARE, "--metric", "swirl:3", "--size", "0.3")
        self.assertIn("--metric-tolerance cannot be checked yet", self.check(2, "--metric-tolerance", "1"))
        self.assertIn("only a .sol file", self.check(2, metric="swirl:3"))
        self.assertIn("only .poly files", self.check(2, domain="square"))
        self.write("curve.poly", CURVE)
        self.assertIn("curves cannot be checked yet", self.check(2, domain="curve.poly"))
        self.check(2, domain="none.poly")

    def test_a_mesh_with_curves_is_proved_as_the_polygon_of_its_chords(self):
        self.make(CURVE, "--size", "0.3")
        self.check(0, domain=None)

    def test_a_mesh_that_is_not_certified_has_no_proof(self):
        done = self.make(SQUARE, "--metric", "expr:(x>0.5)?900:1;0;1", "--metric-tolerance", "0",
                         status=1)
        self.assertIn("no proof is written: ", done.stderr)
        self.assertNotIn("m.proof", self.files())

    def test_certify_writes_a_proof(self):
        self.make(SQUARE, "--metric", "swirl:3", "--size", "0.3")
        (self.folder / "m.proof").unlink()
        done = self.run_command("certify", "m.mesh", "--proof", "m.proof")
        self.assertEqual(done.returncode, 0, done.stderr)
        self.check(0)

    def test_adapt_writes_a_proof(self):
        self.make(SQUARE, "--metric", "swirl:3", "--size", "0.3")
        done = self.run_command("adapt", "m.mesh", "--metric", "m.sol", "--vertices", "80", "--quiet",
                                "-o", "n.mesh", "--proof", "n.proof")
        self.assertEqual(done.returncode, 0, done.stderr)
        for end in ("mesh", "sol", "proof"):
            (self.folder / f"n.{end}").rename(self.folder / f"m.{end}")
        self.check(0, domain=None)


if __name__ == "__main__":
    unittest.main()
