// SPDX-License-Identifier: MIT
//
// Reads Triangle's .poly files.
//
//   # comments run to the end of the line; blank lines do not count
//   <vertices> <dimension: 2> <attributes> <markers: 0 or 1>
//   <number> <x> <y> [attributes] [marker]         one line a vertex
//   <segments> <markers: 0 or 1>
//   <number> <vertex> <vertex> [marker]            one line a segment
//   <holes>
//   <number> <x> <y>                               one line a hole
//   <regions>                                      optional
//   <number> <x> <y> <attribute> [area]            one line a region
//   curves <curves>                                optional (io/poly_curves.hpp)
//
// Numbers start at 0 or at 1 and go up by one. Counts left out at the end of a header line are 0.
// With 0 vertices the vertices are in NAME.node beside NAME.poly. Attributes and the markers of
// vertices are read, checked and not used. An attribute of a region that is no whole number of 32
// bits gives it the least positive number that no other has, with a note and the attribute as its
// name; where it is the only number on its line, it is the largest area, too.
//
// Coordinates are the doubles nearest to the decimals, in any locale. Every error names file, line
// and token, and the fault: no number, not finite, out of range, missing or superfluous. Source:
// https://www.cs.cmu.edu/~quake/triangle.poly.html and triangle.node.html.
#pragma once

#include <filesystem>
#include <map>
#include <string>

#include "asterism/core/result.hpp"
#include "asterism/mesh/data/domain.hpp"

namespace asterism::internal {

// Reads the domain as written, before check_domain. `name` is the path as given.
result<domain> read_poly(const std::filesystem::path& path);

// Returns the names of regions whose attributes are no whole numbers, by their numbers.
std::map<int, std::string> region_names_in_poly(const std::filesystem::path& path);

// Reads a .node file as a domain of vertices without segments.
result<domain> read_nodes(const std::filesystem::path& path);

}  // namespace asterism::internal
