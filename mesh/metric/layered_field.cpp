// SPDX-License-Identifier: MIT
#include "asterism/mesh/metric/layered_field.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <string>
#include <type_traits>
#include <utility>

#include "asterism/core/number_text.hpp"
#include "asterism/mesh/metric/formula_functions.hpp"
#include "asterism/mesh/metric/interval_functions.hpp"
#include "asterism/mesh/metric/layer_enclosure.hpp"

namespace asterism::internal {

namespace {

// A point in the frame's coordinates, in doubles or enclosures.
template <class Number>
struct local_point {
  Number x, y;
};

// The tensor in which an edge of length `across` along the unit vector `normal`, and one of length
// `along` at right angles to it, have length 1.
template <class Number>
struct layer_lengths {
  local_point<Number> normal;
  Number across, along;
};

metric_tensor tensor_of(const layer_lengths<double>& h) {
  const double a = 1 / (h.across * h.across), b = 1 / (h.along * h.along);
  const auto& n = h.normal;
  return {a * (n.x * n.x) + b * (n.y * n.y), (a - b) * (n.x * n.y),
          a * (n.y * n.y) + b * (n.x * n.x)};
}

tensor_jet tensor_of(const layer_lengths<interval_jet>& h) {
  const interval_jet a = 1 / square(h.across), b = 1 / square(h.along);
  const auto& n = h.normal;
  return {a * square(n.x) + b * square(n.y), (a - b) * (n.x * n.y),
          a * square(n.y) + b * square(n.x)};
}

using plain_point = local_point<double>;
using enclosed_point = local_point<interval_jet>;

template <class Number>
struct two_lengths {
  Number across, along;
};

// Describes lengths that depend on the distance r from a centre alone, across the circles around
// it.
struct radial_formula {
  std::function<two_lengths<interval_jet>(const interval_jet& r)> over;
  plain_point centre{0, 0};
  bool is_round_at_centre = false;  // are both lengths the same at r = 0?
};

// Evaluates a formula in both arithmetics.
struct layer_formula {
  std::function<layer_lengths<double>(const plain_point&)> at;
  std::function<layer_lengths<interval_jet>(const enclosed_point&)> over;
  std::optional<radial_formula> radial = {};
};

// Returns the enclosures of a layer from enclosed lengths and directions with their derivatives.
layer_enclosure layers_of(const layer_lengths<interval_jet>& h) {
  const rounded_interval &nx = h.normal.x.value, &ny = h.normal.y.value;
  const auto by_normal = [&](const interval_jet& f) { return nx * f.x + ny * f.y; };
  const auto by_tangent = [&](const interval_jet& f) { return nx * f.y - ny * f.x; };
  const interval_jet &x = h.normal.x, &y = h.normal.y;
  const rounded_interval excess =
      divided(h.along.value, h.across.value) - divided(h.across.value, h.along.value);
  return {h.across.value,
          h.along.value,
          by_normal(h.across),
          by_tangent(h.across),
          by_normal(h.along),
          by_tangent(h.along),
          excess * (nx * by_normal(y) - ny * by_normal(x)),
          excess * (nx * by_tangent(y) - ny * by_tangent(x))};
}

// Returns the enclosures of a layer across circles, at enclosed coordinates. The angle of the
// normal grows by 1/r along the circle. Where r may be 0 and both lengths are the same there, (B -
// A) / r is one of the derivatives of B - A from 0 to r.
layer_enclosure layers_around(const radial_formula& formula, const enclosed_point& p) {
  const rounded_interval r = root_of(squared(p.x.value - rounded_interval(formula.centre.x)) +
                                     squared(p.y.value - rounded_interval(formula.centre.y)));
  const two_lengths<interval_jet> h = formula.over({r, 1, 0});
  const rounded_interval &a = h.across.value, &b = h.along.value;
  const bool from_centre = formula.is_round_at_centre && !(r.inf() > 0);
  const rounded_interval slope = from_centre ? h.along.x - h.across.x : divided(b - a, r);
  return {a, b, h.across.x, 0.0, h.along.x, 0.0, 0.0, divided(slope * (b + a), a * b)};
}

template <class Formula>
layer_formula in_both(const Formula& formula) {
  return {formula, formula};
}

// Evaluates a formula of the frame's coordinates. Its lengths are in units of the domain times
// `unit`.
class layered_field final : public sized_field, public layered {
 public:
  layered_field(double size, layer_formula lengths, const field_frame& frame, double unit)
      : sized_field(size * unit), lengths_(std::move(lengths)), frame_(frame) {}

