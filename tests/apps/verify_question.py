# SPDX-License-Identifier: MIT
"""The question that `verify` answers: what its options ask is judged; what they leave open is taken from the
certificate and named in the output. Each test makes a mesh that passed before, by a word of its certificate."""
import json
import math
import pathlib
import re
import unittest

import command
from verdicts import identity, medit

ROOT = pathlib.Path(__file__).resolve().parents[2]

# A square with a slot from its left side and an island of one segment. It is valid as it stands; a repair within 0.45
# closes the slot.
SLOT = """12 2 0 0
1 0 0\n2 10 0\n3 10 10\n4 0 10\n5 5 5\n6 5.4 5\n7 5.4 5.4\n8 5 5.4\n9 0 3\n10 4 3\n11 0 3.3\n12 4 3.3
9 1
1 1 2 1\n2 2 3 1\n3 3 4 1\n4 4 11 1\n5 11 12 1\n6 12 10 1\n7 10 9 1\n8 9 1 1\n9 5 6 2
0
"""
# A square of which the last side misses the first corner, and crosses the first side.
OPEN = """5 2 0 0
1 0 0\n2 4 0\n3 4 4\n4 0 4\n5 0.001 -0.001
4 0
1 1 2\n2 2 3\n3 3 4\n4 4 5
0
"""
# A square with an arc for its right side.
BULGE = """4 2 0 0
1 -1 -1\n2 1 -1\n3 1 1\n4 -1 1
4 1
1 1 2 1\n2 2 3 1\n3 3 4 1\n4 4 1 1
0
0
curves 1
1 arc 2  0 0 ccw
"""
# A circle through one vertex, and another vertex far outside of it.
DISC = "2 2\n1 1 0\n2 7 3\n0\n0\n0\ncurves 1\n1 circle 1 0 0\n"
JUMP = "expr:(x>0)?100:1;0;1"


