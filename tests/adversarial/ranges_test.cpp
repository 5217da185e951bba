// SPDX-License-Identifier: MIT
//
// The ends of the range of doubles, and callers who changed the floating-point environment: no
// overflow, underflow or rounding mode may turn into a certain wrong answer.
#include <array>
#include <cfenv>
#include <cmath>
#include <cstdint>

#if defined(__SSE2__)
#include <xmmintrin.h>
#endif

#include "asterism/tests/oracle/oracle.hpp"
#include "asterism/tests/property/agreement.hpp"

namespace asterism::property {
namespace {

struct answers {
  std::array<int, 8> values{};
};

template <class Kernel>
answers ask_everything(const Kernel& kernel, const four_sites& sites, const point& p) {
  const auto& [v, w, x, y] = sites;
  return {{as_int(kernel.orientation(v.position, w.position, p)),
           as_int(kernel.compare_distance(v, w, p)), as_int(kernel.in_wedge(v, w, p)),
           as_int(kernel.dominates(v, w, p)), as_int(kernel.voronoi_vertex_count(v, w, x)),
           as_int(kernel.arc_intersection_count(v, w, x)), as_int(kernel.encroaches(v, w, x)),
           as_int(kernel.insertion_test(v, w, x, y))}};
}

void expect_same(const answers& expected, const answers& given, const four_sites& sites,
                 const std::string& who) {
  for (std::size_t i = 0; i < expected.values.size(); ++i)
    expect_equal(expected.values[i], given.values[i], record("insertion_test", sites),
                 who + ", question " + std::to_string(i));
}

// Small integers scaled to both ends of the range, where products overflow or vanish.
TEST_CASE("the ends of the range of doubles", "[adversarial]") {
  const exact_kernel exact;
  const filtered_kernel filtered;
  const double_kernel doubles;
  for (const kind& k : kinds()) {
    if (k.name != "small integers" && k.name != "tiny integers" && k.name != "common point" &&
        k.name != "crossing line pairs" && k.name != "cocircular")
      continue;
    random_source random(51);
    for (int i = 0; i < 10; ++i) {
      const four_sites sites = draw(k, random);
      const point p = {double(random.integer(-3, 3)), double(random.integer(-3, 3))};
      const answers expected = ask_everything(exact, sites, p);
      for (const auto& [coordinates, metrics] : {std::array{1000, 0},
                                                 {-1000, 0},
                                                 {0, 1000},
                                                 {0, -1000},
                                                 {1000, 1000},
                                                 {-1060, -1060},
                                                 {1000, -1060},
                                                 {-1060, 1000}}) {
        four_sites moved = sites;
        for (site& s : moved) s = scaled(s, coordinates, metrics);
        const point q = scaled({p, {}}, coordinates, 0).position;
        expect_same(expected, ask_everything(exact, moved, q), moved, "exact, scaled");
        expect_same(expected, ask_everything(filtered, moved, q), moved, "filtered, scaled");
        (void)ask_everything(doubles, moved, q);  // may be wrong, but must return
      }
    }
  }
}

double of_any_exponent(random_source& random, int lowest, int highest) {
  return std::ldexp(random.real(-1, 1), random.integer(lowest, highest));
}

site of_any_size(random_source& random, int exponents) {
  const int e11 = random.integer(-exponents, exponents),
            e22 = random.integer(-exponents, exponents);
  const double off_diagonal = std::ldexp(random.real(-1, 1), (e11 + e22) / 2 - 1);
  return {{of_any_exponent(random, -exponents, exponents),
           of_any_exponent(random, -exponents, exponents)},
          {std::ldexp(random.real(1, 2), e11), off_diagonal, std::ldexp(random.real(1, 2), e22)}};
}

void expect_filtered_is_exact(int exponents, int cases, bool ask_oracle) {
  const exact_kernel exact;
  const filtered_kernel filtered;
  const double_kernel doubles;
  random_source random(52);
  for (int i = 0; i < cases; ++i) {
    four_sites sites;
    for (site& s : sites) s = of_any_size(random, exponents);
    const point p = of_any_size(random, exponents).position;
    const answers expected = ask_everything(exact, sites, p);
    expect_same(expected, ask_everything(filtered, sites, p), sites, "filtered");
    (void)ask_everything(doubles, sites, p);
    if (!ask_oracle) continue;
    const auto& [v, w, x, y] = sites;
    expect_equal(oracle::insertion_test(v, w, x, y), expected.values[7] == 1,
                 record("insertion_test", sites), "exact against the oracle");
    expect_equal(oracle::dominates(v, w, p), to_sign(expected.values[3]),
                 record("dominates", {sites.data(), 2}, std::array{p}), "exact against the oracle");
  }
}

TEST_CASE("numbers of every size mixed", "[adversarial]") {
  expect_filtered_is_exact(20, 60, true);
  expect_filtered_is_exact(200, 5, true);
  expect_filtered_is_exact(200, 20, false);
  expect_filtered_is_exact(1000, 5, false);
}

void expect_unchanged_answers(const char* environment) {
  const exact_kernel exact;
  const filtered_kernel filtered;
  for_each_case(6, [&](const four_sites& sites, random_source& random) {
    const point p = draw_point(sites, random);
    const int mode = std::fegetround();
    const answers given = ask_everything(filtered, sites, p);
    const answers also_given = ask_everything(exact, sites, p);
    CHECK(std::fegetround() == mode);
    std::fesetround(FE_TONEAREST);
    const answers expected = ask_everything(exact, sites, p);
    expect_same(expected, given, sites, std::string("filtered, ") + environment);
    expect_same(expected, also_given, sites, std::string("exact, ") + environment);
    std::fesetround(mode);
  });
}

TEST_CASE("the caller's rounding mode changes no answer and is left alone", "[adversarial]") {
  for (const int mode : {FE_UPWARD, FE_DOWNWARD, FE_TOWARDZERO}) {
    std::fesetround(mode);
    expect_unchanged_answers("directed rounding");
    std::fesetround(FE_TONEAREST);
  }
}

#if defined(__SSE2__)
TEST_CASE("flushing denormals changes no answer and is left alone", "[adversarial]") {
  const exact_kernel exact;
  const filtered_kernel filtered;
  const unsigned normal = _mm_getcsr();
  constexpr unsigned flush_to_zero = 0x8000U, denormals_are_zero = 0x0040U;
  random_source random(53);
  for (int i = 0; i < 60; ++i) {
    four_sites sites = draw(kind_named("small integers"), random);
    const answers expected = ask_everything(exact, sites, {1, 1});
    const int exponent = i % 2 == 0 ? -1065 : -540;
    for (site& s : sites) s = scaled(s, exponent, i % 3 == 0 ? -540 : 0);
    const point p = {std::ldexp(1, exponent), std::ldexp(1, exponent)};
    _mm_setcsr(normal | flush_to_zero | denormals_are_zero);
    const answers given = ask_everything(filtered, sites, p);
    const answers also_given = ask_everything(exact, sites, p);
    const unsigned after = _mm_getcsr();
    _mm_setcsr(normal);
    CHECK((after & (flush_to_zero | denormals_are_zero)) == (flush_to_zero | denormals_are_zero));
    expect_same(expected, given, sites, "filtered, flushing");
    expect_same(expected, also_given, sites, "exact, flushing");
  }
}
#endif

}  // namespace
}  // namespace asterism::property
