// SPDX-License-Identifier: MIT
#include "asterism/mesh/io/gmsh_numbering.hpp"

#include <algorithm>
#include <utility>

#include "asterism/mesh/io/text_lines.hpp"

namespace asterism::internal {

gmsh_groups_by_number number_groups(const std::set<int>& numbers,
                                    const std::map<int, std::string>& names,
                                    std::string_view what) {
  gmsh_groups_by_number made;
  long long next = numbers.empty() ? 1 : std::max(1LL, 1LL + *numbers.rbegin());
  for (const int number : numbers) {
    gmsh_group& g = made[number];
    g.entity = made.size();
    const auto named = names.find(number);
    g.name = what;
    g.name += ' ';
    append_integer(g.name, number);
    if (number > 0 && named != names.end()) g.name = named->second;
    g.tag = number > 0 ? number : static_cast<int>(next++);
  }
  return made;
}

std::string names_of_groups(const gmsh_groups_by_number& curves,
                            const gmsh_groups_by_number& surfaces, bool with_given) {
  std::string names = with_given ? "0 1 \"given\"\n" : "";
  for (const auto& [dimension, all] : {std::pair{1, &curves}, {2, &surfaces}})
    for (const auto& [number, g] : *all)
      names += std::to_string(dimension) + ' ' + std::to_string(g.tag) + " \"" + g.name + "\"\n";
  const std::size_t count = curves.size() + surfaces.size() + (with_given ? 1 : 0);
  return "$PhysicalNames\n" + std::to_string(count) + '\n' + names + "$EndPhysicalNames\n";
}

}  // namespace asterism::internal
