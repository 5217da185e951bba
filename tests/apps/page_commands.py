# SPDX-License-Identifier: MIT
"""The commands that README and the manual show run as they stand, page by page and in their order, beside the files
that a reader would have. Results are left out, since their commands take minutes; the gallery has a test of its
own."""
import json
import math
import os
import pathlib
import re
import subprocess
import unittest

import command
from trimmed_surfaces import drilled_plate

TOP = pathlib.Path(__file__).resolve().parents[2]
PAGES = ["README.md", "docs/tutorial/README.md", *sorted(str(p.relative_to(TOP)) for p in (TOP / "docs/manual").glob("*.md"))]
SHOWN = re.compile(r"^    ((?:asterism |echo .*\| ?asterism )(?:.*\\\n)*.*)$", re.M)
# Files that a reader has: an outline, one with a fault, meshes of other programs, a solution.
OUTLINE = "4 2 0 0\n1 0 0\n2 2 0\n3 2 1\n4 0 1\n4 1\n1 1 2 1\n2 2 3 2\n3 3 4 3\n4 4 1 4\n0\n"
FAULTY = "5 2 0 0\n1 0 0\n2 2 0\n3 2 1\n4 0 1\n5 -0.1 0.5\n6 1\n1 1 2 1\n2 2 3 2\n3 3 4 3\n4 4 1 4\n5 5 3 5\n6 5 1 6\n0\n"
DISC = "1 2 0 0\n1 1 0\n0 1\n0\n0\ncurves 1\n1 circle 1 0 0 1\n"
LAKE = ('{"type": "Polygon", "coordinates": [[[-1, -1], [2, -1], [2, 1], [-1, 1], [-1, -1]],\n'
        '[[0.5, -0.3], [0.5, 0.3], [1, 0], [0.5, -0.3]]]}\n')
# Lines that cannot be run: forms with [options] or WORDS to fill in, and the reader's own programs.
FORM = re.compile(r"\[[A-Z-]|\.\.\.|\b(?!BAMG\b)[A-Z]{2,}\b|\||challenge \./")


def commands_of(page):
    for found in SHOWN.findall((TOP / page).read_text(encoding="utf-8")):
        line = re.sub(r"  +#.*$", "", found.replace("\\\n", " "), flags=re.M)
        if not FORM.search(re.sub(r"'[^']*'|^echo .*?\|", "", line)):
            yield line


class PageCommands(command.CommandTest):
    def prepare(self):
        for name in ("part", "house", "wing"):
            self.write(f"{name}.poly", OUTLINE)
        for name in ("lake", "crossed"):
            self.write(f"{name}.poly", FAULTY)
        self.write("lake.geojson", LAKE)
        self.write("disc.poly", DISC)
        self.write("drilled.json", json.dumps(drilled_plate()))
        for example in (TOP / "examples").glob("*.poly"):
            self.write(example.name, example.read_text())
        for name in ("swirl", "plate", "old", "made", "m", "w", "round1", "round2", "round3"):
            done = self.run_command("mesh", "square", "--metric", "swirl:3", "--size", "0.4", "-o", f"{name}.mesh")
            self.assertEqual(done.returncode, 0)
        lines = (self.folder / "old.mesh").read_text().split("\n")
        start, count = command.section(lines, "Vertices")
        at = [tuple(map(float, line.split()[:2])) for line in lines[start:start + count]]
        for name in ("u.sol", "old_u.sol", "t0.sol", "t1.sol"):
            self.write(name, f"MeshVersionFormatted 2\nDimension 2\nSolAtVertices {count}\n1 1\n"
                       + "".join(f"{math.tanh(4 * (x + y))!r}\n" for x, y in at) + "End\n")
        self.write("bamg.mesh", (self.folder / "m.mesh").read_text())
        self.write("bamg.sol", (self.folder / "m.sol").read_text())

    def follow(self, page):
        self.prepare()
        path = os.pathsep.join([str(pathlib.Path(command.PROGRAM).resolve().parent), os.environ["PATH"]])
        for line in commands_of(page):
            done = subprocess.run(["bash", "-c", line], cwd=self.folder, capture_output=True, text=True, timeout=300,
                                  check=False, env={**os.environ, "PATH": path})
            self.assertEqual(done.returncode, 0, f"{page}: {line}\n{done.stderr}")

    def test_there_are_many(self):
        self.assertGreaterEqual(sum(len(list(commands_of(page))) for page in PAGES), 16)


for name in PAGES:
    setattr(PageCommands, "test_" + re.sub(r"\W", "_", name), lambda self, page=name: self.follow(page))

if __name__ == "__main__":
    unittest.main()
