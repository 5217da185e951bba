# SPDX-License-Identifier: MIT
"""Triangles of second order through the real command: written to .msh, .msh2 and .vtu, with nodes on the
domain's curves, proved to fold nowhere, proved again by `verify`, refused where they fold."""
import json
import math
import re
import unittest

import command

DISC = "1 2\n1 1 0\n0 1\n0\n0\ncurves 1\n1 circle 1 0 0 7\n"
# A plate with a round hole: straight sides and an arc.
PLATE = ("5 2\n1 -2 -2\n2 2 -2\n3 2 2\n4 -2 2\n5 0.7 0\n4 1\n1 1 2 1\n2 2 3 2\n3 3 4 3\n4 4 1 4\n"
         "1\n1 0 0\n0\ncurves 1\n1 circle 5 0 0 9\n")


def elements(path):
    """Returns nodes, and elements by type, of a .msh of version 2."""
    text = path.read_text()
    body = {head: rows.split("\n") for head, rows in
            re.findall(r"\$(Nodes|Elements)\n\d+\n(.*?)\n\$End", text, re.S)}
    nodes = {int(w[0]): (float(w[1]), float(w[2])) for w in map(str.split, body["Nodes"])}
    kinds = {}
    for w in map(str.split, body["Elements"]):
        kinds.setdefault(int(w[1]), []).append([int(x) for x in w[3 + int(w[2]):]])
    return nodes, kinds


