// SPDX-License-Identifier: MIT
#include "asterism/mesh/audit/audit.hpp"

#include <algorithm>
#include <iterator>
#include <numeric>
#include <utility>

#include "asterism/kernels/filtered_edge_test.hpp"
#include "asterism/mesh/audit/audit_again.hpp"
#include "asterism/mesh/audit/audit_work.hpp"
#include "asterism/mesh/audit/context.hpp"
#include "asterism/mesh/audit/shared_tree.hpp"

namespace asterism {
using namespace internal;

const std::array<std::string_view, finding_kind_count> finding_kind_names = {
    "invalid_option",
    "empty_mesh",
    "disagreeing_triangles",
    "index_out_of_range",
    "not_finite",
    "metric_not_positive_definite",
    "repeated_position",
    "repeated_corner",
    "repeated_triangle",
    "orientation",
    "repeated_edge",
    "unmatched_edge",
    "boundary_without_triangle",
    "boundary_inside",
    "repeated_boundary",
    "open_boundary",
    "boundary_contact",
    "wrong_winding",
    "unused_vertex",
    "broken_fan",
    "given_changed",
    "segment_not_covered",
    "marker_changed",
    "side_changed",
    "boundary_deviation",
    "curve_deviation",
    "wrong_region",
    "angle_below_bound",
    "collateral_angle_below_bound",
    "exemption_not_proven",
    "nothing_judged",
    "star_neighbour_rejected",
    "star_site_missing",
    "stopped",
    "voronoi_vertex_missing",
    "voronoi_arc_reversed",
    "voronoi_site_nearer",
    "voronoi_boundary_encroached",
};

const std::array<std::string_view, 4> voronoi_verdict_names = {"not asked", "not reached",
                                                               "refused", "proved"};

std::size_t audit_report::total_found() const {
  return std::accumulate(found.begin(), found.end(), std::size_t{0});
}

std::vector<vertex_index> audit_report::refused_triangles() const {
  std::vector<vertex_index> all;
  std::set_union(low_triangles.begin(), low_triangles.end(), collateral_triangles.begin(),
                 collateral_triangles.end(), std::back_inserter(all));
  return all;
}

namespace {

// Audits everything, or of the stars only what concerns the sites in `changed`, unless that is
// null, as may be `memory`, and `tree`, which is set to the tree that was made.
audit_report audit_stars_of(const mesh& subject, const audit_options& options,
                            const std::vector<vertex_index>* changed, star_memory* memory,
                            hard_questions hard, shared_tree* tree = nullptr) {
  using namespace audit_detail;
  audit_report report;
  report.sites = subject.sites.size();
  report.triangles = subject.triangles.size();
  report.boundary_subsegments = subject.boundary.size();
  report.given = subject.given;

  audit_context context(subject, options, report);
  context.changed = changed;
  context.memory = memory;
  context.leaves_open = hard == hard_questions::left_open;
  if (memory != nullptr) memory->open.clear();
  check_values(context);
  check_orientations(context);
  check_edges(context);
  check_boundary_contacts(context);
  // The rest of point 2 is a statement about matched edges and a simple boundary.
  const bool matched = report.total_found() == 0;
  if (matched) {
    check_winding(context);
    check_fans(context);
  }
  const bool triangulation = report.total_found() == 0;
  if (options.original != nullptr) check_domain_kept(context);
  check_regions(context);
  check_angles(context);
  check_something_judged(context);
  if (options.check_stars && triangulation) check_stars(context);

  report.certified = report.total_found() == 0 && (memory == nullptr || memory->open.empty());
  if (options.check_voronoi) {
    report.voronoi = voronoi_verdict::not_reached;
    if (triangulation) check_voronoi(context);
  }
  // Angles take the auditor's own arithmetic, and findings sentences.
  constexpr double a_decision = 0.003, an_exact_one = 1, a_finding = 0.5;
  options.stop.charge(audit_units(report, context.looked_units) +
                      a_decision * static_cast<double>(report.decisions) +
                      an_exact_one * static_cast<double>(report.exact_decisions) +
                      a_finding * static_cast<double>(report.findings.size()));
  if (tree != nullptr) *tree = std::move(context.tree);
  return report;
}

}  // namespace

audit_report audit(const mesh& subject, const audit_options& options) {
  return audit_stars_of(subject, options, nullptr, nullptr, hard_questions::asked);
}

audit_report internal::audit_sharing(const mesh& subject, const audit_options& options,
                                     shared_tree& tree) {
  return audit_stars_of(subject, options, nullptr, nullptr, hard_questions::asked, &tree);
}

audit_report internal::audit_quickly(const mesh& subject, const audit_options& options,
                                     star_memory& memory) {
  memory.reaches.clear();
  return audit_stars_of(subject, options, nullptr, &memory, hard_questions::left_open);
}

audit_report internal::audit_numbers(const mesh& subject) {
  const audit_options options;
  audit_report report;
  audit_detail::audit_context context(subject, options, report);
  check_values(context);
  return report;
}

void internal::ask_filters(const mesh& subject, const cancellation& stop,
                           const std::function<bool(const open_question&)>& is_asked,
                           const std::function<void(const open_question&)>& refuse,
                           std::vector<open_question>& open, audit_report& report) {
  tier_counters decided;
  const auto is_in_order = [&](const open_question& question) {
    if (question.what == open_question::about::gap) return false;
    const auto at = [&](std::size_t i) { return subject.sites[question.sites[i]]; };
    const uncertain_bool accepted = filtered_edge_test(at(0), at(1), at(2), at(3), decided);
    const bool is_to_be = question.what == open_question::about::neighbour;
    return accepted.certain() && accepted.value() == is_to_be;
  };
  std::vector<open_question> left;
  for (const open_question& question : open) {
    const bool asked = is_asked(question);
    if (asked && is_in_order(question)) continue;
    if (asked) refuse(question);
    left.push_back(question);
  }
  open = std::move(left);
  report.counters += decided;
  report.certified = report.total_found() == 0 && open.empty();
  stop.charge(work_units(decided));
}

audit_report internal::audit_again(const mesh& subject, const audit_options& options,
                                   const audit_report& before,
                                   const std::vector<vertex_index>& changed, star_memory& memory,
                                   hard_questions hard) {
  audit_report report = audit_stars_of(subject, options, &changed, &memory, hard);
  report.decisions += before.decisions;
  report.exact_decisions += before.exact_decisions;
  report.star_pairs += before.star_pairs;
  report.star_pairs_tested += before.star_pairs_tested;
  report.counters += before.counters;
  return report;
}

}  // namespace asterism
