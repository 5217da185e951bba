// SPDX-License-Identifier: MIT
#include "asterism/mesh/io/medit.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cstring>

#include "asterism/mesh/io/write_mesh.hpp"
#include "asterism/tests/mesh/fixtures/temporary_directory.hpp"
#include "asterism/tests/mesh/io/sample_mesh.hpp"

using namespace asterism;
using tests::sample_mesh;
using tests::temporary_directory;

namespace {

bool same_bits(double a, double b) { return std::memcmp(&a, &b, sizeof a) == 0; }

bool same_bits(const site& a, const site& b) {
  return same_bits(a.position.x, b.position.x) && same_bits(a.position.y, b.position.y) &&
         same_bits(a.metric.m11, b.metric.m11) && same_bits(a.metric.m12, b.metric.m12) &&
         same_bits(a.metric.m22, b.metric.m22);
}

void require_same(const mesh& a, const mesh& b) {
  REQUIRE(a.sites.size() == b.sites.size());
  for (std::size_t v = 0; v < a.sites.size(); ++v) REQUIRE(same_bits(a.sites[v], b.sites[v]));
  REQUIRE(a.given == b.given);
  REQUIRE(a.triangles == b.triangles);
  REQUIRE(a.regions == b.regions);
  REQUIRE(a.boundary.size() == b.boundary.size());
  for (std::size_t i = 0; i < a.boundary.size(); ++i) {
    REQUIRE(a.boundary[i].a == b.boundary[i].a);
    REQUIRE(a.boundary[i].b == b.boundary[i].b);
    REQUIRE(a.boundary[i].segment == b.boundary[i].segment);
    REQUIRE(a.boundary[i].marker == b.boundary[i].marker);
    REQUIRE(a.boundary[i].internal == b.boundary[i].internal);
  }
}

// A file as other programs write it: keywords in another order, counts on the keyword's line,
// sections that are passed over, comments.
const std::string foreign_mesh =
    "MeshVersionFormatted 1\n"
    "# made elsewhere\n"
    "Dimension\n2\n"
    "Edges 3\n1 2 5\n2 3 6\n3 1 7\n"
    "Triangles\n1\n1 2 3 0\n"
    "Corners\n2\n1 2\n"
    "Normals 1\n0.6 0.8\nNormalAtVertices 1\n1 1\n"
    "RequiredVertices 1\n2\n"
    "Vertices\n3\n0 0 1\n1. 0 1\n0 1.5e0 1\n"
    "Quadrilaterals 0\n"
    "End\n";
const std::string foreign_solution =
    "MeshVersionFormatted 2\nDimension 2\nSolAtVertices\n3\n1 3\n1 0 1\n2 0 2\n3 0.5 3\nEnd\n";

}  // namespace

TEST_CASE("a mesh written and read back has the same bits") {
  const temporary_directory here("medit");
  mesh m = sample_mesh(9);
  m.sites[20].metric = {0x1.fffffffffffffp+1023, -0x1p-1074, 0x1p-1022};
  m.sites[21].position = {-0.0, 0x1.5555555555555p-400};
  const auto written = write_mesh(here / "sample.mesh", m);
  REQUIRE(written.ok());
  REQUIRE(written.value() ==
          std::vector<std::filesystem::path>{here / "sample.mesh", here / "sample.sol"});
  const auto back = read_medit(here / "sample.mesh");
  INFO((back.ok() ? "" : back.failure().message));
  REQUIRE(back.ok());
  require_same(m, back.value());
}

TEST_CASE("corners are the given vertices where the boundary turns") {
  mesh m = sample_mesh(2);
  REQUIRE_THAT(medit_mesh_text(m), Catch::Contains("\nCorners\n4\n1\n2\n3\n4\n"));
  // The fifth site is in the middle of the bottom side.
  REQUIRE(m.sites[4].position == point{0, -1});
  m.given = 5;
  REQUIRE_THAT(medit_mesh_text(m), Catch::Contains("\nCorners\n4\n1\n2\n3\n4\n"));
  REQUIRE_THAT(medit_mesh_text(m), Catch::Contains("\nRequiredVertices\n5\n"));
}

