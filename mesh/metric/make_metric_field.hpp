// SPDX-License-Identifier: MIT
//
// Makes a metric field from its specification, a name or three formulas, and lists the names.
#pragma once

#include <memory>
#include <string_view>
#include <vector>

#include "asterism/core/export.h"
#include "asterism/core/result.hpp"
#include "asterism/mesh/data/bounding_box.hpp"
#include "asterism/mesh/data/metric_field.hpp"

namespace asterism {

// Describes a metric that has a name: a row of help and manual.
struct metric_name {
  std::string_view name;       // what comes before the colon
  std::string_view arguments;  // with their colon; those in brackets may be left out
  std::string_view sentence;   // what the metric does, with the arguments' defaults
};

// Returns every metric that has a name, in the order in which help and errors list them.
ASTERISM_EXPORT std::vector<metric_name> metric_names();

// Makes the field. `specification` is what --metric takes: one of metric_names(), with its
// arguments. docs/manual/metrics.md has the formulas. `box` is that of the domain: all but
// `identity` and `expr` are placed in it and scaled to it. `size` divides the metric by size^2, so
// that an edge of length `size` measured in the field as given gets metric length 1; it must be
// positive and finite.
ASTERISM_EXPORT result<std::unique_ptr<metric_field>> make_metric_field(
    std::string_view specification, const bounding_box& box, double size = 1);

}  // namespace asterism
