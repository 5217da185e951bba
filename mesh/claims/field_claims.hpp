// SPDX-License-Identifier: MIT
//
// Checks whether the tensors of a mesh are those of the metric that was asked for, as the caller or
// the certificate states it.
#pragma once

#include <memory>
#include <optional>
#include <string>

#include "asterism/core/result.hpp"
#include "asterism/mesh/audit/certificate.hpp"
#include "asterism/mesh/claims/field_check.hpp"
#include "asterism/mesh/data/domain.hpp"
#include "asterism/mesh/data/mesh.hpp"
#include "asterism/mesh/data/metric_field.hpp"

namespace asterism::internal {

// A metric as it was asked for in words.
struct metric_wording {
  std::string name;  // as --metric takes it
  double size = 1;
  std::optional<double> gradation;
  std::string domain = {};     // the name of what is meshed: numbers at vertices may be of it
  std::string sizes = "none";  // at places, as text_of(size_wishes) has them

  friend bool operator==(const metric_wording&, const metric_wording&) = default;
};

// Makes a metric of the sizes asked for, graded as it was. `shape` is the domain as meshed, curves
// divided: formulas are placed in its box, local sizes at its segments, and gradation uses its
// width.
result<std::unique_ptr<metric_field>> field_of(const metric_wording& asked, const domain& shape);

// Returns the words in which a certificate states the metric asked for. Fails,
// with a reason in half a sentence, where size, gradation or local sizes cannot be
// read.
result<metric_wording> wording_in(const certificate& claim);

// Returns the domain in whose box the metric's formulas were placed: the certificate's own domain,
// or, for a piece, the box of the whole domain, which the certificate states. None if there is no
// domain.
std::optional<domain> placed_in(const certificate& claim);

// Makes the metric that a mesh's certificate names, if the mesh is delivered in it. Fails, with
// half a sentence, if the mesh is delivered in another metric, the metric was given as numbers, or
// cannot be made again.
result<std::unique_ptr<metric_field>> field_in(const certificate& claim);

// Compares the tensor of every vertex with the metric that the certificate states was asked for,
// or, where another metric was delivered, compares the report of its distance. A tensor may be off
// by 2^-40 of itself: libraries of elementary functions differ in the last places. Nothing is
// checked of a mesh that is not the certificate's, by its fingerprint.
field_check check_field(const mesh& subject, const certificate& claim);

// Compares the tensor of every vertex with a metric. `apart` is set to the distance, with the
// triangles below the bound in that metric.
field_check check_against(const mesh& subject, const metric_field& wanted,
                          std::optional<double> angle_bound);

}  // namespace asterism::internal
