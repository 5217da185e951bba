// SPDX-License-Identifier: MIT
//
// Makes a mesh of a metric that is scaled until as many vertices come out as are wanted.
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

// Makes a mesh of a domain and a metric, as make_certified_mesh does. Called several times.
using mesh_maker =
    std::function<result<certified_mesh>(const mesh_input& input, const mesh_options& options)>;

// A mesh, and what it was made of.
struct counted_mesh {
  mesh_input input;
  certified_mesh made;
};

// Makes the mesh of what prepare_mesh_input returns. Fails as that or `make` does. With
// options.vertices it is made again as meet_vertices does.
ASTERISM_EXPORT result<counted_mesh> make_counted_mesh(const mesh_source& source,
                                                       const mesh_options& options,
                                                       const mesh_maker& make);

// Returns the mesh, of this source, as it is where it is not certified, where no number of vertices
// is wanted, and where it has not over 5 % more or fewer. Otherwise domain and metric are prepared
// and a mesh is made of them at other densities, ten times at most and with a third of the work of
// a run, and the nearest that is certified is returned. A number may lie below what the domain
// takes, or between two that come out: then none is near.
ASTERISM_EXPORT counted_mesh meet_vertices(counted_mesh first, const mesh_source& source,
                                           const mesh_options& options, const mesh_maker& make);

// True if a mesh has as many vertices as are wanted, or at most 5 % more or fewer.
ASTERISM_EXPORT bool is_count_near(std::size_t wanted, std::size_t delivered);

}  // namespace asterism
