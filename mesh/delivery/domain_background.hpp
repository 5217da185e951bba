// SPDX-License-Identifier: MIT
//
// Decides whether a metric is given on a mesh of the domain, or on one that extends beyond it.
#pragma once

#include <optional>
#include <string>

#include "asterism/mesh/data/domain.hpp"
#include "asterism/mesh/data/mesh.hpp"
#include "asterism/mesh/data/metric_field.hpp"

namespace asterism::internal {

// Returns the field's background, if its triangles have no more than a hundredth more area than the
// domain. Otherwise nothing: sums over its nodes would include area outside, so that the field must
// be sampled over the domain, as a formula is. A background with coarser chords of holes has
// somewhat more area. The domain is one that check_domain accepted.
const mesh* background_of_domain(const domain& d, const metric_field& field);

// Returns a note where the background leaves a part of the domain uncovered: its area is less than
// 99 % of the domain's, or a vertex of the domain is outside of its box by more than a hundredth of
// the box's longer side. There the field has the tensor of a nearby triangle. Smaller gaps, and
// gaps that excess area elsewhere compensates, are not detected.
std::optional<std::string> note_on_uncovered(const domain& d, const metric_field& field);

}  // namespace asterism::internal