class Question(command.CommandTest):
    def made(self, *arguments, status=0):
        done = self.run_command("mesh", *arguments, "--quiet", "-o", "m.mesh")
        self.assertEqual(done.returncode, status, done.stdout + done.stderr)
        return json.loads((self.folder / "m.certificate.json").read_text())

    def verdict(self, status, *arguments, mesh="m.mesh"):
        done = self.run_command("verify", mesh, *arguments)
        self.assertEqual(done.returncode, status, done.stdout + done.stderr)
        return done.stdout + done.stderr

    def judged(self, *arguments):
        return json.loads(self.run_command("verify", "m.mesh", "--json", *arguments).stdout)

    def forget_certificate(self):
        (self.folder / "m.certificate.json").unlink()

    def forge(self, *edits):
        """Sets fields of the certificate: pairs of a path with dots and a value."""
        path = self.folder / "m.certificate.json"
        claim = json.loads(path.read_text())
        for name, value in edits:
            inner = claim
            *outer, last = name.split("/")
            for key in outer:
                inner = inner[key]
            inner[last] = value
        path.write_text(json.dumps(claim))

    def test_numbers_at_the_vertices_of_the_mesh_that_was_adapted_are_a_metric(self):
        self.made("square", "--size", "0.3")
        vertices = self.judged()["vertices"]
        for name, size in (("asked.sol", 0.2), ("finer.sol", 0.1)):
            self.write(name, "\n".join(["MeshVersionFormatted 2", "Dimension 2", "SolAtVertices", str(vertices), "1 1",
                                        *[str(size)] * vertices, "End", ""]))
        done = self.run_command("adapt", "m.mesh", "--metric", "asked.sol", "--quiet", "-o", "n.mesh")
        self.assertEqual(done.returncode, 0, done.stderr)
        self.verdict(0, "--metric", "asked.sol", mesh="n.mesh")
        said = self.verdict(1, "--metric", "finer.sol", mesh="n.mesh")
        self.assertIn("the metric of the mesh is 0.693147 from finer.sol", said)

    def test_a_domain_repaired_without_need_was_passed_for_the_domain(self):
        self.write("slot.poly", SLOT)
        self.made("slot.poly", "--repair-domain", "--repair-distance", "0.45")
        said = self.verdict(1, "--domain", "slot.poly")
        self.assertIn("the certificate is of slot.poly as repaired within 0.45, which moves it by up to 0.", said)
        self.assertIn("--repair-distance 0.45 asks for the repaired one", said)
        said = self.verdict(0, "--domain", "slot.poly", "--repair-distance", "0.45")
        self.assertRegex(said, r"; domain slot\.poly as repaired by up to 0\.\d+ \(within 0\.45\);")
        said = self.verdict(0)
        self.assertIn("; the certificate's domain, which it says was repaired within 0.45;", said)
        self.verdict(1, "--domain", "slot.poly", "--repair-distance", "0.1")
        self.forget_certificate()
        self.verdict(1, "--domain", "slot.poly", "--angle-bound", "20")
        self.verdict(0, "--domain", "slot.poly", "--angle-bound", "20", "--repair-distance", "0.45")

    def test_a_repair_without_effect_is_no_other_domain(self):
        self.write("slot.poly", SLOT)
        self.made("slot.poly", "--repair-domain")
        self.assertIn("; domain slot.poly;", self.verdict(0, "--domain", "slot.poly"))

    def test_a_repair_that_is_needed_is_named_with_its_greatest_move(self):
        self.write("open.poly", OPEN)
        self.made("open.poly", "--repair-domain", "--repair-distance", "0.01")
        said = self.verdict(0, "--domain", "open.poly")
        self.assertRegex(said, r"; domain open\.poly as repaired by up to 0\.001\d* \(within 0\.01, by the certificate\)")
        found = self.judged("--domain", "open.poly")["question"]
        self.assertEqual((found["repair_distance"], found["repair_distance_by"]), (0.01, "certificate"))
        self.assertAlmostEqual(found["greatest_move"], math.hypot(0.001, 0.001), places=6)
        self.forget_certificate()
        self.verdict(2, "--domain", "open.poly", "--angle-bound", "20")

    def test_options_without_what_they_speak_of_are_refused(self):
        self.made("square")
        self.verdict(2, "--repair-distance", "0.1")
        self.verdict(2, "--size", "0.1")
        self.verdict(2, "--gradation", "1.5")
        self.verdict(2, "--domain", "square", "--metric", "nothing")
        self.forget_certificate()
        self.assertIn("--metric names one", self.verdict(2, "--metric-tolerance", "1", "--angle-bound", "20"))

    def test_what_is_taken_from_the_certificate_is_named(self):
        self.made("square", "--metric", "swirl:3", "--size", "0.4", "--gradation", "1.5")
        said = self.verdict(0)
        for part in ("; bound 20 degrees, by the certificate; the certificate's domain; metric: swirl:3, by the "
                     "certificate, compared at every vertex",):
            self.assertIn(part, said)
        said = self.verdict(0, "--domain", "square", "--angle-bound", "20", "--metric", "swirl:3")
        self.assertIn("; bound 20 degrees; domain square; metric: swirl:3 (size 0.4, gradation 1.5 by the "
                      "certificate), compared at every vertex;", said)
        whole = ("--domain", "square", "--angle-bound", "20", "--metric", "swirl:3", "--size", "0.4", "--gradation", "1.5")
        self.assertNotIn("by the certificate", self.verdict(0, *whole))
        self.forget_certificate()
        self.assertIn("; metric: swirl:3, compared at every vertex", self.verdict(0, *whole))

    def test_another_metric_than_the_one_named_is_refused_with_its_distance(self):
        self.made("square", "--metric", "swirl:3", "--size", "0.4")
        for other in (("swirl:4", "0.4"), ("swirl:3", "0.41"), ("identity", "0.4")):
            said = self.verdict(1, "--metric", other[0], "--size", other[1])
            distance = re.search(r"^metric: the metric of the mesh is \S+ from \S+: a metric tolerance of (\S+) is kept",
                                 said, re.M)
            self.assertTrue(distance, said)
            asked = ("--metric", other[0], "--size", other[1], "--metric-tolerance")
            self.assertIn("; metric: another than asked for, ", self.verdict(0, *asked, distance[1]))
            self.verdict(1, *asked, float(distance[1]) * 0.999)

    def test_a_metric_on_a_mesh_is_asked_for_by_its_file(self):
        self.made("square", "--metric", "swirl:3", "--size", "0.3")
        self.run_command("mesh", "square", "--metric", "m.mesh", "--size", "1.2", "--quiet", "-o", "n.mesh")
        self.verdict(0, "--metric", "m.mesh", "--size", "1.2", mesh="n.mesh")
        self.verdict(0, "--metric", "m.mesh", mesh="n.mesh")
        self.verdict(1, "--metric", "m.mesh", "--size", "1.3", mesh="n.mesh")

    def test_the_line_says_how_far_a_metric_delivered_is(self):
        claim = self.made("square", "--metric", JUMP, "--size", "0.5")
        delivered = claim["outcome"]["delivered"]
        said = self.verdict(0)
        self.assertRegex(said, r"; metric: another than asked for, expr:\S+, by the certificate: lengths up to [\d.]+ "
                         r"times as long or as short \([\d.]+\), [\d.]+ times at half of the sites; \d+ triangles below "
                         r"the bound in the metric asked for, the worst [\d.]+; no metric tolerance, by the certificate")
        self.assertIn(f"; {len(delivered['low_triangles_as_wanted'])} triangles below", said)
        self.assertIn("; the theorem on nets, in the metric delivered, ", self.verdict(0, "--long"))
        found = self.judged()
        self.assertEqual(found["metric_delivered"]["greatest"], delivered["greatest"])
        self.assertEqual(found["metric_delivered"]["low_triangles_as_wanted"], len(delivered["low_triangles_as_wanted"]))
        self.assertTrue(found["metric_checked"])
        self.verdict(1, "--metric-tolerance", delivered["greatest"] * 0.99)
        self.assertNotIn("by the certificate: lengths", self.verdict(0, "--metric", JUMP))
        self.forget_certificate()
        asked = ("--angle-bound", "20", "--domain", "square", "--metric", JUMP, "--size", "0.5")
        self.verdict(1, *asked)
        self.verdict(0, *asked, "--metric-tolerance", delivered["greatest"])

    def test_an_incomplete_run_was_completed_by_two_words(self):
        claim = self.made("square", "--metric", JUMP, "--size", "0.5", "--metric-tolerance", "0.1", status=1)
        options = {**claim["asked"]["options"], "metric-tolerance": "none"}
        tolerance = ("asked/options", options)
        done = ("outcome/complete", True)
        reason = ("outcome/reason", "all stars agree and every triangle meets the bound")
        for edits in ((done,), (done, tolerance), (done, tolerance, reason), (done, ("asked/options", {}), reason),
                      (done, ("asked/options", {}), ("asked/metric", ""), ("outcome/reason", "")),
                      (done, ("asked/options", {**options, "metric-tolerance": "1"}), reason)):
            self.folder.joinpath("m.certificate.json").write_text(json.dumps(claim))
            self.forge(*edits)
            with self.subTest(edits=[name for name, _ in edits]):
                if edits[-1][0] != "outcome/reason" or edits[-1][1]:
                    self.verdict(1)
                else:  # the certificate names no metric, and says so
                    self.assertIn("the certificate names none; it says lengths up to 3.92", self.verdict(0))
        self.folder.joinpath("m.certificate.json").write_text(json.dumps(claim))
        self.forge(done, tolerance, ("outcome/reason", reason[1] + ", in the metric delivered"))
        self.assertIn("no metric tolerance, by the certificate", self.verdict(0))
        self.verdict(1, "--metric-tolerance", "0.1")

    def test_another_metric_altogether_is_not_completed_by_leaving_the_options_away(self):
        other = "expr:((x>0)==(y>0))?1e6:1;0;((x>0)==(y>0))?1:1e6"
        self.made("square", "--metric", other, "--size", "3", status=1)
        self.forge(("outcome/complete", True), ("asked/options", {}), ("asked/metric", ""), ("outcome/reason", ""))
        self.assertIn("of half of the sites the metric delivered is more than", self.verdict(1))


