// SPDX-License-Identifier: MIT
//
// Describes how the metric of a mesh differs from the one asked for. Plain data: the mesher fills
// it in (pipeline/metric_relaxation.hpp), and certificates hold it.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "asterism/core/site.hpp"
#include "asterism/mesh/data/domain.hpp"

namespace asterism {

// The way in which the metric was relaxed.
enum class relaxation_kind { softened, graded, constant, without_demands };

// The mesh is of another metric than the one given, in which the stars could not agree.
struct relaxation_report {
  std::string why;  // how refinement ended in the metric as given, one sentence
  relaxation_kind kind = relaxation_kind::softened;  // pipeline/metric_relaxation.hpp
  double power = 1;                                  // of the aspects where they are softened
  double beta = 1, reach = 1;        // graded: lengths differ by beta at most over the length reach
  std::size_t tries = 0;             // meshes begun for it, the one in the metric given left out
  std::vector<metric_tensor> given;  // of each site, what the field says there
  std::size_t changed = 0;           // sites with another tensor than that
  double most_longer = 1, most_shorter = 1;  // by which some length at a site is measured so
  // Smallest angle, degrees, as the tensors given measure it, away from corners that are sharp in
  // these.
  double worst_angle = 180;
  std::vector<vertex_index> low_triangles;  // below the bound, ascending
};

}  // namespace asterism
