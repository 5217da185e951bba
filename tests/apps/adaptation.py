# SPDX-License-Identifier: MIT
"""From a solution to the next mesh through the real command: files, statuses, sentences."""
import base64
import json
import math
import re
import struct
import unittest

import command


def grid(n, low=0.0, high=1.0):
    """Points and triangles of n x n cells, each cut in two."""
    step = (high - low) / n
    points = [(low + i * step, low + j * step) for j in range(n + 1) for i in range(n + 1)]
    cells = [j * (n + 1) + i for j in range(n) for i in range(n)]
    triangles = [t for a in cells for t in ((a, a + 1, a + n + 2), (a, a + n + 2, a + n + 1))]
    return points, triangles


def mesh_text(points, triangles):
    lines = ["MeshVersionFormatted 2", "Dimension 2", "Vertices", str(len(points))]
    lines += [f"{x!r} {y!r} 0" for x, y in points]
    lines += ["Triangles", str(len(triangles))]
    lines += [" ".join(str(v + 1) for v in t) + " 1" for t in triangles]
    return "\n".join(lines + ["End", ""])


def solution_text(rows, types=(1,)):
    lines = ["MeshVersionFormatted 2", "Dimension 2", "SolAtVertices", str(len(rows)),
             " ".join(map(str, (len(types), *types)))]
    lines += [" ".join(map(repr, row)) for row in rows]
    return "\n".join(lines + ["End", ""])


def rows_after(file, keyword, skipped):
    """Returns the rows of numbers of a section. The first line after the keyword has their number; `skipped` lines
    follow it before the rows."""
    lines = file.read_text().split("\n")
    start = lines.index(keyword) + 1
    return [list(map(float, line.split())) for line in lines[start + skipped:start + skipped + int(lines[start])]]


def front(x, y):
    return math.tanh(20 * (x * x + y * y - 0.5))


class AdaptationTest(command.CommandTest):
    def setUp(self):
        super().setUp()
        points, triangles = grid(20)
        self.points = points
        self.write("g.mesh", mesh_text(points, triangles))
        self.write("u.sol", solution_text([(front(x, y),) for x, y in points]))

    def metric(self, *arguments, status=0):
        done = self.run_command("metric", "g.mesh", *arguments, "-o", "m.mesh")
        self.assertEqual(done.returncode, status, done.stderr)
        return done

    def refused(self, *arguments, sentence):
        before = self.files()
        done = self.run_command(*arguments)
        self.assertEqual(done.returncode, 2, done.stderr)
        self.assertIn(sentence, done.stderr)
        self.assertEqual(self.files(), before)


