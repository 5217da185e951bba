// SPDX-License-Identifier: MIT
//
// Reports how far the tensors of a mesh are from the metric that was asked for.
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
  // Set where the tensors are others than asked for: by how much, as measured here.
  std::optional<delivered_report> apart;
};

}  // namespace asterism::internal
