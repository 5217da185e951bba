// SPDX-License-Identifier: MIT
//
// Collects the contents of a page about a mesh (mesh/draw/report.hpp).
#pragma once

#include <string>

#include "arguments.hpp"
#include "asterism/mesh/draw/report.hpp"
#include "py_mesh.hpp"

namespace asterism::python {

// Returns the page's part about the mesh itself: its certificate, and the certificate's source.
report_facts facts_of(const py_mesh& m, const std::string& title);

}  // namespace asterism::python
