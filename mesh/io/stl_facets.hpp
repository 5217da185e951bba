// SPDX-License-Identifier: MIT
//
// Reads the facets of an .stl file, text or binary, as they are listed.
#pragma once

#include <cstddef>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "asterism/core/result.hpp"

namespace asterism::internal {

// A corner of a facet; zeros have no sign. `line` is 1 in binary files.
struct stl_corner {
  double x, y, z;
  std::size_t line;
};

struct stl_facets {
  std::vector<stl_corner> corners;  // three a facet
  std::vector<int> solids;          // of each facet, from 1; empty for a binary file, which has one
  std::map<int, std::string> names;  // of solids that have one
};

// Reads the facets of a file. Fails, naming the line or the facet, if there is no facet, a number
// is invalid or not finite, or a facet has not three corners.
result<stl_facets> read_stl_facets(std::string_view text, const std::string& file);

}  // namespace asterism::internal
