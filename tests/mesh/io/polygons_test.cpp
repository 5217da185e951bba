// SPDX-License-Identifier: MIT

#include <catch2/catch.hpp>
#include <cmath>

#include "asterism/core/random.hpp"
#include "asterism/mesh/domain/check_domain.hpp"
#include "asterism/mesh/domain/point_in_domain.hpp"
#include "asterism/mesh/io/geojson.hpp"
#include "asterism/mesh/io/load_domain.hpp"
#include "asterism/mesh/io/polygon_domain.hpp"
#include "asterism/mesh/io/wkt.hpp"
#include "asterism/tests/mesh/fixtures/temporary_directory.hpp"

using namespace asterism;
using namespace asterism::internal;
using tests::temporary_directory;

namespace {

// A square with a square hole, in which there is an island.
const char* const lake =
    R"({"type": "MultiPolygon", "coordinates": [
  [[[0,0],[9,0],[9,9],[0,9],[0,0]], [[1,1],[1,8],[8,8],[8,1],[1,1]]],
  [[[2,2,77],[7,2,77],[7,7,77],[2,7,77],[2,2,77]]]]})";

}  // namespace

TEST_CASE("a GeoJSON hole with an island in it is a hole around the island") {
  const temporary_directory here("geojson");
  const auto read = load_domain(here.write("lake.geojson", lake).string());
  INFO((read.ok() ? "" : read.failure().message));
  REQUIRE(read.ok());
  REQUIRE(read.value().vertices.size() == 12);
  const auto checked = check_domain(read.value());
  REQUIRE(checked.ok());
  CHECK(checked.value().segments.size() == 12);
  CHECK(internal::contains(checked.value(), {0.5, 4}));
  CHECK_FALSE(internal::contains(checked.value(), {1.5, 4}));
  CHECK(internal::contains(checked.value(), {4, 4}));
}

TEST_CASE("features of a collection are regions, and a common side is inside") {
  const temporary_directory here("features");
  const auto read =
      read_geojson(here.write("two.geojson", R"({"type": "FeatureCollection", "features": [
    {"type": "Feature", "properties": null, "geometry": {"type": "Polygon", "coordinates": [[[0,0],[1,0],[1,1],[0,1],[0,0]]]}},
    {"type": "Feature", "properties": {}, "geometry": {"type": "Polygon", "coordinates": [[[1,0],[2,0],[2,1],[1,1],[1,0]]]}}]})"));
  REQUIRE(read.ok());
  const auto checked = check_domain(read.value());
  REQUIRE(checked.ok());
  CHECK(checked.value().segments.size() == 7);
  int inside = 0;
  for (const segment& s : checked.value().segments)
    if (s.internal) {
      ++inside;
      CHECK(s.left_region + s.right_region == 3);
    }
  CHECK(inside == 1);
}

TEST_CASE("well-known text gives the same domain as GeoJSON") {
  const temporary_directory here("wkt");
  const auto one = read_geojson(here.write("a.geojson", lake));
  const auto other = load_domain(
      here.write("a.wkt",
                 "SRID=2056;MULTIPOLYGON Z (((0 0 1, 9 0 1, 9 9 1, 0 9 1, 0 0 1),"
                 "(1 1 1,1 8 1,8 8 1,8 1 1,1 1 1)),\n((2 2 1, 7 2 1, 7 7 1, 2 7 1, 2 2 1)))\n")
          .string());
  INFO((other.ok() ? "" : other.failure().message));
  REQUIRE((one.ok() && other.ok()));
  REQUIRE(one.value().vertices.size() == other.value().vertices.size());
  for (std::size_t v = 0; v < one.value().vertices.size(); ++v) {
    CHECK(one.value().vertices[v].x == other.value().vertices[v].x);
    CHECK(one.value().vertices[v].y == other.value().vertices[v].y);
  }
  REQUIRE(other.value().polygons.size() == 2);
  for (std::size_t p = 0; p < 2; ++p)
    CHECK(one.value().polygons[p].rings == other.value().polygons[p].rings);
}

