// SPDX-License-Identifier: MIT
//
// Compares the weights of kernels/work_units.hpp with processor time.
#include "asterism/kernels/work_units.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <ctime>
#include <string>
#include <vector>

#include "asterism/core/random.hpp"
#include "asterism/kernels/filtered_kernel.hpp"

using namespace asterism;
using namespace asterism::internal;

namespace {

metric_tensor random_tensor(splitmix64& random, double condition) {
  const double angle = random.real(0, 3), c = std::cos(angle), s = std::sin(angle);
  const double p = std::pow(condition, random.real()), q = std::pow(condition, random.real());
  return {p * c * c + q * s * s, (p - q) * c * s, p * s * s + q * c * c};
}

struct measured {
  std::string what;
  double counted = 0, taken = 0;  // in units; in tens of microseconds of processor time
};

// Asks edge tests about four neighbouring sites whose tensors have this condition, for some time.
// All four have the same tensor where `equal`.
measured measure(const std::string& what, double condition, bool equal, double jitter) {
  splitmix64 random(11);
  tier_counters counts;
  const filtered_kernel kernel(counts);
  constexpr double enough = 0.1;
  const std::clock_t start = std::clock();
  const auto seconds = [start] {
    return static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
  };
  while (seconds() < enough)
    for (int i = 0; i < 20; ++i) {
      std::vector<site> sites;
      const metric_tensor one = random_tensor(random, condition);
      for (const point& q : {point{0, 0}, point{1, 1}, point{1, 0}, point{0, 1}})
        sites.push_back({{q.x + jitter * random.real(-1, 1), q.y + jitter * random.real(-1, 1)},
                         equal ? one : random_tensor(random, condition)});
      kernel.edge_test(sites[0], sites[1], sites[2], sites[3]);
    }
  return {what, work_units(counts), seconds() * 1e5};
}

}  // namespace

// Weights serve to bound work: a factor of a few is tolerated, and ten is not. Skipped in builds
// that are not optimised, or sanitized. Prints the factors measured.
TEST_CASE("work is counted as it costs, within a factor", "[work_units]") {
#if defined(NDEBUG) && !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)
  const std::vector<measured> all = {
      measure("equal tensors, general places", 1e3, true, 0.3),
      measure("equal tensors, ties", 1, true, 0),
      measure("random tensors to 30", 30, false, 0.3),
      measure("random tensors to 1e4", 1e4, false, 0.3),
      measure("random tensors to 1e12", 1e12, false, 0.3),
      measure("random tensors, places on a lattice", 100, false, 0),
  };
  for (const measured& m : all) {
    const double ratio = m.taken / m.counted;
    INFO(m.what << ": " << m.taken << " taken, " << m.counted << " counted, ratio " << ratio);
    WARN(m.what << ": takes " << ratio << " of what is counted");
    CHECK(ratio < 8);
    CHECK(ratio > 1.0 / 100);
  }
#endif
}
