// SPDX-License-Identifier: MIT
//
// Defines the metric that is made of a solution, and the report of the steps that made it, which
// are those of solution_metric.hpp.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "asterism/core/site.hpp"

namespace asterism {

// Numbers about the steps made. Shares are parts of the vertices.
struct solution_metric_report {
  std::vector<std::string> steps;   // in the order they were done, a word each and its numbers
  std::vector<std::string> fields;  // in the order of their intersection
  std::size_t flat_fields = 0;      // without second derivatives
  double share_noise = 0;           // of vertices and fields: nothing but rounding
  double share_at_boundary = 0;     // of vertices and fields: the mean of neighbours
  double share_floored = 0;         // of vertices and fields: an eigenvalue was raised
  // Shares of the optimal metric's complexity, each the greatest over the fields: the share of
  // places where the density is raised to its lower bound, and that of other places where the
  // weaker eigenvalue is raised, so that no edge is longer than the domain.
  double complexity_at_least_density = 0, complexity_along_ridges = 0;
  double complexity_asked = 0;  // 0 where an error was asked for
  double complexity_before_gradation = 0;
  double complexity_delivered = 0;
  double factor = 0;           // of step 4
  double error_predicted = 0;  // greatest of the fields
  double share_intersected = 0, share_step = 0, share_least_size = 0, share_greatest_size = 0,
         share_aspect = 0, share_graded = 0;
  std::size_t gradation_rounds = 0;
  bool gradation_ended = true;  // false: some neighbours still ask for more
  bool reached = false;         // the target is met within 2 %
  std::string reason;           // one sentence where it is not
};

// A metric at the vertices of a mesh, all tensors positive definite.
struct solution_metric {
  std::vector<metric_tensor> tensors;
  solution_metric_report report;
};

}  // namespace asterism
