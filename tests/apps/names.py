# SPDX-License-Identifier: MIT
"""Each thing has one name, and its other spellings do the same, to the byte: the table of docs/manual/names.md. Help
shows the one name alone."""
import re
import unittest

import command

# The command, with the one name and with another spelling; words that help must show, and must not.
ALIKE = [
    ("mesh", ["square", "--size", "0.5", "--voronoi"], ["square", "--size", "0.5", "--certify", "voronoi"],
     "--voronoi", "--certify "),
    ("mesh", ["square", "--size", "0.5", "--gradation", "none"], ["square", "--size", "0.5"], "none", None),
    ("mesh", ["square", "--metric", "a.mesh", "--size", "0.9"], ["square", "--metric", "./a.mesh", "--size", "0.9"], "--metric", None),
    ("adapt", ["a.mesh", "--solution", "u.sol", "--vertices", "90", "--hessian", "lsq"],
     ["a.mesh", "--solution", "u.sol", "--vertices", "90", "--hessian", "least_squares"], "lsq", "least_squares"),
    ("adapt", ["a.mesh", "--solution", "u.sol", "--vertices", "90", "--norm", "inf"],
     ["a.mesh", "--solution", "u.sol", "--vertices", "90", "--norm", "inf", "--gradation", "6"], "--norm", None),
    ("adapt", ["a.mesh", "--solution", "u.sol", "--vertices", "90", "--transfer", "project", "--solution-out", "v.sol"],
     ["a.mesh", "--solution", "u.sol", "--vertices", "90", "--transfer", "conservative", "--solution-out", "v.sol"],
     "project", "conservative"),
    ("draw", ["a.mesh", "--colour-by", "size"], ["a.mesh", "--color-by", "size"], "--colour-by", "--color-by"),
]
OUTPUT = {"draw": "out.svg"}
# The one name of each thing, and the commands that have the option.
EVERYWHERE = {
    "--metric": "mesh adapt metric verify certify", "--size": "mesh verify certify", "--hmin": "mesh adapt metric",
    "--hmax": "mesh adapt metric", "--aspect": "mesh adapt metric", "--gradation": "mesh adapt metric verify",
    "--vertices": "mesh adapt metric", "--angle-bound": "mesh adapt verify certify", "--voronoi": "mesh verify certify",
    "--max-seconds": "mesh adapt verify certify", "--threads": "mesh adapt metric transfer",
    "--domain": "adapt verify", "--solution": "adapt metric draw", "--certificate": "mesh adapt verify draw",
}


class Names(command.CommandTest):
    def prepare(self):
        self.assertEqual(self.run_command("mesh", "square", "--metric", "swirl:3", "--size", "0.5", "-o", "a.mesh").returncode, 0)
        count = command.section((self.folder / "a.mesh").read_text().split("\n"), "Vertices")[1]
        self.write("u.sol", f"MeshVersionFormatted 2\nDimension 2\nSolAtVertices {count}\n1 1\n"
                   + "".join(f"{(v * 7) % 11}\n" for v in range(count)) + "End\n")

    def written(self, name, arguments):
        """Returns the files that the command writes. Leaves out the words of the certificate that repeat the command
        line."""
        before = set(self.files())
        done = self.run_command(name, *arguments, "-o", OUTPUT.get(name, "out.mesh"))
        self.assertEqual(done.returncode, 0, f"{name} {arguments}: {done.stderr}")
        made = {file: (self.folder / file).read_bytes() for file in set(self.files()) - before if "certificate" not in file}
        for file in set(self.files()) - before:
            (self.folder / file).unlink()
        return made

    def test_other_spellings_do_the_same(self):
        self.prepare()
        for name, ours, other, shown, hidden in ALIKE:
            with self.subTest(name, other=other):
                self.assertTrue(self.written(name, ours) == self.written(name, other))
                text = self.run_command(name, "--help").stdout
                self.assertIn(shown, text)
                if hidden is not None:
                    self.assertNotIn(hidden, text)

    def test_commands_call_one_thing_by_one_name(self):
        for option, commands in EVERYWHERE.items():
            for name in commands.split():
                text = self.run_command(name, "--help").stdout
                self.assertRegex(text, rf"{re.escape(option)}\b", f"{name} has no {option}")


if __name__ == "__main__":
    unittest.main()
