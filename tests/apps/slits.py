# SPDX-License-Identifier: MIT
"""Meshes with slits, whose vertices are in the file twice. Every command that takes a mesh keeps the two sides apart,
in every format."""
import json
import math
import re
import unittest

import command


def grid(n, slit, both=(1, 1)):
    """Returns a square of 2 n^2 triangles on [-1, 1]^2 with a slit along y = 0 from the left side to x = slit.
    Vertices on the slit are there twice, the tip once. Markers: 1 outside, `both` above and below the slit."""
    at = [(-1 + 2 * i / n, -1 + 2 * j / n) for j in range(n + 1) for i in range(n + 1)]
    middle = n // 2
    doubled = [i for i in range(n + 1) if -1 + 2 * i / n < slit - 1e-9]
    above = {i + middle * (n + 1): (n + 1) ** 2 + k for k, i in enumerate(doubled)}
    at += [at[v] for v in above]

    def corner(i, j, lower):
        v = i + j * (n + 1)
        return above.get(v, v) if j == middle and not lower else v

    triangles, edges = [], []
    for j in range(n):
        for i in range(n):
            lower = j < middle
            a, b, c, d = (corner(*ij, lower) for ij in ((i, j), (i + 1, j), (i + 1, j + 1), (i, j + 1)))
            triangles += [(a, b, d), (b, c, d)] if (i + j) % 2 else [(a, b, c), (a, c, d)]
            edges += [(p, q, 1) for p, q, out in ((a, b, j == 0), (b, c, i == n - 1), (c, d, j == n - 1),
                                                 (d, a, i == 0)) if out]
            if i < len(doubled):
                if j == middle:
                    edges.append((a, b, both[0]))
                if j == middle - 1:
                    edges.append((c, d, both[1]))
    return at, triangles, edges


def medit(at, triangles, edges):
    rows = [("Vertices", [(*p, 0) for p in at]), ("Edges", [(a + 1, b + 1, m) for a, b, m in edges]),
            ("Triangles", [(a + 1, b + 1, c + 1, 1) for a, b, c in triangles])]
    return "MeshVersionFormatted 2\nDimension 2\n" + "".join(
        f"{name}\n{len(all_)}\n" + "".join(" ".join(map(repr, r)) + "\n" for r in all_)
        for name, all_ in rows) + "End\n"


def values(at, field):
    return (f"MeshVersionFormatted 2\nDimension 2\nSolAtVertices\n{len(at)}\n1 1\n"
            + "".join(f"{field(v)!r}\n" for v in range(len(at))) + "End\n")


