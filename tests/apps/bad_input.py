# SPDX-License-Identifier: MIT
"""Malformed and impossible input: a message that names what is wrong, exit status 2, and nothing
written."""
import os
import subprocess
import unittest

import command

SQUARE = """4 2 0 0
1 0 0
2 1 0
3 1 1
4 0 1
4 0
1 1 2
2 2 3
3 3 4
4 4 1
0
"""
HOLE = SQUARE.rsplit("0\n", 1)[0] + "1\n1 {} {}\n"


def changed(old, new):
    assert old in SQUARE
    return SQUARE.replace(old, new, 1)


# Lists what is wrong, the text of the .poly file, and a pattern that the message must match.
FILES = [
    ("empty file", "", r"in\.poly.*(empty|missing|end)"),
    ("comments only", "# nothing\n\n", r"in\.poly"),
    ("text for a number", changed("2 1 0\n", "2 one 0\n"), r"in\.poly:3.*'one'"),
    ("decimal comma", changed("2 1 0\n", "2 1,0 0\n"), r"in\.poly:3.*'1,0'"),
    ("NaN", changed("2 1 0\n", "2 nan 0\n"), r"in\.poly:3.*nan"),
    ("infinity", changed("2 1 0\n", "2 -inf 0\n"), r"in\.poly:3.*-inf"),
    ("overflow", changed("2 1 0\n", "2 1e999 0\n"), r"in\.poly:3.*1e999"),
    ("index out of range", changed("2 2 3\n", "2 2 9\n"), r"in\.poly:8.*9"),
    ("huge index", changed("2 2 3\n", "2 2 99999999999999999999\n"), r"in\.poly:8"),
    ("negative index", changed("2 2 3\n", "2 2 -3\n"), r"in\.poly:8.*-3"),
    ("three dimensions", changed("4 2 0 0", "4 3 0 0"), r"in\.poly:1.*dimension"),
    ("negative count", changed("4 2 0 0", "-4 2 0 0"), r"in\.poly:1.*-4"),
    ("absurd count", changed("4 2 0 0", "4000000000000 2 0 0"), r"in\.poly:1"),
    ("more vertices than lines", changed("4 2 0 0", "9 2 0 0"), r"in\.poly"),
    ("cut off", SQUARE[:40], r"in\.poly"),
    ("more on a line than there should be", changed("2 1 0\n", "2 1 0 7 8 9\n"), r"in\.poly:3"),
    ("number used twice", changed("3 1 1\n", "2 1 1\n"), r"in\.poly:4"),
    ("crossing segments", changed("2 2 3\n3 3 4\n", "2 2 4\n3 4 3\n").replace("4 4 1", "4 3 1"),
     r"segment.*cross"),
    ("unclosed boundary", changed("4 0\n1 1 2", "3 0\n1 1 2").replace("4 4 1\n", ""), r"vertex"),
    ("no segments", "3 2 0 0\n1 0 0\n2 1 0\n3 0 1\n0 0\n0\n", r"segment"),
    ("no vertices", "0 2 0 0\n0 0\n0\n", r"in\.(poly|node)"),
    ("all points the same", "3 2 0 0\n1 5 5\n2 5 5\n3 5 5\n3 0\n1 1 2\n2 2 3\n3 3 1\n0\n", r"."),
    ("flat domain", "3 2 0 0\n1 0 0\n2 1 1\n3 2 2\n3 0\n1 1 2\n2 2 3\n3 3 1\n0\n", r"."),
    ("hole outside", HOLE.format(5, 5), r"hole.*(outside|5)"),
    ("hole on the boundary", HOLE.format(0.5, 0), r"hole"),
    ("hole that leaves nothing", HOLE.format(0.5, 0.5), r"hole|empty|nothing"),
    ("hole at infinity", HOLE.format("inf", 0), r"in\.poly:12.*inf"),
    ("not text", bytes(range(256)) * 40, r"in\.poly:1"),
]

