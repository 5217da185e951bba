// SPDX-License-Identifier: MIT
#include "asterism/mesh/refine/coarser_mesh.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "asterism/core/elementary.hpp"
#include "asterism/mesh/numerics/scaled_tensor.hpp"
#include "asterism/mesh/numerics/triangle_quality.hpp"

namespace asterism::internal {
namespace {

// Returns the length times 2^(halvings / 2), rounded once.
double restored(double length, int halvings) {
  const bool is_odd = halvings % 2 != 0;
  return std::scalbn(is_odd ? length * std::numbers::sqrt2 : length,
                     (halvings - (is_odd ? 1 : 0)) / 2);
}

double sites_on_segments(const mesh& m) {
  std::vector<char> on(m.sites.size(), 0);
  for (const boundary_edge& e : m.boundary) on[e.a] = on[e.b] = 1;
  return static_cast<double>(std::count(on.begin(), on.end(), 1));
}

}  // namespace

result<metric_tensor> coarser_field::at(const point& q) const {
  auto given = field_->at(q);
  if (!given || halvings_ == 0) return given;
  const metric_tensor m = times_power_of_two(given.value(), -halvings_);
  if (times_power_of_two(m, halvings_) == given.value()) return m;
  return error{fmt::format("the metric at ({}, {}) is ({}, {}, {}): with edges so much longer "
                           "lengths in it leave the range of doubles",
                           q.x, q.y, given.value().m11, given.value().m12, given.value().m22),
               error_code::invalid_metric};
}

void restore_lengths(int halvings, mesh_outcome& outcome) {
  for (site& s : outcome.result.sites) s.metric = times_power_of_two(s.metric, halvings);
  refinement_ending& ended = outcome.ended;
  ended.tolerance = restored(ended.tolerance, halvings);
  if (ended.steep) ended.steep->spacing = restored(ended.steep->spacing, halvings);
}

void report_coarser(int halvings, bool fill_stopped, const mesh_options& options,
                    mesh_outcome& outcome) {
  if (halvings == 0) return;
  const mesh& m = outcome.result;
  outcome.complete = false;
  outcome.too_large = static_cast<std::size_t>(
      std::count_if(m.triangles.begin(), m.triangles.end(), [&m](const triangle& t) {
        return metric_circumradius({m.sites[t[0]], m.sites[t[1]], m.sites[t[2]]}) >
               largest_circumradius;
      }));
  refinement_ending& ended = outcome.ended;
  ended.max_sites = options.max_sites;
  ended.length_factor = elementary::exp2(halvings / 2.0);
  if (fill_stopped) return;
  const double on_segments = sites_on_segments(m);
  const double inside = static_cast<double>(outcome.sites) - on_segments;
  ended.sites_wanted =
      on_segments * ended.length_factor + inside * ended.length_factor * ended.length_factor;
}

}  // namespace asterism::internal
