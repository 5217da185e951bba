// SPDX-License-Identifier: MIT
#include "asterism/mesh/metric/make_metric_field.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <fstream>
#include <iterator>
#include <string>
#include <thread>
#include <vector>

#include "asterism/mesh/data/metric_field.hpp"

using namespace asterism;

namespace {

constexpr bounding_box unit_box{{-1, -1}, {1, 1}};

metric_tensor value(const std::string& specification, const point& q,
                    const bounding_box& box = unit_box, double size = 1) {
  const auto field = make_metric_field(specification, box, size);
  INFO((field.ok() ? "" : field.failure().message));
  REQUIRE(field.ok());
  const auto m = field.value()->at(q);
  INFO((m.ok() ? "" : m.failure().message));
  REQUIRE(m.ok());
  return m.value();
}

std::string refusal(const std::string& specification, double size = 1) {
  const auto field = make_metric_field(specification, unit_box, size);
  REQUIRE_FALSE(field.ok());
  CHECK((field.failure().code == error_code::invalid_metric ||
         field.failure().code == error_code::bad_option));
  return field.failure().message;
}

}  // namespace

TEST_CASE("fields with a closed form") {
  const point q{0.5, -0.25};
  REQUIRE(value("identity", q) == metric_tensor{1, 0, 1});
  REQUIRE(value("swirl:8", q) == metric_tensor{3, -1, 1.5});
  REQUIRE(value("sink:8", q) == metric_tensor{1.5, 1, 3});
  REQUIRE(value("swirl", q) == value("swirl:12", q));
  REQUIRE(value("sink", q) == value("sink:1.2e1", q));
  REQUIRE(value("swirl:0", q) == metric_tensor{1, 0, 1});
  REQUIRE(value("expr:1+8*x^2;8*x*y;1+8*y*y", q) == value("swirl:8", q));
}

TEST_CASE("swirl and sink are centred on the box and scaled by half its longer side") {
  const bounding_box box{{10, -2}, {18, 0}};  // centre (14,-1), half 4
  REQUIRE(value("swirl:16", {16, 0}, box) == metric_tensor{5, 2, 2});
  REQUIRE(value("sink:16", {16, 0}, box) == metric_tensor{2, -2, 5});
  REQUIRE(value("swirl:16", {14, -1}, box) == metric_tensor{1, 0, 1});
}

TEST_CASE("the size divides by its square") {
  REQUIRE(value("swirl:8", {0.5, -0.25}, unit_box, 0.5) == metric_tensor{12, -4, 6});
  REQUIRE(value("identity", {0, 0}, unit_box, 4) == metric_tensor{0.0625, 0, 0.0625});
}

TEST_CASE("expressions have the functions and constants of a calculator") {
  REQUIRE(value("expr: sqrt(4) ; sin(0*x) ; x < 0 ? 1 : 3", {1, 1}) == metric_tensor{2, 0, 3});
  REQUIRE(value("expr:exp(0);0;2*pi", {0, 0}).m22 == 2 * std::acos(-1.0));
  REQUIRE(value("expr:1+(x>=0)+(y==2);0;1", {0, 2}).m11 == 3);
}

TEST_CASE("powers in expressions are not the C library's, and bind as they did") {
  REQUIRE(value("expr:10-x^2; -y^2/2 ; 2^3^2", {3, 1}) == metric_tensor{1, -0.5, 512});
  REQUIRE(value("expr:2*x^2+1; 2^-3 ; (1+y)^0.5", {3, 3}) == metric_tensor{19, 0.125, 2});
  REQUIRE_THAT(refusal("expr:1;0;x^^2"), Catch::Contains("unexpected '^' (position 3)"));
  REQUIRE_THAT(refusal("expr:1;0;x#2"), Catch::Contains("unexpected '#' (position 2)"));
}

TEST_CASE("expressions have all functions of their language") {
  const auto at = [](const std::string& formula, double x, double y) {
    const metric_tensor m = value("expr:9;" + formula + ";9", {x, y});
    return m.m12;
  };
  CHECK(at("asin(x)+acos(x)-pi/2", 0.3, 0) == Approx(0).margin(1e-15));
  CHECK(at("atan2(y,x)-atan(y/x)", 2, 3) == Approx(0).margin(1e-15));
  CHECK(at("sinh(asinh(x))+cosh(acosh(y))-tanh(atanh(x))", 0.4, 1.5) == Approx(1.5));
  CHECK(at("log2(8)+log10(100)-ln(e)-log(e)+exp(0)", 0, 0) == 4);
  CHECK(at("sign(-x)+rint(y)+abs(-x)", 2, 0.5) == 2);
  CHECK(at("min(3,x,y)+max(x)+sum(1,x)+avg(x,y)", 2, 1) == 7.5);
  CHECK(at("x>1&&y||x!=x", 2, 0) == 0);
  CHECK(at("x<0?1:x<1?2:x<2?3:4", 1.5, 0) == 3);
  CHECK(at("2^-x^2*3 - -y", 1, 1) == 2.5);
}

