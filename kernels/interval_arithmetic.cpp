// SPDX-License-Identifier: MIT
#include "asterism/kernels/interval_arithmetic.hpp"

#include <cmath>

namespace asterism::internal::certified {

namespace {

constexpr int most_root_boxes = 96;
constexpr int most_segment_boxes = 160;
// Least width, in turn parameter, of boxes that are split: below it the question stays undecided.
constexpr double narrowest_box = 0x1p-24;

// Returns the sum of c_k mu^k lambda^(degree - k).
interval form_value(const std::array<interval, 5>& c, int degree, const parameter_box& box) {
  interval value = c[static_cast<std::size_t>(degree)], power = box.lambda;
  for (int k = degree; k-- > 0;) {
    value = value * box.mu + c[static_cast<std::size_t>(k)] * power;
    if (k > 0) power = power * box.lambda;
  }
  return value;
}

// Returns the derivative along the turn parameter, on a side where lambda = 1 - side * t, mu = t.
interval form_slope(const std::array<interval, 5>& c, int degree, double side,
                    const parameter_box& box) {
  std::array<interval, 5> by_mu, by_lambda;
  by_mu.fill(interval(0));
  by_lambda.fill(interval(0));
  for (int k = 1; k <= degree; ++k)
    by_mu[static_cast<std::size_t>(k - 1)] = interval(k) * c[static_cast<std::size_t>(k)];
  for (int k = 0; k < degree; ++k)
    by_lambda[static_cast<std::size_t>(k)] = interval(degree - k) * c[static_cast<std::size_t>(k)];
  return form_value(by_mu, degree - 1, box) -
         interval(side) * form_value(by_lambda, degree - 1, box);
}

struct isolation {
  const std::array<interval, 5>& c;
  int degree;
  int boxes_left = most_root_boxes;
  std::vector<enclosed_root> roots;

  uncertain_sign sign_at(double t) const { return sign_of(form_value(c, degree, at_turn(t, t))); }

  // Isolates the roots in [low, high], all of one sign of t, both ends of which are certainly not
  // roots. False if undecided.
  bool run(double low, double high, double side) {
    if (--boxes_left < 0) return false;
    const parameter_box box = at_turn(low, high);
    const uncertain_sign value = sign_of(form_value(c, degree, box));
    if (value.certain()) return value.value() != sign::zero;
    const uncertain_sign slope = sign_of(form_slope(c, degree, side, box));
    if (slope.certain() && slope.value() != sign::zero) {
      if (sign_at(low).value() != sign_at(high).value()) keep_root(low, high);
      return true;
    }
    const double middle = split(low, high);
    if (!(middle > low && middle < high) || high - low < narrowest_box) return false;
    return run(low, middle, side) && run(middle, high, side);
  }

  // Returns a point near the middle that is certainly not a root; `low` when there is none.
  double split(double low, double high) const {
    for (const double part : {0.5, 0.4375, 0.59375}) {
      const double t = low + part * (high - low);
      const uncertain_sign s = sign_at(t);
      if (s.certain() && s.value() != sign::zero) return t;
    }
    return low;
  }

  void keep_root(double low, double high) {
    const uncertain_sign left = sign_at(low);
    for (int step = 0; step < 40; ++step) {
      const double t = 0.5 * (low + high);
      const uncertain_sign s = sign_at(t);
      if (!(t > low && t < high) || !s.certain() || s.value() == sign::zero) break;
      (s.value() == left.value() ? low : high) = t;
    }
    roots.push_back({at_turn(low, high)});
  }
};

}  // namespace

std::optional<std::vector<enclosed_root>> isolate(const std::array<interval, 5>& coefficients,
                                                  int degree) {
  while (degree > 0 &&
         sign_of(coefficients[static_cast<std::size_t>(degree)]).certainly(sign::zero))
    --degree;
  if (degree == 0) return std::vector<enclosed_root>{};
  isolation work{coefficients, degree, most_root_boxes, {}};
  // Leaves a root at infinity or at zero undecided: boxes cannot isolate it with certainty.
  for (const double t : {-1.0, 0.0, 1.0}) {
    const uncertain_sign s = work.sign_at(t);
    if (!s.certain() || s.value() == sign::zero) return std::nullopt;
  }
  if (!work.run(-1, 0, -1) || !work.run(0, 1, 1)) return std::nullopt;
  return std::move(work.roots);
}

namespace {

struct segment_search {
  const encroachment_question<interval>& question;
  int boxes_left = most_segment_boxes;

  bool refuted(double low, double high) {
    if (--boxes_left < 0) return false;
    const interval t(low, high);
    const interval lambda = interval(1) - t;
    const uncertain_bool nearer_than_a =
        is_negative(sign_of(evaluate(question.against_a, lambda, t)));
    const uncertain_bool nearer_than_b =
        is_negative(sign_of(evaluate(question.against_b, lambda, t)));
    if ((nearer_than_a & nearer_than_b).certainly(false)) return true;
    if (high - low < narrowest_box) return false;
    const double middle = 0.5 * (low + high);
    return refuted(low, middle) && refuted(middle, high);
  }
};

}  // namespace

uncertain_bool exists(const encroachment_question<interval>& question,
                      std::optional<double> witness) {
  if (witness && std::isfinite(*witness))
    if (question.holds(interval(1), interval(*witness)).certainly(true)) return true;
  if (segment_search{question}.refuted(0, 1)) return false;
  return {};
}

}  // namespace asterism::internal::certified
