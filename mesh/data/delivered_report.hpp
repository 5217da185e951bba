// SPDX-License-Identifier: MIT
//
// Holds the distance of a mesh's delivered metric from the one wanted. Plain data: the
// mesher fills it in, certificates hold it, verify measures it
// (delivery/delivered_metric.hpp).
#pragma once

#include <cstddef>
#include <vector>

#include "asterism/mesh/data/domain.hpp"

namespace asterism {

// Distances of the metric delivered from the one wanted: ln of the greatest ratio in which the two
// tensors of a site measure a length, 0.095 for ten percent. It is half the greatest |ln| of an
// eigenvalue of A^-1 B: at least as strict as half the difference of the logarithms of A and B.
struct delivered_report {
  std::size_t changed = 0;  // sites whose tensor is not, to the last bit, the one wanted there
  double beyond_tenth = 0;  // the part of the sites where some length differs by more than 10 %
  double median = 0, ninetieth = 0, greatest = 0;  // distances, of all sites
  // Area of the domain in either metric, from the tensors at the vertices.
  double complexity_wanted = 0, complexity_delivered = 0;
  // Factor by which edges are longer than 1, so that the mesh has the number of sites
  // wanted.
  double length_factor = 1;
  // Least angle in degrees, and the triangles below the bound, ascending: in the metric wanted,
  // without angles at corners of the domain that are sharp in it.
  double worst_angle_wanted = 180;
  std::vector<vertex_index> low_wanted;
};

// Greatest median distance of a run that is complete where no tolerance is asked for: ln 10. With
// more, half of the sites find some length more than ten times as long or as short as wanted, and
// the metric is another one altogether. Of metrics as simulations make them, the worst are two
// fronts that cross on 500 vertices, at 1.52 (docs/results/metrics_on_meshes.md).
inline constexpr double most_median_distance = 2.302585092994046;

// Greatest ratio of the complexities of the two metrics, the greater to the lesser, of a run that
// is complete where no tolerance is asked for. Beyond it the mesh is of another size altogether,
// though half of its sites, in a flat part, may have the tensors wanted. Of metrics as simulations
// make them, two fronts that cross have the greatest ratio, 3.4.
inline constexpr double most_density_ratio = 10;

// Returns the ratio of the complexities of the metric delivered and of the one wanted, or its
// inverse, whichever is at least 1; NaN where they have no ratio.
inline double density_ratio(const delivered_report& report) {
  const double ratio = report.complexity_delivered / report.complexity_wanted;
  return ratio < 1 ? 1 / ratio : ratio;
}

}  // namespace asterism
