// SPDX-License-Identifier: MIT
#include "asterism/mesh/pipeline/periodic_mesh.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <string>
#include <utility>

#include "asterism/mesh/delivery/count_search.hpp"
#include "asterism/mesh/delivery/domain_background.hpp"
#include "asterism/mesh/pipeline/counted_mesh.hpp"
#include "asterism/mesh/pipeline/kept_mesh.hpp"
#include "asterism/mesh/pipeline/mesh_attempts.hpp"
#include "asterism/mesh/pipeline/outcome_text.hpp"
#include "asterism/mesh/pipeline/periodic_division.hpp"
#include "asterism/mesh/pipeline/periodic_sides.hpp"
#include "asterism/mesh/pipeline/split_across.hpp"
#include "asterism/mesh/pipeline/star_refusal.hpp"
#include "asterism/mesh/stars/work_limit.hpp"

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

// Returns the metric length of edges with which the domain takes this number of vertices; none
// where no number is wanted, or the metric is not given at the nodes of a mesh. A mesh is fitted to
// the number by edges of another length than 1: sides divided in lengths of 1 would leave too few
// vertices for the inside. If unit edges take A vertices for the area and B for half the boundary,
// edges of length t take A / t^2 + B / t vertices, 2 B / t of them on the boundary.
std::optional<double> edge_length_for_count(const domain& d, const metric_field& field,
                                            std::optional<std::size_t> vertices) {
  const mesh* const given = vertices ? background_of_domain(d, field) : nullptr;
  if (given == nullptr) return std::nullopt;
  const unit_counts counts = vertices_of_unit_edges(*given);
  const auto wanted = static_cast<double>(*vertices);
  const double area = counts.inside, half_boundary = std::max(0.0, counts.all - counts.inside);
  const double length =
      (half_boundary + std::sqrt(half_boundary * half_boundary + 4 * area * wanted)) / (2 * wanted);
  const double for_boundary = 2 * half_boundary / wanted;
  if (!std::isfinite(length) || !(length > 0)) return std::nullopt;
  return std::max(length, for_boundary);
}

// Explains sides that differ after this many meshes, none of them with the points that both want.
std::string differing_text(int meshes, const std::string& why) {
  return fmt::format(
      "each of {} meshes splits one side where its partner has no vertex, and a mesh with the "
      "vertices of both was not made ({}): more vertices, or a stricter gradation, leave fewer "
      "edges to split",
      meshes, why);
}

// Makes meshes with periodic sides of one domain, once for each way in which stars are confirmed.
class periodic_mesher {
 public:
  // References must outlive the object.
  periodic_mesher(const domain& d, const metric_field& field, const mesh_options& options,
                  const std::vector<periodic_pair>& pairs, const progress_listener& progress,
                  bool no_split_across)
      : domain_(d),
        field_(field),
        options_(options),
        pairs_(pairs),
        progress_(progress),
        no_split_across_(no_split_across),
        is_fitted_(edge_length_for_count(d, field, options.vertices).has_value()) {}

  // Makes the mesh and judges it. Where the number of vertices is not near the one wanted, aims at
  // other numbers, with 0.3 of the work of a run: sides are divided in other lengths, and the
  // inside is fitted to the rest. What stars split on one side is added on the other, so the number
  // aimed at is not the number that comes. Returns the certified mesh nearest to the one wanted.
  result<certified_mesh> run(star_confirmation confirmed, bool may_deliver) {
    constexpr int most_times = 6;
    constexpr double part_of_run = 0.3, slowest_growth = 0.25;  // as meet_vertices()
    constexpr double runs_for_rounds = 2;
    auto nearest = attempt(confirmed, may_deliver, with_runs(runs_for_rounds));
    if (!is_fitted_ || !nearest || !nearest.value().certified()) return nearest;
    mesh_options aiming = with_runs(part_of_run);
    count_search search(static_cast<double>(*options_.vertices), slowest_growth);
    search.take(static_cast<double>(unsplit_));
    for (int times = 0; times < most_times && !aiming.stop.is_requested(); ++times) {
      if (is_count_near(*options_.vertices, unsplit_)) break;
      aiming.vertices = count_aimed_at(*options_.vertices, search.factor(), options_.max_sites);
      auto other = attempt(confirmed, may_deliver, aiming);
      if (!other || !other.value().certified()) break;
      if (search.take(static_cast<double>(unsplit_))) nearest = std::move(other);
    }
    return nearest;
  }

 private:
  // Returns the options with this multiple of the work limit of a run.
  mesh_options with_runs(double times) const {
    mesh_options limited = options_;
    limited.stop = options_.stop.with_work(times * units_for_run, times * run_units_for_site);
    return limited;
  }

  // Makes the mesh for the number of vertices in the options.
  result<certified_mesh> attempt(star_confirmation confirmed, bool may_deliver,
                                 const mesh_options& options) {
    auto sides = divided_sides(options);
    if (!sides) return sides.failure();
    auto made = make_in_rounds(sides.value(), confirmed, may_deliver, options);
    if (!made) return made.failure();
    if (progress_) progress_({.phase = mesh_phase::auditing, .sites = made.value().sites});
    certified_mesh judged = judge_outcome(std::move(made).value(), domain_, options_);
    if (why_not_split_) judged.claim.reason = *why_not_split_;
    claim_periodic(pairs_, judged);
    if (why_sides_differ_ && !judged.claim.complete) judged.claim.reason = *why_sides_differ_;
    return judged;
  }

