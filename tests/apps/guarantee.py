# SPDX-License-Identifier: MIT
"""mesh --guarantee through the real command: kept, refused beforehand by name, not reached; and what verify
makes of the certificate."""
import json
import unittest

import command

SHARP = "3 2\n1 0 0\n2 4 0\n3 4 1\n3 0\n1 1 2\n2 2 3\n3 3 1\n0\n"
PLATE = "4 2\n1 0 0\n2 3 0\n3 3 2\n4 0 2\n4 0\n1 1 2\n2 2 3\n3 3 4\n4 4 1\n0\n"


class Guarantee(command.CommandTest):
    def mesh(self, *options, status=0):
        done = self.run_command("mesh", *options, "--guarantee", "-o", "g.mesh")
        self.assertEqual(done.returncode, status, done.stdout + done.stderr)
        return done

    def claim(self):
        return json.loads((self.folder / "g.certificate.json").read_text())

    def test_is_kept_and_proved_again(self):
        self.write("plate.poly", PLATE)
        for metric, size in (("identity", "0.3"), ("layer:0.3,1", "0.5"), ("expr:1+x*x/9;0;1", "0.4")):
            with self.subTest(metric):
                done = self.mesh("plate.poly", "--metric", metric, "--size", size)
                self.assertIn("guarantee: edges ", done.stdout)
                claim = self.claim()
                self.assertEqual(claim["asked"]["options"]["guarantee"], "asked")
                kept = claim["guarantee"]
                self.assertEqual(kept["sigma"], claim["theorem"]["variation"])
                self.assertEqual(kept["eps"], claim["theorem"]["covering_radius"])
                self.assertLessEqual(kept["eps"] * kept["size_factor"], 0.75001)
                again = self.run_command("verify", "g.mesh", "--domain", "plate.poly", "--metric", metric,
                                         "--size", size)
                self.assertEqual(again.returncode, 0, again.stdout + again.stderr)
                self.assertIn("; guaranteed: edges ", again.stdout)

    def test_another_bound_is_asked_of_the_mesh_and_not_of_its_guarantee(self):
        self.write("plate.poly", PLATE)
        self.mesh("plate.poly", "--metric", "sink:1", "--size", "0.4")
        for bound in ("10", "25"):
            done = self.run_command("verify", "g.mesh", "--angle-bound", bound)
            self.assertEqual(done.returncode, 0, done.stdout + done.stderr)

    def test_without_a_size_it_is_1(self):
        self.write("plate.poly", PLATE)
        self.mesh("plate.poly", "--metric", "expr:30;0;30")
        self.assertEqual(self.claim()["asked"]["options"]["size"], "1")

    def test_a_forged_guarantee_is_refused(self):
        self.write("plate.poly", PLATE)
        self.mesh("plate.poly", "--size", "0.4")
        good = self.claim()
        for change in ({"sigma": 1}, {"eps": 0.01}, {"size_factor": 4}, {"size_factor": 1 + 2 ** -52}, {"times_least": 1}):
            with self.subTest(change):
                claim = {**good, "guarantee": {**good["guarantee"], **change}}
                self.write("g.certificate.json", json.dumps(claim))
                done = self.run_command("verify", "g.mesh")
                self.assertEqual(done.returncode, 1, done.stdout + done.stderr)
                self.assertIn('"guarantee.', done.stdout + done.stderr)
                other = self.run_command("verify", "g.mesh", "--angle-bound", "10")
                self.assertEqual(other.returncode, 1, "of another bound: " + other.stdout)
        without = {key: value for key, value in good.items() if key != "guarantee"}
        self.write("g.certificate.json", json.dumps(without))
        self.assertEqual(self.run_command("verify", "g.mesh").returncode, 1)

    def test_a_field_is_bounded_or_said_to_be_sampled(self):
        self.write("plate.poly", PLATE)
        done = self.mesh("plate.poly", "--metric", "sink:1", "--size", "0.4")
        self.assertIn("; the field varies by at most ", done.stdout)
        good = self.claim()
        kept = good["guarantee"]
        self.assertEqual(kept["field"], "bounded")
        self.assertLessEqual(kept["field_variation"], kept["field_variation_bound"])
        self.assertLessEqual(kept["sigma"], kept["field_variation_bound"] * 1.000001)
        for bound in (kept["field_variation_bound"] * 0.99, kept["field_variation_bound"] * 1.01, 0, 1e9):
            claim = {**good, "guarantee": {**kept, "field_variation_bound": bound}}
            self.write("g.certificate.json", json.dumps(claim))
            done = self.run_command("verify", "g.mesh")
            self.assertEqual(done.returncode, 1, done.stdout + done.stderr)
            self.assertIn('"guarantee.field_variation_bound" is ', done.stdout + done.stderr)
        claim = {**good, "guarantee": {**kept, "field": "sampled"}}
        self.write("g.certificate.json", json.dumps(claim))
        self.assertNotEqual(self.run_command("verify", "g.mesh").returncode, 0)
        done = self.mesh("plate.poly", "--metric", "expr:2+rint(0.1*x);0;2", "--size", "0.6")
        self.assertIn("; the field was sampled, and is not known between the samples", done.stdout)
        kept = self.claim()["guarantee"]
        self.assertEqual((kept["field"], kept["field_variation_bound"]), ("sampled", None))

    def test_what_fails_is_named_beforehand(self):
        self.write("sharp.poly", SHARP)
        for options, words in ((("sharp.poly", "--size", "0.3"), "sharp.poly: no guarantee: the corner at vertex 1"),
                               (("square", "--metric", "expr:x<0?1:25;0;1", "--size", "0.3"), "no jump is allowed"),
                               (("square", "--size", "0.3", "--angle-bound", "25"), "at most 20 degrees")):
            with self.subTest(words):
                done = self.mesh(*options, status=2)
                self.assertIn(words, done.stderr)
                self.assertFalse((self.folder / "g.mesh").exists())

    def test_not_reached_says_how_far_it_came(self):
        done = self.mesh("square", "--metric", "sink:12", "--size", "0.4", "--max-sites", "300", status=1)
        self.assertIn("not reached: no guarantee: with edges ", done.stderr)
        self.assertIn("try --max-sites 1200, or --gradation 1.1", done.stderr)
        self.assertNotIn("guarantee", {**self.claim(), "asked": None})

    def test_what_does_not_go_with_it_is_refused(self):
        for other in (("--vertices", "100"), ("--refine", "darts"), ("--improve", "1"), ("--tol", "0.1")):
            self.assertEqual(self.mesh("square", *other, status=2).returncode, 2)


if __name__ == "__main__":
    unittest.main()
