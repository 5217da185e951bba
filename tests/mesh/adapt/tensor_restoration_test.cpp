// SPDX-License-Identifier: MIT
//
// Restores wanted tensors at the nodes of a mesh, and undoes that.
#include "asterism/mesh/adapt/tensor_restoration.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <string>

#include "asterism/mesh/gradation/nodal_gradation.hpp"
#include "asterism/mesh/mesher.hpp"
#include "fixtures/mesh_disorder.hpp"
#include "fixtures/mesh_to_change.hpp"

using namespace asterism;
using namespace asterism::internal;
using namespace asterism::internal::adapting;

namespace {

constexpr double bound = 20;

// A mesh that is certified in the metric of the formula.
editable_mesh certified_mesh_in(const domain& d, const std::string& metric, double size) {
  const auto field = make_metric_field(metric, d.box(), size);
  mesh_options options;
  options.limit_size = true;
  return mesh_to_change(d, *field.value(), options);
}

std::vector<metric_tensor> tensors_of(const editable_mesh& m) {
  std::vector<metric_tensor> all;
  for (const node& n : m.nodes()) all.push_back(n.metric);
  return all;
}

std::size_t differing(const editable_mesh& m, const std::vector<metric_tensor>& from) {
  std::size_t count = 0;
  for (vertex_index v = 0; v < from.size(); ++v)
    if (!identical(m.at(v).metric, from[v])) ++count;
  return count;
}

}  // namespace

TEST_CASE("tensors that a mesh agrees in are given back to the last bit") {
  const domain d = square();
  editable_mesh m = certified_mesh_in(d, "swirl:3", 0.3);
  const std::vector<metric_tensor> wanted = tensors_of(m);
  // A metric with slightly longer lengths along x everywhere: stars agree in it nearly everywhere,
  // too.
  for (vertex_index v = 0; v < wanted.size(); ++v)
    m.set_metric(v, {1.05 * wanted[v].m11, wanted[v].m12, wanted[v].m22});
  tensor_restoration giving(m, bound, wanted);
  giving.run({});
  CHECK(differing(m, wanted) < wanted.size() / 2);
}

TEST_CASE("what was given is taken back once, and kept from then on") {
  const domain d = square();
  editable_mesh m = certified_mesh_in(d, "swirl:3", 0.3);
  const std::vector<metric_tensor> wanted = tensors_of(m);
  for (vertex_index v = 0; v < wanted.size(); ++v)
    m.set_metric(v, {1.05 * wanted[v].m11, wanted[v].m12, wanted[v].m22});
  const std::vector<metric_tensor> before = tensors_of(m);
  tensor_restoration giving(m, bound, wanted);
  giving.run({});
  const std::size_t given = differing(m, before);
  REQUIRE(given > 0);
  std::vector<vertex_index> all, taken;
  for (vertex_index v = 0; v < before.size(); ++v) all.push_back(v);
  giving.take_back(all, taken);
  CHECK(taken.size() == given);
  CHECK(differing(m, before) == 0);
  giving.take_back(all, taken);
  CHECK(taken.size() == given);
  giving.run({});
  CHECK(differing(m, before) == 0);
}

TEST_CASE("tensors that are kept are neither taken back nor given") {
  const domain d = square();
  editable_mesh m = certified_mesh_in(d, "swirl:3", 0.3);
  const std::vector<metric_tensor> wanted = tensors_of(m);
  tensor_restoration giving(m, bound, wanted);
  const std::vector<vertex_index> one = {static_cast<vertex_index>(m.nodes().size() - 1)};
  const metric_tensor& own = wanted[one[0]];
  const metric_tensor other = {1.01 * own.m11, own.m12, own.m22};
  m.set_metric(one[0], other);
  giving.keep(one);
  std::vector<vertex_index> taken;
  giving.take_back(one, taken);
  giving.run({});
  CHECK(taken.empty());
  CHECK(identical(m.at(one[0]).metric, other));
}

TEST_CASE("nothing is given that neighbours do not agree about") {
  const domain d = square();
  editable_mesh m = certified_mesh_in(d, "identity", 0.3);
  const std::vector<metric_tensor> agreed = tensors_of(m);
  // A metric thin along x and along y in turns: no two adjacent nodes have similar tensors.
  std::vector<metric_tensor> wanted;
  for (vertex_index v = 0; v < agreed.size(); ++v)
    wanted.push_back(v % 2 == 0 ? metric_tensor{1e4, 0, 1} : metric_tensor{1, 0, 1e4});
  tensor_restoration giving(m, bound, wanted);
  const std::size_t in_disorder = count_disorder(m, bound);
  giving.run({});
  CHECK(count_disorder(m, bound) <= in_disorder);
}