// Meshes depend on the bits of these.
TEST_CASE("expressions are evaluated step by step as they are written") {
  const double x = 0.7, y = 0.3;
  const metric_tensor m = value("expr:7*(x-0.1);y/3-y/7;9+(x+2*x-0.1-0.2)*3/7", {x, y});
  CHECK(m.m11 == 7 * (x - 0.1));
  CHECK(m.m12 == y / 3 - y / 7);
  CHECK(m.m22 == 9 + (x + 2 * x - 0.1 - 0.2) * 3 / 7);
  // A multiple of x plus a constant would be x itself.
  CHECK(value("expr:1;(x+0.1)-0.1;1", {1e-20, 0}).m12 == 0);
  CHECK(value("expr:3*x*2^0.5;0;9", {x, y}).m11 == 3 * x * std::sqrt(2.0));
}

TEST_CASE("faults of expressions are told with their places") {
  for (const auto& [formula, said] :
       {std::pair("2x", "unexpected 'x' (position 2)"), std::pair("x y", "unexpected 'y'"),
        std::pair("(x", "something is missing at the end (position 3)"),
        std::pair("x)", "unexpected ')' (position 2)"), std::pair("x?1", "missing at the end"),
        std::pair("sin x", "unexpected 'x' (position 5)"),
        std::pair("1+sin(x,y)", "the number of arguments of sin is not 2 (position 3)"),
        std::pair("min()", "the number of arguments of min is not 0"),
        std::pair("1e+", "'1e+' is not a number (position 1)"),
        std::pair("1e999*x", "(position 1)"), std::pair("f(x)", "unknown name \"f\""),
        std::pair("x=1", "assignments are not allowed (position 2)"),
        std::pair("x\u00b2", "unexpected '\u00b2' (position 2)"),
        std::pair("\xe2\x88", "unexpected '\xe2' (position 1)")}) {
    CAPTURE(formula);
    REQUIRE_THAT(refusal(std::string("expr:1;0;") + formula), Catch::Contains(said));
  }
  REQUIRE_THAT(refusal("expr:1;0;" + std::string(1000, '(')), Catch::Contains("more than 200"));
  std::string chain;
  for (int i = 0; i < 1000; ++i) chain += "x<" + std::to_string(i) + "?" + std::to_string(i) + ":";
  REQUIRE(value("expr:" + chain + "0;0;1", {700.5, 0}).m11 == 701);
}

TEST_CASE("a tensor that is no metric is refused with point and numbers") {
  const auto field = make_metric_field("expr:x;0;1", unit_box).value()->at({-0.1, 0.3});
  REQUIRE_FALSE(field.ok());
  REQUIRE(field.failure().message ==
          "the metric at (-0.1, 0.3) is not positive definite: m11 m12 m22 = -0.1 0 1");
  // Six digits of these numbers are a tensor that is positive definite.
  const auto rounded = make_metric_field("expr:1;1.000004;1.000006", unit_box).value()->at({0, 0});
  REQUIRE_THAT(rounded.failure().message, Catch::Contains("= 1 1.000004 1.000006"));
  const auto semidefinite = make_metric_field("expr:1;3;9", unit_box).value()->at({0, 0});
  REQUIRE_THAT(semidefinite.failure().message, Catch::Contains("not positive definite"));
  const auto infinite = make_metric_field("expr:1/x;0;1", unit_box).value()->at({0, 1});
  REQUIRE_THAT(infinite.failure().message, Catch::Contains("not finite: m11 m12 m22 = too large"));
  CHECK(infinite.failure().code == error_code::invalid_metric);
  const auto undefined = make_metric_field("expr:sqrt(x);0;1", unit_box).value()->at({-1, 1});
  REQUIRE_THAT(undefined.failure().message, Catch::Contains("not finite"));
}

TEST_CASE("definiteness is decided exactly") {
  // The determinant is 2^-105, and in doubles its two products round to the same number.
  const double e = 0x1p-52;
  const auto tensor = [&](double m11) {
    return "expr:" + std::to_string(static_cast<int>(m11)) + "+2^-51;1+2^-52;1";
  };
  // (1 + 2e)(1) - (1 + e)^2 = -e^2 < 0
  REQUIRE_FALSE(make_metric_field(tensor(1), unit_box).value()->at({0, 0}).ok());
  REQUIRE(value("expr:1+2^-51;1+2^-52;1+2^-52", {0, 0}).m22 == 1 + e);
}

