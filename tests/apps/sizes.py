# SPDX-License-Identifier: MIT
"""Sizes at places through the real command: edges have the size asked for, the certificate records it, and `verify`
proves it again."""
import json
import math
import unittest

import command

# A channel with a round hole, the hole's marker 2.
CHANNEL = ("5 2\n1 0 0\n2 2.2 0\n3 2.2 0.41\n4 0 0.41\n5 0.25 0.2\n4 1\n1 1 2 1\n2 2 3 3\n3 3 4 1\n4 4 1 4\n"
           "1\n1 0.2 0.2\n0\ncurves 1\n1 circle 5 0.2 0.2 2\n")
# Two squares side by side, regions 1 and 2, the second with an area for its triangles.
HALVES = ("6 2\n1 0 0\n2 1 0\n3 2 0\n4 2 1\n5 1 1\n6 0 1\n7 1\n1 1 2 1\n2 2 3 1\n3 3 4 2\n4 4 5 1\n5 5 6 1\n"
          "6 6 1 3\n7 2 5 9\n0\n2\n1 0.5 0.5 1\n2 1.5 0.5 2 0.001\n")
NAMED = """$MeshFormat
2.2 0 8
$EndMeshFormat
$PhysicalNames
3
1 5 "wall"
1 6 "rest"
2 1 "fluid"
$EndPhysicalNames
$Nodes
4
1 0 0 0
2 1 0 0
3 1 1 0
4 0 1 0
$EndNodes
$Elements
6
1 1 2 5 1 1 2
2 1 2 6 2 2 3
3 1 2 6 2 3 4
4 1 2 6 2 4 1
5 2 2 1 1 1 2 3
6 2 2 1 1 1 3 4
$EndElements
"""


