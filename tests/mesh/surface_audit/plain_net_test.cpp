// SPDX-License-Identifier: MIT
//
// Control nets in doubles contain the exact net within their bounds, whose number of roundings is
// counted here again. Triangles next to knots are proved like others.
#include "asterism/mesh/surface_audit/plain_net.hpp"

#include <algorithm>
#include <array>
#include <catch2/catch.hpp>
#include <cmath>
#include <limits>
#include <map>
#include <vector>

#include "asterism/core/dyadic.hpp"
#include "asterism/core/floating_point_environment.hpp"
#include "asterism/core/random.hpp"
#include "asterism/mesh/surface_audit/shell_audit.hpp"
#include "asterism/mesh/surface_audit/shell_triangles.hpp"
#include "asterism/mesh/surface_audit/triangle_net.hpp"
#include "asterism/mesh/surface_audit/ways_to_choose.hpp"

using namespace asterism;
using namespace asterism::internal;

namespace {

// Returns the polar form of a Bezier curve, by one step for each argument.
exact_weighted_point polar(std::vector<exact_weighted_point> c,
                           const std::vector<double>& arguments) {
  for (const double x : arguments) {
    for (std::size_t k = 0; k + 1 < c.size(); ++k) c[k] = mixed(c[k], c[k + 1], dyadic(x));
    c.pop_back();
  }
  return c[0];
}

// Returns the list that has each corner as often as the multi-index says.
std::vector<double> repeated(const std::array<double, 3>& at, const std::array<int, 3>& times) {
  std::vector<double> all;
  for (std::size_t k = 0; k < 3; ++k)
    all.insert(all.end(), static_cast<std::size_t>(times[k]), at[k]);
  return all;
}

struct random_patch {
  int p = 0, q = 0;
  std::vector<weighted_point> control;
  std::array<std::array<double, 3>, 2> at{};  // parameters s and t of the corners
  parameter_triangle corners;

  tensor_net tensor() const { return {p, q, control.data()}; }
};

random_patch patch_of(splitmix64& random, int most, double least_weight) {
  random_patch r;
  const auto degree = [&] { return 1 + static_cast<int>(random.real() * most); };
  r.p = degree(), r.q = degree();
  for (int k = 0; k < (r.p + 1) * (r.q + 1); ++k) {
    const double w = std::pow(least_weight, random.real());
    const auto number = [&] { return rounded_interval(w * (2 * random.real() - 1)); };
    r.control.push_back({{number(), number(), number()}, w});
  }
  for (std::size_t k = 0; k < 3; ++k) {
    r.at[0][k] = random.real(), r.at[1][k] = random.real();
    r.corners[k] = {rounded_interval(r.at[0][k]), rounded_interval(r.at[1][k])};
  }
  return r;
}

// Returns the net's point times the number of arrangements of its arguments, exactly.
exact_weighted_point exact_sum(const random_patch& r, const std::array<int, 3>& index) {
  exact_weighted_point sum{{0, 0, 0}, 0};
  for (int i = 0; i <= r.p; ++i)
    for (int j = 0; i + j <= r.p; ++j) {
      const std::array<int, 3> a = {i, j, r.p - i - j},
                               b = {index[0] - a[0], index[1] - a[1], index[2] - a[2]};
      if (*std::min_element(b.begin(), b.end()) < 0) continue;
      std::vector<exact_weighted_point> line;
      for (int m = 0; m <= r.p; ++m) {
        std::vector<exact_weighted_point> row;
        for (int n = 0; n <= r.q; ++n) {
          const weighted_point& c = r.control[static_cast<std::size_t>(m * (r.q + 1) + n)];
          row.push_back({{c.at.x.inf(), c.at.y.inf(), c.at.z.inf()}, c.weight.inf()});
        }
        line.push_back(polar(row, repeated(r.at[1], b)));
      }
      const exact_weighted_point form = polar(line, repeated(r.at[0], a));
      dyadic ways = 1;
      for (std::size_t k = 0; k < 3; ++k) ways = ways * dyadic(ways_to_choose(index[k], a[k]));
      sum = sum + ways * form;
    }
  return sum;
}

bool holds(const rounded_interval& a, const dyadic& times, const dyadic& x) {
  return (x - times * dyadic(a.inf())).sign_value() != sign::negative &&
         (times * dyadic(a.sup()) - x).sign_value() != sign::negative;
}

// A bent patch with one inner knot, and a plane mesh of three triangles with a vertex on the
// patch's side.
struct bent_shell {
  surface of;
  surface_shell shell;
};
bent_shell shell_beside_knot(double knot, double vertex) {
  bent_shell made;
  surface_patch p;
  p.degree_u = 2, p.degree_v = 1, p.count_u = 4, p.count_v = 2;
  p.knots_u = {0, 0, 0, knot, 1, 1, 1}, p.knots_v = {0, 0, 1, 1};
  const std::array<double, 4> x = {0, knot / 2, (1 + knot) / 2, 1}, z = {0, 0.01, 0.01, 0};
  for (std::size_t i = 0; i < 4; ++i)
    for (const double y : {0.0, 1.0}) p.control.push_back({{x[i], y, z[i]}, 1});
  made.of.patches = {p};
  shell_face face;
  const std::array<point, 5> sites = {{{0, 0}, {1, 0}, {1, 1}, {0, 1}, {vertex, 0}}};
  const auto pieces = bezier_pieces(made.of);
  const auto spans = spans_of(pieces.value(), 1);
  for (std::uint32_t k = 0; k < 5; ++k) {
    face.plane.sites.push_back({sites[k], {1, 0, 1}});
    face.vertex.push_back(k);
    const surface_place at = place_in(pieces.value(), spans[0], sites[k].x, sites[k].y);
    const plain_vector q = evaluate(pieces.value()[at.piece], at.s, at.t).at;
    made.shell.points.push_back({q.x, q.y, q.z});
  }
  face.plane.given = 5;
  face.plane.triangles = {{0, 4, 3}, {4, 1, 2}, {4, 2, 3}};
  face.plane.boundary = {{0, 4, 0, 1, false},
                         {4, 1, 1, 1, false},
                         {1, 2, 2, 2, false},
                         {2, 3, 3, 3, false},
                         {3, 0, 4, 4, false}};
  made.shell.faces = {face};
  return made;
}

}  // namespace

