// SPDX-License-Identifier: MIT
#include "asterism/mesh/audit/auditor.hpp"

#include <cstddef>
#include <memory>
#include <optional>
#include <utility>

#include "asterism/kernels/filtered_edge_test.hpp"
#include "asterism/mesh/audit/audit_work.hpp"
#include "asterism/mesh/audit/checks.hpp"
#include "asterism/mesh/audit/site_tree.hpp"
#include "asterism/mesh/audit/theorem_of_mesh.hpp"
#include "asterism/mesh/support/parallel_for.hpp"
#include "asterism/mesh/support/work_weights.hpp"

namespace asterism::internal {
namespace {

using namespace audit_detail;

// Charges the run for the audit's work: decisions of the kernel and of the auditor's own
// arithmetic, and the sentences written for findings.
void charge(const audit_context& context) {
  const audit_report& report = context.report;
  context.options.stop.charge(
      audit_units(report, context.looked_units) +
      work_weights::audit_decision * static_cast<double>(report.decisions) +
      work_weights::audit_exact_decision * static_cast<double>(report.exact_decisions) +
      work_weights::audit_finding_text * static_cast<double>(report.findings.size()));
}

// Checks points 0 to 2. Returns false where the mesh is no triangulation.
bool check_covering(audit_context& context) {
  audit_report& report = context.report;
  check_values(context);
  check_orientations(context);
  check_edges(context);
  check_boundary_contacts(context);
  // Requires matched edges and a simple boundary: the rest of point 2 is only defined for these.
  const bool matched = report.total_found() == 0;
  if (matched) {
    check_winding(context);
    check_fans(context);
  }
  return report.total_found() == 0;
}

audit_report counts_of(const mesh& subject) {
  audit_report report;
  report.sites = subject.sites.size();
  report.triangles = subject.triangles.size();
  report.boundary_subsegments = subject.boundary.size();
  report.given = subject.given;
  return report;
}

// Forgets the triangulation that the audit before checked, and takes the memory of its edges, most
// of that of an audit's lists: new memory takes time. `before` still has its lists; null where they
// are in the context, or another audit has them, too.
void forget_checked(audit_context& context, checked_triangulation* before) {
  auto& lists = static_cast<triangulation_lists&>(context);
  std::vector<directed_edge> edges = std::move(lists.edges);
  if (before != nullptr) edges = before->lend_lists().edges;
  edges.clear();
  lists = {};
  lists.edges = std::move(edges);
  context.known = nullptr;
  context.former_tree = nullptr;
  context.are_lists_lent = false;
  context.angle_bounds.clear();
}

// Takes the lists of the triangulation that the audit before checked, and returns the changes
// since. Where there are others than those of tensors and a few triangles, forgets it and returns
// nothing.
std::optional<triangulation_changes> take_checked(audit_context& context) {
  if (context.memory == nullptr) return std::nullopt;
  auto before = std::move(context.memory->triangulation);
  auto tree = std::move(context.memory->tree);
  context.angle_bounds = std::move(context.memory->angle_bounds);
  std::optional<triangulation_changes> changes;
  if (context.changed != nullptr && before != nullptr)
    changes = before->changes_to(context.subject, context.options.original);
  // A copy takes as long as several of the checks, most of it for new memory. One is needed only
  // where others have the triangulation, too.
  context.are_lists_lent = before.use_count() == 1;
  if (!changes || !(changes->triangles.empty() || context.are_lists_lent)) {
    forget_checked(context, context.are_lists_lent ? before.get() : nullptr);
    return std::nullopt;
  }
  auto& lists = static_cast<triangulation_lists&>(context);
  // A conditional expression would make a constant of the lists lent, and copy them.
  if (context.are_lists_lent)
    lists = before->lend_lists();
  else
    lists = before->lists();
  before->enter_measurements(context.report);
  context.known = std::move(before);
  context.former_tree = std::move(tree);
  return changes;
}

// Checks the triangles and places that have changed since the triangulation was checked. With a
// finding, forgets the triangulation and the finding: a check of all will name it in its order.
bool check_changes(audit_context& context, const triangulation_changes& changes) {
  if (changes.triangles.empty()) return true;
  for (const auto check :
       {check_values_again, check_edges_again, check_fans_again, check_regions_again}) {
    check(context, changes);
    if (context.report.total_found() == 0) continue;
    context.report = counts_of(context.subject);
    forget_checked(context, nullptr);
    return false;
  }
  context.known->take_changes(context.subject, changes);
  return true;
}

// Checks points 0 to 2, the domain and the regions; of a triangulation checked before, the tensors
// and what has changed. Returns false where the mesh is no triangulation.
bool check_triangulation(audit_context& context) {
  const auto changes = take_checked(context);
  if (changes && check_changes(context, *changes)) {
    check_sites(context);
    return context.report.total_found() == 0;
  }
  const bool is_one = check_covering(context);
  if (context.options.original != nullptr) check_domain_kept(context);
  check_regions(context);
  context.is_new = is_one && context.report.total_found() == 0;
  return is_one;
}

// Passes what was checked of the triangulation and its angles to the next audit.
void remember_triangulation(audit_context& context) {
  if (context.memory == nullptr) return;
  context.memory->tree = context.tree != nullptr ? context.tree : context.former_tree;
  context.memory->angle_bounds = std::move(context.angle_bounds);
  auto& lists = static_cast<triangulation_lists&>(context);
  if (context.are_lists_lent)
    context.known->take_back(std::move(lists));
  else if (context.is_new)
    context.known = std::make_shared<checked_triangulation>(
        context.subject, context.options.original, std::move(lists), context.report);
  if (context.known != nullptr) context.memory->triangulation = std::move(context.known);
}

// Runs all checks that the options call for, one point after the other.
void check_all(audit_context& context) {
  const audit_options& options = context.options;
  audit_report& report = context.report;
  const bool triangulation = check_triangulation(context);
  audit_detail::check_angles(context);
  check_something_judged(context);
  if (options.check_stars && triangulation) check_stars(context);
  const bool are_open = context.memory != nullptr && !context.memory->open.empty();
  report.certified = report.total_found() == 0 && !are_open;
  if (options.check_voronoi) {
    report.voronoi = voronoi_verdict::not_reached;
    if (triangulation) check_voronoi(context);
  }
}

}  // namespace

auditor::auditor(const mesh& subject, audit_options asked)
    : subject_(&subject), asked_(std::move(asked)) {}

auditor::auditor(const mesh& subject, audit_options asked, past_audit before)
    : subject_(&subject),
      asked_(std::move(asked)),
      report_(std::move(before.report)),
      memory_(std::move(before.memory)) {}

auditor::auditor(auditor&&) noexcept = default;
auditor::~auditor() = default;

// Audits all points. Remembers reaches and open questions of stars only if open questions are
// allowed, since recheck() needs them only then.
const audit_report& auditor::run(const audit_effort& effort) {
  const bool remembers = effort.hard == hard_questions::left_open;
  memory_ = {};
  ask(nullptr, remembers ? &memory_ : nullptr, effort);
  return report_;
}

const audit_report& auditor::recheck(const std::vector<vertex_index>& changed,
                                     const audit_effort& effort) {
  const audit_report before = std::move(report_);
  ask(&changed, &memory_, effort);
  report_.decisions += before.decisions;
  report_.exact_decisions += before.exact_decisions;
  report_.star_pairs += before.star_pairs;
  report_.star_pairs_tested += before.star_pairs_tested;
  report_.counters += before.counters;
  return report_;
}

// Runs all checks. Restricts those of stars to the questions that involve a site in `changed`; a
// null pointer checks all stars.
void auditor::ask(const std::vector<vertex_index>* changed, audit_memory* memory,
                  const audit_effort& effort) {
  report_ = counts_of(*subject_);
  audit_context context(*subject_, asked_, report_);
  context.changed = changed;
  context.memory = memory;
  context.leaves_open = effort.hard == hard_questions::left_open;
  context.many_for_a_gap = effort.many_for_a_gap;
  context.many_open_at_a_gap = effort.many_open_at_a_gap;
  if (memory != nullptr) memory->open.clear();
  check_all(context);
  charge(context);
  remember_triangulation(context);
  tree_ = std::move(context.tree);
}

const audit_report& auditor::check_numbers() {
  report_ = {};
  audit_context context(*subject_, asked_, report_);
  check_input(context);
  return report_;
}

const audit_report& auditor::check_triangulation() {
  report_ = counts_of(*subject_);
  audit_context context(*subject_, asked_, report_);
  check_covering(context);
  check_regions(context);
  report_.certified = report_.total_found() == 0;
  charge(context);
  return report_;
}

const audit_report& auditor::check_angles() {
  report_ = counts_of(*subject_);
  audit_context context(*subject_, asked_, report_);
  auto& lists = static_cast<triangulation_lists&>(context);
  checked_triangulation* const before = memory_.triangulation.get();
  const bool has_lists = before != nullptr && before->has_lists_of(*subject_);
  if (has_lists) {
    lists = before->lend_lists();  // until the angles are checked, which changes none of them
    check_sites(context);
  } else {
    check_values(context);
    check_orientations(context);
    check_edges(context);
  }
  audit_detail::check_angles(context);
  if (has_lists) before->take_back(std::move(lists));
  charge(context);
  return report_;
}

void auditor::ask_filters(const std::function<bool(const open_question&)>& is_asked,
                          const std::function<void(const open_question&)>& refuse) {
  tier_counters decided;
  const auto is_in_order = [&](const open_question& question) {
    if (question.what == open_question::about::gap) return false;
    const auto at = [&](std::size_t i) { return subject_->sites[question.sites[i]]; };
    const uncertain_bool accepted = filtered_edge_test(at(0), at(1), at(2), at(3), decided);
    const bool is_to_be = question.what == open_question::about::neighbour;
    return accepted.certain() && accepted.value() == is_to_be;
  };
  std::vector<open_question> left;
  for (const open_question& question : memory_.open) {
    const bool asked = is_asked(question);
    if (asked && is_in_order(question)) continue;
    if (asked) refuse(question);
    left.push_back(question);
  }
  memory_.open = std::move(left);
  report_.counters += decided;
  report_.certified = report_.total_found() == 0 && memory_.open.empty();
  asked_.stop.charge(work_units(decided));
}

std::shared_ptr<const site_tree> auditor::known_tree() const {
  if (tree_ != nullptr || memory_.tree == nullptr) return tree_;
  const auto copy = std::make_shared<site_tree>(*memory_.tree);
  copy->take_sites(subject_->sites);
  return copy;
}

certificate auditor::make_certificate(const cancellation& account) const {
  std::optional<theorem_hypotheses> theorem;
  certificate made;
  parallel_for(2, [&](std::size_t i) {
    if (i == 1)
      made = asterism::make_certificate(*subject_, asked_, report_, std::nullopt);
    else if (is_theorem_asked(asked_, report_))
      theorem = theorem_of_mesh(*subject_, *asked_.angle_bound, account, known_tree().get());
  });
  made.theorem = std::move(theorem);
  return made;
}

}  // namespace asterism::internal
