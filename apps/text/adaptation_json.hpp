// SPDX-License-Identifier: MIT
//
// Describes the outcome of metric, transfer and adapt for programs: one JSON object, as
// json_summary.hpp does for the other commands. Names stay as they are; others may be added.
#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "asterism/mesh/pipeline/adapt_to_metric.hpp"
#include "asterism/mesh/solution/solution_metric.hpp"
#include "asterism/mesh/transfer/transfer.hpp"

namespace asterism::apps {

using written_paths = std::vector<std::filesystem::path>;

// Returns the object of `metric`; `windows` are the complexities of the windows, for a series.
std::string metric_json(const solution_metric_report& report, int status,
                        const written_paths& files, const std::vector<double>& windows = {});

// Returns the object of `transfer`.
std::string transfer_json(const transfer_report& report, int status, const written_paths& files);

// Results of a run of `adapt`; no number of vertices where the metric determines it, no transfer
// where no fields were transferred.
struct adapt_facts {
  const solution_metric_report& metric;
  const adapted_mesh& next;
  const transfer_report* values = nullptr;
  std::optional<std::size_t> vertices_wanted = {};
};

// Returns the object of `adapt`: that of `mesh` with further members.
std::string adapt_json(const adapt_facts& facts, int status, const written_paths& files);

}  // namespace asterism::apps
