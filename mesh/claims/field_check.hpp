// SPDX-License-Identifier: MIT
//
// Holds the result of comparing the tensors of a mesh with the metric that was asked for.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "asterism/mesh/data/delivered_report.hpp"

namespace asterism::internal {

// Findings of comparing a mesh's tensors with a metric.
struct field_check {
  bool made = false;    // true if the metric asked for could be made again
  std::string why_not;  // half a sentence on why it could not
  std::vector<std::string> contradictions;
  // Measured distance of the tensors from those asked for; set where they differ.
  std::optional<delivered_report> apart;
};

}  // namespace asterism::internal