class MetricTest(AdaptationTest):
    def test_target_is_met_and_said(self):
        done = self.metric("--solution", "u.sol", "--complexity", "900", "--gradation", "1.5",
                           "--hmax", "0.2")
        got = float(re.search(r"complexity ([0-9.]+) of 900 asked for", done.stdout).group(1))
        self.assertLess(abs(got / 900 - 1), 0.02)
        self.assertRegex(done.stdout, r"tensors changed by .*gradation \(how fast sizes grow\) at [\d.]+ %")
        self.assertEqual(self.files(), ["g.mesh", "m.mesh", "m.sol", "u.sol"])

    def test_case_that_bounds_once_multiplied_by_a_million(self):
        self.write("x.sol", solution_text([(50 * x * x,) for x, _ in self.points]))
        done = self.metric("--solution", "x.sol", "--complexity", "1000", "--hmin", "1e-5", "--hmax",
                           "0.2", "--aspect", "10")
        got = float(re.search(r"complexity ([0-9.]+) of", done.stdout).group(1))
        self.assertLess(abs(got - 1000), 20)

    def test_target_out_of_reach_is_told(self):
        done = self.metric("--solution", "u.sol", "--complexity", "1e6", "--hmin", "0.1", status=1)
        self.assertIn("hmin at 100 % of the vertices", done.stderr)
        self.assertIn("m.sol", self.files())
        self.assertIn("The target was not met", (self.folder / "m.mesh").read_text())

    def test_same_for_any_number_of_threads(self):
        texts = []
        for threads in ("1", "2"):
            self.metric("--solution", "u.sol", "--gradation", "1.4", "--threads", threads)
            texts.append((self.folder / "m.sol").read_bytes())
        self.assertEqual(*texts)

    def test_gradation_of_a_solution_is_six_unless_named(self):
        texts = []
        for words in ((), ("--gradation", "6"), ("--gradation", "none")):
            done = self.metric("--solution", "u.sol", "--vertices", "900", *words)
            texts.append((self.folder / "m.sol").read_text())
        self.assertEqual(texts[0], texts[1])
        self.assertNotEqual(texts[0], texts[2])
        self.assertNotIn("gradation (", done.stdout)
        self.refused("metric", "g.mesh", "--solution", "u.sol", "--gradation", "1", "-o", "x.mesh",
                     sentence="--gradation: 1 is out of range: it must be above 1")

    def test_gradation_of_a_metric_is_none_unless_named(self):
        rows = [(1 / (0.01 + 0.3 * x) ** 2, 0.0, 100.0) for x, _ in self.points]
        self.write("own.sol", solution_text(rows, (3,)))
        self.metric("--metric", "own.sol")
        kept = [float(w) for w in (self.folder / "m.sol").read_text().split("1 3\n")[1].split()[:3]]
        self.assertEqual(kept, list(rows[0]))

    def test_implied_metric_of_a_grid(self):
        self.metric("--implied")
        self.refused("metric", "g.mesh", "--implied", "--solution", "u.sol", "-o", "n.mesh",
                     sentence="there are several")

    def test_fields_are_chosen_by_name(self):
        self.write("v.sol", solution_text([(front(x, y), x * x, y * y) for x, y in self.points],
                                          types=(1, 2)))
        one = self.metric("--solution", "v.sol", "--field", "2.x")
        self.assertIn("1 field", one.stdout)
        self.assertIn("3 fields", self.metric("--solution", "v.sol").stdout)
        self.refused("metric", "g.mesh", "--solution", "v.sol", "--field", "p", "-o", "n.mesh",
                     sentence="there is no field 'p'; there are '1', '2'")

    def test_appended_base64_of_a_vtu(self):
        points, triangles = grid(20)
        arrays = {"Points": [c for x, y in points for c in (x, y, 0.0)],
                  "u": [front(x, y) for x, y in points]}
        appended, offsets = b"", {}
        for name, numbers in arrays.items():
            offsets[name] = len(appended)
            raw = struct.pack(f"<{len(numbers)}d", *numbers)
            appended += base64.b64encode(struct.pack("<I", len(raw)) + raw)
        text = ('<VTKFile type="UnstructuredGrid" version="0.1" byte_order="LittleEndian">'
                f'<UnstructuredGrid><Piece NumberOfPoints="{len(points)}" NumberOfCells="0"><PointData>'
                f'<DataArray type="Float64" Name="u" format="appended" offset="{offsets["u"]}"/></PointData>'
                '<Points><DataArray type="Float64" NumberOfComponents="3" format="appended" '
                f'offset="{offsets["Points"]}"/></Points><Cells></Cells></Piece></UnstructuredGrid>'
                f'<AppendedData encoding="base64">\n_{appended.decode()}\n</AppendedData></VTKFile>\n')
        self.write("u.vtu", text)
        self.metric("--solution", "u.vtu", "--vertices", "500")
        of_vtu = (self.folder / "m.sol").read_bytes()
        self.metric("--solution", "u.sol", "--vertices", "500")
        self.assertEqual(of_vtu, (self.folder / "m.sol").read_bytes())
        for spoiled in (text.replace("\n_", "\n_?"), text.replace(f'offset="{offsets["u"]}"', 'offset="99999999"'),
                        text.replace(appended.decode(), appended.decode()[:-4000])):
            self.write("u.vtu", spoiled)
            self.refused("metric", "g.mesh", "--solution", "u.vtu", "-o", "n.mesh", sentence="u.vtu")

    def test_metric_is_no_solution(self):
        self.metric("--implied")
        self.refused("metric", "g.mesh", "--solution", "m.sol", "-o", "n.mesh",
                     sentence="m.sol: one symmetric tensor a vertex is a metric")

    def test_solution_is_no_metric(self):
        self.refused("metric", "g.mesh", "--metric", "u.sol", "-o", "n.mesh", sentence="a size is a positive length, not '-")

    def test_no_file_is_used_twice(self):
        self.refused("metric", "g.mesh", "--solution", "u.sol", "-o", "u.mesh",
                     sentence="would be used twice")
        self.refused("metric", "g.mesh", "--solution", "u.sol", "-o", "m.vtu",
                     sentence="is written as .mesh")

    def test_a_metric_is_written_alone(self):
        done = self.run_command("metric", "g.mesh", "--solution", "u.sol", "--vertices", "60", "-o", "n.mesh")
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertRegex(done.stdout, r"written in [0-9.]+ seconds: n\.mesh, n\.sol")
        done = self.run_command("metric", "g.mesh", "--solution", "u.sol", "--vertices", "60", "-o", "alone.sol")
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertRegex(done.stdout, r"written in [0-9.]+ seconds: alone\.sol")
        self.assertEqual((self.folder / "alone.sol").read_bytes(), (self.folder / "n.sol").read_bytes())
        self.assertFalse((self.folder / "alone.mesh").exists())
        done = self.run_command("metric", "g.mesh", "--implied", "--vertices", "100000", "--hmin", "0.5", "-o", "far.sol")
        self.assertEqual(done.returncode, 1, done.stderr)
        self.assertIn("\n# The target was not met: ", (self.folder / "far.sol").read_text())
        (self.folder / "far.mesh").write_bytes((self.folder / "g.mesh").read_bytes())
        done = self.run_command("info", "far.sol")
        self.assertEqual(done.returncode, 0, done.stderr)

    def test_a_metric_alone_of_a_file_with_a_vertex_in_no_triangle(self):
        """It has a row for each vertex of the file, so that it is a metric of that file."""
        points, triangles = grid(20)
        at = 7
        self.write("lone.mesh", mesh_text([*points[:at], (5.0, 5.0), *points[at:]],
                                          [[v + (v >= at) for v in t] for t in triangles]))
        done = self.run_command("metric", "lone.mesh", "--implied", "-o", "lone.sol")
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertIn("note: 1 vertex in no triangle left out, the first: vertex 8 at (5, 5)", done.stderr)
        self.assertEqual(self.metric("--implied").stderr, "")
        rows, plain = (rows_after(self.folder / name, "SolAtVertices", 2) for name in ("lone.sol", "m.sol"))
        self.assertEqual(rows, [*plain[:at], [1, 0, 1], *plain[at:]])
        done = self.run_command("adapt", "lone.mesh", "--metric", "lone.sol", "-o", "n.mesh")
        self.assertEqual(done.returncode, 0, done.stderr)

    def test_numbers_that_are_none(self):
        self.write("nan.sol", (self.folder / "u.sol").read_text().replace("\nEnd", "\nEnd")
                   .replace(repr(front(*self.points[3])), "nan", 1))
        self.refused("metric", "g.mesh", "--solution", "nan.sol", "-o", "n.mesh", sentence="vertex")
        for wish in (("--norm", "0.5"), ("--vertices", "0"), ("--hmin", "2", "--hmax", "1"),
                     ("--gradation", "1"), ("--norm", "x"), ("--vertices", "9", "--error", "1")):
            self.refused("metric", "g.mesh", "--solution", "u.sol", *wish, "-o", "n.mesh",
                         sentence=wish[0].removeprefix("--vertices"))


def exact_hessian(x, y):
    """Returns the second derivatives of the front, or of a saddle."""
    t = math.tanh(20 * (x * x + y * y - 0.5))
    slope, bend = 20 * (1 - t * t), -800 * t * (1 - t * t)
    return (bend * 4 * x * x + 2 * slope, bend * 4 * x * y, bend * 4 * y * y + 2 * slope)


def data_text(rows, name):
    """Returns a gmsh file with the grid's nodes and a tensor at each."""
    points, triangles = grid(20)
    lines = ["$MeshFormat", "2.2 0 8", "$EndMeshFormat", "$Nodes", str(len(points))]
    lines += [f"{k + 1} {x!r} {y!r} 0" for k, (x, y) in enumerate(points)]
    lines += ["$EndNodes", "$Elements", str(len(triangles))]
    lines += [f"{k + 1} 2 2 1 1 {a + 1} {b + 1} {c + 1}" for k, (a, b, c) in enumerate(triangles)]
    lines += ["$EndElements", "$NodeData", "1", f'"{name}"', "1", "0", "3", "0", "9", str(len(points))]
    lines += [f"{k + 1} {a!r} {b!r} 0 {b!r} {c!r} 0 0 0 0" for k, (a, b, c) in enumerate(rows)]
    return "\n".join(lines + ["$EndNodeData", ""])


def vtu_text(rows, name, width=9):
    points, _ = grid(20)
    tensors = "\n".join(f"{a!r} {b!r} 0 {b!r} {c!r} 0 0 0 0" for a, b, c in rows)
    places = "\n".join(f"{x!r} {y!r} 0" for x, y in points)
    return ('<VTKFile type="UnstructuredGrid" version="0.1" byte_order="LittleEndian"><UnstructuredGrid>'
            f'<Piece NumberOfPoints="{len(points)}" NumberOfCells="0"><PointData>'
            f'<DataArray type="Float64" Name="{name}" NumberOfComponents="{width}" format="ascii">\n{tensors}\n'
            '</DataArray></PointData><Points><DataArray type="Float64" NumberOfComponents="3" format="ascii">\n'
            f'{places}\n</DataArray></Points><Cells></Cells></Piece></UnstructuredGrid></VTKFile>\n')