class NothingJudged(command.CommandTest):
    """Slivers whose sides are all segments, so that every low angle is the domain's own."""

    def strip(self, good=0, inner_marked=True):
        """Writes 40 slivers, and beside them `good` rhombi whose short diagonals are no segments."""
        n, shear = 20, 150.0
        points = [(i + shear * j, j, 0) for j in (0, 1) for i in range(n + 1)]
        low, high = list(range(1, n + 2)), list(range(n + 2, 2 * n + 3))
        triangles = []
        for i in range(n):
            triangles += [(low[i], low[i + 1], high[i], 1), (low[i + 1], high[i + 1], high[i], 1)]
        free = set()
        for k in range(good):
            at = len(points)
            points += [(1000 + 3 * k + x, y, 0) for x, y in ((0, 0), (1, 0), (1.5, 0.9), (0.5, 0.9))]
            triangles += [(at + 1, at + 2, at + 4, 1), (at + 2, at + 3, at + 4, 1)]
            free.add((at + 2, at + 4))
        sides = [tuple(sorted((t[k], t[(k + 1) % 3]))) for t in triangles for k in range(3)]
        self.segments = sorted({s for s in sides if s not in free and (inner_marked or sides.count(s) == 1)})
        self.points = points
        inner = [i + 1 for i, s in enumerate(self.segments) if sides.count(s) == 2]
        text = medit(points, triangles, [(*s, 1) for s in self.segments], [(i,) for i in inner])
        given = "\n".join(["RequiredVertices", str(len(points)), *(str(i + 1) for i in range(len(points))), "End", ""])
        self.write("s.mesh", text.replace("End\n", given))
        self.write("s.sol", identity(len(points)))
        self.write("s.poly", "\n".join(
            [f"{len(points)} 2 0 0", *(f"{i + 1} {x!r} {y!r}" for i, (x, y, _) in enumerate(points)),
             f"{len(self.segments)} 1", *(f"{i + 1} {a} {b} 1" for i, (a, b) in enumerate(self.segments)), "0", ""]))

    def told(self, status, *words):
        done = self.run_command(*words)
        self.assertEqual(done.returncode, status, done.stdout + done.stderr)
        return done.stdout + done.stderr

    def test_slivers_between_segments_were_certified_by_every_route_but_one(self):
        for good in (0, 1, 15):
            with self.subTest(good=good):
                self.strip(good)
                bound = ("--angle-bound", "20")
                self.assertIn("nothing_judged: ", self.told(1, "certify", "s.mesh", *bound))
                self.assertIn("nothing_judged: ", self.told(1, "verify", "s.mesh", *bound))
                said = self.told(1, "verify", "s.mesh", *bound, "--domain", "s.poly")
                self.assertIn(f"nothing_judged: 40 of {40 + 2 * good} triangles have segments for all their sides", said)
                self.assertIn(f", 40 of {40 + 2 * good} triangles exempt at ", said)
                self.told(0, "certify", "s.mesh", "--angle-bound", "0", "-o", "m.mesh")
                self.told(0, "verify", "m.mesh")
                claim = json.loads((self.folder / "m.certificate.json").read_text())
                claim["asked"]["angle_bound"], claim["asked"]["options"]["angle-bound"] = 20.0, "20"
                self.write("m.certificate.json", json.dumps(claim))
                self.assertIn("nothing_judged: ", self.told(1, "verify", "m.mesh"))

    def test_few_slivers_among_many_triangles_are_told(self):
        self.strip(60)
        said = self.told(0, "verify", "s.mesh", "--angle-bound", "20", "--domain", "s.poly")
        self.assertRegex(said, r", 40 of 160 triangles exempt at \d+ corners, the sharpest 0\.00")

    def test_a_domain_of_one_sharp_triangle_is_judged(self):
        self.write("t.poly", "3 2 0 0\n1 0 0\n2 10 0\n3 10 0.5\n3 0\n1 1 2\n2 2 3\n3 3 1\n0\n")
        self.told(0, "mesh", "t.poly", "-o", "t.mesh")
        self.assertIn(", 1 of 1 triangles exempt at 1 corners, the sharpest 2.86", self.told(0, "verify", "t.mesh"))
        self.told(0, "verify", "t.mesh", "--domain", "t.poly")


