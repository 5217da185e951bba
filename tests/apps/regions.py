# SPDX-License-Identifier: MIT
"""Regions of a mesh that is a domain: they come back with their numbers, markers and areas."""
import collections
import itertools
import json
import os
import random
import struct
import unittest
from fractions import Fraction

import command

FORMATS = ("mesh", "meshb", "msh", "vtu")
CASES = int(os.environ.get("ASTERISM_REGION_CASES", "24"))


class Plane:
    """A triangulation with a region for each triangle and some of its edges, with markers."""

    def __init__(self, points, triangles, regions, edges=()):
        self.points, self.triangles, self.regions = points, triangles, regions
        self.edges = list(edges)  # a, b, marker

    def areas(self):
        """Returns the area of each region, in fractions."""
        areas = collections.defaultdict(Fraction)
        for t, region in zip(self.triangles, self.regions):
            (ax, ay), (bx, by), (cx, cy) = (tuple(map(Fraction, self.points[v])) for v in t)
            areas[region] += ((bx - ax) * (cy - ay) - (by - ay) * (cx - ax)) / 2
        return dict(areas)

    def sides(self):
        """Returns the triangles on each edge, by the edge's two ends."""
        at = collections.defaultdict(list)
        for k, t in enumerate(self.triangles):
            for a, b in ((t[0], t[1]), (t[1], t[2]), (t[2], t[0])):
                at[frozenset((a, b))].append(k)
        return at

    def medit(self):
        lines = ["MeshVersionFormatted 2", "Dimension 2", "Vertices", str(len(self.points))]
        lines += [f"{x!r} {y!r} 0" for x, y in self.points]
        if self.edges:
            lines += ["Edges", str(len(self.edges))]
            lines += [f"{a + 1} {b + 1} {m}" for a, b, m in self.edges]
        lines += ["Triangles", str(len(self.triangles))]
        lines += [f"{a + 1} {b + 1} {c + 1} {r}" for (a, b, c), r in zip(self.triangles, self.regions)]
        return "\n".join([*lines, "End", ""])

    def medit_binary(self):
        def block(keyword, content, at):
            return struct.pack("<ii", keyword, at + 8 + len(content)) + content
        data = struct.pack("<ii", 1, 2) + struct.pack("<iii", 3, 20, 2)
        vertices = b"".join(struct.pack("<ddi", x, y, 0) for x, y in self.points)
        data += block(4, struct.pack("<i", len(self.points)) + vertices, len(data))
        if self.edges:
            rows = b"".join(struct.pack("<iii", a + 1, b + 1, m) for a, b, m in self.edges)
            data += block(5, struct.pack("<i", len(self.edges)) + rows, len(data))
        rows = b"".join(struct.pack("<iiii", a + 1, b + 1, c + 1, r)
                        for (a, b, c), r in zip(self.triangles, self.regions))
        data += block(6, struct.pack("<i", len(self.triangles)) + rows, len(data))
        return data + struct.pack("<ii", 54, 0)

    def gmsh(self):
        lines = ["$MeshFormat", "2.2 0 8", "$EndMeshFormat", "$Nodes", str(len(self.points))]
        lines += [f"{k + 1} {x!r} {y!r} 0" for k, (x, y) in enumerate(self.points)]
        lines += ["$EndNodes", "$Elements", str(len(self.edges) + len(self.triangles))]
        rows = [f"1 2 {m} 1 {a + 1} {b + 1}" for a, b, m in self.edges]
        rows += [f"2 2 {r} 1 {a + 1} {b + 1} {c + 1}"
                 for (a, b, c), r in zip(self.triangles, self.regions)]
        return "\n".join([*lines, *(f"{k + 1} {row}" for k, row in enumerate(rows)),
                          "$EndElements", ""])

    def vtu(self, name="region"):
        cells = [(a, b) for a, b, _ in self.edges] + list(self.triangles)
        values = [m for _, _, m in self.edges] + list(self.regions)
        ends = list(itertools.accumulate(map(len, cells)))

        def array(kind, of, numbers, more=""):
            return (f'<DataArray type="{kind}" Name="{of}"{more} format="ascii">'
                    f'{" ".join(map(repr, numbers))}</DataArray>')
        at = [z for x, y in self.points for z in (x, y, 0.0)]
        parts = ['<VTKFile type="UnstructuredGrid" version="0.1"><UnstructuredGrid>',
                 f'<Piece NumberOfPoints="{len(self.points)}" NumberOfCells="{len(cells)}">',
                 "<Points>", array("Float64", "Points", at, ' NumberOfComponents="3"'), "</Points>",
                 "<Cells>", array("Int64", "connectivity", [v for c in cells for v in c]),
                 array("Int64", "offsets", ends),
                 array("UInt8", "types", [3 if len(c) == 2 else 5 for c in cells]), "</Cells>",
                 "<CellData>", array("Int32", name, values), "</CellData>",
                 "</Piece></UnstructuredGrid></VTKFile>", ""]
        return "\n".join(parts)

    def text(self, form):
        return {"mesh": self.medit, "meshb": self.medit_binary, "msh": self.gmsh, "vtu": self.vtu}[form]()


