// SPDX-License-Identifier: MIT
//
// Generates quadruples of sites of every degenerate kind. (kind, seed) gives the same case in all
// versions. Each case has four distinct sites with positive definite metrics, exactly as doubles.
// Kinds that promise an exact coincidence have small integers or dyadic fractions as numbers.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>

#include "asterism/core/site.hpp"
#include "random_source.hpp"

namespace asterism::property {

using four_sites = std::array<site, 4>;

struct kind {
  std::string_view name;
  // May return metrics that are not positive definite or sites that coincide: draw() tries again.
  four_sites (*attempt)(random_source&);
};

std::span<const kind> kinds();
// Looks a kind up by name; the first kind if there is none.
const kind& kind_named(std::string_view name);

four_sites shuffled(four_sites sites, random_source& random);

// Returns a valid case of this kind.
four_sites draw(const kind& k, random_source& random);

// Returns a point that may be critical to these sites: near, on or at them, with as few digits.
point draw_point(const four_sites& sites, random_source& random);

// Returns the record of the batch protocol (hexadecimal doubles) that replays a question.
std::string record(std::string_view predicate, std::span<const site> sites,
                   std::span<const point> points = {});

// Exact as long as nothing overflows or underflows.
site scaled(const site& s, int coordinate_exponent, int metric_exponent);

}  // namespace asterism::property
