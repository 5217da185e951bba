// SPDX-License-Identifier: MIT
#include "asterism/mesh/stars/guessed_neighbours.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "asterism/core/plane_algebra.hpp"
#include "asterism/mesh/stars/site_triangulation.hpp"

namespace asterism::internal {
namespace {

// Returns the mean of the tensors, each divided by its trace: what counts is which way they lie.
metric_tensor mean_shape(const std::vector<site>& sites) {
  metric_tensor sum{0, 0, 0};
  for (const site& s : sites) {
    const metric_tensor& m = s.metric;
    const double trace = m.m11 + m.m22;
    sum = {sum.m11 + m.m11 / trace, sum.m12 + m.m12 / trace, sum.m22 + m.m22 / trace};
  }
  return sum;
}

// Says of an edge from a to b, with c on its left and d on its right, whether that from c to d is
// the Delaunay one in the mean of the four metrics: the angles at c and d are more than half a turn
// together. A tie by roundings stays as it is.
class edge_comparison {
 public:
  explicit edge_comparison(const std::vector<site>& sites) : sites_(&sites) {}

  bool operator()(vertex_index a, vertex_index b, vertex_index c, vertex_index d) const {
    const site &at_a = (*sites_)[a], &at_b = (*sites_)[b], &at_c = (*sites_)[c],
               &at_d = (*sites_)[d];
    metric_tensor m{0, 0, 0};
    for (const site* s : {&at_a, &at_b, &at_c, &at_d})
      m = {m.m11 + s->metric.m11, m.m12 + s->metric.m12, m.m22 + s->metric.m22};
    const auto ca = between(at_c.position, at_a.position),
               cb = between(at_c.position, at_b.position);
    const auto da = between(at_d.position, at_a.position),
               db = between(at_d.position, at_b.position);
    const double one = cross(ca, cb) * dot(apply(m, da), db),
                 other = cross(db, da) * dot(apply(m, ca), cb);
    constexpr double tie = 0x1p-30;
    return one + other < -tie * (std::abs(one) + std::abs(other));
  }

 private:
  const std::vector<site>* sites_;
};

// Collects the neighbours of a site, in the net's numbers.
void collect_ring(const delaunay_net& net, vertex_index v, std::vector<vertex_index>& ring) {
  ring.clear();
  const delaunay_net::place first = net.at(v);
  delaunay_net::place p = first;
  do {
    const auto& corner = net.faces()[p.face].corner;
    const vertex_index w = corner[(p.corner + 1) % 3];
    if (!net.is_frame(w)) ring.push_back(w);
    p = net.next_around(p);
  } while (p.face != first.face && p.face != delaunay_net::none);
}

}  // namespace

neighbour_lists guess_neighbours(const site_oracle& oracle, const cancellation& cancelled) {
  // Sites whose metrics vary over an edge by little take two or three flips each.
  constexpr std::size_t flips_for_each = 16;
  tier_counters apart;  // proposing is no part of the work that is bounded
  const auto kernel = oracle.kernel().fork(apart);
  auto from = triangulate(oracle, mean_shape(oracle.sites()), *kernel, cancelled);
  neighbour_lists guesses;
  if (!from) return guesses;
  std::vector<site> sites = from->net.all_sites();
  for (vertex_index v = 0; v < oracle.size(); ++v) sites[v] = oracle.sites()[from->original[v]];
  from->net.flip_towards(edge_comparison(sites), flips_for_each * oracle.size());
  guesses.reserve(oracle.size());
  std::vector<vertex_index> ring;
  for (vertex_index v = 0; v < oracle.size(); ++v) {
    collect_ring(from->net, from->numbers[v], ring);
    for (vertex_index& w : ring) w = from->original[w];
    std::rotate(ring.begin(),
                std::min_element(ring.begin(), ring.end(),
                                 [&](vertex_index a, vertex_index b) {
                                   return oracle.squared_distance(v, a) <
                                          oracle.squared_distance(v, b);
                                 }),
                ring.end());
    for (const vertex_index w : ring) guesses.add(w);
    guesses.end_list();
  }
  return guesses;
}

}  // namespace asterism::internal
