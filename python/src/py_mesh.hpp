// SPDX-License-Identifier: MIT
//
// Holds a mesh for Python.
#pragma once

#include <optional>
#include <string>

#include "asterism/mesh/audit/certificate.hpp"
#include "asterism/mesh/data/mesh.hpp"
#include "asterism/mesh/data/mesh_marks.hpp"
#include "asterism/mesh/io/physical_names.hpp"

namespace asterism::python {

struct py_mesh {
  mesh content;
  bool complete = false, certified = false;
  std::string reason;
  double angle_bound = 0;            // angle bound in degrees, for pictures
  std::optional<certificate> claim;  // of a mesh that was made here, or read beside one
  mesh_marks marks = {};             // parts that must stay when the mesh is adapted
  physical_names names = {};         // names of markers and regions, for files
};

}  // namespace asterism::python
