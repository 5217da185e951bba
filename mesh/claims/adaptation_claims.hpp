// SPDX-License-Identifier: MIT
//
// Checks the claims about metric and transferred solution in the certificate of an adapted mesh:
// makes both again from the files of the background mesh and the solution, and from the new mesh.
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

// Returns the report of a transfer in words, by names that begin with "transfer-".
std::map<std::string, std::string> words_of(const transfer_report& report, transfer_method how);

// Makes the metric asked for again, and returns it. Adds a sentence for each number of its
// report and of the transfer that differs. Fails where the files are missing or hold another
// metric.
result<std::unique_ptr<metric_field>> check_adaptation(const mesh& subject,
                                                       const certificate& claim,
                                                       field_check& check);

}  // namespace asterism::internal
