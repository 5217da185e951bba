# SPDX-License-Identifier: MIT
"""Tests what "certified" and the exit status mean, through the real command: sharp corners, edges that a file
lists, lost and forged certificates, and the files of a run as one unit."""
import json
import math
import re
import resource
import subprocess
import unittest

import command


def medit(vertices, triangles, edges=(), required=()):
    def rows(name, entries):
        return [name, str(len(entries)), *(" ".join(map(str, e)) for e in entries)] if entries else []

    lines = ["MeshVersionFormatted 2", "Dimension 2", *rows("Vertices", vertices),
             *rows("Triangles", triangles), *rows("Edges", edges), *rows("RequiredEdges", required)]
    return "\n".join([*lines, "End", ""])


def identity(count):
    return "\n".join(["MeshVersionFormatted 2", "Dimension 2", "SolAtVertices", str(count), "1 3",
                      *["1 0 1"] * count, "End", ""])


class Verdicts(command.CommandTest):
    def judged(self, name, *arguments):
        """Checks that certify and verify end with the same status, and what they print."""
        one = self.run_command("certify", name, "--angle-bound", "20", *arguments)
        two = self.run_command("verify", name, "--angle-bound", "20", *arguments)
        self.assertEqual(one.returncode, two.returncode, one.stdout + two.stdout + two.stderr)
        return one.returncode, one.stdout, two.stdout

    def strip(self, reference, required=False, every=True):
        """Writes 40 triangles with an angle of less than a degree each, all edges listed."""
        n, shear = 20, 200.0
        points = [(i + shear * j, j, 0) for j in (0, 1) for i in range(n + 1)]
        low, high = list(range(1, n + 2)), list(range(n + 2, 2 * n + 3))
        triangles = []
        for i in range(n):
            triangles += [(low[i], low[i + 1], high[i], 1), (low[i + 1], high[i + 1], high[i], 1)]
        sides = {tuple(sorted((t[k], t[(k + 1) % 3]))) for t in triangles for k in range(3)}
        edges = [(a, b, reference) for a, b in sorted(sides)][0 if every else 1:]
        marks = [(i + 1,) for i in range(len(edges))] if required else ()
        self.write("strip.mesh", medit(points, triangles, edges, marks))
        self.write("strip.sol", identity(len(points)))

    def test_a_sheared_strip_with_all_edges_listed_was_certified(self):
        for reference in (0, 1, 5):
            self.strip(reference)
            status, certified, verified = self.judged("strip.mesh")
            self.assertEqual(status, 1)
            self.assertIn("NOT certified", certified)
            self.assertIn("angle_below_bound: ", certified)
            self.assertIn("REFUSED", verified)
        self.strip(5, required=True)
        status, certified, verified = self.judged("strip.mesh")
        self.assertEqual(status, 1)
        self.assertIn("nothing_judged: all ", certified)
        self.assertIn("nothing_judged: all ", verified)
        self.strip(0)
        self.assertIn("nothing_judged: all ", self.judged("strip.mesh", "--all-edges")[1])

    def test_findings_are_ten_of_each_kind_or_all(self):
        self.strip(0)
        for name in ("certify", "verify"):
            few = self.run_command(name, "strip.mesh", "--angle-bound", "20").stdout
            every = self.run_command(name, "strip.mesh", "--angle-bound", "20", "--all-findings").stdout
            self.assertEqual(len(re.findall(r"^angle_below_bound: the angle", few, re.M)), 10)
            self.assertRegex(few, r"(?m)^angle_below_bound: \d+ more \(--all-findings lists them\)$")
            self.assertGreater(len(re.findall(r"^angle_below_bound: the angle", every, re.M)), 40)
            self.assertNotIn(" more (", every)

    def test_direction_and_inner_edges_of_a_list_do_not_matter(self):
        done = self.run_command("mesh", "square", "--metric", "swirl:3", "--size", "0.4", "--quiet",
                                "-o", "good.mesh")
        self.assertEqual(done.returncode, 0, done.stderr)
        lines = (self.folder / "good.mesh").read_text().splitlines()
        start = lines.index("Triangles") + 2
        triangles = [tuple(map(int, line.split())) for line in lines[start:start + int(lines[start - 1])]]
        place = lines.index("Vertices") + 2
        points = [tuple(line.split()) for line in lines[place:place + int(lines[place - 1])]]
        sides = sorted({tuple(sorted((t[k], t[(k + 1) % 3]))) for t in triangles for k in range(3)})
        told = []
        for edges in ((), [(b, a, 0) for a, b in sides], [(a, b, 3) for a, b in sides]):
            self.write("other.mesh", medit(points, triangles, edges))
            self.write("other.sol", (self.folder / "good.sol").read_text())
            status, certified, verified = self.judged("other.mesh")
            self.assertEqual(status, 0, certified + verified)
            told.append(verified)
        self.assertEqual(len(set(told)), 1)

    def test_only_the_sharp_corners_own_angle_is_exempt(self):
        # The domain's corner has 19 degrees. The first triangle's apex is so low that its other angle is 0.1 degrees.
        far = (math.cos(math.radians(19)), math.sin(math.radians(19)))
        near = 0.005
        points = [(0, 0, 0), (1, 0, 0), (near * far[0], near * far[1], 0), (*far, 0)]
        self.write("w.mesh", medit(points, [(1, 2, 3, 1), (2, 4, 3, 1)]))
        self.write("w.sol", identity(4))
        status, certified, _ = self.judged("w.mesh")
        self.assertEqual(status, 1)
        self.assertRegex(certified, r"collateral_angle_below_bound: the angle at vertex 2 .* is 0\.\d+ degr")
        self.assertIn("collateral beside sharp corners, the worst 0.", certified)

    def test_a_narrow_wedge_between_internal_segments_is_not_called_certified(self):
        wedge = "\n".join(["7 2 0 0", "0 -1 -1", "1 1 -1", "2 1 1", "3 -1 1", "4 0 0", "5 0.7 0",
                           f"6 {0.7 * math.cos(math.radians(1))} {0.7 * math.sin(math.radians(1))}",
                           "6 0", "0 0 1", "1 1 2", "2 2 3", "3 3 0", "4 4 5", "5 4 6", "0", ""])
        self.write("w.poly", wedge)
        done = self.run_command("mesh", "w.poly", "--size", "0.2", "-o", "w.mesh")
        self.assertEqual(done.returncode, 1, done.stdout)
        self.assertRegex(done.stdout, r"\d+ collateral beside sharp corners, the worst \d")
        self.assertRegex(done.stdout, r"\ANOT certified")
        self.assertRegex(done.stderr, r"not reached: all stars agree, but \d+ triangles beside corners of the domain"
                         r".* the sharpest corner beside them is vertex 5 at \(0, 0\), 1 degrees")
        audit = json.loads((self.folder / "w.certificate.json").read_text())["audit"]
        self.assertTrue(audit["collateral_triangles"])
        self.assertLess(audit["worst_collateral_angle"], 20)
        self.assertAlmostEqual(audit["worst_exempt_angle"], 1, places=6)

    def make_good(self, *arguments):
        done = self.run_command("mesh", "square", "--metric", "swirl:3", "--size", "0.4", "--quiet",
                                *arguments, "-o", "good.mesh")
        self.assertEqual(done.returncode, 0, done.stderr)
        return json.loads((self.folder / "good.certificate.json").read_text())

    def test_a_lost_certificate_does_not_certify(self):
        self.make_good()
        (self.folder / "good.certificate.json").unlink()
        done = self.run_command("verify", "good.mesh")
        self.assertEqual(done.returncode, 1)
        self.assertRegex(done.stdout, "^no bound asked for: not certified: ")
        self.assertEqual(self.run_command("verify", "good.mesh", "--angle-bound", "20").returncode, 0)

    def test_the_line_of_verify_says_what_was_checked(self):
        claim = self.make_good()
        done = self.run_command("verify", "good.mesh")
        self.assertRegex(done.stdout, "^certified: .*; bound 20 degrees, by the certificate; the certificate's domain; metric: "
                         "swirl:3, by the certificate, compared at every vertex; size asked for 0.4, not checked\n$")
        self.assertIn("; the theorem on nets, in the metric asked for, ", self.run_command("verify", "good.mesh", "--long").stdout)
        claim["asked"]["metric"] = "swirl:4"
        self.write("good.certificate.json", json.dumps(claim))
        done = self.run_command("verify", "good.mesh")
        self.assertEqual(done.returncode, 1)
        self.assertRegex(done.stdout, r'certificate: the tensors of \d+ of \d+ vertices are not those of '
                         '"asked.metric": vertex')

    def test_whether_the_theorem_on_nets_applies_is_said_measured_again_and_not_forged(self):
        slow = ("square", "--metric", "sink:3", "--size", "0.05")
        fast = ("square", "--metric", "swirl:24", "--size", "0.5")
        for job, applies in ((slow, True), (fast, False)):
            done = self.run_command("mesh", *job, "-o", "m.mesh")
            self.assertEqual(done.returncode, 0, done.stderr)
            said = "nets: applies: at sigma eps 0.0" if applies else "nets: does not apply: "
            self.assertNotIn("theorem", done.stdout)
            claim = json.loads((self.folder / "m.certificate.json").read_text())
            self.assertIs(claim["theorem"]["theorem_applies"], applies)
            line = self.run_command("verify", "m.mesh", "--long").stdout
            self.assertIn("; the theorem on " + said.replace("nets:", "nets, in the metric asked for,"), line)
            told = json.loads(self.run_command("verify", "m.mesh", "--json").stdout)["theorem"]
            self.assertIs(told["applies"], applies)
            self.assertEqual(told["reason"], claim["theorem"]["reason"])
            if applies:
                self.assertGreater(claim["theorem"]["sigma_eps"], 0)
                self.assertGreaterEqual(claim["theorem"]["proved_angle"], 20)
            else:
                self.assertIn(claim["theorem"]["reason"], line)
            for field, value in claim["theorem"].items():
                forged = json.loads(json.dumps(claim))
                forged["theorem"][field] = (not value if isinstance(value, bool) else value + "!"
                                            if isinstance(value, str) else math.nextafter(value or 0, 9))
                self.write("m.certificate.json", json.dumps(forged))
                done = self.run_command("verify", "m.mesh")
                self.assertEqual(done.returncode, 1, field)
                self.assertIn(f'"theorem.{field}" is ', done.stdout)
            forged["theorem"] = None
            self.write("m.certificate.json", json.dumps(forged))
            self.assertIn('"theorem" is null', self.run_command("verify", "m.mesh").stdout)

    def test_split_points_off_their_segments_by_more_than_an_ulp_are_told(self):
        # A square of side 2 about (2^20, 2^20); the middle of its bottom side is off by some ulps of 2^20.
        far, ulp = 2.0**20, 2.0**-32
        for ulps, told in ((1, None), (2, r"points of split segments off them by up to 4\.66e-10 \(2\.00 ulps\)")):
            points = [(far + x, far + y, 0) for x, y in ((-1, -1), (1, -1), (1, 1), (-1, 1), (0, -1))]
            points[4] = (far, far - 1 + ulps * ulp, 0)
            edges = [(1, 5, 0), (5, 2, 0), (2, 3, 0), (3, 4, 0), (4, 1, 0)]
            poly = ["4 2 0 0", *(f"{i} {points[i][0]!r} {points[i][1]!r}" for i in range(4)), "4 0",
                    *(f"{i} {i} {(i + 1) % 4}" for i in range(4)), "0", ""]
            self.write("d.poly", "\n".join(poly))
            self.write("d.mesh", medit([(repr(x), repr(y), r) for x, y, r in points],
                                       [(1, 5, 4, 1), (5, 2, 3, 1), (5, 3, 4, 1)], edges).replace(
                                           "End\n", "RequiredVertices\n4\n1\n2\n3\n4\nEnd\n"))
            self.write("d.sol", identity(5))
            done = self.run_command("verify", "d.mesh", "--domain", "d.poly", "--angle-bound", "20")
            self.assertEqual(done.returncode, 0, done.stdout + done.stderr)
            if told is None:
                self.assertNotIn("off them", done.stdout)
            else:
                self.assertRegex(done.stdout, told)

    def test_a_certificate_that_hides_another_metric_was_verified(self):
        self.run_command("mesh", "square", "--metric", "expr:(x>0)?100:1;0;1", "--size", "0.5", "--quiet",
                         "-o", "jump.mesh")
        path = self.folder / "jump.certificate.json"
        claim = json.loads(path.read_text())
        self.assertIsNotNone(claim["outcome"]["delivered"])
        claim["outcome"].update(complete=True, delivered=None,
                                reason="all stars agree and every triangle meets the bound")
        claim["asked"]["options"]["size-delivered"] = claim["asked"]["options"]["size"]
        path.write_text(json.dumps(claim))
        done = self.run_command("verify", "jump.mesh")
        self.assertEqual(done.returncode, 1, done.stdout)
        self.assertIn('not those of "asked.metric"', done.stdout)

    def test_thinned_certificates_were_verified(self):
        whole = self.make_good()
        for path in (("numbering",), ("measured",), ("measured", "mean_quality"),
                     ("audit", "low_triangles"), ("audit", "voronoi"), ("outcome", "delivered"),
                     ("asked", "options", "angle-bound"), ("domain", "segments")):
            claim = json.loads(json.dumps(whole))
            inner = claim
            for key in path[:-1]:
                inner = inner[key]
            del inner[path[-1]]
            self.write("good.certificate.json", json.dumps(claim))
            done = self.run_command("verify", "good.mesh")
            self.assertNotEqual(done.returncode, 0, path)
            self.assertIn(path[-1] + '"', done.stdout + done.stderr)

    def test_messages_on_certificates_name_field_and_line(self):
        self.make_good()
        text = (self.folder / "good.certificate.json").read_text()
        spoils = (('"numbering": "from 1"', '"numbering": "from 0"', r'"numbering" is not what'),
                  ('"format": "asterism certificate 2"', '"format": 3', "this is not an"),
                  ('"certified": true', '"certified": true,\n  "certified": true', '"audit.certified" is there twice'),
                  ('"certified": true', '"certified": true,\n  "luck": 1', '"audit.luck" is no field'),
                  ('"angle_bound": 20.0', '"angle_bound": 1e999', '"asked.angle_bound" is beyond the range'),
                  ('"audit": {', '"audit": {{', "this is not JSON"))
        for old, new, said in spoils:
            self.assertIn(old, text)
            self.write("good.certificate.json", text.replace(old, new, 1))
            done = self.run_command("verify", "good.mesh")
            self.assertEqual(done.returncode, 2, new)
            self.assertRegex(done.stderr, r"^asterism: good\.certificate\.json:\d+: " + said)
            self.assertNotIn("json.exception", done.stderr)

    def test_references_of_vertices_and_corners_are_read_and_checked(self):
        self.make_good()
        text = (self.folder / "good.mesh").read_text()
        lines = text.splitlines()
        row = lines.index("Vertices") + 2
        lines[row] = " ".join([*lines[row].split()[:2], "77"])
        self.write("good.mesh", "\n".join(lines) + "\n")
        done = self.run_command("verify", "good.mesh")
        self.assertEqual(done.returncode, 1)
        self.assertIn("fingerprints differ", done.stdout)
        for bad in ("-1", "1000000000", "0x10"):
            self.write("good.mesh", re.sub(r"(\nCorners\n\d+\n)\d+", r"\g<1>" + bad, text))
            done = self.run_command("verify", "good.mesh")
            self.assertEqual(done.returncode, 2, bad)
            self.assertRegex(done.stderr, r"good\.mesh:\d+: corner: ")

    def test_a_tensor_that_is_no_metric_is_named_with_its_line(self):
        self.make_good()
        lines = (self.folder / "good.sol").read_text().splitlines()
        row = lines.index("SolAtVertices") + 5
        lines[row] = "1 2 1"
        self.write("good.sol", "\n".join(lines) + "\n")
        done = self.run_command("verify", "good.mesh")
        self.assertEqual(done.returncode, 2)
        self.assertIn(f"good.sol:{row + 1}: the metric tensor 1 2 1 of vertex 3 is not positive definite",
                      done.stderr)

    def test_the_old_name_of_the_strategy_is_refused_with_the_new_one(self):
        done = self.run_command("mesh", "square", "--refine", "guaranteed", "-o", "m.mesh")
        self.assertEqual(done.returncode, 2)
        self.assertIn("fill", done.stderr)
        self.assertEqual(self.files(), [])


