// SPDX-License-Identifier: MIT
//
// The sites near enough to matter to a star, in a tree of boxes.
//
// How near a site w must be depends on its own metric: with |w|_v the metric distance of w as v
// sees it and sigma^2 the largest eigenvalue of M_w^-1 M_v, or 1 if that is more, a site with
//   |w|_v > (1 + sigma) reach
// is accepted in no gap of the star (docs/math/certificate.md, section 4.3). A box bounds |w|_v
// from below and sigma from above for all its sites at once; rounding only ever keeps a site.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

#include "asterism/core/site.hpp"
#include "asterism/mesh/domain.hpp"

namespace asterism::audit_detail {

class site_tree {
 public:
  // Finite positions, positive definite metrics. The sites must outlive the tree.
  explicit site_tree(const std::vector<site>& sites);

  // All sites, near ones near each other.
  const std::vector<index>& order() const { return order_; }

  // Calls visit(w) for each site that is not certainly too far from v, in an order that depends on
  // the sites alone; v itself may be among them. `reach` in the metric of v, at least the distance
  // to x, to y and to the bisectors in the middle direction of each gap; infinite: all sites.
  template <class Visit>
  void visit_near(const site& v, double reach, const Visit& visit) const;

 private:
  static constexpr std::size_t leaf_size = 8;
  static constexpr std::size_t most_depth = 64;  // nodes are halved

  // The sites order_[first .. last), in a box. Every metric M_w among them is at least
  // inverse^-1 / spread_squared, as quadratic forms.
  struct node {
    point low, high;
    metric_tensor inverse;
    double determinant_below = 0;  // of `inverse`
    double spread_squared = 0;     // infinite where not known
    std::size_t first = 0, last = 0;
    std::size_t right = 0;  // the left child follows its parent; no right child: a leaf
  };
  // The centre of a star, and how far it reaches.
  struct centre {
    point at;
    metric_tensor metric;
    double determinant_below = 0, reach = 0;
  };

  void build(std::size_t first, std::size_t last, const std::vector<site>& sites);
  void bound_leaf(node& n, const std::vector<site>& sites) const;
  void bound_parent(node& n, const node& left, const node& right) const;
  static centre centre_of(const site& v, double reach);
  // (1 + sigma) reach for all sites of the node, from above; infinite where not known.
  static double limit(const node& n, const centre& v);
  static bool too_far(const node& n, const centre& v);
  // Is |q - v|_v certainly above the limit?
  static bool beyond(const point& q, const centre& v, double limit);

  std::vector<index> order_;
  std::vector<point> places_;  // in that order
  std::vector<node> nodes_;
};

template <class Visit>
void site_tree::visit_near(const site& v, double reach, const Visit& visit) const {
  const centre c = centre_of(v, reach);
  std::array<std::size_t, most_depth> open;
  std::size_t waiting = 0;
  if (!nodes_.empty()) open[waiting++] = 0;
  while (waiting > 0) {
    const std::size_t self = open[--waiting];
    const node& n = nodes_[self];
    if (too_far(n, c)) continue;
    if (n.right != 0) {
      open[waiting++] = n.right;
      open[waiting++] = self + 1;
      continue;
    }
    const double most = limit(n, c);
    for (std::size_t i = n.first; i < n.last; ++i)
      if (!beyond(places_[i], c, most)) visit(order_[i]);
  }
}

}  // namespace asterism::audit_detail
