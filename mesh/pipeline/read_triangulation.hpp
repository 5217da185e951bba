// SPDX-License-Identifier: MIT
//
// Reads a mesh that is a triangulation, whoever made it.
#pragma once

#include <string>
#include <string_view>
#include <vector>

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
// Does the same and returns marks, names and fields of the file, too.
result<mesh_file> read_plain_mesh_file(const std::string& path);

// True if a metric of this name is given at the vertices of a mesh.
bool is_metric_on_mesh(std::string_view name);

// Reads the mesh that a metric is given on, with it. A mesh's file has its own. A file of numbers
// alone (.sol, .solb, .mtr) is of the mesh that a command is about, `mesh`, where that is one; else
// of the mesh beside it with its name, .mesh, .meshb, .msh or .vtu in this order.
result<adopted_mesh> read_metric_on_mesh(const std::string& name, const std::string& mesh);

// Returns the metric of a file at the vertices of a mesh file, in their order: numbers for these,
// or another mesh with its metric, which is interpolated.
result<std::vector<metric_tensor>> read_metric_at_vertices(const std::string& mesh_file,
                                                           const std::string& metric);

// Refuses a mesh that is no triangulation; `path` is for the message.
result<adopted_mesh> checked_triangulation(mesh read, const std::string& path,
                                           slit_rule slits = slit_rule::refused);

}  // namespace asterism::internal
