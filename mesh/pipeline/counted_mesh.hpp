// SPDX-License-Identifier: MIT
//
// Makes a mesh of a metric that is scaled until the mesh has the number of vertices wanted.
//
//   const auto made = make_counted_mesh({disc, field, {}}, options, [](const auto& in, const auto&
//   how) {
//     return make_certified_mesh(in.shape, *in.metric.field, how);
//   });
#pragma once

#include <cstddef>
#include <functional>

#include "asterism/core/export.h"
#include "asterism/core/result.hpp"
#include "asterism/mesh/data/options.hpp"
#include "asterism/mesh/pipeline/certified_mesh.hpp"
#include "asterism/mesh/pipeline/mesh_input.hpp"

namespace asterism {

// Function that makes a mesh of a domain and a metric, as make_certified_mesh does. Called several
// times.
using mesh_maker =
    std::function<result<certified_mesh>(const mesh_input& input, const mesh_options& options)>;

// A mesh, and the domain and metric that it was made of.
struct counted_mesh {
  mesh_input input;
  certified_mesh made;
};

// Makes the mesh of the input that prepare_mesh_input returns. Fails as that function or `make`
// does. With options.vertices the mesh is made again as meet_vertices does.
ASTERISM_EXPORT result<counted_mesh> make_counted_mesh(const mesh_source& source,
                                                       const mesh_options& options,
                                                       const mesh_maker& make);

// Makes up to ten meshes of this source at other densities, with a third of the work of a run,
// until is_count_near() is true of the number of vertices. Returns the certified mesh whose number
// is nearest: the number wanted may be below the least number for the domain, or between two
// numbers that are possible. Returns `first` unchanged if it is not certified, if no number is
// wanted, or if its own number is near.
ASTERISM_EXPORT counted_mesh meet_vertices(counted_mesh first, const mesh_source& source,
                                           const mesh_options& options, const mesh_maker& make);

// True if the number of vertices delivered differs from the one wanted by at most 5 % of it.
ASTERISM_EXPORT bool is_count_near(std::size_t wanted, std::size_t delivered);

}  // namespace asterism
