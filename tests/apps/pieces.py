# SPDX-License-Identifier: MIT
"""Meshes in pieces: made, verified, spoiled, interrupted and distributed among ranks."""
import json
import os
import pathlib
import random
import re
import shutil
import signal
import subprocess
import time
import unittest

import command

SPOILED = int(os.environ.get("ASTERISM_SPOILED_PIECES", "60"))
MPI = os.environ.get("ASTERISM_MPI", "")

# A square with two holes, two regions divided by inner segments, and markers.
PLATE = """16 2 0 0
1 0 0
2 4 0
3 4 2
4 0 2
5 0.6 0.6
6 1.2 0.6
7 1.2 1.3
8 0.6 1.3
9 2.8 0.5
10 3.3 0.5
11 3.3 1.1
12 2.8 1.1
13 2 0
14 2 2
15 3.6 1.5
16 3.8 1.7
16 1
1 1 13 4
2 13 2 4
3 2 3 5
4 3 14 6
5 14 4 6
6 4 1 7
7 5 6 8
8 6 7 8
9 7 8 8
10 8 5 8
11 9 10 9
12 10 11 9
13 11 12 9
14 12 9 9
15 13 14 3
16 15 16 2
2
1 0.9 0.9
2 3 0.8
2
1 0.1 0.1 10 0
2 3.9 0.1 20 0
"""

# A disk with a hole, bounded by circles, and a spline inside.
DISK = """5 2 0 0
1 1 0
2 -0.4 0
3 0.1 -0.5
4 0.5 0
5 0.1 0.6
2 1
1 3 4 6
2 4 5 6
1
1 -0.55 0
0
curves 3
1 circle 1 0 0 3
2 circle 2 -0.55 0 4
3 spline 1 2
"""

JOBS = {
    "square": (["square", "--metric", "swirl:12", "--size", "0.08"], 5),
    "plate": (["plate.poly", "--size", "0.06"], 6),
    "points": (["square", "--random-points", "40", "--size", "0.1"], 4),
    "disk": (["disk.poly", "--size", "0.07"], 5),
    "layer": (["square", "--metric", "layer:0.02,0.3", "--size", "1"], 3),
}


def contents(folder):
    return {p.name: p.read_bytes() for p in folder.iterdir()}


