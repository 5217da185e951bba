// SPDX-License-Identifier: MIT
//
// Compares the bound of a field's variation with formulas whose variation is known, and with the
// definition: lengths at pairs of points.
#include "asterism/mesh/metric/variation_bound.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>
#include <random>
#include <string>
#include <tuple>

#include "asterism/core/floating_point_environment.hpp"
#include "asterism/core/random.hpp"
#include "asterism/mesh/metric/expression_enclosure.hpp"
#include "asterism/mesh/metric/graded_field.hpp"
#include "asterism/mesh/metric/interpolated_field.hpp"
#include "asterism/mesh/metric/plane_expression.hpp"
#include "asterism/mesh/metric/tensor_variation.hpp"
#include "asterism/mesh/numerics/mesh_statistics.hpp"
#include "asterism/mesh/numerics/metric_length.hpp"
#include "fixtures/domain_kinds.hpp"
#include "fixtures/named_metric.hpp"

using namespace asterism;
using namespace asterism::internal;

namespace {

domain box(double low_x, double low_y, double high_x, double high_y) {
  return testing::accepted(testing::polygon(testing::box_ring(low_x, low_y, high_x, high_y)));
}

std::unique_ptr<metric_field> field(const std::string& spec, const domain& d, double size) {
  return testing::named_metric(spec, d.box(), size);
}

double bound_of(const std::string& spec, const domain& d, double size) {
  const variation_bounds found = bound_variation(d, *field(spec, d, size));
  INFO(spec << ": " << found.obstacle);
  REQUIRE(found.above);
  CHECK(found.seen <= *found.above);
  return *found.above;
}

// Returns the greatest (1 - 1 / tau) / d of random pairs of points in a box, near and far: the
// definition of H1. The seed and the number of a pair replay it.
double steepest_pair(const metric_field& f, const bounding_box& b, std::uint64_t seed) {
  std::mt19937_64 random(seed);
  const auto part = [&] { return unit_fraction(random()); };
  double steepest = 0;
  for (int i = 0; i < 4000; ++i) {
    const point p{b.low.x + (b.high.x - b.low.x) * part(), b.low.y + (b.high.y - b.low.y) * part()};
    const double reach = std::ldexp(1.0, -static_cast<int>(random() % 12));
    const point q{std::clamp(p.x + reach * (2 * part() - 1), b.low.x, b.high.x),
                  std::clamp(p.y + reach * (2 * part() - 1), b.low.y, b.high.y)};
    if (p == q) continue;
    const site at_p{p, f.at(p).value()}, at_q{q, f.at(q).value()};
    steepest = std::max(steepest, variation(at_p, at_q));
  }
  return steepest;
}

// Adds two triangles for each of n by n cells, whose vertices exist row by row.
void add_grid_triangles(mesh& m, vertex_index n) {
  for (vertex_index j = 0; j < n; ++j)
    for (vertex_index i = 0; i < n; ++i) {
      const vertex_index v = j * (n + 1) + i;
      m.triangles.push_back({v, v + 1, v + n + 2});
      m.triangles.push_back({v, v + n + 2, v + n + 1});
    }
}

}  // namespace

TEST_CASE("how fast a field varies is what its formula says, where that is known by hand") {
  const domain unit = box(0, 0, 1, 1), wide = box(0, 0, 4, 1);
  CHECK(bound_of("identity", unit, 0.1) == 0);
  // The length wanted across the layer grows by H1 - H0 per unit of length, and so does the scale
  // of the metric.
  CHECK(bound_of("layer:0.3,1", unit, 0.3) == Approx(0.21).epsilon(0.02));
  CHECK(bound_of("layer:0.3,1", wide, 0.3) == Approx(0.21 / 4).epsilon(0.02));
  CHECK(bound_of("linear", unit, 1) == Approx(0.198).epsilon(0.02));
  // The round metric e^(2 x) varies by e^(-x) per unit of its length, most at x = 0.
  CHECK(bound_of("expr:exp(2*x);0;exp(2*x)", unit, 0.5) == Approx(0.5).epsilon(0.02));
  // The hyperbolic metric 1 / x^2 of a half-plane varies by 1 everywhere.
  CHECK(bound_of("expr:x^-2;0;x^-2", box(1, 0, 9, 2), 0.25) == Approx(0.25).epsilon(0.02));
}