class OwnMeshes(command.CommandTest):
    """`verify` confirms what `mesh` makes, by the certificate alone and by options that ask the same."""
    METRICS = ("identity", "swirl:3", "sink:3", "layer:0.1,0.2", "shock:10", "linear", "polar-1", "polar-2", "circle-1",
               "expr:1+x*x;0.1;1+y*y")
    # Metrics with short lengths get a larger size, to save time.
    DENSE = {"polar-1": 8, "polar-2": 8, "circle-1": 8}
    DOMAINS = {"square": 0.5, "airfoil": 4, "plate.poly": 2, "fillets.poly": 8, "spline_airfoil.poly": 2,
               "bulge.poly": 0.5, "disc.poly": 0.5}

    def setUp(self):
        super().setUp()
        self.write("bulge.poly", BULGE)
        self.write("disc.poly", DISC)
        for path in (ROOT / "examples/plate.poly", ROOT / "examples/fillets.poly",
                     ROOT / "tests/apps/spline_airfoil.poly"):
            self.write(path.name, path.read_bytes())

    def test_meshes_of_formulas_placed_in_the_box_of_curves_were_refused(self):
        for shape, base in self.DOMAINS.items():
            for metric in self.METRICS:
                size = base * self.DENSE.get(metric, 1)
                with self.subTest(shape=shape, metric=metric):
                    done = self.run_command("mesh", shape, "--metric", metric, "--size", size, "--max-sites", "3000",
                                            "--quiet", "-o", "m.mesh")
                    self.assertIn(done.returncode, (0, 1), done.stderr)
                    asked = ("--domain", shape, "--angle-bound", "20", "--metric", metric, "--size", size)
                    for more in ((), asked):
                        said = self.run_command("verify", "m.mesh", *more)
                        self.assertEqual(said.returncode, done.returncode, said.stdout + said.stderr)
                        self.assertNotIn("the tensors of", said.stdout)
                        if done.returncode == 0:
                            self.assertNotIn("metric of the mesh is", said.stdout)


if __name__ == "__main__":
    unittest.main()
