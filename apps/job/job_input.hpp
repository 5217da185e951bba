// SPDX-License-Identifier: MIT
//
// Reads the input of a mesh job: its domain, checked, and its metric.
#pragma once

#include <cstddef>
#include <optional>

#include "asterism/apps/base/mesh_job.hpp"
#include "asterism/core/result.hpp"
#include "asterism/mesh/data/domain.hpp"
#include "asterism/mesh/domain/check_domain.hpp"
#include "asterism/mesh/domain/cracks.hpp"
#include "asterism/mesh/metric/size_wishes.hpp"
#include "asterism/mesh/pipeline/mesh_input.hpp"

namespace asterism::apps {

// Domain and metric of a job, with their files and notes.
struct prepared_input : mesh_input {
  // Source of meshes of other densities. None where no number of vertices is wanted, since it may
  // hold a large mesh with the metric.
  std::optional<mesh_source> source = {};
  domain_repairs repairs = {};  // of the domain; distance 0: none were asked for
  size_wishes sizes = {};       // of the job, and of the domain's file where they are asked for
  bool of_mesh = false;         // the domain is what a finished mesh covers
  std::optional<domain> before_repair = {};  // as the file has it, where it was repaired
  crack_markers cracks = {};                 // of that mesh
};

// Reads and checks the domain, adds the random points, and makes the metric. Notes on repairs go to
// standard error, unless the job is quiet.
result<prepared_input> prepare(const mesh_job& job);

// Raises the default limit on sites where the domain has many vertices: an angle bound alone takes
// two to five times their number.
void make_room(std::size_t given, mesh_options& options);

// Adds the sides of the convex hull of the vertices, for --convex-hull.
result<domain> close_by_hull(domain d);

}  // namespace asterism::apps
