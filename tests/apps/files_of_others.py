# SPDX-License-Identifier: MIT
"""Meshes and domains in the forms that other programs write: each is read in its program's sense, with a note for
what is changed or passed over, or refused by file and line."""
import json
import struct
import unittest

import command

HEAD = "MeshVersionFormatted 2\nDimension 2\n"
SQUARE = "Vertices\n4\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n"
TWO = "Triangles\n2\n1 2 3 1\n1 3 4 1\n"

# A rectangle of two squares, the left one in region 3, the right one in region 4, its four sides with markers.
POINTS = ((0, 0), (1, 0), (2, 0), (2, 1), (1, 1), (0, 1))
TRIANGLES = (((0, 1, 4), 3), ((0, 4, 5), 3), ((1, 2, 3), 4), ((1, 3, 4), 4))
EDGES = ((0, 1, 7), (1, 2, 7), (2, 3, 8), (3, 4, 9), (4, 5, 9), (5, 0, 10))
QUADRILATERALS = (((0, 1, 4, 5), 3), ((1, 2, 3, 4), 4))


def medit(points=POINTS, triangles=TRIANGLES, edges=EDGES, quadrilaterals=(), head=HEAD):
    lines = [head.rstrip("\n"), "Vertices", str(len(points))]
    lines += [" ".join(map(repr, p)) + " 0" for p in points]
    if edges:
        lines += ["Edges", str(len(edges)), *(f"{a + 1} {b + 1} {m}" for a, b, m in edges)]
    for name, cells in (("Triangles", triangles), ("Quadrilaterals", quadrilaterals)):
        if cells:
            lines += [name, str(len(cells))]
            lines += [" ".join(str(v + 1) for v in c) + f" {r}" for c, r in cells]
    return "\n".join([*lines, "End", ""])


def solution(values):
    return (HEAD + f"SolAtVertices\n{len(values)}\n1 1\n" + "\n".join(map(repr, values)) + "\nEnd\n")


def gmsh(version, elements, names="", nodes=None):
    nodes = nodes or [f"{k + 1} {x} {y} 0" for k, (x, y) in enumerate(POINTS)]
    return "\n".join([f"$MeshFormat\n{version} 0 8\n$EndMeshFormat", names, "$Nodes", str(len(nodes)), *nodes,
                      "$EndNodes", "$Elements", str(len(elements)), *elements, "$EndElements", ""])


def gmsh_elements(cells=TRIANGLES):
    all_of = [f"1 2 {m} {m} {a + 1} {b + 1}" for a, b, m in EDGES]
    all_of += [f"2 2 {r} {r} " + " ".join(str(v + 1) for v in c) for c, r in cells]
    return [f"{k + 1} {text}" for k, text in enumerate(all_of)]


def su2(cells=TRIANGLES):
    lines = ["% a comment", "NDIME= 2", f"NELEM= {len(cells)}"]
    lines += [f"{5 if len(c) == 3 else 9} " + " ".join(map(str, c)) + f" {k}" for k, (c, _) in enumerate(cells)]
    lines += [f"NPOIN= {len(POINTS)}", *(f"{x} {y} {k}" for k, (x, y) in enumerate(POINTS)), "NMARK= 4"]
    for marker, name in ((7, "lower"), (8, "8"), (9, "upper wall"), (10, "inlet")):
        edges = [f"3 {a} {b}" for a, b, m in EDGES if m == marker]
        lines += [f"MARKER_TAG= {name}", f"MARKER_ELEMS= {len(edges)}", *edges]
    return "\n".join(lines) + "\n"


def fort14():
    lines = ["a grid", f"{len(TRIANGLES)} {len(POINTS)} ! elements, nodes"]
    lines += [f"{10 * (k + 1)} {x} {y} 5.5" for k, (x, y) in enumerate(POINTS)]
    lines += [f"{k + 1} 3 " + " ".join(str(10 * (v + 1)) for v in c) for k, (c, _) in enumerate(TRIANGLES)]
    lines += ["1 = Number of open boundaries", "2 = nodes", "2 = nodes of boundary 1", "60", "10",
              "1 = Number of land boundaries", "6 = nodes", "6 20 = nodes, type", *"10 20 30 40 50 60".split()]
    return "\n".join(lines) + "\n"


def sms(cells=TRIANGLES):
    lines = ["MESH2D", 'MESHNAME "a mesh"', "NUM_MATERIALS_PER_ELEM 1"]
    lines += [("E3T" if len(c) == 3 else "E4Q") + f" {k + 1} " + " ".join(str(v + 1) for v in c) + f" {r}"
              for k, (c, r) in enumerate(cells)]
    lines += [f"ND {k + 1} {x} {y} 1.5" for k, (x, y) in enumerate(POINTS)]
    lines += ["NS 1 2", "NS -3 1", "NS 3 -4 2", "BEGPARAMDEF", "GM \"x\"", "ENDPARAMDEF"]
    return "\n".join(lines) + "\n"


