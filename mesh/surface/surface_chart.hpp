// SPDX-License-Identifier: MIT
//
// Defines the plane of a patch's parameters, and the metric in it in which edges of length 1 are as
// long as a chord height allows. Works in doubles; the results are proposals.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "asterism/core/site.hpp"
#include "asterism/mesh/surface_audit/shell_triangles.hpp"

namespace asterism::internal {

// Limits on edges. Lengths are in units of space.
struct surface_sizes {
  double chord = 0;               // D
  std::optional<double> turn;     // of the normal along an edge, radians
  std::optional<double> longest;  // edge
  double aspect = 0;              // the greatest ratio of the two lengths at a point
};

// Chart of a patch, in units (u 2^scale_u, v 2^scale_v) that make it about as wide and high as in
// space: powers of two, so that parameters in other units of powers of two have the same chart, bit
// for bit.
class surface_chart {
 public:
  // Makes the chart of the whole patch, or of the box around the loops that trim it.
  surface_chart(const surface_patch& patch, const std::vector<bezier_piece>& pieces,
                const patch_spans& spans);

  int scale_u() const { return scale_u_; }
  int scale_v() const { return scale_v_; }
  point low() const { return low_; }
  point high() const { return high_; }

  // Returns the nearest point of the patch's rectangle.
  point in_patch(const point& p) const;
  // Returns the point of the surface at a point of the chart; at a side the point on the side
  // itself.
  space_point lift(const point& p) const;
  // Returns the metric that the curvature at the point alone requires. At a side that is one point,
  // returns the metric at a point near it. `first` and `second` are the directions of the
  // curvatures, as displacements in the chart that are 1 long in space; none where there is no
  // normal.
  struct local_metric {
    metric_tensor metric{0, 0, 0};
    std::array<point, 2> directions;
    std::array<double, 2> densities{};
    bool known = false;
  };
  local_metric metric_at(const point& p, const surface_sizes& sizes) const;

 private:
  struct local_place {
    const bezier_piece* piece;
    double s, t;
  };
  local_place place_of(const point& p) const;
  void keep_to_loops(const surface_patch& patch);
  plain_second_jet jet_at(const point& p) const;

  const std::vector<bezier_piece>* pieces_;
  const patch_spans* spans_;
  int scale_u_ = 0, scale_v_ = 0;
  point low_, high_;
};

}  // namespace asterism::internal
