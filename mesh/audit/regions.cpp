// SPDX-License-Identifier: MIT
//
// Point 2, the regions: every triangle has the number of its part of the domain. A region is
// bounded by segments, so two checks are enough: triangles with no segment between them have one
// number, and that those beside a segment have the number the domain has there.
#include "asterism/mesh/audit/checks.hpp"

namespace asterism::internal::audit_detail {
namespace {

int region_of(const audit_context& context, vertex_index t) {
  const auto& regions = context.subject.regions;
  return regions.empty() ? 1 : regions[t];
}

std::string region_text(const audit_context& context, vertex_index t) {
  return triangle_text(context, t) + " is in region " + std::to_string(region_of(context, t));
}

// Compares the regions on both sides of an edge, once for its two directions.
void check_across(audit_context& context, const directed_edge& e) {
  if (e.a > e.b) return;
  const std::size_t no_subsegment = context.subject.boundary.size();
  const std::size_t across = find_edge(context, e.b, e.a);
  if (across == context.edges.size()) return;
  const vertex_index other = context.edges[across].triangle;
  if (region_of(context, e.triangle) == region_of(context, other)) return;
  if (find_subsegment(context, e.a, e.b) != no_subsegment ||
      find_subsegment(context, e.b, e.a) != no_subsegment)
    return;
  context.found(finding_kind::wrong_region, region_text(context, e.triangle) + ", " +
                                                region_text(context, other) +
                                                ", and no segment is between them");
}

void check_beside_segments(audit_context& context) {
  const auto& segments = context.options.original->segments;
  for (const directed_subsegment& side : context.sides) {
    const auto& segment_index = context.segment_of[side.subsegment];
    const std::size_t edge = find_edge(context, side.a, side.b);
    if (!segment_index || edge == context.edges.size()) continue;
    const segment& s = segments[*segment_index];
    const bool on_left = side.a == context.subject.boundary[side.subsegment].a;
    const int region = on_left ? s.left_region : s.right_region;
    const vertex_index t = context.edges[edge].triangle;
    if (region_of(context, t) != region)
      context.found(finding_kind::wrong_region, region_text(context, t) + ", beside " +
                                                    subsegment_text(context, side.subsegment) +
                                                    " the domain is region " +
                                                    std::to_string(region));
  }
}

}  // namespace

void check_regions(audit_context& context) {
  const mesh& m = context.subject;
  if (!m.regions.empty() && m.regions.size() != m.triangles.size()) {
    context.found(finding_kind::wrong_region,
                  std::to_string(m.regions.size()) + " regions are given for " +
                      std::to_string(m.triangles.size()) + " triangles");
    return;
  }
  if (!m.regions.empty())  // else all are 1
    for (const directed_edge& e : context.edges) check_across(context, e);
  if (context.options.original != nullptr) check_beside_segments(context);
}

void check_regions_again(audit_context& context, const triangulation_changes& changes) {
  const auto& start = context.edge_start;
  for (const vertex_index v : changes.corners)
    for (std::size_t i = start[v]; i < start[v + 1]; ++i) check_across(context, context.edges[i]);
  if (context.options.original != nullptr) check_beside_segments(context);
}

}  // namespace asterism::internal::audit_detail
