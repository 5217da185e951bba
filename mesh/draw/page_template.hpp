// SPDX-License-Identifier: MIT
//
// Holds the files of mesh/draw/page and mesh/draw/space_page, built into the program.
#pragma once

#include <string_view>

namespace asterism::internal::page_template {

extern const std::string_view page, style, script;
extern const std::string_view space_page, space_style, space_script;

}  // namespace asterism::internal::page_template
