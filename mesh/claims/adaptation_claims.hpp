// SPDX-License-Identifier: MIT
//
// Checks what the certificate of an adapted mesh says of its metric and of the solution brought to
// it, made once more from the files: the background mesh, the solution, the new mesh.
#pragma once

#include <map>
#include <memory>
#include <string>

#include "asterism/core/result.hpp"
#include "asterism/mesh/audit/certificate.hpp"
#include "asterism/mesh/claims/field_check.hpp"
#include "asterism/mesh/data/mesh.hpp"
#include "asterism/mesh/data/metric_field.hpp"
#include "asterism/mesh/transfer/transfer.hpp"

namespace asterism::internal {

// True if the certificate is of a mesh that `adapt` made.
bool is_of_adaptation(const certificate& claim);

// Returns what was transferred in words, by names that begin with "transfer-".
std::map<std::string, std::string> words_of(const transfer_report& report, transfer_method how);

// Makes the metric asked for once more, adds a sentence for each number of the report and of the
// transfer that is another one, and returns the metric. Fails where the files are not there or hold
// another metric.
result<std::unique_ptr<metric_field>> check_adaptation(const mesh& subject,
                                                       const certificate& claim,
                                                       field_check& check);

}  // namespace asterism::internal