class GivenHessianTest(AdaptationTest):
    """Takes second derivatives from a file (--given-hessian) in place of recovering them."""

    def setUp(self):
        super().setUp()
        self.rows = [exact_hessian(x, y) for x, y in self.points]
        self.write("h.sol", solution_text(self.rows, (3,)))

    def tensors(self, *arguments):
        self.metric(*arguments)
        return rows_after(self.folder / "m.sol", "SolAtVertices", 2)

    def test_metric_is_the_optimum_of_the_tensors(self):
        """Where no bound applies, M = D det|H|^(-1/6) |H|, so that M and |H| have the same shape."""
        found = self.tensors("--given-hessian", "h.sol", "--vertices", "800", "--gradation", "none")
        factors = []
        for h, m in list(zip(self.rows, found))[::7]:
            det, mean = h[0] * h[2] - h[1] * h[1], (h[0] + h[2]) / 2
            radius = math.sqrt(max(mean * mean - det, 0))
            low, high = sorted((abs(mean + radius), abs(mean - radius)))
            weak = ((m[0] + m[2]) - math.hypot(m[0] - m[2], 2 * m[1])) / 2
            if weak < 10:  # sizes are bounded at the other points
                continue
            trace = (low + high) * (low * high) ** (-1 / 6)
            factors.append((m[0] + m[2]) / trace)
        self.assertGreater(len(factors), 10)
        self.assertLess(max(factors) / min(factors), 1 + 1e-9)

    def test_sign_of_a_tensor_has_no_part_in_it(self):
        first = self.tensors("--given-hessian", "h.sol", "--vertices", "800")
        self.write("h.sol", solution_text([tuple(-x for x in row) for row in self.rows], (3,)))
        self.assertEqual(first, self.tensors("--given-hessian", "h.sol", "--vertices", "800"))

    def test_files_of_all_forms_say_the_same(self):
        wanted = self.tensors("--given-hessian", "h.sol", "--error", "1e-3", "--norm", "1")
        self.write("h.msh", data_text(self.rows, "H"))
        self.write("h.vtu", vtu_text(self.rows, "H"))
        for file in ("h.msh", "h.vtu"):
            words = ("--given-hessian", file, "--error", "1e-3", "--norm", "1")
            self.assertEqual(wanted, self.tensors(*words))
            self.assertEqual(wanted, self.tensors(*words, "--field", "H"))
            self.refused("metric", "g.mesh", *words, "--field", "K", "-o", "n.mesh",
                         sentence="there is no field 'K'; there are 'H'")

    def test_several_fields_are_intersected(self):
        saddle = [(0.0, 300.0, 0.0)] * len(self.points)
        self.write("two.sol", solution_text([(*a, *b) for a, b in zip(self.rows, saddle)], (3, 3)))
        done = self.metric("--given-hessian", "two.sol", "--vertices", "900", "--json")
        said = json.loads(done.stdout)
        self.assertEqual(said["fields"], ["1", "2"])
        self.assertEqual(said["steps"][:3], ["hessian given", "optimum 2", "fields 2"])

    def test_adapt_brings_the_solution_and_verify_makes_the_metric_again(self):
        done = self.run_command("adapt", "g.mesh", "--given-hessian", "h.sol", "--solution", "u.sol", "--vertices",
                                "500", "-o", "n.mesh", "--solution-out", "v.sol")
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertLess(abs(int(re.search(r"(\d+) sites", done.stdout).group(1)) / 500 - 1), 0.1)
        certificate = (self.folder / "n.certificate.json").read_text()
        self.assertIn('"adapt-given-hessian": "h.sol"', certificate)
        self.assertEqual(self.run_command("verify", "n.mesh").returncode, 0)
        self.write("h.sol", solution_text([(2.0, 1.0, -1.0)] * len(self.points), (3,)))
        self.assertNotEqual(self.run_command("verify", "n.mesh").returncode, 0)

    def test_of_several_steps_of_a_field_it_is_said_which_is_taken(self):
        one = data_text(self.rows, "u")
        data = one[one.index("$NodeData"):]
        self.write("u.msh", one + data.replace("\n3\n0\n", "\n3\n4\n"))
        note = "u.msh: the field 'u' is there 2 times, and the last one is taken: step 4"
        for job in (("transfer", "u.msh", "u.msh", "g.mesh", "-o", "v.sol"),
                    ("metric", "u.msh", "--given-hessian", "u.msh", "--vertices", "900", "-o", "n.mesh"),
                    ("draw", "u.msh", "-o", "u.html"), ("convert", "u.msh", "u.vtu"),
                    ("info", "u.msh")):
            done = self.run_command(*job)
            self.assertEqual(done.returncode, 0, done.stderr)
            self.assertEqual((done.stdout if job[0] == "info" else done.stderr).count(note), 1, job)
        self.assertRegex(done.stdout, r"field u +tensor, numbers from ")

    def test_lines_between_regions_that_keep_their_vertices_are_named(self):
        points, triangles = grid(20)
        text = mesh_text(points, triangles).split("\n")
        first = text.index("Triangles") + 2
        for k in range(len(triangles)):
            text[first + k] = " ".join([*text[first + k].split()[:3], str(1 + k % 5)])
        self.write("r.mesh", "\n".join(text))
        done = self.run_command("adapt", "r.mesh", "--given-hessian", "h.sol", "--vertices", "50", "-o", "new.mesh")
        self.assertEqual(done.returncode, 1, done.stderr)
        self.assertRegex(done.stderr, r"\d+ on those inside, which keep every vertex at which a line between regions")

    def test_advice_on_a_solution_of_one_direction_is_followed(self):
        points, _ = grid(20, -1, 1)
        self.write("s.mesh", mesh_text(*grid(20, -1, 1)))
        self.write("s.sol", solution_text([(1, -1, 1)] * len(points), (3,)))
        job = ("adapt", "s.mesh", "--given-hessian", "s.sol", "--vertices", "400", "-o", "new.mesh")
        done = self.run_command(*job)
        self.assertEqual(done.returncode, 1)
        self.assertRegex(done.stderr, "asterism: try --hmax 1, or an --aspect of 30\n$")
        for advice in ("--hmax", "1"), ("--aspect", "30"):
            self.assertEqual(self.run_command(*job, *advice).returncode, 0)

    def test_what_cannot_be_meant_is_refused(self):
        job = ("metric", "g.mesh", "-o", "n.mesh")
        self.refused(*job, "--given-hessian", "h.sol", "--hessian", "lsq", sentence="leave one of the two out")
        self.refused(*job, "--given-hessian", "h.sol", "--error", "0.01", "--relative",
                     sentence="divide the second derivatives")
        self.refused(*job, "--given-hessian", "h.sol", "--implied", sentence="there are several")
        self.refused(*job, "--given-hessian", "u.sol", sentence="there is no symmetric tensor")
        self.refused(*job, "--given-hessian", "none.sol", sentence="none.sol")
        self.write("nan.sol", (self.folder / "h.sol").read_text().replace(repr(self.rows[3][0]), "nan", 1))
        self.refused(*job, "--given-hessian", "nan.sol", sentence="vertex")


