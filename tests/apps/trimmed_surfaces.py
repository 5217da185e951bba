# SPDX-License-Identifier: MIT
"""Trimmed patches through the command. Areas, chords and gaps are computed here a second time, by sampling,
with no code of the program's."""
import json
import unittest
from math import cos, hypot, pi, sin, sqrt

from command import CommandTest

HALF = sqrt(0.5)


def circle(x, y, radius, clockwise=False, **more):
    corners = [(1, 0), (1, 1), (0, 1), (-1, 1), (-1, 0), (-1, -1), (0, -1), (1, -1), (1, 0)]
    if clockwise:
        corners = corners[::-1]
    return {"degree": 2, "knots": [0, 0, 0, 1, 1, 2, 2, 3, 3, 4, 4, 4], "weights": [1, HALF] * 4 + [1],
            "control": [[x + radius * a, y + radius * b] for a, b in corners], **more}


def line(a, b, **more):
    return {"control": [a, b], **more}


def lines(*points):
    return {"control": [*points, points[0]]}


PLATE = {"name": "plate", "degree": [1, 1], "control": [[[0, 0, 0], [0, 2, 0]], [[3, 0, 0], [3, 2, 0]]]}
# A quarter of a cylinder of radius 1, 2 high; u goes around, v up.
WALL = {"name": "wall", "degree": [2, 1], "weights": [[1, 1], [HALF, HALF], [1, 1]],
        "control": [[[1, 0, 0], [1, 0, 2]], [[1, 1, 0], [1, 1, 2]], [[0, 1, 0], [0, 1, 2]]]}


def drilled_plate():
    return {"patches": [{**PLATE, "loops": [[lines([.1, .1], [.9, .1], [.9, .9], [.1, .9])],
                                            [circle(.5, .5, .2, clockwise=True)]]}]}


def wall_with_top(radius=1.0):
    """Returns a drilled wall and the quarter disc on it. The disc's own arc has the given radius."""
    top = {"name": "top", "degree": [1, 1], "control": [[[0, 0, 2], [0, 2, 2]], [[2, 0, 2], [2, 2, 2]]]}
    r = radius / 2
    arc = {"degree": 2, "control": [[r, 0], [r, r], [0, r]], "weights": [1, HALF, 1], "edge": "rim"}
    wall = {**WALL, "loops": [[line([0, 0], [1, 0]), line([1, 0], [1, 1]),
                               line([1, 1], [0, 1], edge="rim", backward=True), line([0, 1], [0, 0])],
                              [circle(.5, .5, .2, clockwise=True)]]}
    return {"patches": [wall, {**top, "loops": [[line([0, 0], [r, 0]), arc, line([0, r], [0, 0])]]}]}


def closed_can():
    """A whole cylinder with a seam, its floor and its lid, all seen from outside."""
    around = [(1, 0), (1, 1), (0, 1), (-1, 1), (-1, 0), (-1, -1), (0, -1), (1, -1), (1, 0)]
    knots = [0, 0, 0, 1, 1, 2, 2, 3, 3, 4, 4, 4]
    side = {"degree": [2, 1], "knots_u": knots, "knots_v": [0, 0, 1, 1],
            "control": [[[x, y, 0], [x, y, 2]] for x, y in around], "weights": [[w, w] for w in [1, HALF] * 4 + [1]],
            "loops": [[line([0, 0], [4, 0], edge="bottom"), line([4, 0], [4, 1], edge="seam"),
                       line([4, 1], [0, 1], edge="top", backward=True), line([0, 1], [0, 0], edge="seam", backward=True)]]}
    lid = {"degree": [1, 1], "control": [[[-2, -2, 2], [-2, 2, 2]], [[2, -2, 2], [2, 2, 2]]],
           "loops": [[circle(.5, .5, .25, edge="top")]]}
    # The floor's v runs down: its loop follows the bottom edge of the wall against that edge's direction.
    floor = {"degree": [1, 1], "control": [[[-2, 2, 0], [-2, -2, 0]], [[2, 2, 0], [2, -2, 0]]],
             "loops": [[circle(.5, .5, .25, edge="bottom", backward=True)]]}
    return {"patches": [side, lid, floor]}


