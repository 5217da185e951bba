// SPDX-License-Identifier: MIT
#include "asterism/mesh/io/file_kinds.hpp"

#include <catch2/catch.hpp>
#include <fstream>
#include <iterator>
#include <string>

#include "asterism/mesh/io/load_domain.hpp"
#include "asterism/mesh/io/mesh_format.hpp"
#include "asterism/mesh/io/read_mesh.hpp"

using namespace asterism;
using namespace asterism::internal;

namespace {

std::string yes_if(bool is_so) { return is_so ? " yes |" : " |"; }

// Returns the table as the manual must have it.
std::string table_of_kinds() {
  std::string table = "| extension | written | read | holds |\n|---|---|---|---|\n";
  for (const file_kind& kind : file_kinds())
    table += "| `" + std::string(kind.ending) + "` |" + yes_if(is_written_kind(kind)) +
             yes_if(is_mesh_kind(kind) || is_domain_kind(kind)) + " " + std::string(kind.holds) +
             " |\n";
  return table;
}

}  // namespace

TEST_CASE("the manual has the kinds of files that there are") {
  std::ifstream page(ASTERISM_DOCS "/manual/files.md");
  REQUIRE(page);
  const std::string text((std::istreambuf_iterator<char>(page)), std::istreambuf_iterator<char>());
  const std::string table = table_of_kinds();
  INFO("docs/manual/files.md is to have\n" << table);
  CHECK(text.find(table + "\n") != std::string::npos);
}

TEST_CASE("who reads and who writes a file agree with its row") {
  for (const file_kind& kind : file_kinds()) {
    const std::string name = "part" + std::string(kind.ending);
    INFO(name);
    CHECK(kind_of_file(name) == &kind);
    CHECK(is_mesh_file(name) == is_mesh_kind(kind));
    const auto format = mesh_format_of(name);
    CHECK(format.ok() == is_written_kind(kind));
    if (format) CHECK(kept_in(format.value()).second_order == holds_second_order(format.value()));
    // A file that does not exist is reported as missing, not as an unknown domain.
    const bool is_read = is_mesh_kind(kind) || is_domain_kind(kind);
    const auto loaded = load_domain("no/such/folder/" + name);
    REQUIRE_FALSE(loaded.ok());
    CHECK((loaded.failure().message.find("unknown domain") == std::string::npos) == is_read);
  }
  for (const char* const name : {"a.msh", "A.MSH2", "a.vtu"}) CHECK(holds_fields(name));
  for (const char* const name : {"a.mesh", "a.meshb", "a.vtk", "a.su2", "a.node", "a"})
    CHECK_FALSE(holds_fields(name));
  for (const char* const name : {"square", "naca0012", "a.poly"}) CHECK(is_domain_name(name));
  for (const char* const name : {"a.mesh", "a.png", "circle"}) CHECK_FALSE(is_domain_name(name));
  CHECK(kind_of_file("part.obj") == nullptr);
  CHECK(kind_of_file("PART.MESHB")->format == mesh_format::medit_binary);
}

TEST_CASE("errors list every kind of file") {
  const std::string written = mesh_format_of("a.stl").failure().message;
  const std::string loaded = load_domain("a.obj").failure().message;
  for (const file_kind& kind : file_kinds()) {
    INFO(kind.ending);
    const std::string ending(kind.ending);
    CHECK((written.find(ending) != std::string::npos) >= is_written_kind(kind));
    CHECK((loaded.find(ending) != std::string::npos) >=
          (is_mesh_kind(kind) || is_domain_kind(kind)));
  }
}
