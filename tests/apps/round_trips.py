# SPDX-License-Identifier: MIT
"""Regions and markers, names and positions, through programs that are not ours: gmsh, meshio and VTK read
what is written, and what they write is read. Skipped where gmsh or VTK are missing."""
import json
import shutil
import subprocess
import sys
import unittest

from command import CommandTest

try:
    import meshio
    import numpy
    from vtkmodules.util.numpy_support import vtk_to_numpy
    from vtkmodules.vtkIOXML import vtkXMLUnstructuredGridReader, vtkXMLUnstructuredGridWriter
except ImportError as missing:
    print(f"skipped: {missing}; the test needs python3-meshio and python3-vtk9")
    sys.exit(77)
if not shutil.which("gmsh"):
    print("skipped: the test needs gmsh (scripts/setup.sh, large_packages)")
    sys.exit(77)

# Two regions, 3 and 5, with a segment between them; sides 11 to 16.
DOMAIN = """6 2 0 0
1 0 0
2 2 0
3 2 1
4 0 1
5 1 0
6 1 1
7 1
1 1 5 11
2 5 2 12
3 2 3 13
4 3 6 14
5 6 4 15
6 4 1 16
7 5 6 7
0
2
1 0.5 0.5 3
2 1.5 0.5 5
"""
FORMULA = ("--metric", "swirl:4", "--size", "0.3")


