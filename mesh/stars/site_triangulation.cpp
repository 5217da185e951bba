// SPDX-License-Identifier: MIT
#include "asterism/mesh/stars/site_triangulation.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <utility>

#include "asterism/mesh/data/site_box.hpp"
#include "asterism/mesh/search/hilbert_order.hpp"
#include "asterism/mesh/support/prefetch.hpp"

namespace asterism::internal {
namespace {

// Returns the order in which sites are inserted: in rounds, each four times as many as all before
// and drawn as if at random, so that no arrangement of sites makes many long flips; along a curve
// within each round, so that the walk to the next site is short. Source: Amenta, Choi and Rote,
// Incremental constructions con BRIO, 2003.
std::vector<vertex_index> insertion_order(const site_oracle& oracle) {
  constexpr std::size_t most_rounds = 16;
  const auto round_of = [](vertex_index v) {
    std::uint64_t bits = (std::uint64_t{v} + 1) * 0x9e3779b97f4a7c15U;
    bits = (bits ^ bits >> 31) * 0xbf58476d1ce4e5b9U;
    std::size_t round = 0;
    for (bits ^= bits >> 29; round + 1 < most_rounds && (bits & 3U) == 0; bits >>= 2) ++round;
    return round;
  };
  std::array<std::vector<vertex_index>, most_rounds> rounds;
  const std::vector<vertex_index> along_curve =
      oracle.near() != nullptr ? oracle.near()->order_anew(oracle.sites())
                               : order_along_curve(oracle.sites(), box_of_sites(oracle.sites()));
  for (const vertex_index v : along_curve) rounds[round_of(v)].push_back(v);
  std::vector<vertex_index> order;
  order.reserve(oracle.size());
  for (std::size_t round = most_rounds; round-- > 0;)
    order.insert(order.end(), rounds[round].begin(), rounds[round].end());
  return order;
}

}  // namespace

std::optional<site_triangulation> triangulate(const site_oracle& oracle,
                                              const metric_tensor& metric,
                                              const star_predicates& kernel,
                                              const cancellation& cancelled) {
  std::vector<vertex_index> order = insertion_order(oracle);
  std::vector<vertex_index> numbers(order.size());
  std::vector<site> sites;
  sites.reserve(order.size() + 4);
  for (std::size_t i = 0; i < order.size(); ++i) {
    if (i + triangles_ahead < order.size()) prefetch(&oracle.sites()[order[i + triangles_ahead]]);
    const vertex_index v = order[i];
    numbers[v] = static_cast<vertex_index>(sites.size());
    sites.push_back({oracle.sites()[v].position, metric});
  }
  delaunay_triangulation delaunay(std::move(sites), kernel);
  constexpr vertex_index polled_after = 1024;
  for (vertex_index v = 0; v < order.size(); ++v) {
    if (v % polled_after == 0 && cancelled.is_requested()) return std::nullopt;
    if (!delaunay.insert(v)) return std::nullopt;
  }
  for (const boundary_edge& e : oracle.edges().subsegments())
    if (!delaunay.insert_segment(numbers[e.a], numbers[e.b])) return std::nullopt;
  if (!delaunay.settle()) return std::nullopt;
  return site_triangulation{std::move(delaunay), std::move(order), std::move(numbers)};
}

// Marks faces from each subsegment on, across edges that are not fixed.
std::vector<char> faces_inside(site_triangulation& from, const boundary& edges) {
  std::vector<char> inside(from.delaunay.faces().size(), 0);
  std::vector<std::uint32_t> open;
  const auto enter = [&](std::uint32_t f) {
    if (inside[f] == 0) open.push_back(f);
    inside[f] = 1;
  };
  for (const boundary_edge& e : edges.subsegments()) {
    const auto left = from.delaunay.find_edge(from.numbers[e.a], from.numbers[e.b]);
    if (!left) return {};
    enter(left->face);
    while (!open.empty()) {
      const delaunay_triangulation::face& f = from.delaunay.faces()[open.back()];
      open.pop_back();
      for (std::size_t i = 0; i < 3; ++i)
        if (!f.fixed[i] && f.across[i] != delaunay_triangulation::none) enter(f.across[i]);
    }
  }
  return inside;
}

}  // namespace asterism::internal
