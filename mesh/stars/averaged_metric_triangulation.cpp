// SPDX-License-Identifier: MIT
#include "asterism/mesh/stars/averaged_metric_triangulation.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "asterism/core/plane_algebra.hpp"
#include "asterism/kernels/filtered_edge_test.hpp"
#include "asterism/kernels/work_units.hpp"
#include "asterism/mesh/numerics/constructions.hpp"
#include "asterism/mesh/stars/canonical_triangle.hpp"

namespace asterism::internal {
namespace {

// Returns the mean of the tensors, each divided by its trace: their directions and ratios count,
// not their sizes.
metric_tensor mean_shape(const std::vector<site>& sites) {
  metric_tensor sum{0, 0, 0};
  for (const site& s : sites) {
    const metric_tensor& m = s.metric;
    const double trace = m.m11 + m.m22;
    sum = {sum.m11 + m.m11 / trace, sum.m12 + m.m12 / trace, sum.m22 + m.m22 / trace};
  }
  return sum;
}

// Largest number of flips for one new site, as a mean over all new sites: nearly all take less than
// ten, but the first sites put beside a boundary of n vertices which all see each other take up to
// n.
constexpr std::size_t most_flips = 64;

}  // namespace

std::optional<averaged_metric_triangulation> averaged_metric_triangulation::make(
    const site_oracle& oracle, const cancellation& cancelled) {
  // Largest number of flips for each site: where metrics vary little over an edge two or three
  // suffice.
  constexpr std::size_t flips_for_each = 16;
  auto questions = std::make_unique<asked>();
  questions->kernel = oracle.kernel().fork(questions->counted);
  auto from = triangulate(oracle, mean_shape(oracle.sites()), *questions->kernel, cancelled);
  if (!from) return std::nullopt;
  std::vector<char> inside = faces_inside(*from, oracle.edges());
  averaged_metric_triangulation made(std::move(questions), *std::move(from), std::move(inside));
  for (vertex_index v = 0; v < oracle.size(); ++v)
    made.sites_[v] = oracle.sites()[made.from_.original[v]];
  made.from_.delaunay.flip_towards(made.better(), flips_for_each * oracle.size());
  return made;
}

averaged_metric_triangulation::averaged_metric_triangulation(std::unique_ptr<asked> questions,
                                                             site_triangulation from,
                                                             std::vector<char> inside)
    : questions_(std::move(questions)),
      from_(std::move(from)),
      sites_(from_.delaunay.all_sites()),
      inside_(std::move(inside)) {
  inside_.resize(faces(), 0);
  // Skips the numbers of the frame's corners, which are not sites.
  from_.original.resize(sites_.size(), 0);
}

triangle averaged_metric_triangulation::corners(std::uint32_t face) const {
  const auto& [a, b, c] = from_.delaunay.faces()[face].corner;
  return canonical({from_.original[a], from_.original[b], from_.original[c]});
}

double averaged_metric_triangulation::excess(vertex_index a, vertex_index b, vertex_index c,
                                             vertex_index d) const {
  const site &at_a = sites_[a], &at_b = sites_[b], &at_c = sites_[c], &at_d = sites_[d];
  metric_tensor m{0, 0, 0};
  for (const site* s : {&at_a, &at_b, &at_c, &at_d})
    m = {m.m11 + s->metric.m11, m.m12 + s->metric.m12, m.m22 + s->metric.m22};
  const auto ca = between(at_c.position, at_a.position), cb = between(at_c.position, at_b.position);
  const auto da = between(at_d.position, at_a.position), db = between(at_d.position, at_b.position);
  const double one = cross(ca, cb) * dot(apply(m, da), db),
               other = cross(db, da) * dot(apply(m, ca), cb);
  return -(one + other) / (std::abs(one) + std::abs(other));
}

// Decides on an edge by the mean metric. If the two diagonals of its quadrangle tie but for
// rounding, the edge stays.
bool averaged_metric_triangulation::is_better(vertex_index a, vertex_index b, vertex_index c,
                                              vertex_index d) const {
  constexpr double tie = 0x1p-30;
  return excess(a, b, c, d) > tie;
}

// Decides in doubles alone: an undecided edge stays. All edges stay once the work equals that of
// making the stars without guesses.
bool averaged_metric_triangulation::is_better_in_stars(vertex_index a, vertex_index b,
                                                       vertex_index c, vertex_index d) {
  constexpr double most_for_each = 2;
  for (const vertex_index v : {a, b, c, d})
    if (from_.delaunay.is_frame(v)) return false;
  const auto ask = [&](vertex_index v, vertex_index w, vertex_index x, vertex_index y) {
    return filtered_edge_test(sites_[v], sites_[w], sites_[x], sites_[y], questions_->counted);
  };
  const auto sites = static_cast<double>(from_.numbers.size());
  const bool may_ask = work_units(questions_->counted) <= most_for_each * sites;
  const uncertain_bool stays = may_ask ? ask(a, b, c, d) : uncertain_bool();
  if (stays.certain() && stays.value()) return false;
  has_doubtful_edge_[a] = has_doubtful_edge_[b] = 1;
  if (!stays.certain()) return false;
  const uncertain_bool comes = ask(c, d, a, b);
  return comes.certain() && comes.value();
}

// Returns the number of flips that the next site may take: flips that a site does not use are left
// to later sites. With 64 for each site alone, a circle of 30,000 equal segments got stars with
// thousands of neighbours, and its mesh had 62,000 sites in place of 52,000.
std::size_t averaged_metric_triangulation::flips_left() const {
  const std::size_t in_all = most_flips * sites_.size(),
                    done = from_.delaunay.flips_of_insertions();
  return std::max(most_flips, in_all - std::min(in_all, done));
}

void averaged_metric_triangulation::number_last(vertex_index v) {
  from_.original.push_back(static_cast<vertex_index>(from_.numbers.size()));
  from_.numbers.push_back(v);
}

// Leaves out faces outside of the domain.
void averaged_metric_triangulation::collect_faces(vertex_index v,
                                                  std::vector<std::uint32_t>& around) const {
  const delaunay_triangulation::place first = from_.delaunay.at(v);
  delaunay_triangulation::place p = first;
  do {
    if (is_inside(p.face)) around.push_back(p.face);
    p = from_.delaunay.next_around(p);
  } while (p.face != first.face);
}

void averaged_metric_triangulation::insert(const site& s,
                                           const delaunay_triangulation::location& at,
                                           std::vector<std::uint32_t>& around) {
  sites_.push_back(s);
  const vertex_index v = from_.delaunay.insert_towards(s, at, better(), flips_left());
  number_last(v);
  inside_.resize(faces(), 1);
  collect_faces(v, around);
}

bool averaged_metric_triangulation::split(const site& s, vertex_index a, vertex_index b,
                                          std::vector<std::uint32_t>& around) {
  const auto at = from_.delaunay.find_edge(from_.numbers[a], from_.numbers[b]);
  if (!at) return false;
  const delaunay_triangulation::face& left = from_.delaunay.faces()[at->face];
  const std::uint32_t other = left.across[at->corner];
  if (other == delaunay_triangulation::none) return false;
  const auto is_beside = [&](vertex_index from, vertex_index to, vertex_index apex) {
    const point &p = sites_[from].position, &q = sites_[to].position, &r = sites_[apex].position;
    return questions_->kernel->orientation(p, s.position, r) == sign::positive &&
           questions_->kernel->orientation(s.position, q, r) == sign::positive;
  };
  const vertex_index from = from_.numbers[a], to = from_.numbers[b];
  const auto& [p, q, r] = from_.delaunay.faces()[other].corner;
  const vertex_index behind = p != from && p != to ? p : q != from && q != to ? q : r;
  const bool is_internal = is_inside(other);
  if (!is_inside(at->face) || !is_beside(from, to, left.corner[at->corner]) ||
      (is_internal && !is_beside(to, from, behind)))
    return false;
  sites_.push_back(s);
  const vertex_index v = from_.delaunay.split_towards(s, *at, is_internal, better(), flips_left());
  number_last(v);
  inside_.push_back(1);
  inside_.push_back(is_internal ? 1 : 0);
  collect_faces(v, around);
  return true;
}

void averaged_metric_triangulation::renumber(const std::vector<vertex_index>& to) {
  const std::vector<vertex_index> before = from_.numbers;
  for (std::size_t v = 0; v < before.size(); ++v) {
    from_.numbers[to[v]] = before[v];
    from_.original[before[v]] = to[v];
  }
}

void averaged_metric_triangulation::collect_ring(vertex_index v,
                                                 std::vector<vertex_index>& ring) const {
  ring.clear();
  const delaunay_triangulation::place first = from_.delaunay.at(v);
  delaunay_triangulation::place p = first;
  double least = 0;
  std::size_t nearest = 0;
  do {
    const vertex_index w = from_.delaunay.faces()[p.face].corner[(p.corner + 1) % 3];
    if (!from_.delaunay.is_frame(w)) {
      const double distance = squared_distance(sites_[v], sites_[w].position);
      if (ring.empty() || distance < least) {
        least = distance;
        nearest = ring.size();
      }
      ring.push_back(from_.original[w]);
    }
    p = from_.delaunay.next_around(p);
  } while (p.face != first.face && p.face != delaunay_triangulation::none);
  std::rotate(ring.begin(), ring.begin() + static_cast<std::ptrdiff_t>(nearest), ring.end());
}

neighbour_lists averaged_metric_triangulation::settled_neighbours() {
  has_doubtful_edge_.assign(sites_.size(), 0);
  const bool is_settled =
      from_.delaunay.flip_towards([this](vertex_index a, vertex_index b, vertex_index c,
                                         vertex_index d) { return is_better_in_stars(a, b, c, d); },
                                  from_.numbers.size());
  neighbour_lists lists;
  lists.reserve(from_.numbers.size());
  std::vector<vertex_index> ring;
  for (const vertex_index v : from_.numbers) {
    collect_ring(v, ring);
    for (const vertex_index w : ring) lists.add(w);
    lists.end_list();
  }
  lists.make_room_for_marks();
  for (std::size_t i = 0; is_settled && i < from_.numbers.size(); ++i)
    if (has_doubtful_edge_[from_.numbers[i]] == 0) lists.mark(i);
  return lists;
}

neighbour_lists guess_neighbours(const site_oracle& oracle, const cancellation& cancelled) {
  auto from = averaged_metric_triangulation::make(oracle, cancelled);
  return from ? from->settled_neighbours() : neighbour_lists();
}

}  // namespace asterism::internal
