// SPDX-License-Identifier: MIT
//
// Returns texts on what was proved of a mesh of a surface.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "asterism/mesh/surface_audit/shell_audit.hpp"

namespace asterism::apps {

// Returns one line, without its end, such as "142 vertices, 250 triangles; every point ... ".
std::string text_of(const internal::shell_report& report, const internal::shell_question& asked);

// Returns the summary as pairs of a name and a value, for pages.
std::vector<std::pair<std::string, std::string>> table_of(const internal::shell_report& report,
                                                          const internal::shell_question& asked);

// Returns the summary as a JSON object, whose numbers have all their digits.
std::string json_of(const internal::shell_report& report, const internal::shell_question& asked,
                    bool complete, const std::string& reason, int status);

}  // namespace asterism::apps
