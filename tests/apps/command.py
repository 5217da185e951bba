# SPDX-License-Identifier: MIT
"""Runs the asterism command named by the environment variable ASTERISM_COMMAND."""
import os
import pathlib
import shutil
import subprocess
import tempfile
import unittest

PROGRAM = os.environ["ASTERISM_COMMAND"]


class CommandTest(unittest.TestCase):
    """Runs each test in a folder of its own."""

    def setUp(self):
        self.folder = pathlib.Path(tempfile.mkdtemp(prefix="asterism-test-"))
        self.addCleanup(shutil.rmtree, self.folder)

    def run_command(self, *arguments, text="", seconds=240, environment=None):
        """Runs the command. `text` is standard input, as text or as bytes; `environment` is added to that of the
        tests."""
        data = text if isinstance(text, bytes) else text.encode()
        done = subprocess.run([PROGRAM, *map(str, arguments)], input=data, cwd=self.folder,
                              capture_output=True, timeout=seconds, check=False,
                              env={**os.environ, **(environment or {})})
        done.stdout = done.stdout.decode()
        done.stderr = done.stderr.decode()
        return done

    def write(self, name, content):
        path = self.folder / name
        path.write_bytes(content if isinstance(content, bytes) else content.encode())
        return path

    def files(self):
        return sorted(p.relative_to(self.folder).as_posix() for p in self.folder.rglob("*"))


# A job of a second, whose mesh is certified.
JOB = ["mesh", "square", "--random-points", "10", "--metric", "swirl:3", "--angle-bound", "20"]


def section(lines, keyword):
    """Returns the line at which the entries of a Medit section start, and their number."""
    at = lines.index(keyword)
    return at + 2, int(lines[at + 1])
