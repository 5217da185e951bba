# SPDX-License-Identifier: MIT
"""Proofs through the real command, checked by tools/check_mesh.py as a reader would run it."""
import json
import math
import pathlib
import re
import subprocess
import sys
import unittest

import command

CHECKER = pathlib.Path(__file__).resolve().parents[2] / "tools/check_mesh.py"
CURVE_CHECKER = CHECKER.with_name("check_curves.py")
SQUARE = "4 2 0 0\n1 0 0\n2 1 0\n3 1 1\n4 0 1\n4 1\n1 1 2 1\n2 2 3 2\n3 3 4 3\n4 4 1 4\n0\n0\n"
# A hole, an island in it, a segment inside that ends on another and splits it, a region, a point.
ROOMS = ("15 2 0 0\n1 0 0\n2 6 0\n3 6 4\n4 0 4\n5 1 1\n6 3 1\n7 3 3\n8 1 3\n9 1.75 1.75\n10 2.25 1.75\n"
         "11 2 2.25\n12 4 0\n13 4.25 4\n14 5 1.5\n15 4.125 2\n13 1\n1 1 2 1\n2 2 3 1\n3 3 4 1\n4 4 1 1\n"
         "5 5 6 2\n6 6 7 2\n7 7 8 2\n8 8 5 2\n9 9 10 3\n10 10 11 3\n11 11 9 3\n12 12 13 4\n13 14 15 5\n"
         "1\n1 1.25 1.25\n2\n1 5.5 3.5 7\n2 2 2 9\n")
# Land with a lake and an island in it, which is another feature, and a neighbour.
LAKE = """{"type": "FeatureCollection", "features": [
{"type": "Feature", "properties": {}, "geometry": {"type": "Polygon", "coordinates":
 [[[0, 0], [6, 0], [6, 4], [0, 4], [0, 0]], [[1, 1], [1, 3], [3, 3], [3, 1], [1, 1]]]}},
{"type": "Feature", "properties": {}, "geometry": {"type": "Polygon", "coordinates":
 [[[6, 0], [8, 0], [8, 4], [6, 4], [6, 0]]]}},
{"type": "Feature", "properties": {}, "geometry": {"type": "Polygon", "coordinates":
 [[[1.75, 1.75], [2.25, 1.75], [2, 2.25], [1.75, 1.75]]]}}]}
"""
EDGES = ("MeshVersionFormatted 2\nDimension 2\nVertices\n4\n0 0 0\n3 0 0\n3 2 0\n0 2 0\n"
         "Edges\n4\n1 2 5\n2 3 6\n3 4 7\n4 1 8\nEnd\n")
# A cubic below, an arc on the right, a cubic above, and a round hole.
BENT = ("5 2\n1 0 0\n2 3 0\n3 3 2\n4 0 2\n5 1.2 1\n4 1\n1 1 2 1\n2 2 3 2\n3 3 4 3\n4 4 1 4\n1\n1 1.5 1\n0\n"
        "curves 4\n1 bezier 1 1 -0.5 2 0.4\n2 arc 2 3 1 ccw\n3 bezier 3 2 2.6 1 1.4\n4 circle 5 1.5 1 7\n")
# Half a disc: its arc and its diameter have the same ends.
HALF = "2 2\n1 -1 0\n2 1 0\n2 1\n1 1 2 1\n2 2 1 2\n0\n0\ncurves 1\n1 arc 2 0 0 ccw\n"
# An open spline, a closed one around a hole with segments turned against it, and a circle.
SPLINES = ("9 2\n1 0 0\n2 2 -0.3\n3 3 1\n4 1.5 2\n5 0 1.5\n6 1.2 0.8\n7 2 0.4\n8 2.4 0.7\n9 2 1\n8 1\n"
           "1 1 2 1\n2 2 3 1\n3 3 4 2\n4 4 5 1\n5 5 1 1\n6 7 8 5\n7 9 8 5\n8 9 7 6\n2\n1 1.3 0.8\n2 2.1 0.7\n0\n"
           "curves 3\n1 spline 1 2 3\n2 spline 6 7 8\n3 circle 6 1.4 0.8 7\n")
CURVE = "1 2\n1 1 0\n0\n0\n0\ncurves 1\n1 circle 1 0 0\n"



