// SPDX-License-Identifier: MIT
//
// Holds the state that the checks of one audit share; inside the auditor alone.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "asterism/core/number_text.hpp"
#include "asterism/kernels/filtered_kernel.hpp"
#include "asterism/mesh/audit/audit_memory.hpp"
#include "asterism/mesh/audit/audit_report.hpp"
#include "asterism/mesh/audit/checked_triangulation.hpp"
#include "asterism/mesh/audit/number.hpp"
#include "asterism/mesh/audit/site_tree.hpp"
#include "asterism/mesh/support/parallel.hpp"
#include "asterism/mesh/support/prefetch.hpp"

namespace asterism::internal::audit_detail {

// Findings and counts of one part of a check, made by one thread. `part` holds findings, counts and
// the least angles of that part.
struct audit_tally {
  std::size_t findings_kept = 0;
  audit_report part;
  double most_units = 0;            // of work (audit/audit_work.hpp) that this part may do
  double looked_units = 0;          // of work that no other number tells
  bool unfinished = false;          // the part ended early, for want of work or as it was told to
  std::optional<std::string> told;  // why it was told to; asked later, the answer may be none
  std::vector<open_question> left_open;

  // True if a further finding of the kind is kept; otherwise it is only counted, and its witness
  // may be empty.
  bool is_kept(finding_kind kind) const {
    return part.found[static_cast<std::size_t>(kind)] < findings_kept;
  }
  // Returns a kernel that counts its decisions in `part`.
  filtered_kernel kernel() { return filtered_kernel(part.counters); }

  void found(finding_kind kind, std::string witness, std::vector<vertex_index> vertices = {});
};

struct audit_context : triangulation_lists {
  audit_context(const mesh& m, const audit_options& o, audit_report& r)
      : subject(m), options(o), report(r) {}

  // Returns the tree of the mesh's sites, which is made where it is first asked for: from that of
  // the audit before, if the triangulation is the same.
  const site_tree& plant();

  const mesh& subject;
  const audit_options& options;
  audit_report& report;
  // Indices of sites whose tensors were changed since all stars were checked; null to check
  // everything. With a list, only questions that involve one of the sites are asked (auditor.hpp).
  const std::vector<vertex_index>* changed = nullptr;
  // Carries reaches, open questions and lists from one audit of a mesh to the next; may be null.
  audit_memory* memory = nullptr;
  bool leaves_open = false;        // hard questions about stars, to the memory
  std::size_t many_for_a_gap = 0;  // sites, for a gap of which no reach is known to be a hard one
  std::size_t many_open_at_a_gap = 0;  // questions about a gap, for the gap itself to be left open

  // Returns a kernel that counts its decisions in the report: for the thread that owns the context.
  filtered_kernel kernel() const { return filtered_kernel(report.counters); }

  std::vector<char> measured;  // flags of sites: placed, and a positive definite metric
  // Upper bound of the cotangents of each triangle's angles in the metrics of its corners, made by
  // check_angles; infinite where one is low or not ordinary. Those passed by the audit before hold
  // for triangles without a changed corner.
  std::vector<double> angle_bounds;
  bool is_new = false;  // the triangulation was checked in this audit, without a finding
  // The triangulation that the audit before checked, if it is this one, and whether it has lent its
  // lists to the context; else null.
  std::shared_ptr<checked_triangulation> known;
  bool are_lists_lent = false;
  // Work units that no counter of the report shows (audit/audit_work.hpp), and whether a part of a
  // check ended early.
  double looked_units = 0;
  bool unfinished = false;
  std::optional<std::string> told;  // the reason, if it was told to end
  double share_of_work = 1;         // of the most that an audit may do
  // Tree of the mesh's sites; none where it was not asked for. `former_tree` is of the same sites
  // as they were in the audit before; none where there was no such audit.
  std::shared_ptr<site_tree> tree, former_tree;

  // Prefetches the sites of one of `triangles`, or of the edges that leave v.
  void prefetch_corners(std::size_t nth) const {
    if (nth >= triangles.size()) return;
    for (const vertex_index v : subject.triangles[triangles[nth]]) prefetch(&subject.sites[v]);
  }
  void prefetch_around(std::size_t v) const {
    if (v + 1 >= edge_start.size()) return;
    prefetch(&subject.sites[v]);
    for (std::size_t i = edge_start[v]; i < edge_start[v + 1]; ++i)
      prefetch(&subject.sites[edges[i].b]);
  }

  const point& at(vertex_index v) const { return subject.sites[v].position; }
  sign orientation(vertex_index a, vertex_index b, vertex_index c) const {
    return kernel().orientation(at(a), at(b), at(c));
  }
  void found(finding_kind kind, std::string witness, std::vector<vertex_index> vertices = {});
  // Adds the findings and counts of one part of a check.
  void take(audit_tally&& tally);
};

// Calls check(tally, begin, end) for chunks of [0, count), in parallel, and returns their tallies
// in order. A check may write only the entries of its own chunk into the context. The work limit of
// each chunk is an even share of `units`.
template <class Check>
std::vector<audit_tally> tallies_of(const audit_context& context, std::size_t count,
                                    const Check& check, std::size_t chunk, double units) {
  std::vector<audit_tally> tallies(chunk_count(count, chunk));
  parallel_chunks(count, chunk, [&](std::size_t i, std::size_t begin, std::size_t end) {
    tallies[i].findings_kept = context.options.findings_kept;
    tallies[i].most_units = units / static_cast<double>(tallies.size());
    check(tallies[i], begin, end);
  });
  return tallies;
}

// Runs the check in parallel and adds the tallies in order, so that the report equals that of one
// thread.
template <class Check>
void check_in_parallel(audit_context& context, std::size_t count, const Check& check,
                       std::size_t chunk = 1024, double units = 0) {
  for (audit_tally& tally : tallies_of(context, count, check, chunk, units))
    context.take(std::move(tally));
}

// Returns count + 1 indices into a list sorted by `a`: where the entries of each a < count begin,
// then the end.
template <class Item>
std::vector<std::size_t> starts_of(const std::vector<Item>& sorted, std::size_t count) {
  std::vector<std::size_t> start(count + 1, 0);
  for (const Item& item : sorted) ++start[item.a + 1];
  for (std::size_t v = 0; v < count; ++v) start[v + 1] += start[v];
  return start;
}

// Returns the index of the edge a -> b in context.edges, or the size of that list if there is none.
std::size_t find_edge(const audit_context& context, vertex_index a, vertex_index b);
// Returns the index, in subject.boundary, of the boundary edge with the domain on the left of a ->
// b, or the size of that list if there is none.
std::size_t find_subsegment(const audit_context& context, vertex_index a, vertex_index b);
// True if two points known to be collinear with v are on the same side of it.
bool same_ray(const point& v, const point& a, const point& b);

// Returns the number of an index in witnesses.
inline std::string number_of(const audit_context& context, std::size_t index) {
  return std::to_string(index + static_cast<std::size_t>(context.options.first_number));
}
// Return the texts of witnesses, whose coordinates read back to the same double.
std::string vertex_text(const audit_context& context, vertex_index v);
std::string triangle_text(const audit_context& context, vertex_index t);
std::string subsegment_text(const audit_context& context, vertex_index subsegment);

template <class Number>
vector2<Number> difference(const point& to, const point& from) {
  return {Number(to.x) - Number(from.x), Number(to.y) - Number(from.y)};
}
template <class Number>
tensor<Number> tensor_of(const metric_tensor& m) {
  return {Number(m.m11), Number(m.m12), Number(m.m22)};
}

}  // namespace asterism::internal::audit_detail
