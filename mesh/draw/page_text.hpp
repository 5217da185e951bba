// SPDX-License-Identifier: MIT
//
// Fills the templates of pages.
#pragma once

#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace asterism::internal {

// Returns the text for a script element, without "<", which could end it.
std::string for_script(std::string text);

// Returns `page` with each name in double braces replaced, in one pass: replacements are not
// scanned again.
std::string fill_in(std::string_view page,
                    const std::vector<std::pair<std::string_view, std::string_view>>& values);

}  // namespace asterism::internal
