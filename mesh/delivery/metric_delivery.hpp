// SPDX-License-Identifier: MIT
//
// Makes a mesh by local changes, in a metric in which stars agree, as near as possible to the one
// wanted (docs/design/adaptation.md). The metric delivered is reported.
//
// Stars disagree where tensors turn or change by much over an edge, whatever the sites. The tensors
// of sites can be chosen, however. They are changed where needed, as little as suffices, and the
// outcome states by how much. The mesh is certified in the metric delivered.
#pragma once

#include <cstddef>
#include <optional>

#include "asterism/mesh/data/domain.hpp"
#include "asterism/mesh/data/metric_field.hpp"
#include "asterism/mesh/data/options.hpp"
#include "asterism/mesh/data/outcome.hpp"
#include "asterism/mesh/delivery/normalised_problem.hpp"
#include "asterism/mesh/metric/background_metric.hpp"

namespace asterism::internal {

// True if the options allow another metric than the one wanted to be delivered.
bool may_adapt(const mesh_options& options);

// Makes meshes in a delivered metric. All references must outlive this object.
class metric_delivery {
 public:
  metric_delivery(const domain& d, const metric_field& field, const mesh_options& options);

  // True if a delivered metric is tried first: with a size, where the metric is given on a mesh.
  bool is_first_choice() const;
  // True if the metric is a formula with a size, and varies by so much over an edge that meshes
  // seldom have agreeing stars in it. Samples the metric, which takes the time of a thousand
  // triangles.
  bool varies_fast();
  // True if the metric is given on a mesh and changes so much over one edge in two hundred,
  // relative to its length, that stars on either side do not agree. Where it jumps there are only
  // few such edges.
  bool jumps() const;
  // True if samples on a lattice show that the metric wants few sites: then to try costs less than
  // to measure how fast the metric varies.
  bool wants_few_sites() const;

  // Makes the whole outcome without the counters. Without a size there will be about `few` sites.
  // Returns none where this led to no certified mesh and was not stopped.
  std::optional<mesh_outcome> make(std::size_t few);

 private:
  bool prepare();
  std::optional<int> halvings(double vertices, std::size_t few) const;
  std::optional<background_metric> wanted_in(const metric_field& coarser, int halved,
                                             const background_metric& sampled) const;
  std::optional<mesh_outcome> in_given_units(mesh_outcome made, int halved);
  void bring_density_near(mesh_outcome& made) const;

  const metric_field& field_;
  const mesh* const given_;  // the background, if the field is given on one of the domain
  const mesh_options& options_;
  normalised_problem image_;
  std::optional<mesh> start_;  // in the frame, as the next
  std::optional<mesh> made_background_;
  const mesh* background_ = nullptr;  // that one, or the given one where the frame changes nothing
  double longest_ = 0;                // edge of the background of a formula, in its metric
  bool prepared_ = false;
};

}  // namespace asterism::internal
