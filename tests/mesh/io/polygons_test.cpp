// SPDX-License-Identifier: MIT
#include "asterism/mesh/io/polygons.hpp"

#include <catch2/catch.hpp>

#include "asterism/core/random.hpp"
#include "asterism/mesh/domain/check_domain.hpp"
#include "asterism/mesh/io/load_domain.hpp"
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
  REQUIRE(read.value().holes.size() == 1);
  const point hole = read.value().holes[0];
  CHECK((hole.x > 1 && hole.x < 8 && hole.y > 1 && hole.y < 8));
  CHECK_FALSE((hole.x > 2 && hole.x < 7 && hole.y > 2 && hole.y < 7));
  const auto checked = check_domain(read.value());
  REQUIRE(checked.ok());
  CHECK(checked.value().segments.size() == 12);
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
  CHECK(one.value().holes[0].x == other.value().holes[0].x);
}

TEST_CASE("a region has a point although the line halfway up meets corners of a hole") {
  // A square of height 4 with a hole whose corners are at 1 and 2: no line but the one at 2 was
  // tried.
  const temporary_directory here("halfway");
  const auto read =
      read_geojson(here.write("a.geojson", R"({"type": "FeatureCollection", "features": [
    {"type": "Feature", "properties": null, "geometry": {"type": "Polygon", "coordinates":
      [[[0,0],[4,0],[4,4],[0,4],[0,0]], [[1,1],[2,1],[2,2],[1,2],[1,1]]]}},
    {"type": "Feature", "properties": null, "geometry": null}]})"));
  INFO((read.ok() ? "" : read.failure().message));
  REQUIRE(read.ok());
  REQUIRE(read.value().regions.size() == 1);
  const auto checked = check_domain(read.value());
  INFO((checked.ok() ? "" : checked.failure().message));
  CHECK(checked.ok());
}

TEST_CASE("a collection of polygons in well-known text is read, and one of anything else is not") {
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
             Contains("not 'POINT'"));
  CHECK_FALSE(read_wkt(here.write("c.wkt",
                                  "GEOMETRYCOLLECTION(GEOMETRYCOLLECTION("
                                  "POLYGON((0 0,1 0,0 1,0 0))))"))
                  .ok());
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
  CHECK_THAT(json(R"({"type": "LineString", "coordinates": []})"), Contains("\"LineString\""));
  CHECK_THAT(json(R"({"type": "Polygon", "coordinates": [[[0,0],[1,"x"]]]})"),
             Contains("coordinates[0][1]: two finite numbers"));
  CHECK_THAT(json(R"({"type": "Polygon", "coordinates": [[[0,0],[1,1],[0,0]]]})"),
             Contains("coordinates[0]: a ring of fewer than three corners"));
  CHECK_THAT(json(R"({"type": "FeatureCollection", "features": []})"), Contains("no polygon"));
  CHECK_THAT(json("[1]"), Contains("there is no \"type\""));
  CHECK_THAT(wkt("POLYGON ((0 0, 1 0,\n1 1, 0 x))"), Contains("a.wkt:2: coordinate"));
  CHECK_THAT(wkt("POINT (1 1)"), Contains("POLYGON or MULTIPOLYGON wanted"));
  CHECK_THAT(wkt("POLYGON EMPTY"), Contains("'(' wanted"));
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
