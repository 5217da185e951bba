// SPDX-License-Identifier: MIT
#include "asterism/mesh/audit/audit.hpp"

#include "asterism/mesh/audit/auditor.hpp"

namespace asterism {

audit_report audit(const mesh& subject, const audit_options& options) {
  return internal::auditor(subject, options).run();
}

}  // namespace asterism
