# SPDX-License-Identifier: MIT
"""Surfaces in space through the command. The witness of a deviation is confirmed here in rationals, from
the files alone and with no code of the program's."""
import json
import os
import random
import struct
import unittest
from fractions import Fraction as F
from math import comb

from command import CommandTest


def dot(a, b):
    return sum(x * y for x, y in zip(a, b))


def less(a, b):
    return [x - y for x, y in zip(a, b)]


def cross(a, b):
    return [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]


def squared_distance(p, t):
    """Returns the squared distance of a point from a triangle, exactly."""
    a, b, c = t
    n = cross(less(b, a), less(c, a))
    if dot(n, n) and all(dot(cross(less(y, x), less(p, x)), n) >= 0 for x, y in ((a, b), (b, c), (c, a))):
        return dot(less(p, a), n) ** 2 / dot(n, n)
    found = []
    for x, y in ((a, b), (b, c), (c, a)):
        e = less(y, x)
        s = min(max(dot(less(p, x), e) / dot(e, e), F(0)), F(1)) if dot(e, e) else F(0)
        d = less(p, [u + s * v for u, v in zip(x, e)])
        found.append(dot(d, d))
    return min(found)


def bernstein(n, i, t):
    return comb(n, i) * t ** i * (1 - t) ** (n - i)


def point_of(patch, u, v):
    """Returns the point of a Bezier patch without weights."""
    p, q = patch["degree"]
    at = [0, 0, 0]
    for i in range(p + 1):
        for j in range(q + 1):
            share = bernstein(p, i, u) * bernstein(q, j, v)
            at = [x + share * type(u)(c) for x, c in zip(at, patch["control"][i][j])]
    return at


def wavy():
    """Returns a bicubic patch over the unit square."""
    numbers = random.Random(5)
    return {"degree": [3, 3], "control": [[[i / 3, j / 3, numbers.uniform(-.35, .35)] for j in range(4)]
                                          for i in range(4)]}


def grid(patch, n):
    """Returns points on the patch and the triangles between them."""
    points = [point_of(patch, i / n, j / n) for i in range(n + 1) for j in range(n + 1)]
    triangles = []
    for i in range(n):
        for j in range(n):
            a = i * (n + 1) + j
            triangles += [(a, a + n + 1, a + n + 2), (a, a + n + 2, a + 1)]
    return points, triangles


def obj(points, triangles):
    return "".join("v %r %r %r\n" % tuple(p) for p in points) + "".join(
        "f %d %d %d\n" % tuple(v + 1 for v in t) for t in triangles)


def written(points, triangles):
    """Returns the mesh in every format, by file name. A float holds all coordinates."""
    corners = [[points[v] for v in t] for t in triangles]
    lines = lambda rows: "".join(" ".join(map(str, row)) + "\n" for row in rows)
    count, last = len(points), len(triangles)
    files = {"m.obj": obj(points, triangles)}
    files["text.stl"] = "solid m\n" + "".join(
        "facet normal 0 0 0\nouter loop\n" + "".join("vertex %r %r %r\n" % tuple(p) for p in t) +
        "endloop\nendfacet\n" for t in corners) + "endsolid m\n"
    files["m.stl"] = b"-" * 80 + struct.pack("<I", last) + b"".join(
        struct.pack("<12fH", 0, 0, 0, *(x for p in t for x in p), 0) for t in corners)
    head = ("ply\nformat %s 1.0\ncomment of a test\nelement vertex %d\nproperty %s x\nproperty %s y\n"
            "property %s z\nelement face %d\nproperty list uchar int vertex_indices\nend_header\n")
    files["text.ply"] = head % ("ascii", count, *3 * ["double"], last) + lines(points) + lines(
        (3, *t) for t in triangles)
    for order, mark in (("little", "<"), ("big", ">")):
        files[order + ".ply"] = (head % (f"binary_{order}_endian", count, *3 * ["float"], last)).encode() + b"".join(
            struct.pack(mark + "3f", *p) for p in points) + b"".join(
                struct.pack(mark + "B3i", 3, *t) for t in triangles)
    files["m.mesh"] = (f"MeshVersionFormatted 2\nDimension 3\nVertices\n{count}\n" + lines((*p, 0) for p in points) +
                       f"Triangles\n{last}\n" + lines((*(v + 1 for v in t), 7) for t in triangles) +
                       "Edges\n1\n1 2 0\nEnd\n")
    files["two.msh"] = ("$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\n%d\n" % count + lines(
        (i + 10, *p) for i, p in enumerate(points)) + "$EndNodes\n$Elements\n%d\n" % last + lines(
            (i + 1, 2, 2, 0, 1, *(v + 10 for v in t)) for i, t in enumerate(triangles)) + "$EndElements\n")
    files["four.msh"] = ("$MeshFormat\n4.1 0 8\n$EndMeshFormat\n$Nodes\n1 %d 1 %d\n2 1 0 %d\n" %
                         (count, count, count) + lines((i + 1,) for i in range(count)) + lines(points) +
                         "$EndNodes\n$Elements\n1 %d 1 %d\n2 1 2 %d\n" % (last, last, last) + lines(
                             (i + 1, *(v + 1 for v in t)) for i, t in enumerate(triangles)) + "$EndElements\n")
    array = lambda name, kind, values, more="": (
        f'<DataArray type="{kind}" Name="{name}" {more} format="ascii">' + " ".join(map(str, values)) + "</DataArray>")
    files["m.vtu"] = ('<?xml version="1.0"?><VTKFile type="UnstructuredGrid" version="0.1" '
                      'byte_order="LittleEndian"><UnstructuredGrid>'
                      f'<Piece NumberOfPoints="{count}" NumberOfCells="{last}"><Points>' +
                      array("Points", "Float64", [x for p in points for x in p], 'NumberOfComponents="3"') +
                      "</Points><Cells>" + array("connectivity", "Int64", [v for t in triangles for v in t]) +
                      array("offsets", "Int64", [3 * k + 3 for k in range(last)]) +
                      array("types", "UInt8", [5] * last) +
                      "</Cells></Piece></UnstructuredGrid></VTKFile>")
    return files


