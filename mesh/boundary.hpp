// SPDX-License-Identifier: MIT
//
// The boundary of the domain as it is now: the input segments, split into pieces.
//
// Pieces are directed with the domain on their left. Splitting keeps every earlier vertex; when a
// split point is rounded off its segment, the split polygon is the domain from then on.
#pragma once

#include <cstddef>
#include <vector>

#include "asterism/core/result.hpp"
#include "asterism/core/site.hpp"
#include "asterism/mesh/domain.hpp"
#include "asterism/mesh/mesh.hpp"
#include "asterism/mesh/star_kernel.hpp"

namespace asterism {

// One interior angle of the domain at a boundary vertex v, swept counter-clockwise from the ray
// v -> first to the ray v -> last: the pieces v -> first and last -> v bound it.
struct boundary_corner {
  index first = 0, last = 0;
};

class boundary {
 public:
  boundary() = default;

  // `d` must have been accepted by check_domain; a vertex whose segments do not alternate between
  // leaving and entering it is reported as an error all the same.
  static result<boundary> build(const domain& d, const star_kernel& kernel);

  const std::vector<boundary_edge>& pieces() const { return pieces_; }
  // Empty for a site that is not on the boundary.
  const std::vector<boundary_corner>& corners(index v) const;
  bool is_piece(index a, index b) const;

  // Replaces pieces()[piece] = a -> b by a -> m (same place) and m -> b (at the end). `m` is the
  // index of a site not yet on the boundary.
  void split(std::size_t piece, index m);

  // The pieces segment by segment, each chain in the direction of its segment.
  std::vector<boundary_edge> in_order() const;

 private:
  std::vector<boundary_edge> pieces_;
  std::vector<std::vector<boundary_corner>> corners_;  // by site
};

// Whether q lies strictly inside the split polygon; a point on it does not. Exact.
bool strictly_inside(const boundary& b, const std::vector<site>& sites, const star_kernel& kernel,
                     const point& q);

}  // namespace asterism
