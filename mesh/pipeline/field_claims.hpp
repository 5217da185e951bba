// SPDX-License-Identifier: MIT
//
// Checks whether the tensors of a mesh are those of the metric its certificate says was asked for.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "asterism/core/result.hpp"
#include "asterism/mesh/audit/certificate.hpp"
#include "asterism/mesh/data/mesh.hpp"
#include "asterism/mesh/data/metric_field.hpp"

namespace asterism::internal {

// Makes the metric asked for again, of the size asked for, graded as it was. Fails, saying why in
// half a sentence, where the certificate does not hold what that takes: a metric on a mesh.
result<std::unique_ptr<metric_field>> field_asked_for(const certificate& claim);

struct field_check {
  bool made = false;    // true if the metric asked for could be made again
  std::string why_not;  // half a sentence on why it could not
  std::vector<std::string> contradictions;
};

// Holds the tensor of every vertex against the metric asked for, or, where the certificate says
// that the mesh is of another, the triangles it lists as low in the one asked for. A tensor may be
// off by 2^-40 of itself: libraries of elementary functions differ in the last places. Nothing is
// checked of a mesh that is not the certificate's, by its fingerprint.
field_check check_field(const mesh& subject, const certificate& claim);

}  // namespace asterism::internal
