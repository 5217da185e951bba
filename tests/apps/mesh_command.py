# SPDX-License-Identifier: MIT
"""The main job through the real command: files, certificate, exit statuses."""
import json
import math
import re
import unittest

import command

SUMMARY = (r"\Acertified: \d+ sites, \d+ triangles, worst angle \d+\.\d\d degrees \(bound \d+\), 0 disagreeing, 0 low-angle"
           r"{}\nwritten in \d+\.\d\d seconds: [^\n]+\n\Z")
UNSIZED = SUMMARY.format("")
SIZED = SUMMARY.format(r", \d+\.\d\d% unit edges(?: \(mean length in the metric [\d.e+-]+, not 1\))?")


# A square with a smaller one at each of two sides.
BOXES = """12 2 0 0
1 0 0\n2 4 0\n3 4 4\n4 0 4\n5 4 1\n6 8 1\n7 8 3\n8 4 3\n9 1 4\n10 3 4\n11 3 6\n12 1 6
12 0
1 1 2\n2 2 3\n3 3 4\n4 4 1\n5 5 6\n6 6 7\n7 7 8\n8 8 5\n9 9 10\n10 10 11\n11 11 12\n12 12 9
0
"""


# A domain of one triangle. Its sharp corner is exempt.
NEEDLE = "3 2 0 0\n1 0 0\n2 10 0\n3 10 0.5\n3 0\n1 1 2\n2 2 3\n3 3 1\n0\n"


