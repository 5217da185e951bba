// SPDX-License-Identifier: MIT
//
// Lists for help the possible values of a domain, a metric and a file of a mesh.
#pragma once

#include <string>

namespace asterism::apps {

// Returns the lines of `mesh` on DOMAIN, SPEC and OUT: every metric that has a name, and every kind
// of file.
std::string mesh_values();

// Returns the lines of `convert` on IN and OUT.
std::string convert_values();

}  // namespace asterism::apps
