// SPDX-License-Identifier: MIT
//
// Makes the edges of meshes longer or shorter than asked for, all by the same factor. Squared
// lengths of the metric are divided by a power of two, which is exact, and multiplied again
// afterwards.
#pragma once

#include "asterism/core/result.hpp"
#include "asterism/mesh/data/metric_field.hpp"
#include "asterism/mesh/data/options.hpp"
#include "asterism/mesh/data/outcome.hpp"

namespace asterism::internal {

// Divides the squared lengths of a field by 2^halvings. Each halving halves the number of sites;
// halvings below 0 double it.
class coarser_field : public metric_field {
 public:
  // `field` must outlive this object.
  coarser_field(const metric_field& field, int halvings) : field_(&field), halvings_(halvings) {}
  // Returns the field's tensor divided by 2^halvings. Fails where the field does, and where the
  // tensor would leave the range of normal doubles.
  result<metric_tensor> at(const point& q) const override;

 private:
  const metric_field* field_;
  int halvings_;
};

// Converts the lengths and tensors of an outcome made in a coarser field to those of the field
// itself.
void restore_lengths(int halvings, mesh_outcome& outcome);

// Converts the outcome of a coarser mesh into one for the size asked for; does nothing without
// halvings. The outcome is then not complete, and has the number of triangles that are too large
// and the length factor delivered. The number of sites that the wanted size takes is estimated from
// its own, unless the fill was stopped before its end.
void report_coarser(int halvings, bool fill_stopped, const mesh_options& options,
                    mesh_outcome& outcome);

}  // namespace asterism::internal
