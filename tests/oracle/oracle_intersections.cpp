// SPDX-License-Identifier: MIT
//
// Common points of two bisectors by CGAL's bivariate algebraic kernel.
#include <CGAL/Algebraic_kernel_d_2.h>

#include <array>
#include <iterator>
#include <optional>
#include <utility>
#include <vector>

#include "conic.hpp"
#include "exact_numbers.hpp"
#include "oracle.hpp"
#include "sheared.hpp"

namespace asterism::oracle {
namespace {

using algebraic_kernel_2 = CGAL::Algebraic_kernel_d_2<integer>;
using polynomial_2 = algebraic_kernel_2::Polynomial_2;
using solution =
    std::pair<algebraic_kernel_2::Algebraic_real_2, algebraic_kernel_2::Multiplicity_type>;

// Returns the site in coordinates in which no curves of sites of one abscissa are in a special
// position. There CGAL 5.5's analysis of two curves may not end.
exact_site placed(const site& s) { return sheared(to_exact(s), rational(3, 7)); }

polynomial_2 with_integer_coefficients(const conic& g) {
  const std::array<const rational*, 6> coefficients = {&g.xx, &g.xy, &g.yy,
                                                       &g.x,  &g.y,  &g.constant};
  integer denominator = 1, content = 0;
  for (const rational* c : coefficients) {
    const integer d = CORE::denominator(*c);
    denominator = denominator / CORE::gcd(denominator, d) * d;
  }
  std::array<integer, 6> n;
  for (std::size_t i = 0; i < 6; ++i) {
    n[i] = CORE::numerator(*coefficients[i]) * (denominator / CORE::denominator(*coefficients[i]));
    content = CORE::gcd(content, n[i]);
  }
  if (content != integer(0))
    for (integer& c : n) c /= content;
  const polynomial_2 x = CGAL::shift(polynomial_2(1), 1, 0), y = CGAL::shift(polynomial_2(1), 1, 1);
  return x * x * n[0] + x * y * n[1] + y * y * n[2] + x * n[3] + y * n[4] + polynomial_2(n[5]);
}

// Holds the common part of two curves, which is a constant when they are coprime, and the rest of
// each.
struct factors {
  polynomial_2 common, rest_first, rest_second;
};

factors split_common_factor(const polynomial_2& first, const polynomial_2& second) {
  const polynomial_2 common = CGAL::gcd(first, second);
  return {common, CGAL::integral_division(first, common), CGAL::integral_division(second, common)};
}

int total_degree(const polynomial_2& p) { return CGAL::total_degree(p); }

std::vector<solution> solve(const algebraic_kernel_2& kernel, const polynomial_2& first,
                            const polynomial_2& second) {
  std::vector<solution> solutions;
  kernel.solve_2_object()(first, second, std::back_inserter(solutions));
  return solutions;
}

// CGAL 5.5 evaluates the canonical form of the polynomial, with a positive leading coefficient. Its
// sign may be opposite to p's.
bool is_positive_at(const algebraic_kernel_2& kernel, const polynomial_2& p, const solution& at) {
  const CGAL::Sign canonical = kernel.sign_at_2_object()(CGAL::canonicalize(p), at.first);
  const CGAL::Sign unit = CGAL::sign(CGAL::innermost_leading_coefficient(p));
  return canonical * unit == CGAL::POSITIVE;
}

// Holds the line a X + b Y + c.
struct line {
  rational a, b, c;
  rational at(const basic_point<rational>& p) const { return a * p.x + b * p.y + c; }
};

line as_line(const polynomial_2& p) {
  const auto coefficient = [&p](int in_x, int in_y) {
    const std::array<int, 2> exponents = {in_x, in_y};
    using traits = CGAL::Polynomial_traits_d<polynomial_2>;
    return rational(traits::Get_innermost_coefficient()(
        p, CGAL::Exponent_vector(exponents.begin(), exponents.end())));
  };
  return {coefficient(1, 0), coefficient(0, 1), coefficient(0, 0)};
}

std::optional<basic_point<rational>> meet(const line& l, const line& m) {
  const rational det = l.a * m.b - l.b * m.a;
  if (sign_of(det) == 0) return std::nullopt;
  return basic_point<rational>{(l.b * m.c - l.c * m.b) / det, (l.c * m.a - l.a * m.c) / det};
}

// Returns the open wedge as two lines that are positive inside.
std::array<line, 2> wedge_sides(const exact_site& v, const exact_site& w) {
  const auto side = [](const exact_site& from, const exact_site& to) {
    const rational dx = to.position.x - from.position.x, dy = to.position.y - from.position.y;
    const rational a = from.metric.m11 * dx + from.metric.m12 * dy;
    const rational b = from.metric.m12 * dx + from.metric.m22 * dy;
    return line{a, b, -(a * from.position.x + b * from.position.y)};
  };
  return {side(v, w), side(w, v)};
}

conic as_conic(const line& l) { return {rational(0), rational(0), rational(0), l.a, l.b, l.c}; }

// True if some point of the line is strictly inside both half planes.
bool line_enters(const line& l, const std::array<line, 2>& sides) {
  const rational norm = l.a * l.a + l.b * l.b;
  const basic_point<rational> origin = {-l.c * l.a / norm, -l.c * l.b / norm};
  const basic_point<rational> ahead = {origin.x - l.b, origin.y + l.a};
  std::optional<rational> low, high;
  for (const line& s : sides) {
    const rational start = s.at(origin), slope = s.at(ahead) - start;
    if (sign_of(slope) == 0) {
      if (sign_of(start) <= 0) return false;
      continue;
    }
    const rational root = -start / slope;
    if (sign_of(slope) > 0 && (!low || *low < root)) low = root;
    if (sign_of(slope) < 0 && (!high || root < *high)) high = root;
  }
  return !low || !high || *low < *high;
}

// The bisectors share a line or are the same curve.
int count_with_shared_component(const factors& f, const std::array<line, 2>& sides) {
  // All of Vor{v,w} is shared, and it crosses the segment vw, which is inside the wedge.
  if (total_degree(f.rest_first) == 0) return -1;
  if (line_enters(as_line(f.common), sides)) return -1;
  if (total_degree(f.rest_second) == 0) return 0;
  const auto corner = meet(as_line(f.rest_first), as_line(f.rest_second));
  return corner && sign_of(sides[0].at(*corner)) > 0 && sign_of(sides[1].at(*corner)) > 0 ? 1 : 0;
}

}  // namespace

int voronoi_vertex_count(const site& u, const site& v, const site& w) {
  const exact_site eu = placed(u), ev = placed(v), ew = placed(w);
  const polynomial_2 first = with_integer_coefficients(bisector(eu, ev));
  const polynomial_2 second = with_integer_coefficients(bisector(eu, ew));
  // A common component is a rational line or a whole bisector, and therefore has real points.
  if (total_degree(CGAL::gcd(first, second)) > 0) return -1;
  return static_cast<int>(solve(algebraic_kernel_2(), first, second).size());
}

int arc_intersection_count(const site& v, const site& w, const site& x) {
  const exact_site ev = placed(v), ew = placed(w), ex = placed(x);
  const std::array<line, 2> sides = wedge_sides(ev, ew);
  const factors f = split_common_factor(with_integer_coefficients(bisector(ev, ew)),
                                        with_integer_coefficients(bisector(ev, ex)));
  if (total_degree(f.common) > 0) return count_with_shared_component(f, sides);
  const std::array<polynomial_2, 2> wedge = {with_integer_coefficients(as_conic(sides[0])),
                                             with_integer_coefficients(as_conic(sides[1]))};
  const algebraic_kernel_2 kernel;  // its functions keep pointers to it
  int count = 0;
  for (const solution& s : solve(kernel, f.rest_first, f.rest_second))
    if (is_positive_at(kernel, wedge[0], s) && is_positive_at(kernel, wedge[1], s)) ++count;
  return count;
}

}  // namespace asterism::oracle
