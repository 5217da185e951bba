# SPDX-License-Identifier: MIT
"""Meshes through `asterism convert`: what survives from every format that is read to every one that is
written, on one mesh with two regions, four markers, names and two fields; standard input and output; and
which metric and which fields are whose."""
import math
import os
import re
import unittest

import command

# Two squares, regions 3 and 5, split by the segment of marker 4; a scalar and a vector.
POINTS = [(0, 0), (1, 0), (2, 0), (2, 1.25), (1, 1.125), (0, 1), (0.5, 0.5), (1.5, 0.4375)]
TRIANGLES = [((0, 1, 6), 3), ((1, 4, 6), 3), ((4, 5, 6), 3), ((5, 0, 6), 3), ((1, 2, 7), 5), ((2, 3, 7), 5),
             ((3, 4, 7), 5), ((4, 1, 7), 5)]
EDGES = [((0, 1), 1), ((1, 2), 1), ((2, 3), 2), ((3, 4), 7), ((4, 5), 7), ((5, 0), 2), ((1, 4), 4)]
NAMES = {1: {1: "floor", 2: "sides", 4: "between", 7: "lid"}, 2: {3: "steel", 5: "air"}}
HEAT = [math.sin(3 * x + y) for x, y in POINTS]
WIND = [(x * y, -x) for x, y in POINTS]

READ = ["mesh", "meshb", "msh", "msh2", "vtu", "su2", "14", "grd", "2dm"]
WRITTEN = [*READ, "node"]


def gmsh():
    lines = ["$MeshFormat", "2.2 0 8", "$EndMeshFormat", "$PhysicalNames", "6"]
    lines += [f'{d} {n} "{name}"' for d, names in NAMES.items() for n, name in names.items()]
    lines += ["$EndPhysicalNames", "$Nodes", str(len(POINTS))]
    lines += [f"{i} {x!r} {y!r} 0" for i, (x, y) in enumerate(POINTS, 1)]
    elements = [f"1 2 {m} {m} {a + 1} {b + 1}" for (a, b), m in EDGES]
    elements += [f"2 2 {r} {r} " + " ".join(str(v + 1) for v in t) for t, r in TRIANGLES]
    lines += ["$EndNodes", "$Elements", str(len(elements))]
    lines += [f"{i} {e}" for i, e in enumerate(elements, 1)]
    lines.append("$EndElements")
    for name, width, rows in (("heat", 1, [(h,) for h in HEAT]), ("the wind", 3, [(*w, 0) for w in WIND])):
        lines += ["$NodeData", "1", f'"{name}"', "1", "0.5", "3", "0", str(width), str(len(rows))]
        lines += [f"{i} " + " ".join(map(repr, row)) for i, row in enumerate(rows, 1)]
        lines.append("$EndNodeData")
    return "\n".join(lines) + "\n"


