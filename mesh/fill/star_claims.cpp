// SPDX-License-Identifier: MIT
#include "asterism/mesh/fill/star_claims.hpp"

#include <algorithm>
#include <utility>

namespace asterism::internal {
namespace {

void begin_star(claims_by_star& sorted, vertex_index star, std::size_t at) {
  sorted.stars.push_back(star);
  sorted.starts.push_back(static_cast<std::uint32_t>(at));
}

claims_by_star sort_few(const claim_list& claims, std::size_t first, std::size_t last) {
  struct claim {
    vertex_index star, by;
  };
  std::vector<claim> all;
  claims.for_each([&](vertex_index star, vertex_index by) {
    if (star >= first && star < last) all.push_back({star, by});
  });
  std::stable_sort(all.begin(), all.end(),
                   [](const claim& a, const claim& b) { return a.star < b.star; });
  claims_by_star sorted;
  sorted.by.resize(all.size());
  for (std::size_t i = 0; i < all.size(); ++i) {
    if (i == 0 || all[i].star != all[i - 1].star) begin_star(sorted, all[i].star, i);
    sorted.by[i] = all[i].by;
  }
  return sorted;
}

// Sorts long lists by counting: comparisons would be mispredicted every other time.
claims_by_star sort_many(const claim_list& claims, std::size_t first, std::size_t last) {
  const std::size_t count = last - first;
  std::vector<std::uint32_t> next(count + 1);
  claims.for_each([&](vertex_index star, vertex_index) {
    if (star - first < count) ++next[star - first + 1];
  });
  const auto zeros =
      static_cast<std::size_t>(std::count(next.begin(), next.end(), std::uint32_t{0}));
  claims_by_star sorted;
  sorted.stars.reserve(next.size() - zeros);
  sorted.starts.reserve(next.size() - zeros + 1);
  for (std::size_t i = 0; i < count; ++i) {
    if (next[i + 1] > 0) begin_star(sorted, static_cast<vertex_index>(first + i), next[i]);
    next[i + 1] += next[i];
  }
  sorted.by.resize(next[count]);
  claims.for_each([&](vertex_index star, vertex_index by) {
    if (star - first < count) sorted.by[next[star - first]++] = by;
  });
  return sorted;
}

}  // namespace

void claim_list::append(const claim_list& other) {
  entries_.insert(entries_.end(), other.entries_.begin(), other.entries_.end());
  if (other.size_ > 0) last_ = other.last_;
  size_ += other.size_;
}

claims_by_star sort_by_star(const claim_list& claims, std::size_t first, std::size_t last) {
  constexpr std::size_t stars_to_a_claim = 16;
  claims_by_star sorted = claims.size() < (last - first) / stars_to_a_claim
                              ? sort_few(claims, first, last)
                              : sort_many(claims, first, last);
  sorted.starts.push_back(static_cast<std::uint32_t>(sorted.by.size()));
  return sorted;
}

}  // namespace asterism::internal
