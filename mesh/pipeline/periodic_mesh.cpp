// SPDX-License-Identifier: MIT
#include "asterism/mesh/pipeline/periodic_mesh.hpp"

#include <algorithm>
#include <cstddef>
#include <string>
#include <utility>

#include "asterism/mesh/pipeline/mesh_attempts.hpp"
#include "asterism/mesh/pipeline/periodic_division.hpp"
#include "asterism/mesh/pipeline/periodic_sides.hpp"
#include "asterism/mesh/pipeline/star_refusal.hpp"

namespace asterism {
using namespace internal;
namespace {

// Largest number of rounds in which meshes add stations on the sides. That the rounds end is proved
// for fills, not for local changes (docs/math/periodic.md).
constexpr int most_rounds = 100;

using all_sides = std::vector<periodic_sides>;

std::optional<error> find_repeated(const std::vector<periodic_pair>& pairs) {
  std::vector<int> markers;
  for (const periodic_pair& one : pairs)
    for (const int marker : {one.first, one.second}) {
      if (std::find(markers.begin(), markers.end(), marker) != markers.end())
        return error{"the sides with markers " + std::to_string(one.first) + " and " +
                         std::to_string(one.second) + " cannot be periodic: marker " +
                         std::to_string(marker) + " is named twice",
                     error_code::bad_option};
      markers.push_back(marker);
    }
  return std::nullopt;
}

result<all_sides> find_sides(const domain& d, const std::vector<periodic_pair>& pairs) {
  if (auto repeated = find_repeated(pairs)) return *repeated;
  all_sides all;
  for (const periodic_pair& one : pairs) {
    auto sides = periodic_sides::find(d, one);
    if (!sides) return sides.failure();
    all.push_back(std::move(sides).value());
  }
  return all;
}

// Makes meshes until one splits no segment between stations, or is not complete.
template <class Make>
result<mesh_outcome> make_in_rounds(const domain& d, all_sides& sides, const Make& make) {
  for (int round = 1;; ++round) {
    const periodic_division divided(d, sides);
    result<mesh_outcome> made = make(divided.shape());
    if (!made) return made;
    const bool is_last = !made.value().complete || round == most_rounds ||
                         divided.take_splits(made.value().result, sides) == 0;
    if (!is_last) continue;
    divided.restore(made.value());
    return made;
  }
}

}  // namespace

std::optional<error> check_periodic(const domain& d, const std::vector<periodic_pair>& pairs) {
  const auto found = find_sides(d, pairs);
  if (!found) return found.failure();
  return std::nullopt;
}

void claim_periodic(const std::vector<periodic_pair>& pairs, certified_mesh& judged) {
  certificate& claim = judged.claim;
  claim.periodic_asked = pairs;
  claim.periodic.clear();
  for (const periodic_pair& one : pairs) {
    auto match = match_periodic(judged.outcome.result, one);
    if (match) {
      claim.periodic.push_back(std::move(match).value());
      continue;
    }
    if (claim.complete) claim.reason = match.failure().message;
    judged.outcome.complete = claim.complete = false;
  }
}

result<certified_mesh> make_periodic_mesh(const domain& d, const metric_field& field,
                                          const mesh_options& options,
                                          const std::vector<periodic_pair>& pairs,
                                          const progress_listener& progress) {
  if (pairs.empty()) return make_certified_mesh(d, field, options, progress);
  // Refuses darts: they start from the distance of the nearest vertices, and stations are near: of
  // a square with 224 sites there were 6,700 after a minute, and no end.
  if (options.strategy == refinement_strategy::poisson_darts)
    return error{"periodic sides are made by the strategies fill and voronoi, not by darts",
                 error_code::bad_option};
  auto sides = find_sides(d, pairs);
  if (!sides) return sides.failure();
  constexpr std::size_t part = 4;  // of the sites there may be; more leaves too few for the inside
  if (options.limit_size && options.strategy == refinement_strategy::fill)
    for (periodic_sides& one : sides.value())
      if (auto failed = divide_by_length(field, options.max_sites / part, one)) return *failed;
  const auto judged_with = [&](star_confirmation confirmed,
                               bool may_deliver) -> result<certified_mesh> {
    auto made = make_in_rounds(d, sides.value(), [&](const domain& divided) {
      return make_by_attempts(divided, field, options, progress, confirmed, may_deliver);
    });
    if (!made) return made.failure();
    if (progress) progress({.phase = mesh_phase::auditing, .sites = made.value().sites});
    certified_mesh judged = judge_outcome(std::move(made).value(), d, options);
    claim_periodic(pairs, judged);
    return judged;
  };
  return judged_until_confirmed(options, judged_with);
}

}  // namespace asterism
