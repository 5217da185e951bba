// SPDX-License-Identifier: MIT
#include "asterism/mesh/io/gmsh_groups.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <iterator>
#include <string_view>

#include "asterism/mesh/io/text_scanner.hpp"

namespace asterism::internal {

int gmsh_groups::number_of_set(int dimension, std::vector<int> tags) {
  std::sort(tags.begin(), tags.end());
  tags.erase(std::unique(tags.begin(), tags.end()), tags.end());
  if (tags.empty()) return 0;
  auto& all = sets_[dimension];
  const auto [at, is_new] = numbers_[dimension].emplace(tags, static_cast<int>(all.size()));
  if (is_new) all.push_back(std::move(tags));
  return at->second;
}

int gmsh_groups::united(int dimension, int one, int other) {
  if (one == other) return one;
  tag_set both = sets_[dimension][static_cast<std::size_t>(one)];
  const tag_set& more = sets_[dimension][static_cast<std::size_t>(other)];
  both.insert(both.end(), more.begin(), more.end());
  return number_of_set(dimension, std::move(both));
}

// Reads the number in a name such as "marker -7", which no physical group can have.
int gmsh_groups::number_of(int dimension, int tag) const {
  const auto named = names_.find({dimension, tag});
  const std::string_view what = dimension == 1 ? "marker " : "region ";
  if (named == names_.end() || !named->second.starts_with(what)) return tag;
  const text_scanner nowhere("", "");
  const auto number = to_marker(nowhere, {std::string_view(named->second).substr(what.size()), 0},
                                "number in a name");
  return number.ok() && number.value() <= 0 ? number.value() : tag;
}

std::string gmsh_groups::name_of(int dimension, int tag) const {
  const auto named = names_.find({dimension, tag});
  return named == names_.end() ? std::to_string(tag) : named->second;
}

std::vector<int> gmsh_groups::numbers_of_sets(int dimension, const std::vector<char>& in_use,
                                              std::map<int, std::string>& names,
                                              std::vector<std::string>& notes) const {
  const auto& all = sets_[dimension];
  std::map<int, std::size_t> uses;
  for (std::size_t i = 0; i < all.size(); ++i)
    for (const int tag : all[i]) uses[tag] += in_use[i] != 0 ? 1 : 0;
  int greatest = 0;
  for (const auto& entry : names_)
    if (entry.first.first == dimension) greatest = std::max(greatest, entry.first.second);
  if (!uses.empty()) greatest = std::max(greatest, uses.rbegin()->first);
  std::vector<int> numbers;
  std::size_t several = 0;
  std::string first;
  for (std::size_t i = 0; i < all.size(); ++i) {
    const tag_set& set = all[i];
    if (set.size() < 2 || in_use[i] == 0) {
      numbers.push_back(set.empty() ? 0 : number_of(dimension, set.front()));
      continue;
    }
    std::string name;
    for (const int tag : set) {
      if (!name.empty()) name += '+';
      name += name_of(dimension, tag);
    }
    const auto own = std::find_if(set.begin(), set.end(), [&](int tag) { return uses[tag] == 1; });
    numbers.push_back(own != set.end() ? *own : ++greatest);
    names[numbers.back()] = name;
    if (several++ == 0) first = fmt::format("{} is \"{}\"", numbers.back(), name);
  }
  if (several > 0)
    notes.push_back(
        fmt::format("{} that are in several physical groups have a number for each set "
                    "of groups and all their names, the first: {}",
                    dimension == 1 ? "curves" : "surfaces", first));
  return numbers;
}

void gmsh_groups::settle(listed_mesh& m) {
  for (const auto& [place, name] : names_) {
    if (place.first == 1) m.names.markers[number_of(1, place.second)] = name;
    if (place.first == 2) m.names.regions[number_of(2, place.second)] = name;
  }
  mesh& made = m.content;
  std::vector<char> lines(sets_[1].size(), 0), surfaces(sets_[2].size(), 0);
  for (const boundary_edge& e : made.boundary) lines[static_cast<std::size_t>(e.marker)] = 1;
  for (const int region : made.regions) surfaces[static_cast<std::size_t>(region)] = 1;
  for (const listed_quadrilateral& q : m.quadrilaterals)
    surfaces[static_cast<std::size_t>(q.region)] = 1;
  const auto markers = numbers_of_sets(1, lines, m.names.markers, made.notes);
  const auto regions = numbers_of_sets(2, surfaces, m.names.regions, made.notes);
  bool grouped = false;
  for (int& region : made.regions) {
    grouped = grouped || region != 0;
    region = regions[static_cast<std::size_t>(region)];
  }
  for (listed_quadrilateral& q : m.quadrilaterals) {
    grouped = grouped || q.region != 0;
    q.region = regions[static_cast<std::size_t>(q.region)];
  }
  if (!grouped) {
    made.regions.assign(made.triangles.size(), 1);
    for (listed_quadrilateral& q : m.quadrilaterals) q.region = 1;
  }
  for (boundary_edge& e : made.boundary) e.marker = markers[static_cast<std::size_t>(e.marker)];
}

void gmsh_groups::unite_repeated(listed_mesh& file) {
  mesh& m = file.content;
  const auto unite = [&](int dimension, std::size_t count, const auto& key_of,
                         const auto& groups_of) {
    using key = std::array<vertex_index, 4>;
    std::vector<std::pair<key, std::size_t>> order(count);
    for (std::size_t i = 0; i < count; ++i) {
      order[i] = {key_of(i), i};
      std::sort(order[i].first.begin(), order[i].first.end());
    }
    std::sort(order.begin(), order.end());
    for (std::size_t begin = 0, end = 0; begin < count; begin = end) {
      int all = groups_of(order[begin].second);
      for (end = begin + 1; end < count && order[end].first == order[begin].first; ++end)
        all = united(dimension, all, groups_of(order[end].second));
      for (std::size_t k = begin; k < end; ++k) groups_of(order[k].second) = all;
    }
  };
  unite(
      2, m.triangles.size(),
      [&](std::size_t i) {
        const triangle& t = m.triangles[i];
        return std::array{t[0], t[1], t[2], t[2]};
      },
      [&](std::size_t i) -> int& { return m.regions[i]; });
  unite(
      2, file.quadrilaterals.size(), [&](std::size_t i) { return file.quadrilaterals[i].corners; },
      [&](std::size_t i) -> int& { return file.quadrilaterals[i].region; });
  unite(
      1, m.boundary.size(),
      [&](std::size_t i) {
        const boundary_edge& e = m.boundary[i];
        return std::array{e.a, e.b, e.b, e.b};
      },
      [&](std::size_t i) -> int& { return m.boundary[i].marker; });
}

}  // namespace asterism::internal
