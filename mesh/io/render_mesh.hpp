// SPDX-License-Identifier: MIT
//
// Makes the files of a mesh without writing them, so that those of a run can be written together.
#pragma once

#include <filesystem>
#include <vector>

#include "asterism/core/result.hpp"
#include "asterism/mesh/data/mesh.hpp"
#include "asterism/mesh/io/file_output.hpp"
#include "asterism/mesh/io/mesh_format.hpp"
#include "asterism/mesh/io/write_options.hpp"

namespace asterism::internal {

// Checks as check_output() does, without creating a file: for outputs that are written next, or
// whose directories check_all_writable() tests together.
result<mesh_format> check_place_of_output(const std::filesystem::path& path);

// Returns NAME.fields.sol for NAME.mesh, NAME.fields.solb for NAME.meshb: the fields on a mesh
// whose metric is beside it.
std::filesystem::path fields_path(const std::filesystem::path& mesh_path);

// Returns the files that write_mesh would write, for write_files. The mesh must outlive them: long
// ones are made from it while they are written. Fails as write_mesh does.
result<std::vector<output_file>> render_mesh(const std::filesystem::path& path, const mesh& m,
                                             const write_options& options);

}  // namespace asterism::internal
