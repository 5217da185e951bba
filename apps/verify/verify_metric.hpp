// SPDX-License-Identifier: MIT
//
// Judges the metric of a mesh for `verify`: whether it is the one asked for, exactly or within the
// tolerance.
#pragma once

#include <memory>
#include <optional>
#include <string>

#include "asterism/apps/text/verify_question.hpp"
#include "asterism/core/result.hpp"
#include "asterism/mesh/data/domain.hpp"
#include "asterism/mesh/data/metric_field.hpp"

namespace asterism::apps {

// Makes the metric of --metric, of the size and gradation given or else the certificate's, placed
// in `shape`, or where that is null among the sites.
result<std::unique_ptr<metric_field>> field_named(const verify_options& options,
                                                  const mesh& subject,
                                                  const std::optional<certificate>& claim,
                                                  const domain* shape);

// Judges the tensors of a mesh. The metric is that of --metric, of the size and gradation given or
// else the certificate's, placed in `shape`; without --metric it is the certificate's. Tensors that
// differ must be within --metric-tolerance. Without it they may differ by the certificate's
// tolerance, if it names the same metric, and otherwise not at all. Fails where the metric named
// cannot be made.
result<metric_answer> judge_metric(const verify_options& options, const mesh& subject,
                                   const std::optional<certificate>& claim, const domain* shape);

// Returns "metric: swirl:3, by the certificate, compared at every vertex".
std::string text_of(const metric_answer& answer);

}  // namespace asterism::apps
