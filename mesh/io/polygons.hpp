// SPDX-License-Identifier: MIT
//
// Reads polygons as geographers write them: GeoJSON (RFC 7946) and well-known text (WKT).
//
// Read: Polygon and MultiPolygon; of GeoJSON also Feature, FeatureCollection and GeometryCollection
// of these. Rings are closed or not; coordinates beyond the second (heights) are dropped. The rings
// of polygon k, from 1, have the marker k, and where there are several features the polygon of
// feature k is region k. Polygons that share a stretch of boundary have an edge inside there.
// Refused: other kinds of geometry, empty polygons, rings of fewer than three corners, numbers that
// are not finite. Coordinates are taken as they are: degrees are not turned into lengths.
#pragma once

#include <filesystem>
#include <string>

#include "asterism/core/result.hpp"
#include "asterism/mesh/data/domain.hpp"

namespace asterism::internal {

// Reads the domain as written: check_domain has yet to accept it.
result<domain> read_geojson(const std::filesystem::path& path);
result<domain> read_wkt(const std::filesystem::path& path);

}  // namespace asterism::internal
