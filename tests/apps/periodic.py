# SPDX-License-Identifier: MIT
"""Periodic sides through the real command: both sides have the same points, `verify` proves it again, and sides that
cannot match are refused."""
import collections
import fractions
import json
import math
import unittest

import command

# A quarter of a ring, its straight sides 1 and 2 on the axes; the arcs are curves.
SECTOR = ("4 2\n1 1 0\n2 3 0\n3 0 3\n4 0 1\n4 1\n1 1 2 1\n2 2 3 7\n3 3 4 2\n4 4 1 8\n0\n0\n"
          "curves 2\n1 arc 2 0 0 ccw\n2 arc 4 0 0 cw\n")
# The same with sides that meet at 30 degrees, as polygons.
WEDGE = "4 2\n1 1 0\n2 3 0\n3 {0} {1}\n4 {2} {3}\n4 1\n1 1 2 1\n2 2 3 7\n3 3 4 2\n4 4 1 8\n0\n".format(
    3 * math.cos(math.pi / 6), 3 * math.sin(math.pi / 6), math.cos(math.pi / 6), math.sin(math.pi / 6))
# Strips whose slanted sides are shifted by one: with doubles that are sums of few powers of two, and without.
SLANTED = "4 2\n1 0 0\n2 1 0\n3 1.25 1\n4 0.25 1\n4 1\n1 1 2 1\n2 2 3 2\n3 3 4 3\n4 4 1 4\n0\n"
ROUNDED = "4 2\n1 0 0\n2 1 0\n3 1.3 1\n4 0.3 1\n4 1\n1 1 2 1\n2 2 3 2\n3 3 4 3\n4 4 1 4\n0\n"
# A square whose left side has a corner that its right side has not, and a line inside that ends at another.
CORNERS = ("7 2\n1 0 0\n2 1 0\n3 1 0.375\n4 1 1\n5 0 1\n6 0 0.6875\n7 0.5 0.375\n"
           "7 1\n1 1 2 1\n2 2 3 2\n3 3 4 2\n4 4 5 3\n5 5 6 4\n6 6 1 4\n7 3 7 9\n0\n")
# A left side that bends, and a straight right side of the same length.
BENT = ("5 2\n1 0 0\n2 1 0\n3 1 1.1180339887498949\n4 0 1\n5 -0.25 0.5\n"
        "5 1\n1 1 2 1\n2 2 3 2\n3 3 4 3\n4 4 5 4\n5 5 1 4\n0\n")


