// SPDX-License-Identifier: MIT
//
// Reads polygons of well-known text (WKT). Rules are those of
// mesh/io/geojson.hpp.
#pragma once

#include <filesystem>

#include "asterism/core/result.hpp"
#include "asterism/mesh/data/domain.hpp"

namespace asterism::internal {

// Reads the domain as written: check_domain has yet to accept it.
result<domain> read_wkt(const std::filesystem::path& path);

}  // namespace asterism::internal
