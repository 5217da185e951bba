// SPDX-License-Identifier: MIT
//
// Grades the tensors of a triangulation that is being fitted, on its own graph, and makes a metric
// field of them. Internal to mesh/adapt.
#pragma once

#include <functional>
#include <vector>

#include "asterism/mesh/adapt/editable_mesh.hpp"
#include "asterism/mesh/metric/background_metric.hpp"

namespace asterism::internal::adapting {

// Grades the tensors of the nodes to this distortion over an edge of length `unit`.
void grade_mesh(editable_mesh& m, double distortion, double unit, const cancellation& stop = {});

// Returns the field of the nodes' tensors, and sets each node's hint to a triangle of it.
background_metric field_of(editable_mesh& m);

// Sets each node's hint to the field's triangle that contains it. Hints of another field would make
// searches cross the whole background.
void look_up_anew(editable_mesh& m, const background_metric& field);

// Clips the tensors of all pairs of these nodes to `part` of the greatest log distortion of a pair.
// Calls changed(v, w) for each pair whose tensors were changed.
void clip_distortion_at(editable_mesh& m, const std::vector<vertex_index>& nodes, double part,
                        const std::function<void(vertex_index, vertex_index)>& changed);

}  // namespace asterism::internal::adapting
