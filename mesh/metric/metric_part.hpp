// SPDX-License-Identifier: MIT
//
// Extracts the part of a metric given on a mesh that one piece of a domain needs, so that a piece
// can be meshed without the rest of it.
#pragma once

#include <memory>
#include <optional>
#include <string>

#include "asterism/core/result.hpp"
#include "asterism/mesh/data/bounding_box.hpp"
#include "asterism/mesh/data/mesh.hpp"
#include "asterism/mesh/data/metric_field.hpp"

namespace asterism::internal {

struct metric_part {
  bounding_box whole;   // of the mesh that this is a part of
  bounding_box window;  // of the piece
  double margin = 0;    // triangles whose boxes come as near as this to the window are there
  double size = 1;      // the tensors are to be divided by its square
  mesh given;           // these triangles in their order, and their vertices
};

// Returns the part around the window, with a margin of an eighth of its longer side. Nothing where
// the field is not one of make_interpolated_field.
std::optional<metric_part> part_of(const metric_field& field, const bounding_box& window);

// Returns the field of the part: at points of the window it equals the whole field bit for bit. It
// fails at a point from which no triangle is within the margin, where the whole field has the
// tensor of a triangle farther away.
std::unique_ptr<metric_field> make_field_of_part(const metric_part& part);

// Returns the part as bytes in this machine's memory format, for a file that exists for one run.
std::string bytes_of(const metric_part& part);
// Reads the part from the bytes of bytes_of. `name` is the file's, for messages.
result<metric_part> metric_part_in(const std::string& bytes, const std::string& name);

}  // namespace asterism::internal
