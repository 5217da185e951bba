// SPDX-License-Identifier: MIT
#include "asterism/mesh/io/gmsh.hpp"

#include <algorithm>
#include <catch2/catch.hpp>

#include "asterism/core/random.hpp"
#include "asterism/mesh/audit/certificate.hpp"
#include "asterism/mesh/io/plain_meshes.hpp"
#include "asterism/tests/mesh/fixtures/temporary_directory.hpp"
#include "asterism/tests/mesh/io/sample_mesh.hpp"

using namespace asterism;
using namespace asterism::internal;
using tests::divided_mesh;
using tests::temporary_directory;

namespace {

mesh mesh_with_markers() {
  mesh m = divided_mesh(5);
  for (boundary_edge& e : m.boundary) e.marker -= 2;  // markers -1, 0, 1, 2, 3
  return m;
}

// Leaves out the segments of subsegments, for which a .msh file has no place.
mesh without_segments(mesh m) {
  for (std::size_t i = 0; i < m.boundary.size(); ++i)
    m.boundary[i].segment = static_cast<vertex_index>(i);
  return m;
}

}  // namespace

TEST_CASE("a .msh file of either version is read back to the last bit") {
  const temporary_directory here("gmsh");
  for (const auto version : {gmsh_version::two, gmsh_version::four}) {
    const mesh m = mesh_with_markers();
    const auto read = read_gmsh(here.write("m.msh", gmsh_text(m, {}, version)));
    INFO((read.ok() ? "" : read.failure().message));
    REQUIRE(read.ok());
    CHECK(read.value().has_metric);
    CHECK(mesh_fingerprint(without_segments(read.value().content)) ==
          mesh_fingerprint(without_segments(m)));
    CHECK(read.value().content.given == m.given);
    CHECK(read.value().content.regions == m.regions);
  }
}

TEST_CASE("physical names survive") {
  const temporary_directory here("gmsh-names");
  physical_names names;
  names.markers = {{2, "inlet of air"}, {3, "wall"}};
  names.regions = {{2, "steel"}};
  for (const auto version : {gmsh_version::two, gmsh_version::four}) {
    const auto read =
        read_gmsh(here.write("m.msh", gmsh_text(mesh_with_markers(), {names}, version)));
    REQUIRE(read.ok());
    CHECK(read.value().names.markers.at(2) == "inlet of air");
    CHECK(read.value().names.markers.at(3) == "wall");
    CHECK(read.value().names.regions.at(2) == "steel");
    CHECK(read.value().names.regions.at(-7) == "region -7");
  }
}

TEST_CASE("what a .msh file may not hold is refused with its line") {
  const temporary_directory here("gmsh-refused");
  const std::string good = gmsh_text(divided_mesh(2), {}, gmsh_version::two);
  const auto message = [&](const std::string& from, const std::string& to) {
    std::string text = good;
    const std::size_t at = text.find(from);
    REQUIRE(at != std::string::npos);
    const auto read = read_gmsh(here.write("m.msh", text.replace(at, from.size(), to)));
    REQUIRE_FALSE(read.ok());
    return read.failure().message;
  };
  using Catch::Contains;
  CHECK_THAT(message("2.2 0 8", "2.2 1 8"), Contains("m.msh:2: a binary file"));
  CHECK_THAT(message("2.2 0 8", "3 0 8"), Contains("4.0 and 4.1 can be read"));
  CHECK_THAT(message("$EndNodes", "$EndKnots"), Contains("$EndNodes wanted, not '$EndKnots'"));
  CHECK_THAT(message("\n2 1 -1 0\n", "\n1 1 -1 0\n"), Contains("node \"2\" does not exist") ||
                                                          Contains("is there twice") ||
                                                          Contains("metric"));
  CHECK_THAT(message("$Elements", "$Ignored\n$EndIgnored\n$Strange"), Contains("$EndStrange"));
}

TEST_CASE("elements of an entity that is not listed were in no group without a word") {
  const temporary_directory here("gmsh-unlisted");
  const auto notes_of = [&](const std::string& surface, const std::string& groups) {
    const auto read = read_gmsh(here.write(
        "m.msh", "$MeshFormat\n4.1 0 8\n$EndMeshFormat\n" + groups +
                     "$Nodes\n1 3 1 3\n2 1 0 3\n1\n2\n3\n0 0 0\n1 0 0\n0 1 0\n$EndNodes\n"
                     "$Elements\n1 1 1 1\n2 " +
                     surface + " 2 1\n1 1 2 3\n$EndElements\n"));
    REQUIRE(read.ok());
    return read.value().content.notes;
  };
  const std::string groups = "$Entities\n0 0 1 0\n1 0 0 0 1 1 0 1 7 0\n$EndEntities\n";
  CHECK(notes_of("1", groups).empty());
  CHECK(notes_of("2", "").empty());
  const auto notes = notes_of("2", groups);
  REQUIRE(notes.size() == 1);
  CHECK_THAT(notes[0], Catch::Contains("1, the first surface 2 on line 20"));
}

TEST_CASE("spoiled .msh files are read or refused, and nothing else") {
  const temporary_directory here("gmsh-spoiled");
  splitmix64 random(20);
  const auto below = [&](std::size_t n) { return static_cast<std::size_t>(random.bits() % n); };
  std::size_t refused = 0;
  for (const auto version : {gmsh_version::two, gmsh_version::four}) {
    const std::string good = gmsh_text(mesh_with_markers(), {}, version);
    for (int i = 0; i < 400; ++i) {
      std::string text = good;
      for (int k = 0; k < 3; ++k) text[below(text.size())] = "0123456789 -.$e\n"[below(16)];
      if (i % 4 == 0) text.resize(below(text.size()));
      const auto read = read_gmsh(here.write("m.msh", text));
      if (!read.ok()) {
        ++refused;
        CHECK_THAT(read.failure().message, Catch::Contains("m.msh"));
        continue;
      }
      const mesh& m = read.value().content;
      for (const triangle& t : m.triangles)
        CHECK(*std::max_element(t.begin(), t.end()) < m.sites.size());
    }
  }
  CHECK(refused > 200);
}

TEST_CASE("gmsh: the name of a section that has no end is shown without its control characters") {
  const temporary_directory here("gmsh-controls");
  const std::string head = "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n";
  const auto read = read_gmsh(here.write("m.msh", head + "$Nod\x1b[2Jes\n"));
  REQUIRE_FALSE(read.ok());
  CHECK_THAT(read.failure().message, Catch::EndsWith("m.msh:4: $EndNod?[2Jes is missing"));
}

TEST_CASE("SU2 gets the boundary alone, Triangle the edges inside too") {
  const mesh m = divided_mesh(3);
  const std::string su2 = su2_text(m, {.markers = {{2, "far field"}}, .regions = {}});
  CHECK_THAT(su2, Catch::Contains("NDIME= 2\nNELEM= 18\n5 ") && Catch::Contains("NMARK= 4\n") &&
                      Catch::Contains("MARKER_TAG= far_field\nMARKER_ELEMS= 3\n3 "));
  CHECK_THAT(edge_text(m), Catch::StartsWith("15 1\n1 "));
  CHECK_THAT(node_text(m), Catch::StartsWith("16 2 3 1\n1 -1 -1 "));
  CHECK_THAT(ele_text(m), Catch::StartsWith("18 3 1\n1 "));
}
