// SPDX-License-Identifier: MIT
//
// Lists the classes of input on which predicates are known to fail. To add a class, declare here a
// function from random numbers to a scene, and enter it in the table of input_classes.cpp: the
// command, its help and the tests read only that table.
#pragma once

#include <span>
#include <string_view>

#include "asterism/challenge/scene.hpp"

namespace asterism::challenge {

std::span<const input_class> input_classes();

// Returns the class of that name, null if there is none.
const input_class* class_named(std::string_view name);

// Classes on the border between two answers, or one unit beside it (input_classes_degenerate.cpp).
scene grid(random_source& random);
scene cocircular(random_source& random);
scene collinear(random_source& random);
scene tangent(random_source& random);
scene common_roots(random_source& random);
scene mirror_images(random_source& random);
scene degenerate(random_source& random);  // one of the five above
scene one_ulp(random_source& random);
scene kettner(random_source& random);

// Classes of numbers of unusual sizes (input_classes_sized.cpp).
scene uniform(random_source& random);
scene ill_conditioned(random_source& random);
scene scaled_400(random_source& random);
scene scaled_1000(random_source& random);
scene subnormal(random_source& random);
scene offset(random_source& random);
scene mixed_sizes(random_source& random);

}  // namespace asterism::challenge
