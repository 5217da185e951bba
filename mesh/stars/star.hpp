// SPDX-License-Identifier: MIT
//
// Represents the star of a site v: its neighbours in exact counter-clockwise order.
//
// A site inside the domain has one closed sector, the full turn. A site on the boundary has one
// open sector for each interior angle of the domain at it (more than one where rings touch or
// internal segments meet). The first and last neighbours of an open sector are the ends of the two
// boundary subsegments there. They are *forced*: the boundary is part of every mesh, so no test
// removes them. At the free end of an internal segment both are the same site: the sector is a full
// turn, cut open along the subsegment.
//
// Neighbours y, x in a row (counter-clockwise) make the triangle v, y, x if the gap between them is
// less than 180 degrees, that is orientation(v, y, x) > 0. A wider gap holds no triangle.
//
// Source: the thesis, section 3.3, definitions 1 and 4; the sectors are ours.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "asterism/mesh/data/domain.hpp"
#include "asterism/mesh/stars/star_oracle.hpp"

namespace asterism::internal {

struct sector {
  std::vector<vertex_index> neighbours;  // counter-clockwise; an open sector has at least two
  bool closed = true;

  std::size_t size() const { return neighbours.size(); }
  // True if the sector is open but goes all around: it starts and ends at the same neighbour.
  bool is_slit() const { return !closed && neighbours.front() == neighbours.back(); }
  bool is_forced(std::size_t i) const { return !closed && (i == 0 || i + 1 == size()); }
  // Returns the position after, or before, i. Positions wrap around a closed sector; in an open
  // sector the position must not be past its ends.
  std::size_t after(std::size_t i) const { return i + 1 < size() ? i + 1 : 0; }
  std::size_t before(std::size_t i) const { return i > 0 ? i - 1 : size() - 1; }
  // Returns the number of gaps; gap i lies between neighbours i and after(i).
  std::size_t gaps() const { return closed ? size() : size() - 1; }
  friend bool operator==(const sector&, const sector&) = default;
};

struct star {
  std::vector<sector> sectors;

  bool contains(vertex_index w) const;
  friend bool operator==(const star&, const star&) = default;
};

// Returns the star of v without any sites tested: no neighbours, or the forced ones.
star empty_star(const boundary& edges, vertex_index v);

enum class placement_kind {
  outside,  // in no part of the sector
  on_ray,   // on the ray from v through neighbour `at`
  in_gap    // strictly inside gap `at`; also when the sector has no neighbour yet (at = 0)
};
struct placement {
  placement_kind kind = placement_kind::outside;
  std::size_t at = 0;
};
// Locates w in a sector of v. Exact. Requires w != v.
placement locate(const site_oracle& oracle, vertex_index v, const sector& s, vertex_index w);

// True if gap i of the sector is less than 180 degrees, so that it holds a triangle.
bool holds_triangle(const site_oracle& oracle, vertex_index v, const sector& s, std::size_t gap);

// Returns the gap of v's sector from the neighbour y to the neighbour x next to it.
std::optional<std::size_t> gap_from(const site_oracle& oracle, vertex_index v, const sector& s,
                                    vertex_index y, vertex_index x);

// True if the star of v has the triangle v, y, x (counter-clockwise).
bool has_triangle(const site_oracle& oracle, vertex_index v, const star& s, vertex_index y,
                  vertex_index x);

}  // namespace asterism::internal
