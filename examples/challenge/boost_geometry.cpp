// SPDX-License-Identifier: MIT
//
// Boost.Geometry's side of a segment, as its algorithms ask it. It has no in-circle test.
#include <boost/geometry/geometries/point_xy.hpp>
#include <boost/geometry/strategies/cartesian/side_by_triangle.hpp>

#include "record_reader.hpp"

namespace {

bool answer(const std::string& name, const std::vector<double>& n, int& given) {
  using point = boost::geometry::model::d2::point_xy<double>;
  if ((name != "orient2d" && name != "orientation") || n.size() != 6) return false;
  given = boost::geometry::strategy::side::side_by_triangle<>::apply(
      point(n[0], n[1]), point(n[2], n[3]), point(n[4], n[5]));
  return true;
}

}  // namespace

int main() { return challenge_adapter::answer_records(answer); }
