// SPDX-License-Identifier: MIT
#include "asterism/mesh/pipeline/scaled_metric.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
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

// Looks for the size at which a complexity is found, by densities: inverse squares of sizes. The
// first turns are as if all of the complexity went with the density. Local sizes and gradation make
// a part that does not: later turns are by the line through the last two places, within those
// found to be too little and too much.
class size_search {
 public:
  explicit size_search(double wanted) : wanted_(wanted) {}

  // Takes the complexity found at this size. Returns the next size.
  double next(double size, double found) {
    constexpr int plain_turns = 4;
    const place now{1 / (size * size), found};
    (found < wanted_ ? little_ : much_) = now;
    const place before = std::exchange(last_, now);
    if (++turns_ <= plain_turns) return size * std::sqrt(found / wanted_);
    return 1 / std::sqrt(density_after(before));
  }

 private:
  struct place {
    double density = 0, found = 0;
  };

  double density_after(const place& before) const {
    constexpr double step = 4;
    if (little_.density == 0) return much_.density / step;
    if (much_.density == 0) return little_.density * step;
    const double slope = (last_.found - before.found) / (last_.density - before.density);
    const double on_line = last_.density + (wanted_ - last_.found) / slope;
    if (on_line > little_.density && on_line < much_.density) return on_line;
    return (little_.density + much_.density) / 2;
  }

  double wanted_;
  place little_, much_, last_;  // density 0: none yet
  int turns_ = 0;
};

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
  size_search search(*wanted.complexity);
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
    size = search.next(size, found);
  }
  return error{not_met_text(wanted, found)};
}

}  // namespace asterism
