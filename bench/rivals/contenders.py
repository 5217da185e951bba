# SPDX-License-Identifier: MIT
"""The mesh generators compared. Each prepares the files of the call that is measured, and returns the words of that
call."""
import os
import pathlib
import subprocess

from children import run

# [-1,1]^2 as BAMG's geometry, with a first length at its corners.
SQUARE = """MeshVersionFormatted 0
Dimension
2
MaximalAngleOfCorner
46
Vertices
4
-1 -1 1
1 -1 2
1 1 3
-1 1 4
Edges
4
1 2 1
2 3 2
3 4 3
4 1 4
Corners
4
1 2 3 4
hVertices
4
0.1 0.1 0.1 0.1
"""


class Failed(Exception):
    pass


def near(count, triangles):
    return abs(count / triangles - 1) <= 0.2


class Case:
    """A metric, and how many triangles unit edges should give."""

    def __init__(self, programs, metric, triangles, folder, limit):
        self.statistics, self.measure = str(programs / "mesh_statistics"), programs / "measure"
        self.metric, self.triangles = metric, triangles
        self.folder, self.limit = pathlib.Path(folder), limit
        self.folder.mkdir(parents=True, exist_ok=True)
        self.size = float(self.ask("size", metric, str(triangles)))

    def run(self, arguments, folder):
        done = run(self.measure, arguments, folder, self.limit)
        if done.timed_out:
            raise Failed(f"not ended after {self.limit} s")
        return done

    def ask(self, *words):
        done = subprocess.run([self.statistics, *words], capture_output=True, text=True, check=False)
        if done.returncode != 0:
            raise Failed(done.stderr.strip())
        return done.stdout


class Contender:
    """Prepares the call. `factor` multiplies the lengths wanted, so that the count is within 20 percent."""

    mesh = "made.mesh"

    def __init__(self, case, name):
        self.case, self.name, self.factor = case, name, 1.0
        self.folder = case.folder / name.replace(" ", "_")
        self.folder.mkdir(exist_ok=True)

    def call(self):
        """Removes the files of the call before. Their blocks may still be on the way to the disk, and a program that
        replaces such a file waits for them."""
        for left in self.folder.glob(pathlib.Path(self.mesh).stem + ".*"):
            left.unlink()
        done = self.case.run(self.command(), self.folder)
        if done.status not in (0, 1) or not (self.folder / self.mesh).exists():
            raise Failed(f"exit status {done.status}: {done.output[-200:].strip()}")
        return done

    def count(self):
        with open(self.folder / self.mesh, encoding="utf-8") as file:
            for line in file:
                if line.strip() == "Triangles":
                    return int(next(file))
        raise Failed("no triangles")

    def prepare(self):
        """Changes the factor at most four times. The table shows a contender whose count is still off."""
        for _ in range(5):
            count = self.settle()
            if near(count, self.case.triangles):
                break
            self.factor *= (count / self.case.triangles) ** 0.5


class Bamg(Contender):
    """Makes the background mesh and the metric on it, and makes them again from the resulting mesh until the count
    changes by less than 2 percent, as BAMG is used with a metric given by a formula. Only the last call is measured:
    it reads background mesh and metric, meshes and writes."""

    ways = 12

    def __init__(self, case, program):
        super().__init__(case, "BAMG")
        self.program = program

    def command(self):
        vertices = max(2000, int(1.5 * self.case.triangles))
        return [self.program, "-b", "background.mesh", "-M", "background.mtr", "-o", self.mesh,
                "-coef", repr(self.factor), "-nbv", str(vertices), "-v", "1"]

    def evaluate(self):
        text = self.case.ask("metric", str(self.folder / "background.mesh"), self.case.metric,
                             repr(self.case.size))
        (self.folder / "background.mtr").write_text(text, encoding="utf-8")

    def first(self):
        (self.folder / "square.mesh").write_text(SQUARE, encoding="utf-8")
        done = self.case.run([self.program, "-g", "square.mesh", "-o", "background.mesh", "-v", "1"],
                             self.folder)
        if done.status != 0:
            raise Failed(done.output[-200:])

    def settle(self):
        """Keeps the last background, so that the call can be repeated."""
        if not (self.folder / "background.mesh").exists():
            self.first()
        before = 0
        for self.calls in range(1, self.ways + 1):
            self.evaluate()
            self.call()
            count = self.count()
            if abs(count - before) <= 0.02 * count:
                break
            before = count
            os.replace(self.folder / self.mesh, self.folder / "background.mesh")
        else:
            self.call()
        return count


class Asterism(Contender):
    """The whole command: reads the domain, and writes mesh, metric and certificate, audit included."""

    def __init__(self, case, program, options):
        super().__init__(case, "Asterism " + " ".join(options))
        self.program, self.options = program, options

    def command(self):
        return [self.program, "mesh", "square", "--metric", self.case.metric,
                "--size", repr(self.case.size * self.factor), "--max-sites",
                str(max(1000, 2 * self.case.triangles)), "-o", self.mesh, *self.options]

    def settle(self):
        self.call()
        return self.count()
