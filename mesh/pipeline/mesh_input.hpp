// SPDX-License-Identifier: MIT
//
// Makes the input of a mesh: the domain, with chords for its curves, and the metric, scaled as
// asked for. Each depends on the other: chords are as long as edges in the metric, and a metric may
// be placed in the box of the domain that is meshed.
#pragma once

#include <cstddef>
#include <functional>
#include <memory>
#include <optional>

#include "asterism/core/export.h"
#include "asterism/core/result.hpp"
#include "asterism/mesh/data/bounding_box.hpp"
#include "asterism/mesh/data/domain.hpp"
#include "asterism/mesh/data/metric_field.hpp"
#include "asterism/mesh/data/options.hpp"
#include "asterism/mesh/pipeline/scaled_metric.hpp"

namespace asterism {

// Function that makes the metric for edges of this length, for a domain with this box. Called
// several times.
using field_in_box =
    std::function<result<std::unique_ptr<metric_field>>(double size, const bounding_box& box)>;

// A domain and a metric as they are given, for a mesh of any density.
struct mesh_source {
  domain shape;  // as check_domain leaves it, its curves divided in any way
  field_in_box metric;
  scale_demand scale = {};
  std::optional<double> chord_tolerance = {};  // default: a part of each chord
  std::size_t random_points = 0;               // added to the domain's vertices
};

// The domain and the metric for one density.
struct mesh_input {
  domain shape;
  scaled_metric metric;
  std::size_t given = 0;  // vertices of the domain before the first rows of layers
};

// Scales the metric by the sizes or the number of vertices that the source demands; with
// options.vertices to the complexity of `density` times that number of vertices. Where only sizes
// at places are demanded, the size elsewhere is size_where_none_is_wished. With options.limit_size
// curves are divided anew for the metric, in at most options.max_sites chords; otherwise for the
// tolerance, if there is one. Then random points are added, by options.seed, and the first rows of
// layers, as long as there are fewer vertices than options.max_sites. Fails as divide_curves_anew,
// add_random_points, make_scaled_metric and with_layer_rows do.
ASTERISM_EXPORT result<mesh_input> prepare_mesh_input(const mesh_source& source,
                                                      const mesh_options& options,
                                                      double density = 1);

}  // namespace asterism