TEST_CASE("no line of a long boundary is longer than other readers take") {
  const std::string text = medit_mesh_text(sample_mesh(200));
  std::size_t begin = 0, longest = 0;
  for (std::size_t end = text.find('\n'); end != std::string::npos; end = text.find('\n', begin)) {
    longest = std::max(longest, end - begin);
    begin = end + 1;
  }
  REQUIRE(longest <= 80);
}

TEST_CASE("files of other programs are read") {
  const temporary_directory here("medit-foreign");
  const auto path = here.write("f.mesh", foreign_mesh);
  here.write("f.sol", foreign_solution);
  const auto m = read_medit(path);
  INFO((m.ok() ? "" : m.failure().message));
  REQUIRE(m.ok());
  REQUIRE(m.value().sites[2] == site{{0, 1.5}, {3, 0.5, 3}});
  REQUIRE(m.value().triangles == std::vector<triangle>{{0, 1, 2}});
  REQUIRE(m.value().boundary[1].marker == 6);
  REQUIRE(m.value().boundary[1].segment == 1);
  REQUIRE(m.value().given == 0);
}

TEST_CASE("a plane mesh in three dimensions is read, with its own kind of tensors") {
  const temporary_directory here("medit-3d");
  const auto path =
      here.write("f.mesh",
                 "MeshVersionFormatted 2\nDimension 3\nVertices\n3\n0 0 0 1\n1 0 0 1\n"
                 "0 1 0 1\nTriangles\n1\n1 2 3 1\nTetrahedra\n0\nEnd\n");
  here.write("f.sol",
             "MeshVersionFormatted 2\nDimension 3\nSolAtVertices\n3\n1 3\n"
             "1 2 5 0 0 1\n1 2 5 0 0 1\n1 2 5 0 0 1\nEnd\n");
  const auto m = read_medit(path);
  INFO((m.ok() ? "" : m.failure().message));
  REQUIRE(m.ok());
  REQUIRE(m.value().sites[1] == site{{1, 0}, {1, 2, 5}});
}

TEST_CASE("internal edges and regions are written and read back") {
  const temporary_directory here("medit-internal");
  const mesh m = tests::divided_mesh(5);
  REQUIRE(write_mesh(here / "m.mesh", m).ok());
  const auto read = read_medit(here / "m.mesh");
  REQUIRE(read.ok());
  require_same(read.value(), m);
  const auto internal = std::count_if(read.value().boundary.begin(), read.value().boundary.end(),
                                      [](const boundary_edge& e) { return e.internal; });
  REQUIRE(internal == 5);
}

TEST_CASE("references that are all 1 say nothing of regions, others do") {
  const temporary_directory here("medit-regions");
  mesh m = sample_mesh(3);
  m.regions.assign(m.triangles.size(), 1);
  REQUIRE(write_mesh(here / "m.mesh", m).ok());
  REQUIRE(read_medit(here / "m.mesh").value().regions.empty());
  m.regions[4] = 0;
  REQUIRE(write_mesh(here / "m.mesh", m).ok());
  REQUIRE(read_medit(here / "m.mesh").value().regions == m.regions);
}

TEST_CASE("a missing metric is an error unless the identity is asked for") {
  const temporary_directory here("medit-sol");
  const auto path = here.write("f.mesh", foreign_mesh);
  REQUIRE(read_medit(path).failure().message == (here / "f.sol").string() + ": no such file");
  const auto m = read_medit(path, {true});
  REQUIRE(m.ok());
  REQUIRE(m.value().sites[2].metric == metric_tensor{1, 0, 1});
}

