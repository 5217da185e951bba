# SPDX-License-Identifier: MIT
"""Curves of a domain file through the real command: what is meshed, how far it is from the curves by the
certificate, and which curves are refused."""
import json
import math
import pathlib
import unittest

import command

HERE = pathlib.Path(__file__).resolve().parent
EXAMPLE = HERE.parents[1] / "examples/fillets.poly"


def poly(vertices, segments, curves, holes=()):
    """A .poly file; numbers from 1. Curves are the words after their numbers."""
    rows = [(vertices, " 2"), (segments, " 1"), (holes, ""), ((), "")]
    text = "".join(f"{len(items)}{more}\n" + "".join(f"{i} {' '.join(map(str, item))}\n"
                                                    for i, item in enumerate(items, 1))
                   for items, more in rows)
    return text + f"curves {len(curves)}\n" + "".join(f"{i} {c}\n" for i, c in enumerate(curves, 1))


def disc(x=0, y=0, r=1):
    return poly([(x + r, y)], [], [f"circle 1 {x} {y} 7"])


TRIANGLE = [(1, 2, 1), (2, 3, 2), (3, 1, 3)]


class Curves(command.CommandTest):
    def mesh(self, text, *options):
        self.write("d.poly", text)
        done = self.run_command("mesh", "d.poly", *options, "-o", "d.mesh")
        self.assertEqual(done.returncode, 0, done.stderr)
        return self.checked(["--regions"] if "--regions" in options else [])

    def checked(self, named):
        """Returns the certificate, after `verify` has proved it again by its own words and against the file."""
        for more in ([], ["--domain", "d.poly", *named]):
            done = self.run_command("verify", "d.mesh", *more)
            self.assertEqual(done.returncode, 0, done.stdout + done.stderr)
        return json.loads((self.folder / "d.certificate.json").read_text())

    def refused(self, text, *words, options=()):
        self.write("d.poly", text)
        done = self.run_command("mesh", "d.poly", *options, "-o", "d.mesh")
        self.assertEqual(done.returncode, 2, done.stdout + done.stderr)
        for word in words:
            self.assertIn(word, done.stderr)
        self.assertEqual(self.files(), ["d.poly"])

    def vertices_of_mesh(self):
        lines = (self.folder / "d.mesh").read_text().split("\n")
        start, count = command.section(lines, "Vertices")
        return [tuple(map(float, line.split()[:2])) for line in lines[start:start + count]]

    def test_a_disc_of_one_circle(self):
        made = self.mesh(disc(), "--size", "0.2")
        told = made["audit"]["curves"]
        chords = len(made["domain"]["curves"][0]["vertices"]) - 1
        self.assertEqual((told["curves"], told["vertices_off"]), (1, 0))
        # A chord over an n-th of a unit circle is 1 - cos(pi / n) from it.
        height = 1 - math.cos(math.pi / chords)
        self.assertGreaterEqual(told["largest_distance"], height * (1 - 1e-9))
        self.assertLess(told["largest_distance"], height * 1.01)
        on = sum(abs(math.hypot(x, y) - 1) < 1e-15 for x, y in self.vertices_of_mesh())
        self.assertEqual(on, told["vertices"])

    def test_a_chord_tolerance_is_kept(self):
        told = self.mesh(disc(), "--chord-tolerance", "1e-4")["audit"]["curves"]
        self.assertLessEqual(told["largest_distance"], 1e-4)

    def test_an_annulus_has_its_hole(self):
        made = self.mesh(poly([(2, 0), (1, 0)], [], ["circle 1 0 0 1", "circle 2 0 0 2"],
                              [(0, 0)]), "--size", "0.3")
        self.assertEqual(made["audit"]["curves"]["curves"], 2)
        self.assertTrue(all(0.999 < math.hypot(x, y) < 2.001 for x, y in self.vertices_of_mesh()))

    def test_a_thin_annulus_whose_chords_would_cross(self):
        self.mesh(poly([(1, 0), (0.999, 0)], [], ["circle 1 0 0 1", "circle 2 0 0 2"], [(0, 0)]))

    def test_points_near_a_circle_stay_on_their_side(self):
        # All three points lie between the circle and the chords that it would have without them.
        near = [(0.9999 * math.cos(a), 0.9999 * math.sin(a)) for a in (0.3, 1.1, 2.9)]
        made = self.mesh(poly([(1, 0), *near], [], ["circle 1 0 0 1"]))
        self.assertEqual(made["mesh"]["given"] - len(made["domain"]["curves"][0]["vertices"]) + 1, 3)

    def test_the_plate_of_the_manual(self):
        told = self.mesh(EXAMPLE.read_text(), "--size", "0.15")["audit"]["curves"]
        self.assertEqual(told["curves"], 5)
        self.assertLess(told["largest_distance"], 0.0022)

    def test_an_airfoil_of_a_spline(self):
        text = (HERE / "spline_airfoil.poly").read_text()
        made = self.mesh(text, "--size", "0.2", "--chord-tolerance", "1e-4")
        self.assertEqual(made["audit"]["curves"]["curves"], 16)
        self.assertLessEqual(made["audit"]["curves"]["largest_distance"], 1.001e-4)

    def test_chords_are_split_on_the_curve(self):
        # Without a size, the chords of the circle, four times an eighth of a turn, are split for the angles near the
        # hole.
        ring = [(1.05, 0), (1.05, 0.02), (1.03, 0.02), (1.03, 0)]
        sides = [(2, 3, 1), (3, 4, 1), (4, 5, 1), (5, 2, 1)]
        text = poly([(1.1, 0), *ring], sides, ["circle 1 0 0 7"], [(1.04, 0.01)])
        for more in ([], ["--refine", "voronoi"], ["--size", "0.3", "--metric", "swirl:2"]):
            with self.subTest(more):
                made = self.mesh(text, "--chord-tolerance", "0.2", *more)
                told, chain = made["audit"]["curves"], made["domain"]["curves"][0]["vertices"]
                self.assertGreater(told["vertices"], len(chain) - 1)
                on = sum(abs(math.hypot(x, y) - 1.1) < 1e-15 for x, y in self.vertices_of_mesh())
                self.assertEqual(on, told["vertices"])

    def test_a_cubic_is_the_bezier_curve_of_its_control_points(self):
        made = self.mesh(poly([(0, 0), (1, 0), (0.5, -1)], TRIANGLE, ["bezier 1 0.2 0.7 0.8 0.7"]),
                         "--size", "0.2")
        domain = made["domain"]
        curve = domain["curves"][0]
        for v, t in zip(curve["vertices"], curve["parameters"]):
            x, y = domain["vertices"][v - 1]
            s = 1 - t
            self.assertAlmostEqual(x, 3 * s * s * t * 0.2 + 3 * s * t * t * 0.8 + t ** 3, delta=1e-14)
            self.assertAlmostEqual(y, 3 * s * t * 0.7, delta=1e-14)

    def test_a_curve_inside_divides_the_domain(self):
        square = [(-2, -2), (2, -2), (2, 2), (-2, 2)]
        sides = [(1, 2, 1), (2, 3, 1), (3, 4, 1), (4, 1, 1)]
        made = self.mesh(poly([*square, (1, 0)], sides, ["circle 5 0 0 4"]), "--size", "0.5", "--regions")
        inside = [s for s in made["domain"]["segments"] if len(s) == 6]
        self.assertGreater(len(inside), 8)
        self.assertTrue(all(s[2] == 4 and s[3] == 1 for s in inside))

    def test_sizes_far_from_one(self):
        for x, r in ((0, 1e-9), (0, 1e12), (1e9, 1)):
            with self.subTest((x, r)):
                self.mesh(disc(x, 0, r))

    def test_a_distance_that_is_claimed_too_small_is_refused(self):
        made = self.mesh(disc(), "--size", "0.3")
        made["audit"]["curves"]["largest_distance"] /= 2
        self.write("d.certificate.json", json.dumps(made))
        done = self.run_command("verify", "d.mesh")
        self.assertEqual(done.returncode, 1)
        self.assertIn("audit.curves.largest_distance", done.stdout)

    def test_another_radius_in_the_file_is_refused(self):
        self.mesh(disc(), "--size", "0.3")
        self.write("d.poly", disc().replace("circle 1 0 0", "circle 1 1e-6 0"))
        done = self.run_command("verify", "d.mesh", "--domain", "d.poly")
        self.assertEqual(done.returncode, 1)

    def test_what_needs_no_repair_is_meshed_with_that_option_too(self):
        self.mesh(EXAMPLE.read_text(), "--size", "0.2")
        plain = (self.folder / "d.mesh").read_bytes()
        self.mesh(EXAMPLE.read_text(), "--size", "0.2", "--repair-domain")
        self.assertEqual(plain, (self.folder / "d.mesh").read_bytes())

    def test_a_fault_beside_curves_is_not_repaired_and_the_message_says_why(self):
        gap = EXAMPLE.read_text().replace("\n1 1 2 1\n", "\n1 1 3 1\n")
        why = ("--repair-domain mends no domain with curves", "the boundary is not closed", "d.poly:")
        self.refused(gap, *why, options=["--repair-domain"])
        crossing = poly([(1, 0), (1.5, 0)], [], ["circle 1 0 0", "circle 2 1 0"])
        self.refused(crossing, why[0], "crosses or touches curve 2", options=["--repair-domain"])

    def test_an_adapted_mesh_keeps_to_the_curves_of_its_domain_file(self):
        self.mesh(disc(), "--size", "0.3")
        values = [math.tanh(9 * (x - 0.3 * y)) for x, y in self.vertices_of_mesh()]
        self.write("u.bb", f"2 1 {len(values)} 2\n" + "".join(f"{u!r}\n" for u in values))
        done = self.run_command("adapt", "d.mesh", "--solution", "u.bb", "--vertices", "400", "--domain", "d.poly",
                                "--chord-tolerance", "1e-3", "-o", "next.mesh")
        self.assertEqual(done.returncode, 0, done.stderr)
        done = self.run_command("verify", "next.mesh", "--domain", "d.poly", "--json")
        self.assertEqual(done.returncode, 0, done.stdout + done.stderr)
        told = json.loads(done.stdout)
        self.assertLess(told["distance_from_curves"], 1.1e-3)

    def solved(self, mesh):
        values = [math.tanh(9 * (x - 0.3 * y)) for x, y in self.vertices_of_mesh()]
        self.write("u.bb", f"2 1 {len(values)} 2\n" + "".join(f"{u!r}\n" for u in values))
        return [mesh, "--solution", "u.bb"]

    def test_new_vertices_of_an_adapted_mesh_are_on_the_curve(self):
        self.mesh(disc(), "--size", "0.5")
        for more in (["--chord-tolerance", "0.05"], []):
            with self.subTest(more):
                done = self.run_command("adapt", *self.solved("d.mesh"), "--vertices", "1500", "--domain", "d.poly",
                                        *more, "-o", "next.mesh")
                self.assertEqual(done.returncode, 0, done.stderr)
                told = json.loads((self.folder / "next.certificate.json").read_text())
                edges = [e for e in told["domain"]["segments"] if e[2] == 7]
                self.assertEqual(told["audit"]["curves"]["vertices_off"], 0)
                self.assertGreaterEqual(told["audit"]["curves"]["vertices"], len(edges))
                self.assertEqual(told["audit"]["curves"]["vertices"], told["mesh"]["boundary_edges"])
                self.assertEqual(self.run_command("verify", "next.mesh", "--domain", "d.poly").returncode, 0)

    def test_chords_follow_the_size_across(self):
        # Layers along the circle: edges a fifth as wide as long.
        layer = ["--size", "1", "--metric", "expr:100+2400*x*x;2400*x*y;100+2400*y*y"]
        made = self.mesh(disc(), *layer)
        self.assertLess(made["audit"]["curves"]["largest_distance"], 0.0201 / 50)
        named = self.mesh(disc(), *layer, "--chord-tolerance", "0.01")
        chords, coarse = (len(m["domain"]["curves"][0]["vertices"]) - 1 for m in (made, named))
        self.assertEqual(chords, 2 * coarse)

    def test_chords_finer_than_the_metric_have_room_beside_them(self):
        """Triangles on short chords had the height of a wanted edge, so that half of the tensors were replaced and
        lengths differed by a factor of ten. The mesh has fewer vertices than wanted. With 1900 two angles at chords
        stay low until there are nodes beside them; lengths differed as much then."""
        square, sides = [(-2, -2), (2, -2), (2, 2), (-2, 2)], [(1, 2, 1), (2, 3, 1), (3, 4, 1), (4, 1, 1)]
        self.mesh(poly([*square, (0.5, 0)], sides, ["circle 5 0 0 2"], [(0, 0)]), "--size", "0.15")
        # The circle begins at another vertex, so that no end of its chords is a vertex of the mesh.
        self.write("turned.poly", poly([*square, (0.3, 0.4)], sides, ["circle 5 0 0 2"], [(0, 0)]))
        solved = self.solved("d.mesh")
        for wanted in (900, 1900, 2250):
            done = self.run_command("adapt", *solved, "--vertices", str(wanted), "--domain", "turned.poly",
                                    "--chord-tolerance", "1e-4", "-o", "next.mesh")
            self.assertEqual(done.returncode, 0, done.stdout + done.stderr)
            told = json.loads((self.folder / "next.certificate.json").read_text())
            self.assertGreater(told["audit"]["curves"]["vertices"], math.pi / math.sqrt(2 * 1e-4 / 0.5))
            delivered = told["outcome"]["delivered"]
            if wanted > 900:
                self.assertLess(delivered["median"], 0.1, delivered)

    def test_the_boundary_of_a_mesh_is_kept_to_within_a_distance(self):
        self.mesh(disc(), "--size", "0.3")
        (self.folder / "d.poly").unlink()
        job = ["adapt", *self.solved("d.mesh"), "--vertices", "1500"]
        sagitta = {}
        for name, more in (("free", []), ("near", ["--hausd", "1e-4"]), ("far", ["--hausd", "0.02"])):
            done = self.run_command(*job, *more, "-o", f"{name}.mesh")
            self.assertEqual(done.returncode, 0, done.stderr)
            self.assertIn("old and new boundary within", done.stdout)
            told = json.loads((self.folder / f"{name}.certificate.json").read_text())
            sagitta[name] = told["audit"]["former_boundary"]["largest_distance"]
            self.assertEqual(told["former_boundary"]["allowed"], float(more[1]) if more else None)
            checked = self.run_command("verify", f"{name}.mesh")
            self.assertEqual(checked.returncode, 0, checked.stdout)
        self.assertLessEqual(sagitta["near"], 1e-4)
        self.assertLessEqual(sagitta["far"], 0.02)
        self.assertGreater(sagitta["free"], 1e-4)
        for refused in (["--hausd", "0"], ["--hausd", "nan"], ["--hausd", "1e-15"],
                        ["--hausd", "1e-3", "--domain", "square"]):
            done = self.run_command(*job, *refused, "-o", "no.mesh")
            self.assertEqual(done.returncode, 2, refused)
        self.assertFalse((self.folder / "no.mesh").exists())

    def test_a_part_of_the_size_takes_the_place_of_the_hundredths(self):
        self.mesh(disc(), "--size", "0.1")
        job = ["adapt", *self.solved("d.mesh"), "--vertices", "300"]
        gone = {}
        for part in (None, "0.01", "0.0353553"):
            done = self.run_command(*job, *(["--boundary-part", part] if part else []), "-o", "n.mesh")
            self.assertEqual(done.returncode, 0, done.stderr)
            told = json.loads((self.folder / "n.certificate.json").read_text())
            gone[part] = told["audit"].get("former_boundary", {}).get("vertices_gone", 0)
            self.assertEqual(told["asked"]["options"].get("boundary-part"), part)
            checked = self.run_command("verify", "n.mesh")
            self.assertEqual(checked.returncode, 0, checked.stdout)
        self.assertGreater(gone["0.0353553"], gone["0.01"] + 20)
        self.assertGreaterEqual(gone[None], gone["0.01"])
        told["asked"]["options"]["boundary-part"] = "0.02"
        self.write("n.certificate.json", json.dumps(told))
        self.assertEqual(self.run_command("verify", "n.mesh").returncode, 1)
        for refused in (["--boundary-part", "0"], ["--boundary-part", "0.2"],
                        ["--boundary-part", "0.02", "--domain", "square"]):
            done = self.run_command(*job, *refused, "-o", "no.mesh")
            self.assertEqual(done.returncode, 2, refused)

    def test_sides_that_bend_take_no_more_vertices_than_are_wanted(self):
        """A channel of 40 rows with bent sides, and a solution with two layers across it: along the sides unit edges
        between the layers are many times as long as the rows."""
        rows = 40
        places = [(i / rows + math.sin(2 * math.pi * j / rows) / 8, j / rows)
                  for j in range(rows + 1) for i in range(rows + 1)]
        first = [j * (rows + 1) + i + 1 for j in range(rows) for i in range(rows)]
        triangles = [t for a in first for t in ((a, a + 1, a + rows + 2), (a, a + rows + 2, a + rows + 1))]
        self.write("c.mesh", "MeshVersionFormatted 2\nDimension 2\n"
                   + f"Vertices\n{len(places)}\n" + "".join(f"{x!r} {y!r} 0\n" for x, y in places)
                   + f"Triangles\n{len(triangles)}\n" + "".join(f"{a} {b} {c} 1\n" for a, b, c in triangles)
                   + "End\n")
        self.write("u.sol", f"MeshVersionFormatted 2\nDimension 2\nSolAtVertices\n{len(places)}\n1 1\n"
                   + "".join(f"{math.tanh(20 * math.sin(2 * math.pi * y))!r}\n" for x, y in places) + "End\n")
        job = ["adapt", "c.mesh", "--solution", "u.sol", "--vertices", "350", "-o", "n.mesh"]
        done = self.run_command(*job)
        self.assertEqual(done.returncode, 0, done.stderr)
        checked = self.run_command("verify", "n.mesh")
        self.assertEqual(checked.returncode, 0, checked.stdout)
        done = self.run_command(*job, "--boundary-part", "0.01")
        self.assertEqual(done.returncode, 1)
        self.assertIn("asterism: try --boundary-part 0.04, ", done.stderr)
        self.assertEqual(self.run_command(*job, "--boundary-part", "0.04").returncode, 0)

    def test_what_is_forged_of_the_former_boundary_is_refused(self):
        self.mesh(disc(), "--size", "0.1")
        job = ["adapt", *self.solved("d.mesh"), "--vertices", "120", "--hausd", "0.02", "-o", "n.mesh"]
        done = self.run_command(*job)
        self.assertEqual(done.returncode, 0, done.stderr)
        made = json.loads((self.folder / "n.certificate.json").read_text())
        self.assertGreater(made["audit"]["former_boundary"]["vertices_gone"], 10)

        def forged(change, word):
            claim = json.loads(json.dumps(made))
            change(claim)
            self.write("n.certificate.json", json.dumps(claim))
            done = self.run_command("verify", "n.mesh")
            self.assertEqual(done.returncode, 1, word)
            self.assertIn(word, done.stdout + done.stderr)

        def nearer(c):
            c["audit"]["former_boundary"]["largest_distance"] *= 0.99

        def fewer(c):
            c["audit"]["former_boundary"]["vertices_gone"] -= 1

        def wider(c):
            c["former_boundary"]["allowed"] = 1

        def other(c):
            c["former_boundary"]["segments"].pop()

        def none(c):
            del c["former_boundary"], c["audit"]["former_boundary"]

        def stricter(c):
            c["former_boundary"]["allowed"] = 1e-6
            c["asked"]["options"]["hausd"] = "1e-06"
        forged(nearer, "audit.former_boundary.largest_distance")
        forged(fewer, "audit.former_boundary.vertices_gone")
        forged(wider, "asked.options.hausd")
        forged(other, "former")
        forged(none, "former_boundary")
        forged(stricter, "was asked for")

    def test_curves_that_mean_nothing_are_refused(self):
        ends = [(1, 0), (0, 1), (0, 0)]
        self.refused(poly([(0, 0)], [], ["circle 1 0 0"]), "d.poly:7:", "radius of 0")
        self.refused(poly([(1, 0)], [], ["circle 1 nan 0"]), "d.poly:7:", "'nan' is not finite")
        self.refused(poly([(1, 0)], [], ["circle 2 0 0"]), "d.poly:7:", "vertex '2' does not exist")
        self.refused(poly([(1, 0)], [], ["ellipse 1 0 0"]), "d.poly:7:", "no kind of curve")
        self.refused(poly([(1e200, 0)], [], ["circle 1 -1e200 0"]), "beyond the range of doubles")
        self.refused(poly([(1, 0), (0, 1.1), (0, 0)], TRIANGLE, ["arc 1 0 0 ccw"]), "d.poly:12:",
                     "does not end on its circle", "1.1")
        self.refused(poly(ends, TRIANGLE, ["arc 1 0 0 left"]), "'left' is no direction")
        self.refused(poly(ends, TRIANGLE, ["arc 1 0 0 ccw", "bezier 1 1 1 1 1"]),
                     "which another curve is on")
        self.refused(poly([*ends[:2], (0, 1)], TRIANGLE, ["spline 1 2 3"]), "segment '2' has no length")
        self.refused(poly([*ends, (3, 3)], [*TRIANGLE, (3, 4, 1)], ["spline 1 4"]),
                     "does not start where the one before it ends")
        self.refused(disc(), "million chords", options=["--chord-tolerance", "1e-30"])

    def test_curves_that_meet_something_are_refused(self):
        self.refused(poly([(1, 0), (0, 1), (0, 0), (0.6, 0.8)], TRIANGLE, ["arc 1 0 0 ccw"]),
                     "passes through vertex 4 (0.6, 0.8)")
        self.refused(poly([(1, 0), (1.5, 0)], [], ["circle 1 0 0", "circle 2 1 0"]),
                     "curve 1 crosses or touches curve 2 near (0.")
        self.refused(poly([(1, 0), (-1, 0)], [], ["circle 1 0 0", "circle 2 0 0"]), "crosses or touches")
        self.refused(poly([(1, 0), (0.2, 0)], [], ["circle 1 0 0", "circle 2 0.6 0"]),
                     "crosses or touches")
        self.refused(poly([(0, 0), (1, 0)], [(1, 2, 1)], ["bezier 1 5 5 -4 5"]), "itself")
        # The first wedge crosses the circle twice within one chord and meets no chord.
        wedge = [(1, 0), (0.9995, 0.01), (1.2, 0), (1.2, 0.02), (0.9995, 0.02)]
        ring = [(2, 3, 1), (3, 4, 1), (4, 5, 1), (5, 2, 1)]
        self.refused(poly(wedge, ring, ["circle 1 0 0"]), "crosses or touches segment")


if __name__ == "__main__":
    unittest.main()
