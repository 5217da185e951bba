// SPDX-License-Identifier: MIT
//
// Names the formats in which meshes are written.
#pragma once

namespace asterism {

// The formats of meshes, pictures and pages.
enum class mesh_format {
  medit,
  vtu,
  svg,
  png,
  pdf,
  html,
  gmsh,
  gmsh2,
  su2,
  node,
  medit_binary,
  sms,
  adcirc
};

}  // namespace asterism
