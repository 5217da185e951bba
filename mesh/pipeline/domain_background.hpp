// SPDX-License-Identifier: MIT
//
// Tells whether a metric is given on a mesh of the domain, or on one that goes beyond it.
#pragma once

#include "asterism/mesh/data/domain.hpp"
#include "asterism/mesh/data/mesh.hpp"
#include "asterism/mesh/data/metric_field.hpp"

namespace asterism::internal {

// Returns the field's background, if its triangles have no more than a hundredth more area than the
// domain. Else nothing: sums over its nodes would count what lies outside, so that the field is to
// be sampled over the domain, as a formula is. Chords of holes in an older mesh have somewhat more.
// The domain is one that check_domain accepted.
const mesh* background_of_domain(const domain& d, const metric_field& field);

}  // namespace asterism::internal