  // Returns the sides with the stations that a fill has. A mesh keeps all of them. So if there are
  // more vertices than wanted before the inside has any, edges are made longer by that ratio: every
  // part of a side has a whole number of edges, which the length for the count leaves out.
  result<all_sides> divided_sides(const mesh_options& options) const {
    constexpr int most_times = 4;
    const auto fitted = edge_length_for_count(domain_, field_, options.vertices);
    double length = fitted.value_or(1);
    for (int times = 1;; ++times) {
      auto sides = find_sides(domain_, pairs_);
      if (!sides || !options.limit_size || options.strategy != refinement_strategy::fill)
        return sides;
      constexpr std::size_t part = 4;  // of the sites there may be: more leaves few for the inside
      for (periodic_sides& one : sides.value())
        if (auto failed = divide_by_length(field_, length, options.max_sites / part, one))
          return *failed;
      if (!fitted || times == most_times || domain_.vertices.size() >= *options.vertices)
        return sides;
      const std::size_t there = periodic_division(domain_, sides.value()).shape().vertices.size();
      if (there <= *options.vertices) return sides;
      length *= static_cast<double>(there) / static_cast<double>(*options.vertices);
    }
  }

  // Makes meshes until the sides of one agree. Returns the last complete one, whose sides differ,
  // if the next is not complete or the work is done.
  result<mesh_outcome> make_in_rounds(all_sides& sides, star_confirmation confirmed,
                                      bool may_deliver, const mesh_options& options) {
    why_sides_differ_.reset();
    std::optional<mesh_outcome> before;
    for (int round = 1;; ++round) {
      const periodic_division divided(domain_, sides);
      const std::size_t unsplit_before = unsplit_;
      result<mesh_outcome> made = make_round(divided.shape(), confirmed, may_deliver, options);
      if (!made) return made;
      mesh_outcome& one = made.value();
      if (!one.complete && before) {
        why_sides_differ_ = differing_text(round - 1, why_not_split_.value_or(ending_text(one)));
        unsplit_ = unsplit_before;
        return *std::move(before);
      }
      const bool is_last =
          !one.complete || agree(one.result, sides) || divided.take_splits(one.result, sides) == 0;
      divided.restore(one);
      if (is_last) return made;
      const auto why = options.stop.poll();
      if (why || round == most_rounds) {
        why_sides_differ_ = differing_text(round, why.value_or("no more are made"));
        return made;
      }
      before = std::move(made).value();
    }
  }

  // True if the mesh itself has the same points on both sides of all pairs: exactly where the
  // stations are exact, else up to roundings.
  bool agree(const mesh& m, const all_sides& sides) const {
    constexpr double rounding = 0x1p-44;  // part of the largest coordinate
    const bounding_box box = domain_.box();
    const double size = std::max(
        {std::abs(box.low.x), std::abs(box.low.y), std::abs(box.high.x), std::abs(box.high.y)});
    for (std::size_t i = 0; i < pairs_.size(); ++i) {
      const auto match = match_periodic(m, pairs_[i]);
      if (!match || !(match.value().greatest_offset <= rounding * size)) return false;
      if (match.value().kind == periodic_kind::matched && sides[i].map().is_exact) return false;
    }
    return true;
  }

  // Makes one mesh of the divided domain, with the work of a run at most.
  result<mesh_outcome> make_round(const domain& divided, star_confirmation confirmed,
                                  bool may_deliver, const mesh_options& options) {
    mesh_options limited = options;
    limited.stop = options.stop.with_work(units_for_run, run_units_for_site);
    auto made = make_by_attempts(divided, field_, limited, progress_, confirmed, may_deliver);
    if (!made) return made;
    unsplit_ = made.value().sites;
    if (no_split_across_) made = without_edges_across(std::move(made).value(), divided, options);
    return made;
  }

  // Splits the inner edges that join two vertices of the boundary. The splits that stars then need
  // may be on the sides.
  mesh_outcome without_edges_across(mesh_outcome made, const domain& divided,
                                    const mesh_options& options) {
    why_not_split_.reset();
    if (!made.complete) return made;
    certified_mesh split =
        split_across(judge_outcome(std::move(made), divided, options), divided, field_, options);
    if (!split.outcome.complete) why_not_split_ = split.claim.reason;
    return std::move(split.outcome);
  }

  const domain& domain_;
  const metric_field& field_;
  const mesh_options& options_;
  const std::vector<periodic_pair>& pairs_;
  const progress_listener& progress_;
  const bool no_split_across_;
  const bool is_fitted_;                      // to a number of vertices, by edges of any length
  std::size_t unsplit_ = 0;                   // vertices of the last mesh, before edges were split
  std::optional<std::string> why_not_split_;  // of the last mesh
  std::optional<std::string> why_sides_differ_;
};

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
                                          const progress_listener& progress, bool no_split_across) {
  if (pairs.empty()) {
    auto made = make_certified_mesh(d, field, options, progress);
    if (!made || !no_split_across) return made;
    return split_across(std::move(made).value(), d, field, options);
  }
  // Refuses darts. Their first distance is that of the nearest vertices, and stations are near to
  // each other: a square that needs 224 sites had 6,700 after a minute, and was not finished.
  if (options.strategy == refinement_strategy::poisson_darts)
    return error{"periodic sides are made by the strategies fill and voronoi, not by darts",
                 error_code::bad_option};
  if (auto refused = check_periodic(d, pairs)) return *refused;
  periodic_mesher mesher(d, field, options, pairs, progress, no_split_across);
  return judged_until_confirmed(options, [&](star_confirmation confirmed, bool may_deliver) {
    return mesher.run(confirmed, may_deliver);
  });
}

}  // namespace asterism
