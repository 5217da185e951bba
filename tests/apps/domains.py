# SPDX-License-Identifier: MIT
"""Domains of every kind through the real command: what is meshed, what is refused and why, and
what becomes of markers and regions in the files."""
import base64
import json
import pathlib
import re
import struct
import unittest

import command


class Shape:
    """A .poly file being put together."""

    def __init__(self):
        self.points, self.segments, self.holes, self.regions = [], [], [], []

    def chain(self, points, marker, closed=False):
        first = len(self.points) + 1
        self.points += points
        last = first + len(points) - 1
        self.segments += [(v, v + 1, marker) for v in range(first, last)]
        if closed:
            self.segments.append((last, first, marker))
        return self

    def ring(self, points, marker=1):
        return self.chain(points, marker, closed=True)

    def point(self, x, y):
        self.points.append((x, y))
        return self

    def hole(self, x, y):
        self.holes.append((x, y))
        return self

    def region(self, *numbers):
        self.regions.append(numbers)
        return self

    def text(self):
        sections = [("2 0 0", self.points), ("1", self.segments), ("", self.holes)]
        if self.regions:
            sections.append(("", self.regions))
        lines = []
        for header, rows in sections:
            lines.append(f"{len(rows)} {header}")
            lines += [" ".join(map(str, (number, *row))) for number, row in enumerate(rows, 1)]
        return "\n".join(lines) + "\n"


def box(x0, y0, x1, y1):
    return [(x0, y0), (x1, y0), (x1, y1), (x0, y1)]


def square():
    return Shape().ring(box(-1, -1, 1, 1))


def kinds():
    diagonal = square()
    diagonal.segments.append((1, 3, 5))
    yield "diagonal", diagonal
    yield "dangling", square().chain([(0, -1), (0.125, 0.25)], 5).chain([(-0.5, 0.5), (-0.25, 0.75)], 6)
    yield "isolated", square().point(0.3, 0.2)
    yield "two components", square().ring([(2, 0), (3, 0), (3, 1)], 2)
    yield "island", (Shape().ring(box(0, 0, 8, 8)).ring(box(1, 1, 7, 7)).ring(box(3, 3, 5, 5))
                     .hole(2, 2))
    yield "touching", (Shape().ring(box(0, 0, 4, 4)).ring(box(4, 4, 6, 6))
                       .ring([(0, 2), (1, 1), (1.5, 2), (1, 3)]).hole(0.75, 2))
    yield "ring in a ring", Shape().ring(box(0, 0, 4, 4)).ring(box(1, 1, 3, 3), 7)
    yield "common side", Shape().ring(box(0, 0, 1, 1)).ring(box(1, 0, 2, 1), 2)
    yield "fan", (square().chain([(0, 0), (0.75, 0)], 5).chain([(0, 0), (0.75, 0.1)], 6)
                  .chain([(-0.7, 0.3), (0, 0)], 7))


# Cause, domain, and a pattern that the message matches: it names both places where two are at fault.
REFUSED = [
    ("crossing inside", square().chain([(-0.5, 0), (0.5, 0)], 0).chain([(0, -0.5), (0, 0.5)], 0),
     r"in\.poly:16: segment 6 .*crosses segment 5 .*line 15"),
    ("open ring", Shape().chain(box(0, 0, 1, 1), 0),
     r"not closed.*vertex 1 \(0, 0\).*segment 1 .*vertex 4 \(0, 1\).*segment 3 "),
    ("open ring with a hole point", square().chain([(-.5, -.5), (.5, -.5), (.5, .5)], 0).hole(.4, .0),
     r"not closed.*vertex 5 .*vertex 7 "),
    ("chain that sticks out", square().chain([(1, 0), (2, 0)], 0), r"not closed.*vertex 6 .*vertex 5 "),
    ("segment beside everything", square().chain([(3, 0), (4, 0)], 0), r"not closed.*vertex 5 .*vertex 6 "),
    ("nothing enclosed", Shape().chain([(0, 0), (1, 0)], 0).chain([(1, 0), (0, 0)], 0), r"enclose nothing"),
    ("region outside", square().region(5, 5, 1), r"in\.poly:13: region 1 \(5, 5\).*outside"),
    ("region on a segment", square().region(1, 0, 1), r"region 1 \(1, 0\) lies on segment 2 .*line 8"),
    ("region in a hole", square().ring(box(-.5, -.5, .5, .5)).hole(0, .25).region(0, 0, 1),
     r"region 1 .*hole"),
    ("one region, two numbers", square().region(0, 0, 1).region(.5, .5, 2), r"region 2 .*region 1 .*different"),
    ("region that is no number", square().region(0, 0, "one"), r"in\.poly:13: .*'one'"),
]


