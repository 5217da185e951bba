// SPDX-License-Identifier: MIT
//
// Numbers the physical groups of gmsh files that have markers and regions.
#pragma once

#include <cstddef>
#include <map>
#include <set>
#include <string>
#include <string_view>

namespace asterism::internal {

// A physical group for one number: its entity from 1, its physical tag and its name. Every element
// is in one: meshio reads a file in which all elements are in groups, or none.
struct gmsh_group {
  std::size_t entity = 0;
  int tag = 0;
  std::string name;
};
using gmsh_groups_by_number = std::map<int, gmsh_group>;

// Returns a group for each number. A number that is not positive gets a free tag; its group's name
// is `what` and the number.
gmsh_groups_by_number number_groups(const std::set<int>& numbers,
                                    const std::map<int, std::string>& names, std::string_view what);

// Returns the section $PhysicalNames, with the group of given vertices if there are any.
std::string names_of_groups(const gmsh_groups_by_number& curves,
                            const gmsh_groups_by_number& surfaces, bool with_given = false);

}  // namespace asterism::internal
