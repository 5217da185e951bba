// SPDX-License-Identifier: MIT
//
// Builds the triangulation that is to be optimised from a finished mesh.
#pragma once

#include "asterism/core/result.hpp"
#include "asterism/mesh/data/domain.hpp"
#include "asterism/mesh/data/mesh.hpp"
#include "asterism/mesh/metric/field_sampler.hpp"
#include "asterism/mesh/optimize/mutable_triangulation.hpp"

namespace asterism::internal::fitting {

// Returns the triangulation of `start`, its sites measured by the field. Fails where the field
// does, and, naming what is wrong, where `start` is no triangulation of `d` in doubles. The domain
// must outlive the result.
result<mutable_triangulation> build_triangulation(const domain& d, field_sampler& sampler,
                                                  const mesh& start);

// Sets the metric area wanted at each vertex. It is that of the triangles around it, smoothed so
// that single ones do not count, then all enlarged so that it takes fewer triangles.
void choose_areas(mutable_triangulation& net);

}  // namespace asterism::internal::fitting
