// SPDX-License-Identifier: MIT
#include "asterism/mesh/numerics/approximate_star.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <optional>

#include "asterism/core/plane_algebra.hpp"
#include "asterism/kernels/vertex_hints.hpp"
#include "asterism/mesh/numerics/constructions.hpp"
#include "asterism/mesh/numerics/ill_conditioned_metric.hpp"
#include "asterism/mesh/support/infinity.hpp"

namespace asterism::internal {
namespace {

struct candidate {
  double turn;  // grows with the angle, from -2 to 2
  vertex_index who;
  std::uint32_t number;  // among the candidates
  double squared_distance;
  displacement<double> d, z;
};

// Returns a number that grows with the direction's angle. Copies the sign without a branch, which
// would be mispredicted, as directions come in any order. Adding 0 turns -0 into 0.
double turn_of(const displacement<double>& d) {
  const double slope = d.x / (std::abs(d.x) + std::abs(d.y));
  return std::copysign(1 - slope, d.y + 0.0);
}

// True if w is a corner of the hull between y and x; always true across half a turn or more.
bool stands_out(const candidate& y, const candidate& w, const candidate& x) {
  return cross(y.d, x.d) <= 0 || cross(w.z - y.z, x.z - w.z) > 0;
}

// Sorts the candidates by direction from the first, by counting how many turn less than each:
// comparisons would be mispredicted. Returns false, leaving them as they were, if they are many, or
// two have one direction.
bool order_by_counting(std::vector<candidate>& all) {
  constexpr std::size_t most_counted = 16;
  const std::size_t size = all.size();
  if (size > most_counted) return false;
  std::array<double, most_counted> turns;
  turns.fill(infinity);
  for (std::size_t i = 0; i < size; ++i) turns[i] = all[i].turn;
  std::array<std::int64_t, most_counted> places{};
  std::uint32_t taken = 0;
  double nearest = infinity;
  std::int64_t first = 0;
  for (std::size_t i = 0; i < size; ++i) {
    std::int64_t place = 0;
    for (const double turn : turns) place += std::int64_t{turn < turns[i]};
    places[i] = place;
    taken |= 1U << static_cast<std::uint32_t>(place);
    const double distance = all[i].squared_distance;
    if (distance < nearest || (distance == nearest && place < first)) first = place;
    nearest = std::min(nearest, distance);
  }
  if (taken + 1 != 1U << size) return false;
  std::array<candidate, most_counted> sorted;
  for (std::size_t i = 0; i < size; ++i) {
    const std::int64_t after = places[i] - first;
    sorted[static_cast<std::size_t>(after < 0 ? after + std::ssize(all) : after)] = all[i];
  }
  std::copy_n(sorted.begin(), size, all.begin());
  return true;
}

// Sorts the candidates by direction from the first, each once.
void order_all(std::vector<candidate>& all) {
  std::sort(all.begin(), all.end(), [](const candidate& a, const candidate& b) {
    return a.turn != b.turn ? a.turn < b.turn : a.who < b.who;
  });
  all.erase(std::unique(all.begin(), all.end(),
                        [](const candidate& a, const candidate& b) { return a.who == b.who; }),
            all.end());
  double nearest = infinity;
  std::ptrdiff_t first = 0;
  for (std::ptrdiff_t i = 0; i < std::ssize(all); ++i) {
    const double distance = all[static_cast<std::size_t>(i)].squared_distance;
    if (distance < nearest) {
      nearest = distance;
      first = i;
    }
  }
  std::rotate(all.begin(), all.begin() + first, all.end());
}

// Returns the candidates for the star of v, counter-clockwise from the nearest, which is on the
// hull.
std::vector<candidate>& order_candidates(const std::vector<site>& sites, vertex_index v,
                                         const std::vector<vertex_index>& from) {
  thread_local std::vector<candidate> all;
  all.clear();
  site s = sites[v];
  std::optional<round_coordinates> round;
  if (is_thin(s.metric)) s = round.emplace(s.position, s.metric).inward(s);
  for (std::uint32_t number = 0; number < from.size(); ++number) {
    const vertex_index w = from[number];
    if (w == v) continue;
    const site other = round ? round->inward(sites[w]) : sites[w];
    const auto d = between(s.position, other.position);
    const auto dual = apply(other.metric, d), own = apply(s.metric, d);
    const double inverse = 1 / dot(dual, d);
    const double own_inverse = std::sqrt(inverse / dot(own, d));
    all.push_back({turn_of(d), w, number, squared_length(s.metric, d), d,
                   inverse * dual + own_inverse * own});
  }
  if (!order_by_counting(all)) order_all(all);
  return all;
}

// Computes vertex and radius of the gap of s between y and x.
void close_gap(const site& s, const site& y, const site& x, approximate_gap& gap) {
  const auto to_y = between(s.position, y.position), to_x = between(s.position, x.position);
  if (!(cross(to_y, to_x) > 0)) return;
  const auto vertex = numeric::voronoi_vertex_near(s, y, x);
  if (!vertex) return;
  const auto seen = apply(s.metric, *vertex);
  // Rejects a point beyond a right angle from a neighbour: it is not the vertex of this gap.
  if (!(dot(seen, to_y) > 0 && dot(seen, to_x) > 0)) return;
  gap.vertex = {vertex->x, vertex->y};
  gap.squared_radius = dot(seen, *vertex);
}

}  // namespace

void close_gap(const std::vector<site>& sites, vertex_index v, approximate_gap& gap,
               vertex_index next) {
  gap.squared_radius = infinity;
  const site &s = sites[v], &y = sites[gap.neighbour], &x = sites[next];
  if (!is_thin(s.metric)) return close_gap(s, y, x, gap);
  const round_coordinates round(s.position, s.metric);
  close_gap(round.inward(s), round.inward(y), round.inward(x), gap);
  gap.vertex = round.outward(gap.vertex);
}

bool take_vertex(const std::vector<site>& sites, vertex_index v, approximate_gap& gap,
                 vertex_index next, vertex_index w, const approximate_gap& found) {
  const site& s = sites[v];
  if (!(found.squared_radius < infinity) || is_thin(s.metric) || is_thin(sites[w].metric))
    return false;
  const auto to_w = between(s.position, sites[w].position);
  const displacement<double> vertex{to_w.x + found.vertex.x, to_w.y + found.vertex.y};
  const auto seen = apply(s.metric, vertex);
  if (!(dot(seen, between(s.position, sites[gap.neighbour].position)) > 0 &&
        dot(seen, between(s.position, sites[next].position)) > 0))
    return false;
  gap.vertex = {vertex.x, vertex.y};
  gap.squared_radius = dot(seen, vertex);
  return true;
}

bool lacks_vertex(const std::vector<site>& sites, vertex_index v, const approximate_gap& gap,
                  vertex_index next) {
  if (gap.squared_radius < infinity) return false;
  const point& q = sites[v].position;
  const auto y = between(q, sites[gap.neighbour].position), x = between(q, sites[next].position);
  constexpr double certainly = 0x1p-20;  // no rounding of sites on a line
  return cross(y, x) > certainly * std::sqrt(dot(y, y) * dot(x, x));
}

// Compares signed squares of the sine of the angle between successive directions, in v's metric.
bool is_plainly_a_star(const std::vector<site>& sites, vertex_index v,
                       const approximate_star& star) {
  constexpr double least_sine = 0x1p-10, least = least_sine * least_sine;
  const metric_tensor& m = sites[v].metric;
  const double determinant = m.m11 * m.m22 - m.m12 * m.m12;
  for (std::size_t i = 0; i < star.size(); ++i) {
    const approximate_gap &before = star[i], &after = star[following(star, i)];
    const double area = before.vertex.x * after.vertex.y - before.vertex.y * after.vertex.x;
    const double radii = before.squared_radius * after.squared_radius;
    if (!(radii < infinity && area > 0 && area * area * determinant > least * radii)) return false;
  }
  return star.size() > 2;
}

namespace {

// Returns those of the candidates that pass the test between their present neighbours,
// stands(before, candidate, after). Goes around the full turn from a candidate that certainly
// stays.
template <class Stands>
const std::vector<const candidate*>& those_that_stand(const std::vector<candidate>& all,
                                                      const Stands& stands) {
  thread_local std::vector<const candidate*> hull;
  hull.clear();
  for (const candidate& next : all) {
    while (hull.size() > 1 && !stands(*hull[hull.size() - 2], *hull.back(), next)) hull.pop_back();
    hull.push_back(&next);
  }
  while (hull.size() > 2 && !stands(*hull[hull.size() - 2], *hull.back(), *hull.front()))
    hull.pop_back();
  return hull;
}

// Removes candidates behind another one on its ray from the centre, up to roundings. The candidates
// are in the order of their directions, from the nearest of all.
void leave_nearest_on_rays(std::vector<candidate>& all) {
  constexpr double on_one_ray = 0x1p-40;
  std::size_t kept = 0;
  for (std::size_t i = 1; i < all.size(); ++i) {
    candidate &last = all[kept], &next = all[i];
    const double along = dot(last.d, next.d);
    if (along > 0 && std::abs(cross(last.d, next.d)) <= on_one_ray * along) {
      if (dot(next.d, next.d) < dot(last.d, last.d)) last = next;
    } else {
      all[++kept] = next;
    }
  }
  if (!all.empty()) all.resize(kept + 1);
}

// True if w belongs to v's star between y and x: by the hull where that is clear, else by their
// Voronoi vertex.
bool stands_out_with_care(const std::vector<site>& sites, vertex_index v, const candidate& y,
                          const candidate& w, const candidate& x) {
  constexpr double in_doubt = 0.25;  // sine of the hull's angle, about
  if (cross(y.d, x.d) <= 0) return true;
  const auto before = w.z - y.z, after = x.z - w.z;
  const double turned = cross(before, after), size = (std::abs(before.x) + std::abs(before.y)) *
                                                     (std::abs(after.x) + std::abs(after.y));
  approximate_gap gap{y.who, {}, infinity};
  if (!(std::abs(turned) > in_doubt * size)) close_gap(sites, v, gap, x.who);
  if (gap.squared_radius == infinity) return turned > 0;
  const auto to_w = between(sites[v].position, sites[w.who].position);
  const point from_w{gap.vertex.x - to_w.x, gap.vertex.y - to_w.y};
  return squared_length(sites[w.who].metric, from_w) < gap.squared_radius;
}

}  // namespace

approximate_star build_careful_star(const std::vector<site>& sites, vertex_index v,
                                    const std::vector<vertex_index>& candidates) {
  std::vector<candidate>& all = order_candidates(sites, v, candidates);
  leave_nearest_on_rays(all);
  const auto& hull =
      those_that_stand(all, [&](const candidate& y, const candidate& w, const candidate& x) {
        return stands_out_with_care(sites, v, y, w, x);
      });
  approximate_star star(hull.size());
  for (std::size_t i = 0; i < hull.size(); ++i) star[i].neighbour = hull[i]->who;
  for (std::size_t i = 0; i < star.size(); ++i)
    close_gap(sites, v, star[i], star[following(star, i)].neighbour);
  return star;
}

approximate_star build_approximate_star(const std::vector<site>& sites, vertex_index v,
                                        const std::vector<vertex_index>& candidates,
                                        const approximate_star& before, const known_vertex& known) {
  const std::vector<candidate>& all = order_candidates(sites, v, candidates);
  const std::vector<const candidate*>& hull = those_that_stand(all, stands_out);
  approximate_star star(hull.size());
  for (std::size_t i = 0; i < hull.size(); ++i) star[i].neighbour = hull[i]->who;
  for (std::size_t i = 0; i < star.size(); ++i) {
    const std::size_t next = following(star, i), then = hull[i]->number;
    if (then < before.size() && hull[next]->number == following(before, then))
      star[i] = before[then];
    else if (!known || !known(star[i], star[next].neighbour))
      close_gap(sites, v, star[i], star[next].neighbour);
  }
  return star;
}

namespace {

// Directions from the centre of a star to its neighbours, in the star's order.
class star_directions {
 public:
  star_directions(const std::vector<site>& sites, vertex_index v, const approximate_star& star)
      : sites_(sites), star_(star), centre_(sites[v].position) {}

