// SPDX-License-Identifier: MIT
#include "asterism/mesh/io/medit_binary.hpp"

#include <bit>
#include <catch2/catch.hpp>
#include <cstdint>
#include <fstream>

#include "asterism/core/random.hpp"
#include "asterism/mesh/audit/certificate.hpp"
#include "asterism/mesh/io/medit.hpp"
#include "asterism/mesh/io/read_mesh.hpp"
#include "asterism/mesh/io/solution_file.hpp"
#include "asterism/mesh/io/write_mesh.hpp"
#include "asterism/tests/mesh/fixtures/temporary_directory.hpp"
#include "asterism/tests/mesh/io/sample_mesh.hpp"

using namespace asterism;
using namespace asterism::internal;
using tests::sample_mesh;
using tests::temporary_directory;

namespace {

// Returns a file of any version and byte order, with a triangle, an edge with marker 7, and a
// section that readers pass over.
struct written_by_hand {
  written_by_hand(int version, bool swapped) : version_(version), swapped_(swapped) {
    put(1, 4);
    put(static_cast<std::uint64_t>(version), 4);
    head(3);
    put(2, 4);
    close();
    head(4);
    count(3);
    for (const auto& [x, y] : {std::pair{0.0, 0.0}, {1.5, 0.0}, {0.25, 2.0}}) {
      real(x);
      real(y);
      whole(0);
    }
    close();
    head(14);  // number of the section Ridges
    count(1);
    whole(1);
    close();
    head(6);
    count(1);
    for (const int n : {1, 2, 3, 4}) whole(n);
    close();
    head(5);
    count(1);
    for (const int n : {1, 2, -7}) whole(n);
    close();
    put(54, 4);
    put(0, place());
  }
  std::size_t place() const { return version_ > 2 ? 8 : 4; }
  void put(std::uint64_t value, std::size_t size) {
    for (std::size_t i = 0; i < size; ++i)
      bytes += static_cast<char>(value >> (8 * (swapped_ ? size - 1 - i : i)));
  }
  void whole(int n) { put(static_cast<std::uint64_t>(std::int64_t{n}), version_ > 3 ? 8 : 4); }
  void count(int n) { whole(n); }
  void real(double x) {
    if (version_ > 1)
      put(std::bit_cast<std::uint64_t>(x), 8);
    else
      put(std::bit_cast<std::uint32_t>(static_cast<float>(x)), 4);
  }
  void head(int code) {
    put(static_cast<std::uint64_t>(code), 4);
    open_ = bytes.size();
    put(0, place());
  }
  void close() {
    const std::string rest = bytes.substr(open_ + place());
    const std::uint64_t here = bytes.size();
    bytes.resize(open_);
    put(here, place());
    bytes += rest;
  }

  std::string bytes;

 private:
  int version_;
  bool swapped_;
  std::size_t open_ = 0;
};

}  // namespace

TEST_CASE("binary Medit files of every version and order of bytes are read") {
  for (const int version : {1, 2, 3, 4})
    for (const bool swapped : {false, true}) {
      INFO("version " << version << (swapped ? ", swapped" : ""));
      const auto text = text_of_medit_binary("a.meshb", written_by_hand(version, swapped).bytes);
      INFO((text.ok() ? "" : text.failure().message));
      REQUIRE(text.ok());
      CHECK(text.value() ==
            "MeshVersionFormatted 2\nDimension 2\nVertices\n3\n0 0 0\n1.5 0 0\n0.25 2 0\n"
            "Triangles\n1\n1 2 3 4\nEdges\n1\n1 2 -7\nEnd\n");
    }
}

TEST_CASE("a mesh comes back from its binary files as it was") {
  const temporary_directory folder("medit-binary");
  for (const mesh& m : {sample_mesh(5), sample_mesh(40)}) {
    const auto path = folder / "m.meshb";
    REQUIRE(write_mesh(path, m).ok());
    REQUIRE(write_mesh(folder / "m.mesh", m).ok());
    const auto read = read_mesh(path), text = read_mesh(folder / "m.mesh");
    INFO((read.ok() ? "" : read.failure().message));
    REQUIRE(read.ok());
    REQUIRE(text.ok());
    CHECK(mesh_fingerprint(read.value()) == mesh_fingerprint(text.value()));
  }
}

TEST_CASE("binary solutions come back as they were") {
  const temporary_directory folder("medit-binary");
  const mesh m = sample_mesh(5);
  solution s;
  s.vertices = m.sites.size();
  for (const field_kind kind : {field_kind::scalar, field_kind::vector, field_kind::tensor}) {
    solution_field f{std::to_string(s.fields.size() + 1), kind, {}};
    for (std::size_t i = 0; i < s.vertices * components_of(kind); ++i)
      f.values.push_back(0.1 * static_cast<double>(i) + 1);
    s.fields.push_back(f);
  }
  const auto path = folder / "s.solb";
  REQUIRE(write_solution(path, s).ok());
  const auto read = read_solution(path, m);
  INFO((read.ok() ? "" : read.failure().message));
  REQUIRE(read.ok());
  REQUIRE(read.value().fields.size() == 3);
  for (std::size_t i = 0; i < 3; ++i) CHECK(read.value().fields[i].values == s.fields[i].values);
}

TEST_CASE("cut off and changed binary files are refused or read, never more") {
  const std::string whole = written_by_hand(2, false).bytes;
  for (std::size_t size = 0; size < whole.size(); ++size) {
    const auto text = text_of_medit_binary("a.meshb", std::string_view(whole).substr(0, size));
    if (!text.ok()) CHECK(text.failure().message.find("a.meshb: byte ") == 0);
  }
  splitmix64 random(11);
  for (int i = 0; i < 20000; ++i) {
    std::string bytes = written_by_hand(1 + static_cast<int>(random.bits() % 4), i % 2 == 0).bytes;
    for (std::uint64_t k = random.bits() % 3 + 1; k > 0; --k)
      bytes[random.bits() % bytes.size()] = static_cast<char>(random.bits());
    const auto text = text_of_medit_binary("a.meshb", bytes);
    if (text.ok()) CHECK(text.value().size() < 100 * bytes.size());
  }
}
