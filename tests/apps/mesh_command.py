# SPDX-License-Identifier: MIT
"""The main job through the real command: files, certificate, exit statuses; and what verify finds
in meshes that were altered."""
import json
import signal
import subprocess
import time
import unittest

import command

JOB = ["mesh", "square", "--random-points", "10", "--metric", "swirl:3", "--angle-bound", "20"]
SUMMARY = (r"\A\d+ sites, \d+ triangles, worst angle \d+\.\d\d degrees, 0 disagreeing, 0 low-angle"
           r"{}: certified\n\Z")
UNSIZED = SUMMARY.format("")
SIZED = SUMMARY.format(r", \d+\.\d\d% unit edges")


def section(lines, keyword):
    """Where the entries of a Medit section start, and how many there are."""
    at = lines.index(keyword)
    return at + 2, int(lines[at + 1])


# A square with a smaller one at each of two sides.
BOXES = """12 2 0 0
1 0 0\n2 4 0\n3 4 4\n4 0 4\n5 4 1\n6 8 1\n7 8 3\n8 4 3\n9 1 4\n10 3 4\n11 3 6\n12 1 6
12 0
1 1 2\n2 2 3\n3 3 4\n4 4 1\n5 5 6\n6 6 7\n7 7 8\n8 8 5\n9 9 10\n10 10 11\n11 11 12\n12 12 9
0
"""


# One triangle, exempt at its sharp corner.
NEEDLE = "3 2 0 0\n1 0 0\n2 10 0\n3 10 0.5\n3 0\n1 1 2\n2 2 3\n3 3 1\n0\n"


