// SPDX-License-Identifier: MIT
//
// Holds the names that a file gives to markers and regions, as gmsh's physical groups have them.
#pragma once

#include <map>
#include <string>

namespace asterism {

// Names by number. A number without a name is written as "marker 3" or "region 2".
struct physical_names {
  std::map<int, std::string> markers, regions;
};

}  // namespace asterism
