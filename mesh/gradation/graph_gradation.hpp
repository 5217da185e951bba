// SPDX-License-Identifier: MIT
//
// Makes a metric at the vertices of a mesh grow slowly from vertex to vertex.
#pragma once

#include <cstddef>
#include <vector>

#include "asterism/core/site.hpp"
#include "asterism/mesh/data/mesh.hpp"
#include "asterism/mesh/search/mesh_links.hpp"

namespace asterism::internal {

// Ways in which the tensor of p acts at q. `metric`: all lengths grow by the same factor 1 +
// ln(beta) d, with d the length of pq as p measures it; the shape stays. `mixed`: each length grows
// by that to the power of 7/8, times 1 + sqrt(l) |pq| ln(beta) to 1/8, with l its own eigenvalue:
// the shape rounds off. Source: Alauzet, "Size gradation control of anisotropic meshes", 2010; the
// exponent is refine's.
enum class gradation_space { metric, mixed };

struct graph_gradation {
  std::size_t rounds = 0;
  std::size_t changed = 0;  // vertices
  bool ended = false;       // nothing was left to change
};

// Makes each tensor at least as strong as its neighbours require. Changes all vertices at once from
// their former tensors, so that the order does not matter; those near a change are tested again, in
// 200 rounds at most.
graph_gradation grade_on_graph(const mesh& m, const mesh_links& links, double beta,
                               gradation_space space, std::vector<metric_tensor>& tensors);

}  // namespace asterism::internal