class Mesh(command.CommandTest):
    def make(self, *more):
        done = self.run_command(*JOB, "-o", "m.mesh", *more)
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
        start, count = section(lines, "RequiredVertices")
        self.assertEqual(lines[start:start + count], [str(v + 1) for v in range(14)])

    def test_a_metric_at_the_vertices_of_a_mesh(self):
        """Made by local changes; how far the metric is from the one wanted is said, written down
        and measured again, until the file with the one wanted changes."""
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
            head = (self.folder / name).read_text().splitlines()[1]
            self.assertRegex(head, "Incomplete, not certified: .*40", name)
        self.assertEqual(self.run_command("verify", "m.mesh", "--certificate", "c.json").returncode, 1)

    def test_a_metric_in_which_stars_cannot_agree(self):
        turning = "expr:sin(6*x)*sin(6*y)>0?100:4;0;sin(6*x)*sin(6*y)>0?4:100"
        job = ["mesh", "square", "--metric", turning, "--size", "1", "-o", "m.mesh", "-o", "m.svg"]
        done = self.run_command(*job)
        self.assertEqual(done.returncode, 1)
        self.assertRegex(done.stdout, ", 0 disagreeing, .*: certified in a relaxed metric, NOT complete\n")
        self.assertRegex(done.stderr, r"\Aasterism: not reached: stars cannot agree in the metric given .*"
                         r"one at \(\S+, \S+\).*; they agree in the metric graded with 1.5 .*"
                         r"as the metric given measures them \d+ triangles are below 20 degrees")
        claim = json.loads((self.folder / "m.certificate.json").read_text())
        self.assertTrue(claim["audit"]["certified"])
        self.assertEqual(claim["audit"]["low_triangles"], [])
        relaxed = claim["outcome"]["relaxed"]
        self.assertEqual(relaxed["kind"], "graded")
        low = relaxed["low_triangles_as_given"]
        self.assertGreater(len(low), 0)
        self.assertEqual(low, sorted(set(low)))
        self.assertLess(relaxed["worst_angle_as_given"], 20)
        self.assertLessEqual(low[-1], claim["mesh"]["triangles"])
        self.assertRegex((self.folder / "m.svg").read_text().splitlines()[1],
                         "Incomplete, certified in a relaxed metric: %d triangles are below 20" % len(low))
        # A certificate that hid its low triangles was believed.
        hidden = json.loads((self.folder / "m.certificate.json").read_text())
        hidden["outcome"]["complete"] = True
        hidden["outcome"]["relaxed"]["low_triangles_as_given"] = []
        (self.folder / "hidden.json").write_text(json.dumps(hidden))
        done = self.run_command("verify", "m.mesh", "--certificate", "hidden.json")
        self.assertEqual(done.returncode, 1)
        self.assertRegex(done.stdout, "%d triangles are below the bound, and the certificate lists 0; " % len(low))
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

        done = self.run_command(*job, "--no-relaxation")
        self.assertEqual(done.returncode, 1)
        self.assertRegex(done.stdout, ", [1-9]\\d* disagreeing, .*: NOT certified, incomplete\n")
        claim = json.loads((self.folder / "m.certificate.json").read_text())
        self.assertIsNone(claim["outcome"]["relaxed"])
        self.assertEqual(claim["asked"]["options"]["relax"], "no")

    def test_the_summary_told_fewer_low_angles_than_the_certificate(self):
        done = self.run_command("mesh", "square", "--size", "0.3", "--max-sites", "80", "--no-relaxation", "--metric",
                                "expr:sin(4*x)*sin(4*y)<0?100:1;0;sin(4*x)*sin(4*y)<0?1:100", "-o", "m.mesh")
        self.assertEqual(done.returncode, 1)
        low = json.loads((self.folder / "m.certificate.json").read_text())["audit"]["low_triangles"]
        self.assertGreater(len(low), 0)
        self.assertIn(", %d low-angle, " % len(low), done.stdout)

    def test_a_jump_in_size_is_complete_and_told(self):
        done = self.run_command("mesh", "square", "--metric", "expr:x<0.1?100:1;0;x<0.1?100:1",
                                "--size", "1", "-o", "m.mesh")
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertRegex(done.stdout, r"\Arelaxed: stars cannot agree in the metric given .*"
                         "measures them 0 triangles are below 20 degrees")
        self.assertRegex(done.stdout, ": certified in a relaxed metric\n\\Z")
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
        self.assertIn("1 triangles, worst angle 87.14 degrees, 1 exempt at 1 corners, the sharpest 2.86, 0 dis",
                      done.stdout)
        audit = json.loads((self.folder / "m.certificate.json").read_text())["audit"]
        self.assertAlmostEqual(audit["worst_angle"], 87.14, places=2)
        self.assertAlmostEqual(audit["worst_exempt_angle"], 2.86, places=2)
        done = self.run_command("verify", "m.mesh")
        self.assertEqual(done.returncode, 0, done.stdout)
        self.assertIn("worst angle 87.14 degrees, 1 exempt at 1 corners, the sharpest 2.86", done.stdout)

    def test_the_metric_was_blamed_where_it_is_the_same_everywhere(self):
        done = self.run_command("mesh", "airfoil", "--max-sites", "120", "-o", "m.mesh")
        self.assertEqual(done.returncode, 1)
        self.assertIn("no mesh was found that meets the demands (the limit of 120 sites was reached), though the "
                      "metric is the same everywhere", done.stderr)
        self.assertNotIn("cannot agree", done.stderr)

    def test_a_metric_beyond_the_exponents_of_doubles_took_forever(self):
        for spec in ("expr:1e300;0;1e-300", "expr:1e250*(1.1+x);0;1e-250"):
            done = self.run_command("mesh", "square", "--metric", spec, "--no-relaxation", "-o", "m.mesh", seconds=60)
            self.assertEqual(done.returncode, 1, done.stderr)
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
        done = self.run_command(*JOB[:-1], "10", "--refine", "darts", "-o", "m.mesh")
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertRegex(done.stdout, UNSIZED)

    def test_size(self):
        sites = []
        for size in ("1", "0.25"):
            done = self.run_command("mesh", "square", "--size", size, "-o", "m.mesh")
            self.assertEqual(done.returncode, 0, done.stderr)
            sites.append(int(done.stdout.split()[0]))
        self.assertGreater(sites[1], 4 * sites[0])

    def sections_kept(self, name):
        """Vertices, triangles and edges of a mesh, and its metric."""
        text = (self.folder / f"{name}.mesh").read_text()
        listed = text.split("Dimension 2")[1].split("#segments")[0]  # the head may hold the reason
        return listed, (self.folder / f"{name}.sol").read_bytes()

    def test_meshing_a_mesh_again_changes_nothing(self):
        limited = ["--metric", "swirl:3", "--size", "0.01", "--max-sites", "500"]
        # Twice as many sites as in the mesh made first would be within the limit: they were added.
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
        start, count = section(old, "Vertices")
        self.assertGreater(section(new, "Vertices")[1], count)
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
        done = self.run_command("mesh", "airfoil", "--size", "0.3", "--max-sites", "120", "-o", "m.mesh")
        self.assertEqual(done.returncode, 1)
        self.assertIn("no demands on angles and sizes", done.stderr)
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
            said = done.stdout.splitlines()[0]
            self.assertRegex(said, r"\Aimprovement: \d+ passes of \d+ tries, \d+ removed, \d+ moved, "
                                   f"{sites[0]} to {sites[-1]} sites, mean quality 0\\.\\d+ to 0\\.\\d+\\Z")
            self.assertIn(claim["asked"]["options"]["improve-done"], said)
        self.assertLess(sites[1], sites[0])
        self.assertEqual(made[1], made[2])

    def test_passes_that_are_no_number_are_refused(self):
        for bad in ("-1", "1.5", "many", "1001", "nan"):
            done = self.run_command(*JOB, "--improve", bad, "-o", "m.mesh")
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
        told, summary = done.stdout.splitlines(keepends=True)
        self.assertRegex(told, r"\Agradation: [1-9]\d* of \d+ nodes changed, density at most times [1-9]")
        self.assertRegex(summary, SIZED)
        asked = json.loads((self.folder / "m.certificate.json").read_text())["asked"]["options"]
        self.assertEqual(asked["gradation"], "1.5")
        self.assertEqual("gradation: " + asked["gradation-done"] + "\n", told)
        self.assertEqual(self.run_command("verify", "m.mesh").returncode, 0)

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
        # Too coarse for the metric: the stars agree, and arcs leave their wedges.
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
            self.assertEqual((done.returncode, done.stdout, done.stderr), (0, "", ""))
            self.assertTrue((self.folder / picture).read_bytes().startswith(head))
        (self.folder / "m.sol").unlink()
        self.assertEqual(self.run_command("draw", "m.mesh", "-o", "e.svg").returncode, 0)
        self.assertEqual(self.run_command("draw", "m.mesh", "-o", "f.svg", "--ellipses").returncode, 2)
        self.assertNotIn("f.svg", self.files())