TEST_CASE("no two points of a formula are farther apart in their metrics than the bound says") {
  const domain d = box(-1, -1, 1, 1);
  for (const std::string spec :
       {"sink:1", "swirl:3", "sink:12", "shock:9", "linear", "layer:0.1,0.4",
        "expr:4+3*sin(3*x);0;4+3*cos(3*y)", "expr:1+8*exp(-4*(x-y)^2);0;1",
        "expr:2+tanh(5*x);0.5*abs(y);1+max(x,y)^2", "expr:1+max(sqrt((x-0.3)*(x-0.3)+y*y),0.4);0;1",
        "expr:1+sqrt(1+x*x*y*y);sin(x)/4;2-cos(x-y)"}) {
    CAPTURE(spec);
    const double bound = bound_of(spec, d, 0.3),
                 pairs = steepest_pair(*field(spec, d, 0.3), d.box(), 42);
    CAPTURE(bound, pairs);
    CHECK(pairs <= bound * (1 + 1e-9));
    CHECK(pairs > 0.5 * bound);
  }
}

TEST_CASE("layers that turn are bounded tightly, also around the centre of their circles") {
  const domain d = box(-1, -1, 1, 1);
  for (const std::string spec :
       {"shock:3", "shock:9", "shock:50", "polar-1", "polar-2", "circle-1"}) {
    CAPTURE(spec);
    const auto given = field(spec, d, 0.3);
    const variation_bounds found = bound_variation(d, *given);
    INFO(found.obstacle);
    REQUIRE(found.above);
    CAPTURE(*found.above, found.seen);
    CHECK(*found.above <= 1.03 * found.seen);
    CHECK(steepest_pair(*given, d.box(), 44) <= *found.above * (1 + 1e-9));
    // Takes pairs near the corner that is the centre of polar-1 and polar-2.
    CHECK(steepest_pair(*given, {{-1, -1}, {-0.99, -0.99}}, 45) <= *found.above * (1 + 1e-9));
  }
  // Lengths across circles are least on this one, and the metric varies most there, since its
  // direction turns.
  for (const auto& [spec, centre, radius] :
       {std::tuple("polar-1", point{-1, -1}, 1.0), std::tuple("circle-1", point{-2, 0}, 2.0)}) {
    CAPTURE(spec);
    const auto given = field(spec, d, 0.3);
    double steepest = 0;
    for (int i = 0; i < 200; ++i) {
      const auto at = [&](double angle) {
        const point q{centre.x + radius * std::cos(angle), centre.y + radius * std::sin(angle)};
        return site{q, given->at(q).value()};
      };
      const double angle = 0.1 + 0.002 * i;
      steepest = std::max(steepest, variation(at(angle), at(angle + 1e-6)));
    }
    const double bound = bound_of(spec, d, 0.3);
    CAPTURE(steepest, bound);
    CHECK(steepest <= bound);
    CHECK(steepest > 0.9 * bound);
  }
}

TEST_CASE("a box whose middle is no double is bounded up to its ends") {
  // The middle of the box from 1 + u to 1 + 4 u is rounded to 1 + 2 u, twice as far from the right
  // end as from the left. The metric is 1 - k (x - 1) there, and varies most at that end.
  constexpr double u = 0x1p-52, k = 0x1p42;
  const double most = k / 2 / std::pow(1 - 4 * u * k, 1.5);
  CHECK(bound_of("expr:1-2^42*(x-1);0;1", box(1 + u, 0, 1 + 4 * u, 1), 1) >= most);
}

