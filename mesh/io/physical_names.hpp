// SPDX-License-Identifier: MIT
//
// Names that a file gives to markers and regions, as gmsh's physical groups have them.
#pragma once

#include <map>
#include <string>

namespace asterism {

// Names by number. What has no name here is written as "marker 3", "region 2".
struct physical_names {
  std::map<int, std::string> markers, regions;
};

}  // namespace asterism