TEST_CASE("bad specifications are refused with the reason") {
  REQUIRE_THAT(refusal("whirl:3"),
               Catch::Contains("metric 'whirl:3': unknown; there are identity"));
  REQUIRE_THAT(refusal(""), Catch::Contains("unknown"));
  REQUIRE_THAT(refusal("identity:2"), Catch::Contains("takes no parameter"));
  REQUIRE_THAT(refusal("swirl:"), Catch::Contains("K: '' is not a number"));
  REQUIRE_THAT(refusal("swirl:abc"), Catch::Contains("K: 'abc' is not a number"));
  REQUIRE_THAT(refusal("swirl:3x"), Catch::Contains("'3x' is not a number"));
  REQUIRE_THAT(refusal("sink:-1"), Catch::Contains("K must not be negative, not -1"));
  REQUIRE_THAT(refusal("sink:nan"), Catch::Contains("'nan' is not finite"));
  REQUIRE_THAT(refusal("expr:"), Catch::Contains("M11: an expression is empty"));
  REQUIRE_THAT(refusal("expr:1;0"), Catch::Contains("there are only 2"));
  REQUIRE_THAT(refusal("expr:1;0;1;0"), Catch::Contains("there are more"));
  REQUIRE_THAT(refusal("expr:1;;1"), Catch::Contains("M12: an expression is empty"));
  REQUIRE_THAT(refusal("expr:1;0;2*(x+"), Catch::Contains("M22: ") && Catch::Contains("position"));
  REQUIRE_THAT(refusal("expr:1;0;1+z"), Catch::Contains("\"z\"") && Catch::Contains("position 3"));
  REQUIRE_THAT(refusal("expr:1;0;X"), Catch::Contains("\"X\""));
  REQUIRE_THAT(refusal("expr:1;x=3;1"),
               Catch::Contains("assignments") && Catch::Contains("position 2"));
  REQUIRE_THAT(refusal("expr:1,2;0;1"), Catch::Contains("one value is wanted, not 2"));
  REQUIRE_THAT(refusal("identity", 0), Catch::Contains("size must be positive and finite, not 0"));
  REQUIRE_THAT(refusal("identity", -0.5), Catch::Contains("not -0.5"));
  REQUIRE_THAT(refusal("identity", NAN), Catch::Contains("not nan"));
  REQUIRE_FALSE(make_metric_field("swirl", {{1, 1}, {1, 1}}).ok());
}

TEST_CASE("an expression field may be asked from several threads") {
  const auto field = make_metric_field("expr:1+x*x;x*y;1+y*y", unit_box);
  std::vector<int> wrong(4, 0);
  std::vector<std::thread> threads;
  for (std::size_t t = 0; t < wrong.size(); ++t)
    threads.emplace_back([&, t] {
      for (int i = 0; i < 2000; ++i) {
        const point q{0.001 * i, static_cast<double>(t)};
        const auto m = field.value()->at(q);
        const metric_tensor expected{1 + q.x * q.x, q.x * q.y, 1 + q.y * q.y};
        if (!m.ok() || m.value() != expected) ++wrong[t];
      }
    });
  for (std::thread& t : threads) t.join();
  REQUIRE(wrong == std::vector<int>(4, 0));
}

TEST_CASE("layers are flat along the lower side of the box and grow upwards") {
  const bounding_box box{{2, -1}, {4, 1}};
  REQUIRE(value("layer:0.25,0.5", {2, -1}, box) == metric_tensor{4, 0, 16});
  REQUIRE(value("layer:0.25,0.5", {3.3, 1}, box) == metric_tensor{4, 0, 4});
  REQUIRE(value("layer:0.5,1", {3, 0}, box).m22 == 1 / (0.75 * 0.75));
  REQUIRE(value("layer", {2, 0.1}, box) == value("layer:0.001,1e-1", {2, 0.1}, box));
  REQUIRE(value("layer:0.25,0.5", {2, -1}, box, 2) == metric_tensor{1, 0, 4});
}

TEST_CASE("the curved shock is thin on its curve and round away from it") {
  const metric_tensor on = value("shock:10", {0, 0});  // normal (-1, 1) / sqrt 2, slope 1
  REQUIRE(on.m11 == Approx(50.5));
  REQUIRE(on.m12 == Approx(-49.5));
  REQUIRE(on.m22 == Approx(50.5));
  const metric_tensor away = value("shock", {0, 0.99});
  REQUIRE(away.m11 == Approx(1).epsilon(1e-5));
  REQUIRE(away.m12 == Approx(0).margin(1e-5));
  REQUIRE(value("shock", {0.1, 0.2}) == value("shock:50", {0.1, 0.2}));
}

