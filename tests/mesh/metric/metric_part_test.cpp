// SPDX-License-Identifier: MIT
//
// Inside its window a part of a field equals the whole field bit for bit. Beyond its margin,
// evaluating it is an error.
#include "asterism/mesh/metric/metric_part.hpp"

#include <catch2/catch.hpp>
#include <memory>
#include <string>

#include "asterism/mesh/metric/constant_field.hpp"
#include "asterism/mesh/metric/interpolated_field.hpp"
#include "fixtures/audit_meshes.hpp"

using namespace asterism;
using namespace asterism::internal;
using namespace asterism::test;

namespace {

// Unit cells on [0, 12] x [0, 12] with tensors at random.
mesh random_background() {
  patch p = make_patch(12);
  splitmix64 random(11);
  for (site& s : p.m.sites) s.metric = {random.real(1, 90), random.real(-1, 1), 2};
  return p.m;
}

bounding_box box_of_background(const mesh& m) {
  bounding_box box{m.sites[0].position, m.sites[0].position};
  for (const site& s : m.sites) box.include(s.position);
  return box;
}

}  // namespace

TEST_CASE("a part has the tensors of the whole field in its window, also as bytes") {
  const mesh background = random_background();
  const bounding_box whole = box_of_background(background);
  const auto field = make_interpolated_field(background, 0.3);
  splitmix64 random(5);
  INFO("splitmix64 5");
  for (int turn = 0; turn < 40; ++turn) {
    bounding_box window{{random.real(whole.low.x, whole.high.x), whole.low.y}, whole.high};
    window.high.x = random.real(window.low.x, whole.high.x);
    const auto part = part_of(*field, window);
    REQUIRE(part.has_value());
    CHECK(part->given.triangles.size() <= background.triangles.size());
    const auto read = metric_part_in(bytes_of(*part), "a part");
    REQUIRE(read.ok());
    const auto small = make_field_of_part(read.value());
    for (const triangle& t : background.triangles) {
      const point &a = background.sites[t[0]].position, &b = background.sites[t[1]].position,
                  &c = background.sites[t[2]].position;
      const double u = random.real(0, 1), v = random.real(0, 1 - u);
      const point q{a.x + u * (b.x - a.x) + v * (c.x - a.x),
                    a.y + u * (b.y - a.y) + v * (c.y - a.y)};
      if (q.x < window.low.x || q.x > window.high.x) continue;
      const auto one = field->at(q), other = small->at(q);
      REQUIRE(one.ok());
      REQUIRE(other.ok());
      REQUIRE(identical(one.value(), other.value()));
    }
  }
}

TEST_CASE("a part fails where no triangle is within its margin") {
  const mesh background = random_background();
  const bounding_box whole = box_of_background(background);
  const double width = whole.high.x - whole.low.x;
  const auto field = make_interpolated_field(background);
  bounding_box window = whole;
  window.high.x += width;  // one width beyond the mesh; the margin is a quarter
  const auto part = part_of(*field, window);
  REQUIRE(part.has_value());
  const auto small = make_field_of_part(*part);
  const double middle = (whole.low.y + whole.high.y) / 2;
  CHECK(small->at({whole.high.x + width / 8, middle}).ok());
  const auto far = small->at({whole.high.x + width * 0.9, middle});
  REQUIRE_FALSE(far.ok());
  CHECK(far.failure().message.find("no triangle within") != std::string::npos);
  window = {{whole.high.x + 9 * width, whole.low.y}, {whole.high.x + 10 * width, whole.high.y}};
  const auto none = part_of(*field, window);
  REQUIRE(none.has_value());
  CHECK(none->given.triangles.empty());
  CHECK_FALSE(make_field_of_part(*none)->at(window.low).ok());
}

TEST_CASE("bytes of a part that were cut off or changed are refused") {
  const auto field = make_interpolated_field(random_background());
  const auto part = part_of(*field, {{0, 0}, {1, 1}});
  REQUIRE(part.has_value());
  const std::string bytes = bytes_of(*part);
  for (std::size_t length = 0; length < bytes.size(); length += 1 + bytes.size() / 97)
    CHECK_FALSE(metric_part_in(bytes.substr(0, length), "a part").ok());
  CHECK_FALSE(metric_part_in(bytes + "x", "a part").ok());
  std::string other = bytes;
  other.back() = '\x7f';  // makes the number of a corner invalid
  CHECK_FALSE(metric_part_in(other, "a part").ok());
}

TEST_CASE("a formula has no parts") {
  CHECK_FALSE(part_of(*same_everywhere({1, 0, 1}), {{0, 0}, {1, 1}}).has_value());
}
