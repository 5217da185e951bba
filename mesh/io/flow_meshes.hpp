// SPDX-License-Identifier: MIT
//
// Writes meshes for programs that simulate rivers and coasts: SMS's .2dm and ADCIRC's fort.14.
//
// Both have triangles and strings of nodes along the boundary, one for each part with one marker
// that is not interrupted. There is no metric, and heights are 0.
#pragma once

#include <string>

#include "asterism/mesh/data/mesh.hpp"
#include "asterism/mesh/io/physical_names.hpp"

namespace asterism::internal {

// Returns the contents of a .2dm file: the region of a triangle is its material, the marker of a
// string its number, after its last node. Strings inside the domain are there, too.
std::string sms_text(const mesh& m);

// Returns the contents of a fort.14 file: all strings are land boundaries; closed strings are
// islands, of type 1, and open ones and the string that encloses the mesh are of type 0. A comment
// after each has its marker, or the marker's name. The format has no place for segments inside and
// for regions.
std::string adcirc_text(const mesh& m, const physical_names& names, const std::string& title);

}  // namespace asterism::internal
