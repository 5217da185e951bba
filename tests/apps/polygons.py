# SPDX-License-Identifier: MIT
"""GeoJSON and well-known text through the command: the domain is what the formats define, each feature's part is in
its region, and `verify` compares the mesh with the same file."""
import json
import os
import unittest

from command import CommandTest, section


def ring(*corners):
    return [list(corner) for corner in (*corners, corners[0])]


def box(x0, y0, x1, y1):
    return ring((x0, y0), (x1, y0), (x1, y1), (x0, y1))


def polygon(*rings):
    return {"type": "Polygon", "coordinates": list(rings)}


def parts(*polygons):
    return {"type": "MultiPolygon", "coordinates": list(polygons)}


def features(*geometries):
    return json.dumps({"type": "FeatureCollection", "features": [
        {"type": "Feature", "properties": {}, "geometry": geometry} for geometry in geometries]})


class Polygons(CommandTest):
    def areas(self, name):
        """Returns the areas of a mesh's triangles, summed by region."""
        lines = (self.folder / name).read_text().split("\n")
        at, count = section(lines, "Vertices")
        points = [tuple(map(float, line.split()[:2])) for line in lines[at:at + count]]
        at, count = section(lines, "Triangles")
        found = {}
        for line in lines[at:at + count]:
            a, b, c, region = map(int, line.split())
            (x0, y0), (x1, y1), (x2, y2) = points[a - 1], points[b - 1], points[c - 1]
            found[region] = found.get(region, 0) + ((x1 - x0) * (y2 - y0) - (y1 - y0) * (x2 - x0)) / 2
        return found

    def check(self, name, content, areas, *options, notes=()):
        """Meshes and verifies a file, and checks that the run prints exactly these notes."""
        self.write(name, content)
        done = self.run_command("mesh", name, *options, "-o", "m.mesh")
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertEqual(len([line for line in done.stderr.split("\n") if "note: " in line]), len(notes), done.stderr)
        for note in notes:
            self.assertIn(note, done.stderr)
        found = self.areas("m.mesh")
        self.assertEqual(found.keys(), areas.keys())
        for region, area in areas.items():
            self.assertAlmostEqual(found[region], area, delta=1e-12 * max(1, area))
        if not options:
            done = self.run_command("verify", "m.mesh", "--domain", name)
            self.assertEqual(done.returncode, 0, done.stdout + done.stderr)

    def test_an_enclave_of_the_same_shape(self):
        self.check("a.wkt", "MULTIPOLYGON(((0 0,3 0,3 3,0 3,0 0),(1 1,2 1,2 2,1 2,1 1)),"
                            "((1 1,2 1,2 2,1 2,1 1)))", {1: 9})
        lines = (self.folder / "m.mesh").read_text().split("\n")
        at, count = section(lines, "Vertices")
        near = {k for k, line in enumerate(lines[at:at + count], 1)
                if all(1 <= float(x) <= 2 for x in line.split()[:2])}
        at, count = section(lines, "Edges")
        between = [line for line in lines[at:at + count] if near.issuperset(map(int, line.split()[:2]))]
        self.assertGreaterEqual(len(between), 4)  # the ring between the two belongs to the domain too

    def test_a_gap_between_parts_that_touch_in_points(self):
        self.check("a.wkt", "MULTIPOLYGON(((0 0,3 0,2 1,1 1,0 0)),((3 0,3 3,2 2,2 1,3 0)),"
                            "((3 3,0 3,1 2,2 2,3 3)),((0 3,0 0,1 1,1 2,0 3)))", {1: 8})

    def test_a_feature_in_the_hole_of_another(self):
        self.check("a.geojson", features(polygon(box(0, 0, 3, 3), box(1, 1, 2, 2)), polygon(box(1, 1, 2, 2))),
                   {1: 8, 2: 1})

    def test_a_hole_of_one_feature_under_another_is_not_that_feature_s(self):
        self.check("a.geojson", features(polygon(box(0, 0, 6, 6), box(1, 1, 5, 5)),
                                         polygon(box(2, 2, 4, 4), box(2.5, 2.5, 3.5, 3.5)),
                                         polygon(box(2.5, 2.5, 3, 3))), {1: 20, 2: 3, 3: 0.25})

    def test_sides_shared_in_part_are_inside(self):
        self.check("a.geojson", features(polygon(box(0, 0, 4, 4)), polygon(box(4, 1, 6, 3)),
                                         parts([box(4, 3, 6, 5)], [box(6, 1, 7, 3)])), {1: 16, 2: 4, 3: 6})

    def test_features_that_overlap(self):
        """Features that cross are refused, both named. With the repair, the first has the part that both contain,
        with a note."""
        note = "parts in which features overlap, numbered as the first of them: 1, feature 1 and feature 2"
        two = features(polygon(box(0, 0, 4, 4)), polygon(box(2, 2, 6, 6)))
        self.write("a.geojson", two)
        done = self.run_command("mesh", "a.geojson", "-o", "m.mesh")
        self.assertEqual(done.returncode, 2)
        self.assertIn("of polygon 2 (feature 2) crosses the side (4, 0) - (4, 4) of polygon 1 (feature 1)", done.stderr)
        self.assertIn("--repair-domain mends it", done.stderr)
        self.assertEqual(self.files(), ["a.geojson"])
        self.check("a.geojson", two, {1: 16, 2: 12}, "--repair-domain",
                   notes=["crossings made vertices: 2", note])
        nested = features(polygon(box(0, 0, 4, 4)), polygon(box(1, 1, 2, 2)))
        self.check("a.geojson", nested, {1: 16}, notes=[note])
        self.check("a.geojson", features(polygon(box(1, 1, 2, 2)), polygon(box(0, 0, 4, 4))), {1: 1, 2: 15},
                   notes=[note])
        self.check("a.geojson", features(polygon(box(0, 0, 4, 4)), polygon(box(0, 0, 4, 4))), {1: 16}, notes=[note])

    def test_what_is_passed_over_is_told(self):
        line = {"type": "LineString", "coordinates": [[0, 0], [1, 1]]}
        content = features({"type": "Point", "coordinates": [0.5, 0.2]}, polygon(box(0, 0, 1, 1)),
                           {"type": "GeometryCollection", "geometries": [line, polygon(box(2, 0, 3, 1))]}, None)
        notes = ["empty geometries passed over: 1, features[3].geometry",
                 "points and lines passed over: 2, the first: features[0].geometry, a Point"]
        self.check("a.geojson", content, {2: 1, 3: 1}, notes=notes)
        done = self.run_command("info", "a.geojson")
        self.assertEqual(done.returncode, 0, done.stderr)
        for note in notes:
            self.assertIn(note, done.stdout)
        self.check("a.geojson", json.dumps(polygon(box(0, 0, 2, 1), ring((0.5, 0.5), (0.6, 0.5)))), {1: 2},
                   notes=["rings without area dropped: 1, ring 2 of polygon 1"])
        self.check("a.wkt", "POLYGON EMPTY; POLYGON((0 0,1 0,0 1,0 0))", {1: 0.5},
                   notes=["empty geometries passed over: 1, on line 1"])
        # Coordinates beyond two do not distinguish points.
        self.check("a.wkt", "POLYGON ZM((0 0 1 2,1 0 1 2,0 1 1 2,0 0 1 2))", {1: 0.5},
                   notes=["points whose coordinates beyond x and y were dropped: 4, the first: on line 1"])

    def test_a_repair_keeps_what_is_inside(self):
        """An enclave whose ring is off by a billionth, and features that overlap by as much."""
        e = 1e-9
        self.check("a.geojson", features(polygon(box(0, 0, 3, 3), box(1, 1, 2, 2)),
                                         polygon(box(1 - e, 1 + e, 2 - e, 2 + e)), polygon(box(3 - e, 0, 4, 3))),
                   {1: 8, 2: 1, 3: 3}, "--repair-domain", "--repair-distance", 1e-8,
                   notes=["vertices joined that were nearer than 1e-08"])

    def test_a_bow_tie_is_refused_by_its_sides(self):
        self.write("a.wkt", "POLYGON((0 0,2 2,2 0,0 2,0 0))")
        done = self.run_command("mesh", "a.wkt", "-o", "m.mesh")
        self.assertEqual(done.returncode, 2)
        self.assertIn("the side (2, 0) - (0, 2) of polygon 1 crosses the side (0, 0) - (2, 2) of polygon 1", done.stderr)

    def test_nesting_without_end_and_names_without_end(self):
        self.write("deep.geojson", '{"type":' + "[" * 100000 + "]" * 100000 + "}")
        done = self.run_command("info", "deep.geojson")
        self.assertEqual(done.returncode, 2)
        self.assertIn("deep.geojson:1: lists and objects are nested too deeply", done.stderr)
        members = ",".join(f'"{i}":1' for i in range(5000))
        self.write("long.certificate.json", '{"' + "A" * 102400 + '":{' + members + "}}")
        with open(self.folder / "said", "wb") as said:
            child = os.posix_spawn(os.environ["ASTERISM_COMMAND"],
                                   ["asterism", "info", str(self.folder / "long.certificate.json")], os.environ,
                                   file_actions=[(os.POSIX_SPAWN_DUP2, said.fileno(), 2)])
            _, status, used = os.wait4(child, 0)
        self.assertEqual(os.waitstatus_to_exitcode(status), 2)
        self.assertLess(used.ru_maxrss, 100000)  # kilobytes; 5,000 copies of the key would take 512 MB

    def test_a_certificate_is_a_file_that_ends(self):
        self.check("a.wkt", "POLYGON((0 0,1 0,0 1,0 0))", {1: 0.5})
        os.mkfifo(self.folder / "pipe")
        for endless in ("pipe", "/dev/zero"):
            done = self.run_command("verify", "m.mesh", "--certificate", endless, seconds=20)
            self.assertEqual(done.returncode, 2)
            self.assertIn("not a regular file", done.stderr)


if __name__ == "__main__":
    unittest.main()
