# SPDX-License-Identifier: MIT
"""Meshes from elsewhere through the real command: certified, refused with the triangles at fault,
repaired, or not readable."""
import json
import re
import unittest

import command


def medit(vertices, triangles, edges=()):
    def rows(name, entries):
        return [name, str(len(entries)), *(" ".join(map(str, e)) for e in entries)]

    lines = ["MeshVersionFormatted 1", "Dimension 2", *rows("Vertices", vertices)]
    lines += rows("Triangles", triangles)
    if edges:
        lines += rows("Edges", edges)
    return "\n".join([*lines, "End", ""])


def solution(tensors):
    return "\n".join(["MeshVersionFormatted 1", "Dimension 2", "SolAtVertices", str(len(tensors)),
                      "1 3", *(" ".join(map(str, t)) for t in tensors), "End", ""])


class Certify(command.CommandTest):
    def run_certify(self, status, *arguments):
        done = self.run_command("certify", *arguments)
        self.assertEqual(done.returncode, status, done.stdout + done.stderr)
        return done

    def grid(self, n, tensor):
        """Cells cut along the rising diagonal, references as other programs write them."""
        at = [[i + j * (n + 1) + 1 for i in range(n + 1)] for j in range(n + 1)]
        cells = [(i, j) for j in range(n) for i in range(n)]
        triangles = [t for i, j in cells for t in
                     ((at[j][i], at[j][i + 1], at[j + 1][i + 1], 7),
                      (at[j][i], at[j + 1][i + 1], at[j + 1][i], 7))]
        places = [(i / n, j / n) for j in range(n + 1) for i in range(n + 1)]
        self.write("grid.mesh", medit([(x, y, 0) for x, y in places], triangles))
        self.write("grid.sol", solution([tensor(x, y) for x, y in places]))

    def make_good(self):
        done = self.run_command("mesh", "square", "--metric", "swirl:3", "--size", "0.3", "--quiet",
                                "-o", "good.mesh")
        self.assertEqual(done.returncode, 0, done.stderr)

    def test_a_good_mesh_is_certified(self):
        self.make_good()
        done = self.run_certify(0, "good.mesh", "-o", "same.mesh")
        self.assertRegex(done.stdout, r", of some: 0, of none: 0\ninverted or flat: 0\n")
        self.assertRegex(done.stdout, r"\Acertified: ")
        self.assertEqual(self.run_command("verify", "same.mesh").returncode, 0)

    def test_the_voronoi_diagram_when_asked(self):
        self.make_good()
        self.assertNotIn("Voronoi", self.run_certify(0, "good.mesh").stdout)
        done = self.run_certify(0, "good.mesh", "--voronoi", "-o", "same.mesh")
        self.assertIn("dual of the Voronoi diagram: proved\n", done.stdout)
        # One site's cell reaches over its neighbours' cells, between the corners of these.
        self.grid(8, lambda x, y: (0.05, 0, 2) if x == y == 0.5 else (1, 0, 1))
        done = self.run_certify(1, "grid.mesh", "--voronoi", "--angle-bound", "0")
        self.assertIn("dual of the Voronoi diagram: refused\n", done.stdout)

    def test_without_edges_the_rim_is_found(self):
        self.make_good()
        text = (self.folder / "good.mesh").read_text()
        start, end = text.index("\nEdges\n"), text.index("\nCorners\n")
        self.write("bare.mesh", text[:start] + text[end:])
        listed = self.run_certify(0, "good.mesh").stdout
        self.assertEqual(self.run_certify(0, "bare.mesh", "good.sol").stdout, listed)

    def test_edges_the_other_way_round_are_turned(self):
        corners = [(0, 0, 0), (1, 0, 0), (0.4, 0.9, 0)]
        self.write("t.mesh", medit(corners, [(1, 2, 3, 0)], [(2, 1, 5), (2, 3, 5), (1, 3, 5)]))
        self.write("t.sol", solution([(1, 0, 1)] * 3))
        self.run_certify(0, "t.mesh")

    def test_a_flipped_diagonal_is_two_triangles(self):
        self.make_good()
        lines = (self.folder / "good.mesh").read_text().splitlines()
        start = lines.index("Triangles") + 2
        rows = {n: list(map(int, lines[n].split()[:3]))
                for n in range(start, start + int(lines[start - 1]))}
        places = lines.index("Vertices") + 2
        at = {v + 1: tuple(map(float, lines[places + v].split()[:2]))
              for v in range(int(lines[places - 1]))}

        def area(a, b, c):
            return ((at[b][0] - at[a][0]) * (at[c][1] - at[a][1])
                    - (at[b][1] - at[a][1]) * (at[c][0] - at[a][0]))

        def flip():
            for m, one in rows.items():
                for n, other in rows.items():
                    for k in range(3):
                        a, b, c = one[k], one[(k + 1) % 3], one[(k + 2) % 3]
                        apex = [v for v in other if v not in (a, b)]
                        if m != n and a in other and b in other and \
                                min(area(a, apex[0], c), area(apex[0], b, c)) > 0.005:
                            return {m: (a, apex[0], c), n: (apex[0], b, c)}
            return None

        flipped = flip()
        for n, corners in flipped.items():
            lines[n] = " ".join(map(str, corners)) + " 1"
        self.write("flipped.mesh", "\n".join(lines) + "\n")
        done = self.run_certify(1, "flipped.mesh", "good.sol", "--angle-bound", "0")
        named = re.findall(r"^not of the stars: triangle (\d+) ", done.stdout, re.MULTILINE)
        self.assertEqual(sorted(map(int, named)), sorted(n - start + 1 for n in flipped))
        self.assertRegex(done.stdout, r"\ANOT certified: ")

    def test_a_plain_grid_under_another_metric_is_repaired(self):
        self.grid(5, lambda x, y: (30 * (1 + 2 * x), 9 * x * y, 25 * (1 + 8 * y * y)))
        self.run_certify(1, "grid.mesh")
        done = self.run_certify(0, "grid.mesh", "--repair", "-o", "out.mesh")
        self.assertRegex(done.stdout, r"\ncertified, repaired: \d+ sites, \d+ of them new, ")
        self.assertEqual(self.run_command("verify", "out.mesh").returncode, 0)
        self.assertRegex(self.run_certify(0, "out.mesh").stdout, r"\Acertified: ")
        claim = json.loads((self.folder / "out.certificate.json").read_text())
        self.assertTrue(claim["audit"]["certified"])
        first = (self.folder / "out.mesh").read_text().splitlines()
        start = first.index("Vertices") + 2
        self.assertEqual(float(first[start + 6].split()[0]), 0.0)  # vertices that were there stay
        self.assertEqual(float(first[start + 6].split()[1]), 0.2)

    def test_repair_that_ends_early_says_so(self):
        self.grid(4, lambda x, y: (30 * (1 + 9 * x), 3 * x * y, 25 * (1 + 8 * y * y)))
        done = self.run_certify(1, "grid.mesh", "--repair", "-o", "out.mesh", "--max-sites", "25",
                                "--angle-bound", "28")
        self.assertRegex(done.stderr, r"\Aasterism: not reached: ")
        self.assertRegex((self.folder / "out.mesh").read_text(), "Incomplete, not certified")

    def test_a_ring_keeps_its_hole(self):
        n, places, triangles = 12, [], []
        angle = 2 * 3.141592653589793 / n
        for radius in (1, 2):
            for i in range(n):
                turn = complex(0, 1) * angle * (i + 0.5 * (radius - 1))
                unit = 2.718281828459045 ** turn
                places.append((radius * unit.real, radius * unit.imag, 0))
        for i in range(n):
            j = (i + 1) % n
            triangles += [(i + 1, n + i + 1, j + 1, 0), (j + 1, n + i + 1, n + j + 1, 0)]
        self.write("ring.mesh", medit(places, triangles))
        self.write("ring.sol", solution([(4, 0, 4)] * len(places)))
        self.run_certify(0, "ring.mesh")
        self.write("ring.sol", solution([(4, 0, 4 + 30 * max(0, x)) for x, _, _ in places]))
        self.run_certify(0, "ring.mesh", "--repair", "-o", "out.mesh")

    def test_a_flat_triangle_is_counted(self):
        corners = [(0, 0, 0), (1, 0, 0), (1, 1, 0), (0.5, 0.5, 0)]
        self.write("t.mesh", medit(corners, [(1, 2, 3, 0), (1, 4, 3, 0)]))
        self.write("t.sol", solution([(1, 0, 1)] * 4))
        done = self.run_certify(1, "t.mesh", "--repair", "-o", "out.mesh")
        self.assertRegex(done.stdout, "\ninverted or flat: 1\n")
        self.assertRegex(done.stderr, "no triangulation")
        self.assertNotIn("out.mesh", self.files())
        # The corner is beyond the side that the two triangles share: turning one over folds the mesh.
        corners[3] = (0.75, 0.25, 0)
        self.write("t.mesh", medit(corners, [(1, 2, 3, 0), (1, 4, 3, 0)]))
        done = self.run_certify(1, "t.mesh", "--repair", "-o", "out.mesh")
        self.assertRegex(done.stderr, "no triangulation")
        self.assertNotIn("out.mesh", self.files())

    # Has the sections that BAMG writes, with quoted names that contain blanks.
    BAMG = ["MeshVersionFormatted 1", "", "Dimension", "2", "", "Identifier",
            '"B=background.mesh, G=square.mesh;2, Date: 01/02/03 10:02 43s"', "", "Geometry", '"square.mesh"', "",
            "Vertices", "4", "0 0 1", "1 0 2", "1 1 3", "0 1 4", "Edges", "4", "1 2 1", "2 3 2", "3 4 3", "4 1 4",
            "Triangles", "2", "1 2 4 1", "2 3 4 1", "SubDomainFromMesh", "1", "3 1 1 1", "VertexOnGeometricVertex",
            "2", "1 1", "2 2", "VertexOnGeometricEdge", "1", "3 1 0.5", "EdgeOnGeometricEdge", "1", "1 1",
            "MeshSupportOfVertices", '"background.mesh"', "IdentityOfMeshSupport", '"B"', "VertexOnSupportVertex", "1",
            "1 1", "VertexOnSupportEdge", "1", "2 1 7.5e-11", "VertexOnSupportTriangle", "1", "3 1 0.25 0.5", "End"]

    def test_a_mesh_as_bamg_writes_it(self):
        self.write("b.mesh", "\n".join(self.BAMG) + "\n")
        self.write("b.mtr", "4 3\n1 0.5 2\n1 0.5 2\n1 0.5 2\n1 0.5 2\n")
        self.write("round.mtr", "4 1\n0.5\n0.5\n0.5\n0.5\n")
        self.write("b.sol", solution([(1, 0.5, 2)] * 4))
        said = self.run_certify(0, "b.mesh", "b.sol").stdout
        self.assertIn("4 sites, 2 triangles, 4 boundary edges", said)
        self.assertEqual(self.run_certify(0, "b.mesh", "b.mtr").stdout, said)
        self.assertEqual(self.run_certify(0, "b.mesh", "--metric", "expr:1;0.5;2").stdout, said)
        half = self.run_certify(0, "b.mesh", "--metric", "identity", "--size", "0.5").stdout
        self.assertEqual(self.run_certify(0, "b.mesh", "round.mtr").stdout, half)
        for text, needle in (("4 2\n1 1\n1 1\n1 1\n1 1\n", "b.mtr:1: 1 or 3 numbers a vertex wanted, not '2'"),
                             ("3 1\n1 1 1\n", "b.mtr:1: 3 tensors for 4 vertices"),
                             ("4 1\n1\n1\n0\n1\n", "b.mtr:4: a length must be positive, not '0'"),
                             ("4 1\n1 1 1 1\n1\n", "b.mtr:3: '1' after the last tensor"),
                             ("4 1\n1 1 nan 1\n", "b.mtr:2: ")):
            self.write("b.mtr", text)
            self.assertIn(needle, self.run_certify(2, "b.mesh", "b.mtr").stderr)
        for line, needle in ((6, "open.mesh:7: Identifier: the text has no end"),
                             (9, "open.mesh:10: Geometry: a text in \" wanted, not 'square'")):
            lines = list(self.BAMG)
            lines[line] = '"B' if line == 6 else "square"
            text = "\n".join(lines)
            self.write("open.mesh", text.replace('"background.mesh"', "0").replace('"B"', "0")
                       if line == 9 else "\n".join(lines[:7]))
            self.assertIn(needle, self.run_certify(2, "open.mesh", "--metric", "identity").stderr)

    def test_a_formula_measures_and_repairs(self):
        self.grid(8, lambda x, y: (1, 0, 1))
        done = self.run_certify(0, "grid.mesh", "--metric", "swirl:12", "--repair", "-o", "repaired.mesh")
        self.assertIn(" of them new", done.stdout)
        self.assertEqual(self.run_command("verify", "repaired.mesh").returncode, 0)
        claim = json.loads((self.folder / "repaired.certificate.json").read_text())
        self.assertEqual(claim["asked"]["metric"], "swirl:12")
        for words, needle in ((["grid.sol", "--metric", "identity"], "SOL"), (["--size", "2"], "--metric"),
                              (["--metric", "swril"], "swril"), (["--metric", "expr:x-0.5;0;1"], "vertex 1"),
                              (["--metric", "identity", "--size", "-1"], "--size")):
            self.assertIn(needle, self.run_certify(2, "grid.mesh", *words).stderr)

    def test_what_cannot_be_read_or_meant_is_refused(self):
        corners = [(0, 0, 0), (1, 0, 0), (0, 1, 0)]
        good = medit(corners, [(1, 2, 3, 0)])
        round_one = [(1, 0, 1)] * 3
        cases = [
            (good, solution(round_one[:2]), r"t\.sol:4: "),
            (good, solution([(1, 0, 1), (1, 2, 1), (1, 0, 1)]), "vertex 2 .*not positive definite"),
            (good, solution([(1, 0, 1), (1, 0, "nan"), (1, 0, 1)]), r"t\.sol:7: "),
            (medit([*corners[:2], (0, 0, 0)], [(1, 2, 3, 0)]), solution(round_one),
             "vertex 1 .* vertex 3 .*same point"),
            (medit(corners, [(1, 2, 2, 0)]), solution(round_one), "vertex 2 .*twice"),
            (medit(corners, []), solution(round_one), "no triangle"),
            (medit(corners, [(1, 2, 4, 0)]), solution(round_one), r"t\.mesh:10: .*vertex 4"),
            ("", solution(round_one), r"t\.mesh:.*empty"),
        ]
        for mesh, tensors, message in cases:
            self.write("t.mesh", mesh)
            self.write("t.sol", tensors)
            done = self.run_certify(2, "t.mesh", "--repair", "-o", "out.mesh")
            self.assertRegex(done.stderr, message)
            self.assertEqual(done.stdout, "")
            self.assertNotIn("out.mesh", self.files())

    def test_without_a_metric_it_is_the_identity_which_is_said(self):
        self.write("t.mesh", medit([(0, 0, 0), (1, 0, 0), (0, 1, 0)], [(1, 2, 3, 0)]))
        done = self.run_certify(0, "t.mesh", "-o", "out.mesh")
        self.assertIn("metric: identity", done.stdout)
        claim = json.loads((self.folder / "out.certificate.json").read_text())
        self.assertEqual(claim["asked"]["metric"], "identity")
        self.assertEqual(self.run_command("verify", "out.mesh").returncode, 0)
        self.assertIn("t.sol: no such file", self.run_certify(2, "t.mesh", "t.sol").stderr)

    def test_bad_usage(self):
        self.grid(2, lambda x, y: (1, 0, 1))
        for arguments, message in [
                (["grid.mesh", "--repair"], "--repair: name the file"),
                (["grid.mesh", "-o", "grid.mesh"], "used twice"),
                (["grid.mesh", "--angle-bound", "60"], "out of range"),
                (["grid.mesh", "--max-sites", "8"], "the mesh has 9 vertices already"),
                (["nothing.mesh"], "nothing.mesh: no such file")]:
            self.assertRegex(self.run_certify(2, *arguments).stderr, message)


if __name__ == "__main__":
    unittest.main()
