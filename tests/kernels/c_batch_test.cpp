// SPDX-License-Identifier: MIT
//
// Compares the C batches with single calls: the same answers and refusals, in every floating-point
// environment.
#include "asterism/kernels/c_batch.h"

#include <array>
#include <catch2/catch.hpp>
#include <cfenv>
#include <cmath>
#include <limits>
#include <vector>

#include "asterism/core/random.hpp"

namespace asterism {
namespace {

constexpr std::size_t width = 20;  // the numbers of four sites
using row = std::array<double, width>;

class rows {
 public:
  explicit rows(std::uint64_t seed) : random_(seed) {}

  // Draws four valid sites. Some values of `oddity` make one invalid.
  row next(std::size_t oddity) {
    row r;
    for (std::size_t s = 0; s < 4; ++s) {
      const double a = between(0.5, 2), b = between(-1, 1), c = between(0.5, 2);
      const std::array<double, 5> site = {between(-1, 1), between(-1, 1), a * a, a * b,
                                          b * b + c * c};
      for (std::size_t i = 0; i < 5; ++i) r[5 * s + i] = site[i];
    }
    spoil(r, oddity);
    return r;
  }

 private:
  double between(double low, double high) { return random_.real(low, high); }

  void spoil(row& r, std::size_t oddity) {
    double* const m = r.data() + 5 * (oddity % 4) + 2;
    const double tiny = std::numeric_limits<double>::denorm_min();
    switch (oddity) {
      case 1:  // a determinant of about zero, of either sign
        m[1] = std::sqrt(m[0] * m[2]) * (1 + 0x1p-52 * std::floor(between(-4, 4)));
        break;
      case 2:
        m[0] = tiny * std::floor(between(0, 3)), m[1] = 0, m[2] = between(0, 1);
        break;
      case 3:
        m[0] = m[2] = 0x1p600, m[1] = 0x1p600 * between(0.9, 1.1);
        break;
      case 4:
        m[0] = -m[0];
        break;
      case 5:
        r[5] = r[0], r[6] = r[1];
        break;
      case 6:
        r[0] = 0, r[1] = tiny, r[10] = -0.0, r[11] = -0.0;
        break;
      case 7:
        r[13] = std::numeric_limits<double>::quiet_NaN();
        break;
      case 8:
        r[16] = std::numeric_limits<double>::infinity();
        break;
      case 9:
        m[0] = m[2] = 0x1p-500, m[1] = 0x1p-501;
        break;
      default:
        break;
    }
  }

  internal::splitmix64 random_;
};

asterism_rows column(const std::vector<row>& table, std::size_t first) {
  return {table[0].data() + first, width};
}

void expect_like_single_calls(const std::vector<row>& table) {
  const std::size_t n = table.size();
  std::vector<signed char> tests(n, 9), circles(n, 9), turns(n, 9);
  asterism_batch_report report, circle_report;
  const asterism_status status =
      asterism_edge_tests(n, column(table, 0), column(table, 5), column(table, 10),
                          column(table, 15), tests.data(), &report);
  const asterism_status of_circles =
      asterism_in_circles(n, column(table, 2), column(table, 0), column(table, 5),
                          column(table, 10), column(table, 15), circles.data(), &circle_report);
  bool refused = false, circle_refused = false;
  for (std::size_t k = 0; k < n; ++k) {
    const double* const r = table[k].data();
    int answer = 0;
    if (!refused) {
      const asterism_status own = asterism_edge_test(r, r + 5, r + 10, r + 15, &answer);
      if (status != ASTERISM_OK && report.failed_row == k) {
        REQUIRE(own == status);
        refused = true;
      } else {
        REQUIRE(own == ASTERISM_OK);
        REQUIRE(int{tests[k]} == (status == ASTERISM_OK ? answer : 9));
      }
    }
    if (!circle_refused) {
      const asterism_status own = asterism_in_circle(r + 2, r, r + 5, r + 10, r + 15, &answer);
      if (of_circles != ASTERISM_OK && circle_report.failed_row == k) {
        REQUIRE(own == of_circles);
        circle_refused = true;
      } else {
        REQUIRE(own == ASTERISM_OK);
        REQUIRE(int{circles[k]} == (of_circles == ASTERISM_OK ? answer : 9));
      }
    }
  }
  REQUIRE(refused == (status != ASTERISM_OK));
  REQUIRE(circle_refused == (of_circles != ASTERISM_OK));
}

}  // namespace

TEST_CASE("a batch answers and refuses what single calls do") {
  rows source(16);
  for (const int mode : {FE_TONEAREST, FE_UPWARD, FE_DOWNWARD, FE_TOWARDZERO})
    for (std::size_t turn = 0; turn < 200; ++turn) {
      std::vector<row> table;
      const std::size_t n = 1 + turn % 7;
      for (std::size_t k = 0; k < n; ++k)
        table.push_back(source.next(k + 1 == n || turn % 3 == 0 ? turn % 11 : 0));
      std::fesetround(mode);
      expect_like_single_calls(table);
      std::fesetround(FE_TONEAREST);
    }
}

TEST_CASE("a batch of one tells which tier decided a single question") {
  const row far = {0, 0, 1, 0, 1, 4, 0, 1, 0, 1, 0, 4, 1, 0, 1, 9, 9, 1, 0, 1};
  signed char answer = 9;
  asterism_batch_report report;
  REQUIRE(asterism_orientations(1, {far.data(), 0}, {far.data() + 5, 0}, {far.data() + 10, 0},
                                &answer, &report) == ASTERISM_OK);
  REQUIRE(answer == 1);
  REQUIRE(report.by_semi_static == 1);
  REQUIRE(report.by_interval + report.by_exact == 0);
}

}  // namespace asterism
