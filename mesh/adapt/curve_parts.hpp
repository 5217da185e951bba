// SPDX-License-Identifier: MIT
//
// Divides the faces of a mesh into parts along a Hilbert curve. Internal to mesh/adapt.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "asterism/mesh/adapt/editable_mesh.hpp"
#include "asterism/mesh/support/free_memory.hpp"
#include "asterism/mesh/support/prefetch.hpp"

namespace asterism::internal::adapting {

// The faces of a part follow each other on the curve. All parts have about equally many, as the
// curve is cut at quantiles of a sample. The number of threads changes nothing.
class curve_parts {
 public:
  // Takes the box through which the curve runs, and the number of parts; there is one for 0, too.
  curve_parts(const std::vector<node>& nodes, const std::vector<face>& faces,
              const bounding_box& box, std::size_t parts);

  std::size_t count() const { return bounds_.size() + 1; }
  // Returns the part of a face; count() for one that does not exist.
  std::uint32_t of(vertex_index t) const { return part_[t]; }
  void prefetch(vertex_index t) const { internal::prefetch(&part_[t]); }
  // Frees the parts of faces, 4 bytes each; of() must not be called any more.
  void forget_faces() { free_memory(part_); }
  // Returns the part that contains the point's place on the curve. Near the edges between parts the
  // face at the point may be in another part.
  std::uint32_t near(const point& q) const;

 private:
  void divide_curve(const std::vector<std::uint64_t>& places, std::size_t parts);
  std::uint32_t at(std::uint64_t place) const;
  bool is_in(std::uint64_t place, std::uint32_t part) const;

  bounding_box box_;
  std::vector<std::uint64_t> bounds_;  // places on the curve between parts
  std::vector<std::uint32_t> part_;    // of each face
};

}  // namespace asterism::internal::adapting