class Deviation(CommandTest):
    def answer(self, mesh, surface, *more, status=0):
        done = self.run_command("deviation", mesh, surface, "--json", *more)
        self.assertEqual(done.returncode, status, done.stderr)
        return json.loads(done.stdout)

    def test_witnesses_hold_in_rationals(self):
        patch = wavy()
        points, triangles = grid(patch, 4)
        self.write("s.json", json.dumps({"patches": [patch]}))
        self.write("m.obj", obj(points, triangles))
        found = self.answer("m.obj", "s.json")
        exact = [[[F(x) for x in points[v]] for v in t] for t in triangles]
        from_surface = found["surface_to_mesh"]
        at = point_of(patch, F(from_surface["witness"]["u"]), F(from_surface["witness"]["v"]))
        least = min(squared_distance(at, t) for t in exact)
        self.assertGreater(least, F(from_surface["low"]) ** 2)
        self.assertLessEqual(least, F(from_surface["high"]) ** 2)
        self.assertLessEqual(from_surface["high"], 1.011 * from_surface["low"])
        # Proves that no point of the surface is nearer to the other witness: samples it, and bounds each cell around
        # a sample by the length of its control polygon.
        from_mesh = found["mesh_to_surface"]
        a, b, c = exact[from_mesh["witness"]["triangle"] - 1]
        s, t = F(from_mesh["witness"]["s"]), F(from_mesh["witness"]["t"])
        at = [float(x + s * (y - x) + t * (z - x)) for x, y, z in zip(a, b, c)]
        sampled = min(dot(d, d) for i in range(201) for j in range(201)
                      for d in [less(at, point_of(patch, i / 200, j / 200))]) ** .5
        self.assertGreater(sampled, from_mesh["low"])
        self.assertLess(sampled, 1.2 * from_mesh["high"])

    def test_every_format_gives_the_same_answer(self):
        patch = {"degree": [1, 2], "control": [[[0, 0, 0], [0, 0.5, 1], [0, 1, 0]],
                                               [[1, 0, 0], [1, 0.5, 1], [1, 1, 0]]]}
        self.write("s.json", json.dumps({"patches": [patch]}))
        points, triangles = grid(patch, 2)
        answers = set()
        for name, content in written(points, triangles).items():
            self.write(name, content)
            found = self.answer(name, "s.json")
            answers.add((found["mesh_to_surface"]["high"], found["surface_to_mesh"]["high"]))
        self.assertEqual(len(answers), 1)
        # z = 2 y (1 - y) is 1/8 above a chord of half its width, measured along z; the chord's slope is 1.
        self.assertAlmostEqual(max(answers.pop()), .125 / 2 ** .5, delta=.001)

    def test_a_distance_is_proved_or_refused(self):
        self.write("plane.json", json.dumps({"patches": [
            {"degree": [1, 1], "control": [[[0, 0, 0], [0, 1, 0]], [[1, 0, 0], [1, 1, 0]]]}]}))
        self.write("m.obj", obj([(0, 0, .5), (1, 0, .5), (1, 1, .5), (0, 1, .5)], [(0, 1, 2), (0, 2, 3)]))
        self.assertEqual(self.answer("m.obj", "plane.json", "--at-most", "0.500001")["verdict"], "within")
        self.assertEqual(self.answer("m.obj", "plane.json", "--at-most", "0.49", status=1)["verdict"], "beyond")
        done = self.run_command("deviation", "m.obj", "plane.json", "--at-most", "0.4")
        self.assertEqual(done.returncode, 1)
        self.assertIn("REFUSED: farther than 0.4", done.stdout)
        # A mesh of half of the surface lies on it. The other half of the surface is far from the mesh.
        self.write("half.obj", obj([(0, 0, 0), (1, 0, 0), (1, 1, 0)], [(0, 1, 2)]))
        found = self.answer("half.obj", "plane.json")
        self.assertLess(found["mesh_to_surface"]["high"], 1e-9)
        self.assertAlmostEqual(found["surface_to_mesh"]["low"], .5 ** .5, delta=.01)

    def test_a_spline_is_what_its_bezier_pieces_are(self):
        control = [[[0, 0, 0], [0, 1, 0]], [[1, 0, 2], [1, 1, 2]], [[3, 0, -1], [3, 1, -1]], [[4, 0, 0], [4, 1, 0]]]
        spline = {"degree": [2, 1], "knots_u": [0, 0, 0, .5, 1, 1, 1], "control": control}
        middle = [[(x + y) / 2 for x, y in zip(p, q)] for p, q in zip(control[1], control[2])]
        pieces = [{"degree": [2, 1], "control": [control[0], control[1], middle]},
                  {"degree": [2, 1], "control": [middle, control[2], control[3]]}]
        self.write("spline.json", json.dumps({"patches": [spline]}))
        self.write("pieces.json", json.dumps({"patches": pieces}))
        self.write("m.obj", obj([(0, 0, 0), (4, 0, 0), (4, 1, 0), (0, 1, 0)], [(0, 1, 2), (0, 2, 3)]))
        one, two = self.answer("m.obj", "spline.json"), self.answer("m.obj", "pieces.json")
        for way in ("mesh_to_surface", "surface_to_mesh"):
            self.assertAlmostEqual(one[way]["high"], two[way]["high"])
            self.assertAlmostEqual(one[way]["low"], two[way]["low"])

    def test_bytes_do_not_depend_on_threads(self):
        self.write("m.obj", obj(*grid(wavy(), 6)))
        self.write("s.json", json.dumps({"patches": [wavy()]}))
        self.assertEqual(len({self.run_command("deviation", "m.obj", "s.json", "--json", "--threads", n).stdout
                              for n in (1, 2, 7)}), 1)

    def test_bad_input_is_refused_by_name(self):
        good = {"degree": [1, 1], "control": [[[0, 0, 0], [0, 1, 0]], [[1, 0, 0], [1, 1, 0]]]}
        self.write("m.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n")
        self.write("s.json", json.dumps({"patches": [good]}))
        spoiled = [({"weights": [[1, 0], [1, 1]]}, "control point 1, 2: its weight is 0"),
                   ({"weights": [[1, 1], [-1, 1]]}, "control point 2, 1: its weight is -1"),
                   ({"weights": [[1, 1]]}, '"weights" must be 2 rows'),
                   ({"control": [[[1, 1, 1]] * 2] * 2}, "all control points are one point"),
                   ({"control": [[[0, 0, 0], [0, 1, 0]], [[1, 0, 0]]]}, 'row 2 of "control" has 1 points'),
                   ({"control": [[[0, 0], [0, 1]], [[1, 0], [1, 1]]]}, "control point 1, 1 has 2 numbers"),
                   ({"degree": [2, 1]}, "2 control points in u"),
                   ({"degree": "3"}, '"degree" must be'),
                   ({"knots_u": [0, 0, 1]}, "3 knots in u"),
                   ({"knots_v": [0, 1, 0, 1]}, "knot 3 in v is below"),
                   ({"trims": []}, '"trims" is no part of a patch'),
                   ({"loops": [[{"control": [[0, 0], [1, 0], [0, 1], [0, 0]]}]]}, "is trimmed, which deviation"),
                   ({"colour": 1}, '"colour" is no part of a patch')]
        for change, said in spoiled:
            self.write("bad.json", json.dumps({"patches": [{**good, **change}]}))
            done = self.run_command("deviation", "m.obj", "bad.json")
            self.assertEqual(done.returncode, 2, change)
            self.assertIn(said, done.stderr)
            self.assertIn("patch 1", done.stderr)
        for name, content, said in [("m.xyz", "", "name does not say"), ("no.obj", None, "no such file"),
                                    ("out.obj", "v 0 0 0\nf 1 2 3\n", "vertex 2 does not exist"),
                                    ("flat.mesh", "MeshVersionFormatted 2\nDimension 2\n", "dimension"),
                                    ("quad.msh", "$MeshFormat\n3 0 8\n", "version"),
                                    ("short.ply", "ply\nformat ascii 1.0\n", "end_header is missing"),
                                    ("no.stl", "facets", "no .stl file"),
                                    ("empty.obj", "v 0 0 0\n", "no triangle"),
                                    ("far.obj", "v 0 0 1e305\nv 1 0 0\nv 0 1 0\nf 1 2 3\n", "out of range")]:
            if content is not None:
                self.write(name, content)
            done = self.run_command("deviation", name, "s.json")
            self.assertEqual(done.returncode, 2, name)
            self.assertIn(said, done.stderr)
            self.assertIn(name, done.stderr)
        self.assertEqual(self.run_command("deviation", "m.obj", "cone").returncode, 2)


