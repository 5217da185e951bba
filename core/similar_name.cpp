// SPDX-License-Identifier: MIT
#include "asterism/core/similar_name.hpp"

#include <algorithm>
#include <cstddef>
#include <numeric>

namespace asterism::internal {
namespace {

// Returns the number of letters that must be changed, added, removed or exchanged with their
// neighbour to turn one word into the other (optimal string alignment).
std::size_t distance(std::string_view a, std::string_view b) {
  std::vector<std::vector<std::size_t>> rows(a.size() + 1, std::vector<std::size_t>(b.size() + 1));
  std::iota(rows[0].begin(), rows[0].end(), std::size_t{0});
  for (std::size_t i = 1; i <= a.size(); ++i) {
    rows[i][0] = i;
    for (std::size_t j = 1; j <= b.size(); ++j) {
      rows[i][j] = std::min({rows[i - 1][j] + 1, rows[i][j - 1] + 1,
                             rows[i - 1][j - 1] + (a[i - 1] == b[j - 1] ? 0 : 1)});
      const bool is_exchanged = i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1];
      if (is_exchanged) rows[i][j] = std::min(rows[i][j], rows[i - 2][j - 2] + 1);
    }
  }
  return rows[a.size()][b.size()];
}

// Leaves letters beyond ASCII as they are, whatever the locale.
std::string in_small_letters(std::string_view word) {
  std::string small(word);
  for (char& c : small)
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  return small;
}

// Returns the name that the word begins, as similar_name() describes; empty if there is none.
std::string completed(std::string_view word, const std::vector<std::string>& names) {
  // Least number of letters that can be completed, dashes of options included.
  constexpr std::size_t least = 3;
  if (word.size() < least) return "";
  std::string shortest;
  for (const std::string& name : names)
    if (name.starts_with(word) && (shortest.empty() || name.size() < shortest.size()))
      shortest = name;
  const bool is_one = std::all_of(names.begin(), names.end(), [&](const std::string& name) {
    return !name.starts_with(word) || name.starts_with(shortest);
  });
  return is_one ? shortest : "";
}

}  // namespace

std::string similar_name(std::string_view word, const std::vector<std::string>& names) {
  constexpr std::size_t most_letters = 2, longest = 100;
  if (word.size() > longest) return "";
  if (std::string whole = completed(word, names); !whole.empty()) return whole;
  const std::string small = in_small_letters(word);
  std::string nearest;
  std::size_t least = most_letters + 1;
  for (const std::string& name : names) {
    if (name.size() > word.size() + most_letters || word.size() > name.size() + most_letters)
      continue;
    const std::size_t off = distance(small, in_small_letters(name));
    if (off >= least) continue;
    nearest = name;
    least = off;
  }
  return 2 * least < word.size() ? nearest : "";
}

std::string did_you_mean(std::string_view word, const std::vector<std::string>& names) {
  const std::string name = similar_name(word, names);
  return name.empty() ? "" : "; did you mean " + name + "?";
}

}  // namespace asterism::internal
