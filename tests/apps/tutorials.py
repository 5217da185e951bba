# SPDX-License-Identifier: MIT
"""The commands of the tutorials work as they stand: files in fences that are named after them are written,
shell commands in fences are run in one folder, in order."""
import os
import pathlib
import re
import subprocess
import unittest

import command

FOLDER = pathlib.Path(__file__).resolve().parents[2] / "docs/tutorial"


class Tutorials(command.CommandTest):
    def follow(self, name):
        text = (FOLDER / name).read_text(encoding="utf-8")
        path = os.pathsep.join([str(pathlib.Path(command.PROGRAM).resolve().parent), os.environ["PATH"]])
        blocks = re.findall(r"^```(\S+)\n(.*?)^```$", text, re.M | re.S)
        self.assertGreater(sum(kind == "sh" for kind, _ in blocks), 2)
        for kind, body in blocks:
            if kind != "sh":
                self.write(kind, body)
                continue
            # A line at a time would lose loops; -e ends at the first command that fails and is not asked for it.
            script = re.sub(r"^(.*); (test \$\? -eq \d)$", r"set +e; \1; \2 || exit 99; set -e", body, flags=re.M)
            done = subprocess.run(["bash", "-ec", script], cwd=self.folder, capture_output=True, text=True,
                                  timeout=600, check=False, env={**os.environ, "PATH": path})
            self.assertEqual(done.returncode, 0, f"{body}\n{done.stdout}{done.stderr}")

    def test_engineer(self):
        self.follow("engineer.md")
        said = (self.folder / "channel.certificate.json").read_text()
        self.assertRegex(said, '"repair-done": "within .*1 crossings made vertices')

    def test_predicate_tester(self):
        self.follow("predicate_tester.md")

    def test_mesh_generator_author(self):
        self.follow("mesh_generator_author.md")


if __name__ == "__main__":
    unittest.main()
