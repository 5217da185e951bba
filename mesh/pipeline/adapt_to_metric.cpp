// SPDX-License-Identifier: MIT
#include "asterism/mesh/pipeline/adapt_to_metric.hpp"

#include <algorithm>
#include <cmath>
#include <memory>
#include <numbers>
#include <utility>

#include "asterism/mesh/audit/audit.hpp"
#include "asterism/mesh/domain/mesh_outline.hpp"
#include "asterism/mesh/metric/interpolated_field.hpp"
#include "asterism/mesh/pipeline/foreign_mesh.hpp"
#include "asterism/mesh/solution/nodal_sums.hpp"
#include "asterism/mesh/solution/optimal_metric.hpp"

namespace asterism {
using namespace internal;
namespace {

double vertices_wanted(const mesh& m) {
  const mesh_links links(m);
  std::vector<metric_tensor> tensors;
  for (const site& s : m.sites) tensors.push_back(s.metric);
  return 2 / std::numbers::sqrt3 * complexity_of(tensors, nodal_areas(m, links));
}

bool has_enough(const mesh& m) {
  constexpr double tolerable = 0.1;
  const double wanted = vertices_wanted(m);
  return std::abs(static_cast<double>(m.sites.size()) - wanted) <= tolerable * wanted;
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
  if (!has_enough(m)) return std::nullopt;
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

mesh_options options_for(const mesh& m, const mesh_adaptation_options& asked) {
  mesh_options options = asked.refinement;
  options.limit_size = true;
  if (asked.keeps_site_limit) return options;
  const double room = std::min(3 * vertices_wanted(m) + 1000, 1e8);
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
