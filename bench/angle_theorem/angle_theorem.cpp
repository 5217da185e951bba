// SPDX-License-Identifier: MIT
//
// angle_theorem [--quick]
// angle_theorem VARIATION RATIO DEGREES
//
// Proves the table of docs/math/angle-theorem.md and prints it; --quick: its first column in steps
// of two degrees. With three numbers: proves that one claim, exit status 0, or does not, 1.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <numbers>
#include <optional>
#include <string_view>

#include "branch_and_bound.hpp"

namespace {

using namespace asterism::internal::angle_theorem;

constexpr std::array variations = {0.001, 0.005, 0.01,  0.02, 0.03, 0.04,
                                   0.052, 0.058, 0.068, 0.08, 0.1};
constexpr std::array ratios = {1.0, 1.1, 1.2, 1.35, 1.5, 1.7};
constexpr std::int64_t most_boxes = 3'000'000;

struct entry {
  double degrees = 0;
  std::int64_t boxes = 0;  // over all attempts
};

// Returns the greatest multiple of `step` that is proved. Tries downwards from the bound without
// variation.
entry best_angle(double variation, double ratio, double step) {
  entry result;
  const double limit = std::asin(0.5 / ratio) * 180 / std::numbers::pi;
  for (double degrees = std::floor(limit / step) * step; degrees > 0; degrees -= step) {
    const proof_attempt attempt = prove(make_hypotheses(variation, ratio, degrees), most_boxes);
    result.boxes += attempt.boxes;
    if (!attempt.proved) continue;
    result.degrees = degrees;
    break;
  }
  return result;
}

void print_table(bool quick) {
  const std::size_t columns = quick ? 1 : ratios.size();
  std::printf("| sigma R |");
  for (std::size_t k = 0; k < columns; ++k) std::printf(" R/lambda %g |", ratios[k]);
  std::printf("\n|");
  for (std::size_t k = 0; k <= columns; ++k) std::printf(" --- |");
  std::int64_t boxes = 0;
  for (const double variation : variations) {
    std::printf("\n| %g |", variation);
    for (std::size_t k = 0; k < columns; ++k) {
      const entry e = best_angle(variation, ratios[k], quick ? 2 : 0.25);
      boxes += e.boxes;
      std::printf(" %g |", e.degrees);
      std::fflush(stdout);
    }
  }
  std::printf("\n\n%lld boxes judged\n", static_cast<long long>(boxes));
}

int prove_claim(const char* const* numbers) {
  std::array<double, 3> n{};
  for (std::size_t k = 0; k < 3; ++k) {
    char* end = nullptr;
    n[k] = std::strtod(numbers[k], &end);
    if (end == numbers[k] || *end != 0) {
      std::fprintf(stderr, "angle_theorem: '%s' is not a number\n", numbers[k]);
      return 2;
    }
  }
  const auto [variation, ratio, degrees] = n;
  if (!(variation >= 0 && variation < 0.25 && ratio >= 1 && ratio <= 8 && degrees > 0 &&
        degrees <= 60)) {
    std::fprintf(stderr,
                 "angle_theorem: wanted 0 <= sigma R < 0.25, 1 <= R/lambda <= 8, "
                 "0 < degrees <= 60\n");
    return 2;
  }
  const proof_attempt attempt = prove(make_hypotheses(variation, ratio, degrees), 1'000'000'000);
  std::printf("%s: %g degrees at sigma R = %g, R/lambda = %g; %lld boxes judged\n",
              attempt.proved ? "proved" : "not proved", degrees, variation, ratio,
              static_cast<long long>(attempt.boxes));
  return attempt.proved ? 0 : 1;
}

}  // namespace

int main(int count, char** arguments) {
  if (count == 4) return prove_claim(arguments + 1);
  const bool quick = count == 2 && std::string_view(arguments[1]) == "--quick";
  if (count != 1 && !quick) {
    std::fprintf(stderr, "angle_theorem [--quick] | VARIATION RATIO DEGREES\n");
    return 2;
  }
  print_table(quick);
  return 0;
}
