// SPDX-License-Identifier: MIT
//
// Divides the periodic sides of a domain at stations, and adds the points that a mesh of it has
// there.
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <vector>

#include "asterism/core/result.hpp"
#include "asterism/mesh/data/domain.hpp"
#include "asterism/mesh/data/metric_field.hpp"
#include "asterism/mesh/data/outcome.hpp"
#include "asterism/mesh/pipeline/periodic_sides.hpp"

namespace asterism::internal {

// Divides both sides by metric length, as a fill divides segments for edges as long as `unit`, in a
// metric that is at each place at least as fine as those of both sides; leaves them as they are if
// that takes more than `most` points. Fails where the field does.
std::optional<error> divide_by_length(const metric_field& field, double unit, std::size_t most,
                                      periodic_sides& sides);

// The domain with the stations as vertices, so that a mesh has them whatever way it is made.
class periodic_division {
 public:
  periodic_division(const domain& d, const std::vector<periodic_sides>& all);

  const domain& shape() const { return shape_; }
  // Adds stations where the mesh splits a segment of either side: at the split points of the
  // first, or, where it has none between two stations, at those of the second. Returns the number
  // added.
  std::size_t take_splits(const mesh& m, std::vector<periodic_sides>& all) const;
  // Converts the outcome of the divided domain to one of the domain itself, in which stations are
  // split points.
  void restore(mesh_outcome& made) const;

 private:
  void add_vertices(const std::vector<periodic_sides>& all);
  void divide(const domain& d);

  domain shape_;
  vertex_index given_ = 0;                          // vertices of the domain itself
  std::vector<std::vector<vertex_index>> between_;  // on each segment, from its start to its end
  std::vector<vertex_index> segment_of_;            // of the domain, by segment of the shape
  // The vertices of each station on both sides, by pair of sides.
  std::vector<std::vector<std::array<vertex_index, 2>>> station_vertices_;
};

}  // namespace asterism::internal
