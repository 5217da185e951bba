// SPDX-License-Identifier: MIT
//
// Compares a batch with single questions: the same answers for every length (whole vectors and
// rests), kind of input and floating-point environment. Columns of different lengths are reported.
#include "asterism/kernels/batch.hpp"

#include <catch2/catch.hpp>
#include <cfenv>
#include <cmath>
#include <cstdint>
#include <limits>
#include <vector>

#include "asterism/core/random.hpp"
#include "asterism/kernels/exact_kernel.hpp"

using namespace asterism;

namespace {

using sequence = internal::splitmix64;

struct site_table {
  std::vector<double> x, y, m11, m12, m22;
  void add(const site& s) {
    x.push_back(s.position.x);
    y.push_back(s.position.y);
    m11.push_back(s.metric.m11);
    m12.push_back(s.metric.m12);
    m22.push_back(s.metric.m22);
  }
  site_columns first(std::size_t n) const {
    const auto cut = [n](const std::vector<double>& c) { return std::span(c).first(n); };
    return {cut(x), cut(y), cut(m11), cut(m12), cut(m22)};
  }
};

enum class kind { smooth, grid, round_grid, round, huge, tiny };
constexpr std::size_t kinds = 6;

site draw(kind which, sequence& random) {
  const double x = random.real(-1, 1), y = random.real(-1, 1);
  const metric_tensor smooth{1 + 12 * x * x, 12 * x * y, 1 + 12 * y * y};
  const point on_grid{1.0 * random.integer(-4, 4), 1.0 * random.integer(-4, 4)};
  switch (which) {
    case kind::grid:
      return {on_grid, {2 + std::abs(on_grid.x), 1, 2}};
    case kind::round_grid:
      return {on_grid, {1, 0, 1}};
    case kind::round:
      return {{x, y}, {3, 1, 2}};
    case kind::huge:
      return {{std::ldexp(x, 900), std::ldexp(y, 900)}, smooth};
    case kind::tiny:
      return {{std::ldexp(x, -1040), std::ldexp(y, -1040)}, smooth};
    default:
      return {{x, y}, smooth};
  }
}

struct questions {
  std::vector<std::array<site, 4>> rows;
  std::array<site_table, 4> tables;

  questions(std::size_t count, std::uint64_t seed) {
    sequence random{seed};
    while (rows.size() < count) {
      const kind which = static_cast<kind>(random.bits() % kinds);
      std::array<site, 4> s;
      for (site& one : s) one = draw(which, random);
      bool distinct = true;
      for (std::size_t i = 0; i < 4; ++i)
        for (std::size_t j = 0; j < i; ++j) distinct = distinct && s[i].position != s[j].position;
      if (!distinct) continue;
      rows.push_back(s);
      for (std::size_t role = 0; role < 4; ++role) tables[role].add(s[role]);
    }
  }
  site_columns sites(std::size_t role, std::size_t n) const { return tables[role].first(n); }
  point_columns points(std::size_t n) const {
    const site_columns third = sites(2, n);
    return {third.x, third.y};
  }
};

void check_against_rows(const questions& all, std::size_t n) {
  tier_counters decided;
  const batch_kernel batch(decided);
  const exact_kernel exact;
  const auto v = all.sites(0, n), w = all.sites(1, n), x = all.sites(2, n), y = all.sites(3, n);
  std::array<std::vector<signed char>, 6> answers;
  for (auto& column : answers) column.assign(n, 77);
  REQUIRE(batch.compare_distance(v, w, all.points(n), answers[0]) == batch_status::ok);
  REQUIRE(batch.in_wedge(v, w, all.points(n), answers[1]) == batch_status::ok);
  REQUIRE(batch.dominates(v, w, all.points(n), answers[2]) == batch_status::ok);
  REQUIRE(batch.edge_test(v, w, x, y, answers[3]) == batch_status::ok);
  REQUIRE(batch.orientation({v.x, v.y}, {w.x, w.y}, {x.x, x.y}, answers[4]) == batch_status::ok);
  REQUIRE(batch.in_circle({v.m11, v.m12, v.m22}, {v.x, v.y}, {w.x, w.y}, {x.x, x.y}, {y.x, y.y},
                          answers[5]) == batch_status::ok);
  for (std::size_t k = 0; k < n; ++k) {
    const auto& s = all.rows[k];
    const point& q = s[2].position;
    INFO("row " << k << " of " << n);
    CHECK(answers[0][k] == to_int(exact.compare_distance(s[0], s[1], q)));
    CHECK(answers[1][k] == static_cast<int>(exact.in_wedge(s[0], s[1], q)));
    CHECK(answers[2][k] == to_int(exact.dominates(s[0], s[1], q)));
    CHECK(answers[3][k] == static_cast<int>(exact.edge_test(s[0], s[1], s[2], s[3])));
    CHECK(answers[4][k] == to_int(exact.orientation(s[0].position, s[1].position, q)));
    CHECK(answers[5][k] ==
          to_int(exact.in_circle(s[0].metric, s[0].position, s[1].position, q, s[3].position)));
  }
  std::uint64_t counted = 0;
  for (const predicate p : {predicate::compare_distance, predicate::in_wedge, predicate::dominates,
                            predicate::edge_test, predicate::orientation, predicate::in_circle})
    for (const tier t : {tier::semi_static, tier::interval, tier::exact})
      counted += decided.at(p, t);
  CHECK(counted == 6 * n);
}

}  // namespace

