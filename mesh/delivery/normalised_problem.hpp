// SPDX-License-Identifier: MIT
//
// Scales domain and field from the caller's units into the unit frame, and the outcome
// back.
#pragma once

#include "asterism/mesh/data/domain.hpp"
#include "asterism/mesh/data/metric_field.hpp"
#include "asterism/mesh/data/options.hpp"
#include "asterism/mesh/data/outcome.hpp"
#include "asterism/mesh/metric/unit_frame.hpp"

namespace asterism::internal {

// Holds the domain and the field in the unit frame. `field` must outlive this object.
class normalised_problem {
 public:
  normalised_problem(const domain& d, const metric_field& field, const mesh_options& options);
  normalised_problem(const normalised_problem&) = delete;
  normalised_problem& operator=(const normalised_problem&) = delete;

  const unit_frame& frame() const { return frame_; }
  const domain& shape() const { return shape_; }
  const metric_field& field() const {
    return frame_.is_identity() ? field_ : static_cast<const metric_field&>(framed_);
  }
  // Scales an outcome made in the unit frame back into the caller's units.
  void outward(mesh_outcome& outcome) const;

 private:
  const metric_field& field_;
  unit_frame frame_;
  domain shape_;
  framed_field framed_;
};

}  // namespace asterism::internal
