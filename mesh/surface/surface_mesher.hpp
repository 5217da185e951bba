// SPDX-License-Identifier: MIT
//
// Meshes surfaces: each patch in its plane of parameters, in the metric of its curvature, by the
// mesher of the plane. Sides that two patches have are divided once. What the distances then are is
// bounded by the auditor in space, the metric made finer where one is beyond the chord asked for,
// and the patch made again. It proves nothing itself: surface_audit/shell_audit.hpp does.
#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <string>

#include "asterism/core/result.hpp"
#include "asterism/mesh/data/options.hpp"
#include "asterism/mesh/data/surface.hpp"
#include "asterism/mesh/data/surface_shell.hpp"

namespace asterism::internal {

struct surface_mesh_options {
  double chord = 0;                     // the greatest distance, both ways
  std::optional<double> normal;         // degrees that the normal may turn along an edge
  std::optional<double> longest;        // edge
  double aspect = 100;                  // the greatest ratio of lengths wanted
  std::optional<std::size_t> vertices;  // about; the chord then decides nothing but the verdict
  double angle_bound = 20;
  std::size_t most_rounds = 12;
  std::size_t most_sites = 1'000'000;  // of a patch
  cancellation stop = {};
};

struct surface_mesh {
  surface_shell shell;
  bool complete = false;  // planes complete, sides agreed, distances within the chord
  std::string reason;     // half a sentence, why not
  std::size_t rounds = 0;
};

// Fails where the surface is refused, or a plane mesh could not be begun.
result<surface_mesh> make_surface_mesh(const surface& s, const surface_mesh_options& options);

}  // namespace asterism::internal
