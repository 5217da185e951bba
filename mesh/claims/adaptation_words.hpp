// SPDX-License-Identifier: MIT
//
// Returns the words for an adaptation in its mesh's certificate: the request, its files, and the
// results.
#pragma once

#include <string>

#include "asterism/core/export.h"
#include "asterism/mesh/claims/metric_request.hpp"
#include "asterism/mesh/pipeline/adapt_to_metric.hpp"
#include "asterism/mesh/transfer/transfer.hpp"

namespace asterism::internal {

// Refers to the inputs and results of an adaptation.
struct adaptation_wording {
  const metric_request& request;
  const mesh& background;  // with the metric wanted at its vertices
  const solution_metric_report& report;
  const mesh_adaptation_options& options;
  std::string domain;                         // its name; empty: the mesh's own
  const transfer_report* transfer = nullptr;  // null where nothing was brought to the new mesh
  transfer_method how = transfer_method::interpolate;
};

// Enters the words into the certificate, with the areas that regions had before.
ASTERISM_EXPORT void describe_adaptation(adapted_mesh& next, const adaptation_wording& wording);

}  // namespace asterism::internal
