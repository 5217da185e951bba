// SPDX-License-Identifier: MIT
//
// Moves nodes to places with better angles in the wanted metric.
#include "asterism/mesh/adapt/vertex_smoothing.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <vector>

#include "asterism/mesh/adapt/unit_mesh.hpp"
#include "asterism/mesh/mesher.hpp"
#include "fixtures/mesh_disorder.hpp"
#include "fixtures/mesh_to_change.hpp"
#include "fixtures/thread_arena.hpp"

using namespace asterism;
using namespace asterism::internal;
using namespace asterism::internal::adapting;

namespace {

constexpr double bound = 20, unit = 0.25;

// A mesh of the square that is certified in the identity.
editable_mesh even_mesh(const domain& d) {
  const auto field = make_metric_field("identity", d.box(), unit);
  mesh_options options;
  options.limit_size = true;
  return mesh_to_change(d, *field.value(), options);
}

// Ratio of lengths along x to those along y. Areas stay the same.
vertex_smoothing::wanted_at stretched_by(double times, double length = unit) {
  return [times, length](const point&, vertex_index&) {
    return metric_tensor{times / (length * length), 0, 1 / times / (length * length)};
  };
}

// A mesh of the square with edges of about this length, all of which agree in the identity.
editable_mesh fine_mesh(const domain& d, double length) {
  editable_mesh m = coarse_mesh(d);
  unit_mesh_options making;
  making.count = static_cast<std::size_t>(4 / (length * length));
  unit_mesh_remesher(m, making).run(
      [length](const point&, vertex_index&) {
        return metric_tensor{1 / (length * length), 0, 1 / (length * length)};
      },
      {});
  return m;
}

std::vector<point> places_of(const editable_mesh& m) {
  std::vector<point> places;
  for (const node& n : m.nodes()) places.push_back(n.position);
  return places;
}

// Counts the nodes with an angle below the bound in the metric.
std::size_t count_low(const editable_mesh& m, const vertex_smoothing::wanted_at& wanted) {
  std::vector<char> is_low(m.nodes().size(), 0);
  vertex_index hint = 0;
  for (const face& f : m.faces()) {
    if (!f.exists()) continue;
    const node &a = m.at(f.v[0]), &b = m.at(f.v[1]), &c = m.at(f.v[2]);
    for (const vertex_index v : f.v) {
      const metric_tensor as = wanted(m.at(v).position, hint);
      if (greatest_cotangent(as, plain_root_of_determinant(as), a, b, c) > cotangent_of(bound))
        is_low[v] = 1;
    }
  }
  return static_cast<std::size_t>(std::count(is_low.begin(), is_low.end(), char{1}));
}

}  // namespace

TEST_CASE("nodes that are moved have fewer low angles in the metric wanted, and agree as before") {
  const domain d = square();
  editable_mesh m = even_mesh(d);
  const auto wanted = stretched_by(3);
  const std::size_t before = count_low(m, wanted);
  REQUIRE(before > 0);
  REQUIRE(count_disorder(m, bound) == 0);
  std::vector<metric_tensor> tensors;
  for (const node& n : m.nodes()) tensors.push_back(n.metric);
  vertex_smoothing settled(m, bound, 1, wanted);
  CHECK_FALSE(settled.is_in_vain());
  settled.run({});
  CHECK(count_low(m, wanted) < before);
  CHECK(count_disorder(m, bound) == 0);
  for (vertex_index v = 0; v < tensors.size(); ++v) CHECK(identical(m.at(v).metric, tensors[v]));
}

TEST_CASE("nodes stay where the metric wanted is the one they have") {
  const domain d = square();
  editable_mesh m = even_mesh(d);
  const std::vector<point> places = places_of(m);
  vertex_smoothing settled(m, bound, 1, stretched_by(1));
  CHECK_FALSE(settled.is_in_vain());
  settled.run({});
  std::size_t moved = 0;
  for (vertex_index v = 0; v < places.size(); ++v)
    if (!(m.at(v).position == places[v])) ++moved;
  CHECK(10 * moved < places.size());
}

TEST_CASE("settling is in vain where the metric wanted finds nearly all angles far too low") {
  const domain d = square();
  editable_mesh m = even_mesh(d);
  CHECK(vertex_smoothing(m, bound, 1, stretched_by(30)).is_in_vain());
}

TEST_CASE("nodes of a mesh of several parts get the same places on any number of threads",
          "[threads]") {
  constexpr double length = 0.01;
  const domain d = square();
  const editable_mesh before = fine_mesh(d, length);
  REQUIRE(before.count() > 35000);
  const std::vector<point> places = places_of(before);
  const auto wanted = stretched_by(3, length);
  std::vector<std::vector<point>> made;
  for (const int threads : {1, 2, 3, 7}) {
    editable_mesh m = before;
    with_threads(threads, [&] { vertex_smoothing(m, bound, 1, wanted).run({}); });
    made.push_back(places_of(m));
    INFO(threads << " threads");
    CHECK(made.front() == made.back());
    CHECK(made.back() != places);
    CHECK(count_low(m, wanted) < count_low(before, wanted));
    CHECK(count_disorder(m, bound) == count_disorder(before, bound));
  }
}
