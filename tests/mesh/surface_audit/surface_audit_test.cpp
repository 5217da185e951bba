// SPDX-License-Identifier: MIT
//
// Control nets contain the surface over their triangles, hulls and pairs of triangles bound
// distances, and enclosures contain the known values of flat and round surfaces.
#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <string>

#include "asterism/core/floating_point_environment.hpp"
#include "asterism/core/random.hpp"
#include "asterism/mesh/support/thread_limit.hpp"
#include "asterism/mesh/surface/built_in_surfaces.hpp"
#include "asterism/mesh/surface_audit/deviation.hpp"
#include "asterism/mesh/surface_audit/hull_bounds.hpp"

using namespace asterism;
using namespace asterism::internal;

namespace {

surface known(const char* name) { return *built_in_surface(name); }

// Returns n x n cells of a patch's parameters, mapped to space.
space_mesh lifted_grid(const std::vector<bezier_piece>& pieces, std::uint32_t n) {
  space_mesh m;
  for (const bezier_piece& piece : pieces) {
    const auto first = static_cast<std::uint32_t>(m.points.size());
    for (std::uint32_t i = 0; i <= n; ++i)
      for (std::uint32_t j = 0; j <= n; ++j) {
        const plain_vector p = evaluate(piece, 1.0 * i / n, 1.0 * j / n).at;
        m.points.push_back({p.x, p.y, p.z});
      }
    for (std::uint32_t i = 0; i < n; ++i)
      for (std::uint32_t j = 0; j < n; ++j) {
        const std::uint32_t a = first + i * (n + 1) + j, b = a + n + 1;
        m.triangles.push_back({a, b, b + 1});
        m.triangles.push_back({a, b + 1, a + 1});
      }
  }
  return m;
}

// Returns the greatest distance of sampled points from the triangles, in doubles.
double sampled_from_surface(const std::vector<bezier_piece>& pieces, const space_mesh& m, int n) {
  double most = 0;
  for (const bezier_piece& piece : pieces)
    for (int i = 0; i <= n; ++i)
      for (int j = 0; j <= n; ++j) {
        double least = 1e300;
        for (const space_triangle& t : m.triangles)
          least = std::min(least, nearest_in({m.points[t[0]], m.points[t[1]], m.points[t[2]]},
                                             evaluate(piece, 1.0 * i / n, 1.0 * j / n).at)
                                      .squared_distance);
        most = std::max(most, least);
      }
  return std::sqrt(most);
}

[[gnu::noinline]] bool is_in_hull_box(const bezier_piece& piece, const parameter_triangle& corners,
                                      double a, double b) {
  const triangle_net net = net_over(tensor_of(piece), corners, piece.is_rational);
  const auto points = euclidean(net.points.data(), net.points.size(), piece.is_rational);
  const double c = 1 - a - b;
  const double s = a * corners[0].s.sup() + b * corners[1].s.sup() + c * corners[2].s.sup();
  const double t = a * corners[0].t.sup() + b * corners[1].t.sup() + c * corners[2].t.sup();
  const plain_vector p = evaluate(piece, s, t).at;
  double low = 1e300, high = -1e300;
  // Compares extents in one direction. Both are rounded, by some units in the last place.
  for (const interval_vector& q : points) {
    low = std::min(low, q.x.inf() + 2 * q.y.inf() - 3 * q.z.sup());
    high = std::max(high, q.x.sup() + 2 * q.y.sup() - 3 * q.z.inf());
  }
  const double at = p.x + 2 * p.y - 3 * p.z;
  return low - 1e-12 <= at && at <= high + 1e-12;
}

}  // namespace

TEST_CASE("a net holds the surface over its triangle, and touches it at the corners") {
  splitmix64 random(4401);
  for (const std::string& name : built_in_surface_names()) {
    const auto pieces = bezier_pieces(known(name.c_str()));
    REQUIRE(pieces);
    for (int k = 0; k < 20; ++k) {
      const bezier_piece& piece =
          pieces.value()[static_cast<std::size_t>(k) % pieces.value().size()];
      parameter_triangle corners;
      for (parameter_corner& c : corners)
        c = {rounded_interval(random.real()), rounded_interval(random.real())};
      double a = random.real(), b = random.real();
      if (a + b > 1) a = 1 - a, b = 1 - b;
      INFO(name << " " << k);
      const floating_point_scope scope(rounding::upward);
      CHECK(is_in_hull_box(piece, corners, a, b));
      CHECK(is_in_hull_box(piece, corners, 1, 0));
    }
  }
}

