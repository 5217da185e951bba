// SPDX-License-Identifier: MIT
//
// Holds the columns of numbers that a batch of questions is about.
#pragma once

#include <span>

namespace asterism {

// Columns of points, one a row.
struct point_columns {
  std::span<const double> x, y;
};

// Columns of metric tensors, one a row.
struct metric_columns {
  std::span<const double> m11, m12, m22;
};

// Columns of sites, one a row.
struct site_columns {
  std::span<const double> x, y, m11, m12, m22;
};

}  // namespace asterism
