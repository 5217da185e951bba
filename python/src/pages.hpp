// SPDX-License-Identifier: MIT
//
// Collects what is told about a mesh on a page (mesh/draw/report.hpp).
#pragma once

#include <string>

#include "arguments.hpp"
#include "asterism/mesh/draw/report.hpp"
#include "py_mesh.hpp"

namespace asterism::python {

// Returns what the mesh itself says: its certificate and where that comes from.
report_facts facts_of(const py_mesh& m, const std::string& title);

}  // namespace asterism::python
