// SPDX-License-Identifier: MIT
//
// Reads pairs of sides that must have the same points.
#pragma once

#include <pybind11/stl.h>

#include <utility>
#include <vector>

#include "arguments.hpp"
#include "asterism/mesh/audit/periodic_match.hpp"

namespace asterism::python {

// Reads the keyword `periodic`, a list of pairs of int.
inline std::vector<periodic_pair> periodic_of(const keywords& given) {
  std::vector<periodic_pair> pairs;
  if (!given.has("periodic")) return pairs;
  for (const auto& [first, second] :
       given.object("periodic").cast<std::vector<std::pair<int, int>>>())
    pairs.push_back({first, second});
  return pairs;
}

}  // namespace asterism::python
