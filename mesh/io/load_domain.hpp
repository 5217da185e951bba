// SPDX-License-Identifier: MIT
//
// Loads a domain by its name or from its file.
#pragma once

#include <string_view>

#include "asterism/core/export.h"
#include "asterism/core/result.hpp"
#include "asterism/mesh/data/domain.hpp"

namespace asterism {

// Loads `square`, `airfoil` (or `naca0012`), or the file of that path: .poly or .node
// (mesh/io/poly.hpp), .geojson or .json (mesh/io/geojson.hpp), .wkt (mesh/io/wkt.hpp), or a mesh
// file of edges alone (mesh/io/read_mesh.hpp). The domain is as written there: check_domain has yet
// to accept it.
ASTERISM_EXPORT result<domain> load_domain(std::string_view what);

}  // namespace asterism
