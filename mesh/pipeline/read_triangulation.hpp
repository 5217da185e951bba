// SPDX-License-Identifier: MIT
//
// Reads a mesh that is a triangulation, whoever made it.
#pragma once

#include <string>

#include "asterism/core/result.hpp"
#include "asterism/mesh/io/read_mesh.hpp"
#include "asterism/mesh/pipeline/foreign_mesh.hpp"

namespace asterism::internal {

// Reads a Medit mesh with the metric beside it, or with the identity if it is not wanted or not
// there. Refuses what the auditor finds is no triangulation.
result<adopted_mesh> read_triangulation(const std::string& path, bool metric_wanted);

// Reads a mesh without its metric, sites and triangles as they are in the file. Its notes are those
// of the mesh taken over, too. Refuses what is no triangulation.
result<mesh> read_plain_triangulation(const std::string& path);
// Returns all that the file has, as well.
result<mesh_file> read_plain_mesh_file(const std::string& path);

// Refuses a mesh that is no triangulation; `path` is for the message.
result<adopted_mesh> checked_triangulation(mesh read, const std::string& path);

}  // namespace asterism::internal
