// SPDX-License-Identifier: MIT
//
// Defines integers of any size, as a sign and a magnitude of 64-bit limbs. Up to `inline_limbs`
// limbs live inside the object, so that arithmetic of numbers of this size allocates nothing;
// longer ones own an array. Short operands are treated in place, long ones by the functions of
// core/limbs_gmp.hpp or core/limbs_cpp_int.hpp.
//
// Ranges: limited by memory alone. Needs integers only: the floating-point environment is neither
// used nor changed. Errors: std::bad_alloc.
#pragma once

#include <algorithm>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>

#include "asterism/core/sign.hpp"

namespace asterism::internal {

// Work that this thread has done with long integers, in products of two limbs: about half a
// nanosecond each. The work of core/limbs_gmp.hpp grows with the sizes of the numbers, so that one
// question can cost ten thousand times another. It depends on the numbers alone, not on the library
// that multiplies them.
inline constinit thread_local std::uint64_t limb_products_done = 0;

class integer {
 public:
  using limb = std::uint64_t;
  static constexpr unsigned limb_bits = 64;
  // Number of limbs inside the object: norms of an edge test in smooth metrics have up to 23; with
  // 20, one in six allocated memory.
  static constexpr std::size_t inline_limbs = 24;

  integer() = default;
  integer(int value)
      : integer(value < 0 ? limb{0} - static_cast<limb>(value) : static_cast<limb>(value),
                value < 0) {}
  integer(limb magnitude, bool negative) : size_(magnitude != 0), negative_(negative) {
    inline_[0] = magnitude;
  }
  integer(const integer& other) { copy(other); }
  integer(integer&& other) noexcept { take(other); }
  integer& operator=(const integer& other) {
    if (this != &other) copy(other);
    return *this;
  }
  integer& operator=(integer&& other) noexcept {
    if (this == &other) return *this;
    delete[] heap_;
    heap_ = nullptr;
    take(other);
    return *this;
  }
  ~integer() { delete[] heap_; }

  bool is_zero() const { return size_ == 0; }
  sign sign_value() const {
    return size_ == 0 ? sign::zero : negative_ ? sign::negative : sign::positive;
  }
  void negate() { negative_ = !negative_; }
  // Returns the limbs of the magnitude, least significant first; the last one is not zero.
  std::span<const limb> limbs() const { return {data(), size_}; }
  // Returns b with 2^(b-1) <= |value| < 2^b; 0 for 0.
  long bit_length() const {
    return size_ == 0 ? 0
                      : static_cast<long>(size_ * limb_bits) - std::countl_zero(data()[size_ - 1]);
  }
  // Requires a value that is not zero.
  unsigned long trailing_zeros() const {
    std::size_t k = 0;
    while (data()[k] == 0) ++k;
    return k * limb_bits + static_cast<unsigned long>(std::countr_zero(data()[k]));
  }

  // Sets *this to a * b. Requires that neither operand is *this.
  void set_product(const integer& a, const integer& b) {
    negative_ = a.negative_ != b.negative_;
    if (a.size_ <= 1 && b.size_ <= 1)
      set_magnitude(a.size_ * b.size_ == 0 ? 0 : wide{a.data()[0]} * b.data()[0]);
    else
      set_long_product(a, b);
  }

  // Sets *this to a * 2^shift + b, or - b. Requires that neither operand is *this.
  void set_sum(const integer& a, unsigned long shift, const integer& b, bool subtract) {
    // Adds numbers below 2^126, whose sum fits into an __int128.
    if (a.size_ <= 1 && b.size_ <= 1 && shift <= largest_short_shift) {
      const wide left = a.size_ == 0 ? 0 : wide{a.data()[0]} << shift,
                 right = b.size_ == 0 ? 0 : b.data()[0];
      const bool negate_b = b.negative_ != subtract;
      const signed_wide sum =
          (a.negative_ ? -static_cast<signed_wide>(left) : static_cast<signed_wide>(left)) +
          (negate_b ? -static_cast<signed_wide>(right) : static_cast<signed_wide>(right));
      negative_ = sum < 0;
      set_magnitude(sum < 0 ? -static_cast<wide>(sum) : static_cast<wide>(sum));
      return;
    }
    set_long_sum(a, shift, b, subtract);
  }

  // Divides by 2^shift and rounds down.
  void shift_down(unsigned long shift);
  void shift_up(unsigned long shift);
  // Returns a / b. Requires that b divides a and is not zero.
  friend integer exact_quotient(const integer& a, const integer& b);
  // Returns the greatest common divisor, which is positive. Requires odd numbers.
  friend integer greatest_common_divisor_of_odd(const integer& a, const integer& b);
  // Returns the root of a > 0, rounded down; sets `exact` to whether that is the root itself.
  friend integer square_root(const integer& a, bool& exact);

 private:
  __extension__ using wide = unsigned __int128;
  __extension__ using signed_wide = __int128;
  static constexpr unsigned long largest_short_shift = 62;

  const limb* data() const { return heap_ != nullptr ? heap_ : inline_; }
  limb* data() { return heap_ != nullptr ? heap_ : inline_; }
  void set_magnitude(wide magnitude) {
    limb* to = data();
    to[0] = static_cast<limb>(magnitude);
    to[1] = static_cast<limb>(magnitude >> limb_bits);
    size_ = to[1] != 0 ? 2 : to[0] != 0;
  }
  void copy(const integer& other) {
    limb* to = room_for(other.size_);
    const limb* from = other.data();
    for (std::size_t k = 0; k < other.size_; ++k) to[k] = from[k];
    size_ = other.size_;
    negative_ = other.negative_;
  }
  // Requires heap_ == nullptr.
  void take(integer& other) noexcept {
    if (other.heap_ != nullptr) {
      heap_ = std::exchange(other.heap_, nullptr);
      capacity_ = other.capacity_;
    } else {
      for (std::size_t k = 0; k < other.size_; ++k) inline_[k] = other.inline_[k];
    }
    size_ = std::exchange(other.size_, 0);
    negative_ = other.negative_;
  }
  // Returns limbs to be overwritten; their old values are lost if new memory was needed.
  limb* room_for(std::size_t limbs) {
    if (limbs <= inline_limbs) return data();  // an array has more
    return room_on_heap(limbs);
  }
  limb* room_on_heap(std::size_t limbs);
  void trim(std::size_t limbs) {
    const limb* from = data();
    while (limbs > 0 && from[limbs - 1] == 0) --limbs;
    size_ = limbs;
  }
  void set_long_product(const integer& a, const integer& b);
  void set_long_sum(const integer& a, unsigned long shift, const integer& b, bool subtract);

  std::size_t size_ = 0;
  bool negative_ = false;  // of zero: nothing
  limb* heap_ = nullptr;
  std::size_t capacity_ = 0;  // of the heap
  limb inline_[inline_limbs];
};

}  // namespace asterism::internal
