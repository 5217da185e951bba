// SPDX-License-Identifier: MIT
//
// Integers with their limbs inside, against GMP's on the same operands: every size from nothing to
// beyond the limbs kept inside, and the patterns where carries and borrows run longest.
#include "asterism/core/integer.hpp"

#include <gmp.h>

#include <catch2/catch.hpp>
#include <cstdint>
#include <vector>

#include "asterism/core/random.hpp"

using namespace asterism;
using namespace asterism::internal;

namespace {

using sequence = splitmix64;

// An integer of GMP, with GMP's functions alone.
struct reference {
  mpz_t value;
  reference() { mpz_init(value); }
  explicit reference(const integer& x) {
    mpz_init(value);
    mpz_import(value, x.limbs().size(), -1, sizeof(integer::limb), 0, 0, x.limbs().data());
    if (x.sign_value() == sign::negative) mpz_neg(value, value);
  }
  reference(const reference&) = delete;
  reference& operator=(const reference&) = delete;
  ~reference() { mpz_clear(value); }
};

bool same(const integer& x, const reference& r) {
  const reference of_x(x);
  const bool top_is_set = x.is_zero() || x.limbs().back() != 0;
  return top_is_set && mpz_cmp(of_x.value, r.value) == 0 &&
         to_int(x.sign_value()) == mpz_sgn(r.value);
}

integer::limb draw_limb(sequence& random) {
  switch (random.below(5)) {
    case 0:
      return 0;
    case 1:
      return ~integer::limb{0};
    case 2:
      return integer::limb{1} << random.below(64);
    default:
      return random.bits() >> random.below(64);
  }
}

// Makes the integer of limbs by sums and shifts, which are tested this way, too.
integer draw(sequence& random, std::size_t most_limbs) {
  integer x;
  for (std::size_t k = random.below(most_limbs + 1); k-- > 0;) {
    integer next;
    next.set_sum(x, 64, integer(draw_limb(random), false), false);
    x = next;
  }
  if (random.below(2) != 0) x.negate();
  return x;
}

constexpr std::size_t longest = integer::inline_limbs + 15;

// Draws short integers often, as these have code of their own.
integer draw(sequence& random) {
  constexpr std::size_t lengths[] = {1, 2, 3, integer::inline_limbs, longest};
  return draw(random, lengths[random.below(5)]);
}

}  // namespace

TEST_CASE("sums and products of integers are GMP's", "[integer]") {
  sequence random{1};
  for (int round = 0; round < 20000; ++round) {
    const integer a = draw(random), b = random.below(8) == 0 ? a : draw(random);
    const unsigned long shift = random.below(2) != 0 ? 0 : random.below(300);
    const bool subtract = random.below(2) != 0;
    CAPTURE(round, shift, subtract, a.limbs().size(), b.limbs().size());
    integer sum, product;
    sum.set_sum(a, shift, b, subtract);
    product.set_product(a, b);
    const reference ra(a), rb(b);
    reference expected;
    mpz_mul_2exp(expected.value, ra.value, shift);
    (subtract ? mpz_sub : mpz_add)(expected.value, expected.value, rb.value);
    REQUIRE(same(sum, expected));
    mpz_mul(expected.value, ra.value, rb.value);
    REQUIRE(same(product, expected));
  }
}

TEST_CASE("shifts, lengths, quotients, divisors and roots of integers are GMP's", "[integer]") {
  sequence random{2};
  for (int round = 0; round < 10000; ++round) {
    const integer a = draw(random);
    const unsigned long shift = random.below(400);
    CAPTURE(round, shift, a.limbs().size());
    const reference ra(a);
    reference expected;
    integer up = a, down = a;
    up.shift_up(shift);
    mpz_mul_2exp(expected.value, ra.value, shift);
    REQUIRE(same(up, expected));
    down.shift_down(shift);
    mpz_fdiv_q_2exp(expected.value, ra.value, shift);
    REQUIRE(same(down, expected));
    if (a.is_zero()) continue;
    REQUIRE(a.bit_length() == static_cast<long>(mpz_sizeinbase(ra.value, 2)));
    REQUIRE(a.trailing_zeros() == mpz_scan1(ra.value, 0));
    integer size = a;
    if (size.sign_value() == sign::negative) size.negate();
    bool exact = false;
    const integer root = square_root(size, exact);
    const reference rsize(size);
    mpz_sqrt(expected.value, rsize.value);
    REQUIRE(same(root, expected));
    REQUIRE(exact == (mpz_perfect_square_p(rsize.value) != 0));
    integer b = draw(random);
    if (b.is_zero()) b = integer(-7);
    integer product;
    product.set_product(a, b);
    REQUIRE(same(exact_quotient(product, b), ra));
    integer odd_a = a, odd_b = b;
    odd_a.shift_down(a.trailing_zeros());
    odd_b.shift_down(b.trailing_zeros());
    mpz_gcd(expected.value, reference(odd_a).value, reference(odd_b).value);
    REQUIRE(same(greatest_common_divisor_of_odd(odd_a, odd_b), expected));
  }
}

TEST_CASE("copies and moves of integers keep the value, inside and on the heap", "[integer]") {
  sequence random{3};
  integer held;
  for (int round = 0; round < 5000; ++round) {
    integer a = draw(random);
    const reference expected(a);
    integer copy = a;
    REQUIRE(same(copy, expected));
    const integer& itself = copy;
    copy = itself;
    REQUIRE(same(copy, expected));
    const integer moved = std::move(a);
    REQUIRE(same(moved, expected));
    held = moved;  // assigns over an integer that is longer or shorter
    REQUIRE(same(held, expected));
    held = std::move(copy);
    REQUIRE(same(held, expected));
  }
}

TEST_CASE("the ends of the range of short integers", "[integer]") {
  for (const integer::limb m : {integer::limb{1}, ~integer::limb{0}})
    for (const bool negative : {false, true})
      for (const unsigned long shift : {0UL, 1UL, 61UL, 62UL, 63UL, 64UL, 127UL}) {
        const integer a(m, negative), b(~integer::limb{0}, !negative);
        for (const bool subtract : {false, true}) {
          integer sum;
          sum.set_sum(a, shift, b, subtract);
          const reference ra(a), rb(b);
          reference expected;
          mpz_mul_2exp(expected.value, ra.value, shift);
          (subtract ? mpz_sub : mpz_add)(expected.value, expected.value, rb.value);
          CAPTURE(m, negative, shift, subtract);
          CHECK(same(sum, expected));
        }
      }
}