class Limits(command.CommandTest):
    LONG = ["mesh", "square", "--metric", "swirl:24", "--size", "0.004", "--max-sites", "5000000", "-o", "m.mesh"]

    def check_partial(self, returncode, stderr, reason):
        self.assertEqual(returncode, 1, stderr)
        self.assertIn(f"not reached: stopped: {reason}", stderr)
        self.assertEqual(self.files(), ["m.certificate.json", "m.mesh", "m.sol"])
        self.assertIn(reason, json.loads((self.folder / "m.certificate.json").read_text())["outcome"]["reason"])
        self.assertIn(f"# Incomplete, not certified: stopped: {reason}", (self.folder / "m.mesh").read_text())

    def test_seconds(self):
        done = self.run_command(*self.LONG, "--max-seconds", "0.5")
        self.check_partial(done.returncode, done.stderr, "0.5 seconds have passed")

    def test_memory(self):
        done = self.run_command(*self.LONG, "--max-memory", "30")
        self.check_partial(done.returncode, done.stderr, "more than 30 megabytes are in use")

    def test_interrupt(self):
        with subprocess.Popen([command.PROGRAM, *self.LONG], cwd=self.folder, stdout=subprocess.PIPE,
                              stderr=subprocess.PIPE) as run:
            time.sleep(0.5)
            run.send_signal(signal.SIGINT)
            _, told = run.communicate(timeout=240)
        self.check_partial(run.returncode, told.decode(), "interrupted")

    def test_an_interrupt_between_two_files_does_not_lose_the_second(self):
        names = ["m.certificate.json", "m.mesh", "m.pdf", "m.png", "m.sol", "m.svg", "m.vtu"]
        outputs = [word for name in names if name[2:] not in ("certificate.json", "sol") for word in ("-o", name)]
        with subprocess.Popen([command.PROGRAM, "mesh", "square", "--size", "0.03", *outputs], cwd=self.folder,
                              stdout=subprocess.PIPE, stderr=subprocess.PIPE) as run:
            while run.poll() is None and not any(name.endswith(".part") for name in self.files()):
                time.sleep(0.001)
            run.send_signal(signal.SIGINT)
            _, told = run.communicate(timeout=240)
        self.assertEqual(run.returncode, 0, told.decode())
        self.assertEqual(self.files(), names)

    def test_threads_change_nothing(self):
        made = []
        for threads in ("1", "3"):
            done = self.run_command("mesh", "square", "--metric", "swirl:12", "--size", "0.05", "--threads", threads,
                                    "-o", "m.mesh")
            self.assertEqual(done.returncode, 0, done.stderr)
            made.append([(self.folder / name).read_bytes() for name in ("m.mesh", "m.sol")])
        self.assertEqual(made[0], made[1])

    def test_what_is_no_limit_is_refused(self):
        for bad in (["--threads", "0"], ["--max-seconds", "-1"], ["--max-memory", "nan"], ["--max-seconds", "soon"]):
            done = self.run_command(*JOB, *bad, "-o", "m.mesh")
            self.assertEqual(done.returncode, 2, bad)
            self.assertIn(bad[0], done.stderr)
            self.assertEqual(self.files(), [])