TEST_CASE("a feature has its region although the line halfway up meets corners of a hole") {
  // The horizontal line through the middle of the square meets two corners of the hole.
  const temporary_directory here("halfway");
  const auto read =
      read_geojson(here.write("a.geojson", R"({"type": "FeatureCollection", "features": [
    {"type": "Feature", "properties": null, "geometry": {"type": "Polygon", "coordinates":
      [[[0,0],[4,0],[4,4],[0,4],[0,0]], [[1,1],[2,1],[2,2],[1,2],[1,1]]]}},
    {"type": "Feature", "properties": null, "geometry": null}]})"));
  INFO((read.ok() ? "" : read.failure().message));
  REQUIRE(read.ok());
  const auto checked = check_domain(read.value());
  INFO((checked.ok() ? "" : checked.failure().message));
  REQUIRE(checked.ok());
  for (const segment& s : checked.value().segments) CHECK(s.left_region == 1);
}

TEST_CASE("collections in well-known text are read, in each other too") {
  const temporary_directory here("wkt-collection");
  const auto read =
      read_wkt(here.write("a.wkt",
                          "SRID=1;GEOMETRYCOLLECTION Z (POLYGON Z ((0 0 1, 1 0 1, 0 1 1, 0 0 1)),"
                          "MULTIPOLYGON (((3 0, 4 0, 3 1, 3 0)), ((5 0, 6 0, 5 1, 5 0))))"));
  INFO((read.ok() ? "" : read.failure().message));
  REQUIRE(read.ok());
  CHECK(read.value().segments.size() == 9);
  using Catch::Contains;
  CHECK_THAT(read_wkt(here.write("b.wkt", "GEOMETRYCOLLECTION(POINT(3 3))")).failure().message,
             Contains("there is no polygon in it; points and lines: 1, a point on line 1"));
  CHECK(read_wkt(here.write("c.wkt",
                            "GEOMETRYCOLLECTION(GEOMETRYCOLLECTION("
                            "POLYGON((0 0,1 0,0 1,0 0))))"))
            .ok());
  std::string deep = "POLYGON((0 0,1 0,0 1,0 0))";
  for (int i = 0; i < 20; ++i) deep = "GEOMETRYCOLLECTION(" + deep + ")";
  CHECK_THAT(read_wkt(here.write("e.wkt", deep)).failure().message,
             Contains("e.wkt:1: collections are nested too deeply"));
  CHECK_FALSE(read_wkt(here.write("d.wkt", "GEOMETRYCOLLECTION(POLYGON((0 0,1 0,0 1,0 0))")).ok());
}

TEST_CASE("polygons that are none are refused with the place") {
  const temporary_directory here("polygons-refused");
  const auto json = [&](const std::string& text) {
    return read_geojson(here.write("a.geojson", text)).failure().message;
  };
  const auto wkt = [&](const std::string& text) {
    return read_wkt(here.write("a.wkt", text)).failure().message;
  };
  using Catch::Contains;
  CHECK_THAT(json("{\n\"type\": }"), Contains("a.geojson:2: this is not JSON"));
  CHECK_THAT(json(R"({"type": "LineString", "coordinates": []})"),
             Contains("there is no polygon in it; points and lines: 1, the root, a LineString"));
  CHECK_THAT(json(R"({"type": "Ellipse", "coordinates": []})"), Contains("the type is 'Ellipse'"));
  CHECK_THAT(json(R"({"type": ["Polygon"], "coordinates": []})"),
             Contains("the type is no string"));
  CHECK_THAT(json(R"({"type": "Polygon", "coordinates": [[[0,0],[1,"x"]]]})"),
             Contains("coordinates[0][1]: two finite numbers"));
  CHECK_THAT(json(R"({"type": "Polygon", "coordinates": [[[0,0],[1,1],[0,0]]]})"),
             Contains("no polygon with an area in it; rings without area: 1, ring 1 of polygon 1"));
  CHECK_THAT(json(R"({"type": "FeatureCollection", "features": []})"), Contains("no polygon"));
  CHECK_THAT(json(R"({"type": "Polygon", "coordinates": [[[0,0],[1e999,0],[1,1]]]})"),
             Contains("a number is beyond the range of doubles"));
  CHECK_THAT(json("[1]"), Contains("there is no \"type\""));
  CHECK_THAT(wkt("POLYGON ((0 0, 1 0,\n1 1, 0 x))"), Contains("a.wkt:2: coordinate"));
  CHECK_THAT(wkt("POINT (1 1)"),
             Contains("there is no polygon in it; points and lines: 1, a point"));
  CHECK_THAT(wkt("POLYGON EMPTY"),
             Contains("there is no polygon in it; empty geometries: 1, on line 1"));
  CHECK_THAT(wkt("CURVEPOLYGON ((0 0, 1 0, 1 1, 0 0))"), Contains("not 'CURVEPOLYGON'"));
  CHECK_THAT(wkt("POLYGON ((0 0, 1 0, 1 1"), Contains("the end of the file"));
  CHECK_THAT(wkt(""), Contains("there is no polygon"));
}

