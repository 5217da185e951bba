// SPDX-License-Identifier: MIT
#include "asterism/challenge/input_classes.hpp"

#include <algorithm>
#include <array>

namespace asterism::challenge {
namespace {

constexpr std::array classes = {
    input_class{"random",
                "positions in [-1,1]^2, tensors of a random triangular factor: what a "
                "plain program gets right",
                uniform},
    input_class{"one-ulp", "exactly degenerate, but for one number moved to the next double",
                one_ulp},
    input_class{"kettner",
                "a neighbourhood of (1/2, 1/2), one unit in the last place a step, "
                "against the line through (12, 12) and (24, 24)",
                kettner},
    input_class{"grid", "whole numbers from -2 to 2, one small tensor or four", grid},
    input_class{"cocircular",
                "four of the twelve integer points of a circle of radius 5, in an "
                "integer map of determinant 1",
                cocircular},
    input_class{"collinear", "sites and point on one line through integer points", collinear},
    input_class{"tangent", "a segment from a site touches a bisector, or an edge touches a cell",
                tangent},
    input_class{"common-roots",
                "one point is equally far from all four sites: three bisectors "
                "share a root",
                common_roots},
    input_class{"mirror", "two sites are images of each other in a line that holds all the rest",
                mirror_images},
    input_class{"ill-conditioned", "tensors of condition 10^4 to 10^12 about integer directions",
                ill_conditioned},
    input_class{"scaled", "the classes above, times 2^400 or 2^-400, tensors too or not",
                scaled_400},
    input_class{"extreme", "the same, times 2^1000 or 2^-1000", scaled_1000},
    input_class{"subnormal", "ordinary numbers beside subnormal ones, which decide", subnormal},
    input_class{"offset", "1e-6 apart at (1e8, -1e8)", offset},
    input_class{"mixed-sizes", "every site of another size, 2^-30 to 2^30, tensors 2^-60 to 2^60",
                mixed_sizes}};

}  // namespace

std::span<const input_class> input_classes() { return classes; }

const input_class* class_named(std::string_view name) {
  const auto* const found = std::find_if(classes.begin(), classes.end(),
                                         [name](const input_class& c) { return c.name == name; });
  return found == classes.end() ? nullptr : found;
}

}  // namespace asterism::challenge