class RelativeErrorTest(AdaptationTest):
    """The error is given as a part of the values, as adaptmesh's err is."""

    def tensors(self, values, *arguments):
        self.write("u.sol", solution_text([(u,) for u in values]))
        self.metric("--solution", "u.sol", "--relative", "--gradation", "none", *arguments)
        return rows_after(self.folder / "m.sol", "SolAtVertices", 2)

    def test_metric_is_the_formula(self):
        """On a grid, the recovery finds the second derivatives of u = 3 x^2 + y^2 + 2 to rounding."""
        values = [3 * x * x + y * y + 2 for x, y in self.points]
        for cutoff in (None, 0.5):
            words = () if cutoff is None else ("--cutoff", cutoff)
            found = self.tensors(values, "--error", "0.01", "--hessian", "lsq", *words)
            for u, m in list(zip(values, found))[::13]:
                scale = 4.0 if cutoff is None else max(u, cutoff * 6)
                for wanted, got in zip((6, 0, 2), m):
                    self.assertAlmostEqual(got, 0.94 * wanted / (0.01 * scale), delta=1e-6 * 600)

    def test_units_of_the_field_have_no_part_in_it(self):
        values = [front(x, y) for x, y in self.points]
        first = self.tensors(values, "--error", "0.02")
        self.assertEqual(first, self.tensors([1024 * u for u in values], "--error", "0.02"))
        pointwise = self.tensors(values, "--error", "0.02", "--cutoff", "0.25")
        self.assertEqual(pointwise, self.tensors([u / 1024 for u in values], "--error", "0.02", "--cutoff", "0.25"))

    def test_no_size_is_greater_than_the_mesh(self):
        found = self.tensors([x for x, _ in self.points[:-1]] + [1.001], "--error", "10")
        for m in found:
            self.assertGreaterEqual(m[0] * (1 + 1e-12), 1)

    def test_count_follows_the_error_and_verify_makes_it_again(self):
        self.write("u.sol", solution_text([(math.exp(-40 * ((x - 0.4) ** 2 + (y - 0.5) ** 2)),)
                                           for x, y in self.points]))
        counts = []
        for error in ("0.02", "0.005"):
            done = self.run_command("adapt", "g.mesh", "--solution", "u.sol", "--error", error, "--relative", "-o",
                                    "n.mesh")
            self.assertEqual(done.returncode, 0, done.stderr)
            counts.append(int(re.search(r"(\d+) sites", done.stdout).group(1)))
            self.assertEqual(self.run_command("verify", "n.mesh").returncode, 0)
        self.assertIn('"adapt-relative": "yes"', (self.folder / "n.certificate.json").read_text())
        self.assertIn("relative 0.005", (self.folder / "n.certificate.json").read_text())
        self.assertLess(abs(counts[1] / counts[0] / 4 - 1), 0.25)

    def test_what_cannot_be_meant_is_refused(self):
        job = ("metric", "g.mesh", "--solution", "u.sol", "-o", "n.mesh")
        self.refused(*job, "--relative", sentence="--relative is of an --error, and there is none")
        self.refused(*job, "--error", "0.1", "--cutoff", "0.1", sentence="--cutoff is of --relative")
        self.refused(*job, "--error", "0.1", "--relative", "--norm", "2", sentence="--norm has no part")
        self.refused(*job, "--error", "0.1", "--relative", "--cutoff", "2", sentence="above 0, at most 1")
        self.write("u.sol", solution_text([(7.0,)] * len(self.points)))
        self.refused(*job, "--error", "0.1", "--relative", sentence="no second derivatives")


class SeriesTest(AdaptationTest):
    """Metrics of windows in time, with one complexity over all."""

    def setUp(self):
        super().setUp()
        for k, steepness in enumerate((5, 20, 60), 1):
            self.write(f"t{k}.sol", solution_text([(math.tanh(steepness * (x - 0.2 * k)),) for x, _ in self.points]))

    def series(self, *arguments, windows=("t1.sol", "t2.sol", "t3.sol")):
        words = [word for file in windows for word in ("--series", file)]
        done = self.run_command("metric", "g.mesh", *words, *arguments, "-o", "s.mesh", "--json")
        self.assertEqual(done.returncode, 0, done.stderr)
        return json.loads(done.stdout)

    def test_one_complexity_over_all(self):
        said = self.series("--complexity", "500")
        self.assertLess(abs(said["complexity_delivered"] / 1500 - 1), 0.02)
        self.assertAlmostEqual(sum(said["windows"]), said["complexity_delivered"], delta=1e-6)
        self.assertLess(said["windows"][0], said["windows"][1])
        self.assertEqual(said["files"], [f"s.{k}.{e}" for k in (1, 2, 3) for e in ("mesh", "sol")])

    def test_complexity_of_a_window_follows_the_optimum(self):
        """In the mean square the factor D is the same for all windows. The density of a window is proportional to
        det|H|^(1/3) of the sum. Values that are eight times as great therefore give 8^(2/3) times the complexity."""
        for name, times in (("a", 1), ("b", 8)):
            self.write(f"{name}.sol", solution_text([(times * (x * x + 2 * y * y),) for x, y in self.points]))
        first, second = self.series("--hessian", "lsq", "--gradation", "none", windows=("a.sol", "b.sol"))["windows"]
        self.assertAlmostEqual(second / first, 4, delta=1e-3)

    def test_windows_alike_have_the_metric_of_one(self):
        for k in (1, 2):
            self.write(f"same{k}.sol", (self.folder / "t2.sol").read_bytes())
        self.series("--vertices", "700", windows=("same1.sol", "same2.sol"))
        self.metric("--solution", "t2.sol", "--vertices", "700")
        for k in (1, 2):
            for a, b in zip(rows_after(self.folder / f"s.{k}.sol", "SolAtVertices", 2),
                            rows_after(self.folder / "m.sol", "SolAtVertices", 2)):
                for x, y in zip(a, b):
                    self.assertAlmostEqual(x, y, delta=0.02 * max(b[0], b[2]))

    def test_windows_on_meshes_of_their_own(self):
        points, triangles = grid(12)
        self.write("w.mesh", mesh_text(points, triangles))
        self.write("w.sol", solution_text([(front(x, y),) for x, y in points]))
        said = self.series("--vertices", "400", windows=("t1.sol", "w.mesh"))
        self.assertEqual(len(said["windows"]), 2)
        self.assertEqual(len(rows_after(self.folder / "s.2.sol", "SolAtVertices", 2)), len(points))

    def test_what_cannot_be_meant_is_refused(self):
        job = ("metric", "g.mesh", "--series", "t1.sol", "-o", "s.mesh")
        self.refused(*job, "--solution", "u.sol", sentence="name one of them")
        self.refused(*job, "--implied", sentence="name one of them")
        self.refused(*job, "--series", "none.sol", sentence="none.sol")
        self.refused(*job, "--series", "t1.sol", sentence="twice")
        self.write("two.sol", solution_text([(x, y) for x, y in self.points], (1, 1)))
        self.refused(*job, "--series", "two.sol", sentence="all windows have the same fields")


