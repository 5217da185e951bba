// SPDX-License-Identifier: MIT
//
// Meshes with longer edges than asked for, all by the same factor: the squared lengths of the
// metric are divided by a power of two, which loses nothing, and multiplied again afterwards.
#pragma once

#include "asterism/core/result.hpp"
#include "asterism/mesh/data/metric_field.hpp"
#include "asterism/mesh/data/options.hpp"
#include "asterism/mesh/data/outcome.hpp"

namespace asterism::internal {

// A field whose squared lengths are divided by 2^halvings: each halves the number of sites.
class coarser_field : public metric_field {
 public:
  // `field` must outlive it.
  coarser_field(const metric_field& field, int halvings) : field_(&field), halvings_(halvings) {}
  // Fails where the field does, and where the tensor would leave the range of normal doubles.
  result<metric_tensor> at(const point& q) const override;

 private:
  const metric_field* field_;
  int halvings_;
};

// Measures all lengths and tensors of an outcome made in a coarser field as the field itself does.
void restore_lengths(int halvings, mesh_outcome& outcome);

// With halvings, turns the outcome of a coarser mesh into one of what was asked: not complete, with
// the triangles that are too large counted and the size that was delivered. How many sites would
// have been wanted is told from those there are, unless the fill was stopped and more were to come.
void report_coarser(int halvings, bool fill_stopped, const mesh_options& options,
                    mesh_outcome& outcome);

}  // namespace asterism::internal