  displacement<double> operator[](std::size_t i) const {
    return between(centre_, sites_[star_[i].neighbour].position);
  }

  // True if the gap after neighbour i is half a turn or more, or contains d: its first side
  // included, its last excluded.
  bool holds(std::size_t i, const displacement<double>& d) const {
    return holds((*this)[i], (*this)[following(star_, i)], d);
  }

  // Returns the first gap that contains d; the number of gaps if there is none.
  std::size_t first_that_holds(const displacement<double>& d) const {
    constexpr std::size_t most_compared = 16;
    if (star_.size() > most_compared) {
      const std::size_t i = last_not_beyond(d);
      if (holds(i, d)) return i;
    }
    auto before = (*this)[0];
    for (std::size_t i = 0; i < star_.size(); ++i) {
      const auto after = (*this)[following(star_, i)];
      if (holds(before, after, d)) return i;
      before = after;
    }
    return star_.size();
  }

 private:
  static bool holds(const displacement<double>& before, const displacement<double>& after,
                    const displacement<double>& d) {
    const bool wide = !(cross(before, after) > 0);
    const bool past = cross(before, d) >= 0, not_beyond = cross(d, after) > 0;
    return wide ? past || not_beyond : past && not_beyond;
  }

  // Finds the last neighbour, counter-clockwise from the first, that is not after d, by bisection:
  // stars in metrics with fast variation have hundreds of neighbours.
  std::size_t last_not_beyond(const displacement<double>& d) const {
    const auto first = (*this)[0];
    const auto in_first_half = [&first](const displacement<double>& e) {
      const double side = cross(first, e);
      return side > 0 || (side == 0 && dot(first, e) > 0);
    };
    const bool d_in_first = in_first_half(d);
    std::size_t low = 0, high = star_.size();
    while (high - low > 1) {
      const std::size_t middle = low + (high - low) / 2;
      const auto e = (*this)[middle];
      const bool e_in_first = in_first_half(e);
      const bool is_before = d_in_first != e_in_first ? d_in_first : cross(e, d) < 0;
      (is_before ? high : low) = middle;
    }
    return low;
  }

  const std::vector<site>& sites_;
  const approximate_star& star_;
  const point& centre_;
};

}  // namespace

bool disturbs(const std::vector<site>& sites, vertex_index v, const approximate_star& star,
              vertex_index w) {
  if (star.size() < 3) return true;
  const auto to_w = between(sites[v].position, sites[w].position);
  const std::size_t i = star_directions(sites, v, star).first_that_holds(to_w);
  if (i == star.size() || star[i].squared_radius == infinity) return true;
  const point& vertex = star[i].vertex;
  return squared_length(sites[w].metric, point{vertex.x - to_w.x, vertex.y - to_w.y}) <
         star[i].squared_radius;
}

}  // namespace asterism::internal