class RoundTrips(CommandTest):
    def setUp(self):
        super().setUp()
        self.write("two.poly", DOMAIN)
        done = self.run_command("mesh", "two.poly", *FORMULA, *"-o t.mesh -o t.msh -o t.msh2 -o t.vtu -o t.su2".split())
        self.assertEqual(done.returncode, 0, done.stderr)
        self.expected = self.content("t.mesh")

    def content(self, name, digits=10):
        """Returns triangles by the places of their corners, with regions; edges likewise, with markers."""
        lines = iter((self.folder / name).read_text().split("\n"))
        sections = {}
        for line in lines:
            if line in ("Vertices", "Triangles", "Edges"):
                sections[line] = [next(lines).split() for _ in range(int(next(lines)))]
        place = [tuple(round(float(x), digits) + 0.0 for x in v[:2]) for v in sections["Vertices"]]
        return {kind: sorted((sorted(place[int(v) - 1] for v in row[:-1]), int(row[-1])) for row in sections[kind])
                for kind in ("Triangles", "Edges")}

    def gmsh(self, source, form, target):
        subprocess.run(["gmsh", source, "-setnumber", "Mesh.SaveElementTagType", "2", "-save", "-format", form, "-o", target], cwd=self.folder, check=True,
                       capture_output=True, timeout=120)

    def check_certified(self, name, digits=10):
        """The mesh of the file is certified in the same metric, and has all vertices, triangles, regions, edges and
        markers of t.mesh."""
        done = self.run_command("certify", name, *FORMULA, "-o", "again.mesh")
        self.assertEqual(done.returncode, 0, done.stdout + done.stderr)
        self.assertEqual(self.content("again.mesh", digits), self.content("t.mesh", digits))

    def test_our_own(self):
        for name in ("t.mesh", "t.msh", "t.msh2"):
            self.check_certified(name)
        self.assertEqual(self.run_command("certify", "t.msh").returncode, 0)  # in its own metric

    def test_gmsh_4(self):
        self.gmsh("t.msh", "msh41", "g.msh")
        self.check_certified("g.msh")
        self.assertIn('1 13 "marker 13"', (self.folder / "g.msh").read_text())

    def test_gmsh_2(self):
        self.gmsh("t.msh2", "msh2", "g.msh")
        self.check_certified("g.msh")

    def test_gmsh_and_medit(self):
        self.gmsh("t.msh", "mesh", "g.mesh")
        self.check_certified("g.mesh")

    def test_names_of_a_gmsh_domain(self):
        text = (self.folder / "t.msh").read_text().replace('"marker 13"', '"outlet to sea"').replace('"region 3"', '"steel"')
        self.write("named.msh", text)
        self.gmsh("named.msh", "msh41", "g.msh")
        done = self.run_command("mesh", "g.msh", "--size", "0.15", "-o", "n.msh", "-o", "n.su2")
        self.assertEqual(done.returncode, 0, done.stderr)
        for name in ('1 13 "outlet to sea"', '2 3 "steel"', '2 5 "region 5"'):
            self.assertIn(name, (self.folder / "n.msh").read_text())
        self.assertIn("MARKER_TAG= outlet_to_sea\n", (self.folder / "n.su2").read_text())

    def test_a_geometry_meshed_by_gmsh(self):
        self.write("plate.geo", """lc = 0.3; Point(1) = {0,0,0,lc}; Point(2) = {1,0,0,lc}; Point(3) = {1,1,0,lc}; Point(4) = {0,1,0,lc};
Line(1) = {1,2}; Line(2) = {2,3}; Line(3) = {3,4}; Line(4) = {4,1}; Curve Loop(1) = {1,2,3,4}; Plane Surface(1) = {1};
Physical Curve("floor", 7) = {1}; Physical Curve("rest", 8) = {2,3,4}; Physical Surface("air", 2) = {1};
""")
        subprocess.run(["gmsh", "plate.geo", "-2", "-format", "msh41", "-o", "plate.msh"], cwd=self.folder, check=True,
                       capture_output=True, timeout=120)
        done = self.run_command("mesh", "plate.msh", "--size", "0.1", "-o", "fine.msh")
        self.assertEqual(done.returncode, 0, done.stderr)
        read = meshio.read(self.folder / "fine.msh")
        self.assertEqual(read.field_data["floor"].tolist(), [7, 1])
        self.assertEqual(read.field_data["air"].tolist(), [2, 2])
        self.assertEqual(set(read.cell_data_dict["gmsh:physical"]["line"].tolist()), {7, 8})

    def test_sides_of_a_geometry_in_no_physical_group(self):
        """gmsh leaves the edges of unnamed lines out of the file. They are sides of the mesh, with marker 0."""
        self.write("plate.geo", """lc = 0.3; Point(1) = {0,0,0,lc}; Point(2) = {1,0,0,lc}; Point(3) = {1,1,0,lc}; Point(4) = {0,1,0,lc};
Line(1) = {1,2}; Line(2) = {2,3}; Line(3) = {3,4}; Line(4) = {4,1}; Curve Loop(1) = {1,2,3,4}; Plane Surface(1) = {1};
Physical Curve("floor", 7) = {1}; Physical Surface("air", 2) = {1};
""")
        for form in ("msh41", "msh22"):
            subprocess.run(["gmsh", "plate.geo", "-2", "-format", form, "-o", "plate.msh"], cwd=self.folder, check=True,
                           capture_output=True, timeout=120)
            done = self.run_command("mesh", "plate.msh", "--size", "0.1", "-o", "fine.mesh")
            self.assertEqual(done.returncode, 0, done.stderr)
            self.assertEqual({marker for _, marker in self.content("fine.mesh")["Edges"]}, {0, 7})

    def test_meshio(self):
        for name in ("t.msh", "t.msh2"):
            read = meshio.read(self.folder / name, file_format="gmsh")
            physical = read.cell_data_dict["gmsh:physical"]
            found = {kind: sorted((sorted(tuple(round(x, 10) + 0.0 for x in read.points[v][:2]) for v in row), number)
                                  for row, number in zip(read.cells_dict[cells], physical[cells].tolist()))
                     for kind, cells in (("Triangles", "triangle"), ("Edges", "line"))}
            self.assertEqual(found, self.expected)
            self.assertEqual(read.point_data["metric"].shape, (len(read.points), 9))

    def test_binary_medit_and_meshio(self):
        self.run_command("certify", "t.mesh", "-o", "t.meshb")
        self.check_certified("t.meshb")
        read = meshio.read(self.folder / "t.meshb")
        self.assertEqual(len(read.cells_dict["triangle"]), len(self.expected["Triangles"]))
        self.assertEqual(sorted(read.cell_data_dict["medit:ref"]["triangle"].tolist()),
                         sorted(r for _, r in self.expected["Triangles"]))
        meshio.write(self.folder / "m.meshb", read)
        self.check_triangles("m.meshb")

    def test_metric_of_a_binary_or_gmsh_mesh(self):
        self.run_command("certify", "t.mesh", "-o", "b.meshb", "-o", "g.msh")
        made = []
        for name in ("t.mesh", "b.meshb", "g.msh"):
            job = ["mesh", "square", "--metric", name, "--size", "1", "-o", "again.mesh"]
            done = self.run_command(*job)
            self.assertIn(done.returncode, (0, 1), done.stderr)
            verified = self.run_command("verify", "again.mesh")
            self.assertEqual(verified.returncode, done.returncode, verified.stdout + verified.stderr)
            made.append((self.folder / "again.mesh").read_bytes())
            refused = self.run_command(*job[:-1], name)
            self.assertEqual(refused.returncode, 2, "the metric's own file is not written over")
        self.assertEqual(len(set(made)), 1)

    def test_written_as_it_is_without_a_metric_file(self):
        """Certifies, with -o, a mesh whose metric is in its own file or in the file of its name."""
        self.run_command("certify", "t.mesh", "-o", "t.msh", "-o", "t.meshb")
        for name in ("t.msh", "t.meshb"):
            done = self.run_command("certify", name, "-o", "w.mesh")
            self.assertEqual(done.returncode, 0, done.stderr)
            self.assertEqual(self.run_command("verify", "w.mesh").returncode, 0)
            self.assertEqual((self.folder / "w.sol").read_bytes(), (self.folder / "t.sol").read_bytes())
        for output in ("t.meshb", "t.solb.mesh"):
            done = self.run_command("certify", "t.meshb", "-o", output)
            self.assertEqual(done.returncode, 2 if output == "t.meshb" else 0, done.stderr)

    def check_triangles(self, name):
        """Compares triangles and regions alone: a program may drop the rest."""
        done = self.run_command("certify", name, *FORMULA, "-o", "again.msh")
        self.assertEqual(done.returncode, 0, done.stdout + done.stderr)
        read = meshio.read(self.folder / "again.msh", file_format="gmsh")
        self.assertEqual(sorted(read.cell_data_dict["gmsh:physical"]["triangle"].tolist()),
                         sorted(r for _, r in self.expected["Triangles"]))

    def test_point_data_of_vtk_and_meshio(self):
        """`metric` reads a file with raw bytes and a solution, as VTK's own writer makes it."""
        read = meshio.read(self.folder / "t.vtu")
        read.point_data["u"] = numpy.tanh(20 * (read.points[:, 0] - 1))
        meshio.write(self.folder / "u.vtu", meshio.Mesh(read.points, read.cells, point_data={"u": read.point_data["u"]}),
                     compression=None)
        reader, writer = vtkXMLUnstructuredGridReader(), vtkXMLUnstructuredGridWriter()
        reader.SetFileName(str(self.folder / "u.vtu"))
        writer.SetInputConnection(reader.GetOutputPort())
        writer.SetFileName(str(self.folder / "raw.vtu"))
        writer.SetCompressorTypeToNone()
        writer.SetDataModeToAppended()
        writer.EncodeAppendedDataOff()
        writer.Write()
        self.assertIn(b'encoding="raw"', (self.folder / "raw.vtu").read_bytes())
        writer.SetCompressorTypeToZLib()
        for order in ("LittleEndian", "BigEndian"):
            getattr(writer, f"SetByteOrderTo{order}")()
            writer.SetFileName(str(self.folder / f"{order}.vtu"))
            writer.Write()
            self.assertIn(b"vtkZLibDataCompressor", (self.folder / f"{order}.vtu").read_bytes())
        meshio.write(self.folder / "zlib.vtu", meshio.read(self.folder / "u.vtu"), compression="zlib")
        names = ("u", "raw", "LittleEndian", "BigEndian", "zlib")
        for name in names:
            done = self.run_command("metric", "t.mesh", "--solution", f"{name}.vtu", "--vertices", "300", "-o", f"{name}.mesh")
            self.assertEqual(done.returncode, 0, done.stderr)
        self.assertEqual(len({(self.folder / f"{name}.sol").read_text() for name in names}), 1)

    @unittest.skipUnless(shutil.which("FreeFem++-nw"), "FreeFEM is not installed")
    def test_freefem(self):
        self.write("trip.edp", 'mesh Th = readmesh("t.mesh"); savemesh(Th, "f.mesh");\n')
        subprocess.run(["FreeFem++-nw", "-v", "0", "trip.edp"], cwd=self.folder, check=True, capture_output=True, timeout=120)
        self.check_certified("f.mesh", digits=8)  # FreeFEM writes ten digits

    def test_meshio_and_medit(self):
        meshio.write(self.folder / "m.mesh", meshio.read(self.folder / "t.mesh"))
        self.check_triangles("m.mesh")
        self.assertEqual(self.content("m.mesh"), self.expected)

    def test_meshio_and_gmsh(self):
        """Version 2.2; meshio's writer of 4.1 refuses several blocks of one surface."""
        self.write("named.msh", (self.folder / "t.msh").read_text().replace('"marker 13"', '"outlet"'))
        read = meshio.read(self.folder / "named.msh", file_format="gmsh")
        mesh = meshio.Mesh(read.points, read.cells, cell_data=read.cell_data, field_data=read.field_data)
        meshio.write(self.folder / "m.msh", mesh, file_format="gmsh22", binary=False)
        self.check_certified("m.msh")
        self.run_command("certify", "m.msh", *FORMULA, "-o", "again.msh")
        self.assertIn('1 13 "outlet"', (self.folder / "again.msh").read_text())

    def test_polygons_of_shapely(self):
        """Reads GeoJSON and WKT as shapely writes them, with holes. The areas of mesh and polygons are equal."""
        try:
            from shapely import geometry, ops
        except ImportError:
            self.skipTest("the test needs python3-shapely")
        plate = geometry.Polygon([(0, 0), (4, 0), (4, 3), (0, 3)], [[(1, 1), (2, 1), (2, 2), (1, 2)]])
        shape = geometry.MultiPolygon([plate, geometry.Polygon([(5, 0), (6, 0), (5, 1)])])
        self.write("s.wkt", shape.wkt)
        self.write("s.geojson", json.dumps(geometry.mapping(shape)))
        for name in ("s.wkt", "s.geojson"):
            done = self.run_command("mesh", name, "--size", "0.5", "-o", "s.mesh")
            self.assertEqual(done.returncode, 0, done.stderr)
            read = meshio.read(self.folder / "s.mesh")
            made = ops.unary_union([geometry.Polygon(read.points[row]) for row in read.cells_dict["triangle"]])
            self.assertLess(made.symmetric_difference(shape).area, 1e-12)

    def test_triangles_own_files(self):
        """Reads .node, .ele and .edge as Triangle's pages describe them, with regions and markers."""
        self.run_command("certify", "t.mesh", "-o", "t.node")
        tables = {kind: [line.split() for line in (self.folder / f"t.{kind}").read_text().splitlines() if not line.startswith("#")]
                  for kind in ("node", "ele", "edge")}
        for kind, head in (("node", ["2", "3", "1"]), ("ele", ["3", "1"]), ("edge", ["1"])):
            self.assertEqual(tables[kind][0], [str(len(tables[kind]) - 1), *head], kind)
            self.assertEqual([row[0] for row in tables[kind][1:]], [str(k) for k in range(1, len(tables[kind]))])
        place = {row[0]: tuple(round(float(x), 10) + 0.0 for x in row[1:3]) for row in tables["node"][1:]}
        found = {name: sorted((sorted(place[v] for v in row[1:-1]), int(row[-1])) for row in tables[kind][1:])
                 for name, kind in (("Triangles", "ele"), ("Edges", "edge"))}
        self.assertEqual(found, self.expected)

    def test_meshio_and_su2(self):
        read = meshio.read(self.folder / "t.su2")
        self.assertEqual(len(read.cells_dict["triangle"]), len(self.expected["Triangles"]))
        self.assertEqual(set(read.cell_data_dict["su2:tag"]["line"].tolist()), {11, 12, 13, 14, 15, 16})

    def test_vtk(self):
        reader = vtkXMLUnstructuredGridReader()
        reader.SetFileName(str(self.folder / "t.vtu"))
        reader.Update()
        grid = reader.GetOutput()
        regions = vtk_to_numpy(grid.GetCellData().GetArray("region"))
        self.assertEqual(sorted(regions.tolist()), sorted(r for _, r in self.expected["Triangles"]))
        cells = vtk_to_numpy(grid.GetCells().GetConnectivityArray()).reshape(-1, 3)
        points = numpy.round(vtk_to_numpy(grid.GetPoints().GetData()), 10) + 0.0
        found = sorted((sorted(tuple(points[v][:2].tolist()) for v in row), int(r)) for row, r in zip(cells, regions))
        self.assertEqual(found, self.expected["Triangles"])


if __name__ == "__main__":
    unittest.main()
