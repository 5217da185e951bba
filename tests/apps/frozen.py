# SPDX-License-Identifier: MIT
"""`adapt --frozen`: triangles of a region stay as they are, the rest is adapted and certified, `verify` proves
both."""
import json
import math
import unittest

import command


def plate(n=12):
    """[0, 3] x [0, 1], three squares of regions 1, 2, 3, triangles of region 2 bent a little."""
    at = []
    for j in range(n + 1):
        for i in range(3 * n + 1):
            x, y = i / n, j / n
            if 1 < x < 2 and 0 < y < 1:
                x, y = x + 0.02 * math.sin(9 * y), y + 0.02 * math.sin(7 * x)
            at.append((x, y))
    triangles = []
    for j in range(n):
        for i in range(3 * n):
            a, b = i + j * (3 * n + 1), i + 1 + j * (3 * n + 1)
            c, d = b + 3 * n + 1, a + 3 * n + 1
            region = 1 + i // n
            triangles += [(a, b, c, region), (a, c, d, region)] if (i + j) % 2 else [(a, b, d, region), (b, c, d, region)]
    return at, triangles


def medit(at, triangles):
    return ("MeshVersionFormatted 2\nDimension 2\nVertices\n" + f"{len(at)}\n"
            + "".join(f"{x!r} {y!r} 0\n" for x, y in at) + f"Triangles\n{len(triangles)}\n"
            + "".join(f"{a + 1} {b + 1} {c + 1} {r}\n" for a, b, c, r in triangles) + "End\n")


def gmsh(at, triangles):
    lines = ["$MeshFormat", "2.2 0 8", "$EndMeshFormat", "$PhysicalNames", "3", '2 1 "inlet"', '2 2 "blade row"',
             '2 3 "outlet"', "$EndPhysicalNames", "$Nodes", str(len(at))]
    lines += [f"{i} {x!r} {y!r} 0" for i, (x, y) in enumerate(at, 1)]
    lines += ["$EndNodes", "$Elements", str(len(triangles))]
    lines += [f"{i} 2 2 {r} {r} {a + 1} {b + 1} {c + 1}" for i, (a, b, c, r) in enumerate(triangles, 1)]
    return "\n".join([*lines, "$EndElements", ""])