TEST_CASE("the benchmarks have their published values on the unit square") {
  const bounding_box square{{0, 0}, {1, 1}};
  const auto inverse_square = [](double h) { return Approx(1 / (h * h)); };
  REQUIRE(value("linear", {0.3, 0.5}, square).m22 == inverse_square(0.001));
  REQUIRE(value("linear", {0.3, 1}, square).m22 == inverse_square(0.1));
  REQUIRE(value("linear", {0.3, 0.25}, square).m22 == inverse_square(0.0505));
  REQUIRE(value("linear", {0.9, 0.25}, square).m11 == inverse_square(0.1));

  REQUIRE(value("polar-1", {0.5, 0}, square).m11 == inverse_square(0.001));
  REQUIRE(value("polar-1", {0.5, 0}, square).m22 == inverse_square(0.1));
  REQUIRE(value("polar-1", {0, 0}, square) == value("polar-2", {0, 0}, square));
  REQUIRE(value("polar-1", {0, 0}, square).m11 == inverse_square(0.1));
  REQUIRE(value("polar-1", {0, 0.8}, square).m22 == inverse_square(0.001 + 0.198 * 0.3));
  // On the diagonal both entries are the mean of the eigenvalues.
  const metric_tensor diagonal = value("polar-1", {0.3, 0.3}, square);
  const double r = std::sqrt(0.18), across = 1 / std::pow(0.001 + 0.198 * (0.5 - r), 2);
  REQUIRE(diagonal.m11 == Approx((across + 100) / 2));
  REQUIRE(diagonal.m12 == Approx((across - 100) / 2));

  REQUIRE(value("polar-2", {0, 0.5}, square).m11 == inverse_square(0.025));
  REQUIRE(value("polar-2", {0, 0.55}, square).m11 == inverse_square(0.0625));
  REQUIRE(value("polar-2", {0, 0.6}, square).m11 == inverse_square(0.1));
  REQUIRE(value("polar-2", {0.45, 0}, square).m22 == inverse_square(0.0625));

  REQUIRE(value("circle-1", {0.5, 0.5}, square).m11 == inverse_square(0.0005));
  REQUIRE(value("circle-1", {0.5, 0.5}, square).m22 == inverse_square(0.1));
  REQUIRE(value("circle-1", {0, 0.5}, square).m11 == inverse_square(0.7505));
  REQUIRE(value("circle-1", {0, 0.5}, square).m22 == inverse_square(0.8));
}

TEST_CASE("the benchmarks scale with the box") {
  // On the square twice as large, lengths are twice as long and tensors a quarter.
  REQUIRE(value("linear", {-0.4, 0}).m22 == Approx(250000));
  REQUIRE(value("polar-1", {0, -1}).m11 == Approx(250000));
  REQUIRE(value("circle-1", {0, 0}, unit_box, 0.5).m11 == Approx(4000000));
}

TEST_CASE("layered fields with bad parameters are refused with the reason") {
  REQUIRE_THAT(refusal("layer:0.1"), Catch::Contains("two lengths are wanted, H0,H1"));
  REQUIRE_THAT(refusal("layer:0,1"), Catch::Contains("H0 must be positive, not 0"));
  REQUIRE_THAT(refusal("layer:0.1,much"), Catch::Contains("H1: 'much' is not a number"));
  REQUIRE_THAT(refusal("layer:0.1,1,2"), Catch::Contains("H1: '1,2' is not a number"));
  REQUIRE_THAT(refusal("shock:-3"), Catch::Contains("A must be positive, not -3"));
  REQUIRE_THAT(refusal("linear:2"), Catch::Contains("linear takes no parameter"));
  REQUIRE_FALSE(make_metric_field("polar-1", {{1, 1}, {1, 1}}).ok());
  // A tensor beyond the range of doubles is an error at the point where it is evaluated.
  REQUIRE_FALSE(make_metric_field("layer:1e-200,1", unit_box).value()->at({0, -1}).ok());
}

TEST_CASE("the manual, help and errors have the metrics that there are") {
  const auto page_of = [](const std::string& name) {
    std::ifstream page(ASTERISM_DOCS "/manual/" + name);
    REQUIRE(page);
    return std::string((std::istreambuf_iterator<char>(page)), std::istreambuf_iterator<char>());
  };
  const std::string formulas = page_of("metrics.md"), refused = refusal("whirl");
  std::string table = "| SPEC | |\n|---|---|\n";
  for (const metric_name& metric : metric_names()) {
    const std::string given = std::string(metric.name).append(metric.arguments);
    INFO(given);
    table += "| `" + given + "` | " + std::string(metric.sentence) + " |\n";
    CHECK(formulas.find("\n| `" + given + "` |") != std::string::npos);
    CHECK(refused.find(given) != std::string::npos);
    // Optional arguments are in brackets. All formulas but three have only optional ones.
    const bool may_be_left_out = metric.arguments.empty() || metric.arguments.front() == '[';
    CHECK(make_metric_field(metric.name, unit_box).ok() == may_be_left_out);
  }
  INFO("docs/manual/command_line.md is to have\n" << table);
  CHECK(page_of("command_line.md").find(table) != std::string::npos);
}
