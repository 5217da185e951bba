// SPDX-License-Identifier: MIT
#include "asterism/mesh/refine/coarser_mesh.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <optional>
#include <string>

#include "asterism/mesh/support/cancellation.hpp"

using namespace asterism;
using namespace asterism::internal;

namespace {

class same_tensor : public metric_field {
 public:
  explicit same_tensor(const metric_tensor& m) : m_(m) {}
  result<metric_tensor> at(const point&) const override { return m_; }

 private:
  metric_tensor m_;
};

}  // namespace

TEST_CASE("coarser meshes: the metric is divided by a power of two and restored without loss") {
  const metric_tensor m{3.7, -0.1, 5.3};
  const same_tensor field(m);
  for (const int halvings : {1, 2, 7}) {
    const auto coarse = coarser_field(field, halvings).at({0, 0});
    REQUIRE(coarse.ok());
    CHECK(coarse.value().m11 == std::scalbn(m.m11, -halvings));
    mesh_outcome made;
    made.result.sites = {{{1, 2}, coarse.value()}};
    made.ended.tolerance = 1;
    made.ended.steep = steep_place{1, {1, 2}, 3};
    restore_lengths(halvings, made);
    CHECK(made.result.sites[0].metric == m);
    CHECK(made.ended.tolerance == Approx(std::exp2(halvings / 2.0)).epsilon(1e-15));
    CHECK(made.ended.steep->spacing == Approx(3 * std::exp2(halvings / 2.0)).epsilon(1e-15));
    CHECK(made.ended.steep->at == point{1, 2});
  }
}

TEST_CASE("coarser meshes: a tensor that leaves the range of doubles is refused") {
  const same_tensor field({1, 0x1p-1000 * (1 + 0x1p-52), 1});
  const auto coarse = coarser_field(field, 100).at({0, 0});
  REQUIRE_FALSE(coarse.ok());
  CHECK(coarse.failure().code == error_code::invalid_metric);
}

TEST_CASE("cancellation: none asks for an end, one that does says why") {
  CHECK_FALSE(cancellation().poll());
  int asked = 0;
  cancellation third = [&]() -> std::optional<std::string> {
    if (++asked < 3) return std::nullopt;
    return "enough";
  };
  CHECK_FALSE(third.poll());
  CHECK_FALSE(third.is_requested());
  CHECK(third.poll() == "enough");
  CHECK(asked == 3);
}
