// SPDX-License-Identifier: MIT
//
// Reads polygons of GeoJSON (RFC 7946).
//
// Read: Polygon and MultiPolygon, and collections of these, within each other too; of GeoJSON
// also Feature and FeatureCollection. The formats define what they contain
// (data/domain_polygon.hpp). Rings are closed or not. The rings of polygon k, from 1, have the
// marker k, and where there are several features the polygons of feature k are region k.
// Polygons that share a part of their boundary have internal edges there. Skipped with a note:
// points and lines, empty geometries, coordinates beyond the second, rings without area and
// polygons whose outer ring has none. Refused: files without a polygon, other kinds of geometry,
// numbers that are not finite. Coordinates are taken as they are: degrees are not turned into
// lengths.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "asterism/core/result.hpp"
#include "asterism/mesh/data/domain.hpp"

namespace asterism::internal {

// Reads the domain as written: check_domain has yet to accept it.
result<domain> read_geojson(const std::filesystem::path& path);

// Reads GeoJSON from a text, which messages call `name`.
result<domain> parse_geojson(std::string_view text, const std::string& name);

}  // namespace asterism::internal