def vtk(cells=TRIANGLES, binary=False, new=False):
    types = [5 if len(c) == 3 else 9 for c, _ in cells] + [3] * len(EDGES)
    lists = [c for c, _ in cells] + [(a, b) for a, b, _ in EDGES]
    marks = [r for _, r in cells] + [m for _, _, m in EDGES]
    out = [b"# vtk DataFile Version 5.1\na title\n" + (b"BINARY\n" if binary else b"ASCII\n"),
           b"DATASET UNSTRUCTURED_GRID\n"]

    def array(kind, values):
        code = {"double": "d", "int": "i", "vtktypeint64": "q"}[kind]
        return (struct.pack(f">{len(values)}{code}", *values) if binary
                else " ".join(map(str, values)).encode()) + b"\n"

    places = [c for p in POINTS for c in (*map(float, p), 0.0)]
    out += [f"POINTS {len(POINTS)} double\n".encode(), array("double", places)]
    if new:
        ends = [sum(map(len, lists[:k])) for k in range(len(lists) + 1)]
        out += [f"CELLS {len(ends)} {ends[-1]}\nOFFSETS vtktypeint64\n".encode(), array("vtktypeint64", ends),
                b"CONNECTIVITY vtktypeint64\n", array("vtktypeint64", [v for one in lists for v in one])]
    else:
        flat = [v for one in lists for v in (len(one), *one)]
        out += [f"CELLS {len(lists)} {len(flat)}\n".encode(), array("int", flat)]
    out += [f"CELL_TYPES {len(lists)}\n".encode(), array("int", types)]
    out += [f"POINT_DATA {len(POINTS)}\nVECTORS flow double\n".encode(), array("double", places),
            f"CELL_DATA {len(lists)}\nSCALARS region int 1\nLOOKUP_TABLE default\n".encode(), array("int", marks)]
    return b"".join(out)


def stl(binary=False):
    facets = [[(*POINTS[v], 0) for v in c] for c, _ in TRIANGLES]
    if binary:
        return (b"solid, or not".ljust(80) + struct.pack("<I", len(facets)) +
                b"".join(struct.pack("<12fH", 0, 0, 1, *(x for p in f for x in p), 0) for f in facets))
    text = ""
    for name, part in (("left", facets[:2]), ("right", facets[2:])):
        text += f"solid {name}\n" + "".join(
            "facet normal 0 0 1\n outer loop\n" + "".join(f"  vertex {x} {y} {z}\n" for x, y, z in f) +
            " endloop\nendfacet\n" for f in part) + f"endsolid {name}\n"
    return text.encode()


class ReaderTest(command.CommandTest):
    def certificate(self, name):
        return json.loads((self.folder / name).with_suffix(".certificate.json").read_text())

    def made(self):
        """Returns whether the mesh is certified, and the area of each region, of which there is at least one."""
        claim = self.certificate("out.msh")["audit"]
        rows = claim.get("regions", [])
        return {"certified": claim["certified"],
                "regions": [{"number": r["region"], "area": round(r["area"], 9)} for r in rows]}

    def mesh(self, name, content, *options):
        """Meshes the file; returns the certificate and the notes."""
        self.write(name, content)
        done = self.run_command("mesh", name, "--size", "0.5", "-o", "out.msh", *options)
        self.assertEqual(done.returncode, 0, done.stderr)
        # Passes over the note on the line between the regions, which none of the files lists.
        notes = [line for line in done.stderr.splitlines() if line.startswith("asterism: note: ")
                 and "edges between triangles of different regions" not in line]
        return self.made(), notes

    def area(self):
        """Returns the area of the mesh written last, within the tests' tolerance."""
        text = (self.folder / "out.msh").read_text()
        lines = text.split("$Nodes\n")[1].split("$EndNodes")[0].split("\n")
        count = int(lines[0].split()[1])
        places = {}
        at = 1
        while len(places) < count:
            block = int(lines[at].split()[3])
            tags = [int(t) for t in lines[at + 1:at + 1 + block]]
            for t, line in zip(tags, lines[at + 1 + block:at + 1 + 2 * block]):
                places[t] = tuple(map(float, line.split()[:2]))
            at += 1 + 2 * block
        elements = text.split("$Elements\n")[1].split("\n$EndElements")[0].split("\n")
        total, at = 0.0, 1
        while at < len(elements):
            _, _, kind, block = map(int, elements[at].split())
            for line in elements[at + 1:at + 1 + block]:
                if kind == 2:
                    (ax, ay), (bx, by), (cx, cy) = (places[int(v)] for v in line.split()[1:])
                    total += ((bx - ax) * (cy - ay) - (by - ay) * (cx - ax)) / 2
            at += 1 + block
        return total

    def expect_note(self, name, content, *parts):
        """Meshes the file with a single note, which --strict refuses."""
        made, notes = self.mesh(name, content)
        self.assertEqual(len(notes), 1, notes)
        for part in parts:
            self.assertIn(part, notes[0])
        strict = self.run_command("mesh", name, "--size", "0.5", "-o", "strict.msh", "--strict")
        self.assertEqual((strict.returncode, (self.folder / "strict.msh").exists()), (2, False))
        self.assertIn("--strict: ", strict.stderr)
        return made

    def expect_refusal(self, name, content, *parts, command_line=("mesh", "{}", "--size", "0.5", "-o", "out.msh")):
        self.write(name, content)
        done = self.run_command(*(word.replace("{}", name) for word in command_line))
        self.assertEqual(done.returncode, 2, done.stdout + done.stderr)
        self.assertIn(name, done.stderr)
        for part in parts:
            self.assertIn(part, done.stderr)