def read_medit(text):
    """Reads the mesh of a .mesh file as the command writes it."""
    lines = text.splitlines()

    def rows(keyword):
        at, count = command.section(lines, keyword)
        return [lines[k].split() for k in range(at, at + count)]
    triangles = [tuple(map(int, row)) for row in rows("Triangles")]
    return Plane([(float(x), float(y)) for x, y, _ in rows("Vertices")],
                 [(a - 1, b - 1, c - 1) for a, b, c, _ in triangles], [r for *_, r in triangles],
                 [(int(a) - 1, int(b) - 1, int(m)) for a, b, m in rows("Edges")])


def grid(n, region_of, place=lambda x, y: (x, y)):
    """Returns n x n cells of side 1, each cut in two, the lower right half first."""
    points = [place(float(i), float(j)) for j in range(n + 1) for i in range(n + 1)]
    triangles, regions = [], []
    for j in range(n):
        for i in range(n):
            a = j * (n + 1) + i
            triangles += [(a, a + 1, a + n + 2), (a, a + n + 2, a + n + 1)]
            regions += [region_of(i, j, 0), region_of(i, j, 1)]
    return Plane(points, triangles, regions)


def random_plane(chance):
    """Rectangles, single cells and single triangles of other regions on a grid, sheared or not."""
    n = chance.randint(3, 7)
    numbers = chance.sample([1, 2, 3, 5, 0, -4, 17, 100000, 2147483647, -2147483648], 4)
    of = {(i, j, h): numbers[0] for i in range(n) for j in range(n) for h in (0, 1)}
    for number in numbers[1:]:
        i, j = chance.randrange(n), chance.randrange(n)
        width, height = chance.randint(1, n - 1), chance.randint(1, n - 1)
        for cell in list(of):
            if i <= cell[0] < i + width and j <= cell[1] < j + height:
                of[cell] = number
    of[chance.randrange(n), chance.randrange(n), chance.randrange(2)] = chance.choice(numbers)
    shear, scale = chance.choice([0.0, 0.25, 1 / 3, -0.7]), chance.choice([1.0, 0.1, 1e-3, 37.0])
    plane = grid(n, lambda i, j, h: of[i, j, h],
                 lambda x, y: (scale * (x + shear * y), scale * y))
    for ends, at in plane.sides().items():
        divides = len(at) == 2 and plane.regions[at[0]] != plane.regions[at[1]]
        if chance.random() < 0.3 and (divides or len(at) == 1):
            plane.edges.append((*ends, chance.choice([3, 8, 21])))
    return plane


def junctions(plane):
    """Returns the vertices where three regions meet, or two regions and the outside."""
    of = collections.defaultdict(set)
    for ends, at in plane.sides().items():
        kinds = [plane.regions[k] for k in at] + [None] * (2 - len(at))
        if kinds[0] != kinds[1]:
            for v in ends:
                of[v] |= set(kinds)
    return {plane.points[v] for v, kinds in of.items() if len(kinds) > 2}


