// SPDX-License-Identifier: MIT
//
// Has a mesh made again where it has many more or fewer vertices than are wanted.
#pragma once

#include <cstddef>
#include <functional>
#include <string>

#include "asterism/apps/job_input.hpp"
#include "asterism/apps/mesh_job.hpp"
#include "asterism/mesh/pipeline/certified_mesh.hpp"

namespace asterism::apps {

using make_mesh_of_job = std::function<result<certified_mesh>(
    const mesh_job&, const prepared_input&, const cancellation&)>;

// Returns how many vertices the metric of the job is scaled to have. Requires that a number is
// wanted.
std::size_t vertices_aimed_at(const mesh_job& job);

// Replaces the mesh, and the input that led to it, by the one nearest to the vertices wanted that
// is found, all of them certified; leaves them where the number is near enough or none is wanted.
// All that is tried takes a third of the work of a run at most.
void meet_vertex_count(const mesh_job& job, const cancellation& stop, const make_mesh_of_job& make,
                       prepared_input& input, certified_mesh& made);

// Says how many vertices came out, and, where these are not near those wanted, that nothing nearer
// was found.
std::string vertex_count_text(std::size_t wanted, std::size_t delivered);

}  // namespace asterism::apps
