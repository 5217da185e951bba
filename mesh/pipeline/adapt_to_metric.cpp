// SPDX-License-Identifier: MIT
#include "asterism/mesh/pipeline/adapt_to_metric.hpp"

#include <algorithm>
#include <cmath>
#include <memory>
#include <numbers>
#include <utility>

#include "asterism/core/elementary.hpp"
#include "asterism/mesh/audit/audit.hpp"
#include "asterism/mesh/domain/mesh_outline.hpp"
#include "asterism/mesh/metric/interpolated_field.hpp"
#include "asterism/mesh/pipeline/foreign_mesh.hpp"
#include "asterism/mesh/solution/nodal_sums.hpp"
#include "asterism/mesh/solution/optimal_metric.hpp"

namespace asterism {
using namespace internal;
namespace {

// Numbers of vertices of a mesh with unit edges.
struct unit_counts {
  double inside;  // as the area alone has it
  double all;     // with the boundary
};

double length_in(const metric_tensor& m, const point& d) {
  return std::sqrt(d.x * (m.m11 * d.x + 2 * m.m12 * d.y) + m.m22 * d.y * d.y);
}

// Returns the logarithmic mean of what the two ends measure, which is the length in a metric that
// changes geometrically from one to the other.
double edge_length(const site& a, const site& b) {
  const point d{b.position.x - a.position.x, b.position.y - a.position.y};
  const double at_a = length_in(a.metric, d), at_b = length_in(b.metric, d);
  const double ratio = at_a / at_b;
  constexpr double alike = 1e-3;  // the two means differ by less than 1e-7 of them there
  return std::abs(ratio - 1) > alike ? (at_a - at_b) / elementary::log(ratio) : (at_a + at_b) / 2;
}

// Triangles of unit edges have an area of sqrt(3) / 4, and the vertices are half of the triangles,
// half of the edges of the boundary and the Euler characteristic.
unit_counts unit_counts_of(const mesh& m) {
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
      boundary += edge_length(m.sites[corners[(i + 1) % 3]], m.sites[corners[(i + 2) % 3]]);
    }
  const double edges = static_cast<double>(sides + outer) / 2;
  const double euler = static_cast<double>(used + m.triangles.size()) - edges;
  return {inside, inside + boundary / 2 + euler};
}

// True if the mesh has as many vertices as its metric asks for, to a tenth. Meshes made with so
// many vertices wanted have a metric in which the area alone has them, others one of unit edges.
bool has_enough(const mesh& m, const mesh_options& options) {
  constexpr double tolerable = 0.1;
  const auto got = static_cast<double>(m.sites.size());
  if (options.vertices) {
    const auto wanted = static_cast<double>(*options.vertices);
    return std::abs(got - wanted) <= tolerable * wanted;
  }
  const unit_counts wanted = unit_counts_of(m);
  return got >= (1 - tolerable) * wanted.inside && got <= (1 + tolerable) * wanted.all;
}

// Returns the mesh as one of the domain found, where that has its first vertices.
std::optional<mesh> as_mesh_of(const mesh& m, const mesh_outline& outline) {
  if (outline.segment_of_edge.empty()) return std::nullopt;
  mesh same = m;
  same.given = static_cast<vertex_index>(outline.shape.vertices.size());
  for (std::size_t e = 0; e < same.boundary.size(); ++e)
    same.boundary[e].segment = outline.segment_of_edge[e];
  return same;
}

// Returns the outcome of leaving the mesh as it is, where it meets its metric. What costs little is
// looked at first.
std::optional<mesh_outcome> outcome_of_keeping(const mesh& m, const domain& shape,
                                               const mesh_options& options) {
  if (!has_enough(m, options)) return std::nullopt;
  audit_options asked;
  asked.angle_bound = options.angle_bound;
  asked.find_exempt_corners = true;
  asked.original = &shape;
  asked.check_stars = false;
  if (!audit(m, asked).certified) return std::nullopt;
  asked.check_stars = true;
  const auto report = std::make_shared<const audit_report>(audit(m, asked));
  if (!report->certified) return std::nullopt;
  mesh_outcome outcome;
  outcome.complete = true;
  outcome.result = m;
  outcome.sites = m.sites.size();
  outcome.triangles = m.triangles.size();
  outcome.ended.how = ending::complete;
  outcome.ended.sites = outcome.sites;
  outcome.audited = report;
  for (const vertex_index v : report->exempt_corners)
    outcome.exempt.push_back({v, options.angle_bound});
  for (const vertex_index t : report->exempt_triangles)
    outcome.exempt_triangles.push_back(m.triangles[t]);
  return outcome;
}

// Sets the number of vertices wanted, and room for it. A metric alone gets ten times as many as the
// mesh has, and what any run may have: what asks for more is a slip of the unit more often than
// not, and millions of vertices do not end in a coffee break.
mesh_options options_for(const mesh& m, const mesh_adaptation_options& asked) {
  mesh_options options = asked.refinement;
  options.limit_size = true;
  constexpr double most = 1e8, times = 3, more = 1000, growth = 10;
  const bool names_count = options.vertices.has_value();
  const double wanted =
      names_count ? static_cast<double>(*options.vertices) : unit_counts_of(m).all;
  if (!names_count && wanted >= 1 && wanted < most)
    options.vertices = static_cast<std::size_t>(std::lround(wanted));
  if (asked.keeps_site_limit) return options;
  double room = std::min(times * wanted + more, most);
  if (!names_count) room = std::min(room, growth * static_cast<double>(m.sites.size()));
  options.max_sites = std::max(options.max_sites, static_cast<std::size_t>(room));
  return options;
}

}  // namespace

result<adapted_mesh> adapt_to_metric(const marked_mesh& from,
                                     const mesh_adaptation_options& options,
                                     const progress_listener& progress) {
  auto adopted = adopt_mesh(from.subject);
  if (!adopted) return adopted.failure();
  const mesh& background = adopted.value().subject;
  adapted_mesh done;
  std::optional<mesh_outcome> same;
  if (options.exact) {
    done.shape = *options.exact;
  } else {
    auto outline = outline_of_mesh(background, from.marks, options.corner_angle);
    if (!outline) return outline.failure();
    const mesh_outline& found = outline.value();
    done.shape = found.keeps_all ? adopted.value().shape : found.shape;
    done.boundary_vertices = found.boundary_vertices;
    done.keeps_boundary = found.keeps_all;
    done.boundary_kept = found.keeps_all ? found.boundary_vertices : found.kept;
    done.boundary_distance = found.greatest_distance;
    if (const auto m = as_mesh_of(background, found))
      same = outcome_of_keeping(*m, done.shape, options.refinement);
  }
  if (same) {
    done.kept = true;
    done.made = judge_outcome(*std::move(same), done.shape, options.refinement);
    return done;
  }
  const auto field = make_sampled_field(background, 1);
  const mesh_options how = options_for(background, options);
  auto made = make_certified_mesh(done.shape, *field, how, progress);
  if (!made) return made.failure();
  done.made = std::move(made).value();
  return done;
}

}  // namespace asterism
