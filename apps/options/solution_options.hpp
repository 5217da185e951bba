// SPDX-License-Identifier: MIT
//
// Adds the options that make a metric from a solution, for several commands.
#pragma once

#include <CLI/CLI.hpp>
#include <filesystem>
#include <optional>
#include <vector>

#include "asterism/core/result.hpp"
#include "asterism/mesh/claims/metric_request.hpp"

namespace asterism::apps {

// Adds MESH, --solution and the options of the metric.
void add_solution_options(CLI::App& app, internal::metric_request& request);

// Sets defaults that depend on the source of the metric: the gradation.
void set_defaults(internal::metric_request& request);

// Returns an error for options that contradict each other; empty if none do.
std::optional<error> check_request(const internal::metric_request& request);

// Returns the files that the request reads.
std::vector<std::filesystem::path> files_of(const internal::metric_request& request);

}  // namespace asterism::apps
