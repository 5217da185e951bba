// SPDX-License-Identifier: MIT
#include "asterism/mesh/io/poly.hpp"

#include <catch2/catch.hpp>
#include <clocale>
#include <limits>

#include "asterism/tests/mesh/fixtures/temporary_directory.hpp"
#include "asterism/tests/mesh/io/sample_mesh.hpp"

using namespace asterism;
using namespace asterism::internal;
using tests::temporary_directory;

namespace {

// A unit square with a square hole, as its author might write it.
const std::string ring =
    "# outer square, then the hole\n"
    "8 2 1 1\n"
    "\n"
    "0 0 0 7.5 1   # attribute and marker\n"
    "1 1 0 7.5 1\n"
    "2 1 1 7.5 1\n"
    "3 0 1e0 7.5 1\n"
    "4 .25 0.25 0 0\n"
    "5 +0.75 0.25 0 0\r\n"
    "6 0.75 0.75 0 0\n"
    "7 0.25 0.75 0 0\n"
    "8 1\n"
    "0 0 1 10\n"
    "1 1 2 11\n"
    "2 2 3 12\n"
    "3 3 0 13\n"
    "4 4 5 -1\n"
    "5 5 6 -1\n"
    "6 6 7 -1\n"
    "7 7 4 -1\n"
    "1\n"
    "0 0.5 0.5\n"
    "1\n"
    "0 0.1 0.1 3 0.01\n";

}  // namespace

TEST_CASE("a .poly file with everything in it is read") {
  const temporary_directory here("poly");
  const auto d = read_poly(here.write("ring.poly", ring));
  REQUIRE(d.ok());
  REQUIRE(d.value().vertices.size() == 8);
  REQUIRE(d.value().segments.size() == 8);
  REQUIRE(d.value().holes == std::vector<point>{{0.5, 0.5}});
  REQUIRE(d.value().vertices[5] == point{0.75, 0.25});
  REQUIRE(d.value().segments[3].a == 3);
  REQUIRE(d.value().segments[3].b == 0);
  REQUIRE(d.value().segments[3].marker == 13);
  REQUIRE(d.value().segments[7].marker == -1);
  REQUIRE(d.value().origin.first_number == 0);
  REQUIRE(d.value().origin.vertex_lines.front() == 4);
  REQUIRE(d.value().origin.segment_lines.front() == 13);
  REQUIRE(d.value().origin.hole_lines.front() == 22);
  REQUIRE(d.value().regions.size() == 1);
  REQUIRE(d.value().regions[0].at == point{0.1, 0.1});
  REQUIRE(d.value().regions[0].number == 3);
  REQUIRE(d.value().regions[0].largest_area == 0.01);
  REQUIRE(d.value().origin.region_lines.front() == 24);
}

TEST_CASE("vertices come from a .node file when the .poly file has none") {
  const temporary_directory here("node");
  here.write("tri.node", "3 2 0 0\n1 0 0\n2 1 0\n3 0 1\n# end\n");
  const auto path = here.write("tri.poly", "0 2 0 0\n3 0\n1 1 2\n2 2 3\n3 3 1\n0\n");
  const auto d = read_poly(path);
  REQUIRE(d.ok());
  REQUIRE(d.value().vertices == std::vector<point>{{0, 0}, {1, 0}, {0, 1}});
  REQUIRE(d.value().segments[2].b == 0);
  here.write("tri.node", "3 2 0 0\n1 0 0\n2 1 zero\n3 0 1\n");
  REQUIRE(read_poly(path).failure().message ==
          (here / "tri.node").string() + ":3: y of vertex 2: 'zero' is not a number");
  std::filesystem::remove(here / "tri.node");
  REQUIRE_THAT(read_poly(path).failure().message, Catch::Contains("tri.node: no such file"));
}