class OrderTest(ReaderTest):
    """Faults that are put in order in every format."""

    def test_clockwise_triangles_are_turned_over(self):
        turned = [((a, c, b), r) for (a, b, c), r in TRIANGLES]
        self.expect_note("m.mesh", medit(triangles=turned), "the triangles are clockwise and turned over: 4")
        self.assertAlmostEqual(self.area(), 2)
        mixed = [turned[0], *TRIANGLES[1:]]
        self.expect_note("n.mesh", medit(triangles=mixed), "1 of 4 triangles", "triangle 1")
        self.expect_note("o.msh", gmsh("2.2", gmsh_elements(turned)), "clockwise")
        self.expect_note("p.su2", su2(turned), "clockwise")

    def test_a_clockwise_mesh_is_adapted_and_certified(self):
        turned = [((a, c, b), r) for (a, b, c), r in TRIANGLES]
        self.write("m.mesh", medit(triangles=turned))
        self.write("u.sol", solution([x * x + y * y for x, y in POINTS]))
        done = self.run_command("adapt", "m.mesh", "--solution", "u.sol", "--vertices", "30", "-o", "n.mesh")
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertIn("clockwise", done.stderr)
        done = self.run_command("certify", "m.mesh")
        self.assertIn("6 sites, 4 triangles, 6 boundary edges", done.stdout)
        self.assertIn("inverted or flat: 0", done.stdout)
        self.assertIn("clockwise", done.stderr)

    def test_a_folded_mesh_stays_refused(self):
        points = [*POINTS[:4], (1.4, -0.4), POINTS[5]]
        self.expect_refusal("m.mesh", medit(points=points), "is no triangulation")

    def test_vertices_in_no_triangle_are_left_out_with_their_rows(self):
        points = [(9, 9), *POINTS, (5, 5)]
        shifted = [(tuple(v + 1 for v in c), r) for c, r in TRIANGLES]
        edges = [(a + 1, b + 1, m) for a, b, m in EDGES]
        content = medit(points, shifted, edges)
        self.expect_note("m.mesh", content, "2 vertices in no triangle left out, the first: vertex 1 at (9, 9)")
        self.write("plain.mesh", medit())
        field = [3 * x + y for x, y in POINTS]
        self.write("u.sol", solution([-1e9, *field, 1e9]))
        done = self.run_command("transfer", "m.mesh", "u.sol", "plain.mesh", "-o", "v.sol")
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertEqual([float(x) for x in (self.folder / "v.sol").read_text().split()[8:-1]], field)
        # A transfer to this mesh writes a row for each vertex of the file.
        self.write("w.sol", solution(field))
        done = self.run_command("transfer", "plain.mesh", "w.sol", "m.mesh", "-o", "x.sol")
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertEqual([float(x) for x in (self.folder / "x.sol").read_text().split()[8:-1]], [0, *field, 0])
        # The metric of a file has a row for each vertex of its mesh, isolated ones included.
        (self.folder / "u.sol").unlink()
        self.write("m.sol", HEAD + "SolAtVertices\n8\n1 3\n" + "4 0 4\n" * 7 + "1e300 0 1e300\nEnd\n")
        done = self.run_command("certify", "m.mesh")
        self.assertRegex(done.stdout, r"edges of metric length 0.71 to 1.41: 0 of 9")

    def test_edges_that_are_listed_again(self):
        self.expect_note("m.mesh", medit(edges=[*EDGES, (1, 0, 7)]), "1 edge is listed again")
        self.expect_refusal("n.mesh", medit(edges=[*EDGES, (1, 0, 8)]), "with the markers 7 and 8")

    def test_triangles_that_are_listed_again(self):
        again = [*TRIANGLES, ((4, 0, 1), 3)]
        self.expect_note("m.mesh", medit(triangles=again), "1 triangle is listed again")
        self.expect_refusal("n.mesh", medit(triangles=[*TRIANGLES, ((4, 0, 1), 4)]), "in the regions 3 and 4")

    def test_heights_of_rounding(self):
        head = HEAD.replace("2\nDimension 2", "2\nDimension 3")
        points = [(x, y, 1e-17 * (k % 3 - 1)) for k, (x, y) in enumerate(POINTS)]
        self.expect_note("m.mesh", medit(points, head=head), "heights of up to 1e-17")
        self.expect_note("n.mesh", medit([(x, y, 2.5) for x, y in POINTS], head=head), "z = 2.5")
        self.expect_refusal("o.mesh", medit([(x, y, 1e-3 * x) for x, y in POINTS], head=head), "o.mesh:6:", "0.001")

    def test_quadrilaterals_are_split(self):
        self.expect_note("m.mesh", medit(triangles=(), quadrilaterals=QUADRILATERALS), "2 quadrilaterals")
        self.assertAlmostEqual(self.area(), 2)
        # With one corner moved inward, only one diagonal is inside.
        points = [(0, 0), (2, 0), (0.5, 0.5), (0, 2)]
        dart = medit(points, (), (), [((0, 1, 2, 3), 1)])
        self.expect_note("n.mesh", dart, "1 quadrilateral is split")
        self.assertAlmostEqual(self.area(), 1)
        folded = medit(((0, 0), (1, 0), (1, 1), (0, 1)), (), (), [((0, 1, 3, 2), 1)])
        self.expect_refusal("o.mesh", folded, "o.mesh:11:", "folded")
        triangle = medit(points[:3], (), (), [((0, 1, 2, 2), 1)])
        self.mesh("p.mesh", triangle)
        self.assertAlmostEqual(self.area(), 0.5)

    def test_sides_that_are_not_listed_have_marker_0(self):
        self.expect_note("m.mesh", medit(edges=EDGES[:2]), "4 of 6 boundary edges are not listed")


