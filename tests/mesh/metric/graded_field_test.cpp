// SPDX-License-Identifier: MIT
#include "asterism/mesh/metric/graded_field.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <cstdint>
#include <optional>
#include <random>
#include <string>
#include <vector>

#include "asterism/kernels/filtered_kernel.hpp"
#include "asterism/mesh/numerics/metric_algebra.hpp"
#include "fixtures/named_metric.hpp"

using namespace asterism;
using namespace asterism::internal;

namespace {

constexpr bounding_box unit_box{{-1, -1}, {1, 1}};

std::unique_ptr<metric_field> field(const std::string& specification, double size,
                                    const bounding_box& box = unit_box) {
  return testing::named_metric(specification, box, size);
}

graded_metric graded(const std::string& specification, double size, double beta,
                     const bounding_box& box = unit_box) {
  auto done = grade_metric(field(specification, size, box), box, {.beta = beta});
  INFO((done.ok() ? "" : done.failure().message));
  REQUIRE(done.ok());
  return std::move(done).value();
}

// Draws from -1 to 1. The engine gives the same numbers everywhere, and the standard's
// distributions do not.
double uniform(std::mt19937_64& random) {
  return 2 * (static_cast<double>(random() >> 11U) * 0x1p-53) - 1;
}

// Returns the least s with N >= (1 + s d)^-2 M, from the smaller root of det(N - c M) = 0. Uses
// Cramer's rule, which the code under test does not.
double growth_rate(const metric_tensor& m, const metric_tensor& n, double d) {
  const double dm = m.m11 * m.m22 - m.m12 * m.m12, dn = n.m11 * n.m22 - n.m12 * n.m12;
  const double half = (m.m22 * n.m11 - 2 * m.m12 * n.m12 + m.m11 * n.m22) / dm / 2;
  const double c = (dn / dm) / (half + std::sqrt(std::max(half * half - dn / dm, 0.0)));
  return (1 / std::sqrt(c) - 1) / d;
}

// Returns growth rates divided by sigma, ascending, of random pairs of points. Their distances are
// from 1/2 to 3 in the first point's metric.
std::vector<double> measured_rates(const metric_field& subject, double beta, int pairs) {
  std::mt19937_64 random(7);
  std::vector<double> rates;
  for (int i = 0; i < pairs; ++i) {
    const point p{uniform(random), uniform(random)};
    const metric_tensor m = subject.at(p).value();
    const unit_displacements unit = unit_circle(m);
    const double angle = 3.14159 * uniform(random), d = 1.75 + 1.25 * uniform(random);
    const double c = d * std::cos(angle), s = d * std::sin(angle);
    const point q{p.x + c * unit.first.x + s * unit.second.x,
                  p.y + c * unit.first.y + s * unit.second.y};
    if (std::max(std::abs(q.x), std::abs(q.y)) > 1) continue;
    rates.push_back(growth_rate(m, subject.at(q).value(), d) / std::log(beta));
  }
  std::sort(rates.begin(), rates.end());
  return rates;
}

double quantile(const std::vector<double>& sorted, double share) {
  return sorted[static_cast<std::size_t>(share * static_cast<double>(sorted.size() - 1))];
}

}  // namespace

TEST_CASE("a field that changes slowly already is returned itself") {
  for (const std::string name : {"identity", "swirl:24", "sink:24", "layer"}) {
    const double size = name == "layer" ? 1 : 0.03;
    auto original = field(name, size);
    const metric_field* const before = original.get();
    const auto done = grade_metric(std::move(original), unit_box, {.beta = 1.1});
    INFO(name);
    REQUIRE(done.value().field.get() == before);
    REQUIRE(done.value().report.changed == 0);
    REQUIRE(done.value().report.largest_growth == 1);
    REQUIRE(done.value().report.settled);
    REQUIRE(done.value().report.resolved);
  }
}

TEST_CASE("a graded field is Lipschitz in its own lengths") {
  struct example {
    const char* name;
    double size, beta;
  };
  for (const example& e :
       {example{"swirl:24", 0.3, 1.1}, example{"sink:24", 0.3, 1.1}, example{"linear", 1, 1.1},
        example{"polar-2", 2, 1.3}, example{"expr:x+y<0.1?2500:1;0;25", 1, 1.2}}) {
    const graded_metric done = graded(e.name, e.size, e.beta);
    const auto before = measured_rates(*field(e.name, e.size), e.beta, 5000);
    const auto after = measured_rates(*done.field, e.beta, 5000);
    INFO(e.name << ": " << before.back() << " before, " << after.back() << " at most, "
                << quantile(after, 0.998) << " for all but 2 in a thousand");
    REQUIRE(before.back() > 2);
    REQUIRE(quantile(after, 0.998) < 1.25);
    REQUIRE(after.back() < 1.6);
    REQUIRE(done.report.settled);
    REQUIRE(done.report.resolved);
    REQUIRE(done.report.largest_growth > 1);
  }
}