class Frozen(command.CommandTest):
    def setUp(self):
        super().setUp()
        self.at, self.triangles = plate()
        self.write("old.mesh", medit(self.at, self.triangles))
        rows = "".join(f"{math.tanh(20 * (x - 0.5)) + math.sin(3 * x + y)!r}\n" for x, y in self.at)
        self.write("u.sol", f"MeshVersionFormatted 2\nDimension 2\nSolAtVertices\n{len(self.at)}\n1 1\n{rows}End\n")

    def done(self, *arguments, status=0):
        done = self.run_command(*arguments)
        self.assertEqual(done.returncode, status, f"{arguments}\n{done.stdout}{done.stderr}")
        return done.stdout + done.stderr

    def placed(self, at, triangles, region):
        return sorted(tuple(sorted(at[v] for v in t[:3])) for t in triangles if t[3] == region)

    def read(self, name):
        lines = (self.folder / name).read_text().split("\n")
        start, count = command.section(lines, "Vertices")
        at = [tuple(map(float, line.split()[:2])) for line in lines[start:start + count]]
        start, count = command.section(lines, "Triangles")
        rows = [list(map(int, line.split())) for line in lines[start:start + count]]
        return at, [(*(v - 1 for v in r[:3]), r[3]) for r in rows]

    def check(self, name, region=2):
        at, triangles = self.read(name)
        self.assertEqual(self.placed(at, triangles, region), self.placed(self.at, self.triangles, region))
        # Checks for a mesh: every side has one triangle on its left, inner ones also one on the right, and the areas
        # add up.
        sides = [side for a, b, c, _ in triangles for side in ((a, b), (b, c), (c, a))]
        self.assertEqual(len(sides), len(set(sides)))
        self.assertEqual(len(at), len(set(at)))
        area = sum((at[b][0] - at[a][0]) * (at[c][1] - at[a][1]) - (at[b][1] - at[a][1]) * (at[c][0] - at[a][0])
                   for a, b, c, _ in triangles) / 2
        self.assertAlmostEqual(area, 3, delta=1e-12)
        return at, triangles

    def test_the_region_stays_and_the_rest_is_adapted(self):
        said = self.done("adapt", "old.mesh", "--solution", "u.sol", "--vertices", "600", "--frozen", "2", "-o",
                         "new.mesh", "--solution-out", "new_u.sol")
        self.assertIn("frozen, not judged: 288 triangles of region 2", said)
        at, triangles = self.check("new.mesh")
        others = [self.placed(at, triangles, r) == self.placed(self.at, self.triangles, r) for r in (1, 3)]
        self.assertEqual(others, [False, False])
        lines = (self.folder / "new_u.sol").read_text().split("\n")
        self.assertEqual(command.section(lines, "SolAtVertices")[1], len(at))
        claim = json.loads((self.folder / "new.certificate.json").read_text())
        self.assertTrue(claim["audit"]["certified"])
        self.assertEqual(claim["asked"]["options"]["frozen"], "2")
        self.assertEqual(claim["asked"]["options"]["frozen-triangles"], "288")
        self.assertLess(claim["mesh"]["triangles"], len(triangles))
        said = self.done("verify", "new.mesh")
        self.assertIn("frozen, not judged: 288 triangles of the regions 2, as in old.mesh", said)
        # The written mesh is the input of the loop's next step.
        self.done("adapt", "new.mesh", "--solution", "new_u.sol", "--vertices", "600", "--frozen", "2", "-o", "next.mesh")
        self.check("next.mesh")
        self.done("verify", "next.mesh")

    def test_verify_sees_a_frozen_triangle_that_was_changed(self):
        self.done("adapt", "old.mesh", "--solution", "u.sol", "--vertices", "600", "--frozen", "2", "-o", "new.mesh")
        at, triangles = self.read("new.mesh")
        inside = next(t for t in triangles if t[3] == 2 and all(1.2 < at[v][0] < 1.8 for v in t[:3]))
        lines = (self.folder / "new.mesh").read_text().split("\n")
        start, _ = command.section(lines, "Vertices")
        words = lines[start + inside[0]].split()
        words[0] = repr(float(words[0]) + 1e-9)
        changed = [*lines]
        changed[start + inside[0]] = " ".join(words)
        self.write("new.mesh", "\n".join(changed))
        said = self.done("verify", "new.mesh", status=1)
        self.assertIn("frozen triangles are not those of old.mesh", said)

    def test_a_region_by_its_name_and_other_formats(self):
        self.write("old.msh", gmsh(self.at, self.triangles))
        for out in ("new.mesh", "new.msh", "new.vtu"):
            with self.subTest(out):
                self.done("adapt", "old.msh", "--solution", "u.sol", "--vertices", "600", "--frozen", "blade row", "-o", out)
                self.done("verify", out)
                self.done("convert", out, "back.mesh")
                self.check("back.mesh")

    def test_two_regions_and_a_metric_much_finer_than_the_border(self):
        said = self.done("adapt", "old.mesh", "--solution", "u.sol", "--vertices", "2500", "--frozen", "2", "--frozen",
                         "3", "-o", "new.mesh")
        self.assertIn("of regions 2, 3", said)
        self.check("new.mesh", 2)
        self.check("new.mesh", 3)
        self.assertIn("the metric is coarser at", said)
        self.done("verify", "new.mesh")

    def test_what_cannot_be_frozen(self):
        for words, said in ((("7",), "region 7 has no triangle; the regions there are: 1, 2, 3"),
                            (("nothing",), "names no region 'nothing'; it names none, and a number is wanted"),
                            (("1", "2", "3"), "all triangles are in frozen regions")):
            options = [w for word in words for w in ("--frozen", word)]
            told = self.done("adapt", "old.mesh", "--solution", "u.sol", "--vertices", "600", *options, "-o", "new.mesh",
                             status=2)
            self.assertIn(said, told)
        self.write("old.msh", gmsh(self.at, self.triangles))
        told = self.done("adapt", "old.msh", "--solution", "u.sol", "--frozen", "hub", "-o", "new.mesh", status=2)
        self.assertIn("names no region 'hub'; it names 'inlet', 'blade row', 'outlet'", told)
        self.assertNotIn("new.mesh", self.files())


if __name__ == "__main__":
    unittest.main()
