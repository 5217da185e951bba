// SPDX-License-Identifier: MIT
#include "asterism/mesh/metric/sized_field.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "asterism/kernels/filtered_kernel.hpp"
#include "asterism/mesh/support/tensor_text.hpp"

namespace asterism::internal {
namespace {

bool has_extent(double half_unit, const point& origin) {
  return half_unit > 0 && std::isfinite(half_unit) && std::isfinite(origin.x + origin.y);
}

double half_of_longer_side(const bounding_box& box) {
  return std::max(box.high.x / 2 - box.low.x / 2, box.high.y / 2 - box.low.y / 2);
}

}  // namespace

result<metric_tensor> checked_tensor(const point& q, const metric_tensor& m) {
  const bool finite = std::isfinite(m.m11) && std::isfinite(m.m12) && std::isfinite(m.m22);
  if (finite && filtered_kernel().is_positive_definite(m)) return m;
  if (!std::isfinite(q.x) || !std::isfinite(q.y))
    return error{
        "the metric is needed at a point beyond the range of doubles: the domain's coordinates are "
        "too large for it; use another unit, in which they are smaller",
        error_code::invalid_metric};
  return error{fmt::format("the metric at {} is not {}: m11 m12 m22 = {}", point_text(q),
                           finite ? "positive definite" : "finite", tensor_text(m)),
               error_code::invalid_metric};
}

result<metric_tensor> sized_field::at(const point& q) const {
  const auto raw = unsized(q);
  if (!raw.ok()) return raw.failure();
  const metric_tensor& m = raw.value();
  return checked_tensor(q, {m.m11 / size_squared_, m.m12 / size_squared_, m.m22 / size_squared_});
}

std::optional<tensor_jet> sized_field::over(const plane_jet& at) const {
  const auto raw = unsized_over(at);
  if (!raw) return std::nullopt;
  return tensor_jet{raw->m11 / size_squared_, raw->m12 / size_squared_, raw->m22 / size_squared_};
}

std::optional<tensor_jet> sized_field::unsized_over(const plane_jet&) const { return std::nullopt; }

error bad_metric(std::string_view specification, const std::string& what) {
  return {"metric '" + std::string(specification) + "': " + what, error_code::invalid_metric};
}

std::optional<field_frame> frame_in_the_middle(const bounding_box& box) {
  const point centre{box.low.x / 2 + box.high.x / 2, box.low.y / 2 + box.high.y / 2};
  const field_frame frame{centre, half_of_longer_side(box) / 2};
  if (!has_extent(frame.half_unit, frame.origin)) return std::nullopt;
  return frame;
}

std::optional<field_frame> frame_at_the_corner(const bounding_box& box) {
  const field_frame frame{box.low, half_of_longer_side(box)};
  if (!has_extent(frame.half_unit, frame.origin)) return std::nullopt;
  return frame;
}

}  // namespace asterism::internal
