// SPDX-License-Identifier: MIT
//
// Reads NAME.sol, and the header that it shares with NAME.mesh. Works inside read_medit.
#pragma once

#include <filesystem>
#include <optional>

#include "asterism/core/result.hpp"
#include "asterism/mesh/data/mesh.hpp"
#include "asterism/mesh/io/medit_read_options.hpp"
#include "asterism/mesh/io/text_scanner.hpp"

namespace asterism::internal {

// Reads `MeshVersionFormatted 1..3`, `Dimension 2 or 3`. Returns the dimension. If BAMG's bound on
// corners, in degrees, is between these two lines, sets `corner_bound` to it, unless `corner_bound`
// is null.
result<int> read_medit_header(text_scanner& source, std::optional<double>* corner_bound = nullptr);

// Reads one tensor a site of `m` from a .sol file, or from one of BAMG's, NAME.mtr: the number of
// vertices, 1 or 3, and for each a length h, meaning the tensor I/h^2, or m11 m12 m22. One number a
// vertex in a .sol is such a length, too, where a metric is wanted. If no metric is required, a
// file with other data than tensors is ignored. Returns whether there was a metric; else every site
// has the identity.
result<bool> read_medit_solution(const std::filesystem::path& path, mesh& m,
                                 const medit_read_options& options);

// True if the file exists and holds one symmetric tensor for each vertex: a metric by itself.
bool holds_tensors(const std::filesystem::path& path);

}  // namespace asterism::internal
