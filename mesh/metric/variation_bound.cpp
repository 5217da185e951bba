// SPDX-License-Identifier: MIT
#include "asterism/mesh/metric/variation_bound.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <queue>
#include <utility>
#include <vector>

#include "asterism/core/floating_point_environment.hpp"
#include "asterism/mesh/domain/message_names.hpp"
#include "asterism/mesh/metric/graded_variation.hpp"
#include "asterism/mesh/metric/layer_enclosure.hpp"
#include "asterism/mesh/metric/logarithm_triangle.hpp"
#include "asterism/mesh/metric/sized_field.hpp"
#include "asterism/mesh/metric/tensor_variation.hpp"
#include "asterism/mesh/support/infinity.hpp"

namespace asterism::internal {
namespace {

// Limits of the halving: largest number of parts, and the ratio of bound to seen variation that is
// close enough. Bounds are valid wherever halving ends, only less tight.
constexpr std::size_t most_parts = 200'000;
constexpr double close_enough = 1.02;

// A convex polygon around the vertices of a domain, known by the farthest of them in each of
// sixteen directions.
class outline {
 public:
  explicit outline(const domain& d) {
    farthest_.fill(-infinity);
    for (const point& v : d.vertices)
      for (std::size_t k = 0; k < directions.size(); ++k)
        farthest_[k] = std::max(farthest_[k], directions[k].x * v.x + directions[k].y * v.y);
  }

  // True only if no point of the box is in the polygon.
  bool misses(const point& low, const point& high) const {
    for (std::size_t k = 0; k < directions.size(); ++k) {
      const point& n = directions[k];
      const double x = n.x * (n.x > 0 ? low.x : high.x), y = n.y * (n.y > 0 ? low.y : high.y);
      // Bounds the rounding errors of x + y and of the sum in farthest_, 2^-53 of each; products
      // by 0, 1 and 2 are exact.
      const double slack = 0x1p-50 * (std::abs(x) + std::abs(y) + std::abs(farthest_[k]));
      if (x + y > farthest_[k] + slack) return true;
    }
    return false;
  }

 private:
  static constexpr std::array<point, 16> directions = {{{1, 0},
                                                        {2, 1},
                                                        {1, 1},
                                                        {1, 2},
                                                        {0, 1},
                                                        {-1, 2},
                                                        {-1, 1},
                                                        {-2, 1},
                                                        {-1, 0},
                                                        {-2, -1},
                                                        {-1, -1},
                                                        {-1, -2},
                                                        {0, -1},
                                                        {1, -2},
                                                        {1, -1},
                                                        {2, -1}}};
  std::array<double, 16> farthest_{};
};

// A part of the region with its bounds; `order` is the tie-breaking order of parts with equal
// bounds.
template <class Part>
struct bounded_part {
  Part part;
  variation_of_part bounds;
  std::size_t order = 0;

  friend bool operator<(const bounded_part& a, const bounded_part& b) {
    if (a.bounds.above != b.bounds.above) return a.bounds.above < b.bounds.above;
    return a.order > b.order;
  }
};

// Repeatedly halves the part with the greatest bound. `Region` provides parts and their bounds.
template <class Region>
class halving {
 public:
  explicit halving(const Region& region) : region_(region) {}

  variation_bounds run() {
    for (auto& part : region_.first_parts()) add(std::move(part));
    while (!parts_.empty() && looked_at_ < most_parts && !obstacle_) {
      const double greatest = parts_.top().bounds.above;
      if (greatest <= close_enough * seen_) break;
      const auto part = parts_.top().part;
      parts_.pop();
      const auto halves = region_.halves(part);
      if (!halves)
        return {std::nullopt, seen_, "it may jump, or be no metric, near " + region_.place(part)};
      for (const auto& half : *halves) add(half);
    }
    if (obstacle_) return {std::nullopt, seen_, *obstacle_};
    if (parts_.empty()) return {std::nullopt, seen_, "no triangle of its mesh meets the domain"};
    const auto& worst = parts_.top();
    if (worst.bounds.above < infinity) return {worst.bounds.above, seen_, {}};
    return {std::nullopt, seen_, "none was found near " + region_.place(worst.part)};
  }

