// SPDX-License-Identifier: MIT
#include "asterism/mesh/metric/local_sizes.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "asterism/core/random.hpp"
#include "asterism/mesh/domain/built_in_domains.hpp"
#include "asterism/mesh/domain/check_domain.hpp"
#include "asterism/mesh/domain/point_in_domain.hpp"
#include "asterism/mesh/metric/make_metric_field.hpp"
#include "asterism/mesh/metric/wall_layers.hpp"
#include "asterism/mesh/pipeline/layer_rows.hpp"

using namespace asterism;
using namespace asterism::internal;

namespace {

// The square [-1,1]^2 with a line x = 0 between region 1 on its left and region 2.
domain two_halves() {
  domain d;
  d.vertices = {{-1, -1}, {0, -1}, {1, -1}, {1, 1}, {0, 1}, {-1, 1}};
  d.segments = {{0, 1, 1}, {1, 2, 1}, {2, 3, 2}, {3, 4, 3}, {4, 5, 3}, {5, 0, 4}, {1, 4, 9}};
  d.regions = {{{-0.5, 0}, 1}, {{0.5, 0}, 2}};
  auto checked = check_domain(d);
  REQUIRE(checked);
  return checked.value();
}

size_wishes wishes_of(const std::string& text) {
  auto wishes = size_wishes_of(text);
  REQUIRE(wishes);
  return wishes.value();
}

std::unique_ptr<metric_field> field_of(const std::string& text, const domain& d, double size = 1,
                                       const std::string& metric = "identity") {
  auto field = with_local_sizes(std::move(make_metric_field(metric, d.box(), size)).value(), d,
                                wishes_of(text));
  REQUIRE(field);
  return std::move(field).value();
}

double size_at(const metric_field& field, const point& q) {
  return 1 / std::sqrt(field.at(q).value().m11);
}

TEST_CASE("sizes are read, written and read again as they were", "[size_wishes]") {
  const std::string text =
      "at 0.1,-2,0.3:0.01,1.3; box 0,0,1,2:0.1,1.5; in 3:0.2,1.3; near -2:0.01,1.2; "
      "layers 2:1e-05,1.2,12; layers 4:0.001,1.1; hmin 0.001; hmax 2; aspect 100";
  CHECK(text_of(wishes_of(text)) == text);
  CHECK(text_of(wishes_of("at 0,0,0:1")) == "at 0,0,0:1,1.3");
  CHECK(text_of(wishes_of("box 1,2,0,0:1")) == "box 0,0,1,2:1,1.3");
  CHECK(text_of(size_wishes{}) == "none");
  CHECK(wishes_of("none").is_empty());
}

TEST_CASE("what is no size is refused in words", "[size_wishes]") {
  const std::vector<std::pair<std::string, std::string>> wrong = {
      {"at 1,2:3", "R is missing"},
      {"at 1,2,3", "no ':'"},
      {"at 1,2,-1:3", "R: '-1'"},
      {"at 1,2,3:0", "H: '0'"},
      {"at 1,2,3:1,0.5", "GROWTH: '0.5'"},
      {"at 1,2,3,4:1", "'4' is too much"},
      {"in wall:1", "REGION"},
      {"in 1.5:1", "REGION is no whole number"},
      {"layers 1:0.1", "GROWTH is missing"},
      {"layers 1:0.1,1.2,0", "N: '0'"},
      {"everywhere 1:1", "no kind of size"},
      {"hmin x", "'x'"},
      {"", "no ':'"}};
  for (const auto& [text, words] : wrong) {
    const auto made = size_wishes_of(text);
    REQUIRE_FALSE(made);
    CHECK_THAT(made.failure().message, Catch::Contains(words));
  }
}

TEST_CASE("sizes grow from their places by the distance", "[local_sizes]") {
  const domain d = two_halves();
  const auto at = field_of("at 0.5,0.5,0.1:0.01,1.2", d);
  CHECK(size_at(*at, {0.5, 0.6}) == Approx(0.01));
  CHECK(size_at(*at, {0.5, 0.8}) == Approx(0.01 + 0.2 * 0.2));
  const auto box = field_of("box 0,0,0.5,0.5:0.02", d);
  CHECK(size_at(*box, {0.2, 0.3}) == Approx(0.02));
  CHECK(size_at(*box, {0.8, 0.9}) == Approx(0.02 + 0.3 * 0.5));
  const auto near = field_of("near 3:0.02,1.5", d);
  CHECK(size_at(*near, {0.3, 1}) == Approx(0.02));
  CHECK(size_at(*near, {-0.3, 0.5}) == Approx(0.02 + 0.5 * 0.5));
  const auto in = field_of("in 2:0.05,1.4", d);
  CHECK(size_at(*in, {0.3, 0.2}) == Approx(0.05));
  CHECK(size_at(*in, {-0.5, 0.2}) == Approx(0.05 + 0.4 * 0.5));
}

TEST_CASE("the finest size counts, and bounds hold for all", "[local_sizes]") {
  const domain d = two_halves();
  const auto both = field_of("at 0,0,0:0.1,2; near 4:0.05,2; hmin 0.08; hmax 0.5", d);
  CHECK(size_at(*both, {0, 0}) == Approx(0.1));
  CHECK(size_at(*both, {-1, 0}) == Approx(0.08));
  CHECK(size_at(*both, {1, 1}) == Approx(0.5));
  const auto slim = field_of("aspect 2", d, 0.1, "expr:100;0;1");
  const metric_tensor m = slim->at({0, 0}).value();
  CHECK(std::sqrt(m.m11 / m.m22) == Approx(2));
}

TEST_CASE("where nothing has to change a tensor keeps its bits", "[local_sizes]") {
  const domain d = two_halves();
  const auto plain = make_metric_field("swirl:7", d.box(), 0.01);
  const auto field = field_of("near 2:0.5; hmax 3", d, 0.01, "swirl:7");
  splitmix64 random(3);
  for (int k = 0; k < 100; ++k) {
    const point q{2 * random.real() - 1, 2 * random.real() - 1};
    CHECK(field->at(q).value() == plain.value()->at(q).value());
  }
}

TEST_CASE("markers and regions that are not there are named with those that are", "[local_sizes]") {
  const domain d = two_halves();
  const auto refused = [&](const std::string& text) {
    auto base = make_metric_field("identity", d.box());
    auto made = with_local_sizes(std::move(base).value(), d, wishes_of(text));
    REQUIRE_FALSE(made);
    return made.failure().message;
  };
  CHECK(refused("near 7:1") == "no segment has the marker 7; the markers there are: 1, 2, 3, 4, 9");
  CHECK(refused("layers 7:1,1.2") ==
        "no segment has the marker 7; the markers there are: 1, 2, 3, 4, 9");
  CHECK(refused("in 7:1") == "there is no region 7; the regions there are: 1, 2");
  CHECK(refused("hmin 2; hmax 1") == "hmin 2 is not less than hmax 1");
}

TEST_CASE("layers shorten across the wall alone", "[local_sizes]") {
  const domain d = two_halves();
  const double edge = 2 / std::sqrt(3.0);  // edge of an equilateral triangle of height 1
  const auto field = field_of("layers 3:0.01,1.2", d, 0.3);
  const metric_tensor m = field->at({0.5, 0.9}).value();
  CHECK(1 / std::sqrt(m.m22) == Approx(edge * (0.01 + 0.2 * 0.1)));
  CHECK(m.m12 == Approx(0).margin(1e-9));
  CHECK(1 / std::sqrt(m.m11) <= 0.3 * (1 + 1e-12));
  // Layers on both sides of an internal segment.
  const auto inner = field_of("layers 9:0.01,1.2", d, 0.3);
  for (const double x : {-0.05, 0.05})
    CHECK(1 / std::sqrt(inner->at({x, 0}).value().m11) == Approx(edge * (0.01 + 0.2 * 0.05)));
}

TEST_CASE("after their number heights of layers grow as usual", "[local_sizes]") {
  const boundary_layers three{1, 1, 1.1, 3};
  const double edge = 2 / std::sqrt(3.0), end = 1 + 1.1 + 1.21, last = 1.331;
  CHECK(edge_across(three, 0.5) == Approx(edge * 1.05));
  CHECK(edge_across(three, end) == Approx(edge * last));
  CHECK(edge_across(three, end + 2) == Approx(edge * (last + 0.6)));
  CHECK(edge_across({1, 1, 1.1}, end + 2) == Approx(edge * (1 + 0.1 * (end + 2))));
}

TEST_CASE("the first row is at the height asked for, and leaves out where there is no room",
          "[layer_rows]") {
  const domain d = two_halves();
  const size_wishes wishes = wishes_of("layers 2:0.02,1.2; layers 3:0.02,1.2");
  const auto field = field_of("layers 2:0.02,1.2; layers 3:0.02,1.2", d, 0.2);
  const auto made = with_layer_rows(d, wishes, *field, 1000);
  REQUIRE(made);
  const std::vector<point>& all = made.value().vertices;
  REQUIRE(all.size() > d.vertices.size() + 20);
  for (std::size_t v = d.vertices.size(); v < all.size(); ++v) {
    CHECK(contains(d, all[v]));
    const double right = 1 - all[v].x, top = 1 - all[v].y;
    CHECK((right == Approx(0.02) || top == Approx(0.02)));
    CHECK(std::min(right, top) >= 0.018);
  }
  CHECK(with_layer_rows(d, wishes, *field, 5).value().vertices.size() <= d.vertices.size() + 5);
}

TEST_CASE("an index finds inside what looking at all segments does", "[inside_index]") {
  const domain d = airfoil().value();
  const domain halves = two_halves();
  const inside_index inside(d), right(halves, 2), none(halves, 5);
  splitmix64 random(9);
  for (int k = 0; k < 2000; ++k) {
    const point q{1.2 * random.real() - 0.1, 0.2 * random.real() - 0.1};
    CHECK(inside.contains(q) == contains(d, q));
    CHECK(right.contains(q) == (q.x > 0 && q.x < 1));
  }
  for (const point& q : d.vertices) CHECK_FALSE(inside.contains(q));
  CHECK(none.is_empty());
}

}  // namespace
