# SPDX-License-Identifier: MIT
"""CAD files through asterism-occt, surface and verify. Skipped where OpenCASCADE is not."""
import json
import math
import os
import pathlib
import subprocess
import sys
import unittest

PROGRAMS = os.environ.get("ASTERISM_OCCT", "")
if not PROGRAMS:
    print("skipped: asterism-occt is not built; it needs OpenCASCADE (libocct-data-exchange-dev)")
    sys.exit(77)

from command import CommandTest  # noqa: E402


class CadFiles(CommandTest):
    def setUp(self):
        super().setUp()
        subprocess.run([pathlib.Path(PROGRAMS) / "asterism_occt_shapes", self.folder], check=True,
                       stdout=subprocess.DEVNULL, timeout=60)

    def convert(self, name, out="part.json", status=0):
        done = subprocess.run([pathlib.Path(PROGRAMS) / "asterism-occt", name, out], cwd=self.folder, text=True,
                              capture_output=True, timeout=60, check=False)
        self.assertEqual(done.returncode, status, done.stdout + done.stderr)
        return done.stdout + done.stderr

    def test_solids_are_certified_and_closed(self):
        """Compares numbers of faces and edges, the Euler number, and the volume by the divergence theorem."""
        for name, faces, edges, euler, volume, off in (
                ("box.brep", 6, 12, 2, 6000, 1e-6), ("can.brep", 3, 3, 2, 628.3185, 30),
                ("drilled.brep", 7, 15, 0, 5497.345, 30), ("drilled.step", 7, 15, 0, 5497.345, 30)):
            with self.subTest(name):
                said = self.convert(name)
                self.assertIn(f"{faces} faces, {edges} edges; lengths in millimetres", said)
                done = self.run_command("surface", "part.json", "--chord", "0.05", "-o", "part.mesh")
                self.assertEqual(done.returncode, 0, done.stdout + done.stderr)
                claim = json.loads((self.folder / "part.certificate.json").read_text())
                self.assertEqual((claim["open_edges"], claim["euler"], claim["trim_edges"]), (0, euler, edges))
                self.assertLess(claim["trim_gap"], 1e-6)
                self.assertLess(abs(self.volume() - volume), off)
                verified = self.run_command("verify", "part.mesh", "--domain", "part.json")
                self.assertEqual(verified.returncode, 0, verified.stdout + verified.stderr)

    def test_rounded_edges_and_crossed_cylinders_are_certified_and_closed(self):
        """Rings of faces whose common sides are divided by angles on and on, and faces that begin left of a period.

        The rounded box is one 26 by 16 by 6, with plates, quarters of cylinders and eighths of a ball about it.
        The volume of two cylinders across each other is that of both less Steinmetz's 16 r^3 / 3.
        """
        for name, faces, volume, area in (("fillet.brep", 26, 2496 + 4 * 668 + math.pi * 4 * 48 + math.pi * 32 / 3, 2000),
                                          ("posts.brep", 10, 10 * (600 - (4 - math.pi) * 4), 2100),
                                          ("crossed.brep", 8, 2 * math.pi * 16 * 30 - 16 * 64 / 3, 1500)):
            with self.subTest(name):
                self.assertIn(f"{faces} faces", self.convert(name))
                done = self.run_command("surface", "part.json", "--chord", "0.1", "-o", "part.mesh")
                self.assertEqual(done.returncode, 0, done.stdout + done.stderr)
                claim = json.loads((self.folder / "part.certificate.json").read_text())
                self.assertEqual((claim["open_edges"], claim["euler"]), (0, 2))
                self.assertLess(claim["trim_gap"], 1e-6)
                self.assertLess(abs(self.volume() - volume), 0.1 * area)
                verified = self.run_command("verify", "part.mesh", "--domain", "part.json")
                self.assertEqual(verified.returncode, 0, verified.stdout + verified.stderr)

    def test_faces_that_bound_themselves_are_certified_and_closed(self):
        """Compares the volumes of a ball of radius 5 and of a ring of radii 10 and 3 with their formulas. A mesh
        within distance D may be off by D times the area."""
        for name, euler, volume, area in (("ball.brep", 2, 500 * math.pi / 3, 100 * math.pi),
                                          ("ring.brep", 0, 180 * math.pi ** 2, 120 * math.pi ** 2)):
            with self.subTest(name):
                said = self.convert(name)
                self.assertRegex(said, r"note: face 1: its loop goes along the sides of its patch but for [-0-9.e]+ of a "
                                       r"parameter's range; it was left out, and all of the patch is meant")
                self.assertNotIn("loops", json.loads((self.folder / "part.json").read_text())["patches"][0])
                done = self.run_command("surface", "part.json", "--chord", "0.1", "-o", "part.mesh")
                self.assertEqual(done.returncode, 0, done.stdout + done.stderr)
                claim = json.loads((self.folder / "part.certificate.json").read_text())
                self.assertEqual((claim["open_edges"], claim["euler"]), (0, euler))
                self.assertLess(abs(self.volume() - volume), 0.1 * area)
                verified = self.run_command("verify", "part.mesh", "--domain", "part.json")
                self.assertEqual(verified.returncode, 0, verified.stdout + verified.stderr)

    def volume(self):
        words = (self.folder / "part.mesh").read_text().split()
        at = words.index("Vertices")
        points = [tuple(map(float, words[at + 2 + 4 * k:at + 5 + 4 * k])) for k in range(int(words[at + 1]))]
        at = words.index("Triangles")
        total = 0.0
        for k in range(int(words[at + 1])):
            a, b, c = (points[int(x) - 1] for x in words[at + 2 + 4 * k:at + 5 + 4 * k])
            total += (a[0] * (b[1] * c[2] - b[2] * c[1]) + a[1] * (b[2] * c[0] - b[0] * c[2]) +
                      a[2] * (b[0] * c[1] - b[1] * c[0])) / 6
        return total

    def test_what_cannot_be_read_is_refused_by_name(self):
        self.write("no.step", "this is no STEP file")
        self.write("no.brep", "nor BREP")
        for name, said in (("gone.step", "no such file"), ("no.step", "this is no STEP file"),
                           ("no.brep", "no BREP file|no face"), ("part.iges", "no such file"),
                           ("box.txt", ".step, .stp, .brep or .brp is wanted")):
            if name == "box.txt":
                self.write(name, "")
            self.assertRegex(self.convert(name, status=2), said)
            self.assertNotIn("part.json", self.files())


if __name__ == "__main__":
    unittest.main()
