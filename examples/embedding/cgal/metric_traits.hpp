// SPDX-License-Identifier: MIT
//
// Traits that make CGAL's Delaunay_triangulation_2 that of one metric tensor: the in-circle test is
// Asterism's, on the points as they are; all else is CGAL's exact kernel of the plane, since the
// orientation of three points is the same in every metric.
#pragma once

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include "asterism/kernels/filtered_kernel.hpp"

namespace embedding {

class metric_traits : public CGAL::Exact_predicates_inexact_constructions_kernel {
 public:
  class Side_of_oriented_circle_2 {
   public:
    using result_type = CGAL::Oriented_side;
    explicit Side_of_oriented_circle_2(const asterism::metric_tensor& metric) : metric_(metric) {}

    CGAL::Oriented_side operator()(const Point_2& a, const Point_2& b, const Point_2& c,
                                   const Point_2& p) const {
      const auto at = [](const Point_2& q) { return asterism::point{q.x(), q.y()}; };
      const asterism::filtered_kernel kernel;
      return CGAL::Oriented_side(
          asterism::to_int(kernel.in_circle(metric_, at(a), at(b), at(c), at(p))));
    }

   private:
    asterism::metric_tensor metric_;
  };

  // Requires a positive definite tensor.
  explicit metric_traits(const asterism::metric_tensor& metric = {1, 0, 1}) : metric_(metric) {}

  Side_of_oriented_circle_2 side_of_oriented_circle_2_object() const {
    return Side_of_oriented_circle_2(metric_);
  }

 private:
  asterism::metric_tensor metric_;
};

}  // namespace embedding
