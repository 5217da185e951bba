// SPDX-License-Identifier: MIT
#include <CGAL/Algebraic_kernel_d_2.h>
#include <CGAL/CORE_BigInt.h>
#include <CGAL/CORE_BigRat.h>

#include <iterator>
#include <utility>
#include <vector>

#include "cgal_rivals.hpp"

namespace asterism::bench {

namespace {

using integer = CORE::BigInt;
using rational = CORE::BigRat;
using algebraic_kernel = CGAL::Algebraic_kernel_d_2<integer>;
using curve = algebraic_kernel::Polynomial_2;
using solution = std::pair<algebraic_kernel::Algebraic_real_2, algebraic_kernel::Multiplicity_type>;

// Returns f_s - offset by its coefficients of x^2, xy, y^2, x, y, 1.
std::array<rational, 6> distance_coefficients(const site& s) {
  const rational a(s.metric.m11), b(s.metric.m12), c(s.metric.m22), x(s.position.x),
      y(s.position.y), two(2);
  const rational to_x = a * x + b * y, to_y = b * x + c * y;
  return {a, two * b, c, -two * to_x, -two * to_y, to_x * x + to_y * y};
}

// Returns f_v - f_w without denominators.
curve bisector(const site& v, const site& w) {
  std::array<rational, 6> difference = distance_coefficients(v);
  const std::array<rational, 6> other = distance_coefficients(w);
  integer denominator = 1;
  for (std::size_t k = 0; k < difference.size(); ++k) {
    difference[k] -= other[k];
    const integer d = CORE::denominator(difference[k]);
    denominator = denominator / CORE::gcd(denominator, d) * d;
  }
  const curve x = CGAL::shift(curve(1), 1, 0), y = CGAL::shift(curve(1), 1, 1);
  const std::array<curve, 6> monomials = {x * x, x * y, y * y, x, y, curve(1)};
  curve sum(0);
  for (std::size_t k = 0; k < monomials.size(); ++k)
    sum = sum + monomials[k] * integer(CORE::numerator(difference[k]) *
                                       (denominator / CORE::denominator(difference[k])));
  return sum;
}

}  // namespace

struct algebraic_rival::content {
  algebraic_kernel kernel;  // the solutions point into this kernel
  curve vw, vx, vy;
  std::vector<solution> solutions;
};

algebraic_rival::algebraic_rival(const edge_question& sites)
    : content_(std::make_unique<content>()) {
  const auto& [v, w, x, y] = sites;
  content_->vw = bisector(v, w);
  content_->vx = bisector(v, x);
  content_->vy = bisector(v, y);
}
algebraic_rival::~algebraic_rival() = default;
algebraic_rival::algebraic_rival(algebraic_rival&&) noexcept = default;

std::size_t algebraic_rival::solve() {
  // Makes a new kernel for each question: a kernel remembers curves, and questions do not repeat.
  content_->solutions.clear();
  content_->kernel = algebraic_kernel();
  content_->kernel.solve_2_object()(content_->vw, content_->vx,
                                    std::back_inserter(content_->solutions));
  return content_->solutions.size();
}

int algebraic_rival::signs() const {
  int packed = 0;
  for (const solution& s : content_->solutions)
    packed = 3 * packed + static_cast<int>(content_->kernel.sign_at_2_object()(
                              CGAL::canonicalize(content_->vy), s.first));
  return packed;
}

}  // namespace asterism::bench
