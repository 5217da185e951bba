// SPDX-License-Identifier: MIT
//
// Reads a mesh, from any program, that is a triangulation.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "asterism/core/result.hpp"
#include "asterism/mesh/io/read_mesh.hpp"
#include "asterism/mesh/pipeline/foreign_mesh.hpp"

namespace asterism::internal {

// Reads a Medit mesh with the metric beside it, or with the identity if the metric is not wanted or
// not there. Refuses a mesh that the auditor finds to be no triangulation.
result<adopted_mesh> read_triangulation(const std::string& path, bool metric_wanted);

// Reads a mesh without its metric, sites and triangles as they are in the file, with the marks,
// names and fields of its file. Its notes include those of the file's reader. Refuses a mesh that
// is no triangulation.
result<mesh_file> read_plain_mesh_file(const std::string& path);

// True if this name is that of a file with a metric at the vertices of a mesh.
bool is_metric_on_mesh(std::string_view name);

// Reads a metric with the mesh that it is given on. A mesh's file has both. A file of numbers alone
// (.sol, .solb, .mtr) belongs to `mesh`, the mesh of the command, if there is one; else to the mesh
// beside it with its name, .mesh, .meshb, .msh or .vtu in this order.
result<adopted_mesh> read_metric_on_mesh(const std::string& name, const std::string& mesh);

// Returns the metric of a file at the vertices of a mesh file, in their order: the file has numbers
// for these vertices, or is another mesh whose metric is interpolated.
result<std::vector<metric_tensor>> read_metric_at_vertices(const std::string& mesh_file,
                                                           const std::string& metric);

// Refuses a mesh that is no triangulation; `path` is for the message.
result<adopted_mesh> checked_triangulation(mesh read, const std::string& path,
                                           slit_rule slits = slit_rule::refused);

}  // namespace asterism::internal
