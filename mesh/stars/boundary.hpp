// SPDX-License-Identifier: MIT
//
// The boundary of the domain as it is now: the input segments, split into subsegments.
//
// Subsegments are directed with the domain on their left. A subsegment of an internal segment is
// two of them, a -> b and b -> a, each the other's twin: the boundary of the domain slit open along
// it. Twins are split together. Splitting keeps every earlier vertex; when a split point is rounded
// off its segment, the split polygon is the domain from then on.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "asterism/core/result.hpp"
#include "asterism/core/site.hpp"
#include "asterism/mesh/data/domain.hpp"
#include "asterism/mesh/data/mesh.hpp"
#include "asterism/mesh/stars/star_predicates.hpp"

namespace asterism::internal {

class neighbourhood;

// One interior angle of the domain at a boundary vertex v, swept counter-clockwise from the ray
// v -> first to the ray v -> last: the subsegments v -> first and last -> v bound it. At the free
// end of an internal segment first and last are the same, and the corner is the full turn.
struct boundary_corner {
  vertex_index first = 0, last = 0;
};

class boundary {
 public:
  boundary() = default;

  // `d` must have been accepted by check_domain; a vertex around which inside and outside do not
  // alternate is reported as an error all the same.
  static result<boundary> build(const domain& d, const star_predicates& kernel);

  // With both directions of internal subsegments.
  const std::vector<boundary_edge>& subsegments() const { return subsegments_; }
  // Index of the same subsegment the other way; none unless it is internal.
  std::optional<std::size_t> twin(std::size_t subsegment) const;
  // Counter-clockwise. Empty for a site that is not on the boundary.
  const std::vector<boundary_corner>& corners(vertex_index v) const;
  bool is_subsegment(vertex_index a, vertex_index b) const;

  // Replaces subsegments()[subsegment] = a -> b by a -> m (same place) and m -> b (at the end), and
  // likewise its twin, whose second part then is the last subsegment. `m` is the index of a site
  // not yet on the boundary.
  void split(std::size_t subsegment, vertex_index m);

  // The subsegments segment by segment, each chain in the direction of its segment, internal ones
  // once.
  std::vector<boundary_edge> in_order() const;

 private:
  // Of each subsegment: where its twin is (itself if none), and whether it runs against its
  // segment.
  struct companion {
    std::size_t twin = 0;
    bool backward = false;
  };

  void add_subsegment(const boundary_edge& subsegment, bool backward);
  void split_one(std::size_t subsegment, vertex_index m);

  std::vector<boundary_edge> subsegments_;
  std::vector<companion> companions_;
  std::vector<std::vector<boundary_corner>> corners_;  // by site
};

// Whether q lies strictly inside the split polygon; a point on a subsegment, internal or not, does
// not. Exact. Linear in the number of subsegments, or of those a ray from q meets when there is a
// neighbourhood.
bool strictly_inside(const boundary& b, const std::vector<site>& sites,
                     const star_predicates& kernel, const point& q,
                     const neighbourhood* near = nullptr);

}  // namespace asterism::internal