class Verify(command.CommandTest):
    def setUp(self):
        super().setUp()
        done = self.run_command(*JOB, "-o", "m.mesh")
        self.assertEqual(done.returncode, 0, done.stderr)
        self.mesh = (self.folder / "m.mesh").read_text()
        self.metric = (self.folder / "m.sol").read_text()

    def verdict(self, *more, mesh=None, metric=None):
        self.write("m.mesh", mesh or self.mesh)
        self.write("m.sol", metric or self.metric)
        return self.run_command("verify", "m.mesh", *more)

    def forget_certificate(self):
        (self.folder / "m.certificate.json").unlink()

    def altered(self, keyword, entry, change):
        """The mesh with lines `entry` of a section replaced by what `change` makes of its words."""
        lines = self.mesh.splitlines()
        start, count = section(lines, keyword)
        new = change(lines[start + entry].split())
        lines[start + entry:start + entry + 1] = [" ".join(map(str, words)) for words in new]
        lines[start - 1] = str(count + len(new) - 1)
        return "\n".join(lines) + "\n"

    def spoiled(self):
        """What was done, the mesh, and what the witness must match."""
        yield ("one index altered",
               self.altered("Triangles", 5, lambda w: [[1 if w[0] != "1" else 2, *w[1:]]]),
               r"triangle")
        yield "one triangle removed", self.altered("Triangles", 5, lambda w: []), r"edge|boundary"
        yield "one triangle doubled", self.altered("Triangles", 5, lambda w: [w, w]), r"triangle 6"
        yield ("one triangle turned over",
               self.altered("Triangles", 5, lambda w: [[w[1], w[0], *w[2:]]]), r"triangle 6")
        yield ("one vertex moved across an edge",
               self.altered("Vertices", 20, lambda w: [["0.999", "0.001", w[2]]]), r"triangle")
        yield "one vertex moved far away", self.altered("Vertices", 0, lambda w: [[5, 5, w[2]]]), r"."
        yield "one boundary piece removed", self.altered("Edges", 3, lambda w: []), r"edge|boundary"

    def test_certified(self):
        for more in ([], ["--domain", "square"], ["--angle-bound", "5"]):
            done = self.verdict(*more)
            self.assertEqual(done.returncode, 0, done.stdout + done.stderr)
            self.assertRegex(done.stdout, r"\Acertified: ")
        self.forget_certificate()
        for more in (["--angle-bound", "20"], ["--domain", "square", "--angle-bound", "20"]):
            self.assertEqual(self.verdict(*more).returncode, 0)
        done = self.verdict()
        self.assertEqual(done.returncode, 1)
        self.assertRegex(done.stdout, r"\Ano bound asked for: not certified: ")

    def test_bound_and_domain_are_checked(self):
        for more in (["--angle-bound", "50"], ["--domain", "airfoil"]):
            done = self.verdict(*more)
            self.assertEqual(done.returncode, 1)
            self.assertRegex(done.stdout, "REFUSED")

    def test_altered_meshes_are_refused_with_a_witness(self):
        for keep_certificate in (True, False):
            if not keep_certificate:
                self.forget_certificate()
            for what, mesh, witness in self.spoiled():
                with self.subTest(what, certificate=keep_certificate):
                    done = self.verdict(mesh=mesh)
                    self.assertEqual(done.returncode, 1, done.stdout + done.stderr)
                    self.assertRegex(done.stdout, witness)
                    self.assertRegex(done.stdout, "REFUSED")

    def test_an_indefinite_metric_is_refused_with_a_witness(self):
        lines = self.metric.splitlines()
        at = lines.index("1 3") + 8  # vertex 8
        lines[at] = "1 2 1"
        done = self.verdict(metric="\n".join(lines) + "\n")
        self.assertEqual(done.returncode, 2)
        self.assertRegex(done.stderr, r":%d: .*vertex 8 is not positive definite" % (at + 1))

    def test_the_last_bit_of_a_coordinate_contradicts_the_certificate(self):
        changed = self.altered("Vertices", 20, lambda w: [[w[0] + "1", w[1], w[2]]])
        if self.verdict(mesh=changed).returncode == 0:  # the same double
            changed = self.altered("Vertices", 20, lambda w: [[float(w[0]) * (1 + 1e-15), *w[1:]]])
        done = self.verdict(mesh=changed)
        self.assertEqual(done.returncode, 1)
        self.assertRegex(done.stdout, "certificate: ")

    def test_damaged_files_are_refused_as_input(self):
        for mesh, metric in ((self.mesh[:200], None), (None, self.metric[:200]),
                             (self.mesh.replace("Triangles", "Hexagons"), None)):
            done = self.verdict(mesh=mesh, metric=metric)
            self.assertEqual((done.returncode, done.stdout), (2, ""))
            self.assertRegex(done.stderr, r"\Aasterism: m\.(mesh|sol)")
        self.write("m.certificate.json", "{")
        done = self.verdict()
        self.assertEqual(done.returncode, 2)
        self.assertRegex(done.stderr, r"m\.certificate\.json")


if __name__ == "__main__":
    unittest.main()
