# SPDX-License-Identifier: MIT
"""Each method of the thesis's chapter 2 makes a mesh that covers its domain, and that the certifier judges.
baselines.py ASTERISM FOLDER_OF_PROGRAMS"""
import json
import pathlib
import subprocess
import sys
import tempfile
import unittest

ASTERISM, PROGRAMS = sys.argv.pop(1), pathlib.Path(sys.argv.pop(1))
L_SHAPE = "6 2 0 0\n1 0 0\n2 2 0\n3 2 1\n4 1 1\n5 1 2\n6 0 2\n6 1\n" + "".join(
    f"{i} {i} {i % 6 + 1} {i}\n" for i in range(1, 7)) + "0\n"
HOLE = ("8 2 0 0\n1 0 0\n2 3 0\n3 3 3\n4 0 3\n5 1 1\n6 2 1\n7 2 2\n8 1 2\n8 1\n1 1 2 1\n2 2 3 1\n3 3 4 1\n4 4 1 1\n"
        "5 5 6 2\n6 6 7 2\n7 7 8 2\n8 8 5 2\n1\n1 1.5 1.5\n")


class Baselines(unittest.TestCase):
    def setUp(self):
        place = tempfile.TemporaryDirectory()
        self.addCleanup(place.cleanup)
        self.folder = pathlib.Path(place.name)
        (self.folder / "l.poly").write_text(L_SHAPE)
        (self.folder / "hole.poly").write_text(HOLE)

    def call(self, program, *words):
        return subprocess.run([program, *words], cwd=self.folder, capture_output=True, text=True, timeout=60,
                              check=False)

    def mesh(self, method, domain, metric, *more):
        done = self.call(PROGRAMS / f"baseline_{method}", domain, "--metric", metric, "--size", "0.2", "-o",
                         "made.mesh", *more)
        self.assertEqual(done.returncode, 0, done.stderr)
        judged = self.call(ASTERISM, "certify", "made.mesh", "--json")
        self.assertIn(judged.returncode, (0, 1), judged.stderr)
        said = json.loads(judged.stdout)
        self.assertEqual(said["inverted"], 0)
        self.assertNotIn("domain", " ".join(said["findings"]))
        self.assertGreater(said["unit_edges"], 0.8 * said["edges"])
        return said

    def test_all_on_both_domains(self):
        for method in ("pliant_refinement", "delaunay_kernel", "bubble_packing"):
            for domain in ("square", "l.poly"):
                with self.subTest(method=method, domain=domain):
                    said = self.mesh(method, domain, "swirl:12")
                    self.assertGreater(said["vertices"], 100)
                    self.assertFalse(said["certified"])

    def test_in_one_metric_the_kernel_is_delaunays(self):
        # Pieces of the border in a metric as odd as this put no four of them on one circle.
        for kernel in "123":
            said = self.mesh("delaunay_kernel", "square", "expr:4;1.1;1.3", "--kernel", kernel)
            self.assertEqual(said["in_stars_of_all"], said["triangles"])

    def test_the_same_again(self):
        self.mesh("pliant_refinement", "square", "sink:12")
        first = (self.folder / "made.mesh").read_bytes()
        self.mesh("pliant_refinement", "square", "sink:12")
        self.assertEqual(first, (self.folder / "made.mesh").read_bytes())

    def test_what_they_do_not_take_is_refused(self):
        for words, what in ((["hole.poly", "--metric", "swirl:3"], "holes"), (["square"], "--metric"),
                            (["square", "--metric", "swirl:3", "--sise", "1"], "no option"),
                            (["square", "--metric", "expr:x;0;1"], "positive definite")):
            done = self.call(PROGRAMS / "baseline_bubble_packing", *words, "-o", "made.mesh")
            self.assertEqual(done.returncode, 2)
            self.assertIn(what, done.stderr)
            self.assertFalse((self.folder / "made.mesh").exists())


if __name__ == "__main__":
    unittest.main()
