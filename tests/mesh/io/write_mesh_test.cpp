// SPDX-License-Identifier: MIT
#include "asterism/mesh/io/write_mesh.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <fstream>
#include <iterator>

#include "asterism/mesh/io/file_output.hpp"
#include "asterism/mesh/io/vtu.hpp"
#include "asterism/mesh/io/vtu_mesh.hpp"
#include "asterism/mesh/io/vtu_numbers.hpp"
#include "asterism/tests/mesh/fixtures/temporary_directory.hpp"
#include "asterism/tests/mesh/io/sample_mesh.hpp"

using namespace asterism;
using namespace asterism::internal;
using tests::sample_mesh;
using tests::temporary_directory;

namespace {

std::string bytes_of(const std::filesystem::path& path) {
  std::ifstream in(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>()};
}

}  // namespace

TEST_CASE("the extension says the format") {
  REQUIRE(mesh_format_of("a.mesh").value() == mesh_format::medit);
  REQUIRE(mesh_format_of("dir.d/a.VTU").value() == mesh_format::vtu);
  REQUIRE(mesh_format_of("a.b.Png").value() == mesh_format::png);
  REQUIRE_THAT(mesh_format_of("a.stl").failure().message,
               Catch::Contains("a.stl: unknown kind of file '.stl'"));
  REQUIRE_FALSE(mesh_format_of("mesh").ok());
  REQUIRE_FALSE(mesh_format_of("").ok());
}

TEST_CASE("every format is written, replaces what was there, and leaves nothing else") {
  const temporary_directory here("write");
  for (const std::string name : {"m.mesh", "m.vtu", "m.svg", "m.png", "m.pdf"}) {
    here.write(name, "old");
    const auto written = write_mesh(here / name, sample_mesh(4));
    INFO((written.ok() ? "" : written.failure().message));
    REQUIRE(written.ok());
    REQUIRE(bytes_of(here / name).size() > 500);
    const std::string first = bytes_of(here / name);
    REQUIRE(write_mesh(here / name, sample_mesh(4)).ok());
    REQUIRE(bytes_of(here / name) == first);
  }
  REQUIRE(here.files() == 6);
}

TEST_CASE("places where nothing can be written are refused beforehand") {
  const temporary_directory here("refused");
  REQUIRE_THAT(check_output(here / "none/m.mesh").failure().message,
               Catch::Contains("there is no directory"));
  std::filesystem::create_directory(here / "m.svg");
  REQUIRE_THAT(check_output(here / "m.svg").failure().message,
               Catch::Contains("not a regular file"));
  std::filesystem::create_directory(here / "m.sol");
  REQUIRE_THAT(check_output(here / "m.mesh").failure().message, Catch::Contains("m.sol"));
  CHECK(check_output(here / "m.mesh").failure().code == error_code::unwritable_file);
  CHECK(check_output(here / "none/m.mesh").failure().code == error_code::unwritable_file);
  REQUIRE(check_output(here / "m.png").ok());
  REQUIRE_FALSE(write_mesh(here / "m.mesh", sample_mesh(2)).ok());
  REQUIRE(here.files() == 2);
}

TEST_CASE(
    "a file of somebody else's with the name of a temporary one was overwritten and removed") {
  const temporary_directory here("part");
  here.write("m.svg.part", "precious");
  std::filesystem::create_directory(here / "m.svg.part2");
  REQUIRE(write_mesh(here / "m.svg", sample_mesh(2)).ok());
  REQUIRE(bytes_of(here / "m.svg.part") == "precious");
  REQUIRE(here.files() == 3);
}

TEST_CASE("renamings before one that fails are undone") {
  const std::vector<std::string> names = {"a", "b", "c", "d"};
  for (const std::string& blocked : names)
    for (const bool had_files : {true, false}) {
      const temporary_directory here("undone");
      std::vector<output_file> files;
      for (const std::string& name : names) {
        if (had_files && name != blocked) here.write(name, "old " + name);
        files.push_back({here / name, "new " + name});
      }
      std::filesystem::create_directory(here / blocked);
      const auto written = write_files(files);
      REQUIRE_FALSE(written.ok());
      REQUIRE_THAT(written.failure().message, Catch::Contains("/" + blocked + ": Is a directory"));
      REQUIRE(std::filesystem::is_directory(here / blocked));
      REQUIRE(here.files() == (had_files ? names.size() : 1));
      for (const std::string& name : names)
        if (had_files && name != blocked) REQUIRE(bytes_of(here / name) == "old " + name);
    }
}