TEST_CASE("region numbers are whole numbers, however they are written") {
  const temporary_directory here("regions");
  const std::string head = "3 2\n1 0 0\n2 1 0\n3 0 1\n3\n1 1 2\n2 2 3\n3 3 1\n0\n";
  const auto d = read_poly(here.write(
      "r.poly", head + "4\n1 0.1 0.1 -2.0\n2 0.2 0.2 1e3 -1\n3 0.3 0.3 0\n4 0 0 2147483647 2\n"));
  REQUIRE(d.ok());
  REQUIRE(d.value().regions.size() == 4);
  REQUIRE(d.value().regions[0].number == -2);
  REQUIRE(d.value().regions[1].number == 1000);
  REQUIRE(d.value().regions[1].largest_area == 0);  // in Triangle's format: no limit
  REQUIRE(d.value().regions[3].number == 2147483647);
  REQUIRE(d.value().regions[3].largest_area == 2);
  for (const std::string bad : {"0.5", "2147483648", "-2.5"}) {
    const auto other = read_poly(here.write("r.poly", head + "1\n1 0.1 0.1 " + bad + "\n"));
    REQUIRE(other.ok());
    REQUIRE(other.value().regions[0].number == 1);
    REQUIRE(other.value().origin.notes.size() == 1);
    REQUIRE_THAT(other.value().origin.notes[0], Catch::Contains(bad + " is region 1"));
    REQUIRE(region_names_in_poly(here / "r.poly").at(1) == bad);
  }
}

TEST_CASE("coordinates are the nearest doubles") {
  const temporary_directory here("digits");
  const auto d = read_poly(here.write(
      "d.poly", "3 2\n1 0.1 5e-324\n2 1.7976931348623157e308 -0\n3 0x1.8p-1 1e-400\n0\n0\n"));
  REQUIRE(d.ok());
  REQUIRE(d.value().vertices[0] == point{0.1, std::numeric_limits<double>::denorm_min()});
  REQUIRE(d.value().vertices[1].x == std::numeric_limits<double>::max());
  REQUIRE(d.value().vertices[2] == point{0.75, 0});
}

