// SPDX-License-Identifier: MIT
//
// Compares the auditor's doubles with error bounds with rationals in every rounding mode, with and
// without flushing; and derives its constants again.
#include "asterism/mesh/audit/number.hpp"

#include <array>
#include <catch2/catch.hpp>
#include <cfenv>
#include <cmath>
#include <cstdint>
#include <vector>

#include "../abuse/caller_environment.hpp"

namespace asterism::internal::audit_detail {
using namespace internal;
namespace {

enum class operation { sum, difference, product, quotient };

struct step {
  operation what;
  std::size_t a, b;  // numbers of earlier values
};

struct random_sequence {
  std::uint64_t state;
  std::uint64_t next() {
    state = state * 6364136223846793005U + 1442695040888963407U;
    return state >> 33;
  }
  std::size_t below(std::size_t n) { return static_cast<std::size_t>(next() % n); }
  // Draws ordinary numbers, adjacent doubles, and sometimes extreme numbers.
  double number() {
    constexpr std::array exponents = {0, 0, 0, -1, 1, -30, 30, -300, 300, -1040, -1074, 500};
    const double fraction = 1 + static_cast<double>(below(3)) * 0x1p-52;
    const double size =
        std::ldexp(below(2) == 0 ? fraction : 1 + static_cast<double>(next()) * 0x1p-31,
                   exponents[below(exponents.size())]);
    return below(2) == 0 ? size : -size;
  }
};

[[gnu::noinline]] void evaluate(const std::vector<double>& given, const std::vector<step>& steps,
                                std::vector<bounded>& values) {
  for (const double x : given) values.emplace_back(x);
  for (const step& s : steps) {
    const bounded a = values[s.a], b = values[s.b];
    values.push_back(s.what == operation::sum          ? a + b
                     : s.what == operation::difference ? a - b
                     : s.what == operation::product    ? a * b
                                                       : a / b);
  }
}

// Returns zero for a division by zero: the bound is infinite then, and the value is not compared.
rational exact_value(const step& s, const std::vector<rational>& values) {
  const rational &a = values[s.a], &b = values[s.b];
  switch (s.what) {
    case operation::sum:
      return a + b;
    case operation::difference:
      return a - b;
    case operation::product:
      return a * b;
    case operation::quotient:
      return b == 0 ? rational(0) : rational(a / b);
  }
  return 0;
}

bool is_finite(const bounded& x) { return std::isfinite(x.value()) && std::isfinite(x.error()); }

}  // namespace

TEST_CASE("the auditor's bounds hold in every rounding mode, flushing or not") {
  const std::uint64_t seed = 71;
  CAPTURE(seed);
  random_sequence random{seed};
  constexpr std::array modes = {FE_TONEAREST, FE_UPWARD, FE_DOWNWARD, FE_TOWARDZERO};
  std::size_t finite = 0, certain = 0;
  for (std::size_t k = 0; k < 3000; ++k) {
    CAPTURE(k);
    std::vector<double> given(4);
    for (double& x : given) x = random.number();
    std::vector<step> steps;
    for (std::size_t i = 0; i < 8; ++i)
      steps.push_back({static_cast<operation>(random.below(4)), random.below(given.size() + i),
                       random.below(given.size() + i)});
    std::vector<bounded> values;
    abuse::set_environment(modes[k % modes.size()], k / modes.size() % 2 == 1);
    evaluate(given, steps, values);
    abuse::set_default_environment();

    std::vector<rational> exact(given.begin(), given.end());
    for (const step& s : steps) exact.push_back(exact_value(s, exact));
    for (std::size_t i = 0; i < values.size(); ++i) {
      if (!is_finite(values[i])) continue;
      ++finite;
      const rational off = abs(exact[i] - rational(values[i].value()));
      CHECK(off <= rational(values[i].error()));
      certain += values[i].certainly_positive() || values[i].certainly_negative();
      if (std::isfinite(values[i].lower())) CHECK(rational(values[i].lower()) <= exact[i]);
      if (std::isfinite(values[i].upper())) CHECK(exact[i] <= rational(values[i].upper()));
    }
  }
  CHECK(finite > 20000);
  CHECK(certain > 10000);
}

TEST_CASE("the auditor's roots hold in every rounding mode, flushing or not") {
  random_sequence random{72};
  constexpr std::array modes = {FE_TONEAREST, FE_UPWARD, FE_DOWNWARD, FE_TOWARDZERO};
  for (std::size_t k = 0; k < 4000; ++k) {
    CAPTURE(k);
    const std::vector<double> given = {random.number(), random.number()};
    std::vector<bounded> values;
    bounded found;
    abuse::set_environment(modes[k % modes.size()], k / modes.size() % 2 == 1);
    evaluate(given, {{static_cast<operation>(k % 3), 0, 1}}, values);
    found = root(values[2]);
    abuse::set_default_environment();
    if (!is_finite(found)) continue;
    const rational of = exact_value({static_cast<operation>(k % 3), 0, 1}, {given[0], given[1]});
    const rational low = rational(found.value()) - rational(found.error()),
                   high = rational(found.value()) + rational(found.error());
    CHECK(high >= 0);
    if (of > 0) CHECK(high * high >= of);
    if (low > 0) CHECK((of > 0 && low * low <= of));
  }
}

TEST_CASE("an overflow rounded to the largest double is not believed") {
  const std::vector<double> given = {0x1p600, 0x1p650, 0.5};
  // 2^1200 - 2^1300 / 2
  const std::vector<step> steps = {{operation::product, 0, 0},
                                   {operation::product, 1, 1},
                                   {operation::product, 4, 2},
                                   {operation::difference, 3, 5}};
  for (const int mode : {FE_TONEAREST, FE_UPWARD, FE_DOWNWARD, FE_TOWARDZERO}) {
    std::vector<bounded> values;
    abuse::set_environment(mode, false);
    evaluate(given, steps, values);
    const bool positive = values.back().certainly_positive();
    const double above = values[3].upper();
    abuse::set_default_environment();
    CHECK_FALSE(positive);
    CHECK(std::isinf(above));
  }
}

// One operation is charged 2^-51 of its result and 2^-1000: twice the rounding of any mode, 2^-52
// of the exact result, and far above what flushing takes. The other half of 2^-51 |value| and the
// factor 1 + 16 2^-51 pay for the roundings of the bound: of its at most 7 operations each takes
// 2^-52 of it.
TEST_CASE("what the auditor charges an operation pays for its bound's own roundings") {
  constexpr double eps = 0x1p-52, charged = 0x1p-51;
  CHECK(charged * (1 - eps) >= eps / (1 - eps));
  CHECK((1 + 16 * charged) * std::pow(1 - eps, 7 + 3) >= 1);
}

}  // namespace asterism::internal::audit_detail
