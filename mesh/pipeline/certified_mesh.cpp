// SPDX-License-Identifier: MIT
#include "asterism/mesh/pipeline/certified_mesh.hpp"

#include <new>
#include <utility>

#include "asterism/core/number_text.hpp"
#include "asterism/mesh/audit/shared_tree.hpp"
#include "asterism/mesh/numerics/mesh_statistics.hpp"
#include "asterism/mesh/pipeline/outcome_text.hpp"
#include "asterism/mesh/pipeline/unconfirmed_mesh.hpp"

namespace asterism {
namespace {

// Returns the question alone, without the account: what is found of an outcome may not depend on
// what was done before it, as those who verify have no account.
cancellation question_of(const cancellation& stop) {
  return [stop]() { return stop.told(); };
}

// Returns what the auditor is asked of an outcome. It finds the sharp corners by itself: the
// mesher's own list is of rounded angles, and names corners at which no triangle needs an
// exemption.
audit_options questions_for(const mesh_outcome& outcome, const domain& d,
                            const mesh_options& options) {
  audit_options asked;
  asked.angle_bound = options.angle_bound;
  asked.original = &d;
  asked.find_exempt_corners = true;
  // Whoever interrupts a run does not want to wait for the stars of a mesh that is not finished.
  asked.check_stars = !outcome.stopped;
  asked.check_voronoi = options.prove_voronoi && !outcome.stopped;
  // A run that was told to end has what there is audited all the same.
  if (outcome.ended.how != ending::stopped && !outcome.stopped)
    asked.stop = question_of(options.stop);
  return asked;
}

// Returns what the auditor finds. Where there is no memory for an audit, which takes more than the
// mesh does, it says so: the mesh must not be lost for that.
audit_report audit_if_possible(const mesh& subject, const audit_options& asked,
                               internal::shared_tree& tree) {
  try {
    return internal::audit_sharing(subject, asked, tree);
  } catch (const std::bad_alloc&) {
    audit_report nothing;
    nothing.sites = subject.sites.size();
    nothing.triangles = subject.triangles.size();
    nothing.boundary_subsegments = subject.boundary.size();
    nothing.given = subject.given;
    nothing.found[static_cast<std::size_t>(finding_kind::stopped)] = 1;
    nothing.findings.push_back({finding_kind::stopped, "there was not enough memory for it"});
    if (asked.check_voronoi) nothing.voronoi = voronoi_verdict::not_reached;
    return nothing;
  }
}

}  // namespace

bool internal::may_be_confirmed(const certified_mesh& judged, const mesh_options& options) {
  const mesh_outcome& outcome = judged.outcome;
  if (!outcome.complete || outcome.delivered || outcome.one_metric || options.improve_passes > 0)
    return false;
  const auto found = [&](finding_kind kind) {
    return judged.report.found[static_cast<std::size_t>(kind)] > 0;
  };
  return found(finding_kind::star_neighbour_rejected) || found(finding_kind::star_site_missing);
}

certified_mesh judge_outcome(mesh_outcome outcome, const domain& d, const mesh_options& options) {
  audit_options asked = questions_for(outcome, d, options);
  certified_mesh judged;
  const bool is_known =
      outcome.audited && asked.check_stars && !asked.check_voronoi && asked.exempt_corners.empty();
  internal::shared_tree tree;
  judged.report = is_known ? *outcome.audited : audit_if_possible(outcome.result, asked, tree);
  if (options.prove_voronoi && outcome.stopped)
    judged.report.voronoi = voronoi_verdict::not_reached;
  certificate& claim = judged.claim;
  asked.stop = options.stop;
  claim = internal::make_certificate_sharing(outcome.result, asked, judged.report, std::move(tree));
  claim.complete = outcome.complete;
  claim.reason = ending_text(outcome);
  claim.mesher_counters = outcome.counters;
  claim.star_repairs = outcome.star_repairs;
  claim.delivered = outcome.delivered;
  if (options.metric_tolerance)
    claim.options["metric-tolerance"] = internal::number_text(*options.metric_tolerance);
  claim.measured = by_name(measure(outcome.result));
  judged.outcome = std::move(outcome);
  return judged;
}

result<certified_mesh> make_certified_mesh(const domain& d, const metric_field& field,
                                           const mesh_options& options,
                                           const progress_listener& progress) {
  const auto judge = [&](result<mesh_outcome> made) -> result<certified_mesh> {
    if (!made) return made.failure();
    if (progress) progress({.phase = mesh_phase::auditing, .sites = made.value().sites});
    return judge_outcome(std::move(made).value(), d, options);
  };
  auto judged = judge(internal::make_unconfirmed_mesh(d, field, options, progress));
  if (!judged || !internal::may_be_confirmed(judged.value(), options)) return judged;
  return judge(internal::make_confirmed_mesh(d, field, options, progress));
}

}  // namespace asterism