# Domains that are refused, and meshed with --repair-domain; and what is then said of the repair.
DIRTY = [
    ("crossing inside", square().chain([(-0.5, 0), (0.5, 0.1)], 0).chain([(0, -0.5), (0.1, 0.5)], 0),
     "1 crossings made vertices, 0 vertices joined"),
    ("a gap", Shape().chain([(0, 0), (1, 0), (1, 1), (0, 1), (1e-7, 1e-6)], 3), "1 vertices joined"),
    ("an end beside a segment", square().ring([(1 + 1e-9, 0), (2, -0.5), (2, 0.5)])
     .chain([(1.5, -0.2), (1.5, 0.7)], 0), "1 crossings made vertices.*1 cut off"),
    ("a ring across itself", Shape().ring([(0, 0), (4, 0), (0, 3), (4, 3.5)]), "1 crossings"),
    ("two rings across each other", Shape().ring(box(0, 0, 3, 3)).ring(box(1, 1, 4, 4.5)), "2 crossings"),
    ("beyond the wall", square().chain([(0, 0), (1.5, 0.25)], 5), "1 crossings.*1 cut off"),
]


class Domains(command.CommandTest):
    def mesh(self, shape, *more):
        self.write("in.poly", shape.text())
        return self.run_command("mesh", "in.poly", "-o", "m.mesh", "-o", "m.vtu", "-o", "m.svg", *more)

    def section(self, keyword):
        lines = (self.folder / "m.mesh").read_text().splitlines()
        at = lines.index(keyword)
        return [line.split() for line in lines[at + 2:at + 2 + int(lines[at + 1])]]

    def test_every_kind_is_meshed_certified_and_verified(self):
        for name, shape in kinds():
            with self.subTest(name):
                done = self.mesh(shape)
                self.assertEqual(done.returncode, 0, done.stdout + done.stderr)
                self.assertRegex(done.stdout, "certified")
                for more in ([], ["--domain", "in.poly"]):
                    verdict = self.run_command("verify", "m.mesh", *more)
                    self.assertEqual(verdict.returncode, 0, verdict.stdout + verdict.stderr)

    def test_a_dirty_domain_meshes_with_one_option(self):
        for name, shape, done_so in DIRTY:
            with self.subTest(name):
                refused = self.mesh(shape)
                self.assertEqual(refused.returncode, 2)
                self.assertRegex(refused.stderr, "--repair-domain mends it: .*" + done_so)
                done = self.mesh(shape, "--repair-domain", "--angle-bound", "5")
                self.assertEqual(done.returncode, 0, done.stdout + done.stderr)
                self.assertRegex(done.stdout, "repaired: .*" + done_so)
                options = json.loads((self.folder / "m.certificate.json").read_text())["asked"]["options"]
                self.assertRegex(options["repair-done"], done_so)
                self.assertNotEqual(options["repair-places"], "none")
                # The removed end of a segment may lie outside of the picture.
                rings = (self.folder / "m.svg").read_text().count("rgb(75%,0%,13%)")
                self.assertIn(rings, range(1, options["repair-places"].count(";") + 2))
                for more in ([], ["--domain", "in.poly"]):
                    verdict = self.run_command("verify", "m.mesh", *more)
                    self.assertEqual(verdict.returncode, 0, verdict.stdout + verdict.stderr)

    def test_a_distance_needs_the_repair_and_room(self):
        self.assertEqual(self.mesh(square(), "--repair-distance", "0.1").returncode, 2)
        too_small = self.mesh(square(), "--repair-domain", "--repair-distance", "1e-17")
        self.assertRegex(too_small.stderr, "at least .*no finer steps")
        self.assertEqual(too_small.returncode, 2)

    def test_what_is_refused_names_both_places(self):
        for name, shape, pattern in REFUSED:
            with self.subTest(name):
                done = self.mesh(shape)
                self.assertEqual(done.returncode, 2, done.stdout + done.stderr)
                self.assertRegex(done.stderr, r"\Aasterism: in\.poly:")
                self.assertRegex(done.stderr, pattern)
                self.assertEqual(self.files(), ["in.poly"])

    def test_repairs_are_counted_and_said(self):
        shape = square().chain([(-1, 0), (0, 0)], 3).chain([(-1, 0), (0.5, 0)], 4).point(0.5, 0)
        done = self.mesh(shape)
        self.assertEqual(done.returncode, 0, done.stderr)
        for words in ("repeated vertices merged: 2", "segments split at vertices on them: 2",
                      "overlapping segments united: 1"):
            self.assertIn(words, done.stderr)
        markers = {edge[2] for edge in self.section("Edges")}
        self.assertEqual(markers, {"1", "3", "4"})

    def test_markers_of_internal_segments_are_on_edges_with_two_triangles(self):
        done = self.mesh(dict(kinds())["dangling"], "--size", "0.3")
        self.assertEqual(done.returncode, 0, done.stderr)
        corners = [t[:3] for t in self.section("Triangles")]
        sides = [frozenset((t[i], t[i - 1])) for t in corners for i in range(3)]
        count = {marker: set() for marker in "156"}
        for a, b, marker in self.section("Edges"):
            count[marker].add(sides.count(frozenset((a, b))))
        self.assertEqual(count, {"1": {1}, "5": {2}, "6": {2}})
        self.assertGreater(len(self.section("Edges")), 30)

    def test_regions_of_the_file_are_the_references_of_the_triangles(self):
        shape = Shape().ring(box(0, 0, 4, 4)).ring(box(1, 1, 3, 3), 7).region(2, 2, 12.0, 0.5)
        done = self.mesh(shape)
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertIn("limits on areas of triangles dropped: 1", done.stderr)
        points = [list(map(float, v[:2])) for v in self.section("Vertices")]
        for *corners, region in self.section("Triangles"):
            x, y = (sum(points[int(v) - 1][i] for v in corners) / 3 for i in (0, 1))
            inner = 1 < x < 3 and 1 < y < 3
            self.assertEqual(region, "12" if inner else "0")
        array = re.search(rb'Name="region"[^>]*>\s*([^<\s]+)\s*<', (self.folder / "m.vtu").read_bytes())[1]
        data = base64.b64decode(array)
        count = struct.unpack_from("<Q", data)[0] // 4
        cells = struct.unpack_from(f"<{count}i", data, 8)
        self.assertEqual([str(n) for n in cells], [t[3] for t in self.section("Triangles")])

    def test_all_regions_numbered(self):
        shape = dict(kinds())["ring in a ring"].region(2, 2, 1)
        done = self.mesh(shape, "--regions")
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertEqual({t[3] for t in self.section("Triangles")}, {"1", "2"})
        options = json.loads((self.folder / "m.certificate.json").read_text())["asked"]["options"]
        self.assertEqual(options["regions"], "numbered")
        for arguments, status in ((["--domain", "in.poly", "--regions"], 0), (["--domain", "in.poly"], 1)):
            verdict = self.run_command("verify", "m.mesh", *arguments)
            self.assertEqual(verdict.returncode, status, verdict.stdout)

    def test_the_example_has_one_of_everything(self):
        example = pathlib.Path(__file__).resolve().parents[2] / "examples/plate.poly"
        done = self.run_command("mesh", example, "--size", "0.15", "-o", "m.mesh", "-o", "m.svg")
        self.assertEqual(done.returncode, 0, done.stdout + done.stderr)
        self.assertRegex(done.stderr, r"note: .*segments split at vertices on them: 1, segment 3 ")
        self.assertEqual({edge[2] for edge in self.section("Edges")}, {"1", "2", "3", "4"})
        self.assertEqual({t[3] for t in self.section("Triangles")}, {"1", "2"})
        self.assertIn(["2", "1.75", "0"], self.section("Vertices"))
        self.assertEqual(self.run_command("verify", "m.mesh", "--domain", example).returncode, 0)

    def test_without_regions_every_reference_is_1(self):
        self.assertEqual(self.mesh(dict(kinds())["diagonal"]).returncode, 0)
        self.assertEqual({t[3] for t in self.section("Triangles")}, {"1"})

    def test_a_mesh_that_lost_something_is_refused(self):
        shape = dict(kinds())["ring in a ring"].region(2, 2, 5).point(0.5, 2)
        self.assertEqual(self.mesh(shape, "--size", "0.5").returncode, 0)
        lines = (self.folder / "m.mesh").read_text().splitlines()

        def altered(keyword, choose, change):
            at = lines.index(keyword)
            count = int(lines[at + 1])
            rows = [change(r.split()) if choose(r.split()) else r.split()
                    for r in lines[at + 2:at + 2 + count]]
            rows = [" ".join(r) for r in rows if r]
            return "\n".join([*lines[:at + 1], str(len(rows)), *rows, *lines[at + 2 + count:]]) + "\n"

        once = iter([True] + [False] * 10000)
        for what, text, witness in (
                ("internal edges", altered("Edges", lambda r: r[2] == "7", lambda r: []),
                 "segment_not_covered"),
                ("a region", altered("Triangles", lambda r: r[3] == "5" and next(once),
                                     lambda r: [*r[:3], "0"]), "wrong_region"),
                ("a marker", altered("Edges", lambda r: r[2] == "7", lambda r: [*r[:2], "8"]),
                 "marker_changed"),
                ("an isolated point", altered("RequiredVertices", lambda r: r == ["9"], lambda r: []),
                 "given_changed")):
            with self.subTest(what):
                self.write("m.mesh", text)
                verdict = self.run_command("verify", "m.mesh")
                self.assertEqual(verdict.returncode, 1, verdict.stdout)
                self.assertRegex(verdict.stdout, witness)


if __name__ == "__main__":
    unittest.main()
