// SPDX-License-Identifier: MIT
#include <algorithm>
#include <catch2/catch.hpp>
#include <string>
#include <utility>
#include <vector>

#include "asterism/core/random.hpp"
#include "asterism/mesh/io/load_domain.hpp"
#include "asterism/mesh/io/read_mesh.hpp"
#include "asterism/tests/mesh/fixtures/temporary_directory.hpp"

using namespace asterism;
using namespace asterism::internal;
using tests::temporary_directory;

namespace {

// A square of two triangles as each format has it.
const std::vector<std::pair<std::string, std::string>> squares = {
    {"a.mesh",
     "MeshVersionFormatted 0\nDimension 2\nVertices\n5\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n9 9 0\n"
     "Edges\n2\n1 2 7\n3 2 8\nQuadrilaterals\n1\n1 4 3 2 4294967299\nUnheardOf\n1\n2 3\nEnd\n"},
    {"b.msh",
     "$MeshFormat\n4 0 8\n$EndMeshFormat\n$Entities\n0 0 1 0\n1 0 0 0 1 1 0 2 5 6 0\n"
     "$EndEntities\n$Nodes\n1 4\n1 2 0 4\n1 0 0 0\n2 1 0 0\n3 1 1 0\n4 0 1 0\n$EndNodes\n"
     "$Elements\n1 2\n1 2 2 2\n1 1 2 3\n2 1 3 4\n$EndElements\n"},
    {"c.msh",
     "$NOD\n4\n1 0 0 0\n2 1 0 0\n3 1 1 0\n4 0 1 0\n$ENDNOD\n$ELM\n3\n1 1 7 7 2 1 2\n"
     "2 2 5 5 3 1 2 3\n3 2 5 5 3 1 3 4\n$ENDELM\n"},
    {"d.msh", "4 2 2\n0 0 1\n1 0 1\n1 1 3\n0 1 3\n1 2 3 0\n1 3 4 0\n1 2 1\n2 3 2\n"},
    {"e.su2",
     "NDIME= 2\nNELEM= 2\n5 0 1 2 0\n5 0 2 3 1\nNPOIN= 4\n0 0 0\n1 0 1\n1 1 2\n0 1 3\n"
     "NMARK= 2\nMARKER_TAG= wall\nMARKER_ELEMS= 1\n3 0 1\nMARKER_TAG= 9\n"
     "MARKER_ELEMS= 1\n3 1 2\n"},
    {"f.14",
     "title\n2 4\n1 0 0 1.5\n2 1 0 1.5\n3 1 1 2\n4 0 1 2\n1 3 1 2 3\n2 3 1 3 4\n1\n2\n2\n"
     "1\n2\n1\n3\n3 0\n2\n3\n4\n"},
    {"g.2dm",
     "MESH2D\nE3T 1 1 2 3 7\nE3T 2 1 3 4 7\nND 1 0 0 1\nND 2 1 0 1\nND 3 1 1 1\nND 4 0 1 1\n"
     "NS 1 2 -3 1\n"},
    {"h.vtk",
     "# vtk DataFile Version 3.0\nx\nASCII\nDATASET UNSTRUCTURED_GRID\nPOINTS 4 double\n0 0 0 1 0 "
     "0 1 1 0 0 1 0\nCELLS 2 8\n3 0 1 2\n3 0 2 3\nCELL_TYPES 2\n5 5\nCELL_DATA 2\nSCALARS "
     "region int\nLOOKUP_TABLE default\n3 4\n"},
    {"i.stl",
     "solid a\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 1 1 0\n"
     "endloop\nendfacet\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 1 0\n"
     "vertex 0 1 0\nendloop\nendfacet\nendsolid a\n"},
};

double area(const mesh& m) {
  double all = 0;
  for (const triangle& t : m.triangles) {
    const point &a = m.sites[t[0]].position, &b = m.sites[t[1]].position,
                &c = m.sites[t[2]].position;
    all += ((b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x)) / 2;
  }
  return all;
}

}  // namespace

TEST_CASE("one square is read of every format") {
  const temporary_directory here("listed");
  for (const auto& [name, text] : squares) {
    INFO(name);
    const auto read = read_mesh_file(here.write(name, text), {.identity_without_solution = true});
    INFO((read.ok() ? "" : read.failure().message));
    REQUIRE(read.ok());
    const mesh& m = read.value().content;
    CHECK(m.sites.size() == 4);
    CHECK(m.triangles.size() == 2);
    CHECK(area(m) == 1);
    CHECK((m.regions.empty() || m.regions.size() == 2));
    for (const boundary_edge& e : m.boundary) CHECK(std::max(e.a, e.b) < 4);
  }
}

