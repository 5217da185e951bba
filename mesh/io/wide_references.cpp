// SPDX-License-Identifier: MIT
#include "asterism/mesh/io/wide_references.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <set>
#include <utility>

namespace asterism::internal {
namespace {

// Least reference that is kept. Smaller references get place holders as wide ones do, so that no
// place holder equals a reference.
constexpr int first_reference = std::numeric_limits<int>::min() / 2;

void replace_keys(std::map<int, std::string>& names, const std::map<int, int>& by) {
  std::map<int, std::string> replaced;
  for (auto& [number, name] : names) {
    const auto at = by.find(number);
    replaced[at == by.end() ? number : at->second] = std::move(name);
  }
  names = std::move(replaced);
}

}  // namespace

bool wide_references::is_plain(long long reference) {
  return reference >= first_reference && reference <= std::numeric_limits<int>::max();
}

int wide_references::number(long long reference) {
  if (is_plain(reference)) return static_cast<int>(reference);
  const int next = std::numeric_limits<int>::min() + static_cast<int>(holder_.size());
  return holder_.emplace(reference, next).first->second;
}

result<int> wide_references::read(const text_scanner& source, const word& w,
                                  std::string_view meaning) {
  const auto value = to_integer(source, w, meaning);
  if (!value.ok()) return value.failure();
  return number(value.value());
}

std::string wide_references::settle(const std::vector<std::vector<int>*>& lists,
                                    physical_names& names) {
  std::set<int> used;
  for (const auto* list : lists) used.insert(list->begin(), list->end());
  for (const auto* named : {&names.markers, &names.regions})
    for (const auto& entry : *named) used.insert(entry.first);
  std::map<int, int> by;
  std::string told;
  constexpr std::size_t most_told = 3;
  int next = 1;
  std::size_t wide = 0;
  for (const auto& [reference, holder] : holder_) {
    if (reference >= std::numeric_limits<int>::min() &&
        reference <= std::numeric_limits<int>::max()) {
      by[holder] = static_cast<int>(reference);
      continue;
    }
    while (used.count(next) != 0) ++next;
    by[holder] = next;
    if (++wide <= most_told)
      told += fmt::format("{}{} is {}", told.empty() ? "" : ", ", reference, next);
    ++next;
  }
  for (auto* list : lists)
    for (int& number : *list)
      if (const auto at = by.find(number); at != by.end()) number = at->second;
  replace_keys(names.markers, by);
  replace_keys(names.regions, by);
  if (wide == 0) return {};
  return fmt::format("references that 32 bits do not hold have other numbers here: {}{}", told,
                     wide > most_told ? fmt::format(", and {} more", wide - most_told) : "");
}

}  // namespace asterism::internal
