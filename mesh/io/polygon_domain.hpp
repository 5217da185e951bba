// SPDX-License-Identifier: MIT
//
// Makes a domain from the polygons of a file, and counts what its reader skipped.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "asterism/core/result.hpp"
#include "asterism/core/site.hpp"
#include "asterism/mesh/data/domain.hpp"

namespace asterism::internal {

using ring = std::vector<point>;

struct polygon {
  std::vector<ring> rings;  // the outer one, then holes; each may end where it begins
  std::optional<int> region;
};

// Number of occurrences of one kind in a file, and the first of them.
struct occurrences {
  std::size_t count = 0;
  std::string first;

  // Counts an occurrence. Describes the first one by describe().
  template <class Describe>
  void add(const Describe& describe) {
    if (count++ == 0) first = describe();
  }
};

struct polygons_read {
  std::vector<polygon> polygons;
  occurrences empty;    // geometries
  occurrences others;   // points and lines
  occurrences heights;  // points with a third coordinate that is not 0, or more
};

// Returns the domain, with notes on what was skipped or dropped: of the polygons, rings that
// enclose nothing and rings that were closed. The rings of polygon k, from 1, have the marker k.
// `name` is the file's. Fails if there is no polygon.
result<domain> domain_of_polygons(const polygons_read& read, const std::string& name);

}  // namespace asterism::internal
