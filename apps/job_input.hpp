// SPDX-License-Identifier: MIT
//
// Reads what a mesh job starts from: its domain, checked, and its metric.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>

#include "asterism/apps/mesh_job.hpp"
#include "asterism/core/result.hpp"
#include "asterism/mesh/data/domain.hpp"
#include "asterism/mesh/data/metric_field.hpp"
#include "asterism/mesh/domain/check_domain.hpp"
#include "asterism/mesh/domain/cracks.hpp"
#include "asterism/mesh/metric/graded_field.hpp"
#include "asterism/mesh/metric/size_wishes.hpp"

namespace asterism::apps {

struct prepared_input {
  domain shape;
  std::unique_ptr<metric_field> field;
  std::optional<gradation_report> gradation;
  double size = 1;                   // of the job, or the one that gives the complexity asked for
  domain_repairs repairs;            // of the domain; distance 0: none were asked for
  std::optional<double> complexity;  // of the metric, where one was asked for
  std::optional<std::uint64_t> background_fingerprint = {};  // of the mesh with the metric
  size_wishes sizes = {};  // of the job, and of the domain's file where they are asked for
  bool of_mesh = false;    // the domain is what a finished mesh covers
  std::optional<domain> before_repair = {};  // as the file has it, where it was repaired
  crack_markers cracks = {};                 // of that mesh
};

// Reads and checks the domain, adds the random points, and makes the metric. Notes on repairs go to
// standard error, unless the job is quiet.
result<prepared_input> prepare(const mesh_job& job);

// Adds the sides of the convex hull of the vertices, for --convex-hull.
result<domain> close_by_hull(domain d);

}  // namespace asterism::apps
