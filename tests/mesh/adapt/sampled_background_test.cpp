// SPDX-License-Identifier: MIT
//
// Samples a metric on a triangulation: the interpolated metric is near the given one half way along
// every edge, sampling ends where the metric jumps, and returns nothing where it fails.
#include "asterism/mesh/adapt/sampled_background.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <set>
#include <utility>

#include "asterism/mesh/delivery/background.hpp"
#include "asterism/mesh/gradation/nodal_gradation.hpp"
#include "asterism/mesh/mesher.hpp"
#include "asterism/mesh/metric/background_metric.hpp"
#include "asterism/mesh/numerics/metric_algebra.hpp"
#include "fixtures/domain_kinds.hpp"

using namespace asterism;
using namespace asterism::internal;
using namespace asterism::internal::adapting;
using namespace asterism::testing;

namespace {

const formula_field flat([](const point&) { return metric_tensor{1, 0, 1}; });

editable_mesh coarse_square(const domain& d) {
  const auto start = coarse_mesh(d, flat, {});
  REQUIRE(start);
  auto built = editable_mesh::build(d, *start);
  REQUIRE(built.ok());
  return std::move(built).value();
}

const formula_field front([](const point& q) {
  const double across = 0.02 + std::abs(q.x - 0.3 * q.y * q.y);
  return metric_tensor{1 / (across * across), 0, 4};
});

class failing_on_the_right final : public metric_field {
 public:
  result<metric_tensor> at(const point& q) const override {
    if (q.x > 0.5) return error{"on the right"};
    return metric_tensor{1, 0, 1};
  }
};

// A field that counts its evaluations, and those at places that were not announced to it.
class attentive_field final : public metric_field {
 public:
  explicit attentive_field(const metric_field& field) : field_(&field) {}
  result<metric_tensor> at(const point& q) const override {
    ++asked;
    if (expected_.count({q.x, q.y}) == 0) ++unexpected;
    return field_->at(q);
  }
  void expect(const std::function<std::vector<point>()>& places) const override {
    ++calls;
    for (const point& q : places()) expected_.insert({q.x, q.y});
  }
  mutable std::size_t asked = 0, unexpected = 0, calls = 0;

 private:
  const metric_field* field_;
  mutable std::set<std::pair<double, double>> expected_;
};

}  // namespace

TEST_CASE("a sampled metric is near to the one wanted half way along every edge") {
  const domain d = accepted(square());
  sampling_limits limits;
  const auto sampled = sample_background(coarse_square(d), front, limits);
  REQUIRE(sampled);
  CHECK(sampled->nodes.sites.size() < limits.most_nodes);
  const background_metric graph(sampled->nodes);
  for (const graph_edge& e : graph.edges()) {
    const point &p = graph.places()[e.a], &q = graph.places()[e.b];
    const point middle{(p.x + q.x) / 2, (p.y + q.y) / 2};
    const metric_tensor wanted = front.at(middle).value();
    const double length = std::sqrt(squared(wanted, q.x - p.x, q.y - p.y));
    CHECK(length <= limits.longest);
    vertex_index hint = 0;
    if (length > limits.shortest)
      CHECK(log_distortion(graph.at(middle, hint), wanted) <= limits.difference * 1.001);
  }
}

TEST_CASE("sampling a metric that jumps ends") {
  const domain d = accepted(square());
  const formula_field jump([](const point& q) {
    return q.x < 0.1 ? metric_tensor{1e4, 0, 1} : metric_tensor{1, 0, 100};
  });
  sampling_limits limits;
  const auto sampled = sample_background(coarse_square(d), jump, limits);
  REQUIRE(sampled);
  CHECK(sampled->nodes.sites.size() < limits.most_nodes);
}

TEST_CASE("sampling a metric that fails gives nothing") {
  const domain d = accepted(square());
  CHECK_FALSE(sample_background(coarse_square(d), failing_on_the_right(), {}));
}

TEST_CASE("most places at which a metric is sampled are announced in a few calls") {
  const domain d = accepted(square());
  const attentive_field told(front);
  const auto sampled = sample_background(coarse_square(d), told, {});
  REQUIRE(sampled);
  CHECK(sampled->nodes.sites == sample_background(coarse_square(d), front, {})->nodes.sites);
  INFO(told.asked << " asked, " << told.unexpected << " unexpected, " << told.calls << " calls");
  CHECK(told.asked < 20'000);  // each place once
  CHECK(told.unexpected + told.calls < told.asked / 5);
}
