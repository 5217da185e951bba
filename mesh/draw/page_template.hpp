// SPDX-License-Identifier: MIT
//
// The files of mesh/draw/page, put into the program when it is built.
#pragma once

#include <string_view>

namespace asterism::internal::page_template {

extern const std::string_view page, style, script;

}  // namespace asterism::internal::page_template
