// SPDX-License-Identifier: MIT
#include "asterism/mesh/metric/unit_frame.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "asterism/mesh/numerics/scaled_tensor.hpp"

namespace asterism::internal {
namespace {

constexpr int ordinary_side = 32, ordinary_length = 64;

}  // namespace

point unit_frame::inward(const point& q) const {
  return {std::scalbn(q.x, -coordinates_), std::scalbn(q.y, -coordinates_)};
}
point unit_frame::outward(const point& q) const {
  return {std::scalbn(q.x, coordinates_), std::scalbn(q.y, coordinates_)};
}
metric_tensor unit_frame::inward(const metric_tensor& m) const {
  return times_power_of_two(m, 2 * coordinates_ - squares_);
}
metric_tensor unit_frame::outward(const metric_tensor& m) const {
  return times_power_of_two(m, squares_ - 2 * coordinates_);
}
double unit_frame::length_outward(double length) const {
  const double root = squares_ % 2 == 0 ? 1 : std::numbers::sqrt2;
  return std::scalbn(length * root, (squares_ - (squares_ % 2 == 0 ? 0 : 1)) / 2);
}

unit_frame unit_frame::choose(const domain& d, const metric_field& field, bool lengths_are_free) {
  const bounding_box box = d.box();
  // Computes half of the extent, as the extent of a box may overflow.
  const double half = std::max(box.high.x / 2 - box.low.x / 2, box.high.y / 2 - box.low.y / 2);
  if (!(half > 0)) return {};
  const int side = std::ilogb(half) + 1;
  int length = 0;
  if (lengths_are_free) {
    const auto metric = field.at(d.vertices[0]);
    if (!metric) return {};
    const metric_tensor& m = metric.value();
    length = side + static_cast<int>(std::floor(std::ilogb(std::max(m.m11, m.m22)) / 2.0));
  }
  if (std::abs(side) <= ordinary_side && std::abs(length) <= ordinary_length) return {};
  const unit_frame frame(side, 2 * length);
  return frame.is_exact(d, field) ? frame : unit_frame();
}

bool unit_frame::is_exact(const domain& d, const metric_field& field) const {
  return std::all_of(d.vertices.begin(), d.vertices.end(), [&](const point& q) {
    const auto metric = field.at(q);
    return metric && outward(inward(q)) == q && outward(inward(metric.value())) == metric.value();
  });
}

domain unit_frame::inward(domain d) const {
  for (point& q : d.vertices) q = inward(q);
  for (point& q : d.holes) q = inward(q);
  for (region_point& r : d.regions) r.at = inward(r.at);
  for (domain_curve& c : d.curves) {
    c.centre = inward(c.centre);
    for (point& q : c.control) q = inward(q);
  }
  return d;
}

void unit_frame::outward(mesh& m) const {
  for (site& s : m.sites) s = {outward(s.position), outward(s.metric)};
}

result<metric_tensor> framed_field::at(const point& q) const {
  const point there = frame_->outward(q);
  auto given = field_->at(there);
  if (!given) return given;
  const metric_tensor m = frame_->inward(given.value());
  if (frame_->outward(m) == given.value()) return m;
  return error{
      fmt::format("the metric at ({}, {}) is ({}, {}, {}): over a domain of this size lengths in "
                  "it leave the "
                  "range of doubles",
                  there.x, there.y, given.value().m11, given.value().m12, given.value().m22),
      error_code::invalid_metric};
}

void framed_field::expect(const std::function<std::vector<point>()>& places) const {
  field_->expect([&] {
    std::vector<point> there = places();
    for (point& q : there) q = frame_->outward(q);
    return there;
  });
}

}  // namespace asterism::internal
