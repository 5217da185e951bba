// SPDX-License-Identifier: MIT
#include "asterism/mesh/pipeline/scaled_metric.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <utility>

#include "asterism/core/elementary.hpp"
#include "asterism/core/number_text.hpp"
#include "asterism/mesh/audit/certificate.hpp"
#include "asterism/mesh/delivery/metric_complexity.hpp"
#include "asterism/mesh/metric/local_sizes.hpp"
#include "asterism/mesh/numerics/target_search.hpp"

namespace asterism {
namespace {

// Makes the metric for edges of one size, graded if that is asked for.
result<scaled_metric> of_size(const domain& d, const field_of_size& make,
                              const scale_demand& wanted, double size) {
  auto given = make(size);
  if (!given) return given.failure();
  scaled_metric made;
  made.size = size;
  if (const mesh* const background = given.value()->background())
    made.background_fingerprint = mesh_fingerprint(*background);
  auto field = with_local_sizes(std::move(given).value(), d, wanted.sizes);
  if (!field) return field.failure();
  if (!wanted.gradation) {
    made.field = std::move(field).value();
    return made;
  }
  gradation_options options;
  options.beta = *wanted.gradation;
  options.stop = wanted.stop;
  auto graded = internal::grade_as_given(std::move(field).value(), d, options);
  if (!graded) return graded.failure();
  made.field = std::move(graded.value().field);
  made.gradation = graded.value().report;
  return made;
}

// Returns why no size was found, in the words of what was asked for.
std::string not_met_text(const scale_demand& wanted, double found) {
  const double for_each =
      wanted.vertices ? static_cast<double>(*wanted.vertices) / *wanted.complexity : 1;
  const std::string asked =
      wanted.vertices ? fmt::format("{} vertices were wanted", *wanted.vertices)
                      : fmt::format("a complexity of {:.6g} was wanted", *wanted.complexity);
  const std::string taken = wanted.vertices ? fmt::format("about {:.0f}", found * for_each)
                                            : fmt::format("{:.6g}", found);
  if (!wanted.sizes.is_empty() && found > *wanted.complexity)
    return fmt::format(
        "{}, and sizes and layers at places, which are not scaled, take {}: a greater number, or "
        "larger sizes at places, can be met",
        asked, taken);
  return fmt::format(
      "{}, and {} came of the last size that was tried{}", asked, taken,
      wanted.gradation ? fmt::format(", with the gradation {:g}", *wanted.gradation) : "");
}

}  // namespace

double complexity_of_vertices(std::size_t vertices) {
  return static_cast<double>(vertices) * (std::numbers::sqrt3 / 2);
}

result<scaled_metric> make_scaled_metric(const domain& d, const field_of_size& make,
                                         const scale_demand& wanted) {
  if (!wanted.complexity) return of_size(d, make, wanted, wanted.size.value_or(1));
  if (!(*wanted.complexity > 0 && std::isfinite(*wanted.complexity)))
    return error{"complexity: a positive finite number is wanted"};
  constexpr int most_turns = 20;
  constexpr double near = 0.005;
  // Searches densities, inverse squares of sizes, since an ungraded metric's complexity is in
  // proportion to them. Their unit is the density that would then be right.
  double size_of_unit = 1, found = 0;
  internal::target_search search;
  for (int turn = 0; turn < most_turns && !search.is_saturated(); ++turn) {
    const double size = size_of_unit / std::sqrt(elementary::exp(search.at()));
    auto made = of_size(d, make, wanted, size);
    if (!made) return made.failure();
    const auto complexity = internal::complexity_over(d, *made.value().field, wanted.stop);
    if (!complexity) return complexity.failure();
    found = complexity.value();
    const double ratio = found / *wanted.complexity;
    if (!(ratio > 0 && std::isfinite(ratio)))
      return error{fmt::format("complexity: that of the metric is {}, which cannot be scaled",
                               internal::format_number(found))};
    if (std::abs(ratio - 1) <= near) {
      made.value().complexity = found;
      return made;
    }
    const double off = elementary::log(ratio);
    if (turn == 0) {
      size_of_unit = std::sqrt(ratio);
      search = internal::target_search(0, off);
    }
    search.take(off);
  }
  return error{not_met_text(wanted, found)};
}

}  // namespace asterism
