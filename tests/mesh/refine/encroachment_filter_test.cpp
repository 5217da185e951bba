// SPDX-License-Identifier: MIT
#include "asterism/mesh/refine/encroachment_filter.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <cstddef>

#include "asterism/core/random.hpp"
#include "asterism/kernels/exact_kernel.hpp"

using namespace asterism;
using namespace asterism::internal;

namespace {

struct tally {
  std::size_t asked = 0, unknown = 0, wrong = 0, yes = 0;

  void ask(const site& a, const site& b, const site& w) {
    ++asked;
    const uncertain_bool quickly = encroaches_quickly(a, b, w);
    const bool exactly = exact_kernel().encroaches(a, b, w);
    yes += exactly ? 1 : 0;
    if (!quickly.certain())
      ++unknown;
    else if (quickly.value() != exactly)
      ++wrong;
  }
};

metric_tensor random_metric(splitmix64& random, double greatest_ratio) {
  const double angle = 3.2 * random.real(), ratio = std::pow(greatest_ratio, random.real());
  const double c = std::cos(angle), s = std::sin(angle);
  return {c * c + ratio * s * s, (1 - ratio) * c * s, s * s + ratio * c * c};
}

}  // namespace

TEST_CASE("encroachment in doubles: never otherwise than exactly, and mostly known") {
  const std::uint64_t seed = 5;
  CAPTURE(seed);
  splitmix64 random(seed);
  for (const double ratio : {1.0, 3.0, 1e6, 1e12}) {
    tally one_metric, three_metrics;
    for (int i = 0; i < 3000; ++i) {
      const auto somewhere = [&] { return point{random.real(), random.real()}; };
      const metric_tensor common = random_metric(random, ratio);
      const site a{somewhere(), common}, b{somewhere(), common}, w{somewhere(), common};
      one_metric.ask(a, b, w);
      three_metrics.ask({a.position, random_metric(random, ratio)}, b,
                        {w.position, random_metric(random, ratio)});
    }
    CAPTURE(ratio, one_metric.unknown, three_metrics.unknown);
    CHECK(one_metric.wrong + three_metrics.wrong == 0);
    CHECK(one_metric.yes > 100);
    CHECK(one_metric.unknown <= (ratio > 1e9 ? 300 : 10));
    CHECK(three_metrics.unknown < three_metrics.asked / 33);
  }
}

TEST_CASE("encroachment in doubles: a right angle over the subsegment is left to the kernel") {
  const metric_tensor round{1, 0, 1};
  const site a{{0, 0}, round}, b{{2, 0}, round};
  CHECK_FALSE(encroaches_quickly(a, b, {{1, 1}, round}).certain());
  CHECK(encroaches_quickly(a, b, {{1, 1 - 1e-9}, round}).value());
  CHECK_FALSE(encroaches_quickly(a, b, {{1, 1 + 1e-9}, round}).value());
  CHECK_FALSE(encroaches_quickly(a, b, {{1, std::nextafter(1, 0)}, round}).certain());
}

TEST_CASE("encroachment in doubles: nothing is decided near underflow or overflow") {
  for (const double scale : {0x1p-480, 0x1p-530, 0x1p520, 0x1p600}) {
    const metric_tensor round{1, 0, 1};
    const site a{{0, 0}, round}, b{{scale, 0}, round}, w{{scale / 2, scale / 4}, round};
    CAPTURE(scale);
    CHECK_FALSE(encroaches_quickly(a, b, w).certain());
  }
}