TEST_CASE("spoiled polygons are read or refused, and nothing else") {
  const temporary_directory here("polygons-spoiled");
  splitmix64 random(21);
  const auto below = [&](std::size_t n) { return static_cast<std::size_t>(random.bits() % n); };
  const std::string good = lake;
  for (int i = 0; i < 500; ++i) {
    std::string text = good;
    text[below(text.size())] = "0123456789[]{},\"e."[below(18)];
    const auto read = read_geojson(here.write("a.geojson", text));
    if (read.ok()) static_cast<void>(check_domain(read.value()));
  }
}

TEST_CASE("what is empty, flat, no polygon or out of the plane is passed over with a note") {
  const temporary_directory here("polygon-notes");
  const auto read =
      read_geojson(here.write("a.geojson", R"({"type": "FeatureCollection", "features": [
    {"type": "Feature", "properties": {}, "geometry": {"type": "Point", "coordinates": [0.5, 0.2]}},
    {"type": "Feature", "properties": {}, "geometry": {"type": "Polygon", "coordinates":
      [[[0,0],[4,0,1],[4,4],[0,4],[0,0]], [[1,1],[2,1],[1,1]], [[1,2],[2,3],[3,4],[1,2]],
       [[1,1],[2,1],[2,2],[2,1],[1,1]]]}},
    {"type": "Feature", "properties": {}, "geometry": {"type": "MultiPolygon", "coordinates": []}},
    {"type": "Feature", "properties": {}, "geometry": {"type": "Polygon", "coordinates":
      [[[7,7],[8,8],[9,9],[7,7]], [[0,0],[1,0],[1,1],[0,0]]]}},
    {"type": "Feature", "properties": {}, "geometry": null}]})"));
  INFO((read.ok() ? "" : read.failure().message));
  REQUIRE(read.ok());
  const auto& notes = read.value().origin.notes;
  REQUIRE(notes.size() == 4);
  using Catch::Contains;
  CHECK_THAT(notes[0],
             Contains("empty geometries passed over: 2, the first: features[2].geometry"));
  CHECK_THAT(notes[1], Contains("points and lines passed over: 1, features[0].geometry, a Point"));
  CHECK_THAT(notes[2], Contains("dropped: 1, features[1].geometry.coordinates[0][1]"));
  CHECK_THAT(notes[3], Contains("rings without area dropped: 4, the first: ring 2 of polygon 1"));
  const auto checked = check_domain(read.value());
  REQUIRE(checked.ok());
  CHECK(checked.value().segments.size() == 4);
  CHECK(checked.value().segments[0].left_region == 2);
}