class MeditTest(ReaderTest):
    def test_versions_byte_order_mark_and_line_ends(self):
        for version in (0, 1, 4):
            self.mesh("m.mesh", medit(head=f"MeshVersionFormatted {version}\nDimension\n2\n"))
        self.mesh("m.mesh", b"\xef\xbb\xbf" + medit().replace("\n", "\r\n").encode())

    def test_sections_of_others_are_passed_over(self):
        more = ("ParallelCommunicatorVertices\n0\nParallelTriangleCommunicators\n1\n3 2\nRequiredTriangles\n1\n1\n"
                "ISolAtVertices\n1\n1 1\n2.5\n")
        made = self.expect_note("m.mesh", medit().replace("End\n", more + "End\n"), "passed over:",
                                "ParallelTriangleCommunicators")
        self.assertEqual({r["number"] for r in made["regions"]}, {3, 4})

    def test_normals_of_three_numbers_in_the_plane(self):
        self.mesh("m.mesh", medit().replace("End", "Normals\n2\n0 0 1\n0 0 1\nRidges\n1\n1\nEnd"))

    def test_one_file_may_be_read_for_two_things(self):
        """A mesh with its metric in the .sol file of its name, and a mesh with fields that is converted to another
        format."""
        self.write("m.mesh", medit())
        self.write("m.sol", solution([0.3, 0.3, 0.5, 0.5, 0.4, 0.4]))
        nodes = "".join(f"{k + 1} {x * x}\n" for k, (x, _) in enumerate(POINTS))
        self.write("u.msh", gmsh("2.2", gmsh_elements())
                   + f'$NodeData\n1\n"u"\n1\n0.0\n3\n0\n1\n{len(POINTS)}\n{nodes}$EndNodeData\n')
        for line in (("mesh", "m.mesh", "--metric", "m.sol", "--size", "1", "-o", "o.mesh"),
                     ("certify", "m.mesh", "--metric", "m.sol", "--repair", "-o", "o.mesh"),
                     ("transfer", "u.msh", "u.msh", "m.mesh", "-o", "v.sol"),
                     ("adapt", "u.msh", "--solution", "u.msh", "--vertices", "20", "-o", "o.mesh")):
            done = self.run_command(*line)
            self.assertEqual(done.returncode, 0, done.stderr)
        for line in (("certify", "m.mesh", "--metric", "m.sol", "--repair", "-o", "m.mesh"),
                     ("certify", "u.msh", "--metric", "m.mesh", "--repair", "-o", "m.mesh"),
                     ("mesh", "u.msh", "--metric", "m.sol", "--size", "1", "-o", "m.mesh")):
            before = (self.folder / "m.mesh").read_text()
            done = self.run_command(*line)
            self.assertEqual((done.returncode, "used twice" in done.stderr), (2, True), done.stderr)
            self.assertEqual((self.folder / "m.mesh").read_text(), before)

    def test_edges_alone_are_a_domain(self):
        edges = HEAD + SQUARE + "Edges\n4\n1 2 1\n2 3 2\n3 4 3\n4 1 4\nEnd\n"
        self.mesh("m.mesh", edges)
        self.assertAlmostEqual(self.area(), 1)
        for name in ("1", "2", "3", "4"):
            self.assertIn(f'"marker {name}"', (self.folder / "out.msh").read_text())
        done = self.run_command("info", "m.mesh")
        self.assertIn("domain", done.stdout)
        done = self.run_command("verify", "out.msh")
        done = self.run_command("mesh", "m.mesh", "--size", "0.5", "-o", "n.mesh")
        self.assertEqual(self.run_command("verify", "n.mesh", "--domain", "m.mesh").returncode, 0)
        gap = edges.replace("4\n1 2 1\n", "3\n")
        self.expect_refusal("n.mesh", gap, "--convex-hull")

    def test_a_geometry_of_bamg_has_straight_edges(self):
        edges = HEAD + SQUARE + "Edges\n4\n1 2 1\n2 3 2\n3 4 3\n4 1 4\nMaximalAngleOfCorner 91\n"
        made = edges + "Corners\n3\n1 2 3\nEnd\n"
        self.expect_note("m.mesh", made, "edges are straight here", "through 1 of their vertices", "vertex 4")
        # BAMG's own geometries have this line before the dimension.
        before = made.replace("MaximalAngleOfCorner 91\n", "").replace("Dimension", "MaximalAngleOfCorner 91\nDimension")
        self.expect_note("b.mesh", before, "through 1 of their vertices", "vertex 4")
        for text in (edges + "Corners\n4\n1 2 3 4\nEnd\n", edges.replace("91", "89") + "End\n",
                     edges.replace("MaximalAngleOfCorner 91\n", "Tangents 0\nEnd\n")):
            _, notes = self.mesh("n.mesh", text)
            self.assertFalse([n for n in notes if "straight" in n], notes)

    def test_edges_alone_in_binary(self):
        def block(keyword, content, at):
            return struct.pack("<ii", keyword, at + 8 + len(content)) + content
        data = struct.pack("<ii", 1, 2) + struct.pack("<iii", 3, 20, 2)
        data += block(4, struct.pack("<i", 4) + b"".join(
            struct.pack("<ddi", x, y, 0) for x, y in ((0, 0), (1, 0), (1, 1), (0, 1))), len(data))
        data += block(5, struct.pack("<i", 4) + b"".join(
            struct.pack("<iii", k + 1, (k + 1) % 4 + 1, k) for k in range(4)), len(data))
        self.mesh("m.meshb", data + struct.pack("<ii", 54, 0))
        self.assertAlmostEqual(self.area(), 1)

    def test_parts_of_a_geometry(self):
        """BAMG's sub-domains: each names a region by an edge and its side, or a hole."""
        points = [(0, 0), (3, 0), (3, 3), (0, 3), (1, 1), (2, 1), (2, 2), (1, 2)]
        edges = [(a, b, 1) for a, b in ((0, 1), (1, 2), (2, 3), (3, 0), (4, 5), (5, 6), (6, 7), (7, 4))]
        text = medit(points, (), edges)
        parts = "SubDomainFromGeom\n2\n2 1 1 7\n2 5 1 9\nEnd\n"
        made, _ = self.mesh("m.mesh", text.replace("End\n", parts))
        self.assertEqual({r["number"]: r["area"] for r in made["regions"]}, {7: 8, 9: 1})
        outer = parts.replace("2 5 1 9", "2 5 -1 9").replace("2 1 1 7", "2 6 1 7")
        made, _ = self.mesh("n.mesh", text.replace("End\n", outer))
        self.assertEqual({r["number"]: r["area"] for r in made["regions"]}, {9: 8, 7: 1})
        one = "SubDomainFromGeom\n1\n2 1 1 7\nEnd\n"
        self.mesh("o.mesh", text.replace("End\n", one))
        self.assertAlmostEqual(self.area(), 8)
        self.expect_refusal("p.mesh", text.replace("End\n", one.replace("2 1 1 7", "2 1 -1 7")), "outside of all edges")

    def test_elements_of_second_order_by_their_corners(self):
        points = [(0, 0), (1, 0), (0, 1), (0.5, 0), (0.5, 0.5), (0, 0.5)]
        text = medit(points, (), ()).replace("End\n", "TrianglesP2\n1\n1 2 3 4 5 6 9\nEdgesP2\n1\n1 2 4 3\nEnd\n")
        _, notes = self.mesh("m.mesh", text)
        self.assertIn("2 elements are of higher order", notes[0])
        self.assertIn("3 vertices in no triangle", " ".join(notes))
        self.assertAlmostEqual(self.area(), 0.5)

    def test_references_beyond_32_bits(self):
        wide = [(c, 2**32 + r) for c, r in TRIANGLES]
        made = self.expect_note("m.mesh", medit(triangles=wide), "4294967299 is 1, 4294967300 is 2")
        self.assertEqual({r["number"]: r["area"] for r in made["regions"]}, {1: 1, 2: 1})

    def test_the_least_reference_of_32_bits_stays(self):
        least = [(c, -2**31 if r == 3 else 2**31 - 1) for c, r in TRIANGLES]
        made, notes = self.mesh("m.mesh", medit(triangles=least))
        self.assertEqual(({r["number"] for r in made["regions"]}, notes), ({-2**31, 2**31 - 1}, []))

    def test_exponents_of_fortran(self):
        text = medit().replace("(2, 1)", "").replace("\n2 0 0\n", "\n2.0D+00 0.0d0 0\n").replace("\n1 1 0\n", "\n.1D1 1.00-000 0\n")
        made, notes = self.mesh("m.mesh", text)
        self.assertEqual((notes, made["certified"]), ([], True))
        self.expect_refusal("n.mesh", text.replace("2.0D+00", "2.0D+D0"), "n.mesh:7:", "2.0D+D0")


