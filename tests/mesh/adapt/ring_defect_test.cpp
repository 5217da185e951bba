// SPDX-License-Identifier: MIT
//
// Measures the defect of a node in rings of neighbours, beside a computation corner by corner.
#include "asterism/mesh/adapt/ring_defect.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <limits>
#include <vector>

#include "asterism/core/random.hpp"

using namespace asterism;
using namespace asterism::internal;
using namespace asterism::internal::adapting;

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double bound = 2;  // cotangent

struct ring {
  std::vector<point> at;
  std::vector<wanted_tensor> wanted;
};

wanted_tensor random_tensor(splitmix64& random) {
  const double a = random.real(0.2, 5), c = random.real(0.2, 5), b = random.real(-0.4, 0.4);
  const double root = std::sqrt(a * c - b * b);
  return {{a, b, c}, root};
}

// Seven neighbours around the origin; the first one comes again at the end.
ring random_ring(splitmix64& random) {
  ring made;
  for (int k = 0; k < 7; ++k) {
    const double angle = 0.9 * k + random.real(0, 0.5), far = random.real(0.3, 2);
    made.at.push_back({far * std::cos(angle), far * std::sin(angle)});
    made.wanted.push_back(random_tensor(random));
  }
  made.at.push_back(made.at.front());
  made.wanted.push_back(made.wanted.front());
  return made;
}

// The defect of a triangle in a tensor: of its greatest cotangent beyond the bound.
double defect_of_triangle(const wanted_tensor& w, const point& a, const point& b, const point& c) {
  double greatest = -infinity;
  const std::vector<point> corners{a, b, c};
  for (std::size_t i = 0; i < 3; ++i) {
    const point &o = corners[i], &p = corners[(i + 1) % 3], &q = corners[(i + 2) % 3];
    const double ux = p.x - o.x, uy = p.y - o.y, wx = q.x - o.x, wy = q.y - o.y;
    const metric_tensor& m = w.metric;
    const double inner = ux * (m.m11 * wx + m.m12 * wy) + uy * (m.m12 * wx + m.m22 * wy);
    greatest = std::max(greatest, inner / (w.root * (ux * wy - uy * wx)));
  }
  return greatest > bound ? std::min(1.0, greatest - bound) + 0.1 : 0;
}

}  // namespace

TEST_CASE("the defect of a ring is the sum over its triangles and the centres across") {
  const std::uint64_t seed = 17;
  CAPTURE(seed);
  splitmix64 random(seed);
  ring_defect measured(bound);
  for (int i = 0; i < 200; ++i) {
    CAPTURE(i);
    const ring r = random_ring(random);
    const wanted_tensor own = random_tensor(random);
    const point q{random.real(-0.1, 0.1), random.real(-0.1, 0.1)};
    const face_centre far{{3, 0}, 1e-3}, near{{0.5, 0.5}, 2}, nowhere{{}, -1};
    measured.clear();
    for (std::size_t k = 0; k < r.at.size(); ++k) measured.add_neighbour(r.at[k], r.wanted[k]);
    for (const face_centre& c : {far, near, nowhere}) measured.add_centre(c);
    double of_others = 0, of_own = 0;
    for (std::size_t k = 0; k + 1 < r.at.size(); ++k) {
      of_others += defect_of_triangle(r.wanted[k], q, r.at[k], r.at[k + 1]) +
                   defect_of_triangle(r.wanted[k + 1], q, r.at[k], r.at[k + 1]);
      of_own += defect_of_triangle(own, q, r.at[k], r.at[k + 1]);
    }
    const double x = near.at.x - q.x, y = near.at.y - q.y;
    const metric_tensor& m = own.metric;
    const double lacks = 1.3 - (m.m11 * x * x + 2 * m.m12 * x * y + m.m22 * y * y) / 2;
    if (lacks > 0) of_own += 2 * (std::min(1.0, lacks) + 0.1);
    of_own += 2 * 1.1;  // towards a face without a centre
    CHECK(measured.of_others(q, infinity) == Approx(of_others).margin(1e-9));
    CHECK(measured.of_own(own, infinity) == Approx(of_own).margin(1e-9));
    if (of_others > 0) CHECK(measured.of_others(q, of_others / 2) >= of_others / 2 - 1e-9);
  }
}
