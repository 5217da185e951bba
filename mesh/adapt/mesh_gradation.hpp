// SPDX-License-Identifier: MIT
//
// Grades the tensors of a triangulation that is being fitted, on its own graph, and makes a field
// of them. Internal to mesh/adapt.
#pragma once

#include <functional>
#include <vector>

#include "asterism/mesh/adapt/working_mesh.hpp"
#include "asterism/mesh/metric/background_metric.hpp"

namespace asterism::internal::adapting {

// Grades the tensors of the nodes to this distortion over an edge of length `unit`.
void grade_mesh(working_mesh& m, double distortion, double unit, const cancellation& stop = {});

// Returns the field of the nodes' tensors, and sets each node's hint to a triangle of it.
background_metric field_of(working_mesh& m);

// Sets each node's hint to a triangle of the field that it is in. Hints of another field lead a
// search across the whole background.
void look_up_anew(working_mesh& m, const background_metric& field);

// Makes all pairs of these nodes' tensors alike, to a part of the greatest distortion they have.
// Calls changed(v, w) for each pair to which other tensors were given.
void clip_distortion_at(working_mesh& m, const std::vector<vertex_index>& nodes, double part,
                        const std::function<void(vertex_index, vertex_index)>& changed);

}  // namespace asterism::internal::adapting
