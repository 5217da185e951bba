// SPDX-License-Identifier: MIT
//
// The caller's floating-point environment: every rounding mode and flush-to-zero give the same
// answers, and the environment is as it was afterwards.
#include <catch2/catch.hpp>
#include <cfenv>
#include <vector>

#if defined(__SSE2__)
#include <xmmintrin.h>
#endif

#include "asterism/kernels/filtered_kernel.hpp"

using namespace asterism;

namespace {

std::vector<int> all_answers() {
  const filtered_kernel kernel;
  std::vector<int> answers;
  const double tiny = 0x1p-1060;  // a subnormal, which is zero to a processor that flushes
  const site v{{0.1, 0.2}, {2, 0.3, 1}}, w{{0.7, 0.3}, {1, -0.4, 3}}, x{{0.3, 0.9}, {1, 0, 1}},
      y{{0.4, -0.6}, {5, 2, 1}}, near_v{{0.1, 0.2 + 0x1p-54}, {2, 0.3, 1}};
  answers.push_back(to_int(kernel.orientation({0, 0}, {tiny, tiny}, {2 * tiny, tiny})));
  answers.push_back(to_int(kernel.orientation({0.1, 0.1}, {0.7, 0.7}, {0.3, 0.3})));
  answers.push_back(kernel.is_positive_definite({tiny, 0, tiny}));
  answers.push_back(to_int(kernel.compare_distance(v, w, {0.4, 0.25})));
  answers.push_back(kernel.in_wedge(v, w, {0.4, 0.5}));
  answers.push_back(to_int(kernel.dominates(v, near_v, {0.5, 0.5})));
  answers.push_back(kernel.voronoi_vertex_count(v, w, x));
  answers.push_back(kernel.arc_intersection_count(v, w, x));
  answers.push_back(kernel.encroaches(v, w, x));
  answers.push_back(kernel.insertion_test(v, w, x, y));
  answers.push_back(kernel.edge_test(v, w, x, y));
  return answers;
}

}  // namespace

TEST_CASE("rounding modes change no answer and are kept", "[environment]") {
  const auto expected = all_answers();
  CHECK(expected[0] == -1);
  CHECK(expected[2] == 1);
  for (const int mode : {FE_UPWARD, FE_DOWNWARD, FE_TOWARDZERO, FE_TONEAREST}) {
    std::fesetround(mode);
    const auto answers = all_answers();
    const int after = std::fegetround();
    std::fesetround(FE_TONEAREST);
    CHECK(answers == expected);
    CHECK(after == mode);
  }
}

#if defined(__SSE2__)
TEST_CASE("flush-to-zero and denormals-are-zero change no answer and are kept", "[environment]") {
  const auto expected = all_answers();
  const unsigned before = _mm_getcsr();
  const unsigned flushing = before | 0x8040;
  _mm_setcsr(flushing);
  const auto answers = all_answers();
  const unsigned after = _mm_getcsr();
  _mm_setcsr(before);
  CHECK(answers == expected);
  CHECK(after == flushing);
}
#endif
