// SPDX-License-Identifier: MIT
//
// Returns the text of the report on triangles of second order.
#pragma once

#include <string>

#include "asterism/mesh/audit/curved_triangles.hpp"

namespace asterism::apps {

// Returns a line such as "second order: 812 triangles, none folds; ...".
std::string text_of(const second_order_report& report);

}  // namespace asterism::apps
