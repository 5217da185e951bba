// SPDX-License-Identifier: MIT
#include "asterism/mesh/pipeline/certified_mesh.hpp"

#include <new>
#include <utility>

#include "asterism/core/number_text.hpp"
#include "asterism/mesh/audit/auditor.hpp"
#include "asterism/mesh/numerics/mesh_statistics.hpp"
#include "asterism/mesh/pipeline/mesh_attempts.hpp"
#include "asterism/mesh/pipeline/outcome_text.hpp"
#include "asterism/mesh/pipeline/star_refusal.hpp"

namespace asterism {
using namespace internal;
namespace {

// Returns the stop without its count of work done. The findings of an audit must not depend on work
// that the run did before: `verify` audits the same mesh without such a count.
cancellation question_of(const cancellation& stop) {
  return [stop]() { return stop.told(); };
}

// Returns the options of the audit of an outcome. The auditor finds the sharp corners by itself:
// the mesher's own list is of rounded angles, and names corners at which no triangle needs an
// exemption.
audit_options questions_for(const mesh_outcome& outcome, const domain& d,
                            const mesh_options& options) {
  audit_options asked;
  asked.angle_bound = options.angle_bound;
  asked.original = &d;
  asked.find_exempt_corners = true;
  // Skips the stars of an interrupted mesh: their check could take long.
  asked.check_stars = !outcome.stopped;
  asked.check_voronoi = options.prove_voronoi && !outcome.stopped;
  // Audits an interrupted mesh without polling the stop, which would end the audit as well.
  if (outcome.ended.how != ending::stopped && !outcome.stopped)
    asked.stop = question_of(options.stop);
  return asked;
}

// Returns the report for a mesh whose audit ran out of memory.
audit_report without_memory(const mesh& subject, const audit_options& asked) {
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

// Returns the auditor of a mesh after the audit. An audit takes more memory than the mesh; where
// there is too little, the report says so, and the mesh is not lost.
auditor audit_if_possible(const mesh& subject, const audit_options& asked) {
  try {
    auditor judge(subject, asked);
    judge.run();
    return judge;
  } catch (const std::bad_alloc&) {
    return {subject, asked, {without_memory(subject, asked), {}}};
  }
}

}  // namespace

certified_mesh judge_outcome(mesh_outcome outcome, const domain& d, const mesh_options& options) {
  const audit_options asked = questions_for(outcome, d, options);
  certified_mesh judged;
  const bool is_known =
      outcome.audited && asked.check_stars && !asked.check_voronoi && asked.exempt_corners.empty();
  const auditor judge = is_known ? auditor(outcome.result, asked, *outcome.audited)
                                 : audit_if_possible(outcome.result, asked);
  judged.report = judge.report();
  if (options.prove_voronoi && outcome.stopped)
    judged.report.voronoi = voronoi_verdict::not_reached;
  certificate& claim = judged.claim;
  claim = judge.make_certificate(options.stop);
  claim.voronoi = judged.report.voronoi;
  claim.complete = outcome.complete;
  claim.reason = ending_text(outcome);
  claim.mesher_counters = outcome.counters;
  claim.star_repairs = outcome.star_repairs;
  claim.delivered = outcome.delivered;
  if (options.metric_tolerance)
    claim.options["metric-tolerance"] = number_text(*options.metric_tolerance);
  claim.measured = by_name(measure(outcome.result));
  judged.outcome = std::move(outcome);
  return judged;
}

result<certified_mesh> make_certified_mesh(const domain& d, const metric_field& field,
                                           const mesh_options& options,
                                           const progress_listener& progress) {
  const auto judged = [&](star_confirmation confirmed, bool may_deliver) -> result<certified_mesh> {
    auto made = make_by_attempts(d, field, options, progress, confirmed, may_deliver);
    if (!made) return made.failure();
    if (progress) progress({.phase = mesh_phase::auditing, .sites = made.value().sites});
    return judge_outcome(std::move(made).value(), d, options);
  };
  return judged_until_confirmed(options, judged);
}

}  // namespace asterism
