// SPDX-License-Identifier: MIT
#include "asterism/mesh/delivery/tolerated_metric.hpp"

namespace asterism::internal {

std::optional<intolerable_distance> excess_of(const mesh_outcome& made,
                                              const mesh_options& options) {
  if (!made.delivered || made.stopped) return std::nullopt;
  return excess_in(*made.delivered, options.metric_tolerance);
}

std::optional<intolerable_distance> excess_in(const delivered_report& report,
                                              std::optional<double> tolerance) {
  using measure = intolerable_distance::measure;
  const auto beyond = [&report](double allowed, double found,
                                measure of) -> std::optional<intolerable_distance> {
    if (found <= allowed) return std::nullopt;
    return intolerable_distance{allowed, found, of, report.greatest};
  };
  if (tolerance) return beyond(*tolerance, report.greatest, measure::greatest);
  if (const auto excess = beyond(most_median_distance, report.median, measure::median))
    return excess;
  // Ignores the ratio of areas at the ends of the range of doubles, where it has no value.
  const double ratio = density_ratio(report);
  if (!(ratio > most_density_ratio)) return std::nullopt;
  return beyond(most_density_ratio, ratio, measure::density);
}

}  // namespace asterism::internal