class SplitAcrossTest(AdaptationTest):
    """No inner edge joins two vertices of the boundary."""

    def across(self, name):
        triangles = [[int(v) for v in row[:3]] for row in rows_after(self.folder / name, "Triangles", 1)]
        counts = {}
        for t in triangles:
            for a, b in ((t[0], t[1]), (t[1], t[2]), (t[2], t[0])):
                counts[min(a, b), max(a, b)] = counts.get((min(a, b), max(a, b)), 0) + 1
        outer = {v for e, n in counts.items() if n == 1 for v in e}
        return sum(1 for e, n in counts.items() if n == 2 and outer.issuperset(e)), len(triangles)

    def both_ways(self, *job):
        found = []
        for words in ((), ("--no-split-across",)):
            done = self.run_command(*job, *words, "-o", "n.mesh")
            self.assertEqual(done.returncode, 0, done.stderr)
            self.assertEqual(self.run_command("verify", "n.mesh").returncode, 0)
            found.append(self.across("n.mesh"))
        (before, _), (after, triangles) = found
        self.assertGreater(before, 0)
        self.assertEqual(after, 0)
        return triangles

    def test_mesh_of_a_square(self):
        self.both_ways("mesh", "square", "--size", "0.5")

    def test_mesh_without_a_size(self):
        self.both_ways("mesh", "square")

    def test_strip_that_is_one_edge_wide(self):
        self.write("strip.poly", "4 2 0 0\n1 0 0\n2 4 0\n3 4 0.3\n4 0 0.3\n4 1\n1 1 2 1\n2 2 3 2\n3 3 4 3\n4 4 1 4\n0\n")
        self.both_ways("mesh", "strip.poly", "--size", "0.3")

    def test_metric_that_turns(self):
        self.both_ways("mesh", "square", "--metric", "swirl:3", "--size", "0.4")

    def test_hole_and_a_line_inside_that_reaches_the_boundary(self):
        self.write("ring.poly", "9 2 0 0\n1 0 0\n2 3 0\n3 3 3\n4 0 3\n5 1 1\n6 2 1\n7 2 2\n8 1 2\n9 3 1.5\n"
                   "10 1\n1 1 2 1\n2 2 9 1\n3 9 3 1\n4 3 4 1\n5 4 1 1\n6 5 6 2\n7 6 7 2\n8 7 8 2\n9 8 5 2\n"
                   "10 9 7 7\n1\n1 1.5 1.5\n")
        self.both_ways("mesh", "ring.poly", "--size", "0.8")

    def test_adapted_mesh_and_its_certificate(self):
        self.both_ways("adapt", "g.mesh", "--solution", "u.sol", "--vertices", "400")
        certificate = (self.folder / "n.certificate.json").read_text()
        self.assertIn('"split-across": "no"', certificate)
        done = self.run_command("adapt", "n.mesh", "--metric", "n.sol", "--no-split-across", "-o", "k.mesh")
        self.assertIn("stays as it is", done.stdout)

    def test_certificate_that_says_so_of_another_mesh_is_refused(self):
        self.assertEqual(self.run_command("mesh", "square", "--size", "0.5", "-o", "n.mesh").returncode, 0)
        text = (self.folder / "n.certificate.json").read_text()
        spoiled, count = re.subn(r'("options": {)', r'\1 "split-across": "no",', text)
        self.assertEqual(count, 1)
        self.write("n.certificate.json", spoiled)
        checked = self.run_command("verify", "n.mesh")
        self.assertEqual(checked.returncode, 1)
        self.assertIn("joins two vertices of the boundary", checked.stdout)

    def test_pieces_are_refused(self):
        self.refused("mesh", "square", "--size", "0.1", "--pieces", "4", "--no-split-across", "-o", "p/",
                     sentence="a mesh in pieces")