class GmshTest(ReaderTest):
    def test_versions(self):
        for version in ("2", "2.0", "2.1", "2.2"):
            self.mesh("m.msh", gmsh(version, gmsh_elements()))
            self.assertAlmostEqual(self.area(), 2)
        self.expect_refusal("m.msh", gmsh("3", gmsh_elements()), "m.msh:2:", "msh41")

    def test_version_1(self):
        lines = ["$NOD", "6", *(f"{k + 1} {x} {y} 0" for k, (x, y) in enumerate(POINTS)), "$ENDNOD", "$ELM", "4"]
        lines += [f"{k + 1} 2 {r} {r} 3 " + " ".join(str(v + 1) for v in c) for k, (c, r) in enumerate(TRIANGLES)]
        made, _ = self.mesh("m.msh", "\n".join([*lines, "$ENDELM", ""]))
        self.assertEqual({r["number"]: r["area"] for r in made["regions"]}, {3: 1, 4: 1})

    def test_version_4_0(self):
        text = ("$MeshFormat\n4 0 8\n$EndMeshFormat\n$Entities\n1 0 2 0\n1 0 0 0 0 0 0 0\n"
                "3 0 0 0 1 1 0 1 3 0\n4 1 0 0 2 1 0 1 4 0\n$EndEntities\n$Nodes\n1 6\n3 2 1 6\n")
        text += "".join(f"{k + 1} {x} {y} 0 {x} {y}\n" for k, (x, y) in enumerate(POINTS))
        text += "$EndNodes\n$Elements\n2 4\n"
        for region in (3, 4):
            cells = [c for c, r in TRIANGLES if r == region]
            text += f"{region} 2 2 {len(cells)}\n"
            text += "".join(f"{region * 10 + k} " + " ".join(str(v + 1) for v in c) + "\n" for k, c in enumerate(cells))
        made, _ = self.mesh("m.msh", text + "$EndElements\n")
        self.assertEqual({r["number"]: r["area"] for r in made["regions"]}, {3: 1, 4: 1})

    def test_several_physical_groups_keep_all_names(self):
        names = '$PhysicalNames\n3\n2 1 "all"\n2 3 "left"\n2 4 "right # one"\n$EndPhysicalNames'
        entities = "$Entities\n0 0 2 0\n3 0 0 0 1 1 0 2 1 3 0\n4 1 0 0 2 1 0 2 1 4 0\n$EndEntities\n"
        text = f"$MeshFormat\n4.1 0 8\n$EndMeshFormat\n{names}\n{entities}$Nodes\n1 6 1 6\n2 3 0 6\n1\n2\n3\n4\n5\n6\n"
        text += "".join(f"{x} {y} 0\n" for x, y in POINTS) + "$EndNodes\n$Elements\n2 4 1 4\n"
        for region in (3, 4):
            cells = [c for c, r in TRIANGLES if r == region]
            text += f"2 {region} 2 {len(cells)}\n"
            text += "".join(f"{k + 1} " + " ".join(str(v + 1) for v in c) + "\n" for k, c in enumerate(cells))
        made = self.expect_note("m.msh", text + "$EndElements\n", "several physical groups", "all+left")
        self.assertEqual({r["number"]: r["area"] for r in made["regions"]}, {3: 1, 4: 1})
        written = (self.folder / "out.msh").read_text()
        self.assertIn('"all+left"', written)
        self.assertIn('"all+right # one"', written)
        # Version 2 lists an element once for each of its groups.
        elements = gmsh_elements() + [f"{20 + k} 2 2 1 9 " + " ".join(str(v + 1) for v in c)
                                      for k, (c, _) in enumerate(TRIANGLES)]
        self.write("n.msh", gmsh("2.2", elements, names))
        done = self.run_command("mesh", "n.msh", "--size", "0.5", "-o", "out.msh")
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertIn('"all+left"', (self.folder / "out.msh").read_text())
        self.assertEqual({r["number"]: r["area"] for r in self.made()["regions"]}, {3: 1, 4: 1})

    def test_centres_of_arcs(self):
        nodes = [f"{k + 1} {x} {y} 0" for k, (x, y) in enumerate(POINTS)] + ["99 5 5 0"]
        self.expect_note("m.msh", gmsh("2.2", gmsh_elements(), nodes=nodes), "1 vertex in no triangle", "(5, 5)")

    def test_quadrilaterals_and_higher_order(self):
        quads = [f"{k + 1} 3 2 {r} {r} " + " ".join(str(v + 1) for v in c) for k, (c, r) in enumerate(QUADRILATERALS)]
        self.expect_note("m.msh", gmsh("2.2", quads), "2 quadrilaterals are split")
        nodes = ["1 0 0 0", "2 1 0 0", "3 0 1 0", "4 .5 0 0", "5 .5 .5 0", "6 0 .5 0"]
        _, notes = self.mesh("n.msh", gmsh("2.2", ["1 9 2 5 5 1 2 3 4 5 6"], nodes=nodes))
        self.assertIn("higher order", notes[0])
        self.expect_refusal("o.msh", gmsh("2.2", ["1 4 2 5 5 1 2 3 4"]), "element of type")

    def test_values_on_triangles_are_passed_over_with_a_note(self):
        values = '$ElementData\n1\n"u"\n1\n0\n3\n0\n1\n1\n1 2.5\n$EndElementData\n'
        _, notes = self.mesh("m.msh", gmsh("2.2", gmsh_elements()) + values + values)
        self.assertEqual(len(notes), 1, notes)
        self.assertIn("values on triangles", notes[0])

    def test_medit_under_the_same_name(self):
        """BAMG names its meshes .msh."""
        made, notes = self.mesh("m.msh", medit())
        self.assertEqual({r["number"]: r["area"] for r in made["regions"]}, {3: 1, 4: 1})

    def test_lines_alone_are_a_domain(self):
        self.mesh("m.msh", gmsh("2.2", gmsh_elements(())))
        self.assertAlmostEqual(self.area(), 2)

    def test_freefem(self):
        lines = [f"{len(POINTS)} {len(TRIANGLES)} {len(EDGES)}", *(f"{x} {y} 1" for x, y in POINTS)]
        lines += [" ".join(str(v + 1) for v in c) + f" {r}" for c, r in TRIANGLES]
        lines += [f"{a + 1} {b + 1} {m}" for a, b, m in EDGES]
        made, notes = self.mesh("m.msh", "\n".join(lines) + "\n")
        self.assertEqual(({r["number"]: r["area"] for r in made["regions"]}, notes), ({3: 1, 4: 1}, []))
        self.expect_refusal("n.msh", "\n".join(lines) + "\n7\n", "n.msh:18:", "after the last edge")
        self.expect_refusal("o.msh", "\n".join(lines).replace("1 2 5 3", "1 2 50 3") + "\n", "o.msh:8:", "50")


