// SPDX-License-Identifier: MIT
//
// The laws of the predicates about given points, by the numbers that the predicates' headers give
// them.
#include <algorithm>
#include <array>
#include <cmath>

#include "agreement.hpp"
#include "asterism/core/dyadic.hpp"
#include "asterism/core/plane_algebra.hpp"
#include "asterism/predicates/in_circle.hpp"

namespace asterism::property {
using namespace internal;
namespace {

const exact_kernel exact;

std::array<point, 3> draw_points(random_source& random) {
  const double unit = random.chance(2) ? 1 : 0.1;
  const auto coordinate = [&] { return unit * random.integer(-9, 9); };
  std::array<point, 3> points;
  for (point& p : points) p = {coordinate(), coordinate()};
  return points;
}

template <class Check>
void for_triples(Check check) {
  random_source random(21);
  for (int i = 0; i < 10000; ++i) {
    const auto points = draw_points(random);
    check(points, record("orientation", {}, points));
  }
}

TEST_CASE("orientation, law 1: a cyclic change keeps the sign", "[laws]") {
  for_triples([](const auto& points, const std::string& replay) {
    const auto& [p, q, r] = points;
    expect_equal(exact.orientation(p, q, r), exact.orientation(q, r, p), replay, "turned");
    expect_equal(exact.orientation(p, q, r), exact.orientation(r, p, q), replay, "turned twice");
  });
}

TEST_CASE("orientation, law 2: an exchange of two points negates it", "[laws]") {
  for_triples([](const auto& points, const std::string& replay) {
    const auto& [p, q, r] = points;
    const sign s = exact.orientation(p, q, r);
    expect_equal(-s, exact.orientation(q, p, r), replay, "qpr");
    expect_equal(-s, exact.orientation(p, r, q), replay, "prq");
    expect_equal(-s, exact.orientation(r, q, p), replay, "rqp");
  });
}

TEST_CASE("orientation, law 3: equal points give zero", "[laws]") {
  for_triples([](const auto& points, const std::string& replay) {
    const auto& [p, q, r] = points;
    expect_equal(sign::zero, exact.orientation(p, p, r), replay, "ppr");
    expect_equal(sign::zero, exact.orientation(p, q, p), replay, "pqp");
    expect_equal(sign::zero, exact.orientation(p, q, q), replay, "pqq");
  });
}

// Draws definite, semidefinite and indefinite tensors, and their neighbours.
template <class Check>
void for_tensors(Check check) {
  random_source random(22);
  for (int i = 0; i < 10000; ++i) {
    const double a = random.real(-2, 2), b = random.real(-2, 2);
    const metric_tensor m = random.chance(2) ? metric_tensor{a * a, a * b, b * b}
                                             : metric_tensor{double(random.integer(-2, 9)),
                                                             double(random.integer(-4, 4)),
                                                             double(random.integer(-2, 9))};
    const std::array<point, 2> numbers = {point{m.m11, m.m12}, point{m.m22, 0}};
    check(m, random, record("is_spd", {}, numbers));
  }
}

TEST_CASE("is_positive_definite, law 1: positive factors keep the answer", "[laws]") {
  for_tensors([](const metric_tensor& m, random_source& random, const std::string& replay) {
    const metric_tensor after = scaled({{0, 0}, m}, 0, random.integer(-400, 400)).metric;
    const metric_tensor tripled = {3 * std::round(m.m11), 3 * std::round(m.m12),
                                   3 * std::round(m.m22)};
    const metric_tensor rounded = {std::round(m.m11), std::round(m.m12), std::round(m.m22)};
    expect_equal(exact.is_positive_definite(m), exact.is_positive_definite(after), replay,
                 "power of two");
    expect_equal(exact.is_positive_definite(rounded), exact.is_positive_definite(tripled), replay,
                 "tripled");
  });
}

TEST_CASE("is_positive_definite, law 2: exchanging m11 and m22 keeps it", "[laws]") {
  for_tensors([](const metric_tensor& m, random_source&, const std::string& replay) {
    expect_equal(exact.is_positive_definite(m), exact.is_positive_definite({m.m22, m.m12, m.m11}),
                 replay, "exchanged");
  });
}

TEST_CASE("is_positive_definite, law 3: negating m12 keeps it", "[laws]") {
  for_tensors([](const metric_tensor& m, random_source&, const std::string& replay) {
    expect_equal(exact.is_positive_definite(m), exact.is_positive_definite({m.m11, -m.m12, m.m22}),
                 replay, "negated");
  });
}

template <class Check>
void for_pairs(const char* predicate, Check check) {
  for_each_case(200, [&](const four_sites& sites, random_source& random) {
    const std::array<point, 1> points = {draw_point(sites, random)};
    check(sites[0], sites[1], points[0], record(predicate, {sites.data(), 2}, points));
  });
}

TEST_CASE("compare_distance, law 1: exchanging v and w negates the sign", "[laws]") {
  for_pairs("compare_distance", [](const site& v, const site& w, const point& q,
                                   const std::string& replay) {
    expect_equal(exact.compare_distance(v, w, q), -exact.compare_distance(w, v, q), replay, "wv");
  });
}

TEST_CASE("compare_distance, law 2: a site is nearest to itself", "[laws]") {
  for_pairs("compare_distance", [](const site& v, const site& w, const point&,
                                   const std::string& replay) {
    expect_equal(sign::negative, exact.compare_distance(v, w, v.position), replay, "at v");
    expect_equal(sign::positive, exact.compare_distance(v, w, w.position), replay, "at w");
  });
}

TEST_CASE("compare_distance, law 3: one positive factor keeps the sign", "[laws]") {
  for_pairs("compare_distance", [](const site& v, const site& w, const point& q,
                                   const std::string& replay) {
    for (const int exponent : {-300, 1, 300})
      expect_equal(exact.compare_distance(v, w, q),
                   exact.compare_distance(scaled(v, 0, exponent), scaled(w, 0, exponent), q),
                   replay, "scaled");
  });
}

TEST_CASE("in_wedge, law 1: symmetric in v and w", "[laws]") {
  for_pairs("in_wedge",
            [](const site& v, const site& w, const point& q, const std::string& replay) {
              expect_equal(exact.in_wedge(v, w, q), exact.in_wedge(w, v, q), replay, "wv");
            });
}

// If the midpoint is a double, both differences are the same.
bool exact_midpoint(const point& a, const point& b, point& middle) {
  middle = {(a.x + b.x) / 2, (a.y + b.y) / 2};
  const auto between_exactly = [](double x, double y, double m) {
    return dyadic(x) + dyadic(y) == dyadic(m).scaled(1);
  };
  return between_exactly(a.x, b.x, middle.x) && between_exactly(a.y, b.y, middle.y);
}

TEST_CASE("in_wedge, law 2: the open segment lies inside, its ends do not", "[laws]") {
  int asked = 0;
  for_pairs("in_wedge", [&](const site& v, const site& w, const point&, const std::string& replay) {
    point middle;
    expect(!exact.in_wedge(v, w, v.position) && !exact.in_wedge(v, w, w.position), replay, "ends");
    if (!exact_midpoint(v.position, w.position, middle)) return;
    ++asked;
    expect(exact.in_wedge(v, w, middle), replay, "midpoint");
    if (exact_midpoint(v.position, middle, middle))
      expect(exact.in_wedge(v, w, middle), replay, "quarter point");
  });
  CHECK(asked > 1000);
}

// With A = |p-v|_v^2 - |p-v|_w^2 and C = |w-v|_w^2 the points of the line from v through p on the
// bisector are t = 1 and t = -C / A: p is the first one on the ray, and not a tangency, iff
// A + C > 0.
bool is_seen(const site& from, const site& other, const point& p) {
  const auto v = convert<dyadic>(from), w = convert<dyadic>(other);
  const auto u = between(v.position, convert<dyadic>(p)), d = between(v.position, w.position);
  const dyadic a = squared_length(v.metric, u) - squared_length(w.metric, u);
  return (a + squared_length(w.metric, d)).sign_value() == sign::positive;
}

TEST_CASE("in_wedge, law 3: on the bisector, inside the wedge is visible from both", "[laws]") {
  int inside = 0, outside = 0;
  for_pairs("in_wedge",
            [&](const site& v, const site& w, const point& q, const std::string& replay) {
              for (const point& p : {q, point{0, 0}, point{1, 0}, point{0, 1}}) {
                if (exact.compare_distance(v, w, p) != sign::zero) continue;
                const bool wedged = exact.in_wedge(v, w, p);
                ++(wedged ? inside : outside);
                expect_equal(is_seen(v, w, p) && is_seen(w, v, p), wedged, replay, "wedged");
              }
            });
  CHECK(inside > 30);
  CHECK(outside > 30);
}

TEST_CASE("dominates, law 1: exchanging v and w negates the sign", "[laws]") {
  for_pairs("dominates",
            [](const site& v, const site& w, const point& p, const std::string& replay) {
              expect_equal(exact.dominates(v, w, p), -exact.dominates(w, v, p), replay, "wv");
            });
}

TEST_CASE("dominates, law 2: a site dominates its own position", "[laws]") {
  for_pairs("dominates", [](const site& v, const site& w, const point&, const std::string& replay) {
    expect_equal(sign::positive, exact.dominates(v, w, v.position), replay, "at v");
  });
}

TEST_CASE("dominates, law 3: what a site dominates and is nearer to it dominates on the way",
          "[laws]") {
  int asked = 0;
  for_pairs("dominates",
            [&](const site& v, const site& w, const point& p, const std::string& replay) {
              if (exact.dominates(v, w, p) != sign::positive) return;
              if (exact.compare_distance(v, w, p) != sign::negative) return;
              point nearer = p;
              for (int halvings = 0; halvings < 3; ++halvings) {
                if (!exact_midpoint(v.position, nearer, nearer)) return;
                ++asked;
                expect_equal(sign::positive, exact.dominates(v, w, nearer), replay, "nearer to v");
              }
            });
  CHECK(asked > 1000);
}

TEST_CASE("dominates: a territory was said to be star-shaped about its site", "[laws]") {
  const site v{{0, 0}, {2, -1, 2}}, w{{-1, 0}, {1, 1, 2}};
  CHECK(exact.dominates(v, w, {0, -0.25}) == sign::positive);
  CHECK(exact.dominates(v, w, {0, -1}) == sign::negative);
  CHECK(exact.dominates(v, w, {0, -4}) == sign::positive);
}

// Counts the common points of the closed segment vp and the bisector, from the definition.
int meetings(const site& from, const site& other, const point& p) {
  const auto v = convert<dyadic>(from), w = convert<dyadic>(other);
  const auto u = between(v.position, convert<dyadic>(p)), d = between(v.position, w.position);
  const dyadic a = squared_length(v.metric, u) - squared_length(w.metric, u);
  const dyadic half_b = dot(u, apply(w.metric, d)), c = squared_length(w.metric, d);
  const auto is_negative_number = [](const dyadic& x) { return x.sign_value() == sign::negative; };
  const dyadic at_end = a + half_b + half_b - c;  // the value at t = 0, -c, is negative
  if (at_end.sign_value() == sign::positive) return 1;
  const dyadic discriminant = half_b * half_b + a * c;
  const dyadic past_top = a + half_b;  // the extremum -half_b / a is in (0, 1)
  const bool top_inside =
      is_negative_number(a) && is_negative_number(-half_b) && is_negative_number(past_top);
  if (at_end.is_zero()) return top_inside ? 2 : 1;
  if (!top_inside || is_negative_number(discriminant)) return 0;
  return discriminant.is_zero() ? 1 : 2;
}

TEST_CASE("dominates, law 4: what domination means for the two segments", "[laws]") {
  for_pairs(
      "dominates", [](const site& v, const site& w, const point& p, const std::string& replay) {
        if (exact.dominates(v, w, p) != sign::positive) return;
        const bool nearer = exact.compare_distance(v, w, p) == sign::negative;
        expect((nearer && meetings(v, w, p) == 0) || meetings(w, v, p) == 2, replay, "v dominates");
      });
}

sign in_circle_sign(const metric_tensor& m, const std::array<point, 4>& p) {
  static const filtered_kernel kernel;
  const auto at = [&p](std::size_t i) { return convert<dyadic>(p[i]); };
  const sign expected =
      in_circle(convert<dyadic>(site{{}, m}).metric, at(0), at(1), at(2), at(3)).value();
  CHECK(kernel.in_circle(m, p[0], p[1], p[2], p[3]) == expected);
  CHECK(exact.in_circle(m, p[0], p[1], p[2], p[3]) == expected);
  return expected;
}

template <class Check>
void for_quadruples(Check check) {
  for (const char* name : {"grid", "cocircular", "equal metrics", "small integers"}) {
    random_source random(23);
    for (int i = 0; i < 200; ++i) {
      const four_sites sites = draw(kind_named(name), random);
      std::array<point, 4> points;
      for (std::size_t k = 0; k < 4; ++k) points[k] = sites[k].position;
      check(sites[0].metric, points, record("insertion_test", sites));
    }
  }
}

TEST_CASE("in_circle, law 1: permutations and their parity", "[laws]") {
  for_quadruples([](const metric_tensor& m, const std::array<point, 4>& points,
                    const std::string& replay) {
    const sign s = in_circle_sign(m, points);
    std::array<std::size_t, 4> order = {0, 1, 2, 3};
    do {
      int inversions = 0;
      std::array<point, 4> permuted;
      for (std::size_t i = 0; i < 4; ++i) {
        permuted[i] = points[order[i]];
        for (std::size_t j = 0; j < i; ++j) inversions += order[j] > order[i] ? 1 : 0;
      }
      expect_equal(inversions % 2 == 0 ? s : -s, in_circle_sign(m, permuted), replay, "permuted");
    } while (std::next_permutation(order.begin(), order.end()));
  });
}

TEST_CASE("in_circle, law 2: with the identity, the usual in-circle test", "[laws]") {
  for_quadruples([](const metric_tensor&, const std::array<point, 4>& points,
                    const std::string& replay) {
    // The determinant of rows x, y, x^2 + y^2, 1, expanded in differences to the last point.
    std::array<std::array<dyadic, 3>, 3> row;
    for (std::size_t i = 0; i < 3; ++i) {
      const dyadic x = dyadic(points[i].x) - dyadic(points[3].x),
                   y = dyadic(points[i].y) - dyadic(points[3].y);
      row[i] = {x, y, x * x + y * y};
    }
    const auto minor = [&](std::size_t i, std::size_t j) {
      return row[i][0] * row[j][1] - row[i][1] * row[j][0];
    };
    const dyadic determinant =
        row[0][2] * minor(1, 2) - row[1][2] * minor(0, 2) + row[2][2] * minor(0, 1);
    expect_equal(determinant.sign_value(), in_circle_sign({1, 0, 1}, points), replay, "in_circle");
  });
}

}  // namespace
}  // namespace asterism::property