TEST_CASE("malformed .poly files are refused with file, line and token") {
  struct malformed {
    std::string contents, line, what;
  };
  const std::string three = "3 2 0 0\n1 0 0\n2 1 0\n3 0 1\n";
  const std::string segments = "3 0\n1 1 2\n2 2 3\n3 3 1\n";
  const std::vector<malformed> cases = {
      {"", "", ": the file is empty"},
      {"# nothing\n\n", "", ": the file is empty"},
      {"three 2 0 0\n", "1", "number of vertices: 'three' is not a whole number"},
      {"-3 2 0 0\n", "1", "number of vertices: '-3' is negative"},
      {"3000000000 2 0 0\n1 0 0\n", "1", "'3000000000' is more than the rest of the file can hold"},
      {"99999999999999999999 2 0 0\n", "1", "'99999999999999999999' is too large"},
      {"3 3 0 0\n1 0 0 0\n", "1", "dimension: '3' should be 2"},
      {"3 2 0 2\n1 0 0 5\n", "1", "number of vertex markers: '2' should be 0 or 1"},
      {"3 2 0 0 0\n", "1", "'0' is too much"},
      {"3 2 0 0\n1 0 0\n2 1 north\n3 0 1\n", "3", "y of vertex 2: 'north' is not a number"},
      {"3 2 0 0\n1 0 0\n2 nan 0\n3 0 1\n", "3", "x of vertex 2: 'nan' is not finite"},
      {"3 2 0 0\n1 0 0\n2 -inf 0\n3 0 1\n", "3", "'-inf' is not finite"},
      {"3 2 0 0\n1 0 0\n2 1e999 0\n3 0 1\n", "3", "'1e999' is not finite"},
      {"3 2 0 0\n1 0 0\n2 1,5 0\n3 0 1\n", "3", "'1,5' is not a number"},
      {"3 2 0 0\n1 0 0\n2 1\n3 0 1\n", "3", "a vertex line needs 3 numbers, this one has 2"},
      {"3 2 0 0\n1 0 0\n2 1 0 9\n3 0 1\n", "3", "'9' is too much"},
      {"3 2 0 0\n1 0 0\n1 1 0\n3 0 1\n", "3", "vertex number 1 occurs twice"},
      {"3 2 0 0\n1 0 0\n3 1 0\n2 0 1\n", "3", "vertex number '3' where 2 should follow"},
      {"3 2 0 0\n2 0 0\n3 1 0\n4 0 1\n", "2", "vertex numbers start at 0 or 1, not at '2'"},
      {"3 2 0 0\n1 0 0\n2 1 0\n", "4", "the file ends after 2 of 3 vertex lines"},
      {three, "5", "the file ends where <segments> <markers> should follow"},
      {three + "3 0\n1 1 2\n2 2 4\n3 3 1\n", "7", "vertex '4' does not exist; there are 1 to 3"},
      {three + "3 0\n1 0 2\n2 2 3\n3 3 1\n", "6", "vertex '0' does not exist"},
      {three + "3 0\n1 1 2.0\n2 2 3\n3 3 1\n", "6", "'2.0' is not a whole number"},
      {three + "3 1\n1 1 2\n2 2 3\n3 3 1\n", "6", "a segment line needs 4 numbers"},
      {three + "3 1\n1 1 2 5000000000\n2 2 3 0\n3 3 1 0\n", "6", "does not fit into 32 bits"},
      {three + "3 0\n1 1 2\n1 2 3\n3 3 1\n0\n", "7", "segment number 1 occurs twice"},
      {three + segments, "9", "the file ends where <holes> should follow"},
      {three + segments + "1\n", "10", "the file ends after 0 of 1 hole lines"},
      {three + segments + "1\n1 0.2 inf\n", "10", "y of hole 1: 'inf' is not finite"},
      {three + segments + "0\n0\n17\n", "11", "'17' is too much: the file should end here"},
      {three + segments + "0\n1\n1 0 0\n", "11", "a region line needs 4 numbers"},
      {three + segments + "0\n1\n1 0 0 x\n", "11", "attribute of a region: 'x'"},
      {three + segments + "0\n1\n1 0 y 2\n", "11", "y of region 1: 'y'"},
      {three + segments + "0\n1\n1 0 0 2 z\n", "11", "largest area in a region: 'z'"},
      {std::string("3 2 0 0\n1 0 0\n2 \0\x07 0\n", 21), "3", "x of vertex 2: "},
  };
  const temporary_directory here("bad-poly");
  for (const malformed& c : cases) {
    INFO(c.contents);
    const auto path = here.write("bad.poly", c.contents);
    const auto d = read_poly(path);
    REQUIRE_FALSE(d.ok());
    const std::string place = path.string() + (c.line.empty() ? "" : ":" + c.line + ": ");
    REQUIRE_THAT(d.failure().message, Catch::StartsWith(place) && Catch::Contains(c.what));
    REQUIRE(d.failure().message.find('\n') == std::string::npos);
    CHECK((d.failure().code == error_code::malformed_file ||
           d.failure().code == error_code::bad_number));
  }
}

TEST_CASE("what is no file is refused by name") {
  const temporary_directory here("no-poly");
  CHECK(read_poly(here / "missing.poly").failure().code == error_code::unreadable_file);
  REQUIRE(read_poly(here / "missing.poly").failure().message ==
          (here / "missing.poly").string() + ": no such file");
  std::filesystem::create_directory(here / "folder.poly");
  REQUIRE(read_poly(here / "folder.poly").failure().message ==
          (here / "folder.poly").string() + ": not a regular file");
}

TEST_CASE("a byte order mark before the text was refused") {
  const temporary_directory here("marked-poly");
  const auto marked = read_poly(here.write("marked.poly", "\xEF\xBB\xBF" + ring));
  REQUIRE(marked.ok());
  CHECK(marked.value().vertices == read_poly(here.write("bare.poly", ring)).value().vertices);
  CHECK_FALSE(read_poly(here.write("twice.poly", "\xEF\xBB\xBF\xEF\xBB\xBF" + ring)).ok());
}
