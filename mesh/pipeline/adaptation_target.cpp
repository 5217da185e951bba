// SPDX-License-Identifier: MIT
#include "asterism/mesh/pipeline/adaptation_target.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

namespace asterism::internal {
namespace {

constexpr double vertices_a_complexity = 2 / std::numbers::sqrt3;  // for each of complexity

}  // namespace

std::optional<error> take_target(const adaptation_wish& wish, const std::string& limit,
                                 mesh_adaptation_options& options) {
  const solution_metric_options& wishes = wish.wishes;
  const bool names_other = wishes.complexity || wishes.error;
  const auto own = static_cast<double>(wish.vertices_before);
  const double vertices = names_other ? vertices_a_complexity * wish.report.complexity_delivered
                                      : wishes.vertices.value_or(own);
  const bool says_how_many = names_other || wishes.vertices || wish.of_solution;
  constexpr auto most = static_cast<double>(most_sites_unasked);
  if (!options.keeps_site_limit && says_how_many && vertices > most)
    return error{fmt::format("{:.4g} vertices are wanted, and no more than {:.0f} are made unless "
                             "{} names a greater limit",
                             vertices, most, limit),
                 error_code::bad_option};
  if (names_other && !options.keeps_site_limit) {
    constexpr double times = 4;
    const double room = std::min(most, times * wish.report.complexity_delivered);
    options.refinement.max_sites =
        std::max(options.refinement.max_sites, static_cast<std::size_t>(room));
  }
  if (names_other || !wish.report.reached || !says_how_many) return std::nullopt;
  options.refinement.vertices = static_cast<std::size_t>(std::max(1L, std::lround(vertices)));
  return std::nullopt;
}

namespace {

// Returns the number of vertices on segments of the domain: all of them, or those inside alone.
std::size_t vertices_on_segments(const mesh& m, bool inside_alone) {
  std::vector<bool> is_on(m.sites.size(), false);
  for (const boundary_edge& e : m.boundary)
    if (e.internal || !inside_alone) is_on[e.a] = is_on[e.b] = true;
  return static_cast<std::size_t>(std::count(is_on.begin(), is_on.end(), true));
}

}  // namespace

std::optional<std::string> what_is_missed(const adapted_mesh& next,
                                          const solution_metric_report& report,
                                          const std::optional<std::size_t>& vertices_wanted) {
  if (!next.made.certified()) return next.made.claim.reason;
  if (!report.reached) return report.reason;
  if (!vertices_wanted) return std::nullopt;
  constexpr double tolerable = 0.1, few = 5;
  const auto wanted = static_cast<double>(*vertices_wanted),
             got = static_cast<double>(next.made.outcome.result.sites.size());
  if (std::abs(got - wanted) <= std::max(tolerable * wanted, std::min(few, wanted / 2)))
    return std::nullopt;
  const mesh& made = next.made.outcome.result;
  const std::size_t inside = vertices_on_segments(made, true);
  return fmt::format("{} vertices were wanted, and {} are there, {} of them on segments{}", wanted,
                     got, vertices_on_segments(made, false),
                     inside == 0 || got < wanted
                         ? ""
                         : fmt::format(", {} on those inside, which keep every vertex at which a "
                                       "line between regions bends",
                                       inside));
}

}  // namespace asterism::internal
