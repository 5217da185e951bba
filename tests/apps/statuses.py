# SPDX-License-Identifier: MIT
"""The exit statuses are those of docs/manual/status_runs.md, and the line of verify that of its page."""
import os
import pathlib
import re
import shutil
import subprocess
import unittest

import command

MANUAL = pathlib.Path(__file__).resolve().parents[2] / "docs/manual"


def runs(page):
    """Yields the shell lines and statuses of the table of runs."""
    for line in page.splitlines():
        row = re.fullmatch(r"\| `(.*)` \| (\d) \| .* \|", line)
        if row:
            yield row[1].replace("\\|", "|"), int(row[2])


class Statuses(command.CommandTest):
    def test_the_line_of_verify_is_the_one_shown(self):
        page = (MANUAL / "verify_line.md").read_text(encoding="utf-8")
        shown = re.search(r"\n`asterism (mesh [^`]*)`, then `asterism (verify [^`]*)`:\n\n((?:    .*\n)+)", page)
        for words in shown[1].split(), shown[2].split():
            done = self.run_command(*words)
            self.assertEqual(done.returncode, 0, done.stderr)
        self.assertEqual(done.stdout.split(), shown[3].split())

    def test_every_run_of_the_table_ends_as_it_says(self):
        listed = list(runs((MANUAL / "status_runs.md").read_text(encoding="utf-8")))
        for name in ("mesh", "verify", "certify", "eval", "draw", "challenge", "metric", "adapt"):
            statuses = {status for line, status in listed if f"asterism {name}" in line}
            self.assertEqual(statuses, {0, 1, 2}, name)
        for name in ("wedge.poly", "values.sh"):
            shutil.copy(pathlib.Path(__file__).with_name(name), self.folder)
        path = os.pathsep.join([str(pathlib.Path(command.PROGRAM).resolve().parent), os.environ["PATH"]])
        for line, status in listed:
            with self.subTest(line):
                done = subprocess.run(["bash", "-c", line], cwd=self.folder, capture_output=True, text=True,
                                      timeout=240, check=False, env={**os.environ, "PATH": path})
                self.assertEqual(done.returncode, status, done.stdout + done.stderr)
                self.assertTrue(done.stderr or status != 2)
        self.assertFalse([name for name in self.files() if name.startswith(("no.", "big."))])


if __name__ == "__main__":
    unittest.main()