class Pieces(command.CommandTest):
    def setUp(self):
        super().setUp()
        self.write("plate.poly", PLATE)
        self.write("disk.poly", DISK)

    def mesh(self, name, folder, *more, **how):
        words, pieces = JOBS[name]
        return self.run_command("mesh", *words, "--pieces", pieces, "-o", f"{folder}/", *more, **how)

    def index(self, folder):
        return json.loads((self.folder / folder / "index.json").read_text())

    def test_jobs_are_certified_and_verified(self):
        for name in JOBS:
            with self.subTest(name):
                done = self.mesh(name, name)
                self.assertEqual(done.returncode, 0, done.stdout + done.stderr)
                self.assertIn("certified", done.stdout)
                done = self.run_command("verify", f"{name}/")
                self.assertEqual(done.returncode, 0, done.stdout)
                index = self.index(name)
                self.assertEqual(len(index["pieces"]), JOBS[name][1])
                # Euler's formula, with vertices on seams counted once: all pieces together are one mesh.
                vertices, edges, triangles = self.whole(name)
                self.assertEqual(index["outcome"]["vertices"], len(vertices))
                self.assertEqual(index["outcome"]["triangles"], triangles)
                holes = {"plate": 2, "disk": 1}.get(name, 0)
                self.assertEqual(len(vertices) - len(edges) + triangles, 1 - holes)
                one = self.run_command("verify", f"{name}/piece_2.mesh")
                self.assertEqual(one.returncode, 0, one.stdout + one.stderr)

    def whole(self, folder):
        """Returns vertices, edges by their ends and the number of triangles of all pieces together."""
        vertices, edges, triangles = set(), set(), 0
        for path in sorted((self.folder / folder).glob("piece_*.mesh")):
            lines = path.read_text().split("\n")
            first, count = command.section(lines, "Vertices")
            here = [tuple(line.split()[:2]) for line in lines[first:first + count]]
            vertices.update(here)
            first, count = command.section(lines, "Triangles")
            triangles += count
            for line in lines[first:first + count]:
                t = [here[int(v) - 1] for v in line.split()[:3]]
                edges.update(frozenset((t[i], t[(i + 1) % 3])) for i in range(3))
        return vertices, edges, triangles

    def test_regions_markers_and_question(self):
        self.assertEqual(self.mesh("plate", "p").returncode, 0)
        ask = ["verify", "p/", "--domain", "plate.poly", "--metric", "identity", "--size", "0.06",
               "--angle-bound", "20"]
        self.assertEqual(self.run_command(*ask).returncode, 0)
        self.assertEqual(self.run_command(*ask[:-1], "45").returncode, 1)
        other = self.run_command("verify", "p/", "--metric", "identity", "--size", "0.07")
        self.assertEqual(other.returncode, 1)
        self.assertIn("piece 1: its metric is", other.stdout)
        square = self.run_command("verify", "p/", "--domain", "square")
        self.assertEqual(square.returncode, 1)
        self.assertIn("another domain than square", square.stdout)
        index = self.index("p")
        self.assertEqual(index["cut"]["marker"], 10)
        markers = {e[2] for e in index["cut"]["edges"]}
        self.assertEqual(markers, {2, 3, 4, 5, 6, 7, 8, 9, 10})
        regions = set()
        for path in (self.folder / "p").glob("piece_*.mesh"):
            lines = path.read_text().split("\n")
            first, count = command.section(lines, "Triangles")
            regions |= {line.split()[3] for line in lines[first:first + count]}
        self.assertEqual(regions, {"10", "20"})

    def test_threads_and_formats(self):
        one = self.mesh("square", "a", "--threads", "1", "--piece-format", "vtu")
        two = self.mesh("square", "b", "--threads", "3", "--piece-format", ".vtu")
        self.assertEqual((one.returncode, two.returncode), (0, 0), one.stderr + two.stderr)
        self.assertIn("piece_1.vtu", contents(self.folder / "a"))
        self.assertEqual(contents(self.folder / "a"), contents(self.folder / "b"))

    def test_all_pieces_are_one_partitioned_file_of_gmsh(self):
        self.assertEqual(self.mesh("plate", "p", "--piece-format", "msh").returncode, 0)
        index, path = self.index("p"), self.folder / "p/pieces.msh"
        lines = path.read_text().split("\n")
        at = lines.index("$PartitionedEntities")
        self.assertEqual(lines[at + 1:at + 3], ["6", "0"])
        told = json.loads(self.run_command("info", "p/pieces.msh", "--json").stdout)
        self.assertEqual((told["vertices"], told["triangles"]), (index["outcome"]["vertices"], index["outcome"]["triangles"]))
        # Counts each edge once. Pieces list an edge on a seam twice.
        markers, seams = {}, {}
        for piece in sorted((self.folder / "p").glob("piece_*.mesh")):
            rows = piece.read_text().split("\n")
            points = command.section(rows, "Vertices")
            places = [tuple(row.split()[:2]) for row in rows[points[0]:points[0] + points[1]]]
            first, count = command.section(rows, "Edges")
            for row in rows[first:first + count]:
                a, b, marker = row.split()
                seams[frozenset((places[int(a) - 1], places[int(b) - 1]))] = int(marker)
        for marker in seams.values():
            markers[marker] = markers.get(marker, 0) + 1
        names = re.search(r"^markers +(.*)$", self.run_command("info", "p/pieces.msh").stdout, re.M)[1]
        self.assertEqual({int(marker): int(count) for marker, count in re.findall(r"(\d+) \"[^\"]*\" \((\d+)\)", names)}, markers)
        judged = self.run_command("certify", "p/pieces.msh")
        self.assertEqual(judged.returncode, 0, judged.stdout + judged.stderr)
        if shutil.which("gmsh"):
            said = subprocess.run(["gmsh", "-check", "p/pieces.msh", "-parse_and_exit"], cwd=self.folder,
                                  capture_output=True, text=True, check=True)
            self.assertIn("6 partitions", said.stdout)
            self.assertNotIn("Error", said.stdout + said.stderr)

    def test_resumed_runs_have_the_same_bytes(self):
        self.assertEqual(self.mesh("square", "whole").returncode, 0)
        wanted = contents(self.folder / "whole")
        names = sorted(wanted)
        shuffled = random.Random(5)
        for turn in range(4):
            shutil.copytree(self.folder / "whole", self.folder / f"cut{turn}")
            (self.folder / f"cut{turn}" / "index.json").unlink()
            for name in shuffled.sample(names, 5):
                (self.folder / f"cut{turn}" / name).unlink(missing_ok=True)
            spoiled = self.folder / f"cut{turn}" / "piece_3.mesh"
            if turn % 2 and spoiled.exists():
                spoiled.write_bytes(spoiled.read_bytes()[:-100])
            done = self.mesh("square", f"cut{turn}", "--resume")
            self.assertEqual(done.returncode, 0, done.stderr)
            self.assertEqual(contents(self.folder / f"cut{turn}"), wanted)

    def test_a_run_that_is_cut_off_goes_on(self):
        cut = self.mesh("square", "c", "--max-seconds", "1e-9")
        self.assertIn(cut.returncode, (1, 2))
        self.assertNotIn("index.json", [p.name for p in (self.folder / "c").glob("*")])
        verify = self.run_command("verify", "c/") if (self.folder / "c").is_dir() else cut
        self.assertNotEqual(verify.returncode, 0)
        self.assertEqual(self.mesh("square", "c", "--resume").returncode, 0)
        self.assertEqual(self.mesh("square", "d").returncode, 0)
        self.assertEqual(contents(self.folder / "c"), contents(self.folder / "d"))

    def test_what_cannot_be_asked_is_refused(self):
        self.write("file", "no folder")
        base = ["mesh", "square", "--pieces", "4"]
        for words, said in [
                ([*base, "-o", "x/"], "a size is wanted"),
                ([*base, "--size", "0.2", "-o", "x/", "-o", "y/"], "one folder"),
                ([*base, "--size", "0.2", "-o", "file"], "a folder is wanted"),
                ([*base, "--size", "0.2", "-o", "no/such/"], "does not exist"),
                ([*base, "--size", "0.2", "-o", "x/", "--improve", "2"], "--improve"),
                ([*base, "--size", "0.2", "-o", "x/", "--certify", "voronoi"], "voronoi"),
                ([*base, "--size", "0.2", "-o", "x/", "--refine", "darts"], "--refine"),
                ([*base, "--size", "0.2", "-o", "x/", "--proof", "x.proof"], "--proof"),
                ([*base, "--size", "0.2", "-o", "x/", "--metric-tolerance", "1"], "tolerance"),
                ([*base, "--size", "0.2", "-o", "x/", "--piece-format", "html"], "html"),
                ([*base, "--size", "0.2", "-o", "x/", "--piece-format", "doc"], "doc"),
                ([*base, "--size", "2", "-o", "x/"], "less than 6 a piece"),
                (["mesh", "square", "--size", "0.2", "--resume", "-o", "x.mesh"], "--pieces"),
                (["verify", "x/"], "no such file")]:
            with self.subTest(words):
                done = self.run_command(*words)
                self.assertEqual(done.returncode, 2, done.stdout + done.stderr)
                self.assertIn(said, done.stderr)
                self.assertFalse((self.folder / "x").exists())

    # ---- spoiled pieces

    def spoil(self, pieces, chance):
        """Changes one thing in the folder; returns what, or None if the files are still the same."""
        folder = self.folder / "spoiled"
        files = sorted(p.name for p in folder.iterdir())
        how = chance.choice(["lose", "exchange", "number", "number", "number", "foreign", "cut off"])
        victim = folder / chance.choice(files)
        if how == "lose":
            victim.unlink()
            return f"{victim.name} lost"
        if how == "exchange":
            kind = chance.choice([".mesh", ".sol", ".certificate.json", ""])
            one, other = chance.sample(range(1, pieces + 1), 2)
            for ending in [kind] if kind else [".mesh", ".sol", ".certificate.json"]:
                a, b = folder / f"piece_{one}{ending}", folder / f"piece_{other}{ending}"
                a.rename(folder / "between")
                b.rename(a)
                (folder / "between").rename(b)
            return f"{one} and {other} exchanged {kind}"
        if how == "foreign":
            other = self.folder / "foreign" / victim.name
            if not other.exists() or other.read_bytes() == victim.read_bytes():
                return None
            shutil.copy(other, victim)
            return f"{victim.name} of another run"
        data = victim.read_text()
        if how == "cut off":
            victim.write_text(data[:chance.randrange(len(data) * 9 // 10)])
            return f"{victim.name} cut off"
        lines = data.split("\n")
        places = [i for i, line in enumerate(lines) if re.search(r"\d", line) and "#" not in line]
        at = chance.choice(places)
        digits = [m.start() for m in re.finditer(r"\d", lines[at])]
        k = chance.choice(digits)
        new = chance.choice([d for d in "0123456789" if d != lines[at][k]])
        before = lines[at]
        lines[at] = before[:k] + new + before[k + 1:]
        victim.write_text("\n".join(lines))
        return f"{victim.name}, line {at + 1}: {before[:60]} -> {lines[at][:60]}"

    def test_spoiled_pieces_are_refused(self):
        jobs = {"square": JOBS["square"], "plate": (JOBS["plate"][0][:-1] + ["0.12"], 4)}
        chance = random.Random(43)
        for name, job in jobs.items():
            words, pieces = job
            for folder, more in [("good", []), ("foreign", ["--angle-bound", "21"])]:
                done = self.run_command("mesh", *words, "--pieces", pieces, "-o", f"{folder}/", *more)
                self.assertEqual(done.returncode, 0, done.stderr)
            tried = 0
            while tried < SPOILED // len(jobs):
                shutil.copytree(self.folder / "good", self.folder / "spoiled")
                what = self.spoil(pieces, chance)
                if what and self.is_another(self.folder / "good", self.folder / "spoiled"):
                    tried += 1
                    done = self.run_command("verify", "spoiled/")
                    self.assertIn(done.returncode, (1, 2), f"accepted: {name}: {what}")
                    self.assertNotIn("Traceback", done.stderr)
                shutil.rmtree(self.folder / "spoiled")
            shutil.rmtree(self.folder / "good")
            shutil.rmtree(self.folder / "foreign")

    def is_another(self, good, spoiled):
        """False if the meshes of both folders have the same values: changed last digits may read back to the same
        double."""
        for path in good.iterdir():
            other = spoiled / path.name
            if not other.exists():
                return True
            if path.read_bytes() == other.read_bytes():
                continue
            if path.suffix == ".json":
                return True
            ours, theirs = path.read_text().split(), other.read_text().split()
            if len(ours) != len(theirs):
                return True
            for a, b in zip(ours, theirs):
                try:
                    if float(a) != float(b):
                        return True
                except ValueError:
                    if a != b:
                        return True
        return False

    def test_lost_exchanged_and_foreign_pieces_are_named(self):
        self.assertEqual(self.mesh("square", "good").returncode, 0)
        (self.folder / "good" / "piece_4.mesh").rename(self.folder / "kept")
        done = self.run_command("verify", "good/")
        self.assertEqual(done.returncode, 1)
        self.assertIn("piece 4: piece_4.mesh is missing", done.stdout)
        shutil.copy(self.folder / "good" / "piece_3.mesh", self.folder / "good" / "piece_4.mesh")
        done = self.run_command("verify", "good/")
        self.assertEqual(done.returncode, 1)
        self.assertIn("piece 4: ", done.stdout)
        self.assertNotIn("piece 3: ", done.stdout)

    # ---- MPI

    def run_ranks(self, ranks, *arguments):
        return subprocess.run(
            ["mpirun", "--allow-run-as-root", "--oversubscribe", "-n", str(ranks), MPI,
             *map(str, arguments)], cwd=self.folder, capture_output=True, text=True, timeout=280,
            check=False)

    def test_a_metric_on_a_mesh_is_read_in_parts(self):
        done = self.run_command("mesh", "square", "--metric", "swirl:12", "--size", "0.1", "-o", "back.mesh")
        self.assertEqual(done.returncode, 0, done.stderr)
        for name, words in {"size": ["--size", "0.8"], "graded": ["--size", "0.9", "--gradation", "1.1"],
                            "count": ["--vertices", "3000"],
                            "wished": ["--size", "0.8", "--size-at", "0,0,0.1:0.01"]}.items():
            with self.subTest(name):
                line = ["mesh", "square", "--metric", "back.mesh", *words, "--pieces", 5, "--quiet"]
                done = self.run_command(*line, "-o", f"{name}/")
                self.assertEqual(done.returncode, 0, done.stderr)
                wanted = contents(self.folder / name)
                self.assertFalse([n for n in wanted if n.endswith(".metric")])
                self.assertEqual(self.run_command("verify", f"{name}/").returncode, 0)
                for ranks in (2, 3) if MPI and shutil.which("mpirun") else ():
                    done = self.run_ranks(ranks, *line, "-o", f"{name}{ranks}/")
                    self.assertEqual(done.returncode, 0, done.stderr)
                    self.assertEqual(contents(self.folder / f"{name}{ranks}"), wanted)
        self.write("wide.poly", "4 2 0 0\n1 -1 -1\n2 9 -1\n3 9 1\n4 -1 1\n"
                   "4 1\n1 1 2 1\n2 2 3 1\n3 3 4 1\n4 4 1 1\n0\n")
        done = self.run_command("mesh", "wide.poly", "--metric", "back.mesh", "--size", "1", "--pieces", 3,
                                "-o", "wide/")
        self.assertEqual(done.returncode, 1)
        self.assertIn("a metric on a mesh that covers the domain", done.stderr)

    def test_ranks_write_the_same_bytes(self):
        if not MPI or not pathlib.Path(MPI).exists() or not shutil.which("mpirun"):
            self.skipTest("there is no MPI")
        self.assertEqual(self.mesh("square", "one").returncode, 0)
        wanted = contents(self.folder / "one")
        words, pieces = JOBS["square"]
        for ranks in (1, 2, 3, 4, 7):
            done = self.run_ranks(ranks, "mesh", *words, "--pieces", pieces, "-o", f"r{ranks}/")
            self.assertEqual(done.returncode, 0, done.stdout + done.stderr)
            self.assertEqual(done.stdout.count("certified"), 1)
            self.assertEqual(contents(self.folder / f"r{ranks}"), wanted)
        done = self.run_ranks(3, "verify", "r7/")
        self.assertEqual(done.returncode, 0, done.stdout)
        (self.folder / "r7" / "piece_5.sol").unlink()
        done = self.run_ranks(3, "verify", "r7/")
        self.assertEqual(done.returncode, 1, done.stdout)
        self.assertIn("piece 5: ", done.stdout)
        done = self.run_ranks(2, "mesh", "square", "--size", "0.2", "-o", "x.mesh")
        self.assertEqual(done.returncode, 2)
        self.assertEqual(done.stderr.count("--pieces is wanted"), 1)


    def ranks_of(self, parent):
        """Returns the processes of the command below this one."""
        below, found = [parent], []
        while below:
            one = below.pop()
            for tasks in pathlib.Path(f"/proc/{one}/task").glob("*/children"):
                children = [int(c) for c in tasks.read_text().split()]
                below += children
                found += [c for c in children
                          if pathlib.Path(f"/proc/{c}/comm").read_text().startswith("asterism-mpi")]
        return found

    def test_a_rank_that_dies_ends_the_run_and_leaves_whole_files(self):
        if not MPI or not pathlib.Path(MPI).exists() or not shutil.which("mpirun"):
            self.skipTest("there is no MPI")
        words = ["mesh", "square", "--metric", "swirl:12", "--size", "0.015", "--pieces", "12"]
        self.assertEqual(self.run_command(*words, "-o", "one/").returncode, 0)
        wanted = contents(self.folder / "one")
        (self.folder / "dead").mkdir()
        with subprocess.Popen(["mpirun", "--allow-run-as-root", "--oversubscribe", "-n", "2", MPI,
                               *words, "-o", "dead/"], cwd=self.folder, stdout=subprocess.DEVNULL,
                              stderr=subprocess.PIPE, text=True) as run:
            while run.poll() is None and not list((self.folder / "dead").glob("*.json")):
                time.sleep(0.01)
            try:
                ranks = self.ranks_of(run.pid) if run.poll() is None else []
                if ranks:
                    os.kill(ranks[-1], signal.SIGKILL)
            except OSError:
                ranks = []
            told = run.communicate(timeout=200)[1]
        left = {name: data for name, data in contents(self.folder / "dead").items()
                if not re.search(r"\.part\d*$", name)}
        for name, data in left.items():
            self.assertEqual(data, wanted[name], name)
        if ranks:
            self.assertNotEqual(run.returncode, 0)
            self.assertIn("signal 9", told)
            self.assertNotIn("index.json", left)
        done = self.run_command(*words, "-o", "dead/", "--resume")
        self.assertEqual(done.returncode, 0, done.stderr)
        for name, data in wanted.items():
            self.assertEqual((self.folder / "dead" / name).read_bytes(), data, name)


if __name__ == "__main__":
    unittest.main()