# Lists what is wrong, the arguments after `asterism mesh`, and a pattern that the message must match.
ARGUMENTS = [
    ("no such file", ["missing.poly", "-o", "x.mesh"], r"missing\.poly"),
    ("no such name", ["triangle", "-o", "x.mesh"], r"triangle"),
    ("a directory", ["folder.poly", "-o", "x.mesh"], r"folder\.poly"),
    ("no domain", ["-o", "x.mesh"], r"DOMAIN"),
    ("no output", ["square"], r"output"),
    ("unknown option", ["square", "-o", "x.mesh", "--colour", "red"], r"colour"),
    ("indefinite metric", ["square", "--metric", "expr:1;2;1", "-o", "x.mesh"], r"definite.*1.*2.*1"),
    ("metric indefinite in places", ["square", "--metric", "expr:x;0;1", "-o", "x.mesh"], r"definite"),
    ("metric not finite in places", ["square", "--metric", "expr:1/(x+1);0;1", "-o", "x.mesh"],
     r"finite|definite"),
    ("unknown metric", ["square", "--metric", "swril:3", "-o", "x.mesh"], r"swril"),
    ("negative swirl", ["square", "--metric", "swirl:-3", "-o", "x.mesh"], r"-3"),
    ("one length of a layer", ["square", "--metric", "layer:0.1", "-o", "x.mesh"], r"layer:0\.1.*H0,H1"),
    ("layer without height", ["square", "--metric", "layer:0,1", "-o", "x.mesh"], r"H0.*not 0"),
    ("benchmark with a parameter", ["square", "--metric", "polar-1:3", "-o", "x.mesh"], r"polar-1.*parameter"),
    ("gradation of one", ["square", "--gradation", "1", "-o", "x.mesh"], r"gradation.*above 1.*'1'|1.*above 1"),
    ("gradation not a number", ["square", "--gradation", "nan", "-o", "x.mesh"], r"gradation.*nan"),
    ("gradation where the metric is undefined", ["square", "--gradation", "2", "--metric", "expr:x;0;1",
     "-o", "x.mesh"], r"domain's box.*definite"),
    ("text for K", ["square", "--metric", "sink:much", "-o", "x.mesh"], r"much"),
    ("expression cut off", ["square", "--metric", "expr:1+;0;1", "-o", "x.mesh"], r"expr|expression"),
    ("two expressions", ["square", "--metric", "expr:1;1", "-o", "x.mesh"], r"expr|three"),
    ("unknown variable", ["square", "--metric", "expr:1+z^2;0;1", "-o", "x.mesh"], r"z"),
    ("empty metric", ["square", "--metric", "", "-o", "x.mesh"], r"metric"),
    ("negative size", ["square", "--size", "-1", "-o", "x.mesh"], r"--size.*-1.*positive"),
    ("size zero", ["square", "--size", "0", "-o", "x.mesh"], r"--size.*0.*positive"),
    ("size not a number", ["square", "--size", "nan", "-o", "x.mesh"], r"--size.*nan"),
    ("size with a unit", ["square", "--size", "3cm", "-o", "x.mesh"], r"--size.*'3cm'"),
    ("size whose square underflows", ["square", "--size", "1e-200", "-o", "x.mesh"], r"--size.*1e-200"),
    ("bound of 80 degrees", ["square", "--angle-bound", "80", "--max-sites", "1000", "-o", "x.mesh"],
     r"--angle-bound.*80.*60"),
    ("bound of 60 degrees", ["square", "--angle-bound", "60", "-o", "x.mesh"], r"--angle-bound.*60"),
    ("negative bound", ["square", "--angle-bound", "-5", "-o", "x.mesh"], r"--angle-bound.*-5"),
    ("tolerance zero", ["square", "--tol", "0", "-o", "x.mesh"], r"--tol.*0"),
    ("fewer sites allowed than given", ["square", "--max-sites", "3", "-o", "x.mesh"], r"3.*4"),
    ("negative number of sites", ["square", "--max-sites", "-7", "-o", "x.mesh"], r"--max-sites.*-7"),
    ("random points", ["square", "--random-points", "1e3", "-o", "x.mesh"], r"--random-points.*1e3"),
    ("too large a seed", ["square", "--seed", "99999999999999999999", "-o", "x.mesh"], r"--seed"),
    ("unknown refinement", ["square", "--refine", "magic", "-o", "x.mesh"], r"--refine.*magic"),
    ("unknown format", ["square", "-o", "x.stl"], r"x\.stl"),
    ("no extension", ["square", "-o", "mesh"], r"mesh"),
    ("no such directory", ["square", "-o", "nowhere/x.mesh"], r"nowhere"),
    ("second output impossible", ["square", "-o", "x.mesh", "-o", "nowhere/x.svg"], r"nowhere"),
    ("output is a directory", ["square", "-o", "folder.poly/../folder.mesh"], r"folder\.mesh"),
    ("the same file twice", ["square", "-o", "x.mesh", "-o", "./x.mesh"], r"x\.mesh.*twice"),
    ("certificate over a mesh", ["square", "-o", "x.mesh", "--certificate", "x.sol"], r"x\.sol.*twice"),
    ("certificate over the domain", ["good.poly", "-o", "x.mesh", "--certificate", "good.poly"],
     r"good\.poly.*twice"),
    ("certificate nowhere", ["square", "-o", "x.mesh", "--certificate", "nowhere/c.json"], r"nowhere"),
]