  std::optional<layer_enclosure> layers_over(const plane_jet& at) const override {
    const plane_jet u = frame_.local(at);
    layer_enclosure found = lengths_.radial ? layers_around(*lengths_.radial, {u.x, u.y})
                                            : layers_of(lengths_.over({u.x, u.y}));
    const rounded_interval size = root_of(rounded_interval(size_squared()));
    found.across = size * found.across;
    found.along = size * found.along;
    // Multiplies lengths and their derivatives by the size. Derivatives are by the coordinates of
    // the domain; those of a radial formula are by the radius in the frame, and are divided by its
    // unit.
    const rounded_interval unit =
        lengths_.radial ? rounded_interval(2) * rounded_interval(frame_.half_unit) : 1.0;
    for (rounded_interval* each : {&found.across_by_normal, &found.across_by_tangent,
                                   &found.along_by_normal, &found.along_by_tangent})
      *each = divided(size * *each, unit);
    found.turn_by_normal = divided(found.turn_by_normal, unit);
    found.turn_by_tangent = divided(found.turn_by_tangent, unit);
    return found;
  }

 private:
  result<metric_tensor> unsized(const point& q) const override {
    const point u = frame_.local(q);
    return tensor_of(lengths_.at({u.x, u.y}));
  }
  std::optional<tensor_jet> unsized_over(const plane_jet& at) const override {
    const plane_jet u = frame_.local(at);
    return tensor_of(lengths_.over({u.x, u.y}));
  }

