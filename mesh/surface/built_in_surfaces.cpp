// SPDX-License-Identifier: MIT
#include "asterism/mesh/surface/built_in_surfaces.hpp"

#include <array>
#include <cmath>
#include <functional>
#include <utility>

#include "asterism/core/elementary.hpp"
#include "asterism/mesh/surface/teapot.hpp"

namespace asterism::internal {
namespace {

// Control point of a plane rational curve, not multiplied by its weight.
struct plane_control {
  double x, y, weight;
};

// Returns arcs of the unit circle in a row, of equal angle below 180 degrees, as rational
// quadratics: the middle point is where the tangents meet, and its weight is the cosine of half the
// angle.
std::vector<plane_control> circle_arcs(double from, double to, int count) {
  const double half = (to - from) / (2 * count), weight = elementary::cos(half);
  std::vector<plane_control> arcs;
  for (int k = 0; k <= 2 * count; ++k) {
    const double angle = from + k * half, radius = k % 2 == 0 ? 1 : 1 / weight;
    arcs.push_back({radius * elementary::cos(angle), radius * elementary::sin(angle),
                    k % 2 == 0 ? 1 : weight});
  }
  return arcs;
}

std::vector<double> knots_of_arcs(int count) {
  std::vector<double> knots = {0, 0, 0};
  for (int k = 1; k < count; ++k) knots.insert(knots.end(), 2, static_cast<double>(k) / count);
  knots.insert(knots.end(), 3, 1.0);
  return knots;
}

// Returns a quarter of the unit circle, whose tangent and normal at the ends are the axes.
std::vector<plane_control> quarter() { return {{1, 0, 1}, {1, 1, std::sqrt(0.5)}, {0, 1, 1}}; }

surface of_one(std::string name, surface_patch patch) {
  surface s;
  s.name = name;
  patch.name = std::move(name);
  s.patches.push_back(std::move(patch));
  return s;
}

// Turns a profile (distance from the axis, height) about the z axis.
surface_patch turned(const std::vector<plane_control>& around,
                     const std::vector<plane_control>& profile, int arcs) {
  surface_patch p;
  p.degree_u = p.degree_v = 2;
  p.count_u = around.size(), p.count_v = profile.size();
  if (arcs > 1) {
    p.knots_v = knots_of_arcs(arcs);
    p.knots_u = knots_of_arcs(1);
  }
  for (const plane_control& a : around)
    for (const plane_control& b : profile)
      p.control.push_back({{a.x * b.x, a.y * b.x, b.y}, a.weight * b.weight});
  return p;
}

surface torus() {
  constexpr double tube = 0.3, share = 0.98;
  constexpr int arcs = 4;
  constexpr double pi = 3.14159265358979323846;
  std::vector<plane_control> profile = circle_arcs(-share * pi, share * pi, arcs);
  for (plane_control& c : profile) c = {1 + tube * c.x, tube * c.y, c.weight};
  return of_one("torus", turned(quarter(), profile, arcs));
}

surface octant() {
  std::vector<plane_control> profile = quarter();
  return of_one("octant", turned(quarter(), profile, 1));
}

surface saddle() {
  constexpr std::array<double, 3> linear = {-1, 0, 1}, square = {1, -1, 1};
  surface_patch p;
  p.degree_u = p.degree_v = 2;
  p.count_u = p.count_v = 3;
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 3; ++j)
      p.control.push_back({{linear[i], linear[j], (square[i] - square[j]) / 2}, 1});
  return of_one("saddle", std::move(p));
}

using polynomial_rows = std::vector<std::vector<double>>;  // c[a][b] of u^a v^b

double choose(std::size_t n, std::size_t k) {
  double c = 1;
  for (std::size_t i = 1; i <= k; ++i)
    c = c * static_cast<double>(n - k + i) / static_cast<double>(i);
  return c;
}

// Returns the Bernstein coefficients of polynomials in powers of u and v: u^a of degree n has C(i,
// a) / C(n, a).
std::vector<std::vector<double>> bernstein(const polynomial_rows& c, std::size_t n, std::size_t m) {
  std::vector<std::vector<double>> out(n + 1, std::vector<double>(m + 1, 0));
  for (std::size_t i = 0; i <= n; ++i)
    for (std::size_t j = 0; j <= m; ++j)
      for (std::size_t a = 0; a <= i && a < c.size(); ++a)
        for (std::size_t b = 0; b <= j && b < c[a].size(); ++b)
          out[i][j] += c[a][b] * choose(i, a) / choose(n, a) * choose(j, b) / choose(m, b);
  return out;
}

polynomial_rows tensor(const std::vector<double>& in_u, const std::vector<double>& in_v) {
  polynomial_rows rows;
  for (const double a : in_u) {
    rows.emplace_back();
    for (const double b : in_v) rows.back().push_back(a * b);
  }
  return rows;
}

void add(polynomial_rows& to, const polynomial_rows& from, double factor) {
  if (to.size() < from.size()) to.resize(from.size());
  for (std::size_t a = 0; a < from.size(); ++a) {
    if (to[a].size() < from[a].size()) to[a].resize(from[a].size(), 0);
    for (std::size_t b = 0; b < from[a].size(); ++b) to[a][b] += factor * from[a][b];
  }
}

std::vector<double> product(const std::vector<double>& a, const std::vector<double>& b) {
  std::vector<double> c(a.size() + b.size() - 1, 0);
  for (std::size_t i = 0; i < a.size(); ++i)
    for (std::size_t j = 0; j < b.size(); ++j) c[i + j] += a[i] * b[j];
  return c;
}

// Makes the wing: u is the root of the share of the chord, so that the nose is a polynomial; v the
// share of the span. The chord falls to 0.4, the wing is swept by 0.5 and turned by an angle w = v
// / 10, whose sine and cosine are taken as w - w^3 / 6 and 1 - w^2 / 2. Source of the section:
// Jacobs, Ward, Pinkerton, NACA report 460, 1933, with the last coefficient that closes the
// trailing edge.
surface wing() {
  const std::vector<double> chord = {1, -0.6}, sweep = {0, 0.5}, sine = {0, 0.1, 0, -1e-3 / 6},
                            cosine = {1, 0, -0.005};
  const std::vector<double> square = {0, 0, 1}, one = {1};
  std::vector<double> thickness = {0, 0.2969, -0.126, 0, -0.3516, 0, 0.2843, 0, -0.1036};
  for (double& c : thickness) c *= 0.6;
  polynomial_rows x, y, z;
  add(x, tensor(square, product(chord, cosine)), 1);
  add(x, tensor(one, product(sweep, cosine)), 1);
  add(x, tensor(thickness, product(chord, sine)), 1);
  add(y, tensor(thickness, product(chord, cosine)), 1);
  add(y, tensor(square, product(chord, sine)), -1);
  add(y, tensor(one, product(sweep, sine)), -1);
  add(z, tensor(one, {0, 2}), 1);
  surface_patch p;
  p.degree_u = 8, p.degree_v = 4;
  p.count_u = 9, p.count_v = 5;
  const auto bx = bernstein(x, 8, 4), by = bernstein(y, 8, 4), bz = bernstein(z, 8, 4);
  for (std::size_t i = 0; i < p.count_u; ++i)
    for (std::size_t j = 0; j < p.count_v; ++j)
      p.control.push_back({{bx[i][j], by[i][j], bz[i][j]}, 1});
  return of_one("wing", std::move(p));
}

using maker = std::pair<const char*, surface (*)()>;
constexpr std::array<maker, 5> makers = {{{"torus", torus},
                                          {"wing", wing},
                                          {"teapot", teapot_surface},
                                          {"saddle", saddle},
                                          {"octant", octant}}};

}  // namespace

std::optional<surface> built_in_surface(std::string_view name) {
  for (const auto& [known, make] : makers)
    if (name == known) return make();
  return std::nullopt;
}

std::vector<std::string> built_in_surface_names() {
  std::vector<std::string> names;
  for (const auto& [name, make] : makers) names.emplace_back(name);
  return names;
}

}  // namespace asterism::internal