class Mesh(command.CommandTest):
    def make(self, *more):
        done = self.run_command(*command.JOB, "-o", "m.mesh", *more)
        self.assertEqual(done.returncode, 0, done.stdout + done.stderr)
        return done

    def test_the_main_job(self):
        done = self.make("-o", "m.svg", "-o", "m.png", "-o", "m.pdf", "-o", "m.vtu", "--ellipses")
        self.assertRegex(done.stdout, UNSIZED)
        self.assertEqual(done.stderr, "")
        self.assertEqual(self.files(), ["m.certificate.json", "m.mesh", "m.pdf", "m.png", "m.sol",
                                        "m.svg", "m.vtu"])
        claim = json.loads((self.folder / "m.certificate.json").read_text())
        self.assertTrue(claim["outcome"]["complete"])
        self.assertEqual(claim["asked"]["options"]["random-points"], "10")
        lines = (self.folder / "m.mesh").read_text().splitlines()
        start, count = command.section(lines, "RequiredVertices")
        self.assertEqual(lines[start:start + count], [str(v + 1) for v in range(14)])

    def test_a_metric_at_the_vertices_of_a_mesh(self):
        """The mesh is made by local changes. The distance of its metric from the wanted one is said and written.
        `verify` measures it again, until the file of the wanted metric changes."""
        done = self.run_command("mesh", "square", "--metric", "shock:20", "--size", "0.6", "--quiet",
                                "-o", "first.mesh")
        self.assertIn(done.returncode, (0, 1), done.stderr)
        done = self.run_command("mesh", "square", "--metric", "first.mesh", "--size", "1", "-o",
                                "second.mesh")
        self.assertEqual(done.returncode, 0, done.stdout + done.stderr)
        self.assertIn("delivered: ", done.stdout)
        path = self.folder / "second.certificate.json"
        claim = json.loads(path.read_text())
        self.assertLess(claim["outcome"]["delivered"]["beyond_tenth"], 1)
        done = self.run_command("verify", "second.mesh")
        self.assertEqual(done.returncode, 0, done.stdout + done.stderr)
        self.assertNotIn("note:", done.stdout)
        claim["outcome"]["delivered"]["greatest"] = 0.5
        path.write_text(json.dumps(claim))
        done = self.run_command("verify", "second.mesh")
        self.assertEqual(done.returncode, 1, done.stdout + done.stderr)
        self.assertIn("greatest", done.stdout)
        (self.folder / "first.mesh").unlink()
        done = self.run_command("verify", "second.mesh")
        self.assertIn("field not checked, first.mesh: no such file", done.stdout)

    def test_the_same_arguments_give_the_same_bytes(self):
        names = ["m.mesh", "m.sol", "m.svg", "m.vtu", "m.certificate.json"]
        seen = []
        for _ in range(2):
            self.make("-o", "m.svg", "-o", "m.vtu", "--quiet")
            seen.append([(self.folder / name).read_bytes() for name in names])
        self.assertEqual(seen[0], seen[1])
        self.assertNotEqual(seen[0], [b""] * len(names))

    def test_quiet_says_nothing(self):
        done = self.make("--quiet")
        self.assertEqual((done.stdout, done.stderr), ("", ""))

    def test_what_is_not_reached_is_said_everywhere(self):
        done = self.run_command("mesh", "square", "--metric", "swirl:12", "--random-points", "10",
                                "--max-sites", "40", "-o", "m.mesh", "-o", "m.vtu", "-o", "m.svg",
                                "--certificate", "c.json")
        self.assertEqual(done.returncode, 1)
        self.assertRegex(done.stdout, "NOT complete|NOT certified, incomplete")
        self.assertRegex(done.stderr, r"\Aasterism: not reached: .*40")
        self.assertFalse(json.loads((self.folder / "c.json").read_text())["outcome"]["complete"])
        for name in ("m.mesh", "m.vtu", "m.svg"):
            head = (self.folder / name).read_bytes().decode(errors="replace").splitlines()[1]
            self.assertRegex(head, "Incomplete, not certified: .*40", name)
        self.assertEqual(self.run_command("verify", "m.mesh", "--certificate", "c.json").returncode, 1)

    def test_a_metric_in_which_stars_cannot_agree(self):
        turning = "expr:sin(6*x)*sin(6*y)>0?100:4;0;sin(6*x)*sin(6*y)>0?4:100"
        job = ["mesh", "square", "--metric", turning, "--size", "1", "-o", "m.mesh", "-o", "m.svg"]
        done = self.run_command(*job)
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertRegex(done.stdout, r"\ndelivered: \S+ % of the sites have lengths changed")
        self.assertRegex(done.stdout, r"\Acertified: .*, 0 disagreeing, ")
        claim = json.loads((self.folder / "m.certificate.json").read_text())
        self.assertTrue(claim["audit"]["certified"])
        self.assertEqual(claim["audit"]["low_triangles"], [])
        delivered = claim["outcome"]["delivered"]
        low = delivered["low_triangles_as_wanted"]
        self.assertGreater(len(low), 0)
        self.assertEqual(low, sorted(set(low)))
        self.assertLess(delivered["worst_angle_as_wanted"], 20)
        self.assertLessEqual(low[-1], claim["mesh"]["triangles"])
        self.assertEqual(self.run_command("verify", "m.mesh").returncode, 0)
        # Hides the low triangles from the certificate's list: verify must not believe it.
        hidden = json.loads((self.folder / "m.certificate.json").read_text())
        hidden["outcome"]["delivered"]["low_triangles_as_wanted"] = []
        (self.folder / "hidden.json").write_text(json.dumps(hidden))
        done = self.run_command("verify", "m.mesh", "--certificate", "hidden.json")
        self.assertEqual(done.returncode, 1)
        self.assertRegex(done.stdout, "%d triangles are below the bound, and the certificate lists 0, or others" % len(low))
        hidden["asked"]["options"]["gradation"] = "1.5"
        (self.folder / "hidden.json").write_text(json.dumps(hidden))
        done = self.run_command("verify", "m.mesh", "--certificate", "hidden.json")
        self.assertEqual(done.returncode, 1)
        self.assertIn('"asked.options.gradation" and "asked.options.gradation-done" contradict', done.stdout)
        done = self.run_command("verify", "m.mesh", "--certificate", "none.json")
        self.assertEqual(done.returncode, 2)
        (self.folder / "m.certificate.json").unlink()
        self.assertEqual(self.run_command("verify", "m.mesh").returncode, 1)
        self.assertEqual(self.run_command("verify", "m.mesh", "--angle-bound", "20").returncode, 0)

        done = self.run_command(*job, "--metric-tolerance", "0")
        self.assertEqual(done.returncode, 1)
        self.assertRegex(done.stdout, r"\ANOT certified, incomplete: .*, [1-9]\d* disagreeing, ")
        claim = json.loads((self.folder / "m.certificate.json").read_text())
        self.assertIsNone(claim["outcome"]["delivered"])
        self.assertEqual(claim["asked"]["options"]["metric-tolerance"], "0")

    def test_a_metric_that_is_another_one_is_not_complete(self):
        job = ("mesh", "square", "--metric", "expr:((x>0)==(y>0))?3e5:1;0;((x>0)==(y>0))?1:3e5", "--size", "3",
               "-o", "m.mesh")
        done = self.run_command(*job)
        self.assertEqual(done.returncode, 1, done.stdout)
        self.assertIn("another one than the one wanted: half of the sites find some length more than", done.stderr)
        self.assertRegex(done.stderr, "try --metric-tolerance [0-9.]+")
        claim = json.loads((self.folder / "m.certificate.json").read_text())
        self.assertFalse(claim["outcome"]["complete"])
        self.assertEqual(self.run_command("verify", "m.mesh").returncode, 1)
        claim["outcome"]["complete"] = True
        (self.folder / "m.certificate.json").write_text(json.dumps(claim))
        self.assertIn("of half of the sites the metric delivered is more than",
                      self.run_command("verify", "m.mesh").stdout)
        found = repr(claim["outcome"]["delivered"]["greatest"])
        claim["outcome"]["delivered"].update(median=0.0, complexity_delivered=1e9)
        (self.folder / "m.certificate.json").write_text(json.dumps(claim))
        self.assertIn("times as dense or as thin as the one wanted", self.run_command("verify", "m.mesh").stdout)
        done = self.run_command(*job, "--metric-tolerance", found)
        self.assertEqual(done.returncode, 0, done.stderr)

    def test_metric_tolerance(self):
        job = ("mesh", "square", "--metric", "expr:(x>0)?100:1;0;1", "--size", "0.5", "-o", "m.mesh")
        self.assertEqual(self.run_command(*job).returncode, 0)
        claim = json.loads((self.folder / "m.certificate.json").read_text())
        self.assertEqual(claim["asked"]["options"]["metric-tolerance"], "none")
        greatest = claim["outcome"]["delivered"]["greatest"]
        done = self.run_command(*job, "--metric-tolerance", repr(greatest))
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertEqual(self.run_command("verify", "m.mesh").returncode, 0)
        kept = json.loads((self.folder / "m.certificate.json").read_text())
        kept["asked"]["options"]["metric-tolerance"] = "0.1"
        (self.folder / "m.certificate.json").write_text(json.dumps(kept))
        done = self.run_command("verify", "m.mesh")
        self.assertEqual(done.returncode, 1)
        self.assertIn("from the one wanted, where 0.1 is tolerated", done.stdout)
        for tolerance in ("0.1", "0"):
            done = self.run_command(*job, "--metric-tolerance", tolerance)
            self.assertEqual(done.returncode, 1)
            self.assertRegex(done.stderr, "where %s is tolerated; a metric tolerance of [0-9.]+ is kept" % tolerance)
            self.assertEqual(self.run_command("verify", "m.mesh").returncode, 1)
        self.assertIsNone(json.loads((self.folder / "m.certificate.json").read_text())["outcome"]["delivered"])
        before = self.files()
        for wrong in ("nan", "inf", "-0.5", "much"):
            self.assertEqual(self.run_command(*job[:-1], "n.mesh", "--metric-tolerance", wrong).returncode, 2)
        self.assertEqual(self.files(), before)
        easy = ("mesh", "square", "--metric", "swirl:3", "--size", "0.4", "-o", "e.mesh")
        self.assertEqual(self.run_command(*easy, "--metric-tolerance", "0").returncode, 0)

    def test_the_summary_told_fewer_low_angles_than_the_certificate(self):
        done = self.run_command("mesh", "square", "--size", "0.3", "--max-sites", "80", "--metric-tolerance", "0", "--metric",
                                "expr:sin(4*x)*sin(4*y)<0?100:1;0;sin(4*x)*sin(4*y)<0?1:100", "-o", "m.mesh")
        self.assertEqual(done.returncode, 1)
        low = json.loads((self.folder / "m.certificate.json").read_text())["audit"]["low_triangles"]
        self.assertGreater(len(low), 0)
        self.assertIn(", %d low-angle, " % len(low), done.stdout)

    def test_a_jump_in_size_is_complete_and_told(self):
        done = self.run_command("mesh", "square", "--metric", "expr:x<0.1?100:1;0;x<0.1?100:1",
                                "--size", "1", "-o", "m.mesh")
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertRegex(done.stdout, r"\Acertified: ")
        self.assertRegex(done.stdout, "\ndelivered: ")
        self.assertEqual(self.run_command("verify", "m.mesh").returncode, 0)

    def test_a_mesh_with_a_capital_extension_was_written_and_not_accepted(self):
        self.write("NEEDLE.POLY", b"\xef\xbb\xbf" + NEEDLE.encode())
        self.assertEqual(self.run_command("mesh", "NEEDLE.POLY", "-o", "A.MESH").returncode, 0)
        done = self.run_command("mesh", "A.MESH", "-o", "b.mesh")
        self.assertEqual(done.returncode, 0, done.stderr)
        self.write("c.mesh", b"\xef\xbb\xbf" + (self.folder / "A.MESH").read_bytes())
        self.write("c.sol", b"\xef\xbb\xbf" + (self.folder / "A.sol").read_bytes())
        self.assertEqual(self.run_command("verify", "c.mesh", "--certificate", "A.certificate.json").returncode, 0)
        self.assertEqual(self.run_command("mesh", "A.MESH", "-o", "A.MESH").returncode, 2)

    def test_the_worst_angle_of_no_triangle_was_180_degrees(self):
        self.write("needle.poly", NEEDLE)
        done = self.run_command("mesh", "needle.poly", "-o", "m.mesh")
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertIn("1 triangles, worst angle 87.14 degrees, 1 of 1 triangles exempt at 1 corners, the sharpest 2.86 (bound 20), 0 dis",
                      done.stdout)
        audit = json.loads((self.folder / "m.certificate.json").read_text())["audit"]
        self.assertAlmostEqual(audit["worst_angle"], 87.14, places=2)
        self.assertAlmostEqual(audit["worst_exempt_angle"], 2.86, places=2)
        done = self.run_command("verify", "m.mesh")
        self.assertEqual(done.returncode, 0, done.stdout)
        self.assertIn("worst angle 87.14 degrees, 1 of 1 triangles exempt at 1 corners, the sharpest 2.86", done.stdout)

    def test_the_metric_was_blamed_where_it_is_the_same_everywhere(self):
        for most, reason in ((90, "no mesh was found that meets the demands (the limit of 90 sites was reached), "
                                  "though the metric is the same everywhere"),
                             (120, "not reached: the limit of 120 sites was reached\n")):
            done = self.run_command("mesh", "airfoil", "--max-sites", most, "-o", "m.mesh")
            self.assertEqual(done.returncode, 1)
            self.assertIn(reason, done.stderr)
            self.assertNotIn("cannot agree", done.stderr)

    def test_a_metric_beyond_the_exponents_of_doubles_took_forever(self):
        for spec in ("expr:1e300;0;1e-300", "expr:1e250*(1.1+x);0;1e-250"):
            done = self.run_command("mesh", "square", "--metric", spec, "--metric-tolerance", "0", "--max-seconds", "6",
                                    "-o", "m.mesh", seconds=60)
            self.assertEqual(done.returncode, 1, done.stderr)
            self.assertNotIn("nan", done.stderr)
            self.assertIn("not reached: ", done.stderr)

    def test_a_thin_metric_that_is_the_same_everywhere_was_left_with_disagreeing_triangles(self):
        done = self.run_command("mesh", "square", "--metric", "expr:1e300;0;1e-300", "-o", "m.mesh", seconds=120)
        self.assertEqual(done.returncode, 1, done.stderr)
        self.assertIn(" 0 disagreeing, ", done.stdout)

    def test_a_metric_that_is_the_same_everywhere_was_said_to_vary_too_fast(self):
        for metric in ("expr:1e200;0;1e-200", "expr:1e300;0;1e-300"):
            done = self.run_command("mesh", "square", "--metric", metric, "-o", "m.mesh", seconds=120)
            self.assertEqual(done.returncode, 1, done.stderr)
            self.assertIn(" 0 disagreeing, ", done.stdout)
            self.assertNotIn("varies", done.stderr)
            self.assertNotIn("stars cannot agree", done.stderr)

    def test_darts(self):
        done = self.run_command(*command.JOB[:-1], "10", "--refine", "darts", "-o", "m.mesh")
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertRegex(done.stdout, UNSIZED)

    def test_size(self):
        sites = []
        for size in ("1", "0.25"):
            done = self.run_command("mesh", "square", "--size", size, "-o", "m.mesh")
            self.assertEqual(done.returncode, 0, done.stderr)
            sites.append(int(re.match(r"certified: (\d+) sites", done.stdout)[1]))
        self.assertGreater(sites[1], 4 * sites[0])

    def sections_kept(self, name):
        """Returns vertices, triangles and edges of a mesh, and its metric."""
        text = (self.folder / f"{name}.mesh").read_text()
        listed = text.split("Dimension 2")[1].split("#segments")[0]  # the head may contain the reason
        return listed, (self.folder / f"{name}.sol").read_bytes()

    def test_meshing_a_mesh_again_changes_nothing(self):
        limited = ["--metric", "swirl:3", "--size", "0.01", "--max-sites", "500"]
        # Meshes the first mesh again with the same limit on sites: the second run must not add sites up to the limit
        # once more.
        self.write("boxes.poly", BOXES)
        for first, job, status in (("airfoil", ["--metric", "swirl:12"], 0),
                                   ("boxes.poly", ["--size", "0.05", "--max-sites", "2000"], 1),
                                   ("square", ["--metric", "swirl:3", "--size", "0.2"], 0),
                                   ("square", limited, 1)):
            for domain, mesh in ((first, "a"), ("a.mesh", "b"), ("b.mesh", "c")):
                done = self.run_command("mesh", domain, *job, "-o", f"{mesh}.mesh")
                self.assertEqual(done.returncode, status, done.stderr)
            self.assertEqual(self.sections_kept("a"), self.sections_kept("b"))
            self.assertEqual((self.folder / "b.mesh").read_bytes(), (self.folder / "c.mesh").read_bytes())
            reason = json.loads((self.folder / "b.certificate.json").read_text())["outcome"]["reason"]
            self.assertIn("nothing to add", reason)

    def test_a_mesh_that_is_too_coarse_gets_vertices(self):
        self.make()
        done = self.run_command("mesh", "m.mesh", "--metric", "swirl:3", "--size", "0.2", "-o", "n.mesh")
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertEqual(self.run_command("verify", "n.mesh").returncode, 0)
        old, new = ((self.folder / name).read_text().splitlines() for name in ("m.mesh", "n.mesh"))
        start, count = command.section(old, "Vertices")
        self.assertGreater(command.section(new, "Vertices")[1], count)
        for i in range(start, start + count):
            self.assertEqual(old[i].split()[:2], new[i].split()[:2])

    def test_the_metric_of_another_mesh(self):
        self.make("--size", "0.3")
        done = self.run_command("mesh", "m.mesh", "--metric", "m.mesh", "--size", "1", "-o", "n.mesh")
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertEqual(self.sections_kept("m"), self.sections_kept("n"))
        done = self.run_command("mesh", "square", "--metric", "m.mesh", "--size", "0.5", "-o", "n.mesh")
        self.assertEqual(done.returncode, 0, done.stderr)
        for job, said in ((["m.mesh", "-o", "m.mesh"], "m.mesh: this file would be used twice"),
                          (["square", "--metric", "m.mesh", "-o", "m.mesh"], "used twice"),
                          (["m.mesh", "--regions", "-o", "x.mesh"], "--regions"),
                          (["none.mesh", "-o", "x.mesh"], "none.mesh: no such file"),
                          (["square", "--metric", "none.mesh", "-o", "x.mesh"], "none.mesh")):
            done = self.run_command("mesh", *job)
            self.assertEqual(done.returncode, 2, job)
            self.assertIn(said, done.stderr)
        (self.folder / "m.sol").unlink()
        done = self.run_command("mesh", "square", "--metric", "m.mesh", "-o", "x.mesh")
        self.assertEqual(done.returncode, 2)
        self.assertIn("m.sol", done.stderr)

    def test_a_size_beyond_the_limit_is_told(self):
        done = self.run_command("mesh", "square", "--size", "1e-7", "--max-sites", "2000", "-o", "m.mesh")
        self.assertEqual(done.returncode, 1)
        self.assertRegex(done.stderr, r"limit of 2000 sites was reached: the size wanted takes about "
                                      r"\d\.\d+e\+14; with edges \d\.\d+e\+05 times as long, all stars")
        asked = json.loads((self.folder / "m.certificate.json").read_text())["asked"]["options"]
        self.assertEqual(asked["size"], "1e-07")
        self.assertGreater(float(asked["size-delivered"]), 1e-3)

    def test_what_a_mesh_without_demands_does_not_meet_was_counted_as_none(self):
        for limit in range(87, 140):  # where no coarser mesh is within the tolerance
            done = self.run_command("mesh", "airfoil", "--size", "0.3", "--max-sites", str(limit),
                                    "-o", "m.mesh")
            self.assertEqual(done.returncode, 1)
            if "no demands on angles and sizes" in done.stderr:
                break
        else:
            self.fail("all limits are met by some coarser mesh")
        claim = json.loads((self.folder / "m.certificate.json").read_text())
        low = len(claim["audit"]["low_triangles"])
        self.assertGreater(low, 0)
        self.assertRegex(done.stdout, rf" {low} low-angle, [1-9]\d* too large,")
        self.assertEqual(claim["asked"]["options"]["size-delivered"], "none")

    def test_improve(self):
        job = ["mesh", "square", "--metric", "swirl:12", "--size", "0.2", "-o", "m.mesh"]
        sites, made = [], []
        for more in ([], ["--improve", "4", "--threads", "1"], ["--improve", "4", "--threads", "2"]):
            done = self.run_command(*job, *more)
            self.assertEqual(done.returncode, 0, done.stderr)
            claim = json.loads((self.folder / "m.certificate.json").read_text())
            self.assertTrue(claim["audit"]["certified"])
            sites.append(claim["mesh"]["vertices"])
            made.append((self.folder / "m.mesh").read_bytes())
            if not more:
                self.assertEqual(claim["asked"]["options"]["improve-done"], "none")
                continue
            said = done.stdout.splitlines()[-2]
            self.assertRegex(said, r"\Aimprovement: \d+ passes of \d+ tries, \d+ removed, \d+ moved, "
                                   f"{sites[0]} to {sites[-1]} sites, mean quality 0\\.\\d+ to 0\\.\\d+\\Z")
            self.assertIn(claim["asked"]["options"]["improve-done"], said)
        self.assertLess(sites[1], sites[0])
        self.assertEqual(made[1], made[2])

    def test_passes_that_are_no_number_are_refused(self):
        for bad in ("-1", "1.5", "many", "1001", "nan"):
            done = self.run_command(*command.JOB, "--improve", bad, "-o", "m.mesh")
            self.assertEqual(done.returncode, 2, bad)
            self.assertIn("--improve", done.stderr)
            self.assertEqual(self.files(), [])

    def test_fields_given_by_lengths(self):
        for metric in ("layer:0.05,0.3", "shock:4"):
            done = self.run_command("mesh", "square", "--metric", metric, "--size", "1", "-o", "m.mesh")
            self.assertEqual(done.returncode, 0, metric + done.stderr)
            self.assertRegex(done.stdout, SIZED)

    def test_gradation(self):
        job = ["mesh", "square", "--metric", "swirl:3", "--size", "1", "-o", "m.mesh"]
        done = self.run_command(*job, "--gradation", "1.5")
        self.assertEqual(done.returncode, 0, done.stderr)
        verdict, told, written, end = done.stdout.split("\n")
        self.assertRegex(told, r"\Agradation: [1-9]\d* of \d+ nodes changed, density at most times [1-9]")
        self.assertRegex(f"{verdict}\n{written}\n{end}", SIZED)
        asked = json.loads((self.folder / "m.certificate.json").read_text())["asked"]["options"]
        self.assertEqual(asked["gradation"], "1.5")
        self.assertEqual("gradation: " + asked["gradation-done"], told)
        self.assertEqual(self.run_command("verify", "m.mesh").returncode, 0)

    def background(self):
        """A front on a mesh: the tensors of a fine ring, in back.mesh and back.sol."""
        front = "expr:4+400*exp(-200*(x^2+y^2-0.4)^2)*x^2;400*exp(-200*(x^2+y^2-0.4)^2)*x*y;" \
                "4+400*exp(-200*(x^2+y^2-0.4)^2)*y^2"
        done = self.run_command("mesh", "square", "--metric", front, "--size", "0.5", "-o", "back.mesh")
        self.assertIn(done.returncode, (0, 1), done.stderr)

    def test_vertices_and_complexity_in_place_of_a_size(self):
        self.background()
        for wanted in (400, 1500):
            done = self.run_command("mesh", "square", "--metric", "back.mesh", "--vertices", str(wanted),
                                    "-o", "m.mesh")
            self.assertEqual(done.returncode, 0, done.stderr)
            claim = json.loads((self.folder / "m.certificate.json").read_text())
            asked, made = claim["asked"]["options"], claim["mesh"]["vertices"]
            self.assertEqual(asked["vertices"], str(wanted))
            self.assertLess(abs(made / wanted - 1), 0.05)
            self.assertIn(f"vertices: {wanted} wanted, {made} delivered", done.stdout)
            self.assertEqual(self.run_command("verify", "m.mesh").returncode, 0)
        done = self.run_command("mesh", "square", "--metric", "swirl:3", "--complexity", "200", "-o", "m.mesh")
        self.assertEqual(done.returncode, 0, done.stderr)
        asked = json.loads((self.folder / "m.certificate.json").read_text())["asked"]["options"]
        self.assertEqual(asked["complexity"], "200")
        self.assertLess(abs(float(asked["complexity-delivered"]) / 200 - 1), 0.006)
        self.assertEqual(self.run_command("verify", "m.mesh").returncode, 0)

    def test_what_a_metric_says_outside_of_the_domain_was_counted(self):
        """The domain is a quarter of the square on which the metric is given. Tensors outside
        of the quarter must not count: with them edges are five times too short for the metric of the certificate."""
        self.background()
        self.write("quarter.poly", "4 2 0 0\n1 -1 -1\n2 0 -1\n3 0 0\n4 -1 0\n"
                   "4 1\n1 1 2 1\n2 2 3 1\n3 3 4 1\n4 4 1 1\n0\n")
        for name, words in {"count": ["--vertices", "1500"], "complexity": ["--complexity", "1300"]}.items():
            with self.subTest(name):
                done = self.run_command("mesh", "quarter.poly", "--metric", "back.mesh", *words, "-o", "m.mesh")
                self.assertEqual(done.returncode, 0, done.stderr)
                claim = json.loads((self.folder / "m.certificate.json").read_text())
                self.assertLess(abs(claim["mesh"]["vertices"] / 1500 - 1), 0.25)
                share = float(re.search(r"([\d.]+)% unit edges", done.stdout)[1])
                self.assertGreater(share, 95)

    def test_edges_far_from_the_length_asked_for_are_told_with_their_own(self):
        """For a size far larger than the domain the summary names the mean length. The share of unit edges
        alone, "0.00%", says too little, as no coarser mesh exists."""
        done = self.run_command("mesh", "square", "--size", "1e9", "-o", "m.mesh")
        self.assertEqual(done.returncode, 0, done.stderr)
        # The mesh has four edges of length 2 and a diagonal.
        mean = (4 * 2 + math.sqrt(8)) / 5 / 1e9
        self.assertIn(f", 0.00% unit edges (mean length in the metric {mean:.3g}, not 1)\n", done.stdout)
        done = self.run_command("mesh", "square", "--size", "0.5", "-o", "m.mesh")
        self.assertRegex(done.stdout, SIZED)

    def test_a_metric_was_carried_on_beyond_its_mesh_without_a_word(self):
        self.background()
        self.write("wide.poly", "4 2 0 0\n1 -1 -1\n2 1.5 -1\n3 1.5 1\n4 -1 1\n"
                   "4 1\n1 1 2 1\n2 2 3 1\n3 3 4 1\n4 4 1 1\n0\n")
        words = ["mesh", "wide.poly", "--metric", "back.mesh", "--size", "2", "-o", "m.mesh"]
        done = self.run_command(*words)
        self.assertIn("has 80 % of the domain's area, and not the vertex at (1.5, -1)", done.stderr)
        done = self.run_command(*words, "--strict")
        self.assertEqual(done.returncode, 2)
        self.assertNotIn("note", self.run_command("mesh", "square", *words[2:]).stderr)

    def test_a_count_was_missed_by_a_sixth_in_one_metric_for_all(self):
        done = self.run_command("mesh", "airfoil", "--metric", "layer:0.01,0.2", "--vertices", "2500", "-o", "m.mesh")
        self.assertEqual(done.returncode, 0, done.stderr)
        claim = json.loads((self.folder / "m.certificate.json").read_text())
        self.assertLessEqual(abs(claim["mesh"]["vertices"] / 2500 - 1), 0.05)
        self.assertGreater(claim["outcome"]["delivered"]["length_factor"], 1.05)
        self.assertEqual(self.run_command("verify", "m.mesh").returncode, 0)

    def spikes(self, count, inner):
        """Writes a star with `count` spikes to spikes.poly."""
        points = []
        for i in range(2 * count):
            radius, angle = (inner if i % 2 else 1.0), math.pi * i / count
            points.append((radius * math.cos(angle), radius * math.sin(angle)))
        ends = [(i, (i + 1) % len(points)) for i in range(len(points))]
        lines = [f"{len(points)} 2 0 0", *(f"{i + 1} {x!r} {y!r}" for i, (x, y) in enumerate(points)),
                 f"{len(ends)} 0", *(f"{i + 1} {a + 1} {b + 1}" for i, (a, b) in enumerate(ends)), "0", ""]
        (self.folder / "spikes.poly").write_text("\n".join(lines))

    def test_a_count_was_missed_by_a_fifth_where_a_boundary_takes_many_vertices(self):
        self.spikes(50, 0.8)
        done = self.run_command("mesh", "spikes.poly", "--metric", "swirl:12", "--vertices", "300", "-o", "m.mesh")
        self.assertEqual(done.returncode, 0, done.stderr)
        claim = json.loads((self.folder / "m.certificate.json").read_text())
        self.assertLessEqual(abs(claim["mesh"]["vertices"] / 300 - 1), 0.05)
        self.assertNotIn("none nearer", done.stdout)
        self.assertEqual(self.run_command("verify", "m.mesh").returncode, 0)

    def test_a_count_that_no_mesh_was_found_with_is_said_to_be_missed(self):
        self.spikes(50, 0.8)
        done = self.run_command("mesh", "spikes.poly", "--metric", "layer", "--vertices", "110", "-o", "m.mesh")
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertRegex(done.stdout, r"vertices: 110 wanted, \d+ delivered \(\S+ %: none nearer to that were found\)")
        self.assertEqual(self.run_command("verify", "m.mesh").returncode, 0)

    def test_a_metric_on_a_mesh_is_graded_at_its_vertices_and_scaled_by_turns(self):
        self.background()
        done = self.run_command("mesh", "square", "--metric", "back.mesh", "--vertices", "800",
                                "--gradation", "1.3", "-o", "m.mesh")
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertRegex(done.stdout, r"\ngradation: \d+ of \d+ nodes changed, density at most times \S+, \d+ sweeps\n")
        claim = json.loads((self.folder / "m.certificate.json").read_text())
        self.assertLess(abs(claim["mesh"]["vertices"] / 800 - 1), 0.05)
        done = self.run_command("verify", "m.mesh")
        self.assertEqual(done.returncode, 0, done.stdout)
        self.assertIn("metric: back.mesh, by the certificate, compared at every vertex", done.stdout)

    def test_a_number_of_vertices_is_no_reason_to_meet_the_default_limit(self):
        done = self.run_command("mesh", "square", "--vertices", "200000", "--max-seconds", "0.01", "-o", "m.mesh")
        self.assertEqual(done.returncode, 1, done.stderr)
        self.assertNotIn("--max-sites", done.stderr)

    def test_numbers_of_vertices_that_cannot_be_meant(self):
        for words, said in ((["--vertices", "3"], "the domain has 4 already"),
                            (["--vertices", "200", "--max-sites", "100"], "more than --max-sites 100"),
                            (["--vertices", "200", "--size", "1"], "excludes"),
                            (["--vertices", "200", "--complexity", "9"], "excludes"),
                            (["--complexity", "0"], "must be positive")):
            done = self.run_command("mesh", "square", *words, "-o", "m.mesh")
            self.assertEqual(done.returncode, 2, words)
            self.assertIn(said, done.stderr)
            self.assertEqual(self.files(), [])

    def test_gradation_of_what_is_graded_changes_nothing(self):
        seen = []
        for more in ([], ["--gradation", "100"]):
            self.make(*more)
            seen.append([(self.folder / name).read_bytes() for name in ("m.mesh", "m.sol")])
        self.assertEqual(seen[0], seen[1])

    def test_the_voronoi_diagram_is_proved_or_refused(self):
        def make(status, *more):
            done = self.run_command("mesh", "square", "--certify", "voronoi", "-o", "m.mesh", *more)
            self.assertEqual(done.returncode, status, done.stdout + done.stderr)
            audit = json.loads((self.folder / "m.certificate.json").read_text())["audit"]
            return done, audit
        done, audit = make(0, "--metric", "swirl:12", "--size", "0.3")
        self.assertIn("dual of the Voronoi diagram: proved", done.stdout)
        self.assertEqual((audit["certified"], audit["voronoi"]), (True, "proved"))
        self.assertIn("dual of the Voronoi diagram: proved",
                      self.run_command("verify", "m.mesh").stdout)
        # The mesh is too coarse for the metric: stars agree, and arcs leave their wedges.
        done, audit = make(1, "--metric", "swirl:24")
        self.assertEqual((audit["certified"], audit["voronoi"]), (True, "refused"))
        self.assertRegex(done.stderr, r"not proved to be the dual.*: triangle \d+ of vertex")
        self.assertEqual(self.run_command("verify", "m.mesh").returncode, 0)
        self.assertEqual(self.run_command("verify", "m.mesh", "--voronoi").returncode, 1)
        self.assertEqual(self.run_command("mesh", "square", "--certify", "all", "-o",
                                          "x.mesh").returncode, 2)

    def test_progress_needs_a_terminal(self):
        self.assertNotIn("\r", self.make().stderr)

    def test_draw(self):
        self.make()
        for picture, head in (("d.svg", b"<?xml"), ("d.png", b"\x89PNG"), ("d.pdf", b"%PDF")):
            done = self.run_command("draw", "m.mesh", "-o", picture, "--ellipses", "--width", "300")
            self.assertEqual((done.returncode, done.stderr), (0, ""))
            self.assertRegex(done.stdout, rf"\Awritten in \d+\.\d\d seconds: {picture}\n\Z")
            self.assertTrue((self.folder / picture).read_bytes().startswith(head))
        (self.folder / "m.sol").unlink()
        self.assertEqual(self.run_command("draw", "m.mesh", "-o", "e.svg").returncode, 0)
        self.assertEqual(self.run_command("draw", "m.mesh", "-o", "f.svg", "--ellipses").returncode, 2)
        self.assertNotIn("f.svg", self.files())

    def test_without_cairo_all_but_pictures_is_made(self):
        self.make("-o", "there.mesh")
        self.write("libcairo.so.2", "")  # the loader finds this one first
        without = {"LD_LIBRARY_PATH": str(self.folder)}
        done = self.run_command(*command.JOB, "-o", "again.mesh", "-o", "again.html", environment=without)
        self.assertEqual(done.returncode, 0, done.stderr)
        before = self.files()
        for job in ([*command.JOB, "-o", "n.mesh", "-o", "n.svg"], ["draw", "there.mesh", "-o", "n.png"]):
            done = self.run_command(*job, environment=without)
            self.assertEqual(done.returncode, 2, done.stdout)
            self.assertRegex(done.stderr, r"\Aasterism: n\.(svg|png): cairo, which draws pictures, is missing: .*libcairo")
        self.assertEqual(self.files(), before)


if __name__ == "__main__":
    unittest.main()