TEST_CASE("empty and other geometries in well-known text are passed over with a note") {
  const temporary_directory here("wkt-notes");
  const auto read =
      read_wkt(here.write("a.wkt",
                          "POLYGON EMPTY\nMULTIPOLYGON Z (EMPTY, ((0 0 0, 1 0 0, 0 1 0, 0 0 "
                          "0)))\nLINESTRING(0 0, 1 1)\n"
                          "MULTIPOINT((1 1),(2 2)); PolygonZ ((5 0 3, 6 0 3, 5 1 3, 5 0 3))"));
  INFO((read.ok() ? "" : read.failure().message));
  REQUIRE(read.ok());
  CHECK(read.value().segments.size() == 6);
  const auto& notes = read.value().origin.notes;
  REQUIRE(notes.size() == 3);
  using Catch::Contains;
  CHECK_THAT(notes[0], Contains("empty geometries passed over: 2, the first: on line 1"));
  CHECK_THAT(notes[1], Contains("passed over: 2, the first: a linestring on line 3"));
  CHECK_THAT(notes[2], Contains("dropped: 4, the first: on line 4"));
}

TEST_CASE("a ring that does not end where it begins is closed with a note") {
  const temporary_directory here("open-rings");
  const auto notes = [&](const char* name, const std::string& text) {
    const auto path = here.write(name, text);
    const auto read = std::string(name).ends_with(".wkt") ? read_wkt(path) : read_geojson(path);
    REQUIRE(read);
    CHECK(read.value().segments.size() == 4);
    return read.value().origin.notes;
  };
  const auto open = notes("a.wkt", "POLYGON ((0 0, 2 0, 2 1, 0 1))");
  REQUIRE(open.size() == 1);
  CHECK_THAT(open[0], Catch::Contains("closed by a segment: 1, "));
  CHECK(notes("a.geojson", R"({"type":"Polygon","coordinates":[[[0,0],[2,0],[2,1],[0,1]]]})")
            .size() == 1);
  CHECK(notes("b.wkt", "POLYGON ((0 0, 2 0, 2 1, 0 1, 0 0))").empty());
}

TEST_CASE("rings that go there and back are dropped wherever they are, and no others") {
  const temporary_directory here("flat-rings");
  splitmix64 random(22);
  for (int round = 0; round < 300; ++round) {
    // A ring that visits up to twelve corners and returns over them, in some rounds far from the
    // origin.
    std::vector<point> there;
    const double at = round % 3 == 0 ? 1e9 : 0;
    const std::size_t count = 2 + random.bits() % 11;
    for (std::size_t i = 0; i < count; ++i)
      there.push_back({at + 1 + 2 * static_cast<double>(i) / 12, at + 1 + 2 * random.real()});
    polygon shape;
    shape.rings.push_back({{at, at}, {at + 4, at}, {at + 4, at + 4}, {at, at + 4}, {at, at}});
    std::vector<point> ring = there;
    ring.insert(ring.end(), there.rbegin() + 1, there.rend());
    shape.rings.push_back(ring);
    polygons_read read;
    read.polygons = {shape};
    const auto flat = domain_of_polygons(read, "flat");
    REQUIRE(flat.ok());
    CHECK(flat.value().segments.size() == 4);
    CHECK(flat.value().origin.notes.size() == 1);
    // With one corner moved by a unit in the last place, the ring encloses an area.
    if (there.size() < 3) continue;
    read.polygons[0].rings[1][there.size()].y = std::nextafter(ring[there.size()].y, 1e300);
    const auto thin = domain_of_polygons(read, "thin");
    REQUIRE(thin.ok());
    CHECK(thin.value().segments.size() > 4);
  }
}

TEST_CASE("JSON that is nested without end is refused before anything follows it") {
  const temporary_directory here("deep");
  const std::string open(100000, '['), close(100000, ']');
  using Catch::Contains;
  for (const std::string& text :
       {"{\"type\":" + open + close + "}", open, "{\"a\":\"]\",\n" + open})
    CHECK_THAT(read_geojson(here.write("a.geojson", text)).failure().message,
               Contains("lists and objects are nested too deeply"));
  CHECK_THAT(
      read_geojson(here.write("a.geojson", "{\"a\":\"[[\\\"[[\",\n" + open)).failure().message,
      Contains("a.geojson:2:"));
}