class Slits(command.CommandTest):
    def read(self, name):
        """Returns vertices, triangles and edges of a .mesh."""
        lines = (self.folder / name).read_text().split("\n")
        made = []
        for section in ("Vertices", "Triangles", "Edges"):
            start, count = command.section(lines, section)
            rows = [line.split() for line in lines[start:start + count]]
            if section == "Vertices":
                made.append([(float(r[0]), float(r[1])) for r in rows])
            else:
                width = 3 if section == "Triangles" else 2
                made.append([(tuple(int(x) - 1 for x in r[:width]), int(r[width])) for r in rows])
        return made

    def check_parted(self, name, tip, sides=(1, 1)):
        """Checks that the file has a slit from x = -1 to the tip, with the vertices of both sides, and that no
        triangle crosses it."""
        at, triangles, edges = self.read(name)
        on = {v for v, (x, y) in enumerate(at) if y == 0 and x < tip - 1e-12}
        ys = {}
        for t, _ in triangles:
            for v in on.intersection(t):
                ys.setdefault(v, set()).add(sum(at[w][1] for w in t) > 0)
        self.assertTrue(all(len(side) == 1 for side in ys.values()))
        places = {}
        for v in on:
            places.setdefault(at[v], []).append(v)
        self.assertTrue(all(len(all_) == 2 for all_ in places.values()), places)
        tips = [v for v, p in enumerate(at) if p == (tip, 0)]
        self.assertEqual(len(tips), 1)
        along = {True: [], False: []}
        for (a, b), m in edges:
            if {a, b} & on and at[a][1] == 0 == at[b][1]:
                v = a if a in on else b
                along[ys[v] == {True}].append(((a, b), m))
        self.assertEqual({m for _, m in along[True]}, {sides[0]})
        self.assertEqual({m for _, m in along[False]}, {sides[1]})
        self.assertEqual(len(along[True]), len(along[False]))
        return at, triangles, edges

    def done(self, *arguments, status=0):
        done = self.run_command(*arguments)
        self.assertEqual(done.returncode, status, f"{arguments}\n{done.stdout}{done.stderr}")
        return done.stdout + done.stderr

    def test_mesh_keeps_both_sides_apart(self):
        for sides in ((1, 1), (7, 8), (8, 7)):
            with self.subTest(sides):
                self.write("s.mesh", medit(*grid(8, 0, sides)))
                said = self.done("mesh", "s.mesh", "--size", "0.1", "-o", "n.mesh")
                self.assertIn("slits: vertices are there once for each side", said)
                self.check_parted("n.mesh", 0, sides)
                self.done("verify", "n.mesh")
                self.done("verify", "n.mesh", "--domain", "s.mesh")

    def test_a_mesh_that_is_good_stays_and_is_certified(self):
        self.write("s.mesh", medit(*grid(8, 0)))
        self.done("mesh", "s.mesh", "-o", "n.mesh")
        at, triangles, _ = self.check_parted("n.mesh", 0)
        self.assertEqual((len(at), len(triangles)), (85, 128))
        said = self.done("certify", "n.mesh", "-o", "m.mesh")
        self.assertIn("certified: 81 sites", said)
        self.assertEqual(self.read("n.mesh"), self.read("m.mesh"))
        self.done("mesh", "n.mesh", "-o", "m.mesh")
        self.assertEqual(len(self.check_parted("m.mesh", 0)[0]), 85)
        self.done("verify", "m.mesh")

    def test_adapt_brings_a_field_that_jumps(self):
        at, triangles, edges = grid(12, 0, (2, 3))
        # sqrt(r) sin(theta / 2) jumps across the slit. The triangles decide which side a vertex is on.
        upper = {v for t in triangles for v in t if at[v][1] == 0 and sum(at[w][1] for w in t) > 0}

        def angle(v):
            x, y = at[v]
            return math.atan2(y, x) if y or x >= 0 else math.pi if v in upper else -math.pi

        self.write("s.mesh", medit(at, triangles, edges))
        self.write("u.sol", values(at, lambda v: math.sqrt(math.hypot(*at[v])) * math.sin(angle(v) / 2)))
        said = self.done("adapt", "s.mesh", "--solution", "u.sol", "--vertices", "300", "-o", "n.mesh", "--solution-out",
                         "n_u.sol")
        self.assertIn("slits:", said)
        new, triangles, _ = self.check_parted("n.mesh", 0, (2, 3))
        lines = (self.folder / "n_u.sol").read_text().split("\n")
        start, count = command.section(lines, "SolAtVertices")
        self.assertEqual(count, len(new))
        u = [float(x) for x in lines[start + 1:start + 1 + count]]
        signs = {}
        for t, _ in triangles:
            for v in t:
                if new[v][1] == 0 and new[v][0] < -0.2:
                    signs.setdefault(v, set()).add((u[v] > 0.2, u[v] < -0.2, sum(new[w][1] for w in t) > 0))
        self.assertTrue(signs)
        for v, side in signs.items():
            self.assertIn(side, ({(True, False, True)}, {(False, True, False)}), new[v])
        self.done("verify", "n.mesh")
        # The loop's next step reads what this step wrote.
        self.done("adapt", "n.mesh", "--solution", "n_u.sol", "--vertices", "300", "-o", "m.mesh", "--solution-out",
                  "m_u.sol")
        self.check_parted("m.mesh", 0, (2, 3))
        self.done("verify", "m.mesh")

    def test_formats_keep_the_slit(self):
        self.write("s.mesh", medit(*grid(8, 0, (7, 8))))
        for name in ("a.msh", "a.msh2", "a.vtu", "a.meshb"):
            with self.subTest(name):
                self.done("convert", "s.mesh", name)
                self.done("convert", name, "back.mesh")
                self.check_parted("back.mesh", 0, (7, 8))
                self.done("mesh", name, "--size", "0.2", "-o", "n.mesh", "-o", "n.msh", "-o", "n.vtu")
                self.check_parted("n.mesh", 0, (7, 8))
                for made in ("n.mesh", "n.msh", "n.vtu"):
                    self.done("verify", made)

    def test_sizes_near_a_slit(self):
        self.write("s.mesh", medit(*grid(8, 0, (7, 7))))
        self.done("mesh", "s.mesh", "--size", "0.3", "--size-near", "7:0.03,1.3", "-o", "n.mesh")
        at, _, edges = self.check_parted("n.mesh", 0, (7, 7))
        along = [math.dist(at[a], at[b]) for (a, b), m in edges if m == 7]
        self.assertLess(sorted(along)[len(along) // 2], 0.05)

    def test_three_cracks_that_meet(self):
        # A hexagon of six triangles, its middle there three times.
        ring = [(math.cos(math.pi * k / 3), math.sin(math.pi * k / 3)) for k in range(6)]
        at = ring + [(0.0, 0.0)] * 3
        triangles = [(k, (k + 1) % 6, 6 + k // 2) for k in range(6)]
        # The outer ends of the cracks are there twice.
        for k in (0, 2, 4):
            at.append(at[k])
            first = triangles[(k - 1) % 6]
            triangles[(k - 1) % 6] = tuple(len(at) - 1 if v == k else v for v in first)
        self.write("s.mesh", medit(at, triangles, []))
        self.done("mesh", "s.mesh", "--size", "0.3", "-o", "n.mesh")
        new, _, _ = self.read("n.mesh")
        self.assertEqual(sum(p == (0, 0) for p in new), 3)
        self.done("verify", "n.mesh")

    def test_vertices_at_one_place_without_a_slit_are_refused(self):
        two = [(0, 0), (1, 0), (0, 1), (0, 0), (-1, 0), (0, -1)]
        self.write("t.mesh", medit(two, [(0, 1, 2), (3, 4, 5)], []))
        said = self.done("mesh", "t.mesh", "-o", "n.mesh", status=2)
        self.assertIn("it is no slit", said)
        self.assertIn("vertex 1 and vertex 4 are at the same point", said)
        flat = [(0, 0), (1, 0), (0, 0), (0, 1)]
        self.write("t.mesh", medit(flat, [(0, 1, 3), (0, 1, 2)], []))
        said = self.done("mesh", "t.mesh", "-o", "n.mesh", status=2)
        self.assertIn("both are corners of triangle 2", said)

    def test_second_order_along_a_slit(self):
        self.write("s.mesh", medit(*grid(8, 0, (7, 8))))
        self.done("mesh", "s.mesh", "--size", "0.3", "--order", "2", "-o", "n.msh")
        self.done("verify", "n.msh")
        self.assertTrue(json.loads((self.folder / "n.certificate.json").read_text())["second_order"]["proved"])


if __name__ == "__main__":
    unittest.main()
