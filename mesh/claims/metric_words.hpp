// SPDX-License-Identifier: MIT
//
// Puts a request for a metric, and the report of what was made of it, into words.
#pragma once

#include <map>
#include <string>

#include "asterism/core/result.hpp"
#include "asterism/mesh/claims/metric_request.hpp"

namespace asterism::internal {

// Returns the request in words, by names that begin with "adapt-"; empty words are "none".
std::map<std::string, std::string> words_of(const metric_request& request);
// Returns the request that has these words. Fails for words that are none of a request's.
result<metric_request> request_of(const std::map<std::string, std::string>& words);

// Returns the report in words, by names that begin with "metric-": numbers read back as they were.
std::map<std::string, std::string> words_of(const solution_metric_report& report);
// Returns the report in a line for people.
std::string text_of(const solution_metric_report& report);

}  // namespace asterism::internal
