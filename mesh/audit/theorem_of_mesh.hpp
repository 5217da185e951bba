// SPDX-License-Identifier: MIT
//
// Measures whether the sites of a mesh meet the hypotheses of the theorem on nets, with the tree of
// the sites that an audit made, where there is one. Internal to the auditor.
#pragma once

#include <string_view>

#include "asterism/mesh/audit/site_tree.hpp"
#include "asterism/mesh/audit/theorem_report.hpp"
#include "asterism/mesh/data/mesh.hpp"
#include "asterism/mesh/support/cancellation.hpp"

namespace asterism::internal {

// Words with which the reason begins where measuring was ended early.
inline constexpr std::string_view not_all_measured = "not all was measured: ";

// Measures as measure_theorem_hypotheses() does. `tree` is of the sites of the mesh, or null.
theorem_hypotheses theorem_of_mesh(const mesh& subject, double angle_bound,
                                   const cancellation& stop,
                                   const audit_detail::site_tree* tree = nullptr);

}  // namespace asterism::internal