class BadInput(command.CommandTest):
    def refuse(self, arguments, pattern):
        before = self.files()
        done = self.run_command(*arguments, seconds=60)
        self.assertEqual(done.returncode, 2, done.stdout + done.stderr)
        self.assertRegex(done.stderr, r"\Aasterism: ")
        self.assertRegex(done.stderr, "(?s)" + pattern)
        self.assertEqual(done.stdout, "")
        self.assertEqual(self.files(), before, "something was written")

    def test_files(self):
        for what, content, pattern in FILES:
            with self.subTest(what):
                self.write("in.poly", content)
                self.refuse(["mesh", "in.poly", "-o", "out.mesh", "-o", "out.svg"], pattern)

    def test_arguments(self):
        self.write("good.poly", SQUARE)
        os.mkdir(self.folder / "folder.poly")
        os.mkdir(self.folder / "folder.mesh")
        for what, arguments, pattern in ARGUMENTS:
            with self.subTest(what):
                self.refuse(["mesh", *arguments], pattern)

    def test_an_output_over_the_vertices_of_a_poly_file(self):
        vertices, rest = SQUARE[:SQUARE.index("4 0\n1 1 2")], SQUARE[SQUARE.index("4 0\n1 1 2"):]
        self.write("in.node", vertices)
        self.write("in.poly", "0 2 0 0\n" + rest)
        self.refuse(["mesh", "in.poly", "-o", "out.mesh", "--certificate", "in.node"], r"in\.node.*twice")

    def test_standard_output_that_is_full(self):
        with open("/dev/full", "w", encoding="ascii") as full:
            done = subprocess.run([command.PROGRAM, "mesh", "square", "-o", "x.mesh"], cwd=self.folder, stdout=full,
                                  stderr=subprocess.PIPE, timeout=60, check=False)
        self.assertEqual(done.returncode, 1)
        self.assertEqual(done.stderr, b"asterism: standard output: writing failed\n")

    def test_other_commands(self):
        self.write("text.mesh", "once upon a time\n")
        self.write("empty.mesh", "")
        for arguments, pattern in [
                ([], r"a command"),
                (["knit"], r"knit"),
                (["verify"], r"MESH"),
                (["verify", "missing.mesh"], r"missing\.mesh"),
                (["verify", "text.mesh"], r"text\.mesh"),
                (["verify", "empty.mesh"], r"empty\.mesh"),
                (["verify", "empty.mesh", "--angle-bound", "80"], r"--angle-bound"),
                (["draw", "missing.mesh", "-o", "x.svg"], r"missing\.mesh"),
                (["draw", "text.mesh", "-o", "x.gif"], r"x\.gif"),
                (["draw", "text.mesh", "-o", "x.vtu"], r"x\.vtu"),
                (["draw", "text.mesh", "-o", "x.svg", "--width", "1"], r"--width.*1"),
        ]:
            with self.subTest(" ".join(arguments)):
                self.refuse(arguments, pattern)

    def test_the_good_file_is_good(self):
        self.write("good.poly", SQUARE)
        done = self.run_command("mesh", "good.poly", "-o", "out.mesh")
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertEqual(self.files(), ["good.poly", "out.certificate.json", "out.mesh", "out.sol"])


if __name__ == "__main__":
    unittest.main()
