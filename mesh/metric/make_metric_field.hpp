// SPDX-License-Identifier: MIT
//
// Makes a metric field from its specification, a name or three formulas.
#pragma once

#include <memory>
#include <string_view>

#include "asterism/core/export.h"
#include "asterism/core/result.hpp"
#include "asterism/mesh/data/bounding_box.hpp"
#include "asterism/mesh/data/metric_field.hpp"

namespace asterism {

// Makes the field. `specification` is what --metric takes: identity, swirl[:K], sink[:K],
// layer[:H0,H1], shock[:A], linear, polar-1, polar-2, circle-1 or expr:M11;M12;M22;
// docs/manual/metrics.md has the formulas. `box` is that of the domain: all but the first and the
// last are placed in it and scaled to it. `size` divides the metric by size^2, so that an edge of
// length `size` measured in the field as given gets metric length 1; it must be positive and
// finite.
ASTERISM_EXPORT result<std::unique_ptr<metric_field>> make_metric_field(
    std::string_view specification, const bounding_box& box, double size = 1);

}  // namespace asterism
