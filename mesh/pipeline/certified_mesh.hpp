// SPDX-License-Identifier: MIT
//
// Does the main job in one call: domain and metric field in; mesh, audit report and certificate
// out.
//
//   const auto made = make_certified_mesh(square(), field, {.angle_bound = 20});
//   if (!made) return complain(made.failure());            // the input was refused
//   if (!made.value().certified()) explain(made.value());  // what is certain is there all the same
//   write_mesh("square.vtu", made.value().outcome.result);
//   write_certificate("square.certificate.json", made.value().claim);
#pragma once

#include "asterism/core/result.hpp"
#include "asterism/mesh/audit/audit_report.hpp"
#include "asterism/mesh/audit/certificate.hpp"
#include "asterism/mesh/data/domain.hpp"
#include "asterism/mesh/data/metric_field.hpp"
#include "asterism/mesh/data/options.hpp"
#include "asterism/mesh/data/outcome.hpp"

namespace asterism {

// A mesh, how its making ended, and the auditor's judgement of it.
struct certified_mesh {
  mesh_outcome outcome;
  audit_report report;
  // The certificate of the run and the audit; the caller adds `metric` and `options`.
  certificate claim;

  // True if the mesher reached its goal and the audit found nothing against the mesh. The mesher's
  // own belief, `outcome.complete`, is not enough.
  bool certified() const { return outcome.complete && report.certified; }
};

// Makes a mesh and audits it, in the metric at its sites, against the domain and the angle bound.
// Requirements and failures are those of make_mesh. A run that was stopped is audited without its
// stars.
ASTERISM_EXPORT result<certified_mesh> make_certified_mesh(const domain& d,
                                                           const metric_field& field,
                                                           const mesh_options& options,
                                                           const progress_listener& progress = {});

// Audits a finished run, whose outcome must be of `d` with `options`: the second half of
// make_certified_mesh, for callers that make the mesh themselves.
ASTERISM_EXPORT certified_mesh judge_outcome(mesh_outcome outcome, const domain& d,
                                             const mesh_options& options);

}  // namespace asterism