  layer_formula lengths_;
  field_frame frame_;
};

// Returns the lengths for a layer across circles about the origin; any direction is valid at the
// origin itself, where the formulas that reach it are isotropic.
layer_lengths<double> across_circles(const plain_point& p, double r, double across, double along) {
  return {r > 0 ? plain_point{p.x / r, p.y / r} : plain_point{1, 0}, across, along};
}
layer_lengths<interval_jet> across_circles(const enclosed_point& p, const interval_jet& r,
                                           const interval_jet& across, const interval_jet& along) {
  return {{p.x / r, p.y / r}, across, along};
}

layer_formula boundary_layer(double at_wall, double far) {
  return in_both([=](const auto& u) {
    using number = std::decay_t<decltype(u.x)>;
    return layer_lengths<number>{{0.0, 1.0}, at_wall + (far - at_wall) * u.y, far};
  });
}

// Makes lengths across the curve y = 0.4 sin(2.5 x) grow from 1/aspect on it to 1 away from it,
// over a width of about 0.1.
layer_formula curved_shock(double aspect) {
  return in_both([thinnest = 1 / aspect](const auto& p) {
    using number = std::decay_t<decltype(p.x)>;
    const number slope = cosine(2.5 * p.x), steepness = square_root(1 + square(slope));
    const number distance = (p.y - 0.4 * sine(2.5 * p.x)) / steepness;
    const number t = hyperbolic_tangent(distance / 0.1);
    return layer_lengths<number>{
        {-slope / steepness, 1 / steepness}, thinnest + (1 - thinnest) * square(t), 1.0};
  });
}

constexpr double thinnest_benchmark_layer = 0.001, benchmark_length = 0.1;

template <class Number>
Number benchmark_length_at(const Number& distance) {
  return thinnest_benchmark_layer + 2 * (benchmark_length - thinnest_benchmark_layer) * distance;
}

layer_formula linear() {
  return in_both([](const auto& u) {
    using number = std::decay_t<decltype(u.x)>;
    return layer_lengths<number>{
        {0.0, 1.0}, benchmark_length_at(absolute(u.y - 0.5)), benchmark_length};
  });
}

// Makes a formula of lengths across circles around a centre.
template <class Lengths>
layer_formula around(const Lengths& lengths, const plain_point& centre, bool is_round_at_centre) {
  layer_formula made = in_both([=](const auto& u) {
    using number = std::decay_t<decltype(u.x)>;
    const bool is_origin = centre.x == 0 && centre.y == 0;
    const local_point<number> p = is_origin ? local_point<number>{u.x, u.y}
                                            : local_point<number>{u.x - centre.x, u.y - centre.y};
    const number r = square_root(square(p.x) + square(p.y));
    const two_lengths<number> h = lengths(r);
    return across_circles(p, r, h.across, h.along);
  });
  made.radial = radial_formula{lengths, centre, is_round_at_centre};
  return made;
}

layer_formula polar_1() {
  return around(
      [](const auto& r) {
        using number = std::decay_t<decltype(r)>;
        return two_lengths<number>{benchmark_length_at(absolute(r - 0.5)), benchmark_length};
      },
      {0, 0}, true);
}

layer_formula polar_2() {
  return around(
      [](const auto& r) {
        using number = std::decay_t<decltype(r)>;
        const number d = lesser(10 * absolute(r - 0.5), number(1.0));
        return two_lengths<number>{benchmark_length_at(absolute(r - 0.5)),
                                   0.1 * d + 0.025 * (1 - d)};
      },
      {0, 0}, true);
}

layer_formula circle_1() {
  return around(
      [](const auto& r) {
        using number = std::decay_t<decltype(r)>;
        const number d = 1.5 * absolute(1 - r);
        return two_lengths<number>{0.0005 + d, 0.1 * r + d};
      },
      {-0.5, 0.5}, false);
}

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

made_field no_extent(const field_request& asked) {
  return bad_metric(asked.specification, "the domain has no extent to scale it to");
}

made_field make_layer(const field_request& asked) {
  const auto corner = frame_at_the_corner(asked.box);
  if (!corner) return no_extent(asked);
  const std::string_view parameter = asked.parameter.value_or("0.001,0.1");
  const std::size_t comma = parameter.find(',');
  if (comma == std::string_view::npos)
    return bad_metric(asked.specification, "two lengths are wanted, H0,H1");
  const auto at_wall = positive_parameter(asked.specification, "H0", parameter.substr(0, comma));
  if (!at_wall.ok()) return at_wall.failure();
  const auto far = positive_parameter(asked.specification, "H1", parameter.substr(comma + 1));
  if (!far.ok()) return far.failure();
  return made(asked.size, boundary_layer(at_wall.value(), far.value()), *corner, 1);
}

made_field make_shock(const field_request& asked) {
  const auto middle = frame_in_the_middle(asked.box);
  if (!middle) return no_extent(asked);
  const auto aspect = positive_parameter(asked.specification, "A", asked.parameter.value_or("50"));
  if (!aspect.ok()) return aspect.failure();
  return made(asked.size, curved_shock(aspect.value()), *middle, 1);
}

// Places the benchmarks, which are defined on the unit square, in a square on the box's longer
// side.
template <layer_formula (*formula)()>
made_field make_benchmark(const field_request& asked) {
  const auto corner = frame_at_the_corner(asked.box);
  if (!corner) return no_extent(asked);
  if (asked.parameter) return takes_no_parameter(asked);
  return made(asked.size, formula(), *corner, 2 * corner->half_unit);
}

constexpr std::array<named_field, 6> rows = {{
    {"layer", "[:H0,H1]",
     "flat along the lower side of the domain's box: H1 long, H0 high there and H1 high a longer "
     "side above (0.001,0.1)",
     make_layer},
    {"shock", "[:A]", "A times as long as high along a curve, 1 high elsewhere (50)", make_shock},
    {"linear", "", "a benchmark: thin along a horizontal line", make_benchmark<linear>},
    {"polar-1", "", "a benchmark: thin along a circle around the lower left corner",
     make_benchmark<polar_1>},
    {"polar-2", "", "a benchmark: thin and short along the same circle", make_benchmark<polar_2>},
    {"circle-1", "", "a benchmark: thin along a circle around a point left of the box",
     make_benchmark<circle_1>},
}};

}  // namespace

std::span<const named_field> layered_fields() { return rows; }

}  // namespace asterism::internal
