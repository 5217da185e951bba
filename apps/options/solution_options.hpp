// SPDX-License-Identifier: MIT
//
// Options that make a metric of a solution, which several commands have.
#pragma once

#include <CLI/CLI.hpp>
#include <filesystem>
#include <optional>
#include <vector>

#include "asterism/core/result.hpp"
#include "asterism/mesh/claims/metric_request.hpp"

namespace asterism::apps {

// Adds MESH, --solution and the wishes.
void add_solution_options(CLI::App& app, internal::metric_request& request);

// Sets what was not named and depends on the source: the gradation.
void set_defaults(internal::metric_request& request);

// Refuses requests that contradict themselves. Empty if this one does not.
std::optional<error> check_request(const internal::metric_request& request);

// Returns the files that the request reads.
std::vector<std::filesystem::path> files_of(const internal::metric_request& request);

}  // namespace asterism::apps