class Convert(command.CommandTest):
    def setUp(self):
        super().setUp()
        self.write("first.msh", gmsh())

    def convert(self, *arguments, **more):
        done = self.run_command("convert", *arguments, **more)
        self.assertEqual(done.returncode, 0, done.stderr)
        return done.stderr

    def facts(self, name):
        """Returns the contents of a file, converted to .msh, as sets that do not depend on any order."""
        if name != "first.msh":
            self.convert(name, "facts.msh2", "--quiet")
        text = (self.folder / ("facts.msh2" if name != "first.msh" else name)).read_text()
        section = {head: body.split("\n") for head, body in
                   re.findall(r"\$(PhysicalNames|Nodes|Elements)\n\d+\n(.*?)\n\$End", text, re.S)}
        nodes = {w[0]: tuple(map(float, w[1:3])) for w in map(str.split, section["Nodes"])}
        names = {(w[0], w[1]): w[2].strip('"') for w in (line.split(" ", 2) for line in section["PhysicalNames"])}
        elements = [line.split() for line in section["Elements"]]
        of = {d: sorted((sorted(nodes[v] for v in e[5:]), int(e[3])) for e in elements if e[1] == d) for d in "12"}
        fields = {}
        for name_of, body in re.findall(r'\$NodeData\n1\n"(.*?)"\n.*?\n3\n0\n(.*?)\$EndNodeData', text, re.S):
            rows = [row.split() for row in body.strip().split("\n")][2:]
            fields[name_of] = {nodes[row[0]]: tuple(map(float, row[1:])) for row in rows}
        return {"points": sorted(nodes.values()), "triangles": [t for t, _ in of["2"]], "regions": of["2"],
                "sides": [s for s, _ in of["1"]], "markers": of["1"],
                "names": {n for n in names.values() if not re.match("marker |region |given", n)}, "fields": fields}

    def test_what_survives_through_every_pair(self):
        """Compares the table of docs/manual/files.md with what conversions keep."""
        first = self.facts("first.msh")
        self.assertEqual(first["fields"]["heat"], {p: (h,) for p, h in zip(POINTS, HEAT)})
        outer = [m for m in first["markers"] if m[1] != 4]
        parts = {"14": 6, "grd": 6}  # ADCIRC's strings are numbered in their order
        rows = {}
        for read in READ:
            self.convert("first.msh", f"from.{read}", "--quiet")
            for written in WRITTEN:
                with self.subTest(f"{read} to {written}"):
                    self.convert(f"from.{read}", f"to_{read}.{written}", "--quiet")
                    if written == "node":
                        self.assertEqual((self.folder / f"to_{read}.node").read_text().split()[0], str(len(POINTS)))
                        self.assertEqual((self.folder / f"to_{read}.ele").read_text().split()[0], str(len(TRIANGLES)))
                        continue
                    found = self.facts(f"to_{read}.{written}")
                    both = {read, written}
                    kept = {"points": found["points"] == first["points"],
                            "triangles": found["triangles"] == first["triangles"],
                            "regions": found["regions"] == first["regions"],
                            "inner": found["markers"] == first["markers"],
                            "markers": [m for m in found["markers"] if m in first["markers"]] in
                            (first["markers"], outer),
                            "names": NAMES[1][7] in found["names"],
                            "fields": sorted(map(sorted, (f.values() for f in found["fields"].values()))) ==
                            sorted(map(sorted, (f.values() for f in first["fields"].values())))}
                    flow, coast = both & {"su2", "14", "grd"}, both & {"14", "grd"}
                    self.assertTrue(kept["points"] and kept["triangles"])
                    self.assertEqual(kept["regions"], not flow, found["regions"])
                    self.assertEqual(kept["inner"], not flow, found["markers"])
                    self.assertEqual(kept["fields"], not both & {"su2", "14", "grd", "2dm"}, found["fields"])
                    self.assertEqual(kept["names"], not both - {"msh", "msh2", "su2"} , found["names"])
                    if not flow:
                        self.assertTrue(kept["markers"])
                    self.assertEqual(len(found["sides"]), 6 if flow else 7)
                    if coast:
                        self.assertLessEqual({m for _, m in found["markers"]}, set(range(1, parts["14"] + 1)))
                    rows[read, written] = kept
        self.assertEqual(len(rows), len(READ) ** 2)

    def test_losses_are_told_and_strict_refuses_them(self):
        said = self.convert("first.msh", "a.su2")
        for lost in ("regions have no place", "segments inside have no place", "names of regions", "fields"):
            self.assertIn(lost, said)
        self.assertNotIn("names of markers", said)
        self.assertEqual(self.convert("first.msh", "a.vtu").count("note"), 2)
        self.convert("first.msh", "plain.2dm", "--quiet")
        self.write("stale.sol", "of another mesh")
        self.assertIn("stale.sol: is there already", self.convert("plain.2dm", "stale.mesh"))
        done = self.run_command("convert", "first.msh", "b.su2", "--strict")
        self.assertEqual(done.returncode, 2)
        self.assertFalse((self.folder / "b.su2").exists())

    def test_standard_input_and_output(self):
        text = gmsh()
        self.convert("first.msh", "a.vtu", "--quiet")
        passed = self.run_command("convert", "-", "-", "--format", "msh", "--format", "2dm", "--quiet", text=text)
        self.assertEqual(passed.returncode, 0, passed.stderr)
        self.convert("first.msh", "a.2dm", "--quiet")
        self.assertEqual(passed.stdout, (self.folder / "a.2dm").read_text())
        self.convert("-", "b.vtu", "--format", ".msh", "--quiet", text=text)
        self.assertEqual((self.folder / "a.vtu").read_bytes(), (self.folder / "b.vtu").read_bytes())
        wrong = self.run_command("convert", "-", "c.vtu", "--format", "msh", text="$Mesh")
        self.assertEqual(wrong.returncode, 2)
        self.assertRegex(wrong.stderr, r"^asterism: standard-input\.msh:1: ")
        for arguments, words in [(["-", "c.vtu"], "one is wanted for each '-'"),
                                 (["first.msh", "c.vtu", "--format", "msh"], "neither IN nor OUT is '-'"),
                                 (["-", "c.vtu", "--format", "xyz"], "unknown kind of file '.xyz'")]:
            done = self.run_command("convert", *arguments, text=text)
            self.assertEqual(done.returncode, 2)
            self.assertIn(words, done.stderr)

    def test_node_data_belong_to_the_nodes_in_every_version_of_gmsh(self):
        """Coordinates are whole numbers, so that one could be mistaken for a tag. Tags are in no order."""
        nodes = ((7, 0, 0), (3, 2, 0), (9, 2, 2), (5, 0, 2))
        placed = "".join(f"{tag} {x} {y} 0\n" for tag, x, y in nodes)
        apart = "".join(f"{tag}\n" for tag, _, _ in nodes) + "".join(f"{x} {y} 0\n" for _, x, y in nodes)
        listed = "1 2 {} 7 3 9\n2 2 {} 7 9 5\n"
        data = '$NodeData\n1\n"u"\n1\n0\n3\n0\n1\n4\n' + "".join(f"{t} {10 * t}\n" for t, _, _ in nodes) + "$EndNodeData\n"
        files = {
            "1": f"$NOD\n4\n{placed}$ENDNOD\n$ELM\n2\n" + listed.format("4 1 3", "4 1 3") + "$ENDELM\n",
            "2.2": f"$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\n4\n{placed}$EndNodes\n$Elements\n2\n"
                   + listed.format("2 4 1", "2 4 1") + "$EndElements\n",
            "4.0": f"$MeshFormat\n4 0 8\n$EndMeshFormat\n$Nodes\n1 4\n1 2 0 4\n{placed}$EndNodes\n"
                   "$Elements\n1 2\n1 2 2 2\n1 7 3 9\n2 7 9 5\n$EndElements\n",
            "4.1": f"$MeshFormat\n4.1 0 8\n$EndMeshFormat\n$Nodes\n1 4 3 9\n2 1 0 4\n{apart}$EndNodes\n"
                   "$Elements\n1 2 1 2\n2 1 2 2\n1 7 3 9\n2 7 9 5\n$EndElements\n"}
        for version, text in files.items():
            with self.subTest(version):
                self.write("v.msh", text + data)
                self.convert("v.msh", "v.mesh", "--quiet")
                lines = (self.folder / "v.mesh").read_text().splitlines()
                start, count = command.section(lines, "Vertices")
                at = [tuple(map(float, line.split()[:2])) for line in lines[start:start + count]]
                lines = (self.folder / "v.sol").read_text().splitlines()
                start, count = command.section(lines, "SolAtVertices")
                found = dict(zip(at, (float(line) for line in lines if re.fullmatch(r"[0-9.]+0", line))))
                self.assertEqual(found, {(x, y): 10 * tag for tag, x, y in nodes})

    def test_unknown_endings_and_links(self):
        self.write("first.xyz", gmsh())
        for arguments in (["first.xyz", "a.msh"], ["first.msh", "a.xyz"], ["first", "a.msh"]):
            done = self.run_command("convert", *arguments)
            self.assertEqual(done.returncode, 2)
            self.assertIn("unknown kind of file", done.stderr)
        (self.folder / "there").mkdir()
        os.symlink("there/real.msh", self.folder / "link.msh")
        self.convert("first.msh", "link.msh", "--quiet")
        self.assertTrue((self.folder / "link.msh").is_symlink())
        self.assertEqual(self.facts("link.msh"), self.facts("there/real.msh"))
        self.convert("first.msh", "link.msh", "--quiet")
        self.assertTrue((self.folder / "link.msh").is_symlink())
        done = self.run_command("mesh", "square", "-o", "link2.mesh")
        self.assertEqual(done.returncode, 0)

    def test_the_metric_of_a_vtu_is_no_field(self):
        self.assertEqual(self.run_command("mesh", "square", "--metric", "swirl:3", "--size", "0.5", "-o", "a.vtu").returncode, 0)
        done = self.run_command("convert", "a.vtu", "b.vtu")
        self.assertEqual((done.returncode, done.stderr), (0, ""))
        again = (self.folder / "b.vtu").read_bytes()
        self.assertEqual([again.count(b'Name="%s"' % name) for name in (b"metric", b"metric_tensor")], [1, 1])
        done = self.run_command("draw", "a.vtu", "-o", "a.svg", "--colour-by", "none such")
        self.assertNotIn("metric_tensor", done.stderr)
        self.run_command("draw", "a.vtu", "-o", "a.html")
        self.assertNotIn("metric_tensor", (self.folder / "a.html").read_text())

    def test_a_size_map_is_a_metric_where_one_is_wanted(self):
        """One number at each vertex beside a mesh is a size where a metric is read, a solution where one is read, and
        ignored elsewhere."""
        self.run_command("mesh", "square", "--size", "0.5", "-o", "plain.mesh")
        (self.folder / "plain.certificate.json").unlink()
        vertices = int((self.folder / "plain.mesh").read_text().split("Vertices\n")[1].split()[0])
        sizes = [0.1 + 0.01 * (i % 3) for i in range(vertices)]
        self.write("plain.sol", f"MeshVersionFormatted 2\nDimension 2\nSolAtVertices\n{vertices}\n1 1\n"
                   + "\n".join(map(str, sizes)) + "\nEnd\n")
        self.write("map.sol", (self.folder / "plain.sol").read_text())
        self.assertEqual(self.run_command("info", "plain.mesh").returncode, 0)
        self.assertEqual(self.run_command("draw", "plain.mesh", "-o", "p.svg").returncode, 0)
        self.assertEqual(self.run_command("mesh", "plain.mesh", "-o", "q.mesh").returncode, 0)
        certified = self.run_command("certify", "plain.mesh")
        self.assertEqual(certified.returncode, 0, certified.stderr)
        self.assertIn("metric: identity", certified.stdout)
        for arguments in (["plain.mesh", "--metric", "plain.mesh"], ["plain.mesh", "--metric", "map.sol"],
                          ["square", "--metric", "plain.sol"]):
            done = self.run_command("mesh", *arguments, "--size", "1", "-o", "fine.mesh")
            self.assertEqual(done.returncode, 0, done.stderr)
            count = int((self.folder / "fine.mesh").read_text().split("Vertices\n")[1].split()[0])
            self.assertGreater(count, 300)
            judged = self.run_command("verify", "fine.mesh")
            self.assertEqual(judged.returncode, 0, judged.stdout)
            self.assertIn("compared at every vertex", judged.stdout)
        for metric in ("map.sol", "fine.mesh", "plain.mesh"):
            done = self.run_command("adapt", "plain.mesh", "--metric", metric, "-o", "next.mesh")
            self.assertEqual(done.returncode, 0, done.stderr)
        done = self.run_command("adapt", "plain.mesh", "--solution", "plain.sol", "--vertices", "200", "-o", "n.mesh")
        self.assertEqual(done.returncode, 0, done.stderr)
        alone = self.run_command("mesh", "square", "--metric", "map.sol", "--size", "1", "-o", "x.mesh")
        self.assertEqual(alone.returncode, 2)
        self.assertIn("no file .mesh, .meshb, .msh or .vtu of this name", alone.stderr)
        self.write("map.sol", (self.folder / "plain.sol").read_text().replace("\n0.11\n", "\n-0.11\n", 1))
        wrong = self.run_command("mesh", "plain.mesh", "--metric", "map.sol", "--size", "1", "-o", "x.mesh")
        self.assertEqual(wrong.returncode, 2)
        self.assertIn("vertex 2: a size is a positive length", wrong.stderr)

    def test_adapt_takes_meshes_with_their_fields(self):
        self.run_command("mesh", "square", "--size", "0.1", "-o", "plain.mesh")
        text = (self.folder / "plain.mesh").read_text().split("Vertices\n")[1].split("\n")
        points = [tuple(map(float, line.split()[:2])) for line in text[1:1 + int(text[0])]]
        self.write("plain.fields.sol", f"MeshVersionFormatted 2\nDimension 2\nSolAtVertices\n{len(points)}\n1 1\n"
                   + "\n".join(repr(math.tanh(20 * (x - y))) for x, y in points) + "\nEnd\n")
        for ending in ("msh", "vtu"):
            self.convert("plain.mesh", f"u.{ending}", "--quiet")
            done = self.run_command("adapt", f"u.{ending}", "--vertices", "300", "-o", "new.mesh")
            self.assertEqual(done.returncode, 0, done.stderr)
            near = [1 for line in (self.folder / "new.mesh").read_text().split("Vertices\n")[1].split("\n")[1:300]
                    if abs(float(line.split()[0]) - float(line.split()[1])) < 0.1]
            self.assertGreater(len(near), 100)
            by_metric = self.run_command("adapt", f"u.{ending}", "--metric", f"u.{ending}", "-o", "new.mesh")
            self.assertEqual(by_metric.returncode, 0, by_metric.stderr)


if __name__ == "__main__":
    unittest.main()