class Periodic(command.CommandTest):
    def mesh(self, domain, *arguments):
        self.write("d.poly", domain)
        done = self.run_command("mesh", "d.poly", *arguments, "-o", "m.mesh")
        self.assertEqual(done.returncode, 0, done.stdout + done.stderr)
        again = self.run_command("verify", "m.mesh")
        self.assertEqual(again.returncode, 0, again.stdout + again.stderr)
        self.assertIn("; periodic: ", again.stdout)
        return done.stdout, self.certificate()["audit"]["periodic"]

    def certificate(self, name="m"):
        return json.loads((self.folder / f"{name}.certificate.json").read_text())

    def sides(self, name="m.mesh"):
        """Returns the points of each marker's edges as fractions."""
        words = (self.folder / name).read_text().split()
        at = words.index("Vertices")
        points = [tuple(fractions.Fraction(float(x)) for x in words[at + 2 + 3 * i:at + 4 + 3 * i])
                  for i in range(int(words[at + 1]))]
        found = collections.defaultdict(set)
        at = words.index("Edges")
        for i in range(int(words[at + 1])):
            a, b, marker = map(int, words[at + 2 + 3 * i:at + 5 + 3 * i])
            found[marker] |= {points[a - 1], points[b - 1]}
        return found

    def test_both_pairs_of_a_square(self):
        for sizes in (["--size", "0.2"], ["--metric", "swirl:12", "--size", "0.3"], [],
                      ["--metric", "layer:0.01,0.2", "--vertices", "400"]):
            done = self.run_command("mesh", "square", *sizes, "--periodic", "4,2", "--periodic", "1,3", "-o", "m.mesh")
            self.assertEqual(done.returncode, 0, done.stdout + done.stderr)
            self.assertIn("periodic: 4 and 2: translated exactly by (2, 0), ", done.stdout)
            self.assertIn("periodic: 1 and 3: translated exactly by (0, 2), ", done.stdout)
            sides = self.sides()
            self.assertEqual({(x + 2, y) for x, y in sides[4]}, sides[2])
            self.assertEqual({(x, y + 2) for x, y in sides[1]}, sides[3])
            again = self.run_command("verify", "m.mesh", "--domain", "square")
            self.assertEqual(again.returncode, 0, again.stdout + again.stderr)
            self.assertIn("periodic: 4 and 2: translated exactly by (2, 0), ", again.stdout)

    def test_quarter_of_a_ring(self):
        for sizes in (["--size", "0.3"], ["--metric", "sink:5", "--size", "0.4"]):
            told, (match,) = self.mesh(SECTOR, *sizes, "--periodic", "1,2")
            self.assertIn("periodic: 1 and 2: turned exactly by 90 degrees about the origin", told)
            self.assertEqual(match["turn"], 90)
            sides = self.sides()
            self.assertEqual({(-y, x) for x, y in sides[1]}, sides[2])

    def test_sector_of_thirty_degrees(self):
        told, (match,) = self.mesh(WEDGE, "--size", "0.2", "--periodic", "1,2")
        self.assertIn("matched by lengths, turned by 30 degrees", told)
        self.assertAlmostEqual(match["turn"], 30, delta=1e-9)
        self.assertLess(match["greatest_offset"], 1e-14)
        self.assertEqual(len(self.sides()[1]), len(self.sides()[2]))

    def test_slanted_strips(self):
        told, (match,) = self.mesh(SLANTED, "--metric", "expr:9;3;4", "--size", "0.25", "--periodic", "4,2")
        self.assertIn("translated exactly by (1, 0)", told)
        self.assertEqual(match["metrics_apart"], 0)
        self.assertEqual({(x + 1, y) for x, y in self.sides()[4]}, self.sides()[2])
        told, (match,) = self.mesh(ROUNDED, "--size", "0.1", "--periodic", "4,2")
        self.assertIn("matched by lengths, translated by (1, 0) but for up to ", told)
        self.assertLess(match["greatest_offset"], 1e-15)
        self.assertGreater(match["greatest_offset"], 0)

    def test_bent_side_near_the_origin(self):
        """Doubles near zero are denser than near their images at one: places slide along their segments."""
        bends = [round(64 * math.sin(math.pi * i / 8)) / 1024 for i in range(17)]
        points = [(0, 0)] + [(1 + x, i / 16) for i, x in enumerate(bends)]
        points += [(x, i / 16) for i, x in reversed(list(enumerate(bends))) if i > 0]
        markers = [1] + [2] * 16 + [3] + [4] * 16
        domain = "\n".join([f"{len(points)} 2", *(f"{k} {x!r} {y!r}" for k, (x, y) in enumerate(points, 1)),
                                     f"{len(points)} 1", *(f"{k} {k} {k % len(points) + 1} {marker}"
                                                           for k, marker in enumerate(markers, 1)), "0", ""])
        for sizes in (["--size", "0.05"], ["--metric", "swirl:12", "--size", "0.3"]):
            told, _ = self.mesh(domain, *sizes, "--periodic", "4,2")
            self.assertIn("translated exactly by (1, 0)", told)
            sides = self.sides()
            self.assertGreater(len(sides[4]), 17)
            self.assertEqual({(x + 1, y) for x, y in sides[4]}, sides[2])

    def test_corners_of_one_side_alone(self):
        told, _ = self.mesh(CORNERS, "--size", "0.2", "--periodic", "4,2")
        self.assertIn("translated exactly by (1, 0)", told)
        sides = self.sides()
        self.assertEqual({(x + 1, y) for x, y in sides[4]}, sides[2])
        self.assertIn((0, fractions.Fraction(3, 8)), sides[4])
        self.assertIn((1, fractions.Fraction(11, 16)), sides[2])

    def test_metric_that_differs(self):
        """Both sides get the smaller of their sizes, and the summary says how far the sizes differ."""
        told, (match,) = self.mesh(SLANTED, "--metric", "expr:(1+3*x)^2;0;(1+3*x)^2", "--size", "0.2",
                                   "--periodic", "4,2")
        self.assertIn("lengths of partners apart by up to ", told)
        self.assertGreater(match["metrics_apart"], 0.5)
        self.assertGreater(match["vertices"], 15)

    def test_same_bytes_for_any_number_of_threads(self):
        texts = set()
        for threads in "1", "2", "3", "7":
            done = self.run_command("mesh", "square", "--metric", "swirl:12", "--size", "0.3", "--periodic", "4,2",
                                    "--threads", threads, "-o", "m.mesh", "--quiet")
            self.assertEqual(done.returncode, 0, done.stderr)
            texts.add((self.folder / "m.mesh").read_bytes())
        self.assertEqual(len(texts), 1)

    def refuse(self, domain, pairs, *words):
        self.write("d.poly", domain)
        options = [word for pair in pairs for word in ("--periodic", pair)]
        done = self.run_command("mesh", "d.poly", "--size", "0.3", *options, "-o", "no.mesh")
        self.assertEqual(done.returncode, 2, done.stdout + done.stderr)
        for word in words:
            self.assertIn(word, done.stderr)
        self.assertNotIn("no.mesh", self.files())

    def test_refusals(self):
        both = "the sides with markers 4 and 2 cannot be periodic: "
        self.refuse(SLANTED, ["1,2"], "markers 1 and 2", "their lengths are 1 and 1.03")
        self.refuse(SLANTED.replace("1.25 1", "1.25 2"), ["4,2"], both + "their lengths are ")
        self.refuse(BENT, ["4,2"], both + "the one is not the other shifted or turned: at the image of (-0.25, 0.5), ")
        self.refuse(SLANTED, ["4,6"], "markers 4 and 6", "no segment has marker 6; the markers there are: 1, 2, 3, 4")
        self.refuse(SLANTED, ["4,4"], "marker 4 is named twice")
        self.refuse(SLANTED, ["4,2", "2,1"], "markers 2 and 1", "marker 2 is named twice")
        self.refuse(SLANTED.replace("3 3 4 3", "3 3 4 4"), ["4,2"], both)
        self.refuse(SLANTED.replace("1 1 2 1", "1 1 2 3"), ["4,3"], "the segments with marker 3 are more than one line")
        self.refuse(SECTOR, ["7,8"], "markers 7 and 8", "is of a curve, and straight sides are wanted")
        self.refuse(CORNERS, ["4,9"], "markers 4 and 9", "the domain is on both sides of the segment from ")
        for word in "4", "4,", "4,2,1", "a,b", "4;2", "4.5,2":
            self.refuse(SLANTED, [word], "--periodic", "two markers are wanted, as 4,2")
        self.write("d.poly", SLANTED)
        done = self.run_command("mesh", "d.poly", "--refine", "darts", "--periodic", "4,2", "-o", "no.mesh")
        self.assertEqual(done.returncode, 2)
        self.assertIn("periodic sides are made by the strategies fill and voronoi, not by darts", done.stderr)
        done = self.run_command("mesh", "d.poly", "--size", "0.3", "--periodic", "4,2", "--pieces", "2", "-o", "p/")
        self.assertEqual(done.returncode, 2)
        self.assertIn("--periodic: both sides want the whole domain", done.stderr)

    def test_spoiled_matchings(self):
        """A claim of matching sides that do not match is refused by name, whatever else holds."""
        self.mesh(SLANTED, "--size", "0.2", "--periodic", "4,2")
        path = self.folder / "m.certificate.json"
        claim = self.certificate()
        for spoil, words in (
                (lambda c: c["asked"]["periodic_sides"].append([1, 2]), "the sides with markers 1 and 2 do not match"),
                (lambda c: c["asked"]["periodic_sides"].append([1, 6]), "no boundary edge has marker 6"),
                (lambda c: c["asked"].update(periodic_sides=[[2, 4]]), "audit.periodic"),
                (lambda c: c["audit"]["periodic"][0].update(vertices=3), "audit.periodic"),
                (lambda c: c["audit"]["periodic"][0].update(kind="matched by lengths"), "audit.periodic"),
                (lambda c: c["audit"]["periodic"][0].update(shift=[1, 1e-20]), "audit.periodic"),
                (lambda c: c["audit"]["periodic"][0].update(metrics_apart=0.5), "audit.periodic"),
                (lambda c: c["audit"]["periodic"].clear(), "audit.periodic")):
            spoiled = json.loads(json.dumps(claim))
            spoil(spoiled)
            path.write_text(json.dumps(spoiled))
            done = self.run_command("verify", "m.mesh")
            self.assertEqual(done.returncode, 1, done.stdout + done.stderr)
            self.assertIn("REFUSED", done.stdout)
            self.assertIn(words, done.stdout)
        path.write_text(json.dumps(claim))
        self.assertEqual(self.run_command("verify", "m.mesh").returncode, 0)

    def test_verify_asks_by_itself(self):
        self.write("d.poly", SLANTED)
        for pairs, status in ([], 1), (["--periodic", "4,2"], 0):
            made = self.run_command("mesh", "d.poly", "--metric", "expr:(1+9*y)^2;x;4", "--size", "0.4", *pairs,
                                    "-o", "m.mesh")
            self.assertEqual(made.returncode, 0, made.stderr)
            done = self.run_command("verify", "m.mesh", "--periodic", "4,2")
            self.assertEqual(done.returncode, status, done.stdout)
            self.assertIn("periodic: ", done.stdout)
        done = self.run_command("verify", "m.mesh", "--periodic", "4,3")
        self.assertEqual(done.returncode, 1)
        self.assertIn("periodic: the sides with markers 4 and 3 do not match: ", done.stdout)

    def test_adapt(self):
        self.run_command("mesh", "square", "--size", "0.15", "-o", "old.mesh", "--quiet")
        text = (self.folder / "old.mesh").read_text().split()
        at = text.index("Vertices")
        rows = [[float(x) for x in text[at + 2 + 3 * i:at + 4 + 3 * i]] for i in range(int(text[at + 1]))]
        values = [math.tanh(10 * math.sin(math.pi * (x - y))) for x, y in rows]
        self.write("u.sol", "MeshVersionFormatted 2\nDimension 2\nSolAtVertices\n%d\n1 1\n%s\nEnd\n"
                   % (len(values), "\n".join(map(repr, values))))
        done = self.run_command("adapt", "old.mesh", "--solution", "u.sol", "--vertices", "500", "--periodic", "4,2",
                                "--periodic", "1,3", "-o", "m.mesh")
        self.assertEqual(done.returncode, 0, done.stdout + done.stderr)
        self.assertIn("periodic: 4 and 2: translated exactly by (2, 0), ", done.stdout)
        sides = self.sides()
        self.assertEqual({(x + 2, y) for x, y in sides[4]}, sides[2])
        self.assertEqual({(x, y + 2) for x, y in sides[1]}, sides[3])
        again = self.run_command("verify", "m.mesh")
        self.assertEqual(again.returncode, 0, again.stdout)
        # A mesh whose sides match is kept as it is. Without --periodic, so is one whose sides do not match.
        stays = self.run_command("adapt", "m.mesh", "--metric", "m.sol", "--periodic", "4,2", "-o", "same.mesh")
        self.assertIn("stays as it is", stays.stdout)
        self.assertIn("periodic: 4 and 2: ", stays.stdout)
        self.assertEqual(self.run_command("verify", "same.mesh").returncode, 0)
        done = self.run_command("adapt", "old.mesh", "--metric", "old.sol", "--keep", "always", "-o", "plain.mesh")
        self.assertIn("stays as it is", done.stdout)

    def torus(self, cells, value=lambda x, y: math.tanh(8 * math.sin(2 * math.pi * (x - y)))):
        """A grid of the unit square, each cell cut along x = y, and values: a front along these diagonals."""
        at = [(i / cells, j / cells) for j in range(cells + 1) for i in range(cells + 1)]
        corners = [j * (cells + 1) + i + 1 for j in range(cells) for i in range(cells)]
        below = cells + 1
        triangles = [t for a in corners for t in ((a, a + 1, a + below + 1), (a, a + below + 1, a + below))]
        last = cells * below
        edges = [e for k in range(cells) for e in (
            (k + 1, k + 2, 1), ((k + 1) * below, (k + 2) * below, 2), (last + k + 2, last + k + 1, 3),
            ((k + 1) * below + 1, k * below + 1, 4))]
        rows = lambda name, table, *more: "\n".join(  # noqa: E731
            [name, str(len(table)), *(" ".join(map(repr, (*row, *more))) for row in table)])
        self.write("t.mesh", "\n".join(["MeshVersionFormatted 2", "Dimension 2", rows("Vertices", at, 0),
                                        rows("Triangles", triangles, 1), rows("Edges", edges), "End", ""]))
        values = [value(x, y) for x, y in at]
        self.write("t.u.sol", "MeshVersionFormatted 2\nDimension 2\nSolAtVertices\n%d\n1 1\n%s\nEnd\n"
                   % (len(values), "\n".join(map(repr, values))))

    def bend_torus(self, bend, digits=17):
        """Moves each point along x by bend(y), and writes the coordinates with `digits` digits."""
        lines = (self.folder / "t.mesh").read_text().split("\n")
        first = lines.index("Vertices") + 2
        for k in range(first, first + int(lines[first - 1])):
            x, y, _ = lines[k].split()
            lines[k] = f"{float(x) + bend(float(y)):.{digits}g} {float(y):.{digits}g} 0"
        self.write("t.mesh", "\n".join(lines))

    def test_sides_that_lean_in_a_file_of_few_digits(self):
        """Rounded to twelve digits their vertices are on no line."""
        self.torus(12, lambda x, y: math.sin(2 * math.pi * x) * math.cos(2 * math.pi * y))
        self.bend_torus(lambda y: 0.3 * y, 12)
        for wanted in 150, 600:
            done = self.run_command("adapt", "t.mesh", "--solution", "t.u.sol", "--vertices", str(wanted), "--periodic",
                                    "4,2", "--periodic", "1,3", "-o", "n.mesh")
            self.assertEqual(done.returncode, 0, done.stderr)
            self.assertIn("periodic: 4 and 2: ", done.stdout)
            self.assertNotIn("note", done.stderr)
            self.assertEqual(self.run_command("verify", "n.mesh").returncode, 0)

    def test_sides_that_bend(self):
        self.torus(16, lambda x, y: math.sin(2 * math.pi * x) * math.cos(2 * math.pi * y))
        self.bend_torus(lambda y: math.sin(2 * math.pi * y) / 8)
        for wanted in 200, 900:
            done = self.run_command("adapt", "t.mesh", "--solution", "t.u.sol", "--vertices", str(wanted), "--periodic",
                                    "4,2", "-o", "n.mesh")
            self.assertEqual(done.returncode, 0, done.stderr)
            self.assertIn("periodic: 4 and 2: ", done.stdout)
            sides = self.sides("n.mesh")
            self.assertEqual(len(sides[4]), len(sides[2]))
            for a, b in zip(*(sorted(sides[k], key=lambda at: at[1]) for k in (4, 2))):
                self.assertAlmostEqual(float(b[0] - a[0]), 1, delta=1e-12)
                self.assertAlmostEqual(float(b[1] - a[1]), 0, delta=1e-12)
            self.assertEqual(self.run_command("verify", "n.mesh").returncode, 0)

    def test_bent_sides_where_edges_wanted_are_long(self):
        """Fronts along and across the channel: its sides keep no more vertices than angles beside them allow."""
        for wanted, front in ((1500, lambda x, y: math.tanh(20 * math.sin(2 * math.pi * (x - 0.25)))),
                              (400, lambda x, y: math.tanh(20 * math.sin(2 * math.pi * y)))):
            self.torus(80, front)
            self.bend_torus(lambda y: math.sin(2 * math.pi * y) / 8)
            done = self.run_command("adapt", "t.mesh", "--solution", "t.u.sol", "--vertices", str(wanted),
                                    "--periodic", "4,2", "-o", "n.mesh")
            self.assertEqual(done.returncode, 0, done.stderr)
            again = self.run_command("verify", "n.mesh")
            self.assertEqual(again.returncode, 0, again.stdout)

    def bent_front(self):
        """A front that leaves one bent side of two, and a region inside."""
        bend = lambda y: math.sin(2 * math.pi * y) / 40  # noqa: E731
        self.torus(40, lambda x, y: math.tanh(20 * (x + bend(y) - 0.1 - 0.3 * y)) + (x + bend(y)) ** 2)
        self.bend_torus(bend)
        lines = (self.folder / "t.mesh").read_text().split("\n")
        first = lines.index("Triangles") + 2
        for k in range(first, first + int(lines[first - 1])):
            corners = [divmod(int(v) - 1, 41) for v in lines[k].split()[:3]]
            if all(48 < sum(c[axis] for c in corners) < 72 for axis in (0, 1)):
                lines[k] = lines[k][:-1] + "2"
        self.write("t.mesh", "\n".join(lines))

    def halve_an_edge(self, cells):
        """Puts a vertex in the middle of an edge of side 2."""
        text = (self.folder / "t.mesh").read_text()
        low, high = (cells // 2 + 1) * (cells + 1), (cells // 2 + 2) * (cells + 1)
        new = (cells + 1) ** 2 + 1
        lines = text.split("\n")
        places = [[float(x) for x in lines[3 + k].split()[:2]] for k in (low, high)]
        for old, parts in ((f"{low - 1} {low} {high} 1", (f"{low - 1} {low} {new} 1", f"{low - 1} {new} {high} 1")),
                           (f"{low} {high} 2", (f"{low} {new} 2", f"{new} {high} 2"))):
            lines[lines.index(old):lines.index(old) + 1] = parts
        middle = [(places[0][k] + places[1][k]) / 2 for k in (0, 1)]
        lines.insert(lines.index("Triangles"), f"{middle[0]!r} {middle[1]!r} 0")
        for name, more in ("Vertices", 1), ("Triangles", 1), ("Edges", 1):
            at = lines.index(name) + 1
            lines[at] = str(int(lines[at]) + more)
        self.write("t.mesh", "\n".join(lines))
        lines = (self.folder / "t.u.sol").read_text().split("\n")
        lines[3] = str(new)
        lines.insert(lines.index("End"), lines[4 + low])
        self.write("t.u.sol", "\n".join(lines))

    def test_a_vertex_that_one_side_keeps_stays_on_both(self):
        """The outline of each side begins at its start, so that the sides keep vertices that are no partners."""
        self.torus(40, lambda x, y: math.tanh(20 * math.sin(2 * math.pi * (x - 0.3 * y))))
        self.bend_torus(lambda y: math.sin(2 * math.pi * y) / 20)
        done = self.run_command("adapt", "t.mesh", "--solution", "t.u.sol", "--vertices", "1500", "--periodic", "4,2",
                                "-o", "n.mesh")
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertNotIn("keep all their vertices", done.stderr)
        self.assertIn("periodic: 4 and 2: matched by lengths", done.stdout)
        again = self.run_command("verify", "n.mesh")
        self.assertEqual(again.returncode, 0, again.stdout)

    def test_the_note_on_sides_whose_vertices_stay(self):
        """One side has a vertex more than its partner, and both bend."""
        self.bent_front()
        self.halve_an_edge(40)
        for frozen in (), ("--frozen", "2"):
            with self.subTest(frozen=frozen):
                done = self.run_command("adapt", "t.mesh", "--solution", "t.u.sol", "--vertices", "80", "--periodic",
                                        "4,2", *frozen, "-o", "n.mesh")
                note = "the periodic sides with the markers 2, 4 keep all their vertices"
                self.assertEqual(done.stderr.count(note), 1, done.stderr)
                self.assertNotIn("REFUSED", self.run_command("verify", "n.mesh").stdout)

    def adapt_torus(self, wanted, *more):
        """The new mesh's status and number of vertices; its sides match."""
        done = self.run_command("adapt", "t.mesh", "--solution", "t.u.sol", "--vertices", str(wanted), "--periodic",
                                "4,2", *more, "-o", "n.mesh")
        self.assertIn("certified", done.stdout, done.stderr)
        self.assertIn("periodic: 4 and 2: translated exactly by (1, 0), ", done.stdout)
        sides = self.sides("n.mesh")
        self.assertEqual({(x + 1, y) for x, y in sides[4]}, sides[2])
        self.assertEqual(self.run_command("verify", "n.mesh").returncode, 0)
        words = (self.folder / "n.mesh").read_text().split()
        return done.returncode, int(words[words.index("Vertices") + 1])

    def test_sides_are_divided_for_the_vertices_that_are_wanted(self):
        """A front as thin as its metric wants would take all vertices to the sides, and more."""
        for cells, wanted in (10, 1000), (14, 200), (14, 400), (14, 1000):
            self.torus(cells)
            for pairs in ((), ("--periodic", "1,3")):
                with self.subTest(cells=cells, wanted=wanted, pairs=pairs):
                    status, got = self.adapt_torus(wanted, *pairs)
                    self.assertEqual(status, 0)
                    self.assertLessEqual(abs(got - wanted), 0.1 * wanted)

    def test_no_edge_across_and_sides_that_match(self):
        self.torus(14, lambda x, y: math.sin(2 * math.pi * x) * math.cos(2 * math.pi * y))
        for wanted in 60, 200, 400:
            for pairs in ((), ("--periodic", "1,3")):
                with self.subTest(wanted=wanted, pairs=pairs):
                    self.assertEqual(self.adapt_torus(wanted, *pairs, "--no-split-across")[0], 0)
        self.write("d.poly", SLANTED)
        for size in "0.5", "0.3", "0.12":
            done = self.run_command("mesh", "d.poly", "--size", size, "--metric", "expr:(1+9*y)^2;x;4", "--periodic",
                                    "4,2", "--no-split-across", "-o", "m.mesh")
            self.assertEqual(done.returncode, 0, done.stdout + done.stderr)
            self.assertEqual({(x + 1, y) for x, y in self.sides()[4]}, self.sides()[2])
            self.assertEqual(self.run_command("verify", "m.mesh").returncode, 0)


if __name__ == "__main__":
    unittest.main()