class FilesOfARun(command.CommandTest):
    def contents(self):
        return {name: (self.folder / name).read_bytes() for name in self.files()}

    def test_a_limit_on_the_size_of_files_leaves_the_old_set(self):
        arguments = ["mesh", "square", "--quiet", "-o", "m.svg", "-o", "m.mesh"]
        self.assertEqual(self.run_command(*arguments, "--size", "1").returncode, 0)
        before = self.contents()
        largest = max(map(len, before.values()))
        done = subprocess.run(
            [command.PROGRAM, *arguments, "--size", "0.1"], cwd=self.folder, capture_output=True,
            preexec_fn=lambda: resource.setrlimit(resource.RLIMIT_FSIZE, (largest, largest)), check=False)
        self.assertEqual(done.returncode, 1, done.stderr)
        self.assertRegex(done.stderr.decode(), r"m\.\S+: cannot be written: File too large")
        self.assertEqual(self.contents(), before)

    def test_files_that_are_replaced_leave_no_second_names(self):
        arguments = ["mesh", "square", "--quiet", "-o", "a.vtu", "-o", "b.mesh"]
        self.assertEqual(self.run_command(*arguments, "--size", "1").returncode, 0)
        before = self.contents()
        self.assertEqual(self.run_command(*arguments, "--size", "0.5").returncode, 0)
        after = self.contents()
        self.assertEqual(sorted(before), sorted(after))
        self.assertTrue(all(before[name] != after[name] for name in after))


if __name__ == "__main__":
    unittest.main()