TEST_CASE("a graded field is bounded by the triangles of its grid") {
  const domain d = box(-1, -1, 1, 1);
  for (const auto& [spec, beta] :
       {std::pair("expr:x+y>0.7?16:1;0;x+y>0.7?16:1", 1.1),
        std::pair("expr:x+y>0.7?16:1;0;x+y>0.7?16:1", 1.5), std::pair("swirl:3", 1.2),
        std::pair("expr:1+8*exp(-4*(x-y)^2);0;1", 1.3),
        std::pair("expr:x>0.1?25:1;0;1+y^2", 1.2)}) {
    CAPTURE(spec, beta);
    gradation_options options;
    options.beta = beta;
    const auto graded = grade_metric(field(spec, d, 0.4), d.box(), options);
    REQUIRE(graded.ok());
    CHECK(graded.value().report.changed > 0);
    const metric_field& f = *graded.value().field;
    const variation_bounds found = bound_variation(d, f);
    INFO(found.obstacle);
    REQUIRE(found.above);
    CAPTURE(*found.above, found.seen);
    CHECK(*found.above <= 1.8 * found.seen);
    const double pairs = steepest_pair(f, d.box(), 46);
    CAPTURE(pairs);
    CHECK(pairs <= *found.above * (1 + 1e-9));
    CHECK(pairs > 0.3 * *found.above);
  }
}

TEST_CASE("a field on a mesh is bounded in each triangle") {
  mesh m;
  std::mt19937_64 random(7);
  const auto part = [&] { return unit_fraction(random()); };
  constexpr vertex_index n = 4;
  for (vertex_index j = 0; j <= n; ++j)
    for (vertex_index i = 0; i <= n; ++i) {
      const double angle = 3 * part(), wide = 1 + 20 * part(), c = std::cos(angle),
                   s = std::sin(angle);
      m.sites.push_back(
          {{i / 4.0, j / 4.0}, {wide * c * c + s * s, (wide - 1) * c * s, wide * s * s + c * c}});
    }
  add_grid_triangles(m, n);
  const auto given = make_interpolated_field(m, 0.2);
  const domain d = box(0, 0, 1, 1);
  const variation_bounds found = bound_variation(d, *given);
  REQUIRE(found.above);
  const double pairs = steepest_pair(*given, d.box(), 43);
  CAPTURE(*found.above, found.seen, pairs);
  CHECK(pairs <= *found.above * (1 + 1e-9));
  CHECK(*found.above <= 1.03 * found.seen);
  CHECK(pairs > 0.5 * *found.above);
  // A corner of the mesh is bounded by the triangles that meet the box, and by no others.
  const variation_bounds corner = bound_variation(box(0, 0, 0.125, 0.125), *given);
  REQUIRE(corner.above);
  CHECK(*corner.above <= *found.above);
  // Beside the mesh no triangle gives a bound.
  const variation_bounds beside = bound_variation(box(5, 5, 6, 6), *given);
  CHECK_FALSE(beside.above);
  CHECK(beside.obstacle.find("no triangle") != std::string::npos);
}

TEST_CASE("a field on a mesh that changes across its triangles alone is bounded tightly") {
  mesh m;
  constexpr vertex_index n = 3;
  for (vertex_index j = 0; j <= n; ++j)
    for (vertex_index i = 0; i <= n; ++i) {
      const double scale = 1 + 0.4 * ((i + j) % 2);
      m.sites.push_back({{i / 3.0, j / 3.0}, {scale, 0, 1.2 * scale}});
    }
  add_grid_triangles(m, n);
  const variation_bounds found = bound_variation(box(0, 0, 1, 1), *make_interpolated_field(m, 0.5));
  INFO(found.obstacle);
  REQUIRE(found.above);
  CHECK(*found.above <= 1.03 * found.seen);
}

