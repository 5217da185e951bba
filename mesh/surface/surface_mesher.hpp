// SPDX-License-Identifier: MIT
//
// Meshes surfaces: each patch in its plane of parameters, in the metric of its curvature, by the
// mesher of the plane. Sides that two patches share are divided once. The auditor in space bounds
// the distances, the metric is refined where one is beyond the chord asked for, and the patch is
// meshed again. It proves nothing itself: surface_audit/shell_audit.hpp does.
#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "asterism/core/result.hpp"
#include "asterism/mesh/data/options.hpp"
#include "asterism/mesh/data/surface.hpp"
#include "asterism/mesh/data/surface_shell.hpp"
#include "asterism/mesh/surface/surface_mesh_options.hpp"

namespace asterism::internal {

struct surface_mesh {
  surface_shell shell;
  bool complete = false;  // planes complete, sides agreed, distances within the chord
  std::string reason;     // half a sentence, why not
  std::size_t rounds = 0;
  double angle_bound = 0;          // degrees, that all plane meshes were made with
  std::vector<std::string> notes;  // what was given up, a sentence each
};

// Makes the mesh. Fails if the surface is refused, or a plane mesh cannot be begun.
result<surface_mesh> make_surface_mesh(const surface& s, const surface_mesh_options& options);

}  // namespace asterism::internal
