// SPDX-License-Identifier: MIT
//
// The insertion test and the edge test by the sweep of arc_sections.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <optional>

#include "arc_sections.hpp"
#include "exact_numbers.hpp"
#include "oracle.hpp"

namespace asterism::oracle {
namespace {

using four_sites = std::array<exact_site, 4>;

rational two_to_minus(long exponent) {
  return rational(integer(1), integer(1) << static_cast<unsigned long>(exponent));
}

std::array<std::size_t, 4> lexicographic_ranks(const std::array<const site*, 4>& sites) {
  std::array<std::size_t, 4> ranks{};
  for (std::size_t i = 0; i < 4; ++i)
    for (std::size_t j = 0; j < 4; ++j)
      if (lexicographically_less(sites[j]->position, sites[i]->position)) ++ranks[i];
  return ranks;
}

// Only differences of offsets matter. The least site has offset zero; the others have 2^-k, 2^-4k
// and 2^-16k, the greatest site the greatest.
four_sites pushed_away(const std::array<const site*, 4>& sites, long k) {
  const auto ranks = lexicographic_ranks(sites);
  const std::array<rational, 4> offsets = {rational(0), two_to_minus(16 * k), two_to_minus(4 * k),
                                           two_to_minus(k)};
  four_sites pushed;
  for (std::size_t i = 0; i < 4; ++i) {
    pushed[i] = to_exact(*sites[i]);
    pushed[i].offset = offsets[ranks[i]];
  }
  return pushed;
}

// True if the numbers are whole multiples of 2^-10 below 2^10. The roots are then farther apart
// than the offsets can move them (tried at two scales, not proven).
bool has_few_digits(const site& s) {
  const std::array<double, 5> numbers = {s.position.x, s.position.y, s.metric.m11, s.metric.m12,
                                         s.metric.m22};
  return std::all_of(numbers.begin(), numbers.end(), [](double number) {
    return std::fabs(number) <= 0x1p10 && std::nearbyint(number * 0x1p10) == number * 0x1p10;
  });
}

// True if the run begins or ends where a bisector with x and one with y meet: the point that the
// tie rule is about.
bool is_between_x_and_y(const good_run& run) {
  const unsigned low = run.kinds_at_low_end, high = run.kinds_at_high_end;
  return (low == equidistant_from_x && high == equidistant_from_y) ||
         (low == equidistant_from_y && high == equidistant_from_x);
}

std::optional<bool> perturbed_answer(const std::array<const site*, 4>& sites, long k) {
  const four_sites s = pushed_away(sites, k);
  const swept_arc arc = sweep(s[0], s[1], s[2], s[3]);
  if (arc.good_runs.empty()) return false;
  if (std::any_of(arc.good_runs.begin(), arc.good_runs.end(), is_between_x_and_y)) return true;
  return std::nullopt;
}

}  // namespace

bool insertion_test(const site& v, const site& w, const site& x, const site& y) {
  return !sweep(to_exact(v), to_exact(w), to_exact(x), to_exact(y)).good_runs.empty();
}

std::optional<bool> edge_test(const site& v, const site& w, const site& x, const site& y) {
  const swept_arc arc = sweep(to_exact(v), to_exact(w), to_exact(x), to_exact(y));
  if (!arc.good_runs.empty()) return true;
  if (!arc.may_have_point_equidistant_from_four) return false;
  if (arc.tie_may_be_beyond_first_order) return std::nullopt;
  const std::array<const site*, 4> sites = {&v, &w, &x, &y};
  if (!std::all_of(sites.begin(), sites.end(), [](const site* s) { return has_few_digits(*s); }))
    return std::nullopt;
  // If two scales disagree, one of them is above the separation of the roots: there is no answer.
  const std::optional<bool> coarse = perturbed_answer(sites, 100),
                            fine = perturbed_answer(sites, 130);
  return coarse == fine ? fine : std::nullopt;
}

}  // namespace asterism::oracle
