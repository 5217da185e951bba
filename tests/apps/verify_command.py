# SPDX-License-Identifier: MIT
"""Alters meshes and certificates, and checks through the real command what `verify` finds in them."""
import unittest

import command


class Verify(command.CommandTest):
    def setUp(self):
        super().setUp()
        done = self.run_command(*command.JOB, "-o", "m.mesh")
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
        """Replaces lines `entry` of a section by what `change` makes of their words."""
        lines = self.mesh.splitlines()
        start, count = command.section(lines, keyword)
        new = change(lines[start + entry].split())
        lines[start + entry:start + entry + 1] = [" ".join(map(str, words)) for words in new]
        lines[start - 1] = str(count + len(new) - 1)
        return "\n".join(lines) + "\n"

    def spoiled(self):
        """The change, the mesh, and the pattern of the witness."""
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

    def test_sites_near_a_line_in_one_metric_are_verified_as_well(self):
        """Each site sees thousands of others. Testing all stars against all sites would exceed the limit on work."""
        many = 3000
        lines = [f"{many + 4} 2 0 0", "1 -1 -1", "2 1 -1", "3 1 1", "4 -1 1"]
        lines += [f"{i + 5} {-0.9 + 1.8 * i / many!r} {0.25 + 1e-9 * (i * i % 101) / 101!r}" for i in range(many)]
        self.write("line.poly", "\n".join([*lines, "4 0", "1 1 2", "2 2 3", "3 3 4", "4 4 1", "0", ""]))
        done = self.run_command("mesh", "line.poly", "--metric", "identity", "--angle-bound", "0", "-o", "line.mesh")
        self.assertEqual(done.returncode, 0, done.stderr)
        done = self.run_command("verify", "line.mesh")
        self.assertEqual(done.returncode, 0, done.stdout + done.stderr)

    def test_an_audit_that_does_not_end_contradicts_nothing(self):
        done = self.verdict("--max-seconds", "1e-9")
        self.assertEqual(done.returncode, 1)
        self.assertIn("not looked at to its end", done.stdout)
        self.assertNotIn("false of this mesh", done.stdout)

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
