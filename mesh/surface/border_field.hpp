// SPDX-License-Identifier: MIT
//
// Defines the metric wanted on a trimmed patch, with edges near the border as long as the border's:
// where two faces share an edge, one face may need it divided more finely than the other's metric
// wants, and with long edges beside short ones a mesher would divide the border again and again.
#pragma once

#include <array>
#include <vector>

#include "asterism/mesh/data/domain.hpp"
#include "asterism/mesh/data/metric_field.hpp"

namespace asterism::internal {

class border_field : public metric_field {
 public:
  // Takes the border as the segments of a domain. The field must outlive the object.
  border_field(const metric_field& of, const domain& d);

  // Returns the tensor with all lengths divided by the wanted length, where that is below 1. The
  // wanted length is a multiple of the nearest segment's length, and grows with the distance from
  // that. Entries have 40 binary digits, so that a metric that is constant up to rounding becomes
  // constant: otherwise stars of sites on a common circle would be decided by long exact searches.
  result<metric_tensor> at(const point& q) const override;
  void expect(const std::function<std::vector<point>()>& places) const override {
    of_->expect(places);
  }

 private:
  double wanted_length(const metric_tensor& m, const point& q) const;

  const metric_field* of_;
  std::vector<std::array<point, 2>> border_;
};

}  // namespace asterism::internal
