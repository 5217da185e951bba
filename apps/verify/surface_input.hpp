// SPDX-License-Identifier: MIT
//
// Finds the surface that a word of the command line names: a built-in one, or a file.
#pragma once

#include <string>

#include "asterism/core/result.hpp"
#include "asterism/mesh/data/surface.hpp"

namespace asterism::apps {

// Reads the surface. A built-in name is never a file; files end in .json.
result<internal::surface> find_surface(const std::string& name);

}  // namespace asterism::apps
