// SPDX-License-Identifier: MIT
//
// The sites near enough to matter to a star, in a tree of boxes.
//
// How near a site w must be depends on its own metric: with |w|_v the metric distance of w as v
// sees it and sigma^2 the largest eigenvalue of M_w^-1 M_v, a site with
//   |w|_v > (1 + sigma) radius  and  |w|_v > (2 + sigma) longest
// is accepted in no gap of the star (docs/math/certificate.md, section 4.3). A box bounds |w|_v
// from below and sigma from above for all its sites at once, by rigorous arithmetic.
#pragma once

#include <vector>

#include "asterism/core/site.hpp"
#include "asterism/mesh/audit_number.hpp"
#include "asterism/mesh/domain.hpp"

namespace asterism::audit_detail {

// Both in the metric of the star's centre; infinite when nothing can be said.
struct star_reach {
  double radius = 0;   // at least 1 / s in the middle direction of each gap
  double longest = 0;  // at least the length of each edge at a gap
};

class site_tree {
 public:
  // Finite positions, positive definite metrics. Keeps no reference.
  explicit site_tree(const std::vector<site>& sites);

  // The sites that are not certainly too far from v, ascending; v itself may be among them.
  std::vector<index> near(const site& v, const star_reach& reach) const;

 private:
  // The sites order_[first .. last), in a box, and ranges of their inverse tensors.
  struct node {
    std::size_t first = 0, last = 0;
    std::size_t right = 0;  // the left child follows its parent; no right child: a leaf
    point low, high;
    double inverse11 = 0, inverse22 = 0;           // upper bounds
    double inverse12_low = 0, inverse12_high = 0;  //
    double inverse_determinant = 0;                // lower bound
  };

  void bound(node& n, const std::vector<site>& sites) const;
  void build(std::size_t first, std::size_t last, const std::vector<site>& sites);
  static bool too_far(const node& n, const site& v, const star_reach& reach);

  std::vector<index> order_;
  std::vector<node> nodes_;
};

}  // namespace asterism::audit_detail
