// SPDX-License-Identifier: MIT
#include "asterism/mesh/pipeline/scaled_metric.hpp"

#include <fmt/format.h>

#include <cmath>
#include <numbers>
#include <utility>

#include "asterism/core/number_text.hpp"
#include "asterism/mesh/audit/certificate.hpp"
#include "asterism/mesh/delivery/metric_complexity.hpp"
#include "asterism/mesh/metric/local_sizes.hpp"

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
  double size = 1, found = 0;
  for (int turn = 0; turn < most_turns; ++turn) {
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
    size *= std::sqrt(ratio);
  }
  return error{fmt::format("complexity {}: not met with gradation {}; the last turn had {}",
                           *wanted.complexity, wanted.gradation.value_or(0), found)};
}

}  // namespace asterism
