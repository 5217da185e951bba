// SPDX-License-Identifier: MIT
//
// Keeps the current boundary of the domain: the input segments, split into subsegments.
//
// Subsegments are directed with the domain on their left. A subsegment of an internal segment is
// stored twice, as a -> b and b -> a, each the other's twin: the boundary of the domain is slit
// open along it. Twins are split together. Splitting keeps every earlier vertex. A split point may
// be rounded off its segment; the split polygon is the domain from then on.
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

// One interior angle of the domain at a boundary vertex v, swept counter-clockwise from the ray v
// -> first to the ray v -> last. The subsegments v -> first and last -> v bound it. At the free end
// of an internal segment first and last are the same, and the corner is the full turn.
struct boundary_corner {
  vertex_index first = 0, last = 0;
};

class boundary {
 public:
  boundary() = default;

  // Builds the boundary of `d`, which must have been accepted by check_domain. Fails, naming the
  // vertex, if inside and outside do not alternate around one.
  static result<boundary> build(const domain& d, const star_predicates& kernel);

  // Returns all subsegments, internal ones in both directions.
  const std::vector<boundary_edge>& subsegments() const { return subsegments_; }
  // Returns the index of the subsegment in the other direction; none unless it is internal.
  std::optional<std::size_t> twin(std::size_t subsegment) const;
  // Returns the corners at v, counter-clockwise; none for a site that is not on the boundary.
  const std::vector<boundary_corner>& corners(vertex_index v) const;
  bool is_subsegment(vertex_index a, vertex_index b) const;

  // Replaces subsegments()[subsegment] = a -> b by a -> m (in its place) and m -> b (at the end).
  // Splits its twin likewise; the twin's second part is then the last subsegment. `m` is the index
  // of a site that is not on the boundary yet.
  void split(std::size_t subsegment, vertex_index m);

  // Returns the subsegments segment by segment, each chain in the direction of its segment,
  // internal ones once.
  std::vector<boundary_edge> in_order() const;

 private:
  // Index of a subsegment's twin (its own if it has none), and whether it runs against its segment.
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

}  // namespace asterism::internal