TEST_CASE("a link to a file is followed, and both are kept where writing fails") {
  const temporary_directory here("link");
  here.write("kept", "kept");
  std::filesystem::create_symlink("kept", here / "a");
  std::filesystem::create_directory(here / "b");
  REQUIRE_FALSE(write_files({{here / "a", "new"}, {here / "b", "new"}}).ok());
  REQUIRE(std::filesystem::is_symlink(here / "a"));
  REQUIRE(bytes_of(here / "kept") == "kept");
  REQUIRE(write_files({{here / "a", "new"}}).ok());
  REQUIRE(std::filesystem::is_symlink(here / "a"));
  REQUIRE(bytes_of(here / "kept") == "new");
}

TEST_CASE("a mesh whose numbers are wrong is not written") {
  const temporary_directory here("wrong");
  mesh m = sample_mesh(2);
  m.triangles[1][2] = 99;
  REQUIRE_THAT(write_mesh(here / "m.vtu", m).failure().message, Catch::Contains("missing site"));
  CHECK(write_mesh(here / "m.vtu", m).failure().code == error_code::invalid_mesh);
  m = sample_mesh(2);
  m.sites[3].position.x = std::nan("");
  REQUIRE_FALSE(write_mesh(here / "m.png", m).ok());
  REQUIRE(here.files() == 0);
}

namespace {

std::string vtu_bytes(const mesh& m) {
  return internal::bytes_of([&m](const byte_sink& put) { write_vtu(m, {}, put); });
}

// Returns the numbers of an array of integers, fewer than 64.
std::vector<double> integers_of(const std::string& file, const std::string& name) {
  const std::size_t tag = file.find("Name=\"" + name + "\"");
  const std::size_t begin = file.find(">\n", tag) + 2;
  const std::string text = file.substr(begin, file.find('\n', begin) - begin);
  const auto bytes = static_cast<unsigned char>(decode_base64(text, 8)[0]);
  const auto read = vtu_binary_numbers(text, "Int32", bytes / 4U, {false, true}, false);
  REQUIRE(read.ok());
  return read.value();
}

}  // namespace

TEST_CASE("a .vtu file has the regions, 1 when there are none") {
  REQUIRE(integers_of(vtu_bytes(sample_mesh(1)), "region") == std::vector<double>{1, 1});
  REQUIRE(integers_of(vtu_bytes(tests::divided_mesh(1)), "region") == std::vector<double>{-7, 2});
}

TEST_CASE("a .vtu file is text all through, as readers of XML want it") {
  const std::string text = vtu_bytes(sample_mesh(5));
  CHECK(std::all_of(text.begin(), text.end(),
                    [](char c) { return c == '\n' || (c >= ' ' && c <= '~'); }));
  CHECK(text.find("AppendedData") == std::string::npos);
  // Arrays longer than one block of the encoder, and of lengths that 3 does not divide.
  const mesh m = sample_mesh(60);
  const auto read = read_vtu_mesh(vtu_bytes(m), "m.vtu");
  REQUIRE(read.ok());
  REQUIRE(read.value().content.sites.size() == m.sites.size());
  CHECK(read.value().content.sites.back().position == m.sites.back().position);
}

TEST_CASE("a mesh with more or fewer regions than triangles is not written") {
  const temporary_directory here("regions");
  mesh m = sample_mesh(2);
  m.regions = {1, 2};
  REQUIRE_THAT(write_mesh(here / "m.mesh", m).failure().message,
               Catch::Contains("not as many regions as triangles"));
  REQUIRE(here.files() == 0);
}

TEST_CASE("a .vtu file marks disagreeing triangles") {
  mesh m = sample_mesh(2);
  m.disagreeing.push_back(m.triangles.back());
  m.triangles.pop_back();
  const std::string text = vtu_bytes(m);
  REQUIRE_THAT(text, Catch::Contains("NumberOfPoints=\"9\" NumberOfCells=\"8\""));
  REQUIRE(integers_of(text, "disagreeing") == std::vector<double>{0, 0, 0, 0, 0, 0, 0, 1});
}
