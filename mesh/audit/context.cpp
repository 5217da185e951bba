// SPDX-License-Identifier: MIT
#include "asterism/mesh/audit/context.hpp"

#include <algorithm>

namespace asterism::internal::audit_detail {

namespace {

void keep(audit_report& report, std::size_t most, audit_finding finding) {
  std::size_t& count = report.found[static_cast<std::size_t>(finding.kind)];
  if (count++ < most) report.findings.push_back(std::move(finding));
}

void keep_least(audited_angle& least, const audited_angle& other) {
  if (other.degrees < least.degrees) least = other;
}

void append(std::vector<vertex_index>& list, const std::vector<vertex_index>& more) {
  list.insert(list.end(), more.begin(), more.end());
}

// Returns the index of the first edge a -> b in `list`, or its size. `list` is sorted, and the
// edges that leave a begin at start[a].
template <class Item>
std::size_t find_directed(const std::vector<Item>& list, const std::vector<std::size_t>& start,
                          vertex_index a, vertex_index b) {
  std::size_t place = start[a];
  // Bisects by conditional moves in place of branches, which would be mispredicted.
  for (std::size_t left = start[a + 1] - place; left > 1;) {
    const std::size_t half = left / 2;
    place += list[place + half - 1].b < b ? half : 0;
    left -= half;
  }
  return place < start[a + 1] && list[place].b == b ? place : list.size();
}

}  // namespace

void audit_tally::found(finding_kind kind, std::string witness,
                        std::vector<vertex_index> vertices) {
  keep(part, findings_kept, {kind, std::move(witness), std::move(vertices)});
}

const site_tree& audit_context::plant() {
  if (tree != nullptr) return *tree;
  if (former_tree == nullptr) {
    tree = std::make_shared<site_tree>(subject.sites);
    return *tree;
  }
  // Copies the tree where somebody else has it, too.
  tree = former_tree.use_count() == 1 ? std::move(former_tree)
                                      : std::make_shared<site_tree>(*former_tree);
  tree->take_sites(subject.sites);
  return *tree;
}

void audit_context::found(finding_kind kind, std::string witness,
                          std::vector<vertex_index> vertices) {
  keep(report, options.findings_kept, {kind, std::move(witness), std::move(vertices)});
}

void audit_context::take(audit_tally&& tally) {
  // Keeps at most `findings_kept` findings of a kind. Those dropped are counted in the next loop.
  for (audit_finding& finding : tally.part.findings) {
    --tally.part.found[static_cast<std::size_t>(finding.kind)];
    keep(report, options.findings_kept, std::move(finding));
  }
  for (std::size_t kind = 0; kind < finding_kind_count; ++kind)
    report.found[kind] += tally.part.found[kind];
  keep_least(report.worst_ordinary, tally.part.worst_ordinary);
  keep_least(report.worst_collateral, tally.part.worst_collateral);
  keep_least(report.worst_exempt, tally.part.worst_exempt);
  append(report.exempt_triangles, tally.part.exempt_triangles);
  append(report.collateral_triangles, tally.part.collateral_triangles);
  append(report.low_triangles, tally.part.low_triangles);
  report.decisions += tally.part.decisions;
  report.exact_decisions += tally.part.exact_decisions;
  report.star_pairs += tally.part.star_pairs;
  report.star_pairs_tested += tally.part.star_pairs_tested;
  report.voronoi_pairs += tally.part.voronoi_pairs;
  report.voronoi_pairs_exact += tally.part.voronoi_pairs_exact;
  report.counters += tally.part.counters;
  looked_units += tally.looked_units;
  unfinished = unfinished || tally.unfinished;
  if (!told) told = tally.told;
  if (memory != nullptr)
    memory->open.insert(memory->open.end(), tally.left_open.begin(), tally.left_open.end());
}

std::size_t find_edge(const audit_context& context, vertex_index a, vertex_index b) {
  return find_directed(context.edges, context.edge_start, a, b);
}

std::size_t find_subsegment(const audit_context& context, vertex_index a, vertex_index b) {
  const std::size_t place = find_directed(context.sides, context.side_start, a, b);
  return place == context.sides.size() ? context.subject.boundary.size()
                                       : context.sides[place].subsegment;
}

bool same_ray(const point& v, const point& a, const point& b) {
  if (a.x != v.x) return (a.x > v.x) == (b.x > v.x) && b.x != v.x;
  return (a.y > v.y) == (b.y > v.y) && b.y != v.y;
}

std::string vertex_text(const audit_context& context, vertex_index v) {
  std::string text = "vertex " + number_of(context, v);
  if (v < context.subject.sites.size())
    text += " (" + number_text(context.at(v).x) + ", " + number_text(context.at(v).y) + ")";
  return text;
}

std::string triangle_text(const audit_context& context, vertex_index t) {
  const triangle& corners = context.subject.triangles[t];
  return "triangle " + number_of(context, t) + " of " + vertex_text(context, corners[0]) + ", " +
         vertex_text(context, corners[1]) + ", " + vertex_text(context, corners[2]);
}

std::string subsegment_text(const audit_context& context, vertex_index subsegment) {
  const boundary_edge& e = context.subject.boundary[subsegment];
  return (e.internal ? "internal edge " : "boundary edge ") + number_of(context, subsegment) +
         " from " + vertex_text(context, e.a) + " to " + vertex_text(context, e.b);
}

}  // namespace asterism::internal::audit_detail
