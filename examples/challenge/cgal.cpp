// SPDX-License-Identifier: MIT
//
// CGAL's kernels: EPICK (exact predicates, inexact constructions), or with the argument --inexact
// plain doubles. The header files used here are under the LGPL 3 or later.
//
// In a metric CGAL has no predicate. What people do is to map the points by F, F^T F = M, and ask
// in the plane; the images are rounded, whatever the kernel.
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Simple_cartesian.h>

#include <cmath>

#include "record_reader.hpp"

namespace {

template <class Kernel>
struct predicates {
  using point = typename Kernel::Point_2;

  static point at(const std::vector<double>& n, std::size_t first) {
    return {n[first], n[first + 1]};
  }
  // F is upper triangular: the Cholesky factor.
  static point mapped(const std::vector<double>& n, std::size_t first) {
    const double f11 = std::sqrt(n[0]), f12 = n[1] / f11, f22 = std::sqrt(n[2] - f12 * f12);
    return {f11 * n[first] + f12 * n[first + 1], f22 * n[first + 1]};
  }
  static int in_circle(const point& a, const point& b, const point& c, const point& p) {
    return static_cast<int>(CGAL::side_of_oriented_circle(a, b, c, p));
  }

  static bool answer(const std::string& name, const std::vector<double>& n, int& given) {
    if ((name == "orient2d" || name == "orientation") && n.size() == 6)
      given = static_cast<int>(CGAL::orientation(at(n, 0), at(n, 2), at(n, 4)));
    else if (name == "incircle" && n.size() == 8)
      given = in_circle(at(n, 0), at(n, 2), at(n, 4), at(n, 6));
    else if (name == "in_circle" && n.size() == 11)
      given = in_circle(mapped(n, 3), mapped(n, 5), mapped(n, 7), mapped(n, 9));
    else
      return false;
    return true;
  }
};

}  // namespace

int main(int count, char** words) {
  if (count > 1 && std::string(words[1]) == "--inexact")
    return challenge_adapter::answer_records(predicates<CGAL::Simple_cartesian<double>>::answer);
  return challenge_adapter::answer_records(
      predicates<CGAL::Exact_predicates_inexact_constructions_kernel>::answer);
}