 private:
  template <class Part>
  void add(Part part) {
    if (region_.is_outside(part) || obstacle_) return;
    ++looked_at_;
    const auto bounds = region_.bounds_of(part);
    if (!bounds) {
      obstacle_ = bounds.failure().message;
      return;
    }
    seen_ = std::max(seen_, bounds.value().in_middle);
    parts_.push({part, bounds.value(), looked_at_});
  }

  const Region& region_;
  std::priority_queue<bounded_part<typename Region::part>> parts_;
  std::size_t looked_at_ = 0;
  double seen_ = 0;
  std::optional<std::string> obstacle_;
};

// Encloses a formula over boxes.
class formula_region {
 public:
  struct part {
    point low, high;
    bool is_wider = false;  // see is_wider()
  };

  formula_region(const domain& d, const sized_field& formula)
      : outline_(d),
        box_(d.box()),
        formula_(formula),
        layers_(dynamic_cast<const layered*>(&formula)) {}

  std::vector<part> first_parts() const { return {{box_.low, box_.high, false}}; }
  bool is_outside(const part& p) const { return outline_.misses(p.low, p.high); }
  static std::string place(const part& p) { return coordinates(middle_of(p)); }

  // Returns the bounds of a part, and stores whether its box is wider than high.
  result<variation_of_part> bounds_of(part& p) const {
    const point m = middle_of(p);
    const small_part shape{m, reach(p.low.x, m.x, p.high.x), reach(p.low.y, m.y, p.high.y)};
    const auto found = enclosed(p, shape);
    if (!found) return error{"its formula has a part of which no bounds are known"};
    p.is_wider = is_wider(p, found->over);
    const auto value = formula_.at(shape.middle);
    if (!value || !agrees(value.value(), found->in_middle))
      return error{"its values are not those of its formula at " + coordinates(shape.middle)};
    return found->bounds;
  }

  // Returns both halves, across the side along which the tensor changes more, or the longer one;
  // nothing where no double is between the ends of that side.
  std::optional<std::array<part, 2>> halves(const part& p) const {
    const point m = middle_of(p);
    const bool across_x = p.is_wider;
    if (across_x ? !(p.low.x < m.x && m.x < p.high.x) : !(p.low.y < m.y && m.y < p.high.y))
      return std::nullopt;
    const point cut = across_x ? point{m.x, p.high.y} : point{p.high.x, m.y};
    const point other_cut = across_x ? point{m.x, p.low.y} : point{p.low.x, m.y};
    return std::array<part, 2>{{{p.low, cut}, {other_cut, p.high}}};
  }

 private:
  static point middle_of(const part& p) {
    return {p.low.x / 2 + p.high.x / 2, p.low.y / 2 + p.high.y / 2};
  }
  // Returns how far the farther end is from the middle, rounded up: difference and product have
  // errors of 2^-53 of themselves each, and none where they are subnormal. The rounded middle need
  // not be the mean of the ends.
  static double reach(double low, double middle, double high) {
    return std::max(high - middle, middle - low) * (1 + 0x1p-50);
  }

  struct enclosure {
    variation_of_part bounds;
    tensor_jet over, in_middle;
  };
  [[gnu::noinline]] std::optional<enclosure> enclosed(const part& p,
                                                      const small_part& shape) const {
    const floating_point_scope scope(rounding::upward);
    const auto over = formula_.over(coordinates_over({p.low.x, p.high.x}, {p.low.y, p.high.y}));
    const auto in_middle = formula_.over(coordinates_over(shape.middle.x, shape.middle.y));
    if (!over || !in_middle) return std::nullopt;
    enclosure found{bound_variation_of(shape, *over, *in_middle), *over, *in_middle};
    if (layers_ != nullptr) bound_by_layers(p, shape, found.bounds);
    return found;
  }

  // Bounds the variation by the field's layers as well, where this bound is less, and sets the
  // variation in the middle to that of the layers there.
  void bound_by_layers(const part& p, const small_part& shape, variation_of_part& bounds) const {
    const auto over =
        layers_->layers_over(coordinates_over({p.low.x, p.high.x}, {p.low.y, p.high.y}));
    const auto in_middle = layers_->layers_over(coordinates_over(shape.middle.x, shape.middle.y));
    if (!over || !in_middle) return;
    bounds.above = std::min(bounds.above, bound_variation_of(*over));
    const double here = bound_variation_of(*in_middle) / direction_slack;
    if (here < infinity) bounds.in_middle = here;
  }

