// SPDX-License-Identifier: MIT
#include "asterism/core/integer.hpp"

#include <cassert>

#ifdef ASTERISM_EXACT_CPP_INT
#include "asterism/core/limbs_cpp_int.hpp"
#else
#include "asterism/core/limbs_gmp.hpp"
#endif

namespace asterism::internal {
namespace {

// Cost of a function call, in units of products of two limbs.
constexpr std::uint64_t a_call = 40;

// Adds the work of a product of numbers of these lengths, in limbs. Beyond some forty limbs it is
// composed of smaller products, and the work grows as the length to the power 1.6.
void count_product(std::size_t longer, std::size_t shorter) {
  constexpr std::size_t plain = 40;
  const std::size_t rows = shorter <= plain ? shorter : plain + (shorter - plain) / 4;
  limb_products_done += a_call + longer * rows;
}

}  // namespace

integer::limb* integer::room_on_heap(std::size_t limbs) {
  if (heap_ != nullptr && limbs <= capacity_) return heap_;
  const std::size_t wanted = limbs + limbs / 2;
  limb* larger = new limb[wanted];
  delete[] heap_;
  heap_ = larger;
  capacity_ = wanted;
  return heap_;
}

void integer::set_long_product(const integer& a, const integer& b) {
  const integer& longer = a.size_ >= b.size_ ? a : b;
  const integer& shorter = a.size_ >= b.size_ ? b : a;
  const std::size_t n = longer.size_, m = shorter.size_;
  if (m == 0) {
    size_ = 0;
    return;
  }
  count_product(n, m);
  limb* to = room_for(n + m);
  const limb top = limbs::multiply(to, longer.data(), n, shorter.data(), m);
  size_ = n + m - (top == 0);
}

void integer::set_long_sum(const integer& a, unsigned long shift, const integer& b, bool subtract) {
  const bool negate_b = b.negative_ != subtract;
  const std::size_t whole = a.size_ == 0 ? 0 : shift / limb_bits;
  const auto part = static_cast<unsigned>(shift % limb_bits);
  std::size_t n = a.size_ + whole;
  const std::size_t m = b.size_;
  limb_products_done += a_call / 2 + n + m;
  limb* to = room_for(std::max(n + 1, m) + 1);
  std::fill(to, to + whole, limb{0});
  if (part == 0 || a.size_ == 0) {
    std::copy(a.data(), a.data() + a.size_, to + whole);
  } else {
    to[n] = limbs::shift_left(to + whole, a.data(), a.size_, part);
    n += to[n] != 0;
  }
  // Writes |a| 2^shift into n limbs of `to`.
  if (m == 0) {
    negative_ = a.negative_;
    size_ = n;
    return;
  }
  if (n == 0) {
    std::copy(b.data(), b.data() + m, to);
    negative_ = negate_b;
    size_ = m;
    return;
  }
  const limb* other = b.data();
  if (a.negative_ == negate_b) {
    const std::size_t most = std::max(n, m);
    to[most] = n >= m ? limbs::add(to, to, n, other, m) : limbs::add(to, other, m, to, n);
    negative_ = negate_b;
    size_ = most + (to[most] != 0);
    return;
  }
  const bool left_is_less = n != m ? n < m : limbs::is_less(to, other, n);
  if (left_is_less)
    limbs::subtract(to, other, m, to, n);
  else
    limbs::subtract(to, to, n, other, m);
  negative_ = left_is_less ? negate_b : a.negative_;
  trim(std::max(n, m));
}

void integer::shift_up(unsigned long shift) {
  integer result;
  result.set_long_sum(*this, shift, integer(), false);
  *this = std::move(result);
}

void integer::shift_down(unsigned long shift) {
  if (size_ == 0) return;
  // Rounds down: the magnitude of a negative number that loses bits grows to the next multiple.
  const bool away = negative_ && trailing_zeros() < shift;
  const std::size_t whole = shift / limb_bits;
  const auto part = static_cast<unsigned>(shift % limb_bits);
  const std::size_t left = whole < size_ ? size_ - whole : 0;
  limb* at = data();
  if (left > 0 && part != 0)
    limbs::shift_right(at, at + whole, left, part);
  else
    std::copy(at + whole, at + whole + left, at);
  trim(left);
  if (!away) return;
  integer result;
  result.set_sum(*this, 0, integer(1), true);
  if (size_ == 0) result = integer(-1);
  *this = std::move(result);
}

integer exact_quotient(const integer& a, const integer& b) {
  integer quotient;
  if (a.size_ < b.size_) return quotient;  // 0
  const std::size_t n = a.size_, m = b.size_;
  limb_products_done += a_call + 2 * (n - m + 1) * m;
  integer rest;
  integer::limb* to = quotient.room_for(n - m + 1);
  limbs::divide(to, rest.room_for(m), a.data(), n, b.data(), m);
  quotient.trim(n - m + 1);
  quotient.negative_ = a.negative_ != b.negative_;
  return quotient;
}

integer greatest_common_divisor_of_odd(const integer& a, const integer& b) {
  assert(a.trailing_zeros() == 0 && b.trailing_zeros() == 0);
  // Copies both magnitudes, which are overwritten.
  integer longer = a.bit_length() >= b.bit_length() ? a : b,
          shorter = a.bit_length() >= b.bit_length() ? b : a;
  limb_products_done += a_call + 8 * longer.size_ * shorter.size_;
  integer divisor;
  integer::limb* to = divisor.room_for(shorter.size_);
  divisor.size_ = limbs::greatest_common_divisor(to, longer.data(), longer.size_, shorter.data(),
                                                 shorter.size_);
  return divisor;
}

integer square_root(const integer& a, bool& exact) {
  integer root, rest;
  const std::size_t n = a.size_;
  limb_products_done += a_call + 2 * n * n;
  integer::limb* to = root.room_for((n + 1) / 2);
  exact = limbs::square_root(to, rest.room_for(n), a.data(), n);
  root.trim((n + 1) / 2);
  return root;
}

}  // namespace asterism::internal
