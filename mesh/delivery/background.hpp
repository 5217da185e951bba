// SPDX-License-Identifier: MIT
//
// Prepares the start of an adaptation: a coarse triangulation of the domain, and a mesh that
// carries the metric wanted.
#pragma once

#include <optional>

#include "asterism/mesh/adapt/sampled_background.hpp"
#include "asterism/mesh/data/domain.hpp"
#include "asterism/mesh/data/mesh.hpp"
#include "asterism/mesh/data/metric_field.hpp"
#include "asterism/mesh/data/options.hpp"

namespace asterism::internal {

// Returns a triangulation of the domain with few sites beyond its vertices: at most three times as
// many, and 500 more. Its stars are those of the Euclidean metric, or, where that needs more sites,
// of the mean of the metric at the vertices. Returns nothing where both need more.
std::optional<mesh> coarse_mesh(const domain& d, const metric_field& field,
                                const mesh_options& options);

// Samples the field on a mesh that begins with `start`, with edges that are at most `longest` long
// in it. Returns nothing where the field fails.
std::optional<adapting::sampled_background> sample_field(const domain& d, const mesh& start,
                                                         const metric_field& field, double longest,
                                                         const cancellation& stop);

// Returns how fast the metric varies, by its samples: the logarithm of the distortion over an edge
// for each unit of the edge's length, exceeded by one edge in `one_in`.
double sampled_variation(const mesh& nodes, std::size_t one_in = 50);

}  // namespace asterism::internal
