# SPDX-License-Identifier: MIT
"""Outlines with the faults that real ones have are refused, and mesh with one option, --repair-domain."""
import json
import random
import unittest

import command


def coastline(levels=8, seed=2, digits=3):
    """Returns a ring that crosses itself: midpoints are moved repeatedly, and the coordinates rounded to few
    digits."""
    numbers = random.Random(seed)
    ring = [(1.0, 0.0), (-0.5, 0.87), (-0.5, -0.87)]
    for _ in range(levels):
        rougher = []
        for (x, y), (u, v) in zip(ring, ring[1:] + ring[:1]):
            s = (numbers.random() - 0.5) * 0.75
            rougher += [(x, y), ((x + u) / 2 - s * (v - y), (y + v) / 2 + s * (u - x))]
        ring = rougher
    return [(round(x, digits), round(y, digits)) for x, y in ring]


# Lines with a drawing's faults: ends that miss each other by 1e-5, one line on another, gaps in a hole's ring.
DRAWING = [((0, 0), (4.00001, 0)), ((4, -0.00001), (4, 3)), ((4, 3.00001), (2.5, 3)), ((2.5, 3), (2.5, 2)),
           ((2.5, 2.00001), (1.5, 2)), ((1.5, 2), (1.5, 3.00002)), ((1.50001, 3), (0, 3)),
           ((0, 3.00001), (0, 0.00001)), ((0, 3), (0, 1)), ((0.5, 0.5), (1, 0.5)), ((1, 0.50001), (1, 1)),
           ((1, 1), (0.5, 1)), ((0.50001, 1), (0.5, 0.50001))]


def poly(points, segments, holes=()):
    sections = [(points, " 2"), (segments, ""), (holes, "")]
    return "".join(f"{len(rows)}{more}\n" + "".join(f"{i} {row[0]} {row[1]}\n" for i, row in enumerate(rows, 1))
                   for rows, more in sections)


class FaultyOutlines(command.CommandTest):
    def meshes_with_one_option(self, text):
        self.write("d.poly", text)
        refused = self.run_command("mesh", "d.poly", "-o", "d.mesh")
        self.assertEqual(refused.returncode, 2)
        self.assertIn("--repair-domain mends it", refused.stderr)
        done = self.run_command("mesh", "d.poly", "--repair-domain", "-o", "d.mesh")
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertIn("repaired: within", done.stdout)
        done = self.run_command("verify", "d.mesh", "--domain", "d.poly")
        self.assertEqual(done.returncode, 0, done.stdout)
        return json.loads((self.folder / "d.certificate.json").read_text())["asked"]["options"]

    def test_a_coastline_that_crosses_itself(self):
        ring = coastline()
        count = len(ring)
        done = self.meshes_with_one_option(poly(ring, [(i + 1, (i + 1) % count + 1) for i in range(count)]))
        self.assertRegex(done["repair-done"], r": [1-9]\d* crossings made vertices")

    def test_a_drawing_whose_lines_miss_each_other(self):
        points = [p for line in DRAWING for p in line]
        ends = [(2 * i + 1, 2 * i + 2) for i in range(len(DRAWING))]
        done = self.meshes_with_one_option(poly(points, ends, [(0.75, 0.75)]))
        self.assertRegex(done["repair-done"], r"13 vertices joined")

    def test_what_is_left_beside_corners_is_said_with_what_to_try(self):
        # Segments of less than a degree inside the domain: the triangles between them stay thin.
        text = poly([(-2, -2), (2, -2), (2, 2), (-2, 2), (0, 0), (1.5, 0), (1.5, 0.02)],
                    [(1, 2), (2, 3), (3, 4), (4, 1), (5, 6), (5, 7)])
        self.write("d.poly", text)
        done = self.run_command("mesh", "d.poly", "-o", "d.mesh")
        self.assertEqual(done.returncode, 1)
        self.assertIn("beside corners of the domain", done.stderr)
        self.assertIn("sharpest corner beside them is vertex 5 at (0, 0), 0.763898 degrees", done.stderr)
        self.assertIn("try --angle-bound 10, or a domain without corners that sharp", done.stderr)

    def test_one_hopeless_corner_does_not_keep_others_from_being_mended(self):
        # Adds a corner of three degrees far from the hopeless one: its low angles must be improved.
        text = poly([(0, 0), (10, 0), (10, 10), (0, 10), (2, 3), (5, 3), (5, 3.0419), (5, 7), (8, 7), (7.9959, 7.157)],
                    [(1, 2), (2, 3), (3, 4), (4, 1), (5, 6), (5, 7), (8, 9), (8, 10)])
        self.write("d.poly", text)
        done = self.run_command("mesh", "d.poly", "-o", "d.mesh")
        self.assertEqual(done.returncode, 1)
        self.assertIn("sharpest corner beside them is vertex 5 at (2, 3)", done.stderr)
        lines = (self.folder / "d.mesh").read_text().split("\n")
        start, count = command.section(lines, "Vertices")
        height = [float(line.split()[1]) for line in lines[start:start + count]]
        start, count = command.section(lines, "Triangles")
        corners = [[int(v) - 1 for v in line.split()[:3]] for line in lines[start:start + count]]
        left = json.loads((self.folder / "d.certificate.json").read_text())["audit"]["collateral_triangles"]
        self.assertTrue(left)
        for t in left:
            self.assertLess(max(height[v] for v in corners[t - 1]), 5, "beside the corner of three degrees")
        self.assertEqual(self.run_command("verify", "d.mesh").returncode, 1)


if __name__ == "__main__":
    unittest.main()
