// SPDX-License-Identifier: MIT
//
// Says for programs how metric, transfer and adapt ended: one JSON object, as json_summary.hpp has
// it for the others. Names stay as they are; others may be added.
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

// Returns the object of `metric`; `windows` are the complexities of a series, if it is one.
std::string metric_json(const solution_metric_report& report, int status,
                        const written_paths& files, const std::vector<double>& windows = {});

// Returns the object of `transfer`.
std::string transfer_json(const transfer_report& report, int status, const written_paths& files);

// Holds what a run of `adapt` has to tell; no vertices wanted where the metric says how many, no
// transfer where no values were asked for.
struct adapt_facts {
  const solution_metric_report& metric;
  const adapted_mesh& next;
  const transfer_report* values = nullptr;
  std::optional<std::size_t> vertices_wanted = {};
};

// Returns the object of `adapt`: that of `mesh`, and more.
std::string adapt_json(const adapt_facts& facts, int status, const written_paths& files);

}  // namespace asterism::apps
