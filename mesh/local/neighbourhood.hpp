// SPDX-License-Identifier: MIT
//
// What is near: the sites and boundary pieces of a growing mesh, so that stars, visibility and
// encroachment are asked of a few instead of all. Follows the mesh's own lists; holds no copy.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "asterism/core/site.hpp"
#include "asterism/mesh/boundary.hpp"
#include "asterism/mesh/domain.hpp"
#include "asterism/mesh/local/box_index.hpp"
#include "asterism/mesh/local/site_index.hpp"

namespace asterism {

class neighbourhood {
 public:
  neighbourhood() = default;
  // Of all sites and pieces.
  neighbourhood(const std::vector<site>& sites, const boundary& edges);

  const site_index& sites() const { return sites_; }
  const box_index& pieces() const { return pieces_; }
  // Pieces by the box of sites that could encroach on them.
  const box_index& influences() const { return influences_; }
  // Around all sites; some may lie outside it by rounding.
  const bounding_box& box() const { return box_; }

  // sites[w] is new.
  void add_site(const std::vector<site>& sites, index w) { sites_.insert(sites, w); }
  // To be called before and after edges.split(piece, ...), with the twin (if any) and the number of
  // pieces there were before.
  void before_split(const std::vector<site>& sites, const boundary& edges, std::size_t piece);
  void after_split(const std::vector<site>& sites, const boundary& edges, std::size_t piece,
                   std::optional<std::size_t> twin, std::size_t first_new);

 private:
  void insert_piece(const std::vector<site>& sites, const boundary& edges, std::size_t piece);
  void remove_piece(const std::vector<site>& sites, const boundary& edges, std::size_t piece);

  bounding_box box_;
  site_index sites_;
  box_index pieces_, influences_;
};

// Around the points that could encroach on the piece between a and b when metrics do not vary
// beyond all measure within its length: a policy of refinement, nothing certain.
bounding_box influence_box(const site& a, const site& b);

// A box around all points within `distance` of the site, as it measures. Not rigorous: rounding
// may leave out points at the rim.
bounding_box box_around(const site& s, double distance);

}  // namespace asterism