class NewFormatsTest(ReaderTest):
    def test_values_on_cells_of_vtk_are_passed_over_with_a_note(self):
        cells = len(TRIANGLES) + len(EDGES)
        more = b"SCALARS pressure double 1\nLOOKUP_TABLE default\n" + b"0.5 " * cells + b"\n"
        _, notes = self.mesh("m.vtk", vtk() + more)
        self.assertEqual(len(notes), 1, notes)
        self.assertIn("values on triangles", notes[0])
        self.assertIn("'pressure'", notes[0])

    def regions(self, made):
        return {r["number"]: r["area"] for r in made["regions"]}

    def test_su2(self):
        _, notes = self.mesh("m.su2", su2())
        self.assertEqual(notes, [])
        self.assertAlmostEqual(self.area(), 2)
        text = (self.folder / "out.msh").read_text()
        for name in ('"lower"', '"upper wall"', '"inlet"', '"marker 8"'):
            self.assertIn(name, text)
        self.expect_note("n.su2", su2(QUADRILATERALS), "2 quadrilaterals")
        self.expect_note("o.su2", su2() + "FFD_NBOX= 1\nFFD_CORNER_POINTS= 1\n0.0 0.5\n", "FFD_NBOX")
        self.expect_refusal("p.su2", su2().replace("NDIME= 2", "NDIME= 3"), "p.su2:2:", "NDIME")
        self.expect_refusal("q.su2", su2().replace("5 0 1 4 0", "5 0 1 44 0"), "q.su2:4:", "44")
        self.expect_refusal("r.su2", "NZONE= 2\n" + su2(), "r.su2:1:", "zone")

    def test_adcirc(self):
        for name in ("fort.14", "m.grd"):
            _, notes = self.mesh(name, fort14())
            self.assertEqual(len(notes), 1)
            self.assertIn("depths", notes[0])
            self.assertAlmostEqual(self.area(), 2)
            text = (self.folder / "out.msh").read_text()
            self.assertIn('"open 1"', text)
            self.assertIn('"land 1 of type 20"', text)
        self.mesh("short.14", "\n".join(fort14().split("\n")[:12]) + "\n")
        self.expect_refusal("n.14", fort14().replace("1 3 10 20 50", "1 3 10 20 55"), "n.14:9:", "55")
        self.expect_refusal("o.14", fort14()[:60], "o.14:")

    def test_strings_that_share_a_side(self):
        shared = fort14().replace("6 = nodes\n6 20 = nodes, type", "7 = nodes\n7 20 = nodes, type") + "10\n"
        _, notes = self.mesh("m.14", shared)
        self.assertTrue(any("in several strings" in n for n in notes), notes)
        self.assertIn('"open 1+land 1 of type 20"', (self.folder / "out.msh").read_text())

    def test_2dm(self):
        made, notes = self.mesh("m.2dm", sms())
        self.assertEqual(self.regions(made), {3: 1, 4: 1})
        self.assertTrue(any("heights" in n for n in notes), notes)
        self.assertIn('1 2 "marker 2"', (self.folder / "out.msh").read_text())
        made, notes = self.mesh("n.2dm", sms(QUADRILATERALS))
        self.assertEqual(self.regions(made), {3: 1, 4: 1})
        self.expect_refusal("o.2dm", sms().replace("ND 6", "ND 5"), "o.2dm:13:", "twice")
        made, notes = self.mesh("p.2dm", sms().replace("NS 3 -4 2", "NS 1 -4 2"))
        self.assertTrue(any("string" in n for n in notes), notes)

    def test_vtk(self):
        for binary in (False, True):
            for new in (False, True):
                made, notes = self.mesh("m.vtk", vtk(TRIANGLES, binary, new))
                self.assertEqual((self.regions(made), notes), ({3: 1, 4: 1}, []))
        self.expect_note("n.vtk", vtk(QUADRILATERALS), "2 quadrilaterals")
        polygons = ("# vtk DataFile Version 3.0\nx\nASCII\nDATASET POLYDATA\nPOINTS 6 float\n" +
                    "".join(f"{x} {y} 0\n" for x, y in POINTS) + "POLYGONS 2 10\n4 0 1 4 5\n4 1 2 3 4\n")
        self.expect_note("o.vtk", polygons, "2 quadrilaterals")
        self.mesh("lower.vtk", vtk().replace(b"SCALARS", b"Scalars").replace(b"CELL_DATA", b"Cell_Data"))
        self.expect_refusal("p.vtk", vtk().replace(b"ASCII", b"PLAIN"), "p.vtk:3:", "ASCII")
        self.expect_refusal("q.vtk", vtk()[:300], "q.vtk:")
        self.expect_refusal("r.vtk", vtk(binary=True)[:300], "r.vtk:")

    def test_stl(self):
        made, notes = self.mesh("m.stl", stl())
        self.assertEqual((self.regions(made), len(notes)), ({1: 1, 2: 1}, 0))
        self.assertIn('"right"', (self.folder / "out.msh").read_text())
        self.mesh("n.stl", stl(binary=True))
        self.assertAlmostEqual(self.area(), 2)
        # A cube's corners lie above each other in the plane; the file may list either first.
        text = stl().decode()
        above = text + text.replace(" 0\n", " 1\n").replace("facet normal 0 0 1", "facet normal 0 0 -1")
        self.expect_refusal("p.stl", above, "above each other")
        self.expect_refusal("q.stl", text.replace(" 0\n", " 1\n") + text, "above each other")
        self.expect_refusal("o.stl", stl().replace(b"vertex 1 1 0", b"vertex 1 1 3"), "o.stl:", "is not 0")

    def test_every_format_is_certified_and_told(self):
        """Without a metric the mesh is judged in the identity, and the output says so."""
        files = {"a.mesh": medit(), "b.msh": gmsh("2.2", gmsh_elements()), "c.su2": su2(), "d.14": fort14(),
                 "e.2dm": sms(), "f.vtk": vtk(), "g.stl": stl(True), "h.grd": fort14()}
        for name, content in files.items():
            with self.subTest(name):
                self.write(name, content)
                done = self.run_command("certify", name, "--all-edges")
                self.assertIn("metric: identity", done.stdout)
                # The verdict is not compared: squares are ties, and the line between the regions is not listed.
                self.assertIn("6 sites, 4 triangles, 6 boundary edges", done.stdout)
                self.assertIn("worst angle 45.00", done.stdout)
                done = self.run_command("info", name)
                self.assertEqual(done.returncode, 0, done.stderr)
                done = self.run_command("draw", name, "-o", "picture.svg")
                self.assertEqual(done.returncode, 0, done.stderr)