class Surface(CommandTest):
    def make(self, *arguments, status=0):
        done = self.run_command("surface", *arguments)
        self.assertEqual(done.returncode, status, done.stdout + done.stderr)
        return done.stdout

    def test_a_mesh_is_certified_and_two_ways_agree(self):
        said = self.make("saddle", "--chord", "0.05", "-o", "s.mesh", "-o", "s.obj")
        self.assertIn("certified: ", said)
        self.assertEqual(self.files(), ["s.certificate.json", "s.mesh", "s.obj"])
        claim = json.loads((self.folder / "s.certificate.json").read_text())
        self.assertLessEqual(claim["distance"], 0.05)
        # `deviation` sees the mesh in space alone, and not the plane meshes.
        done = self.run_command("deviation", "s.obj", "saddle", "--at-most", "0.05", "--json")
        self.assertEqual(done.returncode, 0, done.stdout)
        found = json.loads(done.stdout)
        low = max(found["mesh_to_surface"]["low"], found["surface_to_mesh"]["low"])
        self.assertLessEqual(low, claim["distance"])
        self.assertLessEqual(claim["distance"], 1.04 * low)
        self.assertEqual(self.run_command("verify", "s.mesh", "--domain", "saddle").returncode, 0)
        self.assertEqual(self.run_command("verify", "s.mesh", "--domain", "octant").returncode, 1)
        self.assertEqual(self.run_command("verify", "s.mesh", "--metric", "swirl:3").returncode, 2)

    def test_no_surface_ends_a_little_beyond_the_chord(self):
        # A mesh made anew has other triangles whose distance exceeds the chord. Before vertices were kept, the rounds
        # of the saddle ended at 0.0065.
        self.write("wavy.json", json.dumps({"patches": [wavy()]}))
        for surface, chord in (("wavy.json", 0.01), ("saddle", 0.006), ("octant", 0.01), ("wing", 0.003),
                               ("torus", 0.01)):
            self.make(surface, "--chord", chord, "-o", "s.mesh")
            claim = json.loads((self.folder / "s.certificate.json").read_text())
            self.assertTrue(claim["certified"] and claim["complete"], surface)
            self.assertLessEqual(claim["distance"], chord)
            self.assertEqual(self.run_command("verify", "s.mesh").returncode, 0)

    def test_bends_sharper_than_the_chord_are_not_folded_over(self):
        # A lip of radius 0.03 along a quarter of a circle, with a chord tolerance as large.
        def turned(radius, height):
            c = radius * 0.5522847498
            return [[radius, 0, height], [radius, c, height], [c, radius, height], [0, radius, height]]
        profile = [(1, 0), (1, 0.08), (0.94, 0.08), (0.94, 0)]
        self.write("lip.json", json.dumps({"patches": [
            {"degree": [3, 3], "control": [turned(r, h) for r, h in profile]}]}))
        self.assertIn("nowhere folded", self.make("lip.json", "--chord", "0.03", "-o", "lip.obj"))

    def test_crossing_triangles_are_named_where_that_is_asked(self):
        self.assertIn("no two triangles cross", self.make("octant", "--chord", "0.05", "--no-crossings", "-o", "o.mesh"))
        self.assertEqual(self.run_command("verify", "o.mesh").returncode, 0)
        flat = {"degree": [1, 1], "control": [[[0, 0, 0], [0, 1, 0]], [[1, 0, 0], [1, 1, 0]]]}
        upright = {"degree": [1, 1], "control": [[[.5, .2, -1], [.5, .8, -1]], [[.5, .2, 1], [.5, .8, 1]]]}
        self.write("two.json", json.dumps({"patches": [flat, upright]}))
        self.make("two.json", "--chord", "0.1", "-o", "two.obj")
        self.assertRegex(self.make("two.json", "--chord", "0.1", "--no-crossings", "-o", "two.obj", status=1),
                         r"triangles \d+ and \d+ in space cross each other")

    def test_cusps_loops_and_curves_are_named(self):
        drawn = lambda *places: {"patches": [{"degree": [len(places) - 1, 1], "control": [
            [[x, y, 0], [x, y, 1]] for x, y in places]}]}
        self.write("cusp.json", json.dumps(drawn((0, 0), (1, 1), (0, 1), (1, 0))))
        said = self.make("cusp.json", "--chord", "0.02", "-o", "cusp.obj", status=1)
        self.assertRegex(said, r"triangle \d+: it is not proved that the surface is not folded over it")
        self.write("loop.json", json.dumps(drawn((0, 0), (2, 1), (-1, 1), (1, 0))))
        self.make("loop.json", "--chord", "0.02", "-o", "loop.obj")
        self.assertRegex(self.make("loop.json", "--chord", "0.02", "--no-crossings", "-o", "loop.obj", status=1),
                         r"triangles \d+ and \d+ in space cross each other")
        there_and_back = drawn((0, 0), (1, 0), (0, 0))
        line = {"patches": [{"degree": [1, 1], "control": [[[0, 0, 0]] * 2, [[1, 0, 0]] * 2]}]}
        for curve in (there_and_back, line):
            self.write("curve.json", json.dumps(curve))
            done = self.run_command("surface", "curve.json", "--chord", "0.02", "-o", "curve.obj")
            self.assertEqual(done.returncode, 2)
            self.assertIn("curve.json: no triangle has three corners in space", done.stderr)

    def test_a_surface_that_is_folded_itself_ends_soon_and_says_where(self):
        # A fold of the surface itself stays folded in finer meshes. Refinement must give up early: going on takes four
        # times as many vertices in vain.
        for name, corners in (("crossed", [[[0, 0, 0], [0, 1, 0]], [[1, 1, 0], [1, 0, 0]]]),
                              ("askew", [[[0, 0, 0], [0, 1, 0]], [[1, .7, 0], [1, .2, 0]]])):
            self.write(name + ".json", json.dumps({"patches": [{"degree": [1, 1], "control": corners}]}))
            said = self.make(name + ".json", "--chord", "0.01", "-o", name + ".mesh", status=1)
            self.assertRegex(said, r"not reached: the surface itself turns round at u = [0-9.]+, v = [0-9.]+ of patch 1")
            self.assertRegex(said, r"triangle \d+: it is not proved that the surface is not folded over it")
            self.assertRegex(said, r"not certified: \d\d vertices")
            self.assertEqual(self.run_command("verify", name + ".mesh").returncode, 1)

    def test_last_digits_of_a_surface_do_not_change_the_count(self):
        self.make("torus", "--chord", "0.05", "-o", "t.mesh")
        torus = json.loads((self.folder / "t.certificate.json").read_text())["surface"]
        counts = set()
        for seed in range(3):
            draw, moved = random.Random(seed), json.loads(json.dumps(torus))
            for point in (p for patch in moved["patches"] for row in patch["control"] for p in row):
                point[:] = [x * (1 + draw.uniform(-1e-15, 1e-15)) for x in point]
            self.write("moved.json", json.dumps(moved))
            self.make("moved.json", "--chord", "0.003", "-o", "moved.obj")
            counts.add((self.folder / "moved.obj").read_text().count("\nv "))
        self.assertEqual(len(counts), 1, counts)

    def test_a_number_of_vertices_is_met_and_proved(self):
        said = self.make("torus", "--chord", "0.004", "--vertices", "700", "-o", "t.mesh")
        count = int(said.split("certified: ")[1].split()[0])
        self.assertAlmostEqual(count, 700, delta=21)
        said = self.make("torus", "--chord", "0.0004", "--vertices", "700", "-o", "t.mesh", status=1)
        self.assertRegex(said, r"the mesh is proved within [0-9.e-]+ of the surface, and 0.0004 is asked: see triangle")
        self.assertEqual(self.run_command("verify", "t.mesh").returncode, 1)

    def test_pictures_are_drawn_and_are_the_same_every_time(self):
        names = ["o.png", "o.svg", "o.pdf"]
        self.make("octant", "--chord", "0.05", *(word for name in names for word in ("-o", name)))
        first = [(self.folder / name).read_bytes() for name in names]
        self.assertEqual([one[:4] for one in first], [b"\x89PNG", b"<?xm", b"%PDF"])
        triangles = self.make("octant", "--chord", "0.05", "-o", "o.svg", "-o", "o.obj").split(" triangles")[0].split()[-1]
        # Draws a filled outline for each triangle, on a page of paper.
        self.assertEqual(first[1].count(b"stroke-width"), int(triangles))
        self.make("octant", "--chord", "0.05", "--threads", "1", *(word for name in names for word in ("-o", name)))
        self.assertEqual([(self.folder / name).read_bytes() for name in names], first)

    def test_a_page_holds_the_mesh_and_what_was_proved(self):
        self.make("octant", "--chord", "0.05", "-o", "o.html", "-o", "o.mesh")
        page = (self.folder / "o.html").read_text()
        self.assertIn("asterism verify o.mesh", page)
        self.assertIn('"certified": true', page)
        self.assertNotIn("://", page)

    def test_every_format_with_vertices_is_verified(self):
        """Files without numbers of faces are refused. `verify` must not end by a signal."""
        for ending in ("obj", "ply", "vtu", "msh", "mesh"):
            with self.subTest(ending):
                self.make("octant", "--chord", "0.05", "-o", f"o.{ending}", "--certificate", "c.json")
                done = self.run_command("verify", f"o.{ending}", "--certificate", "c.json")
                self.assertEqual(done.returncode, 0, done.stdout + done.stderr)
        self.make("octant", "--chord", "0.05", "-o", "o.stl", "-o", "alone.obj", "--certificate", "c.json")
        done = self.run_command("verify", "o.stl", "--certificate", "c.json")
        self.assertEqual(done.returncode, 2)
        self.assertIn("asterism deviation", done.stderr)
        done = self.run_command("verify", "alone.obj")
        self.assertEqual(done.returncode, 2)
        self.assertIn("without a certificate", done.stderr)
        lines = (self.folder / "alone.obj").read_text().split("\n")
        (self.folder / "cut.obj").write_text("\n".join(lines[:-3]) + "\n")
        self.assertEqual(self.run_command("verify", "cut.obj", "--certificate", "c.json").returncode, 1)

    def test_two_patches_share_their_edge(self):
        left = {"degree": [2, 2], "control": [[[i, j, (i - 1) ** 2 * .3 + j % 2 * .4] for j in range(3)]
                                              for i in range(3)]}
        # u runs from its greatest value to its least, so that the edge runs the other way and the patch is seen from
        # below.
        right = {"degree": [2, 2], "control": [[[i, j, (i - 3) ** 2 * .3 + j % 2 * .4] for j in range(3)]
                                               for i in (4, 3, 2)]}
        self.write("s.json", json.dumps({"patches": [left, right]}))
        self.make("s.json", "--chord", "0.02", "-o", "s.mesh")
        claim = json.loads((self.folder / "s.certificate.json").read_text())
        self.assertEqual(claim["euler"], 1)
        self.assertEqual([f["reversed"] for f in claim["faces"]], [False, True])
        self.assertEqual(self.run_command("verify", "s.mesh").returncode, 0)

    def triangles_of(self, name):
        """Returns the triangles as texts of their corners, each from its least corner on, sorted."""
        rows = [line.split() for line in (self.folder / name).read_text().split("\n") if line]
        points = [tuple(row[1:]) for row in rows if row[0] == "v"]
        corners = [[points[int(v) - 1] for v in row[1:]] for row in rows if row[0] == "f"]
        return sorted(c[c.index(min(c)):] + c[:c.index(min(c))] for c in corners)

    def test_the_order_of_patches_does_not_matter(self):
        # Four patches meet in a corner, and one of them is given from behind. The two patches of a side evaluate it
        # to different last digits.
        heights = [[random.Random(f"{i} {j}").uniform(-.4, .4) for j in range(5)] for i in range(5)]
        net = lambda rows, columns: [[[i * .7, j * .3, heights[i][j]] for j in columns] for i in rows]
        low, high = (0, 1, 2), (2, 3, 4)
        patches = [{"degree": [2, 2], "control": net(*of)}
                   for of in ((low, low), (high, low), (high[::-1], high), (low, high))]
        found = []
        for order in ((0, 1, 2, 3), (3, 2, 1, 0), (2, 0, 3, 1)):
            self.write("s.json", json.dumps({"patches": [patches[k] for k in order]}))
            for more in ((), ("--vertices", "60")):
                done = self.run_command("surface", "s.json", "--chord", "0.03", *more, "-o", "s.obj")
                self.assertIn(done.returncode, (0, 1), done.stderr)
                found.append(self.triangles_of("s.obj"))
        self.assertEqual(found[0], found[2])
        self.assertEqual(found[0], found[4])
        self.assertEqual(found[1], found[3])
        self.assertEqual(found[1], found[5])

    def test_units_of_a_parameter_do_not_matter(self):
        wave = wavy()
        bytes_of = set()
        for low, high in ((0, 1), (0, 2 ** 20), (0, 1e4), (-3, 0.7)):
            patch = {**wave, "knots_u": [low] * 4 + [high] * 4, "knots_v": [0] * 4 + [1] * 4}
            self.write("s.json", json.dumps({"patches": [patch]}))
            done = self.run_command("surface", "s.json", "--chord", "0.02", "-o", "s.mesh")
            self.assertEqual(done.returncode, 0, done.stderr)
            self.assertEqual("patch 1: u, from" in done.stderr, (low, high) != (0, 1))
            bytes_of.add((self.folder / "s.mesh").read_bytes()
                         + (self.folder / "s.certificate.json").read_bytes())
            self.assertEqual(self.run_command("verify", "s.mesh", "--domain", "s.json").returncode, 0)
        self.assertEqual(len(bytes_of), 1)

    def test_units_of_a_spline_in_powers_of_two_do_not_matter(self):
        wave = wavy()
        bytes_of = set()
        for scale in (1, 2 ** 20):
            control = wave["control"] + [[[x + 1, y, z] for x, y, z in row] for row in wave["control"][1:3]]
            patch = {**wave, "control": control,
                     "knots_u": [0] * 4 + [scale / 4, scale / 2] + [scale] * 4}
            self.write("s.json", json.dumps({"patches": [patch]}))
            self.make("s.json", "--chord", "0.05", "-o", "s.obj")
            bytes_of.add((self.folder / "s.obj").read_bytes())
        self.assertEqual(len(bytes_of), 1)

    def test_bytes_do_not_depend_on_threads(self):
        bytes_of = set()
        for threads in (1, 2, 7):
            self.make("octant", "--chord", "0.03", "--threads", threads, "-o", "s.mesh")
            bytes_of.add((self.folder / "s.mesh").read_bytes() + (self.folder / "s.certificate.json").read_bytes())
        self.assertEqual(len(bytes_of), 1)

    def test_spoiled_meshes_and_certificates_are_refused(self):
        self.make("saddle", "--chord", "0.2", "-o", "s.mesh")
        mesh = (self.folder / "s.mesh").read_text().split("\n")
        claim = (self.folder / "s.certificate.json").read_text()
        points, triangles = mesh.index("Vertices") + 2, mesh.index("Triangles") + 2
        count, last = int(mesh[points - 1]), int(mesh[triangles - 1])
        draw = random.Random(44)
        for k in range(int(os.environ.get("ASTERISM_SPOILED", "40"))):
            lines, text = list(mesh), claim
            at = triangles + draw.randrange(last)
            how = k % 5
            if how == 0:  # moves a vertex by twice the distance
                v = points + draw.randrange(count)
                x = list(map(float, lines[v].split()))
                x[draw.randrange(3)] += draw.choice((-.4, .4))
                lines[v] = "%r %r %r 0" % tuple(x[:3])
            elif how == 1:  # turns a triangle over
                a, b, c, f = lines[at].split()
                lines[at] = f"{b} {a} {c} {f}"
            elif how == 2:  # drops a triangle
                del lines[at]
                lines[triangles - 1] = str(last - 1)
            elif how == 3:  # forges a number of the certificate
                name = draw.choice(("chord", "distance", "vertices", "triangles", "euler", "open_edges",
                                    "vertex_distance", "normal_tangent", "least_angle"))
                start = text.index(f'"{name}": ') + len(name) + 4
                end = text.index(",", start)
                number = float(text[start:end])
                number = number / 3 if name in ("chord", "distance") else number + draw.choice((1, 2, .5))
                text = text[:start] + (str(int(number)) if name in ("vertices", "triangles", "euler", "open_edges")
                                       and number == int(number) else repr(number)) + text[end:]
            else:  # cracks an edge: doubles a vertex of one triangle, in both files
                corners = lines[at].split()
                v = int(corners[0])
                lines.insert(points + count, lines[points + v - 1])
                lines[points - 1] = str(count + 1)
                lines[at + 1] = " ".join([str(count + 1)] + corners[1:])
            self.write("s.mesh", "\n".join(lines))
            self.write("s.certificate.json", text)
            done = self.run_command("verify", "s.mesh")
            self.assertNotEqual(done.returncode, 0, f"{k}: {done.stdout}")

    def test_counts_that_are_not_whole_are_refused(self):
        # A reader that truncates numbers reads 9.5 vertices as 9.
        self.make("saddle", "--chord", "0.2", "-o", "s.mesh")
        claim = (self.folder / "s.certificate.json").read_text()
        for name in ("vertices", "triangles", "edges", "open_edges", "collapsed", "euler"):
            start = claim.index(f'"{name}": ') + len(name) + 4
            end = claim.index(",", start)
            number = int(claim[start:end])
            for written in (f"{number}.5", f"{number}.0", f"{number}e0", f'"{number}"', str(number + 2 ** 64), "null"):
                self.write("s.certificate.json", claim[:start] + written + claim[end:])
                done = self.run_command("verify", "s.mesh")
                self.assertIn(done.returncode, (1, 2), f"{name}: {written}: {done.stdout}")
        self.write("s.certificate.json", claim)
        self.assertEqual(self.run_command("verify", "s.mesh").returncode, 0)

    def test_bad_input_is_refused_by_name(self):
        self.write("fan.json", json.dumps({"patches": [
            {"degree": [1, 1], "control": [[[0, 0, 0], [1, 0, 0]], [p, [x + y for x, y in zip(p, (1, 0, 0))]]]}
            for p in ([0, 1, 0], [0, 0, 1], [0, -1, 1])]}))
        done = self.run_command("surface", "fan.json", "--chord", "0.1", "-o", "no.obj")
        self.assertEqual(done.returncode, 2)
        self.assertIn("patches 1, 2 and 3 have one side in common", done.stderr)
        for name in ("part.step", "part.STP", "part.brep", "part.igs"):
            done = self.run_command("surface", name, "--chord", "0.1", "-o", "no.obj")
            self.assertEqual(done.returncode, 2)
            self.assertIn(name + ": files of CAD programs are not read", done.stderr)
        for arguments in (["torus", "-o", "no.obj"], ["torus", "--chord", "0", "-o", "no.obj"],
                          ["torus", "--chord", "0.1", "-o", "no.xyz"], ["cone", "--chord", "0.1", "-o", "no.obj"]):
            self.assertEqual(self.run_command("surface", *arguments).returncode, 2, arguments)
        self.assertEqual(self.files(), ["fan.json"])

    def test_distances_that_no_mesh_can_have_are_refused_before_any_is_made(self):
        """Refuses distances below what doubles can prove, also far from the origin, and distances for which too many
        vertices would be needed."""
        far = 2.0 ** 30  # coordinates have a last bit of 2^-23
        self.write("far.json", json.dumps({"patches": [
            {"degree": [1, 1], "control": [[[far, 0, 0], [far, 1, 0]], [[far + 1, 0, 0], [far + 1, 1, 1]]]}]}))
        for name, chord, said in (("torus", "1e-300", r"the distance 1e-300 is below 1\.3e-12, the least"),
                                  ("teapot", "1e-13", r"the distance 1e-13 is below 6\.\d+e-12, the least"),
                                  ("far.json", "2e-7", r"the distance 2e-07 is below 2\.38e-07, the least"),
                                  ("torus", "1e-7", r"take about \d\.\d+e\+06 vertices, and at most 1000000 are made"),
                                  ("saddle", "1e-9", r"take about \d\.\d+e\+08 vertices, and at most 1000000")):
            with self.subTest(name=name, chord=chord):
                done = self.run_command("surface", name, "--chord", chord, "-o", "no.obj")
                self.assertEqual(done.returncode, 2, done.stdout + done.stderr)
                self.assertRegex(done.stderr, said)
        done = self.run_command("surface", "torus", "--chord", "1e-7", "--vertices", "100", "-o", "some.obj")
        self.assertEqual(done.returncode, 1, done.stderr)
        self.assertEqual(self.run_command("surface", "far.json", "--chord", "0.1", "-o", "far.obj").returncode, 0)
        self.assertEqual(self.files(), ["far.json", "far.obj", "some.obj"])


if __name__ == "__main__":
    unittest.main()
