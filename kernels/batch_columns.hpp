// SPDX-License-Identifier: MIT
//
// Holds the columns of numbers that a batch of questions is about.
#pragma once

#include <span>

namespace asterism {

// Points, one a row.
struct point_columns {
  std::span<const double> x, y;
};

// Metric tensors, one a row.
struct metric_columns {
  std::span<const double> m11, m12, m22;
};

// Sites, one a row.
struct site_columns {
  std::span<const double> x, y, m11, m12, m22;
};

}  // namespace asterism
