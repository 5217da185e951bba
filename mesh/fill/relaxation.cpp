// SPDX-License-Identifier: MIT
#include "asterism/mesh/fill/relaxation.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>

#include "asterism/core/plane_algebra.hpp"
#include "asterism/mesh/numerics/constructions.hpp"
#include "asterism/mesh/support/parallel.hpp"

namespace asterism::internal {
namespace {

constexpr std::size_t places_a_chunk = 256;

point way(const point& from, const point& to) { return {to.x - from.x, to.y - from.y}; }

using ways_to_neighbour = relaxation::ways_to_neighbour;

// True if lengths along both axes differ by at most a factor of two between the metrics, and areas
// by at most four: then there is no jump of the metric between two places.
bool is_similar(const metric_tensor& a, const metric_tensor& b) {
  constexpr double most_times = 4;  // as squares
  const auto is_near = [](double p, double q, double most) {
    return p <= most * q && q <= most * p;
  };
  return is_near(a.m11, b.m11, most_times) && is_near(a.m22, b.m22, most_times) &&
         is_near(a.m11 * a.m22 - a.m12 * a.m12, b.m11 * b.m22 - b.m12 * b.m12,
                 most_times * most_times);
}

// True if all triangles of the site with two successive neighbours turn left, and their circles in
// the metric m have at most this radius, for the old and the new places of both neighbours.
bool keep_small(const metric_tensor& m, const std::vector<ways_to_neighbour>& ways, double radius) {
  const double most = 4 * radius * radius * (m.m11 * m.m22 - m.m12 * m.m12);
  int all = 1;
  for (std::size_t i = 0; i < ways.size(); ++i) {
    const ways_to_neighbour &y = ways[i], &x = ways[i + 1 < ways.size() ? i + 1 : 0];
    for (std::size_t at_y = 0; at_y < 2; ++at_y)
      for (std::size_t at_x = 0; at_x < 2; ++at_x) {
        const point &to_y = y.way[at_y], &to_x = x.way[at_x];
        const double area = to_y.x * to_x.y - to_y.y * to_x.x,
                     lengths =
                         y.squared[at_y] * x.squared[at_x] * squared_length(m, way(to_y, to_x));
        all &= static_cast<int>(area > 0) & static_cast<int>(lengths <= most * (area * area));
      }
  }
  return all != 0;
}

}  // namespace

void relaxation::run(double distance, const cancellation& stop) {
  find_places(stop);
  const std::vector<vertex_index> going = those_that_may_go(distance, stop);
  if (stop.is_requested()) return;
  parts_.field.expect([&] {
    std::vector<point> asked;
    asked.reserve(going.size());
    for (const vertex_index v : going) asked.push_back(places_[v]);
    return asked;
  });
  parallel_chunks(going.size(), places_a_chunk,
                  [&](std::size_t, std::size_t begin, std::size_t end) {
                    for (std::size_t i = begin; i < end; ++i) {
                      const point& to = places_[going[i]];
                      const auto metric = parts_.field.at(to);
                      if (metric && is_similar(metric.value(), parts_.sites[going[i]].metric))
                        parts_.sites.move(going[i], {to, metric.value()});
                    }
                  });
}

void relaxation::find_places(const cancellation& stop) {
  places_.resize(parts_.sites.size());
  parallel_chunks(
      places_.size(), places_a_chunk, [&](std::size_t, std::size_t begin, std::size_t end) {
        if (stop.is_requested()) return;
        for (std::size_t i = begin; i < end; ++i) {
          const vertex_index v = order_[i];
          const bool stays = v < parts_.shape.vertices.size() || parts_.sites.is_on_segment(v);
          places_[v] = stays ? here(v) : middle_of_neighbours(v);
        }
      });
}

// Returns the place half the way to the mean of the neighbours: a longer move would make more
// triangles too large.
point relaxation::middle_of_neighbours(vertex_index v) const {
  constexpr double part = 0.5;
  point sum{0, 0};
  for (const approximate_gap& gap : parts_.stars[v]) {
    const point to = way(here(v), here(gap.neighbour));
    sum = {sum.x + to.x, sum.y + to.y};
  }
  const auto count = static_cast<double>(std::max(parts_.stars[v].size(), std::size_t{1}));
  return {here(v).x + part / count * sum.x, here(v).y + part / count * sum.y};
}

std::vector<vertex_index> relaxation::those_that_may_go(double distance,
                                                        const cancellation& stop) const {
  return collect_chunks<vertex_index>(
      places_.size(), places_a_chunk,
      [&](std::size_t begin, std::size_t end, std::vector<vertex_index>& out) {
        if (stop.is_requested()) return;
        const filtered_kernel kernel;
        std::uint64_t gaps = 0;
        for (std::size_t i = begin; i < end; ++i) {
          const vertex_index v = order_[i];
          gaps += parts_.stars[v].size();
          if (may_go(kernel, v, distance)) out.push_back(v);
        }
        parts_.work.count_gaps(gaps);
      });
}

bool relaxation::may_go(const filtered_kernel& kernel, vertex_index v, double distance) const {
  if (places_[v] == here(v) || parts_.stars[v].size() < 3) return false;
  thread_local std::vector<ways_to_neighbour> ways;
  ways.clear();
  const metric_tensor& m = parts_.sites[v].metric;
  for (const approximate_gap& gap : parts_.stars[v]) {
    const point old_way = way(places_[v], here(gap.neighbour)),
                new_way = way(places_[v], places_[gap.neighbour]);
    ways.push_back({gap.neighbour,
                    {old_way, new_way},
                    {squared_length(m, old_way), squared_length(m, new_way)}});
  }
  constexpr double part = 0.998;  // what metrics vary on the way seldom is more than the rest
  if (!keeps_distances(v, ways, distance) || !keep_small(m, ways, part * distance)) return false;
  const approximate_star& star = parts_.stars[v];
  const bool is_at_segment = std::any_of(
      star.begin(), star.end(),
      [this](const approximate_gap& gap) { return parts_.sites.is_on_segment(gap.neighbour); });
  return (!is_at_segment || stays_clear(v, distance)) && locator_.contains(kernel, places_[v]);
}

bool relaxation::stays_clear(vertex_index v, double distance) const {
  std::uint64_t looked_at = 0;
  const bool is_clear =
      parts_.segments.stays_clear({places_[v], parts_.sites[v].metric}, distance, looked_at);
  parts_.work.count_candidates(looked_at);
  return is_clear;
}

// True if v at its new place keeps `distance` to every neighbour, in both metrics and at both
// places of the neighbour; a neighbour that was nearer before may stay as near. False if the
// lengths of the displacement between v and a neighbour, in their two metrics, differ by more than
// a factor of two: across a jump of the metric the mean of the neighbours lies on the dense side.
bool relaxation::keeps_distances(vertex_index v, const std::vector<ways_to_neighbour>& ways,
                                 double distance) const {
  const double squared = distance * distance;
  constexpr double most_times = 4;  // as squares
  const metric_tensor& m = parts_.sites[v].metric;
  return std::all_of(ways.begin(), ways.end(), [&](const ways_to_neighbour& to) {
    const metric_tensor& other = parts_.sites[to.neighbour].metric;
    const point before = way(here(v), here(to.neighbour));
    const double by_site = squared_length(m, before), by_other = squared_length(other, before);
    if (by_site > most_times * by_other || by_other > most_times * by_site) return false;
    const double least = std::min(squared, by_site), least_of_other = std::min(squared, by_other);
    return std::min(to.squared[0], to.squared[1]) >= least &&
           std::min(squared_length(other, to.way[0]), squared_length(other, to.way[1])) >=
               least_of_other;
  });
}

}  // namespace asterism::internal
