# SPDX-License-Identifier: MIT
"""Tests what reaches a terminal: names of files and parts of them hold no character that it obeys and break no
line, long words are cut in their middle, and numbers have the digits that are read. JSON has all of it."""
import json
import math
import re
import subprocess
import unittest

import command

PART = "4 2 0 0\n1 0 0\n2 2 0\n3 2 1\n4 0 1\n4 1\n1 1 2 1\n2 2 3 2\n3 3 4 3\n4 4 1 4\n0\n"
CROSSED = PART.replace("2 2 3 2\n3 3 4 3\n4 4 1 4", "2 2 4 2\n3 4 3 3\n4 3 1 4")
NAMES = {"line feed": b"a\nb", "return": b"a\rb", "escape": b"a\x1b[31mb", "bell": b"a\x07b",
         "CSI of eight bits": b"a\x9bb", "CSI in UTF-8": "a\u009b31mb".encode(),
         "right to left": "a\u202eb".encode(), "letter mark": "a\u061cb".encode(), "end of paragraph": "a\u2029b".encode()}
# Lists commands as typed, with NAME in place of the file's name; commands with --json print an object.
LINES = ["mesh NAME.poly --size .4 -o NAME.mesh -o NAME.html", "mesh NAME.poly --size .4 -o NAME.mesh --json",
         "verify NAME.mesh --long", "verify NAME.mesh --domain NAME.crossed.poly", "certify NAME.mesh", "info NAME.poly",
         "info NAME.mesh", "info NAME.mesh --json", "info NAME.certificate.json", "mesh NAME.wrong.poly -o q.mesh",
         "mesh NAME.crossed.poly -o q.mesh", "draw NAME.mesh -o NAME.svg", "convert NAME.mesh NAME.msh", "mesh NAME -o q.mesh",
         "mesh square -o NAME", "mesh square --metric NAME -o q.mesh", "mesh square --size NAME -o q.mesh",
         "mesh square --NAME -o q.mesh", "mesh square --refine NAME -o q.mesh", "mesh square --size-near NAME:.1 -o q.mesh",
         "NAME", "NAME.poly", "help NAME", "man NAME", "completion NAME", "eval NAME", "challenge ./NAME",
         "mesh square -o noNAME/x.mesh",
         "mesh NAME.poly --size .4 -o NAME.mesh --proof NAME.proof",
         "check NAME.mesh NAME.proof --angle-bound 20 --metric NAME.sol --domain NAME.poly",
         "check NAME.mesh NAME.poly --angle-bound 20 --metric NAME.sol",
         "surface torus --chord .2 -o NAME.obj", "surface NAME --chord .2 -o q.obj", "deviation NAME.obj torus",
         "transfer NAME.mesh NAME.sol NAME.mesh -o q.sol", "mesh NAME.poly --size 1e-3 --max-sites 100 -o q.mesh"]
# A program may write this many lines of its own.
OWN_LINES = 40