def medit_texts(points, tensors, triangles):
    """Returns a mesh whose edges with one triangle are segments, and its metric."""
    sides = {(t[i], t[i - 2]) for t in triangles for i in range(3)}
    edges = sorted((a, b) for a, b in sides if (b, a) not in sides)
    mesh = ["MeshVersionFormatted 2", "Dimension 2", "Vertices", str(len(points))]
    mesh += [f"{x!r} {y!r} 0" for x, y in points] + ["Triangles", str(len(triangles))]
    mesh += [f"{a + 1} {b + 1} {c + 1} 1" for a, b, c in triangles] + ["Edges", str(len(edges))]
    mesh += [f"{a + 1} {b + 1} 1" for a, b in edges] + ["End", ""]
    sol = ["MeshVersionFormatted 2", "Dimension 2", "SolAtVertices", str(len(points)), "1 3"]
    sol += [f"{m11!r} {m12!r} {m22!r}" for m11, m12, m22 in tensors] + ["End", ""]
    return "\n".join(mesh), "\n".join(sol)


def lattice(step, tensor):
    """Returns squares, each cut by the diagonal that does not end at the square's greatest corner."""
    count = 6
    points = [(i * step, k * step) for i in range(count) for k in range(count)]
    triangles = [t for v in (i * count + k for i in range(count - 1) for k in range(count - 1)) for t in (
        (v, v + count, v + 1), (v + count + 1, v + 1, v + count))]
    return points, [tensor(*p) for p in points], triangles


def ring():
    """Returns twelve sites of different metrics, all equally far from the origin. Ears are cut off in order, the
    greatest site's first."""
    points, quarter = [], [(5.0, 0.0), (4.0, 3.0), (3.0, 4.0)]
    for _ in range(4):
        points += quarter
        quarter = [(-y, x) for x, y in quarter]
    left, triangles = list(range(len(points))), []
    for v in sorted(left, key=lambda v: points[v], reverse=True)[:-2]:
        k = left.index(v)
        triangles.append((left[k - 1], v, left[(k + 1) % len(left)]))
        del left[k]
    return points, [(1 + x * x / 64, x * y / 64, 1 + y * y / 64) for x, y in points], triangles


# Ties of different kinds, and near ties: with steps of a tenth the doubles are not symmetric.
TIES = {"product of two lines": lattice(1.0, lambda x, y: (1 + x / 8, 0.0, 1 + y / 4)),
        "mirrored": lattice(1.0, lambda x, y: (1 + x / 8, 0.0, 1 + x * x / 16)),
        "nearly mirrored": lattice(0.1, lambda x, y: (1 + x / 8, 0.0, 1 + math.sqrt(x))),
        "nearly a product": lattice(0.1, lambda x, y: (1 + x / 8, 0.0, 1 + math.sqrt(y))),
        "ring": ring()}


