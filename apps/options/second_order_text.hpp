// SPDX-License-Identifier: MIT
//
// Words the report on triangles of second order.
#pragma once

#include <string>

#include "asterism/mesh/audit/curved_triangles.hpp"

namespace asterism::apps {

// Returns "second order: 812 triangles, none folds; ...".
std::string text_of(const second_order_report& report);

}  // namespace asterism::apps