TEST_CASE("a round length grows linearly from its smallest place") {
  const auto done = graded("expr:1/(0.01+sqrt(x*x+y*y))^2;0;1/(0.01+sqrt(x*x+y*y))^2", 1, 1.1);
  // The exact solution: min over p of h(p) + sigma |p - q|.
  for (const point& q : {point{0, 0}, {0.1, 0}, {0.3, 0.4}, {-0.5, 0.7}, {1, -1}}) {
    const double h = 0.01 + std::log(1.1) * std::hypot(q.x, q.y);
    const metric_tensor m = done.field->at(q).value();
    INFO(q.x << ", " << q.y);
    REQUIRE(1 / std::sqrt(m.m11) == Approx(h).epsilon(0.08));
    REQUIRE(m.m22 == Approx(m.m11).epsilon(0.05));
  }
}

TEST_CASE("a graded field is no coarser than the field as given, up to interpolation") {
  for (const std::string name : {"swirl:24", "linear", "polar-2"}) {
    const double size = name == "swirl:24" ? 0.3 : 2;
    const auto given = field(name, size);
    const auto done = graded(name, size, 1.2);
    std::mt19937_64 random(11);
    int length_factor = 0;
    for (int i = 0; i < 3000; ++i) {
      const point q{uniform(random), uniform(random)};
      const metric_tensor m = done.field->at(q).value(), before = given->at(q).value();
      REQUIRE(filtered_kernel().is_positive_definite(m));
      REQUIRE_FALSE(exceeds(before, m, 0.1));
      if (exceeds(before, m, 0.02)) ++length_factor;
    }
    INFO(name);
    REQUIRE(length_factor < 150);
  }
}

TEST_CASE("the same field is graded to the same bits") {
  const auto first = graded("polar-2", 3, 1.2), second = graded("polar-2", 3, 1.2);
  std::mt19937_64 random(3);
  for (int i = 0; i < 2000; ++i) {
    const point q{uniform(random), uniform(random)};
    REQUIRE(identical(first.field->at(q).value(), second.field->at(q).value()));
  }
  REQUIRE(first.report.changed == second.report.changed);
  REQUIRE(first.report.sweeps == second.report.sweeps);
}

TEST_CASE("scaling box and size by a power of two scales the graded field") {
  const auto base = graded("linear", 1, 1.1);
  for (const int exponent : {-200, 200}) {
    const double f = std::ldexp(1.0, exponent);
    const auto scaled = graded("linear", 1, 1.1, {{-f, -f}, {f, f}});
    REQUIRE(scaled.report.changed == base.report.changed);
    const metric_tensor m = base.field->at({0.3, 0.01}).value();
    const metric_tensor s = scaled.field->at({0.3 * f, 0.01 * f}).value();
    REQUIRE(std::ldexp(s.m22, 2 * exponent) == Approx(m.m22).epsilon(1e-9));
  }
  // Grades a field on a box far from the origin, and on a thin box.
  REQUIRE(graded("linear", 1, 1.1, {{1e8, 1e8}, {1e8 + 2, 1e8 + 2}}).report.settled);
  REQUIRE(graded("swirl:24", 0.3, 1.1, {{-1, 0}, {1, 1e-3}}).report.settled);
}

TEST_CASE("a jump is smoothed, and what lies far from it is left alone") {
  const auto given = field("expr:x<0.1?10000:1;0;x<0.1?10000:1", 1);
  const auto done = graded("expr:x<0.1?10000:1;0;x<0.1?10000:1", 1, 1.2);
  for (const point& q : {point{-0.9, 0.3}, {-0.5, -0.77}, {0, 0.123}})
    REQUIRE(identical(done.field->at(q).value(), given->at(q).value()));
  const double h = 1 / std::sqrt(done.field->at({0.6, 0.2}).value().m11);
  REQUIRE(h == Approx(0.01 + std::log(1.2) * 0.5).epsilon(0.1));
}

TEST_CASE("limits that are met are told") {
  const auto few_nodes =
      grade_metric(field("polar-1", 1), unit_box, {.beta = 1.1, .max_nodes = 600});
  REQUIRE_FALSE(few_nodes.value().report.resolved);
  const auto few_sweeps =
      grade_metric(field("swirl:24", 0.3), unit_box, {.beta = 1.1, .max_sweeps = 2});
  REQUIRE_FALSE(few_sweeps.value().report.settled);
  REQUIRE(few_sweeps.value().report.sweeps == 2);
}