  // True if a value in doubles agrees with the enclosure up to roundings: the two evaluators of a
  // formula check each other. The difference allowed exceeds a formula's loss of digits, and is
  // less than the effect of a misread formula. No bound depends on it.
  static bool agrees(const metric_tensor& m, const tensor_jet& enclosed) {
    const double allowed = 0x1p-20 * std::max(m.m11, m.m22);
    const auto is_near = [&](double x, const interval_jet& j) {
      return x >= j.value.inf() - allowed && x <= j.value.sup() + allowed;
    };
    return is_near(m.m11, enclosed.m11) && is_near(m.m12, enclosed.m12) &&
           is_near(m.m22, enclosed.m22);
  }

  // True if the box is longer along x by the lengths that its enclosure gives, or, without these,
  // by its sides.
  static bool is_wider(const part& p, const tensor_jet& over) {
    const double width = p.high.x - p.low.x, height = p.high.y - p.low.y;
    const auto change = [](const rounded_interval& a) { return std::max(-a.inf(), a.sup()); };
    const double by_x =
        width * std::max({change(over.m11.x), change(over.m12.x), change(over.m22.x)});
    const double by_y =
        height * std::max({change(over.m11.y), change(over.m12.y), change(over.m22.y)});
    const bool tells = by_x < infinity && by_y < infinity && (by_x > 0 || by_y > 0);
    if (!tells) return width >= height;
    return by_x >= by_y;
  }

  outline outline_;
  bounding_box box_;
  const sized_field& formula_;
  const layered* layers_;  // the same field, if it is one of layers
};

// Encloses a metric whose logarithm is linear in each triangle of a mesh.
class background_region {
 public:
  using part = logarithm_triangle;

  background_region(const domain& d, const mesh& background) : outline_(d) {
    for (const triangle& t : background.triangles)
      if (auto made = logarithm_triangle::make(background.sites[t[0]], background.sites[t[1]],
                                               background.sites[t[2]]))
        parts_.push_back(*made);
  }

  const std::vector<part>& first_parts() const { return parts_; }
  bool is_outside(const part& p) const {
    const auto [low_x, high_x] = std::minmax({p.corners[0].x, p.corners[1].x, p.corners[2].x});
    const auto [low_y, high_y] = std::minmax({p.corners[0].y, p.corners[1].y, p.corners[2].y});
    return outline_.misses({low_x, low_y}, {high_x, high_y});
  }
  static std::string place(const part& p) { return coordinates(p.corners[0]); }
  [[gnu::noinline]] static result<variation_of_part> bounds_of(const part& p) {
    const floating_point_scope scope(rounding::upward);
    return p.bounds();
  }
  static std::optional<std::array<part, 2>> halves(const part& p) { return p.halves(); }

 private:
  outline outline_;
  std::vector<part> parts_;
};

// Encloses a graded field in the triangles of its grid.
class graded_domain {
 public:
  using part = graded_region::part;

  graded_domain(const domain& d, const graded_parts& field) : outline_(d), region_(field) {}

  std::vector<part> first_parts() const { return region_.first_parts(); }
  bool is_outside(const part& p) const {
    return outline_.misses(p.box.low, p.box.high) || region_.misses_triangle(p);
  }
  static std::string place(const part& p) { return coordinates(p.box.low); }
  result<variation_of_part> bounds_of(const part& p) const { return region_.bounds_of(p); }
  static std::optional<std::array<part, 2>> halves(const part& p) {
    return graded_region::halves(p);
  }

 private:
  outline outline_;
  graded_region region_;
};

}  // namespace

variation_bounds bound_variation(const domain& d, const metric_field& field) {
  if (const mesh* const background = field.background()) {
    const background_region region(d, *background);
    return halving(region).run();
  }
  if (const auto* const graded = dynamic_cast<const graded_parts*>(&field)) {
    const graded_domain region(d, *graded);
    return halving(region).run();
  }
  const auto* const formula = dynamic_cast<const sized_field*>(&field);
  if (formula == nullptr)
    return {std::nullopt, 0, "it is no formula and not given on a mesh, or was changed since"};
  const formula_region region(d, *formula);
  return halving(region).run();
}

}  // namespace asterism::internal
