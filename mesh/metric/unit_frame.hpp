// SPDX-License-Identifier: MIT
//
// Maps very large and very small domains to images of about unit size, by a power of two, which is
// exact. The mesh is the same as for a domain of ordinary size, and made as fast, since no product
// leaves the range in which doubles decide. If no size is asked for, so that the unit of metric
// length is arbitrary, the metric is scaled to unit size as well.
#pragma once

#include "asterism/core/site.hpp"
#include "asterism/mesh/data/domain.hpp"
#include "asterism/mesh/data/mesh.hpp"
#include "asterism/mesh/data/metric_field.hpp"

namespace asterism::internal {

// A frame. The image of a point x is x / 2^coordinates; squared lengths are divided by 2^squares.
class unit_frame {
 public:
  unit_frame() = default;
  // Chooses the frame: no scaling for a domain of ordinary size (sides from 2^-32 to 2^32 and, when
  // lengths are free, 2^-64 to 2^64 long in the metric), and none where it would not be exact: a
  // vertex or a metric at a vertex would leave the range of normal doubles.
  static unit_frame choose(const domain& d, const metric_field& field, bool lengths_are_free);

  bool is_identity() const { return coordinates_ == 0 && squares_ == 0; }
  point inward(const point& q) const;
  point outward(const point& q) const;
  metric_tensor inward(const metric_tensor& m) const;
  metric_tensor outward(const metric_tensor& m) const;
  double length_outward(double length) const;

  domain inward(domain d) const;
  void outward(mesh& m) const;

 private:
  unit_frame(int coordinates, int squares) : coordinates_(coordinates), squares_(squares) {}
  bool is_exact(const domain& d, const metric_field& field) const;

  int coordinates_ = 0, squares_ = 0;
};

// Field for the image of the domain. Both references must outlive it.
class framed_field : public metric_field {
 public:
  framed_field(const metric_field& field, const unit_frame& frame)
      : field_(&field), frame_(&frame) {}
  // Fails where the field does, and where the scaled tensor would leave the range of normal
  // doubles.
  result<metric_tensor> at(const point& q) const override;
  void expect(const std::function<std::vector<point>()>& places) const override;

 private:
  const metric_field* field_;
  const unit_frame* frame_;
};

}  // namespace asterism::internal