class AdaptTest(AdaptationTest):
    def test_wishes_of_a_solution_are_refused_without_one(self):
        self.write("m.sol", solution_text([(1.0, 0.0, 4.0)] * len(self.points), (3,)))
        for wish in (("--norm", "1"), ("--hessian", "l2"), ("--error", "0.1")):
            for source in (("--metric", "m.sol"), ("--implied",)):
                self.refused("metric", "g.mesh", *source, *wish, "-o", "n.mesh",
                             sentence=wish[0] + " is of a --solution, and there is none")

    def adapt(self, mesh, *arguments, status=0):
        done = self.run_command("adapt", mesh, *arguments)
        self.assertEqual(done.returncode, status, done.stderr)
        return done

    def test_mesh_solution_and_certificate(self):
        done = self.adapt("g.mesh", "--solution", "u.sol", "--vertices", "300", "--transfer", "project",
                          "-o", "n.mesh", "--solution-out", "v.sol")
        self.assertIn("domain: 4 of 80 boundary vertices kept", done.stdout)
        self.assertEqual(self.files(), ["g.mesh", "n.certificate.json", "n.mesh", "n.sol", "u.sol",
                                        "v.sol"])
        sites = int(re.search(r"(\d+) sites", done.stdout).group(1))
        self.assertLess(abs(sites / 300 - 1), 0.1)
        checked = self.run_command("verify", "n.mesh")
        self.assertEqual(checked.returncode, 0, checked.stdout)
        self.assertRegex(checked.stdout, r"metric: another than asked for, solution u\.sol, by the certificate: lengths up to [\d.]+ times")

    def test_numbers_of_the_report_are_made_again(self):
        self.adapt("g.mesh", "--solution", "u.sol", "--vertices", "200", "--transfer", "bounded", "-o",
                   "n.mesh", "--solution-out", "v.sol")
        certificate = (self.folder / "n.certificate.json").read_text()
        for name in ("metric-complexity-delivered", "metric-factor", "metric-floored",
                     "transfer-area-after", "transfer-integral-after 1", "boundary-kept", "kept",
                     "adapt-vertices"):
            spoiled, count = re.subn(f'("{name}": ")([^"]*)"', r'\g<1>0.123"', certificate)
            self.assertEqual(count, 1, name)
            self.write("n.certificate.json", spoiled)
            checked = self.run_command("verify", "n.mesh")
            self.assertEqual(checked.returncode, 1, name)
            self.assertIn("certificate: ", checked.stdout)
        (self.folder / "u.sol").unlink()
        self.write("n.certificate.json", certificate)
        self.assertIn("field not checked", self.run_command("verify", "n.mesh").stdout)

    def test_fields_that_are_carried_have_no_part_in_the_metric(self):
        self.write("c.sol", solution_text([(x, x - 2 * y, y) for x, y in self.points], (1, 2)))
        plain = self.adapt("g.mesh", "--solution", "u.sol", "--vertices", "300", "-o", "p.mesh")
        self.assertNotIn("carried", plain.stdout)
        done = self.adapt("g.mesh", "--solution", "u.sol", "--vertices", "300", "-o", "n.mesh", "--solution-out",
                          "v.sol", "--carry", "c.sol", "--carry-out", "d.sol", "--transfer", "project")
        self.assertEqual((self.folder / "n.mesh").read_bytes(), (self.folder / "p.mesh").read_bytes())
        self.assertIn("carried.2.y", done.stdout)
        points, rows = rows_after(self.folder / "n.mesh", "Vertices", 1), rows_after(self.folder / "d.sol", "SolAtVertices", 2)
        self.assertEqual(len(points), len(rows))
        for (x, y, _), row in list(zip(points, rows))[::17]:
            for wanted, found in zip((x, x - 2 * y, y), row):
                self.assertAlmostEqual(wanted, found, places=12)
        self.assertEqual(self.run_command("verify", "n.mesh").returncode, 0)
        certificate = (self.folder / "n.certificate.json").read_text()
        spoiled, count = re.subn('("transfer-integral-after carried.2.y": ")([^"]*)"', r'\g<1>0.123"', certificate)
        self.assertEqual(count, 1)
        self.write("n.certificate.json", spoiled)
        self.assertEqual(self.run_command("verify", "n.mesh").returncode, 1)
        self.write("m.sol", solution_text([(9.0, 0.0, 30.0)] * len(self.points), (3,)))
        self.adapt("g.mesh", "--metric", "m.sol", "-o", "q.mesh", "--carry", "c.sol", "--carry-out", "e.bb")
        self.adapt("g.mesh", "--metric", "m.sol", "-o", "t.mesh", "--carry", "m.sol", "--carry-out", "s.sol")
        self.assertEqual(self.run_command("verify", "t.mesh").returncode, 0)
        self.assertEqual(self.run_command("verify", "q.mesh").returncode, 0)
        for more, sentence in ((("--carry", "c.sol"), "--carry-out"), (("--carry-out", "e.bb"), "--carry"),
                               (("--carry", "none.sol", "--carry-out", "f.bb"), "none.sol"),
                               (("--carry", "c.sol", "--carry-out", "c.sol"), "c.sol")):
            self.refused("adapt", "g.mesh", "--solution", "u.sol", "-o", "r.mesh", *more, sentence=sentence)

    def test_adapting_twice_with_the_metric_delivered_changes_nothing(self):
        self.adapt("g.mesh", "--solution", "u.sol", "--vertices", "300", "-o", "n.mesh")
        done = self.adapt("n.mesh", "--metric", "n.sol", "-o", "m.mesh")
        self.assertIn("stays as it is", done.stdout)
        for ending in (".mesh", ".sol"):
            self.assertEqual((self.folder / f"n{ending}").read_bytes(),
                             (self.folder / f"m{ending}").read_bytes())
        self.assertEqual(self.run_command("verify", "m.mesh").returncode, 0)

    def test_what_stays_is_asked_for(self):
        # The grid has equal sizes. exp(5x) cos(5y) wants other sizes, equal in all directions.
        values = [(math.exp(5 * x) * math.cos(5 * y),) for x, y in self.points]
        self.write("h.sol", solution_text(values))
        count = str(len(self.points))
        job = ("g.mesh", "--solution", "h.sol", "--vertices", count)
        for words in ((), ("--keep", "auto"), ("--keep", "never")):
            done = self.adapt(*job, *words, "-o", "n.mesh")
            self.assertNotIn("stays as it is", done.stdout)
            self.assertGreater(float(re.search(r"([\d.]+)% unit", done.stdout).group(1)), 95)
        self.assertEqual(self.run_command("verify", "n.mesh").returncode, 0)
        done = self.adapt("n.mesh", "--metric", "n.sol", "--keep", "never", "-o", "m.mesh")
        self.assertNotIn("stays as it is", done.stdout)
        done = self.adapt("n.mesh", "--implied", "--keep", "always", "-o", "m.mesh")
        self.assertIn("stays as it is, as --keep always wants it", done.stdout)
        self.assertEqual(self.run_command("verify", "m.mesh").returncode, 0)
        self.assertEqual(self.run_command("adapt", *job, "--keep", "maybe", "-o", "n.mesh").returncode, 2)

    def test_a_note_on_a_mesh_that_stays_is_said_once(self):
        self.adapt("g.mesh", "--solution", "u.sol", "--vertices", "300", "-o", "n.mesh")
        self.assertEqual(self.run_command("convert", "n.mesh", "n.su2").returncode, 0)
        lines = (self.folder / "n.su2").read_text().split("\n")
        first = [line.startswith("NELEM") for line in lines].index(True) + 1
        kind, a, b, *more = lines[first].split()
        lines[first] = " ".join((kind, b, a, *more))
        self.write("turned.su2", "\n".join(lines))
        done = self.adapt("turned.su2", "--metric", "n.sol", "--keep", "always", "-o", "m.mesh")
        self.assertIn("stays as it is", done.stdout)
        self.assertEqual(done.stderr.count("turned over"), 1, done.stderr)

    def test_a_new_mesh_that_is_the_same_is_verified(self):
        text = mesh_text([(0.0, 0.0), (1.0, 0.0), (1.0, 1.0), (0.0, 1.0)], [(0, 1, 2), (0, 2, 3)])
        self.write("o.mesh", text.replace("1 3 4 1", "1 3 4 2"))  # two regions, so that the edge between stays
        self.write("o.sol", solution_text([(0.0,), (1.0,), (1.0,), (0.0,)]))
        done = self.adapt("o.mesh", "--solution", "o.sol", "--vertices", "3", "--keep", "never", "-o", "n.mesh")
        self.assertIn("the new mesh is the one given", done.stdout)
        self.assertEqual(self.run_command("verify", "n.mesh").returncode, 0)

    def test_vertices_on_segments_are_counted_once(self):
        points, triangles = grid(2, 0.0, 1.0)
        text = mesh_text(points, triangles).replace("Triangles", "Edges\n2\n2 5 9\n5 8 9\nRequiredEdges\n2\n1\n2\n"
                                                    "Triangles")
        self.write("o.mesh", text)
        self.write("o.sol", solution_text([(x,) for x, _ in points]))
        done = self.adapt("o.mesh", "--solution", "o.sol", "--vertices", "2", "-o", "n.mesh", status=1)
        there, on = re.search(r"2 vertices were wanted, and (\d+) are there, (\d+) of them on segments",
                              done.stderr).groups()
        self.assertLessEqual(int(on), int(there))

    def test_a_metric_near_the_end_of_the_doubles_stays_what_it_is(self):
        for size in "1e-200", "1e-300":
            tensors = solution_text([(float(size), 0.0, float(size))] * len(self.points), (3,))
            self.write("far.sol", tensors)
            done = self.adapt("g.mesh", "--metric", "far.sol", "-o", "n.mesh")
            self.assertNotIn("changed by aspect", done.stdout)
            self.assertEqual(self.run_command("verify", "n.mesh").returncode, 0)

    def test_few_vertices_that_a_mesh_cannot_have_are_told(self):
        done = self.adapt("g.mesh", "--solution", "u.sol", "--vertices", "1", "-o", "n.mesh", status=1)
        self.assertIn("1 vertices were wanted, and 4 are there", done.stderr)

    def test_fields_that_vary_in_one_direction_have_the_number_wanted(self):
        """All vertices are on two sides, and edges from one to the other are as long as the domain is high."""
        for cells, height in (5, 1), (10, 0.1), (4, 10):
            points, triangles = grid(cells)
            points = [(x, height * y) for x, y in points]
            self.write("o.mesh", mesh_text(points, triangles))
            self.write("o.sol", solution_text([(x * x,) for x, _ in points]))
            for wanted in 40, 60, 200:
                with self.subTest(cells=cells, height=height, wanted=wanted):
                    self.adapt("o.mesh", "--solution", "o.sol", "--vertices", str(wanted), "-o", "n.mesh")
                    self.assertLess(abs(len(rows_after(self.folder / "n.mesh", "Vertices", 0)) / wanted - 1), 0.1)

    def test_extreme_targets_end(self):
        for wish in ("1e-300", "1e-20"):
            done = self.adapt("g.mesh", "--solution", "u.sol", "--complexity", wish, "-o", "n.mesh", status=1)
            self.assertIn("sizes of a thousand times the mesh's extent", done.stderr)
        for wish in (("--vertices", "1e8"), ("--complexity", "1e9"), ("--error", "1e-300")):
            self.refused("adapt", "g.mesh", "--solution", "u.sol", *wish, "-o", "k.mesh",
                         sentence="no more than 10000000 are made unless --max-sites")
        self.adapt("g.mesh", "--solution", "u.sol", "--vertices", "1e8", "--max-sites", "500", "-o", "n.mesh",
                   status=1)

    def test_exact_domain(self):
        self.write("unit.poly", "4 2 0 0\n1 0 0\n2 1 0\n3 1 1\n4 0 1\n4 1\n1 1 2 5\n2 2 3 6\n3 3 4 7\n"
                                "4 4 1 8\n0\n")
        self.adapt("g.mesh", "--solution", "u.sol", "--vertices", "200", "--domain", "unit.poly", "-o",
                   "n.mesh")
        self.assertIn("unit.poly", (self.folder / "n.certificate.json").read_text())
        self.refused("adapt", "g.mesh", "--solution", "u.sol", "--domain", "unit.poly",
                     "--corner-angle", "20", "-o", "k.mesh", sentence="excludes")

    def test_same_for_any_number_of_threads(self):
        texts = []
        for threads in ("1", "2"):
            self.adapt("g.mesh", "--solution", "u.sol", "--vertices", "200", "--threads", threads,
                       "--transfer", "bounded", "-o", "n.mesh", "--solution-out", "v.sol")
            texts.append([(self.folder / f).read_bytes()
                          for f in ("n.mesh", "n.sol", "v.sol", "n.certificate.json")])
        self.assertEqual(*texts)

    def test_metric_tolerance(self):
        job = ("adapt", "g.mesh", "--solution", "u.sol", "--vertices", "200",
               "--gradation", "none", "-o", "n.mesh")
        done = self.run_command(*job, "--metric-tolerance", "0.001")
        self.assertEqual(done.returncode, 1)
        self.assertIn("where 0.001 is tolerated", done.stderr)
        self.assertEqual(self.run_command("verify", "n.mesh").returncode, 1)
        done = self.run_command(*job, "--metric-tolerance", "9")
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertEqual(self.run_command("verify", "n.mesh").returncode, 0)
        self.assertEqual(self.run_command(*job, "--metric-tolerance", "-1").returncode, 2)

    def test_page_and_json(self):
        done = self.adapt("g.mesh", "--solution", "u.sol", "--vertices", "200", "--transfer", "project", "-o",
                          "n.mesh", "-o", "n.html", "--solution-out", "v.sol", "--json")
        said = json.loads(done.stdout)
        self.assertEqual((said["command"], said["status"], said["vertices_wanted"], said["kept"]),
                         ("adapt", 0, 200, False))
        self.assertEqual(sorted(said["files"]), ["n.certificate.json", "n.html", "n.mesh", "n.sol", "v.sol"])
        self.assertTrue(said["solution_metric"]["reached"])
        field = said["transfer"]["fields"][0]
        self.assertLess(abs(field["integral_after"] - field["integral_before"]), 1e-14)
        page = (self.folder / "n.html").read_text()
        self.assertIn("solution u.sol", page)
        self.assertIn("verify", page)
        self.assertEqual(self.run_command("adapt", "g.mesh", "--solution", "u.sol", "-o", "k.mesh", "--json",
                                          "--quiet").returncode, 2)

    def test_json_of_metric_and_transfer(self):
        said = json.loads(self.run_command("metric", "g.mesh", "--solution", "u.sol", "--complexity", "700",
                                           "-o", "m.mesh", "--json").stdout)
        self.assertEqual((said["command"], said["status"], said["complexity_asked"]), ("metric", 0, 700))
        self.assertLess(abs(said["complexity_delivered"] - 700), 14)
        missed = self.run_command("metric", "g.mesh", "--solution", "u.sol", "--complexity", "1e6", "--hmin",
                                  "0.1", "-o", "m.mesh", "--json")
        self.assertEqual(missed.returncode, 1)
        self.assertIn("hmin", json.loads(missed.stdout)["reason"])
        points, triangles = grid(17)
        self.write("h.mesh", mesh_text(points, triangles))
        said = json.loads(self.run_command("transfer", "g.mesh", "u.sol", "h.mesh", "--transfer", "bounded",
                                           "-o", "v.sol", "--json").stdout)
        self.assertEqual((said["command"], said["files"]), ("transfer", ["v.sol"]))
        self.assertLess(abs(said["area_common"] - 1), 1e-14)

    def test_another_number_than_was_wanted_is_told(self):
        # A comb whose teeth end in vertices that must all stay: more than the number wanted.
        lines = ["MeshVersionFormatted 2", "Dimension 2", "Vertices", "302"]
        lines += [f"{i / 150!r} {0 if k == 0 else 0.2 + 0.1 * (i % 2)!r} 0" for i in range(151) for k in (0, 1)]
        triangles = [t for i in range(150) for t in ((2 * i, 2 * i + 2, 2 * i + 3), (2 * i, 2 * i + 3, 2 * i + 1))]
        lines += ["Triangles", "300", *(" ".join(str(v + 1) for v in t) + " 1" for t in triangles), "End", ""]
        self.write("c.mesh", "\n".join(lines))
        self.write("c.sol", solution_text([(float(i % 7),) for i in range(302)]))
        done = self.run_command("adapt", "c.mesh", "--solution", "c.sol", "--vertices", "100", "-o", "d.mesh",
                                seconds=100)
        self.assertEqual(done.returncode, 1, done.stdout)
        self.assertRegex(done.stderr, "not reached: ")

    def test_what_is_refused(self):
        adapt = ("adapt", "g.mesh")
        self.refused(*adapt, "-o", "n.mesh", sentence="there is none")
        self.refused(*adapt, "--solution", "u.sol", "-o", "u.mesh", sentence="used twice")
        self.refused(*adapt, "--solution", "u.sol", "-o", "n.mesh", "--solution-out", "n.sol",
                     sentence="used twice")
        self.refused(*adapt, "--implied", "-o", "n.mesh", "--solution-out", "v.sol",
                     sentence="there is no --solution to transfer")
        self.refused(*adapt, "--solution", "u.sol", "--domain", "no.poly", "-o", "n.mesh",
                     sentence="no.poly")


