// SPDX-License-Identifier: MIT
#include "asterism/mesh/draw/report.hpp"

#include <zlib.h>

#include <catch2/catch.hpp>
#include <cstring>
#include <limits>
#include <nlohmann/json.hpp>

#include "asterism/mesh/draw/packed_arrays.hpp"
#include "asterism/tests/mesh/io/sample_mesh.hpp"

using namespace asterism;
using internal::base64;
using internal::packed_arrays;
using tests::divided_mesh;
using tests::sample_mesh;

namespace {

std::string page_of(const mesh& m, const report_facts& facts = {}) {
  const auto page = report_page(m, facts);
  INFO((page.ok() ? "" : page.failure().message));
  REQUIRE(page.ok());
  return page.value();
}

// Returns the text of the page's script element with this identifier.
std::string part(const std::string& page, const std::string& id) {
  const std::size_t tag = page.find("id=\"" + id + "\">", page.find("</noscript>"));
  REQUIRE(tag != std::string::npos);
  const std::size_t begin = page.find('>', tag) + 1;
  return page.substr(begin, page.find("</script>", begin) - begin);
}

std::string bytes_of_base64(const std::string& text) {
  const std::string digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string bytes;
  unsigned group = 0, bits = 0;
  for (const char c : text) {
    if (c == '=') break;
    group = group << 6U | static_cast<unsigned>(digits.find(c));
    bits += 6;
    if (bits < 8) continue;
    bits -= 8;
    bytes += static_cast<char>(group >> bits & 255U);
  }
  return bytes;
}

std::string inflated(const std::string& compressed, std::size_t length) {
  std::string bytes(length, '\0');
  uLongf got = length;
  REQUIRE(uncompress(reinterpret_cast<Bytef*>(bytes.data()), &got,
                     reinterpret_cast<const Bytef*>(compressed.data()), compressed.size()) == Z_OK);
  REQUIRE(got == length);
  return bytes;
}

// Returns number i of an array stored in planes: first the first bytes of all numbers, then the
// second ones. `planes` has it from `start` on.
template <class Number>
Number number_at(const std::string& planes, std::size_t start, std::size_t length, std::size_t i) {
  char bytes[sizeof(Number)];
  for (std::size_t k = 0; k < sizeof(Number); ++k) bytes[k] = planes[start + k * length + i];
  Number number;
  std::memcpy(&number, bytes, sizeof(Number));
  return number;
}

}  // namespace

TEST_CASE("base64 is that of RFC 4648") {
  REQUIRE(base64("").empty());
  REQUIRE(base64("f") == "Zg==");
  REQUIRE(base64("fo") == "Zm8=");
  REQUIRE(base64("foobar") == "Zm9vYmFy");
  REQUIRE(base64("\xff\xff\xfe") == "///+");
}

TEST_CASE("a page holds every position and tensor as the double it is") {
  const mesh m = divided_mesh(7);
  const std::string page = page_of(m);
  const auto facts = nlohmann::json::parse(part(page, "facts"));
  REQUIRE(facts["vertices"] == m.sites.size());
  REQUIRE(facts["triangles"] == m.triangles.size());
  const std::size_t n = m.sites.size(), t = m.triangles.size(), b = m.boundary.size();
  const std::size_t metrics = 16 * n, corners = metrics + 24 * n, regions = corners + 12 * t;
  const std::string planes =
      inflated(bytes_of_base64(part(page, "data")), regions + 4 * t + 8 * b + 4 * b + b);
  for (std::size_t v = 0; v < n; ++v) {
    REQUIRE(number_at<double>(planes, 0, 2 * n, 2 * v) == m.sites[v].position.x);
    REQUIRE(number_at<double>(planes, 0, 2 * n, 2 * v + 1) == m.sites[v].position.y);
    REQUIRE(number_at<double>(planes, metrics, 3 * n, 3 * v + 1) == m.sites[v].metric.m12);
  }
  for (std::size_t k = 0; k < t; ++k) {
    REQUIRE(number_at<std::uint32_t>(planes, corners, 3 * t, 3 * k + 2) == m.triangles[k][2]);
    REQUIRE(number_at<std::int32_t>(planes, regions, t, k) == m.regions[k]);
  }
}