TEST_CASE("gradation ends when it is told, and does not ask again") {
  int asked = 0, last = -1;
  gradation_options options;
  options.stop = [&]() -> std::optional<std::string> {
    if (++asked == last) return "enough";
    return std::nullopt;
  };
  REQUIRE(grade_metric(field("swirl:24", 0.3), unit_box, options).ok());
  const int in_all = asked;
  REQUIRE(in_all > 20);
  for (const int when : {1, 2, in_all / 2, in_all}) {
    asked = 0;
    last = when;
    const auto ended = grade_metric(field("swirl:24", 0.3), unit_box, options);
    REQUIRE(ended.failure().message == "gradation was ended before it was done");
    REQUIRE(asked == when);
  }
}

TEST_CASE("gradation refuses what it cannot do") {
  for (const double beta : {1.0, 0.5, -3.0, std::nan(""), HUGE_VAL}) {
    const auto refused = grade_metric(field("identity", 1), unit_box, {.beta = beta});
    REQUIRE_FALSE(refused.ok());
    REQUIRE_THAT(refused.failure().message, Catch::Contains("beta must be above 1"));
  }
  const auto undefined = grade_metric(field("expr:x;0;1", 1), unit_box);
  REQUIRE_THAT(undefined.failure().message, Catch::Contains("everywhere in the domain's box") &&
                                                Catch::Contains("m11 m12 m22 = -1"));
  REQUIRE_FALSE(grade_metric(field("identity", 1), {{1, 1}, {1, 1}}).ok());
}

TEST_CASE("logarithm and exponential are inverse, up to the condition number") {
  std::mt19937_64 random(5);
  for (int i = 0; i < 4000; ++i) {
    const double t = 4 * uniform(random), c = std::cos(t), s = std::sin(t);
    const double condition = std::pow(10, 6 + 6 * uniform(random));
    const int exponent = static_cast<int>(400 * uniform(random));
    const double high = std::ldexp(condition, exponent), low = std::ldexp(1, exponent);
    const metric_tensor m{high * c * c + low * s * s, (high - low) * c * s,
                          high * s * s + low * c * c};
    const metric_tensor back = exponential(logarithm(m));
    INFO("condition " << condition << ", angle " << t);
    REQUIRE_FALSE(exceeds(back, m, condition * 1e-14 + 1e-12));
    REQUIRE_FALSE(exceeds(m, back, condition * 1e-14 + 1e-12));
    REQUIRE(density_ratio(m, m) == 1);
  }
}

TEST_CASE("a tensor between two of very different sizes was not positive definite") {
  std::mt19937_64 random(6);
  for (int i = 0; i < 4000; ++i) {
    const double t = 4 * uniform(random), c = std::cos(t), s = std::sin(t);
    const double high = 350 * uniform(random), low = high - 400 * (1 + uniform(random));
    const metric_tensor made =
        exponential({high * c * c + low * s * s, (high - low) * c * s, high * s * s + low * c * c});
    INFO("logarithms " << high << " and " << low << ", angle " << t);
    REQUIRE(filtered_kernel().is_positive_definite(made));
  }
}

TEST_CASE("an intersection is no coarser than both, and no finer than the finest direction") {
  std::mt19937_64 random(9);
  const auto draw = [&] {
    const double t = 4 * uniform(random), c = std::cos(t), s = std::sin(t);
    const double a = std::pow(10, 3 * uniform(random)), b = std::pow(10, 3 * uniform(random));
    return metric_tensor{a * c * c + b * s * s, (a - b) * c * s, a * s * s + b * c * c};
  };
  const auto largest = [](const metric_tensor& m) {
    return (m.m11 + m.m22) / 2 + std::hypot((m.m11 - m.m22) / 2, m.m12);
  };
  for (int i = 0; i < 4000; ++i) {
    const metric_tensor a = draw(), b = draw(), both = intersection(a, b);
    REQUIRE_FALSE(exceeds(a, both, 1e-6));
    REQUIRE_FALSE(exceeds(b, both, 1e-6));
    REQUIRE(largest(both) <= (1 + 1e-12) * std::max(largest(a), largest(b)));
  }
  const metric_tensor m{4, 1, 3};
  REQUIRE(intersection(m, {1, 0, 1}) == m);
  REQUIRE(intersection({1, 0, 1}, m) == m);
  const metric_tensor across = intersection({100, 0, 1}, {1, 0, 50});
  REQUIRE(across.m11 == 100);
  REQUIRE(across.m22 == Approx(50));
}