class Proofs(command.CommandTest):
    def make(self, domain, *words, status=0):
        self.write("d.poly", domain)
        done = self.run_command("mesh", "d.poly", *words, "--quiet", "-o", "m.mesh", "--proof", "m.proof")
        self.assertEqual(done.returncode, status, done.stderr)
        return done

    def make_of(self, domain, *words):
        done = self.run_command("mesh", domain, *words, "--quiet", "-o", "m.mesh", "--proof", "m.proof")
        self.assertEqual(done.returncode, 0, done.stderr)

    def check(self, status, *words, domain="d.poly", metric="m.sol", bound="20"):
        arguments = ["m.mesh", "m.proof", "--angle-bound", bound, "--metric", metric, *words]
        arguments += ["--domain", domain] if domain else []
        done = subprocess.run([sys.executable, str(CHECKER), *arguments], cwd=self.folder,
                              capture_output=True, text=True, check=False)
        self.assertEqual(done.returncode, status, done.stdout + done.stderr)
        same = self.run_command("check", *arguments)
        self.assertEqual(same.returncode, status, same.stdout + same.stderr)
        return done.stdout + done.stderr

    def test_meshes_of_many_metrics_are_proved(self):
        for metric, size in (("swirl:12", "0.1"), ("sink:24", "0.2"), ("shock:9", "0.1"), ("identity", "0.1"),
                             ("layer:0.02,0.3", "1"), ("expr:1+9*x^2;0.5*x*y;1+y^2", "0.1")):
            with self.subTest(metric=metric):
                self.make(SQUARE, "--metric", metric, "--size", size)
                self.assertRegex(self.check(0), r"^proved: \d+ sites, \d+ triangles, no angle below 20")
                self.check(0, domain=None)

    def test_holes_regions_points_and_segments_inside(self):
        self.make(ROOMS, "--metric", "sink:3", "--size", "0.4")
        self.check(0)
        for old, new in (("1 1.25 1.25\n", "1 2 2\n"),  # the hole elsewhere
                         ("1\n1 1.25 1.25\n", "0\n"),  # no hole
                         ("1 5.5 3.5 7", "1 5.5 3.5 8"),  # the region's number changed
                         ("12 12 13 4", "12 12 13 5"),  # the marker changed
                         ("15 4.125 2", "15 4.125 2.0001")):  # the point moved
            self.assertIn(old, ROOMS)
            self.write("d.poly", ROOMS.replace(old, new))
            self.assertIn("NOT proved: ", self.check(1))
        self.write("d.poly", ROOMS.replace("2\n13 1\n", "2\n12 1\n").replace("13 14 15 5\n", ""))
        self.assertIn("are no segment's", self.check(1))

    def test_a_corner_below_the_bound_is_exempt_and_no_other(self):
        self.make("3 2 0 0\n1 0 0\n2 4 0\n3 4 1\n3 0\n1 1 2\n2 2 3\n3 3 1\n0\n0\n", "--size", "0.3")
        self.check(0)
        self.assertIn("has an angle below the bound", self.check(1, domain="d.poly", bound="35"))

    def test_what_cannot_be_said(self):
        self.make(SQUARE, "--metric", "swirl:3", "--size", "0.3")
        for tolerance in ("-1", "nan", "inf", "soon"):
            self.assertIn("--metric-tolerance", self.check(2, f"--metric-tolerance={tolerance}"))
        self.assertIn("only a .sol file", self.check(2, metric="swirl:3"))
        self.write("curve.poly", CURVE)
        self.assertIn("curves", self.check(2, domain="curve.poly"))
        self.check(2, domain="none.poly")

    def test_every_form_of_domain_in_its_plain_form(self):
        """Domains of GeoJSON with features, well-known text, a built-in name, a mesh with a hole, and edges alone."""
        self.write("lake.geojson", LAKE)
        self.write("two.wkt", "MULTIPOLYGON (((0 0, 5 0, 5 4, 0 4, 0 0), (1 1, 2 1, 2 2, 1 2, 1 1)), "
                              "((7 0, 9 0, 9 3, 7 3, 7 0)))")
        self.write("edges.mesh", EDGES)
        done = self.run_command("mesh", "lake.geojson", "--size", "0.8", "--quiet", "-o", "lake.mesh")
        self.assertEqual(done.returncode, 0, done.stderr)
        for domain in ("lake.geojson", "two.wkt", "square", "lake.mesh", "edges.mesh"):
            with self.subTest(domain=domain):
                self.make_of(domain, "--metric", "sink:3", "--size", "0.8")
                done = self.run_command("convert", domain, "plain.poly")
                self.assertEqual((done.returncode, done.stderr), (0, ""))
                self.check(0, domain="plain.poly")
                same = self.run_command("check", "m.mesh", "m.proof", "--angle-bound", "20", "--metric",
                                        "m.sol", "--domain", domain)
                self.assertEqual(same.returncode, 0, same.stdout + same.stderr)

    def test_a_plain_form_says_what_is_inside(self):
        self.write("lake.geojson", LAKE)
        self.make_of("lake.geojson", "--size", "0.8")
        self.assertEqual(self.run_command("convert", "lake.geojson", "d.poly").returncode, 0)
        rows = (self.folder / "d.poly").read_text().splitlines()
        # The domain has one hole, the ring of water around the island, and a number for each of three features.
        self.assertEqual((rows[-6], rows[-4]), ("1", "3"))
        self.assertEqual([row.split()[-1] for row in rows[-3:]], ["1", "2", "3"])
        for k, other in ((-5, "1 2 1.9"), (-1, rows[-1][:-1] + "4")):  # a hole on the island; another number
            self.write("other.poly", "\n".join([*rows[:k], other, *rows[len(rows) + k + 1:]]) + "\n")
            self.assertIn("NOT proved", self.check(1, domain="other.poly"))
        again = self.run_command("convert", "d.poly", "again.poly")
        self.assertEqual(again.returncode, 0, again.stderr)
        self.assertEqual((self.folder / "again.poly").read_text().splitlines(), rows)

    def test_a_repaired_domain_is_checked_as_it_was_repaired(self):
        crossed = "4 2\n1 0 0\n2 3 2\n3 3 0\n4 0 2\n4 1\n1 1 2 1\n2 2 3 2\n3 3 4 3\n4 4 1 4\n0\n0\n"
        self.write("crossed.poly", crossed)
        self.make_of("crossed.poly", "--repair-domain", "--metric", "sink:3", "--size", "0.8")
        self.assertEqual(self.run_command("convert", "crossed.poly", "no.poly").returncode, 2)
        done = self.run_command("convert", "crossed.poly", "repaired.poly", "--repair-domain")
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertIn("asterism: note: ", done.stderr)
        self.check(0, domain="repaired.poly")
        self.assertIn("NOT proved", self.check(1, domain="crossed.poly"))
        done = self.run_command("convert", "crossed.poly", "far.poly", "--repair-domain", "--repair-distance", "0.5")
        self.assertEqual(done.returncode, 0, done.stderr)
        for words, said in ((("m.mesh", "n.mesh", "--repair-domain"), "--repair-domain is of domains"),
                            (("crossed.poly", "n.poly", "--repair-distance", "1"), "--repair-domain")):
            done = self.run_command("convert", *words)
            self.assertEqual(done.returncode, 2, done.stderr)
            self.assertIn(said, done.stderr)

    def test_what_is_no_plain_form(self):
        self.write("curve.poly", CURVE)
        for words, said in ((("curve.poly", "out.poly"), "it has curves"),
                            (("square", "out.poly", "--metric", "swirl:3"), "are of meshes"),
                            (("none.poly", "out.poly"), "none.poly"),
                            (("curve.poly", "curve.poly"), "is the file to read; name another one")):
            done = self.run_command("convert", *words)
            self.assertEqual(done.returncode, 2, done.stderr)
            self.assertIn(said, done.stderr)
            self.assertNotIn("out.poly", self.files())

    def test_a_domain_that_ends_early_is_told(self):
        self.make(SQUARE, "--size", "0.8")
        for rows in ("2\n1 5 5\n", "0\n1\n"):  # one of two holes; no region of one
            self.write("short.poly", "\n".join(SQUARE.split("\n")[:-3]) + "\n" + rows)
            self.assertIn("ends early", self.check(2, domain="short.poly"))

    def test_a_metric_within_a_tolerance(self):
        """The bound of the proof is the one that `verify` measures by another route."""
        self.make(SQUARE, "--metric", "expr:(x>0.5)?100:1;0;1", "--size", "0.25", "--metric-tolerance", "3")
        done = self.run_command("convert", "m.mesh", "asked.mesh", "--metric", "expr:(x>0.5)?100:1;0;1",
                                "--size", "0.25")
        self.assertEqual(done.returncode, 0, done.stderr)
        measured = self.run_command("verify", "m.mesh").stdout
        apart = float(re.search(r"as long or as short \(([0-9.e+-]+)\)", measured).group(1))
        self.assertGreater(apart, 0.1)
        self.check(0, "--metric-tolerance", repr(apart * (1 + 1e-4)), metric="asked.sol")
        said = self.check(1, "--metric-tolerance", repr(apart * (1 - 1e-4)), metric="asked.sol")
        self.assertIn("farther than the tolerance", said)
        self.check(1, "--metric-tolerance", "0", metric="asked.sol")
        self.check(0, "--metric-tolerance", "0")
        self.check(0, "--metric-tolerance", "1e300", metric="asked.sol")
        self.write("few.sol", "MeshVersionFormatted 2\nDimension 2\nSolAtVertices 1\n1 3\n1 0 1\nEnd\n")
        self.check_fails("few.sol")

    def check_fails(self, metric):
        words = ["m.mesh", "m.proof", "--angle-bound", "20", "--metric", metric, "--metric-tolerance", "1"]
        done = subprocess.run([sys.executable, str(CHECKER), *words], cwd=self.folder, capture_output=True,
                              text=True, check=False)
        self.assertIn(done.returncode, (1, 2), done.stdout)
        self.assertIn(self.run_command("check", *words).returncode, (1, 2))

    def test_a_mesh_with_curves_is_proved_as_the_polygon_of_its_chords(self):
        self.make(CURVE, "--size", "0.3")
        self.check(0, domain=None)

    def check_curves(self, status, tolerance, domain="d.poly", *words):
        done = subprocess.run([sys.executable, str(CURVE_CHECKER), "m.mesh", "m.proof", "--domain", domain,
                               "--chord-tolerance", repr(tolerance), "--angle-bound", "20", "--metric", "m.sol",
                               *words], cwd=self.folder, capture_output=True, text=True, check=False)
        self.assertEqual(done.returncode, status, done.stdout + done.stderr)
        same = self.run_command("check", "m.mesh", "m.proof", "--domain", domain, f"--chord-tolerance={tolerance!r}",
                                "--angle-bound", "20", "--metric", "m.sol", *words)
        self.assertEqual(same.returncode, status, same.stdout + same.stderr)
        return done.stdout + done.stderr + same.stdout + same.stderr

    def test_curves_are_as_near_as_the_certificate_says(self):
        """Compares the bound with the auditor's, which has another derivation: the same number for arcs, nearly the
        same for cubics."""
        for domain, slack in ((CURVE, 1e-12), (HALF, 1e-12), (BENT, 1e-6), (SPLINES, 1e-6)):
            with self.subTest(domain=domain):
                self.make(domain, "--metric", "sink:2", "--size", "0.3")
                claim = json.loads((self.folder / "m.certificate.json").read_text())
                nearest = claim["audit"]["curves"]["largest_distance"]
                self.assertIn(", its curves within ", self.check_curves(0, nearest * (1 + slack)))
                self.assertIn("no chords are along curve", self.check_curves(1, nearest * (1 - slack) * 0.99))
                self.check_curves(2, -1.0)

    def test_another_curve_is_not_proved(self):
        self.make(BENT, "--metric", "sink:2", "--size", "0.3")
        self.check_curves(0, 0.01)
        for old, new, status in (("1 -0.5 2", "1 -0.4 2", 1), ("2 3 1 ccw", "2 3 1 cw", 1),
                                 ("2 3 1 ccw", "2 3 1.2 ccw", 1), ("1.5 1 7", "1.5 1 8", 1),
                                 ("1.5 1 7", "1.5 1.01 7", 1), ("arc 2", "arc 4", 1), ("bezier 3", "bezier 1", 1),
                                 ("2 2.6 1 1.4", "1 1.4 2 2.6", 1), ("curves 4", "curves 3", 2),
                                 ("4 circle 5", "4 circle 6", 2), ("2 arc 2 3 1 ccw", "2 spline 2", 2),
                                 ("5 1.2 1", "5 1.2 1.0001", 1)):
            with self.subTest(new=new):
                self.assertIn(old, BENT)
                self.write("other.poly", BENT.replace(old, new))
                self.check_curves(status, 0.01, "other.poly")
        self.write("other.poly", BENT.replace("4 circle 5 1.5 1 7\n", "").replace("curves 4", "curves 3"))
        self.assertIn("NOT proved", self.check_curves(1, 0.01, "other.poly"))

    def test_a_vertex_off_its_curve_is_not_proved(self):
        self.make(CURVE, "--size", "0.5")
        claim = json.loads((self.folder / "m.certificate.json").read_text())
        nearest = claim["audit"]["curves"]["largest_distance"]
        lines = (self.folder / "m.mesh").read_text().splitlines()
        at = lines.index("Vertices") + 3  # the second vertex, at which the circle was divided
        x, y, _ = map(float, lines[at].split())
        self.assertAlmostEqual(math.hypot(x, y), 1)
        for factor in (0.98, 1.02):
            lines[at] = f"{x * factor!r} {y * factor!r} 0"
            self.write("m.mesh", "\n".join(lines) + "\n")
            self.assertIn("no chords are along curve 1", self.check_curves(1, nearest * (1 + 1e-12)))

    def test_a_mesh_that_is_not_certified_has_no_proof(self):
        done = self.make(SQUARE, "--metric", "expr:(x>0.5)?900:1;0;1", "--metric-tolerance", "0",
                         status=1)
        self.assertIn("no proof is written: ", done.stderr)
        self.assertNotIn("m.proof", self.files())

    def test_certify_writes_a_proof(self):
        self.make(SQUARE, "--metric", "swirl:3", "--size", "0.3")
        (self.folder / "m.proof").unlink()
        done = self.run_command("certify", "m.mesh", "--proof", "m.proof")
        self.assertEqual(done.returncode, 0, done.stderr)
        self.check(0)

    def certify(self, mesh, sol, status=0):
        self.write("m.mesh", mesh)
        self.write("m.sol", sol)
        done = self.run_command("certify", "m.mesh", "--angle-bound", "5", "--proof", "m.proof")
        self.assertEqual(done.returncode, status, done.stdout + done.stderr)

    def test_ties_of_several_metrics_are_proved(self):
        for name, made in TIES.items():
            with self.subTest(name):
                points, tensors, triangles = made
                mesh, sol = medit_texts(*made)
                self.certify(mesh, sol)
                self.check(0, domain=None, bound="5")
                size = (self.folder / "m.proof").stat().st_size
                self.assertLess(size, (3000 if name == "ring" else 300) * len(triangles))
                # Moves a vertex by 2^-40 (of the ring inwards), or changes its tensor: the weights then belong to
                # other sites.
                inside = 8 if name != "ring" else 0
                x, y = points[inside]
                points = [*points[:inside], (x - 2**-40 if name == "ring" else x + 2**-40, y), *points[inside + 1:]]
                self.write("m.mesh", medit_texts(points, tensors, triangles)[0])
                self.check(1, domain=None, bound="5")
                self.write("m.mesh", mesh)
                other = [*tensors[:inside], (2.0, 0.25, 2.0), *tensors[inside + 1:]]
                self.write("m.sol", medit_texts(points, other, triangles)[1])
                self.check(1, domain=None, bound="5")

    def test_the_other_diagonal_of_a_tie_is_not_proved(self):
        points, tensors, triangles = TIES["mirrored"]
        self.certify(*medit_texts(points, tensors, triangles))
        flipped = [(0, 6, 7), (0, 7, 1), *triangles[2:]]
        self.write("m.mesh", medit_texts(points, tensors, flipped)[0])
        self.check(1, domain=None, bound="5")
        self.run_command("certify", "m.mesh", "--angle-bound", "5", "--proof", "n.proof")
        self.assertNotIn("n.proof", self.files())

    def test_symmetric_domains_with_symmetric_metrics(self):
        for words in (("square", "--metric", "swirl:12", "--random-points", "10"),
                      ("square", "--metric", "swirl:12", "--size", "0.8")):
            with self.subTest(words):
                self.make_of(*words)
                self.check(0, domain=None)

    def test_edges_of_which_a_neighbour_looks_away_are_proved(self):
        # At all places of an edge's arc, the product of a neighbour with its end is negative.
        corners = [(math.cos(2 * math.pi * i / 5), math.sin(2 * math.pi * i / 5)) for i in range(5)]
        pentagon = "5 2 0 0\n" + "".join(f"{i + 1} {x!r} {y!r}\n" for i, (x, y) in enumerate(corners)) + "5 1\n" + (
            "".join(f"{i + 1} {i + 1} {(i + 1) % 5 + 1} 1\n" for i in range(5)) + "0\n0\n")
        wide = SQUARE.replace("1 0 0\n2 1 0\n3 1 1\n4 0 1", "1 -1 -1\n2 1 -1\n3 1 1\n4 -1 1")
        for domain, metric, size in ((wide, "swirl:24", "0.6"), (wide, "swirl:24", "1"), (pentagon, "shock:6", "0.5")):
            with self.subTest(metric=metric, size=size):
                self.make(domain, "--metric", metric, "--size", size)
                self.check(0)

    def test_adapt_writes_a_proof(self):
        self.make(SQUARE, "--metric", "swirl:3", "--size", "0.3")
        done = self.run_command("adapt", "m.mesh", "--metric", "m.sol", "--vertices", "80", "--quiet",
                                "-o", "n.mesh", "--proof", "n.proof")
        self.assertEqual(done.returncode, 0, done.stderr)
        for end in ("mesh", "sol", "proof"):
            (self.folder / f"n.{end}").rename(self.folder / f"m.{end}")
        self.check(0, domain=None)


if __name__ == "__main__":
    unittest.main()