TEST_CASE("the same page twice has the same bytes") {
  REQUIRE(page_of(sample_mesh(5)) == page_of(sample_mesh(5)));
}

TEST_CASE("names from files cannot become markup, and braces in them are not filled in") {
  report_facts facts;
  facts.title = "</script><b>{{data}}";
  const std::string page = page_of(sample_mesh(2), facts);
  REQUIRE(page.find("</script><b>") == std::string::npos);
  REQUIRE_THAT(page, Catch::Contains("<title>&lt;/script>&lt;b>{{data}}"));
  REQUIRE(nlohmann::json::parse(part(page, "facts"))["title"] == facts.title);
}

TEST_CASE("a certificate of another mesh is told apart by its fingerprint") {
  const mesh m = sample_mesh(3);
  report_facts facts;
  facts.claim = certificate{};
  facts.claim->fingerprint = mesh_fingerprint(m);
  const auto is_of_this = [&] {
    return nlohmann::json::parse(part(page_of(m, facts), "facts"))["is_of_this_mesh"].get<bool>();
  };
  REQUIRE(is_of_this());
  facts.claim->fingerprint ^= 1;
  REQUIRE_FALSE(is_of_this());
}

TEST_CASE("a page loads nothing") {
  const std::string page = page_of(sample_mesh(3));
  REQUIRE_THAT(page, Catch::Contains("default-src 'none'"));
  for (const char* loads : {"src=", "href=\"http", "@import", "fetch(", "XMLHttp"})
    REQUIRE(page.find(loads) == std::string::npos);
}

TEST_CASE("a mesh that cannot be shown is refused with what is wrong") {
  REQUIRE_FALSE(report_page(mesh{}, {}).ok());
  mesh m = sample_mesh(2);
  m.sites[3].metric.m12 = std::numeric_limits<double>::infinity();
  REQUIRE(report_page(m, {}).failure().message == "vertex 4 is not finite");
  m = sample_mesh(2);
  REQUIRE_FALSE(report_page(m, {.wanted = {m.sites[0].metric}}).ok());
}

TEST_CASE("fields and the meshes before have their arrays, and their counts are told") {
  const mesh m = sample_mesh(3);
  report_facts facts;
  facts.fields.fields.push_back({"u", field_kind::vector, std::vector<double>(2 * m.sites.size())});
  const mesh earlier = sample_mesh(2);
  facts.before.push_back({"Before", earlier, {}, {}});
  facts.before[0].fields.fields.push_back(
      {"u", field_kind::scalar, std::vector<double>(earlier.sites.size(), 7)});
  const auto told = nlohmann::json::parse(part(page_of(m, facts), "facts"));
  REQUIRE(told["label"] == "After");
  REQUIRE(told["fields"][0]["components"] == 2);
  const auto& frame = told["frames"][0];
  REQUIRE(frame["label"] == "Before");
  REQUIRE(frame["triangles"] == earlier.triangles.size());
  const auto length_of = [&](const std::string& name) {
    for (const auto& entry : told["arrays"])
      if (entry["name"] == name) return entry["length"].get<std::size_t>();
    return std::size_t{0};
  };
  REQUIRE(length_of(told["fields"][0]["array"]) == 2 * m.sites.size());
  REQUIRE(length_of(frame["fields"][0]["array"]) == earlier.sites.size());
  REQUIRE(length_of("frame0.triangles") == 3 * earlier.triangles.size());
}

TEST_CASE("fields and meshes before that do not fit are refused by name") {
  const mesh m = sample_mesh(2);
  report_facts facts;
  facts.fields.fields.push_back({"pressure", field_kind::scalar, {1, 2}});
  REQUIRE_THAT(report_page(m, facts).failure().message, Catch::Contains("pressure"));
  facts.fields.fields.clear();
  facts.before.push_back({"round 3", mesh{}, {}, {}});
  REQUIRE_THAT(report_page(m, facts).failure().message, Catch::Contains("round 3: "));
}
