// SPDX-License-Identifier: MIT
//
// Adapts a mesh except for regions whose triangles stay as they are.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "asterism/core/result.hpp"
#include "asterism/mesh/audit/certificate.hpp"
#include "asterism/mesh/data/mesh.hpp"
#include "asterism/mesh/data/mesh_marks.hpp"
#include "asterism/mesh/data/options.hpp"
#include "asterism/mesh/pipeline/adapt_to_metric.hpp"

namespace asterism::apps {

// Counts and angles of the frozen triangles, which are not certified.
struct frozen_facts {
  std::vector<int> regions;  // ascending; empty: none
  std::size_t triangles = 0, low = 0;
  double worst_angle = 180;  // degrees, as any of the corners measures it in the metric wanted
  double border_length = 0;  // greatest one left to the border's edges
  std::size_t coarser = 0;   // vertices of the border with a coarser tensor for that
};

// The adapted mesh of the rest, alone and with the frozen triangles beside it.
struct frozen_run {
  adapted_mesh next;
  mesh background, together;  // the rest with its metric; what is written
  frozen_facts facts;
  std::size_t border_split = 0;  // edges, where no length that is tried leaves all whole
};

// Returns the numbers of the regions given by number or name, ascending. Fails for unknown ones.
result<std::vector<int>> frozen_regions(const std::vector<std::string>& named,
                                        const std::string& mesh_file);

// Adapts the mesh outside the frozen regions.
result<frozen_run> adapt_the_rest(const std::vector<int>& regions, const marked_mesh& from,
                                  const mesh_adaptation_options& options,
                                  const progress_listener& progress);

// Enters the facts about frozen triangles into the certificate.
void describe_frozen(const frozen_facts& facts, certificate& claim);

// Returns a line such as "frozen, not judged: 123 triangles of region 2, ...".
std::string text_of(const frozen_facts& facts, double angle_bound);

}  // namespace asterism::apps
