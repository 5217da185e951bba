// SPDX-License-Identifier: MIT
#include "asterism/mesh/star_oracle.hpp"

#include "asterism/mesh/constructions.hpp"
#include "asterism/mesh/visibility.hpp"

namespace asterism {

sign site_oracle::orientation(index u, index v, index w) const {
  const auto& s = *sites_;
  return kernel_->orientation(s[u].position, s[v].position, s[w].position);
}

// On a line the lexicographic order is the order along it.
bool site_oracle::same_direction(index v, index w, index u) const {
  return precedes(v, w) == precedes(v, u);
}

bool site_oracle::nearer_on_ray(index v, index near, index far) const {
  const auto& s = *sites_;
  return strictly_between(s[v].position, s[near].position, s[far].position);
}

bool site_oracle::edge_test(index v, index w, index x, index y) const {
  const auto& s = *sites_;
  const auto ask = [&] { return kernel_->edge_test(s[v], s[w], s[x], s[y]); };
  return memory_ == nullptr ? ask() : memory_->recall(v, w, x, y, ask);
}

bool site_oracle::visible(index v, index w) const {
  return sees(*boundary_, *sites_, *kernel_, v, w, near_);
}

bool site_oracle::crosses(index v, index w, index a, index b) const {
  if (v == a || v == b || w == a || w == b) return false;
  const auto& s = *sites_;
  return properly_cross(*kernel_, s[v].position, s[w].position, s[a].position, s[b].position);
}

double site_oracle::squared_distance(index v, index w) const {
  const site& s = (*sites_)[v];
  return asterism::squared_distance(s, (*sites_)[w].position);
}

bool site_oracle::precedes(index v, index w) const {
  return lexicographically_less((*sites_)[v].position, (*sites_)[w].position);
}

}  // namespace asterism
