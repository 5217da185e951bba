// SPDX-License-Identifier: MIT
#include "asterism/mesh/pipeline/kept_mesh.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <numbers>
#include <utility>
#include <vector>

#include "asterism/core/elementary.hpp"
#include "asterism/mesh/audit/audit.hpp"
#include "asterism/mesh/audit/past_audit.hpp"
#include "asterism/mesh/numerics/metric_length.hpp"
#include "asterism/mesh/numerics/nodal_sums.hpp"
#include "asterism/mesh/search/mesh_links.hpp"
#include "asterism/mesh/solution/optimal_metric.hpp"

namespace asterism::internal {
namespace {

constexpr double least_length = 1.0 / 3, greatest_length = 1.75;

// Returns the logarithmic mean of both ends' lengths, which is the length in a metric that changes
// geometrically from one end to the other.
double logarithmic_mean_length(const site& a, const site& b) {
  const point d{b.position.x - a.position.x, b.position.y - a.position.y};
  return logarithmic_mean(plain_length(a.metric, d), plain_length(b.metric, d), elementary::log);
}

}  // namespace

// Computes the number of vertices from the area: triangles of unit edges have an area of sqrt(3) /
// 4, and the number of vertices is half that of the triangles, plus half that of the boundary's
// edges, plus the Euler characteristic.
unit_counts vertices_of_unit_edges(const mesh& m) {
  const mesh_links links(m);
  std::vector<metric_tensor> tensors;
  for (const site& s : m.sites) tensors.push_back(s.metric);
  const double inside = 2 / std::numbers::sqrt3 * complexity_of(tensors, nodal_areas(m, links));
  double boundary = 0;
  std::size_t sides = 0, outer = 0, used = 0;
  for (vertex_index v = 0; v < m.sites.size(); ++v) used += links.around(v).empty() ? 0 : 1;
  for (vertex_index t = 0; t < m.triangles.size(); ++t)
    for (std::size_t i = 0; i < 3; ++i) {
      ++sides;
      if (links.across(t, i) != no_triangle) continue;
      ++outer;
      const triangle& corners = m.triangles[t];
      boundary +=
          logarithmic_mean_length(m.sites[corners[(i + 1) % 3]], m.sites[corners[(i + 2) % 3]]);
    }
  const double edges = static_cast<double>(sides + outer) / 2;
  const double euler = static_cast<double>(used + m.triangles.size()) - edges;
  return {inside, inside + boundary / 2 + euler};
}

// Compares the number of vertices with options.vertices, for which the metric is scaled, or, if
// that is not set, with the numbers that unit edges take.
bool has_enough_vertices(const mesh& m, const mesh_options& options) {
  constexpr double of_named = 0.02, tolerable = 0.1;
  const auto got = static_cast<double>(m.sites.size());
  if (options.vertices) {
    const auto wanted = static_cast<double>(*options.vertices);
    return std::abs(got - wanted) <= of_named * wanted;
  }
  const unit_counts wanted = vertices_of_unit_edges(m);
  return got >= (1 - tolerable) * wanted.inside && got <= (1 + tolerable) * wanted.all;
}

edge_lengths edge_lengths_of(const mesh& m) {
  const mesh_links links(m);
  edge_lengths found{0, std::numeric_limits<double>::infinity(), 0};
  std::size_t edges = 0, unit = 0;
  for (vertex_index t = 0; t < m.triangles.size(); ++t)
    for (std::size_t i = 0; i < 3; ++i) {
      const vertex_index beyond = links.across(t, i);
      if (beyond != no_triangle && beyond < t) continue;
      const triangle& corners = m.triangles[t];
      const double length =
          logarithmic_mean_length(m.sites[corners[(i + 1) % 3]], m.sites[corners[(i + 2) % 3]]);
      ++edges;
      unit += is_unit_length(length) ? 1 : 0;
      found.least = std::min(found.least, length);
      found.greatest = std::max(found.greatest, length);
    }
  if (edges > 0) found.unit_share = static_cast<double>(unit) / static_cast<double>(edges);
  return found;
}

bool are_as_in_new_mesh(const edge_lengths& lengths) {
  constexpr double least_share = 0.95;
  return lengths.unit_share >= least_share && lengths.least >= least_length &&
         lengths.greatest <= greatest_length;
}

bool are_no_worse(const edge_lengths& lengths, const edge_lengths& of_new) {
  constexpr double alike = 0.02, times = 1.25;
  return lengths.unit_share >= of_new.unit_share - alike &&
         lengths.least >= std::min(least_length, of_new.least / times) &&
         lengths.greatest <= std::max(greatest_length, of_new.greatest * times);
}

// Makes the tests that take little time first.
std::optional<mesh_outcome> outcome_of_keeping(const mesh& m, const domain& shape,
                                               const mesh_options& options) {
  audit_options asked;
  asked.angle_bound = options.angle_bound;
  asked.find_exempt_corners = true;
  asked.original = &shape;
  asked.check_stars = false;
  if (!audit(m, asked).certified) return std::nullopt;
  asked.check_stars = true;
  const auto audited = std::make_shared<const past_audit>(past_audit{audit(m, asked), {}});
  const audit_report& report = audited->report;
  if (!report.certified) return std::nullopt;
  mesh_outcome outcome;
  outcome.complete = true;
  outcome.result = m;
  outcome.sites = m.sites.size();
  outcome.triangles = m.triangles.size();
  outcome.ended.how = ending::complete;
  outcome.ended.sites = outcome.sites;
  outcome.audited = audited;
  for (const vertex_index v : report.exempt_corners)
    outcome.exempt.push_back({v, options.angle_bound});
  for (const vertex_index t : report.exempt_triangles)
    outcome.exempt_triangles.push_back(m.triangles[t]);
  return outcome;
}

}  // namespace asterism::internal