class SecondOrder(command.CommandTest):
    def mesh(self, text, *options):
        self.write("d.poly", text)
        done = self.run_command("mesh", "d.poly", *options)
        self.assertEqual(done.returncode, 0, done.stdout + done.stderr)
        return done

    def claim(self, name="d"):
        return json.loads((self.folder / f"{name}.certificate.json").read_text())["second_order"]

    def test_nodes_are_on_the_circle_and_elsewhere_in_the_middle(self):
        done = self.mesh(PLATE, "--size", "0.5", "--order", "2", "-o", "d.msh2")
        self.assertIn("no triangle folds", done.stdout)
        nodes, kinds = elements(self.folder / "d.msh2")
        self.assertEqual(set(kinds), {15, 8, 9})
        on_circle = 0
        for a, b, m in kinds[8]:
            p, q, x = nodes[a], nodes[b], nodes[m]
            ends_on = all(abs(math.hypot(*v) - 0.7) < 1e-12 for v in (p, q))
            if ends_on:
                on_circle += 1
                self.assertAlmostEqual(math.hypot(*x), 0.7, delta=1e-15)
                self.assertAlmostEqual(math.dist(x, p), math.dist(x, q), delta=1e-14)
            else:
                self.assertEqual(x, ((p[0] + q[0]) / 2, (p[1] + q[1]) / 2))
        self.assertGreater(on_circle, 6)
        told = self.claim()
        self.assertEqual(told["curved_sides"], on_circle)
        self.assertEqual(told["on_curves"], on_circle)
        self.assertEqual(told["triangles"], len(kinds[9]))
        self.assertTrue(told["proved"])
        # The area of the curved mesh equals the plate's to fourth order. The straight mesh is off by 1 %.
        area = 0
        for a, b, c, d, e, f in kinds[9]:
            for p, q, m in ((a, b, d), (b, c, e), (c, a, f)):
                (px, py), (qx, qy), (mx, my) = nodes[p], nodes[q], nodes[m]
                area += (px * qy - py * qx) / 2
                area += 2 / 3 * ((mx - px) * (qy - py) - (my - py) * (qx - px))
        self.assertAlmostEqual(area, 16 - math.pi * 0.49, delta=2e-4)

    def test_a_node_of_each_side_is_shared(self):
        self.mesh(DISC, "--size", "0.5", "--order", "2", "-o", "d.msh2")
        nodes, kinds = elements(self.folder / "d.msh2")
        of_side = {}
        for a, b, c, d, e, f in kinds[9]:
            for p, q, m in ((a, b, d), (b, c, e), (c, a, f)):
                of_side.setdefault(frozenset((p, q)), set()).add(m)
        for a, b, m in kinds[8]:
            of_side[frozenset((a, b))].add(m)
        self.assertTrue(all(len(m) == 1 for m in of_side.values()))
        self.assertEqual(len(nodes), len({v for t in kinds[9] for v in t}))

    def test_verify_proves_each_format_again(self):
        for name in ("d.msh", "d.msh2", "d.vtu"):
            with self.subTest(name):
                self.mesh(PLATE, "--size", "0.4", "--metric", "swirl:3", "--order", "2", "-o", name)
                for more in ([], ["--domain", "d.poly"]):
                    done = self.run_command("verify", name, *more)
                    self.assertEqual(done.returncode, 0, done.stdout + done.stderr)
                    self.assertIn("no triangle folds", done.stdout)
                    self.assertNotIn("note", done.stderr)
                told = json.loads(self.run_command("verify", name, "--json").stdout)["second_order"]
                self.assertEqual(told["on_curves"], self.claim()["on_curves"])
                done = self.run_command("certify", name)
                self.assertEqual(done.returncode, 0, done.stdout + done.stderr)
                self.assertIn("no triangle folds", done.stdout)

    def test_verify_refuses_a_node_that_was_moved(self):
        self.mesh(PLATE, "--size", "0.5", "--order", "2", "-o", "d.msh2")
        path = self.folder / "d.msh2"
        nodes, kinds = elements(path)
        a, b, m = next(e for e in kinds[8] if abs(math.hypot(*nodes[e[0]]) - 0.7) < 1e-9)
        text = path.read_text()
        for factor, said in ((1 + 1e-6, "on curves"), (3.0, "folded")):
            x, y = (c * factor for c in nodes[m])
            moved = re.sub(rf"^{m} \S+ \S+ 0$", f"{m} {x!r} {y!r} 0", text, count=1, flags=re.M)
            self.assertNotEqual(moved, text)
            path.write_text(moved)
            done = self.run_command("verify", "d.msh2")
            self.assertEqual(done.returncode, 1, done.stdout + done.stderr)
            self.assertIn(said, done.stdout)
        done = self.run_command("certify", "d.msh2")
        self.assertEqual(done.returncode, 1, done.stdout + done.stderr)
        self.assertIn("folded", done.stderr)
        done = self.run_command("convert", "d.msh2", "e.msh", "--order", "2")
        self.assertEqual(done.returncode, 2, done.stdout + done.stderr)
        self.assertIn("folds", done.stderr)

    def test_meshes_with_straight_sides_still_verify(self):
        self.mesh(PLATE, "--size", "0.5", "-o", "d.msh", "-o", "d.vtu")
        for name in ("d.msh", "d.vtu"):
            done = self.run_command("verify", name)
            self.assertEqual(done.returncode, 0, done.stdout + done.stderr)
        self.assertNotIn("second_order", json.loads((self.folder / "d.certificate.json").read_text()))

    def test_a_mesh_beside_says_that_its_sides_are_straight(self):
        done = self.mesh(DISC, "--size", "0.5", "--order", "2", "-o", "d.mesh", "-o", "d.vtu")
        self.assertIn("d.mesh: triangles of second order have no place", done.stderr)
        done = self.run_command("verify", "d.mesh")
        self.assertEqual(done.returncode, 0, done.stdout)
        self.assertIn("second order are in other files", done.stdout)

    def test_formats_without_a_place_are_refused(self):
        self.write("d.poly", DISC)
        done = self.run_command("mesh", "d.poly", "--size", "0.5", "--order", "2", "-o", "d.mesh")
        self.assertEqual(done.returncode, 2)
        self.assertIn(".msh, .msh2 and .vtu", done.stderr)
        self.assertEqual(self.files(), ["d.poly"])
        done = self.run_command("mesh", "d.poly", "--order", "3", "-o", "d.msh")
        self.assertEqual(done.returncode, 2)

    def test_convert_keeps_the_nodes(self):
        self.mesh(DISC, "--size", "0.5", "--order", "2", "-o", "d.msh2")
        for name, strict in (("e.msh", ["--strict"]), ("f.msh2", ["--strict"]), ("e.vtu", [])):
            done = self.run_command("convert", "d.msh2", name, "--order", "2", *strict)
            self.assertEqual(done.returncode, 0, done.stderr)
            self.assertNotIn("higher order", done.stderr)
        done = self.run_command("convert", "e.vtu", "g.msh2", "--order", "2", "--strict")
        self.assertEqual(done.returncode, 0, done.stderr)
        first, last = (elements(self.folder / name) for name in ("d.msh2", "g.msh2"))
        self.assertEqual(first[0], last[0])
        self.assertEqual(sorted(map(tuple, first[1][9])), sorted(map(tuple, last[1][9])))
        done = self.run_command("convert", "d.msh2", "h.msh", "--strict")
        self.assertEqual(done.returncode, 2)
        self.assertIn("higher order", done.stderr)

    def test_adapt_writes_second_order(self):
        self.mesh(DISC, "--size", "0.3", "-o", "d.mesh")
        vertices = command.section((self.folder / "d.mesh").read_text().split("\n"), "Vertices")[1]
        values = "\n".join(str(math.sin(i)) for i in range(vertices))
        self.write("u.sol", f"MeshVersionFormatted 2\nDimension 2\nSolAtVertices\n{vertices}\n1 1\n{values}\nEnd\n")
        done = self.run_command("adapt", "d.mesh", "--solution", "u.sol", "--vertices", "200", "--domain", "d.poly",
                                "--order", "2", "-o", "n.msh")
        self.assertIn(done.returncode, (0, 1), done.stderr)
        self.assertGreater(self.claim("n")["on_curves"], 6)
        again = self.run_command("verify", "n.msh")
        self.assertEqual(again.returncode, done.returncode, again.stdout)

    def test_a_side_that_would_fold_its_triangle_stays_straight(self):
        # A triangle beside the chord of an eighth of a turn has an angle of 4 degrees at the chord's end. The circle
        # leaves the chord at 22.5 degrees there, so that the curved triangle would fold.
        x = 0.75 * math.sqrt(0.5)
        text = PLATE.replace("5 2\n", "6 2\n", 1).replace("5 0.7 0\n", f"5 0.7 0\n6 {x} {x}\n")
        done = self.mesh(text, "--angle-bound", "0", "--chord-tolerance", "1", "--order", "2", "-o", "d.msh2")
        told = self.claim()
        self.assertGreater(told["kept_straight"], 0)
        self.assertGreater(told["on_curves"], 0)
        self.assertEqual(told["kept_straight"] + told["on_curves"], 8)
        self.assertIn("kept straight: a triangle would fold", done.stderr)
        again = self.run_command("verify", "d.msh2")
        self.assertEqual(again.returncode, 0, again.stdout + again.stderr)
        nodes, kinds = elements(self.folder / "d.msh2")
        straight = [e for e in kinds[8] if abs(math.hypot(*nodes[e[0]]) - 0.7) < 1e-9
                    and abs(math.hypot(*nodes[e[2]]) - 0.7) > 1e-9]
        self.assertEqual(len(straight), told["kept_straight"])


if __name__ == "__main__":
    unittest.main()
