// SPDX-License-Identifier: MIT
#include "asterism/kernels/root_line.hpp"

#include <utility>

namespace asterism::internal::exact {

namespace {

// Returns the largest multiple of 2^exponent that is not above x.
dyadic round_down(const dyadic& x, long exponent) {
  if (x.exponent() >= exponent || x.is_zero()) return x;
  integer quotient = x.mantissa();
  quotient.shift_down(static_cast<unsigned long>(exponent - x.exponent()));
  return {std::move(quotient), exponent};
}

// Returns a short number strictly between low and high.
dyadic short_number_between(const dyadic& low, const dyadic& high) {
  const dyadic middle = (low + high).scaled(-1);
  dyadic rounded = round_down(middle, (high - low).magnitude() - 3);
  rounded.shorten();
  return rounded;
}

}  // namespace

void root_line::add(const dense_polynomial& p, unsigned tag) {
  if (p.is_zero()) return;
  const std::uint64_t bit = std::uint64_t{1} << tag;
  std::size_t position = 0;
  for (real_root& root : isolate_real_roots(p)) {
    sign order = sign::positive;
    while (position < cuts_.size() &&
           (order = compare(root, cuts_[position].root)) == sign::positive)
      ++position;
    if (position < cuts_.size() && order == sign::zero)
      cuts_[position].vanishing |= bit;
    else
      cuts_.insert(cuts_.begin() + static_cast<std::ptrdiff_t>(position), {std::move(root), bit});
    ++position;
  }
}

std::vector<dyadic> root_line::samples() {
  if (cuts_.empty()) return {dyadic(0)};
  for (std::size_t k = 1; k < cuts_.size(); ++k) {
    real_root &left = cuts_[k - 1].root, &right = cuts_[k].root;
    while (!(left.high() < right.low())) {
      left.refine();
      right.refine();
    }
  }
  std::vector<dyadic> result;
  result.push_back(round_down(cuts_.front().root.low(), 0) - dyadic(1));
  for (std::size_t k = 1; k < cuts_.size(); ++k)
    result.push_back(short_number_between(cuts_[k - 1].root.high(), cuts_[k].root.low()));
  result.push_back(round_down(cuts_.back().root.high(), 0) + dyadic(1));
  for (dyadic& x : result) x.shorten();
  return result;
}

}  // namespace asterism::internal::exact
