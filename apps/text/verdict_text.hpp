// SPDX-License-Identifier: MIT
//
// Words what `verify` and `certify` say of an audit, the same for both.
#pragma once

#include <optional>
#include <ostream>
#include <string>
#include <vector>

#include "asterism/mesh/audit/audit_report.hpp"
#include "asterism/mesh/audit/certificate.hpp"
#include "asterism/mesh/audit/region_areas.hpp"
#include "asterism/mesh/audit/theorem_report.hpp"

namespace asterism::apps {

// Returns how many findings of each kind an audit keeps: all with --all-findings.
std::size_t findings_kept(bool all);

// Writes the findings, the first ten of each kind or all that were kept, a line each, and how many
// more there are.
void write_findings(std::ostream& out, const audit_report& report);

// Tells the worst angle; `degrees` as an audit has it: 180 where no triangle is away from the
// exempt corners.
std::string worst_angle_text(double degrees);
// Returns "worst angle 20.10 degrees", and what is exempt and collateral if anything is.
std::string angles_text(const audit_report& report);

// Returns "; points of split segments off them by up to 3.3e-16 (1.5 ulps)"; nothing up to an ulp.
std::string deviation_text(const audit_report& report);
// Says how near the boundary is to the curves of the domain; nothing if it has none.
std::string curves_text(const audit_report& report);
// Says how far the boundary is from the one that it took the place of, as the certificate has it
// and verify() compared it; nothing where there is none.
std::string former_text(const std::optional<certificate>& claim);

// Returns "; periodic: " and how the sides match that are to have the same points; nothing where
// there are none.
std::string periodic_text(const std::vector<periodic_match>& matches);

// Returns "areas of regions before and after: 1 (0.25, 0.25), 3 (0.75, 0.75)", the first ten, with
// what they are in the domain for those before where no mesh was adapted; nothing where there is
// but region 1.
std::string regions_text(const std::vector<region_area>& regions);

// Returns "not all stars were looked at, as ...", where the audit ended with the first certain
// reasons.
std::string cut_short_text(const audit_report& report);

// Returns "applies: at sigma eps 0.013 angles of 27.25 degrees are proved", or why it does not.
std::string theorem_text(const theorem_hypotheses& measured);

// Returns "; dual of the Voronoi diagram: proved", where that was asked.
std::string voronoi_text(const audit_report& report);

}  // namespace asterism::apps
