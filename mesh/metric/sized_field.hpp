// SPDX-License-Identifier: MIT
//
// Defines the common base of fields that do not change another field: applies the size, checks
// every tensor, and encloses those of a formula over boxes.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <string_view>

#include "asterism/mesh/data/bounding_box.hpp"
#include "asterism/mesh/data/metric_field.hpp"
#include "asterism/mesh/metric/interval_jet.hpp"

namespace asterism::internal {

// Divides tensors by size^2 and refuses every one that is no metric.
class sized_field : public metric_field {
 public:
  explicit sized_field(double size) : size_squared_(size * size) {}
  result<metric_tensor> at(const point& q) const final;
  // Encloses the tensors of the formula, in exact arithmetic, and their derivatives over the points
  // that `at` encloses; nothing where the formula has a part that cannot be enclosed. Requires a
  // floating_point_scope(rounding::upward); several threads may call it.
  std::optional<tensor_jet> over(const plane_jet& at) const;

 protected:
  double size_squared() const { return size_squared_; }

 private:
  virtual result<metric_tensor> unsized(const point& q) const = 0;
  // Returns an enclosure of the tensors over a box; nothing where none is known.
  virtual std::optional<tensor_jet> unsized_over(const plane_jet& at) const;

  double size_squared_;
};

using made_field = result<std::unique_ptr<metric_field>>;

// Returns an error "metric 'SPECIFICATION': WHAT".
error bad_metric(std::string_view specification, const std::string& what);

// Returns `m` if it is finite and positive definite (exactly tested); else an error that names q
// and m.
result<metric_tensor> checked_tensor(const point& q, const metric_tensor& m);

// Coordinates in which a field is isotropic or layered: u = (q - origin) / unit. Computed from
// halves, since the extent of a box may overflow.
struct field_frame {
  point origin;
  double half_unit = 0;

  point local(const point& q) const {
    return {(q.x / 2 - origin.x / 2) / half_unit, (q.y / 2 - origin.y / 2) / half_unit};
  }
  // Returns the coordinates of all points of a box.
  plane_jet local(const plane_jet& q) const {
    return {(q.x / 2 - origin.x / 2) / half_unit, (q.y / 2 - origin.y / 2) / half_unit};
  }
};

// Returns coordinates relative to the middle of the box, in halves of its longer side; empty when
// the box has no extent.
std::optional<field_frame> frame_in_the_middle(const bounding_box& box);
// Returns coordinates relative to the lower left corner, in units of the longer side.
std::optional<field_frame> frame_at_the_corner(const bounding_box& box);

}  // namespace asterism::internal