TEST_CASE("spoiled files of every format are read or refused by name") {
  const temporary_directory here("listed-spoiled");
  splitmix64 random(39);
  const auto below = [&](std::size_t n) { return static_cast<std::size_t>(random.bits() % n); };
  std::size_t runs = 0, refused = 0;
  for (const auto& [name, good] : squares) {
    for (int i = 0; i < 600; ++i) {
      std::string text = good;
      for (std::size_t k = 1 + below(3); k > 0; --k)
        text[below(text.size())] = "0123456789 -.e\nDN=$"[below(19)];
      if (i % 4 == 0) text.resize(below(text.size()));
      if (i % 16 == 1) text.insert(below(text.size()), "99999999999");
      INFO(name << " " << i << "\n" << text);
      const auto file = here.write(name, text);
      const auto read = read_mesh_file(file, {.without_solution = true});
      ++runs;
      if (!read.ok()) {
        ++refused;
        CHECK_THAT(read.failure().message, Catch::Contains(name));
        (void)load_domain(file.string());
        continue;
      }
      const mesh& m = read.value().content;
      for (const triangle& t : m.triangles)
        CHECK(*std::max_element(t.begin(), t.end()) < m.sites.size());
      for (const boundary_edge& e : m.boundary) CHECK(std::max(e.a, e.b) < m.sites.size());
      CHECK((m.regions.empty() || m.regions.size() == m.triangles.size()));
    }
  }
  CHECK(runs == 5400);
  CHECK(refused > 1000);
}

TEST_CASE("one word too few or too many in a line of numbers was read as other numbers") {
  const temporary_directory here("listed-words");
  const auto failure_of = [&](const std::string& name, const std::string& from,
                              const std::string& to) {
    const auto square = std::find_if(squares.begin(), squares.end(),
                                     [&](const auto& one) { return one.first == name; });
    std::string text = square->second;
    text.replace(text.find(from), from.size(), to);
    const auto read = read_mesh_file(here.write(name, text), {.without_solution = true});
    REQUIRE_FALSE(read.ok());
    return read.failure().message;
  };
  using Catch::Contains;
  // The number of a point that has lost its y was the y.
  CHECK_THAT(failure_of("e.su2", "\n0 1 3\n", "\n0 3\n"), Contains("e.su2:9: 2 words, where 3"));
  CHECK_THAT(failure_of("e.su2", "5 0 2 3 1", "5 0 2 3"), Contains("e.su2:4: 4 words, where 5"));
  CHECK_THAT(failure_of("e.su2", "5 0 2 3 1", "5 0 2 2 3 1"), Contains("e.su2:4: 6 words"));
  // Triangles with the type of a point were left out, as points are, and so were those of none.
  CHECK_THAT(failure_of("h.vtk", "5 5", "1 5"), Contains("cell 1 is of type 1 with 3 points"));
  CHECK_THAT(failure_of("h.vtk", "5 5", "1.5 5"), Contains("cell 1: 1.5 is no type of a cell"));
}

TEST_CASE("counts that a file cannot hold take no memory") {
  const temporary_directory here("listed-counts");
  const std::vector<std::pair<std::string, std::string>> files = {
      {"a.su2", "NDIME= 2\nNELEM= 1000000000\n"},
      {"b.14", "x\n1000000000 1000000000\n"},
      {"c.vtk",
       "# vtk DataFile Version 3.0\nx\nBINARY\nDATASET UNSTRUCTURED_GRID\nPOINTS "
       "500000000 double\n"},
      {"d.vtk",
       "# vtk DataFile Version 5.1\nx\nASCII\nDATASET UNSTRUCTURED_GRID\nPOINTS 0 float\n"
       "CELLS 999999999999 999999999999\nOFFSETS vtktypeint64\n"},
      {"e.vtk",
       "# vtk DataFile Version 3.0\nx\nASCII\nDATASET UNSTRUCTURED_GRID\nPOINTS 0 float\n"
       "POINT_DATA 999999999999999\nFIELD f 1\na 999999999999999 999999999999999 int\n"},
      {"f.msh", "1000000000 1000000000 0\n0 0 0\n"},
  };
  for (const auto& [name, text] : files) {
    INFO(name);
    const auto read = read_mesh_file(here.write(name, text), {.without_solution = true});
    REQUIRE_FALSE(read.ok());
    CHECK_THAT(read.failure().message, Catch::Contains(name));
  }
}
