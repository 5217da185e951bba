// SPDX-License-Identifier: MIT
//
// Defines the metric wanted on a trimmed patch, with edges near the border as long as the border's:
// where two faces share an edge, one may need it divided more finely than the other's metric asks,
// and with long edges beside short ones a mesher divides the border on and on.
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

  // Returns the tensor with all lengths divided by the length wanted, where that is below 1: of the
  // nearest segment, growing with the distance from it. Entries have 40 binary digits, so that a
  // metric that is constant but for rounding is constant: stars of sites on a common circle are
  // decided at once then, and else only by long exact searches.
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