TEST_CASE("a net in doubles holds the exact one, and its roundings are no more than counted") {
  splitmix64 random(4411);
  for (const double least_weight : {1.0, 0.5, 1e-12}) {
    for (int k = 0; k < 12; ++k) {
      const random_patch r = patch_of(random, k < 10 ? 3 : 7, least_weight);
      const bool is_rational = least_weight < 1;
      INFO("weights from " << least_weight << ", patch " << k << ", degrees " << r.p << " " << r.q);
      REQUIRE(plain_net_over(r.tensor(), r.corners, is_rational));
      const floating_point_scope scope(rounding::upward);
      const triangle_net net = net_over(r.tensor(), r.corners, is_rational);
      const int n = r.p + r.q;
      const dyadic ways = ways_to_choose(n, r.p);
      for (int i = n; i >= 0; --i)
        for (int j = n - i; j >= 0; --j) {
          const exact_weighted_point exact = exact_sum(r, {i, j, n - i - j});
          const weighted_point& found = net.points[net_index(n, i, j)];
          CHECK(holds(found.at.x, ways, exact.at.x));
          CHECK(holds(found.at.y, ways, exact.at.y));
          CHECK(holds(found.at.z, ways, exact.at.z));
          if (is_rational) CHECK(holds(found.weight, ways, exact.weight));
          // The interval is narrow in proportion to the weight, also where the weight is small.
          CHECK(found.at.x.sup() - found.at.x.inf() <= 1e-13 * found.weight.sup());
        }
    }
  }
  for (int p = 1; p <= most_degree; ++p)
    for (int q = 1; q <= most_degree; ++q) {
      std::map<std::array<int, 2>, int> pairs;
      int most_pairs = 0;
      for (int i = 0; i <= p; ++i)
        for (int j = 0; i + j <= p; ++j)
          for (int a = 0; a <= q; ++a)
            for (int b = 0; a + b <= q; ++b)
              most_pairs = std::max(most_pairs, ++pairs[{i + a, j + b}]);
      const int shares = 3 * p + 3 * q, control = (1 + p) + (1 + q);
      CHECK(shares + control + 1 + most_pairs + 2 <= roundings_of_net(p, q));
    }
}

TEST_CASE("a net in doubles is none where its bound would not hold") {
  splitmix64 random(4412);
  random_patch r = patch_of(random, 3, 0.5);
  r.corners[1].s = rounded_interval(1, 1 + 0x1p-52);
  CHECK(!plain_net_over(r.tensor(), r.corners, true));
  r.corners[1].s = rounded_interval(0.25, 0.5);
  CHECK(!plain_net_over(r.tensor(), r.corners, true));
  r.corners[1].s = 0.5;
  CHECK(plain_net_over(r.tensor(), r.corners, true));
  r.control[1].weight = rounded_interval(0, 1);
  CHECK(!plain_net_over(r.tensor(), r.corners, true));
}

TEST_CASE("vertices next to a knot leave parts that are proved like others") {
  const double knot = 0.3;
  for (const double vertex :
       {knot, std::nextafter(knot, 1.0), std::nextafter(knot, 0.0), knot + 1e-12, knot - 1e-9}) {
    INFO(vertex - knot);
    const bent_shell b = shell_beside_knot(knot, vertex);
    shell_question asked;
    asked.chord = 1, asked.angle_bound = 0;
    const auto report = audit_shell(b.of, b.shell, asked);
    REQUIRE(report);
    CHECK(report.value().findings == std::vector<std::string>{});
    CHECK(report.value().folded == 0);
    // A curve of height 0.01 rises beside its start by at most 0.01 / 0.15 of the distance.
    CHECK(report.value().normal_tangent < 0.1);
  }
}