def lengths_of_markers(plane):
    """Returns the length of each marker's edges. Edges without a marker are left out."""
    lengths = collections.defaultdict(float)
    for a, b, marker in plane.edges:
        (x, y), (u, v) = plane.points[a], plane.points[b]
        if marker != 0:
            lengths[marker] += ((x - u) ** 2 + (y - v) ** 2) ** 0.5
    return lengths


class RegionTest(command.CommandTest):
    def write_plane(self, plane, form, stem="old"):
        self.write(f"{stem}.sol", "\n".join(
            ["MeshVersionFormatted 2", "Dimension 2", "SolAtVertices", str(len(plane.points)), "1 1",
             *(repr(x * x + 3 * x * y) for x, y in plane.points), "End", ""]))
        self.write(f"u.{stem}.sol", (self.folder / f"{stem}.sol").read_bytes())
        (self.folder / f"{stem}.sol").unlink()
        return self.write(f"{stem}.{form}", plane.text(form))

    def run_json(self, *arguments):
        done = self.run_command(*arguments, "--json")
        self.assertEqual(done.returncode, 0, done.stderr)
        return json.loads(done.stdout), done

    def assert_kept(self, before, after, told):
        wanted, found = before.areas(), after.areas()
        whole = float(sum(wanted.values()))
        self.assertEqual(set(wanted), set(found))
        for region, area in wanted.items():
            self.assertAlmostEqual(float(found[region]) / whole, float(area) / whole, delta=1e-14)
        if set(wanted) == {1}:
            return self.assertNotIn("regions", told)
        rows = {row["region"]: row for row in told["regions"]}
        self.assertEqual(set(rows), set(wanted))
        for region, row in rows.items():
            # Python rounds a sum of fractions once, and so does the program.
            self.assertEqual(row["area_before"], float(wanted[region]))
            self.assertEqual(row["area_after"], float(found[region]))

    def assert_marked(self, before, after):
        wanted, found = lengths_of_markers(before), lengths_of_markers(after)
        self.assertEqual(set(wanted), set(found))
        for marker, length in wanted.items():
            self.assertAlmostEqual(found[marker] / length, 1, delta=1e-12)


class PropertyTest(RegionTest):
    def test_regions_through_adapt_and_mesh_in_four_formats(self):
        for case in range(CASES):
            chance = random.Random(case)
            plane = random_plane(chance)
            form = FORMATS[case % 4]
            with self.subTest(case=case, form=form):
                self.write_plane(plane, form)
                told, _ = self.run_json("adapt", f"old.{form}", "--solution", "u.old.sol",
                                        "--vertices", 3 * len(plane.points), "-o", "new.mesh", "-o",
                                        f"other.{form}")
                made = read_medit((self.folder / "new.mesh").read_text())
                self.assert_kept(plane, made, told)
                self.assert_marked(plane, made)
                self.assertLessEqual(junctions(plane), set(made.points))
                done = self.run_command("verify", "new.mesh")
                self.assertEqual(done.returncode, 0, done.stdout)
                # The same mesh in the other format gives the same regions and markers.
                told, _ = self.run_json("mesh", f"other.{form}", "-o", "again.mesh")
                again = read_medit((self.folder / "again.mesh").read_text())
                self.assert_kept(made, again, told)
                self.assert_marked(made, again)


