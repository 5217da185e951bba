// SPDX-License-Identifier: MIT
//
// Holds what an audit found, and what it passes to later audits of the same mesh. Internal to the
// library.
#pragma once

#include "asterism/mesh/audit/audit_memory.hpp"
#include "asterism/mesh/audit/audit_report.hpp"

namespace asterism {

struct past_audit {
  audit_report report;
  internal::audit_memory memory;
};

}  // namespace asterism