class SpoiledTest(AdaptationTest):
    """Two hundred spoiled or hostile inputs give neither crash nor hang: each is refused by a sentence, and nothing
    is written."""

    WORDS = ["nan", "inf", "-1", "0", "1e999", "99999999999999999999", "x", "", "\x00", "#", "1e-320",
             "SolAtVertices", "End", "Dimension 3", "\xff\xfe"]

    def test_spoiled_files(self):
        points, triangles = grid(6)
        mesh, values = mesh_text(points, triangles), solution_text([(x * x + y,) for x, y in points])
        self.write("o.mesh", mesh)
        refused = 0
        state = 12345  # a linear congruential sequence from a fixed seed
        for i in range(200):
            texts = {"g.mesh": mesh, "u.sol": values}
            name = ("u.sol", "g.mesh")[i % 4 == 3]
            words = texts[name].split(" ") if i % 5 == 4 else re.split(r"(\s+)", texts[name])
            state = (state * 6364136223846793005 + 1442695040888963407) % 2**64
            at = (state >> 33) % len(words)
            if i % 7 == 6:
                words = words[:at]
            else:
                words[at] = self.WORDS[(state >> 20) % len(self.WORDS)]
            texts[name] = "".join(words) if i % 5 != 4 else " ".join(words)
            for file, text in texts.items():
                self.write(file, text.encode("latin-1"))
            command_line = (("metric", "g.mesh", "--solution", "u.sol", "-o", "n.mesh"),
                            ("adapt", "g.mesh", "--solution", "u.sol", "--max-seconds", "5", "-o",
                             "n.mesh", "--solution-out", "v.sol"),
                            ("transfer", "g.mesh", "u.sol", "o.mesh", "-o", "v.sol"))[i % 3]
            done = self.run_command(*command_line, seconds=60)
            with self.subTest(i=i, error=done.stderr):
                self.assertIn(done.returncode, (0, 1, 2))
                if done.returncode == 2:
                    refused += 1
                    self.assertTrue(done.stderr.startswith("asterism: "))
                    self.assertEqual(self.files(), ["g.mesh", "o.mesh", "u.sol"])
            for made in self.folder.glob("[nv].*"):
                made.unlink()
        self.assertGreater(refused, 100)

    def test_values_of_any_size_have_the_mesh_of_ordinary_ones(self):
        points, triangles = grid(6)
        self.write("g.mesh", mesh_text(points, triangles))
        made = set()
        for times in (1, 2.0 ** -900, 2.0 ** 1000):
            # From 1 to 2 at most: the same power of two is taken out.
            self.write("u.sol", solution_text([(times * (1.5 + (x ** 2 + x * y) / 8),) for x, y in points]))
            done = self.run_command("adapt", "g.mesh", "--solution", "u.sol", "--vertices", "50", "-o", "n.mesh")
            self.assertEqual(done.returncode, 0, done.stderr)
            made.add((self.folder / "n.mesh").read_bytes())
        self.assertEqual(len(made), 1)

    def test_coordinates_too_small_to_compute_with_name_the_file_of_values(self):
        points, triangles = grid(6)
        self.write("g.mesh", mesh_text([(x * 1e-100, y * 1e-100) for x, y in points], triangles))
        self.write("u.sol", solution_text([(100.0 if i == 20 else x,) for i, (x, y) in enumerate(points)]))
        for command_line in (("metric", "g.mesh"), ("adapt", "g.mesh")):
            self.refused(*command_line, "--solution", "u.sol", "--vertices", "50", "-o", "n.mesh",
                         sentence="u.sol: field 1: the second derivatives at vertex")


