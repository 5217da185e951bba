// SPDX-License-Identifier: MIT
//
// Words what `verify` and `certify` say of an audit, the same for both.
#pragma once

#include <ostream>
#include <string>

#include "asterism/mesh/audit/audit.hpp"

namespace asterism::apps {

// For --all-findings: how many of each kind an audit keeps.
std::size_t findings_kept(bool all);

// The findings, the first ten of each kind or all that were kept, a line each, and how many more
// there are.
void write_findings(std::ostream& out, const audit_report& report);

// "worst angle 20.10 degrees", and what is exempt and collateral where there is such a thing.
std::string angles_text(const audit_report& report);

// "; dual of the Voronoi diagram: proved", where that was asked.
std::string voronoi_text(const audit_report& report);

}  // namespace asterism::apps