class Sizes(command.CommandTest):
    def mesh(self, *arguments):
        done = self.run_command("mesh", *arguments, "-o", "m.mesh")
        self.assertEqual(done.returncode, 0, done.stderr)
        again = self.run_command("verify", "m.mesh")
        self.assertEqual(again.returncode, 0, again.stdout + again.stderr)
        self.assertIn("compared at every vertex", again.stdout)
        return json.loads((self.folder / "m.certificate.json").read_text())["asked"]["options"]

    def read(self):
        words = (self.folder / "m.mesh").read_text().split()

        def table(name, columns, kind):
            at = words.index(name)
            rows = range(int(words[at + 1]))
            return [tuple(map(kind, words[at + 2 + columns * i:at + 2 + columns * (i + 1)])) for i in rows]
        return table("Vertices", 3, float), table("Edges", 3, int), table("Triangles", 4, int)

    def longest_edge(self, is_there):
        vertices, _, triangles = self.read()
        lengths = [math.dist(vertices[a - 1][:2], vertices[b - 1][:2]) for a, b, c, _ in triangles
                   for a, b in ((a, b), (b, c), (c, a))
                   if is_there(vertices[a - 1]) and is_there(vertices[b - 1])]
        self.assertGreater(len(lengths), 20)
        return max(lengths)

    def first_heights(self, marker):
        vertices, edges, triangles = self.read()
        wall = {frozenset(edge[:2]) for edge in edges if edge[2] == marker}
        heights = []
        for a, b, c, _ in triangles:
            for p, q, r in ((a, b, c), (b, c, a), (c, a, b)):
                if frozenset((p, q)) in wall:
                    (px, py, _), (qx, qy, _), (rx, ry, _) = vertices[p - 1], vertices[q - 1], vertices[r - 1]
                    heights.append(((qx - px) * (ry - py) - (qy - py) * (rx - px)) / math.hypot(qx - px, qy - py))
        return sorted(heights)

    def test_sizes_are_met_where_they_are_asked_for(self):
        near = 1.5  # edges may be this long in the metric
        for option, value, is_there, size in [
                ("--size-at", "0.2,0.1,0.3:0.03", lambda v: math.dist(v[:2], (0.2, 0.1)) < 0.3, 0.03),
                ("--size-box", "-0.5,-0.5,0,0:0.03", lambda v: -0.5 <= v[0] <= 0 and -0.5 <= v[1] <= 0, 0.03),
                ("--size-near", "3:0.03", lambda v: v[1] == 1, 0.03),
                ("--hmax", "0.2", lambda v: True, 0.2)]:
            with self.subTest(option):
                asked = self.mesh("square", option, value, *(["--size", "0.4"] if option != "--hmax" else []))
                self.assertLess(self.longest_edge(is_there), near * size)
                self.assertNotEqual(asked["sizes"], "none")
                self.assertLess(len(self.read()[0]), 4000)

    def test_a_region_has_its_size_by_number_and_by_area(self):
        self.write("halves.poly", HALVES)
        asked = self.mesh("halves.poly", "--size", "0.5", "--size-in", "2:0.03")
        self.assertEqual(asked["sizes"], "in 2:0.03,1.3")
        self.assertLess(self.longest_edge(lambda v: v[0] >= 1), 0.045)
        asked = self.mesh("halves.poly", "--size", "0.5", "--sizes-of-file")
        self.assertTrue(asked["sizes"].startswith("in 2:0.03699"), asked["sizes"])
        vertices, _, triangles = self.read()
        for a, b, c, region in triangles:
            (ax, ay, _), (bx, by, _), (cx, cy, _) = (vertices[v - 1] for v in (a, b, c))
            if region == 2:
                self.assertLessEqual(((bx - ax) * (cy - ay) - (by - ay) * (cx - ax)) / 2, 0.001)
        self.assertGreater(sum(t[3] == 2 for t in triangles), 1000)
        self.assertLess(sum(t[3] == 1 for t in triangles), 1000)

    def test_names_of_markers_and_regions(self):
        self.write("named.msh", NAMED)
        asked = self.mesh("named.msh", "--size", "0.3", "--size-near", "wall:0.02", "--size-in", "fluid:0.2")
        self.assertEqual(asked["sizes"], "in 1:0.2,1.3; near 5:0.02,1.3")
        done = self.run_command("mesh", "named.msh", "--size-near", "wal:0.02", "-o", "x.mesh")
        self.assertEqual(done.returncode, 2)
        self.assertIn("named.msh names no marker 'wal'; there are 'wall', 'rest'", done.stderr)

    def test_first_cells_of_layers_have_the_height_asked_for(self):
        self.write("channel.poly", CHANNEL)
        for domain, height in (("channel.poly", 1e-3), ("channel.poly", 1e-4), ("airfoil", 1e-3)):
            with self.subTest(f"{domain} {height}"):
                self.mesh(domain, "--size", "0.05" if domain != "airfoil" else "0.3",
                          "--layers", f"2:{height},1.2")
                heights = self.first_heights(2)
                self.assertGreater(len(heights), 100)
                self.assertLess(abs(heights[len(heights) // 2] / height - 1), 0.05)
                within = sum(abs(h / height - 1) <= 0.2 for h in heights)
                self.assertGreaterEqual(within, 0.9 * len(heights))
                named = self.run_command("verify", "m.mesh", "--domain", domain)
                self.assertEqual(named.returncode, 0, named.stdout)

    def test_other_sizes_in_the_certificate_are_refused(self):
        self.mesh("square", "--size", "0.4", "--size-near", "3:0.05", "--layers", "1:0.01,1.2")
        path = self.folder / "m.certificate.json"
        text = path.read_text()
        for before, after in [("near 3:0.05,1.3", "near 3:0.06,1.3"), ("near 3", "near 2"),
                              ("layers 1:0.01,1.2", "layers 1:0.011,1.2"), ("near 3:0.05,1.3", "near 3"),
                              ("near 3:0.05,1.3; ", "")]:
            self.assertIn(before, text)
            path.write_text(text.replace(before, after))
            done = self.run_command("verify", "m.mesh")
            self.assertEqual(done.returncode, 1, done.stdout)
        path.write_text(text)
        done = self.run_command("verify", "m.mesh", "--metric", "identity")
        self.assertIn("sizes near 3:0.05,1.3; layers 1:0.01,1.2 by the certificate", done.stdout)

    def test_what_is_no_size_is_refused(self):
        self.write("halves.poly", HALVES)
        self.write("twice.poly", HALVES.replace("2 1.5 0.5 2 0.001", "2 1.5 0.5 1 0.001"))
        for arguments, words in [
                (["square", "--size-near", "9:0.1"], "no segment has the marker 9; the markers there are: 1, 2, 3, 4"),
                (["square", "--size-in", "9:0.1"], "there is no region 9"),
                (["square", "--size-in", "wall:0.1"], "square names no region 'wall'"),
                (["square", "--size-at", "0,0:0.1"], "--size-at: '0,0:0.1': R is missing"),
                (["square", "--layers", "1:0.1"], "GROWTH is missing"),
                (["square", "--hmin", "1", "--hmax", "0.1"], "hmin 1 is not less than hmax 0.1"),
                (["square", "--metric", "swirl:3", "--hmax", "0.1"], "--size says how long edges are"),
                (["square", "--sizes-of-file", "--size", "1"], "wants no areas"),
                (["twice.poly", "--sizes-of-file", "--size", "1"], "two points of region 1")]:
            with self.subTest(arguments):
                done = self.run_command("mesh", *arguments, "-o", "x.mesh")
                self.assertEqual(done.returncode, 2, done.stdout)
                self.assertIn(words, done.stderr)
        self.assertFalse((self.folder / "x.mesh").exists())

    def test_a_number_of_vertices_with_a_size_at_a_place(self):
        done = self.run_command("mesh", "square", "--vertices", "2000", "--size-at", "0,0,0.1:0.01", "-o", "m.mesh")
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertLess(abs(len(self.read()[0]) - 2000), 100)
        self.assertEqual(self.run_command("verify", "m.mesh").returncode, 0)


if __name__ == "__main__":
    unittest.main()