class TransferTest(AdaptationTest):
    def setUp(self):
        super().setUp()
        points, triangles = grid(17)
        self.write("h.mesh", mesh_text(points, triangles))

    def transfer(self, how, values="u.sol"):
        """Returns the numbers of --json, after comparing them with those of the summary, to the digits these have."""
        line = ["transfer", "g.mesh", values, "h.mesh", "--transfer", how, "-o", "v.sol"]
        done = self.run_command(*line)
        self.assertEqual(done.returncode, 0, done.stderr)
        found = re.search(r"integral (\S+) before, (\S+) after(?:, the same|, differing by \S+)?; from (\S+) to (\S+) "
                          r"before, (\S+) to (\S+) after", done.stdout)
        component = json.loads(self.run_command(*line, "--json").stdout)["fields"][0]
        exact = [component[name] for name in ("integral_before", "integral_after", "least_before", "greatest_before",
                                              "least_after", "greatest_after")]
        for told, number in zip(found.groups(), exact):
            self.assertAlmostEqual(float(told), number, delta=5e-6 * abs(number))
        return exact

    def test_a_metric_goes_over_entry_by_entry(self):
        self.write("m.sol", solution_text([(9.0, x, 30.0) for x, _ in self.points], (3,)))
        done = self.run_command("transfer", "g.mesh", "m.sol", "h.mesh", "-o", "v.sol")
        self.assertEqual(done.returncode, 0, done.stderr)
        for (x, _, _), row in zip(rows_after(self.folder / "h.mesh", "Vertices", 1),
                                  rows_after(self.folder / "v.sol", "SolAtVertices", 2)):
            for wanted, found in zip((9.0, x, 30.0), row):
                self.assertAlmostEqual(wanted, found, places=12)

    def test_integral_is_reported_and_kept(self):
        for how in ("project", "bounded"):
            before, after, *_ = self.transfer(how)
            self.assertLess(abs(after - before), 1e-14)
        before, after, *_ = self.transfer("interpolate")
        self.assertGreater(abs(after - before), 1e-8)

    def test_bounded_has_no_new_extrema(self):
        *_, low, high, least, greatest = self.transfer("bounded")
        self.assertGreaterEqual(least, low)
        self.assertLessEqual(greatest, high)

    def test_bamg_files(self):
        self.write("u.bb", f"2 1 {len(self.points)} 2\n"
                   + "\n".join(repr(x + 2 * y) for x, y in self.points) + "\n")
        done = self.run_command("transfer", "g.mesh", "u.bb", "h.mesh", "-o", "v.bb")
        self.assertEqual(done.returncode, 0, done.stderr)
        values = [float(w) for w in (self.folder / "v.bb").read_text().split()[4:]]
        exact = [x + 2 * y for x, y in grid(17)[0]]
        self.assertLess(max(abs(a - b) for a, b in zip(values, exact)), 1e-14)

    def test_what_is_refused(self):
        self.refused("transfer", "g.mesh", "u.sol", "h.mesh", "-o", "u.sol", sentence="used twice")
        self.refused("transfer", "h.mesh", "u.sol", "g.mesh", "-o", "v.sol",
                     sentence="values at 441 vertices, and the mesh has 324")
        self.refused("transfer", "g.mesh", "u.sol", "h.mesh", "-o", "v.txt", sentence=".sol, .solb or .bb")
        self.refused("transfer", "g.mesh", "u.sol", "no.mesh", "-o", "v.sol", sentence="no such file")
        points, triangles = grid(3, 5, 6)
        self.write("far.mesh", mesh_text(points, triangles))
        self.refused("transfer", "g.mesh", "u.sol", "far.mesh", "-o", "v.sol",
                     sentence="in a part that the old mesh does not touch")


if __name__ == "__main__":
    unittest.main()