TEST_CASE("a batch answers as its rows do, whatever its length", "[batch]") {
  const questions all(400, 7);
  for (const std::size_t n : {0, 1, 2, 3, 4, 5, 7, 8, 9, 15, 16, 17, 31, 33, 400})
    check_against_rows(all, n);
}

TEST_CASE("a batch answers the same in every rounding mode", "[batch]") {
  const questions all(64, 8);
  for (const int mode : {FE_UPWARD, FE_DOWNWARD, FE_TOWARDZERO}) {
    std::fesetround(mode);
    check_against_rows(all, 64);
    CHECK(std::fegetround() == mode);
    std::fesetround(FE_TONEAREST);
  }
}

TEST_CASE("clear rows are decided by the first pass alone", "[batch][tiers]") {
  const std::vector<double> zero(9, 0.0), one(9, 1.0), two(9, 2.0), quarter(9, 0.25);
  const site_columns v{zero, zero, one, zero, one}, w{one, zero, two, zero, two};
  std::vector<signed char> answers(9, 77);
  tier_counters decided;
  const batch_kernel kernel(decided);
  REQUIRE(kernel.compare_distance(v, w, {quarter, quarter}, answers) == batch_status::ok);
  CHECK(answers == std::vector<signed char>(9, -1));
  REQUIRE(kernel.dominates(v, w, {quarter, quarter}, answers) == batch_status::ok);
  CHECK(answers == std::vector<signed char>(9, 1));
  REQUIRE(kernel.in_wedge(v, w, {quarter, quarter}, answers) == batch_status::ok);
  CHECK(answers == std::vector<signed char>(9, 1));
  CHECK(decided.at(predicate::compare_distance, tier::semi_static) == 9);
  CHECK(decided.at(predicate::dominates, tier::semi_static) == 9);
  CHECK(decided.at(predicate::in_wedge, tier::semi_static) == 9);
}

TEST_CASE("columns of different lengths are refused and nothing is written", "[batch]") {
  const std::vector<double> three(3, 1.0), two(2, 1.0);
  const site_columns good{three, three, three, three, three};
  const point_columns point{three, three};
  std::vector<signed char> answers(3, 77), short_answers(2, 77);
  const batch_kernel kernel;
  const auto refused = batch_status::length_mismatch;
  const std::vector<site_columns> bad = {{two, three, three, three, three},
                                         {three, two, three, three, three},
                                         {three, three, two, three, three},
                                         {three, three, three, two, three},
                                         {three, three, three, three, two}};
  for (const site_columns& s : bad) {
    CHECK(kernel.compare_distance(s, good, point, answers) == refused);
    CHECK(kernel.compare_distance(good, s, point, answers) == refused);
    CHECK(kernel.in_wedge(s, good, point, answers) == refused);
    CHECK(kernel.dominates(good, s, point, answers) == refused);
    CHECK(kernel.edge_test(s, good, good, good, answers) == refused);
    CHECK(kernel.edge_test(good, good, s, good, answers) == refused);
    CHECK(kernel.edge_test(good, good, good, s, answers) == refused);
  }
  CHECK(kernel.dominates(good, good, {three, two}, answers) == refused);
  CHECK(kernel.in_wedge(good, good, {two, three}, answers) == refused);
  CHECK(kernel.edge_test(good, good, good, good, short_answers) == refused);
  CHECK(kernel.orientation(point, {three, two}, point, answers) == refused);
  CHECK(kernel.in_circle({three, two, three}, point, point, point, point, answers) == refused);
  CHECK(kernel.in_circle({three, three, three}, point, point, point, {two, three}, answers) ==
        refused);
  CHECK(answers == std::vector<signed char>(3, 77));
  CHECK(short_answers == std::vector<signed char>(2, 77));
}
