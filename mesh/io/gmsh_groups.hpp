// SPDX-License-Identifier: MIT
//
// Gives markers and regions to elements that are in physical groups of gmsh, in one or in several.
#pragma once

#include <map>
#include <string>
#include <utility>
#include <vector>

#include "asterism/mesh/io/listed_mesh.hpp"

namespace asterism::internal {

// The physical groups of a file. Dimension 1 has lines, 2 surfaces.
class gmsh_groups {
 public:
  void set_name(int dimension, int tag, std::string name) {
    names_[{dimension, tag}] = std::move(name);
  }

  // Returns the number of a set of groups of one dimension: 0 for the empty set.
  int number_of_set(int dimension, std::vector<int> tags);
  // Returns the number of the union of two sets.
  int united(int dimension, int one, int other);

  // Gives an element that is listed once for each of its groups the set of all of them: versions 1
  // and 2 have no other form for several groups.
  void unite_repeated(listed_mesh& m);

  // Replaces the numbers of sets by markers and regions, and names these. A set of one group gets
  // its tag, or the number in its name ("marker -7" for a number that no group can have); a set of
  // several groups gets a tag that no other set has, or the next free number, with all their names.
  // Regions are left out where no surface is in a group.
  void settle(listed_mesh& m);

 private:
  using tag_set = std::vector<int>;
  int number_of(int dimension, int tag) const;
  std::string name_of(int dimension, int tag) const;
  // Returns a marker or region for each set of groups. Names only sets that some element belongs
  // to.
  std::vector<int> numbers_of_sets(int dimension, const std::vector<char>& in_use,
                                   std::map<int, std::string>& names,
                                   std::vector<std::string>& notes) const;

  std::map<std::pair<int, int>, std::string> names_;  // by dimension and tag
  std::map<tag_set, int> numbers_[3];                 // of sets, by dimension
  std::vector<tag_set> sets_[3] = {{{}}, {{}}, {{}}};
};

}  // namespace asterism::internal