class TriangleTest(ReaderTest):
    CORNERS = "4 2 0 0\n1 0 0\n2 1 0\n3 1 1\n4 0 1\n"
    SIDES = "4 0\n1 1 2\n2 2 3\n3 3 4\n4 4 1\n0\n"

    def test_attributes_that_are_no_whole_numbers(self):
        poly = self.CORNERS.replace("4 2", "4 2") + self.SIDES + "1\n1 .5 .5 2.5 0.01\n"
        _, notes = self.mesh("m.poly", poly)
        self.assertIn("2.5 is region 1", notes[0])
        self.assertIn('2 1 "2.5"', (self.folder / "out.msh").read_text())
        halves = ("6 2 0 0\n1 0 0\n2 1 0\n3 2 0\n4 2 1\n5 1 1\n6 0 1\n7 0\n1 1 2\n2 2 3\n3 3 4\n4 4 5\n5 5 6\n6 6 1\n"
                  "7 2 5\n0\n2\n1 .5 .5 {}\n2 1.5 .5 {}\n")
        for left, right, numbers in (("0.01", "7", {1, 7}), ("1", "0.5", {1, 2}), ("-0.5", "-0.5", set())):
            made, notes = self.mesh("n.poly", halves.format(left, right))
            self.assertEqual({r["number"] for r in made["regions"]}, numbers)

    def test_a_hull_for_points_and_open_boundaries(self):
        self.expect_refusal("m.node", self.CORNERS, "--convex-hull")
        self.write("m.node", self.CORNERS + "")
        done = self.run_command("mesh", "m.node", "--convex-hull", "--size", "0.5", "-o", "n.mesh")
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertIn("4 of 4 sides of the convex hull", done.stderr)
        for options, status in (((), 2), (("--convex-hull",), 0)):
            done = self.run_command("verify", "n.mesh", "--domain", "m.node", *options)
            self.assertEqual(done.returncode, status, done.stderr)
        # Vertices on the sides of the hull divide these.
        text = "6 2 0 0\n0 0 0\n1 2 0\n2 2 2\n3 0 2\n4 1 0\n5 1 1\n1 1\n0 0 1 5\n0\n"
        done = self.mesh("o.poly", text, "--convex-hull")
        self.assertAlmostEqual(self.area(), 4)
        self.expect_refusal("p.poly", text, "--convex-hull")
        # The exact domain of `adapt` is closed likewise.
        self.write("old.mesh", medit(points=((0, 0), (1, 0), (1, 1), (0, 1)), triangles=(((0, 1, 2), 1), ((0, 2, 3), 1)),
                                     edges=()))
        adapt = ("adapt", "old.mesh", "--implied", "--domain", "m.node", "-o", "a.mesh")
        self.assertEqual(self.run_command(*adapt).returncode, 2)
        done = self.run_command(*adapt, "--convex-hull")
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertIn("4 of 4 sides of the convex hull", done.stderr)
        line = "3 2 0 0\n1 0 0\n2 1 1\n3 2 2\n"
        self.expect_refusal("q.node", line, "on one line",
                            command_line=("mesh", "{}", "--convex-hull", "--size", "1", "-o", "out.msh"))

    def test_exponents_of_fortran(self):
        self.mesh("m.poly", self.CORNERS.replace("1 0 0", "1 0.0D0 0.d-3").replace("2 1 0", "2 1.D+00 0") + self.SIDES)


if __name__ == "__main__":
    unittest.main()