class KindsTest(RegionTest):
    """Keeps regions of a single triangle or of few, none of whose edges the file lists."""

    def kept(self, plane, form="mesh", note=True):
        self.write_plane(plane, form)
        for arguments in (["mesh", f"old.{form}"],
                          ["adapt", f"old.{form}", "--solution", "u.old.sol", "--vertices", 200]):
            told, done = self.run_json(*arguments, "-o", "new.mesh")
            made = read_medit((self.folder / "new.mesh").read_text())
            self.assert_kept(plane, made, told)
            self.assertLessEqual(junctions(plane), set(made.points))
            if note:
                self.assertIn("edges between triangles of different regions that are not listed are segments",
                              done.stderr)
            self.assertEqual(self.run_command("verify", "new.mesh").returncode, 0)

    def test_single_triangle(self):
        self.kept(grid(4, lambda i, j, h: 9 if (i, j, h) == (2, 1, 0) else 1))

    def test_ring_without_a_corner_that_another_line_meets(self):
        self.kept(grid(5, lambda i, j, h: 2 if 1 <= i <= 3 and 1 <= j <= 3 else 1))

    def test_region_in_a_region_in_a_region(self):
        self.kept(grid(7, lambda i, j, h: max(abs(i - 3), abs(j - 3))))

    def test_interface_from_side_to_side(self):
        self.kept(grid(4, lambda i, j, h: -1 if i < 2 else 0))

    def test_interface_through_corners(self):
        self.kept(grid(4, lambda i, j, h: 5 if i > j or (i == j and h == 0) else 6))

    def test_four_regions_at_a_vertex(self):
        self.kept(grid(4, lambda i, j, h: 1 + (i < 2) + 2 * (j < 2)))

    def test_region_that_touches_itself_at_a_vertex(self):
        self.kept(grid(4, lambda i, j, h: 3 if (i < 2) == (j < 2) else 1))

    def test_one_region_of_two_parts(self):
        self.kept(grid(5, lambda i, j, h: 4 if i in (0, 4) else 1))

    def test_all_triangles_of_one_other_region(self):
        self.kept(grid(3, lambda i, j, h: 12), note=False)

    def test_every_triangle_its_own_region(self):
        self.kept(grid(4, lambda i, j, h: 8 * i + 2 * j + h + 1))

    def test_curved_interface_keeps_its_vertices(self):
        def bent(x, y):
            return x + 0.06 * (y - 4) ** 2 * x * (8 - x) / 16, y
        plane = grid(8, lambda i, j, h: 1 if i < 4 else 2, bent)
        self.kept(plane)
        made = read_medit((self.folder / "new.mesh").read_text())
        self.assertLessEqual({plane.points[9 * j + 4] for j in range(9)}, set(made.points))

    def test_curved_sides_and_areas_are_both_told(self):
        # Two regions with sides that curve outwards and a straight line between them.
        n = 12
        plane = grid(n, lambda i, j, h: 3 if i < n // 2 else 8,
                     lambda x, y: (x + 0.05 * y * (n - y) * (2 * x / n - 1), y))
        self.write_plane(plane, "mesh")
        allowed = 0.3
        job = ["adapt", "old.mesh", "--solution", "u.old.sol", "--vertices", 80]
        self.run_json(*job, "--hausd", allowed, "-o", "new.mesh")
        path = self.folder / "new.certificate.json"
        made = json.loads(path.read_text())
        proved = made["audit"]["former_boundary"]["largest_distance"]
        self.assertLessEqual(proved, allowed)
        self.assertGreater(proved, 0)
        before = plane.areas()
        after = read_medit((self.folder / "new.mesh").read_text()).areas()
        for row in made["audit"]["regions"]:
            self.assertEqual(row["area_before"], float(before[row["region"]]))
            self.assertEqual(row["area"], float(after[row["region"]]))
            self.assertLess(abs(row["area"] - row["area_before"]), 2 * n * proved)
        done = self.run_command("verify", "new.mesh")
        self.assertEqual(done.returncode, 0, done.stdout)
        self.assertIn("of the boundary before, both ways", done.stdout)
        self.assertIn("areas of regions", done.stdout)
        for part, name in (("regions", "area_before"), ("former_boundary", "largest_distance")):
            forged = json.loads(json.dumps(made))
            told = forged["audit"][part]
            (told[0] if part == "regions" else told)[name] *= 0.99
            path.write_text(json.dumps(forged))
            self.assertEqual(self.run_command("verify", "new.mesh").returncode, 1, name)

    def test_listed_markers_stay_and_others_are_zero(self):
        plane = grid(4, lambda i, j, h: 1 if i < 2 else 2)
        plane.edges = [(2, 7, 13), (7, 12, 14)]
        self.kept(plane)
        made = read_medit((self.folder / "new.mesh").read_text())
        self.assert_marked(plane, made)

    def test_markers_stay_where_every_inner_edge_is_listed(self):
        plane = grid(4, lambda i, j, h: 1 if i < 2 else 2)
        plane.edges = [(*ends, 6 if all(v % 5 == 2 for v in ends) else 1) for ends in plane.sides()]
        self.write_plane(plane, "mesh")
        self.run_json("mesh", "old.mesh", "-o", "new.mesh")
        made = read_medit((self.folder / "new.mesh").read_text())
        self.assertAlmostEqual(lengths_of_markers(made)[6], 4)
        self.assertAlmostEqual(lengths_of_markers(made)[1], 16)

    def test_repair(self):
        plane = grid(4, lambda i, j, h: 1 if i < 2 else 2, lambda x, y: (x, 0.01 * y))
        self.write("old.mesh", plane.medit())
        done = self.run_command("certify", "old.mesh", "--metric", "identity", "--repair", "-o",
                                "new.mesh")
        self.assertEqual(done.returncode, 0, done.stderr)
        made = read_medit((self.folder / "new.mesh").read_text())
        self.assertEqual(made.areas(), plane.areas())
        self.assertIn("areas of regions in domain and mesh: 1 (0.08, 0.08), 2 (0.08, 0.08)",
                      done.stdout)