TEST_CASE("malformed .mesh files are refused with file, line and token") {
  struct malformed {
    std::string contents, line, what;
  };
  const std::string header = "MeshVersionFormatted 2\nDimension 2\n";
  const std::string vertices = header + "Vertices\n3\n0 0 0\n1 0 0\n0 1 0\n";
  const std::vector<malformed> cases = {
      {"", "1", "the file is empty"},
      {"solid cube\n", "1", "'solid' where MeshVersionFormatted should be"},
      {"MeshVersionFormatted 5\nDimension 2\n", "1", "'5' is none of 0 to 4"},
      {"MeshVersionFormatted 2\nVertices\n", "2", "'Vertices' where Dimension should be"},
      {"MeshVersionFormatted 2\nDimension 1\n", "2", "'1' is not 2"},
      {"MeshVersionFormatted 2\nDimension 3\nVertices 3\n0 0 0 0\n1 0 0.5 0\n0 1 0 0\nTriangles 1\n"
       "1 2 3 1\n",
       "5", "vertex 2 has 0.5, which is not 0"},
      {header + "Vertices\n3\n0 0 0\n1 O 0\n0 1 0\n", "6", "y of a vertex: 'O' is not a number"},
      {header + "Vertices\n3\n0 0 0\n1 nan 0\n0 1 0\n", "6", "'nan' is not finite"},
      {header + "Vertices\n3\n0 0 0\n1 0 0\n0 1\n", "8",
       "reference of a vertex: the file ends here"},
      {header + "Vertices\n-3\n", "4", "'-3' is negative"},
      {header + "Vertices\n400000000\n0 0 0\n", "4", "more than the rest of the file can hold"},
      {vertices, "8", "there is no section Triangles"},
      {header + "Triangles\n1\n1 2 3 0\nEnd\n", "6", "there is no section Vertices"},
      {vertices + "Triangles\n1\n1 2 4 0\nEnd\n", "10", "vertex 4 does not exist; there are 3"},
      {vertices + "Triangles\n1\n1 2 0 0\nEnd\n", "10", "vertex '0' does not exist"},
      {vertices + "Triangles\n1\n1 2 3.5 0\nEnd\n", "10", "'3.5' is not a whole number"},
      {vertices + "Triangles\n2\n1 2 3 0\nEnd\n", "11", "'End' is not a whole number"},
      {vertices + "Vertices\n3\n0 0 0\n1 0 0\n0 1 0\n", "9", "a second section Vertices"},
      {vertices + "Polygons\n1\n2.5\n", "11", "there is no section Triangles"},
      {vertices + "0 0 0\n", "8", "'0' where a section should begin"},
      {vertices + "Tetrahedra\n1\n1 2 3 3 0\n", "8", "only meshes of triangles"},
  };
  const temporary_directory here("bad-mesh");
  for (const malformed& c : cases) {
    INFO(c.contents);
    const auto path = here.write("bad.mesh", c.contents);
    const auto m = read_medit(path, {.without_solution = true});
    REQUIRE_FALSE(m.ok());
    CHECK_THAT(m.failure().message,
               Catch::StartsWith(path.string() + ":" + c.line + ": ") && Catch::Contains(c.what));
  }
}

TEST_CASE("malformed .sol files are refused with file, line and token") {
  const std::string header = "MeshVersionFormatted 2\nDimension 2\n";
  const std::vector<std::array<std::string, 3>> cases = {{
      {header, "3", "there is no section SolAtVertices"},
      {header + "SolAtVertices\n2\n1 3\n", "4", "2 tensors for 3 vertices"},
      {header + "SolAtVertices\n3\n1 2\n1 1 1 1 1 1\n", "5", "'1 3'"},
      {header + "SolAtVertices\n3\n1 1\n1 -1 1\n", "6", "a size is a positive length, not '-1'"},
      {header + "SolAtVertices\n3\n1 3\n1 0 1\n1 0 1\n1 0\n", "9", "the file ends here"},
      {header + "SolAtVertices\n3\n1 3\n1 0 1\n1 0 inf\n1 0 1\n", "7", "'inf' is not finite"},
      {header + "SolAtTriangles\n1\n1 1\n5\n", "3", "'SolAtTriangles' where"},
  }};
  const temporary_directory here("bad-sol");
  const auto path = here.write("bad.mesh", foreign_mesh);
  for (const auto& [contents, line, what] : cases) {
    INFO(contents);
    const auto solution = here.write("bad.sol", contents);
    const auto m = read_medit(path);
    REQUIRE_FALSE(m.ok());
    CHECK_THAT(m.failure().message,
               Catch::StartsWith(solution.string() + ":" + line + ": ") && Catch::Contains(what));
  }
}