TEST_CASE("a distance is certainly more or not, and never both, in intervals and exactly") {
  splitmix64 random(4402);
  for (int k = 0; k < 300; ++k) {
    const auto number = [&] { return std::floor(random.real() * 9 - 4); };
    const plain_triangle t = {{{number(), number(), number()},
                               {number(), number(), number()},
                               {number(), number(), number()}}};
    const space_point p{number(), number(), number()};
    const double squared = nearest_in(t, plain(p)).squared_distance;
    const exact_vector exact = vector_of<dyadic>(p);
    INFO(k);
    // The numbers are integers and their quotients by areas, so that a part of a millionth decides.
    CHECK(is_farther(exact, dyadic(1), t, dyadic(squared * (1 - 1e-6) - 1e-12)));
    CHECK(!is_farther(exact, dyadic(1), t, dyadic(squared * (1 + 1e-6) + 1e-12)));
    const floating_point_scope scope(rounding::upward);
    CHECK(!is_farther(vector_of<rounded_interval>(p), rounded_interval(1), t,
                      rounded_interval(squared * (1 + 1e-6) + 1e-12)));
    CHECK(std::sqrt(squared_distance_above({vector_of<rounded_interval>(p), 1}, t)) >=
          std::sqrt(squared) - 1e-12);
  }
}

TEST_CASE("enclosures of a plane beside a plane are its distance") {
  surface flat = known("saddle");
  for (control_point& c : flat.patches[0].control) c.at.z = 0.25;
  space_mesh m;
  m.points = {{-1, -1, 0}, {1, -1, 0}, {1, 1, 0}, {-1, 1, 0}};
  m.triangles = {{0, 1, 2}, {0, 2, 3}};
  const auto found = deviation(m, flat);
  REQUIRE(found);
  for (const one_sided_distance& d : {found.value().from_mesh, found.value().from_surface}) {
    CHECK(d.narrowed);
    CHECK(d.low <= 0.25);
    CHECK(d.low >= 0.2475);
    CHECK(d.high >= 0.25);
    CHECK(d.high <= 0.2526);
  }
}

TEST_CASE("enclosures hold what samples find") {
  for (const char* name : {"torus", "saddle", "octant", "wing"}) {
    INFO(name);
    const surface s = known(name);
    const auto pieces = bezier_pieces(s);
    REQUIRE(pieces);
    const space_mesh m = lifted_grid(pieces.value(), 3);
    const auto found = deviation(m, s);
    REQUIRE(found);
    const double sampled = sampled_from_surface(pieces.value(), m, 40);
    const one_sided_distance& d = found.value().from_surface;
    CHECK(d.narrowed);
    CHECK(d.high >= sampled);
    CHECK(d.high <= 1.02 * std::max(d.low, sampled));
    CHECK(found.value().from_mesh.narrowed);
    CHECK(found.value().from_mesh.high <= 1.02 * found.value().from_mesh.low);
  }
}

TEST_CASE("an enclosure is the same for any number of threads") {
  const surface s = known("torus");
  const space_mesh m = lifted_grid(bezier_pieces(s).value(), 4);
  std::vector<double> first;
  for (const std::size_t threads : {1, 2, 7}) {
    const internal::thread_limit limit(threads);
    const deviation_report found = deviation(m, s).value();
    const std::vector<double> now = {found.from_mesh.low, found.from_mesh.high,
                                     found.from_surface.low, found.from_surface.high};
    if (first.empty()) first = now;
    CHECK(now == first);
  }
}

TEST_CASE("what is no surface is refused by name") {
  const auto message = [](const surface& s) {
    const auto pieces = bezier_pieces(s);
    return pieces ? std::string() : pieces.failure().message;
  };
  const auto spoiled = [&](const auto& spoil) {
    surface s = known("octant");
    spoil(s.patches[0]);
    return message(s);
  };
  CHECK(spoiled([](surface_patch&) {}).empty());
  CHECK_THAT(message({}), Catch::Contains("no patch"));
  CHECK_THAT(spoiled([](surface_patch& p) { p.control[4].weight = 0; }),
             Catch::Contains("weight is 0"));
  CHECK_THAT(spoiled([](surface_patch& p) { p.control[4].weight = -1; }),
             Catch::Contains("weight is -1"));
  CHECK_THAT(spoiled([](surface_patch& p) { p.degree_u = 13; }), Catch::Contains("degree 13 in u"));
  CHECK_THAT(spoiled([](surface_patch& p) { p.control[2].at.y = NAN; }),
             Catch::Contains("control point 1, 3"));
  CHECK_THAT(spoiled([](surface_patch& p) { p.control.pop_back(); }), Catch::Contains("lengths"));
  CHECK_THAT(spoiled([](surface_patch& p) {
               p.knots_u = {0, 0, 0, 1, 1};
             }),
             Catch::Contains("5 knots in u"));
  CHECK_THAT(spoiled([](surface_patch& p) { p.knots_u = {0, 0, 1, 0, 1, 1}; }),
             Catch::Contains("below the one before"));
  CHECK_THAT(spoiled([](surface_patch& p) {
               for (control_point& c : p.control) c.at = {1, 2, 3};
             }),
             Catch::Contains("one point"));
}