def trim_at(curve, place):
    """Returns a point of a curve whose inner knots have full multiplicity, from its Bezier pieces."""
    degree = curve.get("degree", 1)
    control = curve["control"]
    pieces = (len(control) - 1) // degree
    at = min(int(place * pieces), pieces - 1)
    t = place * pieces - at
    weights = curve.get("weights", [1] * len(control))
    points = [[w * x, w * y, w] for (x, y), w in zip(control, weights)][degree * at:degree * at + degree + 1]
    while len(points) > 1:
        points = [[a + t * (b - a) for a, b in zip(p, q)] for p, q in zip(points, points[1:])]
    return points[0][0] / points[0][2], points[0][1] / points[0][2]


class Trimmed(CommandTest):
    def make(self, surface, *arguments, status=0):
        self.write("s.json", json.dumps(surface))
        done = self.run_command("surface", "s.json", *arguments, "-o", "s.mesh")
        self.assertEqual(done.returncode, status, done.stdout + done.stderr)
        return done.stdout + done.stderr

    def claim(self):
        return json.loads((self.folder / "s.certificate.json").read_text())

    def mesh(self):
        words = (self.folder / "s.mesh").read_text().split()
        at = words.index("Vertices")
        points = [tuple(map(float, words[at + 2 + 4 * k:at + 5 + 4 * k])) for k in range(int(words[at + 1]))]
        at = words.index("Triangles")
        triangles = [tuple(int(x) - 1 for x in words[at + 2 + 4 * k:at + 5 + 4 * k]) for k in range(int(words[at + 1]))]
        return points, triangles

    def area(self):
        points, triangles = self.mesh()
        total = 0.0
        for a, b, c in ([points[k] for k in t] for t in triangles):
            p, q = [y - x for x, y in zip(a, b)], [y - x for x, y in zip(a, c)]
            total += hypot(p[1] * q[2] - p[2] * q[1], p[2] * q[0] - p[0] * q[2], p[0] * q[1] - p[1] * q[0]) / 2
        return total

    def chord_distance(self, surface, lift):
        """Returns the greatest distance in space between points of the curves and points of their chords at equal
        parameters."""
        worst = 0.0
        for patch, face in zip(surface["patches"], self.claim()["faces"]):
            curves = [c for loop in patch["loops"] for c in loop]
            places = {k: [0.0, 1.0] for k in range(len(curves))}
            for curve, place in face["border"]:
                places[curve - 1].append(place)
            for k, some in places.items():
                some = sorted(set(some))
                for a, b in zip(some, some[1:]):
                    p, q = trim_at(curves[k], a), trim_at(curves[k], b)
                    length = (q[0] - p[0]) ** 2 + (q[1] - p[1]) ** 2
                    for n in range(1, 16):
                        x = trim_at(curves[k], a + (b - a) * n / 16)
                        share = ((x[0] - p[0]) * (q[0] - p[0]) + (x[1] - p[1]) * (q[1] - p[1])) / length
                        foot = [s + share * (t - s) for s, t in zip(p, q)]
                        worst = max(worst, sum((s - t) ** 2 for s, t in zip(lift(patch, x), lift(patch, foot))) ** .5)
        return worst

    def test_a_drilled_plate_is_certified_again_and_has_its_area(self):
        for chord in (0.05, 0.001):
            with self.subTest(chord):
                plate = drilled_plate()
                self.assertIn("certified: ", self.make(plate, "--chord", chord))
                claim = self.claim()
                self.assertLessEqual(claim["distance"], 1e-6 * chord)
                # In space the curves are an ellipse with half axes 0.6 and 0.4.
                self.assertLess(abs(self.area() - (2.4 * 1.6 - pi * .6 * .4)), 3.2 * claim["trim_distance"])
                sampled = self.chord_distance(plate, lambda _, x: (3 * x[0], 2 * x[1], 0))
                self.assertLessEqual(sampled, claim["trim_distance"] * (1 + 1e-9))
                self.assertLess(claim["trim_distance"], 1.2 * sampled)
                self.assertLess(claim["trim_distance"], chord)
                self.assertEqual((claim["trims"], claim["trim_edges"], claim["euler"]), (2, 0, 0))
                verified = self.run_command("verify", "s.mesh", "--domain", "s.json")
                self.assertEqual(verified.returncode, 0, verified.stdout)

    def test_two_faces_have_the_vertices_of_their_edge_and_the_gap_is_told(self):
        for radius, gap in ((1.0, 0.0), (1.001, 0.001)):
            with self.subTest(radius):
                said = self.make(wall_with_top(radius), "--chord", 0.01)
                claim = self.claim()
                self.assertIn("common edges is at most", said)
                self.assertLessEqual(gap * (1 - 1e-9), claim["trim_gap"])
                self.assertLessEqual(claim["trim_gap"], 1.06 * gap + 1e-11)
                self.assertLessEqual(claim["vertex_distance"], claim["trim_gap"] + 1e-11)
                # The mesh is one component with one hole, so that no edge at the rim is open.
                self.assertEqual(claim["euler"], 0)
                self.assertEqual(self.run_command("verify", "s.mesh").returncode, 0)
        said = self.make(wall_with_top(1.05), "--chord", .01, status=2)
        self.assertRegex(said, r'patches 1 and 2: the two curves of edge "rim" are up to 0\.05\d* from each other')

    def test_a_closed_can_has_no_open_edge(self):
        self.make(closed_can(), "--chord", 0.01, "--no-crossings")
        claim = self.claim()
        self.assertEqual((claim["open_edges"], claim["euler"], claim["trim_edges"]), (0, 2, 3))
        self.assertLess(abs(self.area() - 6 * pi), 0.01 * 4 * pi)
        points, triangles = self.mesh()
        volume = sum(a[0] * (b[1] * c[2] - b[2] * c[1]) + a[1] * (b[2] * c[0] - b[0] * c[2]) +
                     a[2] * (b[0] * c[1] - b[1] * c[0]) for a, b, c in ([points[k] for k in t] for t in triangles)) / 6
        self.assertLess(abs(volume - 2 * pi), 0.1)
        self.assertEqual(self.run_command("verify", "s.mesh").returncode, 0)

    def test_bytes_do_not_depend_on_threads(self):
        texts = set()
        for threads in (1, 2, 7):
            self.make(closed_can(), "--chord", 0.03, "--threads", threads)
            texts.add((self.folder / "s.mesh").read_bytes() + (self.folder / "s.certificate.json").read_bytes())
        self.assertEqual(len(texts), 1)

    def test_triangles_do_not_depend_on_the_order_of_faces(self):
        """By rounding, a corner of several faces is a different point on each. All faces use the same one of
        these."""
        for surface in (closed_can(), wall_with_top(1.001)):
            found = []
            for patches in (surface["patches"], surface["patches"][::-1]):
                self.make({"patches": patches}, "--chord", 0.03)
                points, triangles = self.mesh()
                at = ([points[k] for k in t] for t in triangles)
                found.append(sorted(min(t[k:] + t[:k] for k in range(3)) for t in at))
            self.assertEqual(*found)

    def test_holes_near_each_other_are_divided_until_they_do_not_meet(self):
        """Polygons within the chord tolerance would cross in the bridge of width 0.01 between the holes."""
        plate = {"patches": [{**PLATE, "loops": [[lines([0, 0], [1, 0], [1, 1], [0, 1])],
                                                 [circle(.3, .5, .195, clockwise=True)],
                                                 [circle(.7, .5, .195, clockwise=True)]]}]}
        self.make(plate, "--chord", 2)
        self.assertEqual(self.claim()["euler"], -1)

    def test_spoiled_certificates_are_refused(self):
        self.make(wall_with_top(1.001), "--chord", 0.02)
        good = self.claim()
        mesh = (self.folder / "s.mesh").read_text()

        def refused(change, said, mesh_text=mesh):
            claim = json.loads(json.dumps(good))
            change(claim)
            self.write("s.certificate.json", '{"kind": "surface",' + json.dumps(claim)[1:].replace('"kind": "surface", ', "", 1))
            self.write("s.mesh", mesh_text)
            done = self.run_command("verify", "s.mesh")
            self.assertEqual(done.returncode, 1, (said, done.stdout, done.stderr))
            self.assertRegex(done.stdout, said)

        def set_place(claim, place):
            row = next(r for r in claim["faces"][0]["border"] if r[1] > 0)
            row[1] = place

        refused(lambda c: c.update(trim_gap=1e-4), "gap along edges: 0.0001 is claimed")
        refused(lambda c: c.update(trim_distance=1e-5), "distance of their chords")
        refused(lambda c: c.update(trims=3), "trimming curves")
        refused(lambda c: set_place(c, 0.999), "a chord of trimming curve|distance of their chords|no chain")
        refused(lambda c: c["faces"][0]["border"].pop(), "differ in number")
        refused(lambda c: c["faces"][0]["border"][0].__setitem__(1, 0.5), "site 1 has no place")
        refused(lambda c: c["surface"]["patches"][0]["loops"].pop(), "face 1: ")
        refused(lambda c: c["surface"]["patches"][1]["loops"][0][1].update(edge="other"), "edges of two trimmed faces|no triangle")

    def test_bad_loops_are_refused_by_name(self):
        square = [[.1, .1], [.9, .1], [.9, .9], [.1, .9]]
        for loops, said in [
                ([], '"loops" must be a list'), ([[]], "loop 1: there is no curve"), ([[3]], "loop 1: curve 1: an object"),
                ([[{"control": [[0, 0, 0]]}]], "control point 1 has 3 numbers"),
                ([[{"control": [[0, 0], [1, 0]], "colour": 1}]], '"colour" is no part of a trimming curve'),
                ([[{"control": [[0, 0], [1, 0]], "edge": 3}]], '"edge" must be a name'),
                ([[{"control": [[0, 0], [1, 0]], "backward": 3}]], '"backward" must be true or false'),
                ([[{"control": [[0, 0], [1, 0]], "weights": [1]}]], "1 weights for 2 control points"),
                ([[{"control": [[0, 0], [1, 0]], "weights": [1, -1]}]], "its weight is -1"),
                ([[{"control": [[0, 0], [1, 0]], "degree": 13}]], "control points for degree 13|degree 13"),
                ([[{"control": [[0, 0], [1, 0]], "knots": [0, 0, 1]}]], "3 knots in t"),
                ([[{"control": [[.5, .5], [.5, .5]]}]], "one point of the plane"),
                ([[lines(*square[::-1])]], "an outer loop must run counter-clockwise"),
                ([[lines(*square)], [circle(.5, .5, .2)]], "the loop of a hole clockwise"),
                ([[lines(*square)], [circle(.8, .5, .2, clockwise=True)]], "."),
                ([[lines(square[0], square[2], square[1], square[3])]], "."),
                ([[lines(*square, ) | {"edge": "a"}], [circle(.5, .5, .2, True, edge="a")], [circle(.5, .5, .1, edge="a")]],
                 'patches 1, 1 and 1 have edge "a"')]:
            with self.subTest(said=said, loops=loops):
                self.write("s.json", json.dumps({"patches": [{**PLATE, "loops": loops}]}))
                done = self.run_command("surface", "s.json", "--chord", 0.1, "-o", "bad.mesh")
                self.assertEqual(done.returncode, 2, done.stdout + done.stderr)
                self.assertRegex(done.stderr, said)
                self.assertIn("patch", done.stderr)
                self.assertNotIn("bad.mesh", self.files())

    def test_a_loop_that_does_not_close_is_beyond_the_chord(self):
        loops = [[line([.1, .1], [.9, .1]), line([.9, .3], [.9, .9]), line([.9, .9], [.1, .9]), line([.1, .9], [.1, .1])]]
        said = self.make({"patches": [{**PLATE, "loops": loops}]}, "--chord", 0.1, status=1)
        self.assertRegex(said, r"a chord of trimming curve \d is proved within 0\.4")


if __name__ == "__main__":
    unittest.main()
