// SPDX-License-Identifier: MIT
#include "asterism/mesh/metric/layered_field.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <string>
#include <utility>

#include "asterism/core/elementary.hpp"
#include "asterism/core/number_text.hpp"

namespace asterism::internal {

namespace {

// The tensor in which an edge of length `across` along the unit vector `normal`, or of length
// `along` at right angles to it, has length 1.
struct layer_lengths {
  point normal;
  double across = 1, along = 1;
};

metric_tensor tensor_of(const layer_lengths& h) {
  const double a = 1 / (h.across * h.across), b = 1 / (h.along * h.along);
  const point& n = h.normal;
  return {a * (n.x * n.x) + b * (n.y * n.y), (a - b) * (n.x * n.y),
          a * (n.y * n.y) + b * (n.x * n.x)};
}

using layer_formula = std::function<layer_lengths(const point& u)>;

// A formula in the frame's coordinates. Its lengths are in units of the domain times `unit`.
class layered_field : public sized_field {
 public:
  layered_field(double size, layer_formula lengths, const field_frame& frame, double unit)
      : sized_field(size * unit), lengths_(std::move(lengths)), frame_(frame) {}

 private:
  result<metric_tensor> unsized(const point& q) const override {
    return tensor_of(lengths_(frame_.local(q)));
  }

  layer_formula lengths_;
  field_frame frame_;
};

// Lengths across circles about the origin; anything goes at the origin itself, where the formulas
// that reach it are round.
layer_lengths across_circles(const point& p, double r, double across, double along) {
  return {r > 0 ? point{p.x / r, p.y / r} : point{1, 0}, across, along};
}

layer_formula boundary_layer(double at_wall, double far) {
  return [=](const point& u) {
    return layer_lengths{{0, 1}, at_wall + (far - at_wall) * u.y, far};
  };
}

// Across the curve y = 0.4 sin(2.5 x): 1/aspect on it, 1 away from it, over a width of about 0.1.
layer_formula curved_shock(double aspect) {
  return [thinnest = 1 / aspect](const point& p) {
    const double slope = elementary::cos(2.5 * p.x), steepness = std::sqrt(1 + slope * slope);
    const double distance = (p.y - 0.4 * elementary::sin(2.5 * p.x)) / steepness;
    const double t = elementary::tanh(distance / 0.1);
    return layer_lengths{
        {-slope / steepness, 1 / steepness}, thinnest + (1 - thinnest) * (t * t), 1};
  };
}

constexpr double thinnest_benchmark_layer = 0.001, benchmark_length = 0.1;

double benchmark_length_at(double distance) {
  return thinnest_benchmark_layer + 2 * (benchmark_length - thinnest_benchmark_layer) * distance;
}

layer_lengths linear(const point& u) {
  return {{0, 1}, benchmark_length_at(std::abs(u.y - 0.5)), benchmark_length};
}

layer_lengths polar_1(const point& u) {
  const double r = std::sqrt(u.x * u.x + u.y * u.y);
  return across_circles(u, r, benchmark_length_at(std::abs(r - 0.5)), benchmark_length);
}

layer_lengths polar_2(const point& u) {
  const double r = std::sqrt(u.x * u.x + u.y * u.y), d = std::min(10 * std::abs(r - 0.5), 1.0);
  return across_circles(u, r, benchmark_length_at(std::abs(r - 0.5)), 0.1 * d + 0.025 * (1 - d));
}

layer_lengths circle_1(const point& u) {
  const point p{u.x + 0.5, u.y - 0.5};
  const double r = std::sqrt(p.x * p.x + p.y * p.y), d = 1.5 * std::abs(1 - r);
  return across_circles(p, r, 0.0005 + d, 0.1 * r + d);
}

struct benchmark {
  std::string_view name;
  layer_lengths (*lengths)(const point& u);
};
constexpr std::array<benchmark, 4> benchmarks = {
    {{"linear", linear}, {"polar-1", polar_1}, {"polar-2", polar_2}, {"circle-1", circle_1}}};

result<double> positive_parameter(std::string_view specification, const std::string& name,
                                  std::string_view text) {
  const auto value = parse_number(text);
  if (!value.ok()) return bad_metric(specification, name + ": " + value.failure().message);
  if (value.value() > 0) return value.value();
  return bad_metric(specification, name + " must be positive, not " + std::string(text));
}

made_field made(double size, layer_formula lengths, const field_frame& frame, double unit) {
  return made_field(std::make_unique<layered_field>(size, std::move(lengths), frame, unit));
}

made_field make_layer(std::string_view specification, std::string_view parameter,
                      const field_frame& frame, double size) {
  const std::size_t comma = parameter.find(',');
  if (comma == std::string_view::npos)
    return bad_metric(specification, "two lengths are wanted, H0,H1");
  const auto at_wall = positive_parameter(specification, "H0", parameter.substr(0, comma));
  if (!at_wall.ok()) return at_wall.failure();
  const auto far = positive_parameter(specification, "H1", parameter.substr(comma + 1));
  if (!far.ok()) return far.failure();
  return made(size, boundary_layer(at_wall.value(), far.value()), frame, 1);
}

}  // namespace

std::optional<made_field> make_layered_field(std::string_view specification, std::string_view name,
                                             std::optional<std::string_view> parameter,
                                             const bounding_box& box, double size) {
  const auto* const known = std::find_if(benchmarks.begin(), benchmarks.end(),
                                         [&](const benchmark& b) { return b.name == name; });
  if (name != "layer" && name != "shock" && known == benchmarks.end()) return std::nullopt;
  const auto middle = frame_in_the_middle(box), corner = frame_at_the_corner(box);
  if (!middle || !corner)
    return bad_metric(specification, "the domain has no extent to scale it to");
  if (name == "layer")
    return make_layer(specification, parameter.value_or("0.001,0.1"), *corner, size);
  if (name == "shock") {
    const auto aspect = positive_parameter(specification, "A", parameter.value_or("50"));
    if (!aspect.ok()) return made_field(aspect.failure());
    return made(size, curved_shock(aspect.value()), *middle, 1);
  }
  if (parameter) return bad_metric(specification, std::string(name) + " takes no parameter");
  return made(size, known->lengths, *corner, 2 * corner->half_unit);
}

}  // namespace asterism::internal
