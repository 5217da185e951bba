// SPDX-License-Identifier: MIT
//
// Counts the findings of the audit of a shell.
#pragma once

#include <string>
#include <utility>

#include "asterism/mesh/surface_audit/shell_report.hpp"

namespace asterism::internal {

// Counts a finding, and keeps its sentence if there is room.
inline void note_finding(shell_report& report, const shell_question& asked, std::string sentence) {
  if (report.found++ < asked.findings_kept) report.findings.push_back(std::move(sentence));
}

}  // namespace asterism::internal
