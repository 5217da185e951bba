// SPDX-License-Identifier: MIT
#include "asterism/mesh/star_construction.hpp"

#include <algorithm>
#include <vector>

#include "asterism/mesh/star_insertion.hpp"

namespace asterism {
namespace {

// Rounds over all sites. A star that does not settle in a few is replacing neighbours in a circle,
// which more rounds do not cure.
constexpr std::size_t most_rounds = 8;

std::vector<index> from_near_to_far(const site_oracle& oracle, index v) {
  struct candidate {
    double distance;
    index who;
  };
  std::vector<candidate> all;
  all.reserve(oracle.size());
  for (index w = 0; w < oracle.size(); ++w)
    if (w != v) all.push_back({oracle.squared_distance(v, w), w});
  std::sort(all.begin(), all.end(), [&](const candidate& a, const candidate& b) {
    return a.distance != b.distance ? a.distance < b.distance : oracle.precedes(a.who, b.who);
  });
  std::vector<index> order;
  order.reserve(all.size());
  for (const candidate& c : all) order.push_back(c.who);
  return order;
}

}  // namespace

constructed_star construct_star(const site_oracle& oracle, index v) {
  constructed_star built{empty_star(oracle.edges(), v), false};
  star& s = built.content;
  const std::vector<index> order = from_near_to_far(oracle, v);
  const std::size_t most_offers = most_rounds * order.size();
  std::size_t refused_in_a_row = 0;  // by the star as it is now
  for (std::size_t i = 0; i < most_offers && refused_in_a_row < order.size(); ++i) {
    const index w = order[i % order.size()];
    ++refused_in_a_row;
    if (s.contains(w)) continue;
    if (offer(oracle, v, s, w)) {
      prune(oracle, v, s);
      refused_in_a_row = 0;
    }
  }
  built.settled = refused_in_a_row == order.size();
  return built;
}

}  // namespace asterism