class WordTest(RegionTest):
    """What a certificate says about regions is proved by `verify`, and changes of it are found."""

    def setUp(self):
        super().setUp()
        self.plane = grid(4, lambda i, j, h: 1 if i < 2 else 7)
        self.write_plane(self.plane, "mesh")
        self.run_json("adapt", "old.mesh", "--solution", "u.old.sol", "--vertices", 60, "-o", "n.mesh")
        self.path = self.folder / "n.certificate.json"

    def verdict(self):
        return self.run_command("verify", "n.mesh")

    def test_summary_and_verdict(self):
        done = self.run_command("adapt", "old.mesh", "--solution", "u.old.sol", "--vertices", 60, "-o",
                                "n.mesh")
        self.assertIn("areas of regions before and after: 1 (8, 8), 7 (8, 8)\n", done.stdout)
        self.assertIn("areas of regions in domain and mesh: 1 (8, 8), 7 (8, 8)",
                      self.verdict().stdout)
        told = json.loads(self.run_command("verify", "n.mesh", "--json").stdout)
        self.assertEqual([(r["region"], r["area_of_domain"], r["area_after"]) for r in told["regions"]],
                         [(1, 8.0, 8.0), (7, 8.0, 8.0)])

    def test_certificate(self):
        found = json.loads(self.path.read_text())["audit"]["regions"]
        self.assertEqual(found, [
            {"region": number, "area_before": 8.0, "area_of_domain": 8.0, "area": 8.0}
            for number in (1, 7)])

    def test_every_number_is_proved_again(self):
        text = json.loads(self.path.read_text())
        for name in ("region", "area_before", "area_of_domain", "area"):
            for row in (0, 1):
                forged = json.loads(self.path.read_text())
                forged["audit"]["regions"][row][name] += 1
                self.path.write_text(json.dumps(forged))
                done = self.verdict()
                self.assertEqual(done.returncode, 1, (name, done.stdout))
                self.assertIn("region", done.stdout)
                self.path.write_text(json.dumps(text))
        forged = json.loads(self.path.read_text())
        del forged["audit"]["regions"]
        self.path.write_text(json.dumps(forged))
        self.assertEqual(self.verdict().returncode, 1)

    def test_region_that_no_segment_separates_is_found(self):
        self.path.unlink()
        text = (self.folder / "n.mesh").read_text()
        at, count = command.section(text.splitlines(), "Triangles")
        lines = text.splitlines()
        lines[at + count // 2] = " ".join([*lines[at + count // 2].split()[:3], "5"])
        self.write("n.mesh", "\n".join([*lines, ""]))
        for arguments in (["verify", "n.mesh", "--angle-bound", "20"], ["certify", "n.mesh"]):
            done = self.run_command(*arguments)
            self.assertEqual(done.returncode, 1, done.stdout)
            self.assertIn("wrong_region: ", done.stdout)
            self.assertIn("and no segment is between them", done.stdout)

    def test_notes_are_refused_where_nothing_may_be_changed(self):
        before = self.files()
        for arguments in (["mesh", "old.mesh"],
                          ["adapt", "old.mesh", "--solution", "u.old.sol", "--vertices", "60"]):
            done = self.run_command(*arguments, "-o", "other.mesh", "--strict")
            self.assertEqual(done.returncode, 2)
            self.assertIn("--strict: edges between triangles of different regions", done.stderr)
            self.assertEqual(self.files(), before)


class SidesTest(RegionTest):
    """Adds a note for boundary edges that the file's list leaves out."""

    def test_sides_that_are_not_listed_have_marker_0(self):
        plane = grid(2, lambda i, j, h: 1)
        plane.edges = [(0, 1, 7), (1, 2, 7)]
        for form in FORMATS:
            with self.subTest(form=form):
                self.write(f"some.{form}", plane.text(form))
                done = self.run_command("mesh", f"some.{form}", "-o", "new.mesh")
                self.assertEqual(done.returncode, 0, done.stderr)
                self.assertIn("6 of 8 boundary edges are not listed and have marker 0, the first "
                              "from ", done.stderr)
                made = read_medit((self.folder / "new.mesh").read_text())
                self.assertEqual(lengths_of_markers(made), {7: 2.0})
                self.assertEqual(made.areas(), {1: 4})


class VtuTest(RegionTest):
    def refused(self, text, sentence):
        self.write("old.vtu", text)
        done = self.run_command("mesh", "old.vtu", "-o", "new.mesh")
        self.assertEqual(done.returncode, 2)
        self.assertIn(sentence, done.stderr)

    def test_names_of_regions(self):
        plane = grid(3, lambda i, j, h: 2 if i == 1 else 1)
        for name, noted in (("gmsh:physical", False), ("medit:ref", False), ("stuff", True)):
            self.write("old.vtu", plane.vtu(name))
            told, done = self.run_json("mesh", "old.vtu", "-o", "new.mesh")
            self.assert_kept(plane, read_medit((self.folder / "new.mesh").read_text()), told)
            self.assertEqual("the cell data 'stuff' are taken for the regions" in done.stderr, noted)

    def test_two_arrays_that_may_be_regions(self):
        text = grid(2, lambda i, j, h: 1).vtu("a")
        second = '<DataArray type="Int32" Name="b">' + "1 " * 8 + "</DataArray></CellData>"
        self.refused(text.replace("</CellData>", second), "and none is named region")

    def test_what_is_no_plane_mesh(self):
        text = grid(1, lambda i, j, h: 1).vtu()
        self.refused(text.replace("5 5</DataArray>", "5 9</DataArray>"), "cell 2 is of type 9")
        self.refused(text.replace("0.0 0.0 0.0", "0.0 0.0 0.5"), "z of a vertex: vertex 1 has 0.5")
        self.refused(text.replace("3 6</DataArray>", "6 3</DataArray>"), "do not ascend")
        self.refused(text.replace(">0 1 3", ">0 1 4"), "point 4, from 0, does not exist")
        self.refused(text.replace("1 1</DataArray>", "1 1.5</DataArray>"), "number 2 is 1.5")
        self.refused(text.replace('"connectivity"', '"x"'), "no array 'connectivity'")


if __name__ == "__main__":
    unittest.main()
