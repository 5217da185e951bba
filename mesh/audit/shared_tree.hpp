// SPDX-License-Identifier: MIT
//
// Audits a mesh and makes its certificate with one tree of its sites, of which each alone makes its
// own. Internal to the library.
#pragma once

#include <memory>

#include "asterism/mesh/audit/audit.hpp"
#include "asterism/mesh/audit/certificate.hpp"
#include "asterism/mesh/audit/site_tree.hpp"
#include "asterism/mesh/audit/theorem_hypotheses.hpp"

namespace asterism::internal {

// The tree of a mesh's sites, if one was made: of the same mesh, which is not moved.
using shared_tree = std::unique_ptr<audit_detail::site_tree>;

// Does what audit() does, and sets `tree` to the one it made.
audit_report audit_sharing(const mesh& subject, const audit_options& options, shared_tree& tree);

// Do what make_certificate() and measure_theorem_hypotheses() do, with a tree unless it is null.
certificate make_certificate_sharing(const mesh& subject, const audit_options& options,
                                     const audit_report& report, shared_tree tree);
theorem_hypotheses measure_theorem_hypotheses_sharing(const mesh& subject, double angle_bound,
                                                      const cancellation& stop, shared_tree tree);

}  // namespace asterism::internal
