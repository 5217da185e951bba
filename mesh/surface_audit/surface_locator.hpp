// SPDX-License-Identifier: MIT
//
// Proposes, in doubles, the place of a surface nearest to a point. It proves nothing: claims about
// a place are proved elsewhere.
#pragma once

#include <cstdint>
#include <vector>

#include "asterism/mesh/surface_audit/bezier_pieces.hpp"
#include "asterism/mesh/surface_audit/box_tree.hpp"

namespace asterism::internal {

// A place of a piece by its own parameters, from 0 to 1.
struct surface_place {
  std::uint32_t piece = 0;
  double s = 0, t = 0;
};

struct located {
  surface_place at;
  double squared_distance = 0;
};

// Follows Gauss and Newton from a place to a nearest point of its piece. With `beyond`, places up
// to that far outside of its square are allowed, where the polynomials are continued.
located project(const std::vector<bezier_piece>& pieces, surface_place from, const plain_vector& p,
                double beyond = 0);

class surface_locator {
 public:
  // Samples each piece on a grid by its degrees. The pieces must outlive this object.
  explicit surface_locator(const std::vector<bezier_piece>& pieces);

  // Projects from the nearest sample of each of the few nearest pieces.
  located nearest(const plain_vector& p) const;
  const std::vector<bezier_piece>& pieces() const { return *pieces_; }

 private:
  const std::vector<bezier_piece>* pieces_;
  std::vector<surface_place> places_;
  std::vector<plain_vector> samples_;
  box_tree tree_;
};

}  // namespace asterism::internal
