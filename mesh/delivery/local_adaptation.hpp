// SPDX-License-Identifier: MIT
//
// Makes one mesh by local changes, in the unit frame: a unit mesh, tensors clipped until stars
// agree, wanted tensors restored (docs/design/adaptation.md). Internal to mesh/pipeline.
#pragma once

#include <cstddef>
#include <optional>

#include "asterism/mesh/data/domain.hpp"
#include "asterism/mesh/data/mesh.hpp"
#include "asterism/mesh/data/metric_field.hpp"
#include "asterism/mesh/data/options.hpp"
#include "asterism/mesh/data/outcome.hpp"
#include "asterism/mesh/metric/background_metric.hpp"

namespace asterism::internal {

// All references must outlive the call.
struct adaptation_job {
  const domain& shape;
  const metric_field& field;
  const mesh_options& options;
  const mesh& start;                // a coarse mesh of the domain
  const background_metric& wanted;  // at the nodes of a background
  bool is_field_itself = false;     // rather than samples of it
  std::size_t count = 0;            // of vertices wanted
};

// Makes the whole outcome without the counters. Returns none where this led to no certified mesh
// and was not stopped.
std::optional<mesh_outcome> adapt_by_local_changes(const adaptation_job& job);

}  // namespace asterism::internal
