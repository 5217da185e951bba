// SPDX-License-Identifier: MIT
//
// Tells whether a metric is given on a mesh of the domain, or on one that goes beyond it.
#pragma once

#include <optional>
#include <string>

#include "asterism/mesh/data/domain.hpp"
#include "asterism/mesh/data/mesh.hpp"
#include "asterism/mesh/data/metric_field.hpp"

namespace asterism::internal {

// Returns the field's background, if its triangles have no more than a hundredth more area than the
// domain. Else nothing: sums over its nodes would count what lies outside, so that the field is to
// be sampled over the domain, as a formula is. Chords of holes in an older mesh have somewhat more.
// The domain is one that check_domain accepted.
const mesh* background_of_domain(const domain& d, const metric_field& field);

// Returns a note where the background leaves a part of the domain uncovered: it has more than a
// hundredth less area, or a vertex of the domain is outside of its box by more than a hundredth of
// that. There the field has the tensor of a triangle near by. A gap that is smaller, or that area
// elsewhere makes up for, is not seen.
std::optional<std::string> note_on_uncovered(const domain& d, const metric_field& field);

}  // namespace asterism::internal
