// SPDX-License-Identifier: MIT
//
// Converts a request for a metric, and the report of the metric made, to words and back.
#pragma once

#include <map>
#include <string>

#include "asterism/core/result.hpp"
#include "asterism/mesh/claims/metric_request.hpp"

namespace asterism::internal {

// Returns the request in words, by names that begin with "adapt-"; empty words are "none".
std::map<std::string, std::string> words_of(const metric_request& request);
// Returns the request that has these words. Fails for words that belong to no request.
result<metric_request> request_of(const std::map<std::string, std::string>& words);

// Returns the report in words, by names that begin with "metric-": numbers read back as they were.
std::map<std::string, std::string> words_of(const solution_metric_report& report);
// Returns the report in one line of text.
std::string text_of(const solution_metric_report& report);

}  // namespace asterism::internal