TEST_CASE("where a field may jump, or its formula is not known, there is no bound") {
  const domain d = box(-1, -1, 1, 1);
  for (const auto& [spec, said] :
       {std::pair("expr:(x>0.1)?100:1;0;1", "near (0."),
        // Formulas in which a comparison with NaN, or with a power of a negative number, decides.
        std::pair("expr:x^101<-0.5?1:2;0;1", "near"), std::pair("expr:sqrt(x)>=0?1:2;0;1", "near"),
        std::pair("expr:tanh(sqrt(x))<2?1:2;0;1", "near"),
        std::pair("expr:ln(x+0.5)<5&&x<2?1:2;0;1", "near"),
        std::pair("expr:2+rint(x);0;1", "a part of which no bounds are known"),
        std::pair("expr:1;0;1+asinh(x)^2", "a part of which no bounds are known")}) {
    CAPTURE(spec);
    const variation_bounds found = bound_variation(d, *field(spec, d, 1));
    CHECK_FALSE(found.above);
    CHECK(found.obstacle.find(said) != std::string::npos);
  }
}

TEST_CASE("formulas are enclosed as they are evaluated") {
  std::mt19937_64 random(11);
  const auto part = [&] { return unit_fraction(random()); };
  for (const std::string text : {"-x^2",
                                 "2^-x^2",
                                 "2^3^0.5*y",
                                 "-x*-y+ +x",
                                 "1-2-3*x/4/5",
                                 "x<y?1:x>=0.5?2:3",
                                 "1e-2+.5*x+3.E1",
                                 "x!=y&&y<0.5||x==0",
                                 "min(x,y,0.3)+max(x,-y)+avg(x,y,1)+sum(x,x,y)",
                                 "sinh(x)-cosh(y)*tanh(x*y)",
                                 "atan(3*x)+tan(x/2)",
                                 "log2(1+x)+log10(2+y)+ln(3+x)+log(4)",
                                 "abs(x-0.5)^1.5",
                                 "pi*e^x",
                                 "sqrt(x*y)",
                                 "cos(40*x)*sin(7*y)",
                                 "(x>0.5)*2+1",
                                 "x^0.5",
                                 "-(-x)",
                                 "x - -y"}) {
    CAPTURE(text);
    const auto plain = plane_expression::parse(text);
    const auto enclosed = expression_enclosure::parse(text);
    REQUIRE(plain.ok());
    REQUIRE(enclosed);
    for (int i = 0; i < 200; ++i) {
      const double x = part(), y = part(), w = std::ldexp(part(), -static_cast<int>(random() % 20));
      const double h = std::ldexp(part(), -static_cast<int>(random() % 20));
      const floating_point_scope scope(rounding::upward);
      const interval_jet over = enclosed->over(coordinates_over({x, x + w}, {y, y + h}));
      const double t = part(), px = x + t * w, py = y + part() * h;
      const floating_point_scope usual(rounding::nearest);
      const double value = plain.value()({std::min(px, x + w), std::min(py, y + h)});
      CAPTURE(i, x, y, w, h, over.value.inf(), over.value.sup(), value);
      const double slack = 1e-13 * (1 + std::abs(value));
      REQUIRE(over.value.inf() - slack <= value);
      REQUIRE(value <= over.value.sup() + slack);
    }
  }
  for (const std::string text :
       {"", "x+", "x y", "sin x", "sin()", "asin(x)", "f(x)", "z", "x=1", "(x", "x)", "1?2", "2x",
        "sin(x,y)", "x,y", std::string(1000, '(').c_str()})
    CHECK_FALSE(expression_enclosure::parse(text));
}

TEST_CASE("the polygon of directions is around the circle") {
  CHECK(direction_slack >= 1 / std::cos(std::numbers::pi / (2 * variation_directions)) + 1e-6);
  CHECK(direction_slack <= 1.005);
}