class TerminalText(command.CommandTest):
    def run_bytes(self, words):
        return subprocess.run([command.PROGRAM.encode(), *words], cwd=self.folder, capture_output=True, check=False, timeout=120)

    def write_bytes(self, name, text):
        with open(self.folder.as_posix().encode() + b"/" + name, "w", encoding="ascii") as file:
            file.write(text)

    def test_names_are_shown_and_not_obeyed(self):
        for what, name in NAMES.items():
            self.write_bytes(name + b".poly", PART)
            self.write_bytes(name + b".crossed.poly", CROSSED)
            self.write_bytes(name + b".wrong.poly", PART.replace("2 2 0\n", "2 2,0 0\n"))
            shown = 0
            for line in LINES:
                done = self.run_bytes([word.encode().replace(b"NAME", name) for word in line.split()])
                said = done.stdout + done.stderr
                with self.subTest(what, line=line, said=said):
                    self.assertIn(done.returncode, (0, 1, 2))
                    if "--json" in line:
                        told = json.loads(done.stdout)
                        if "files" in told:
                            self.assertEqual(told["files"][0], name.decode(errors="replace") + ".mesh")
                        continue
                    self.assertNotIn(name, said)
                    self.assertEqual(set(re.findall(rb"[\x00-\x08\x0b-\x1f\x7f]", said)), set())
                    self.assertLess(said.count(b"\n"), OWN_LINES)
                    shown += b"?" in said
            self.assertGreater(shown, len(LINES) // 2)

    def test_words_of_the_user_are_cut_in_their_middle(self):
        long = "b" + "y" * 3000 + "e"
        self.write("long.poly", PART.replace("2 2 0\n", f"2 {long} 0\n"))
        self.write("long.msh", f"$MeshFormat\n4.1 0 8\n$EndMeshFormat\n${long}\n")
        for line in ("mesh NAME -o q.mesh", "mesh square -o NAME", "mesh square -o NAME/x.mesh", "mesh square --metric NAME -o q.mesh",
                     "mesh square --metric expr:NAME;0;1 -o q.mesh", "mesh square --size NAME -o q.mesh", "mesh square --NAME -o q.mesh",
                     "mesh square --refine NAME -o q.mesh", "NAME", "help NAME", "man NAME", "completion NAME", "eval NAME",
                     "draw square -o q.png --colour-by NAME", "surface NAME --chord 1 -o q.obj", "mesh square --periodic NAME -o q.mesh",
                     "mesh long.poly -o q.mesh", "certify long.msh", "info NAME", "mesh square -o q.mesh NAME"):
            done = self.run_command(*line.replace("NAME", long).split())
            self.assertEqual((done.returncode, done.stdout), (2, ""), line)
            self.assertLess(max(map(len, done.stderr.splitlines())), 600, line)

    def test_findings_have_the_digits_that_are_read(self):
        done = self.run_command("mesh", "square", "--metric", "swirl:12", "--size", "0.4", "-o", "a.mesh")
        self.assertEqual(done.returncode, 0, done.stderr)
        (self.folder / "a.sol").unlink()
        done = self.run_command("certify", "a.mesh")
        self.assertEqual(done.returncode, 1)
        found = [line for line in done.stdout.splitlines() if line.startswith("angle_below_bound: the angle")]
        self.assertEqual(len(found), 4)  # ten findings: an angle that several metrics measure alike is one line
        for line in found:
            self.assertIsNone(re.search(r"\d\.?\d{7,}|\d\.\d{9,}", line), line)
            places = re.findall(r"vertex \d+ \(", line)
            self.assertEqual(len(places), len(set(places)), line)
            self.assertEqual(len(places), 3, line)
        exact = json.loads(self.run_command("certify", "a.mesh", "--json").stdout)["witnesses"]
        self.assertTrue(any(re.search(r"\d\.\d{12,}", witness) for witness in exact))

    def test_numbers_of_regions_keep_their_digits(self):
        self.write("t.mesh", "MeshVersionFormatted 2\nDimension 2\nVertices\n4\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n"
                   "Triangles\n2\n1 2 3 1000001\n1 3 4 1000000\nEdges\n4\n1 2 1\n2 3 1\n3 4 1\n4 1 1\nEnd\n")
        said = self.run_command("certify", "t.mesh").stdout
        self.assertRegex(said, r"wrong_region: .* is in region 1000000, .* is in region 1000001, ")

    def test_an_angle_just_below_the_bound_keeps_its_digits(self):
        # The diagonal of a quadrangle leaves 1e-7 degrees less than the bound beside it.
        x, y = math.cos(math.radians(20 - 1e-7)), math.sin(math.radians(20 - 1e-7))
        self.write("t.mesh", "MeshVersionFormatted 2\nDimension 2\nVertices\n4\n0 0 0\n1 0 0\n"
                   f"{x!r} {y!r} 0\n0.3 0.9 0\nTriangles\n2\n1 2 3 1\n1 3 4 1\nEnd\n")
        done = self.run_command("certify", "t.mesh", "--angle-bound", "20")
        self.assertEqual(done.returncode, 1, done.stdout)
        line = next(line for line in done.stdout.splitlines() if line.startswith("angle_below_bound: the angle"))
        self.assertRegex(line, r"is 19\.9999999\d* degrees .*, below 20$")

    def test_edges_of_no_size_are_told_their_mean_length(self):
        self.run_command("mesh", "square", "--size", "0.2", "-o", "a.su2")
        said = self.run_command("certify", "a.su2").stdout
        self.assertRegex(said, r"edges of metric length 0\.71 to 1\.41: 0 of \d+ \(0\.0%\) \(mean length in the metric 0\.\d+, not 1\)")


if __name__ == "__main__":
    unittest.main()
