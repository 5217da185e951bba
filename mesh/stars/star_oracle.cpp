// SPDX-License-Identifier: MIT
#include "asterism/mesh/stars/star_oracle.hpp"

#include "asterism/mesh/numerics/constructions.hpp"
#include "asterism/mesh/stars/visibility.hpp"

namespace asterism::internal {

sign site_oracle::orientation(vertex_index u, vertex_index v, vertex_index w) const {
  const auto& s = *sites_;
  return kernel_->orientation(s[u].position, s[v].position, s[w].position);
}

// Compares positions lexicographically, which on a line is the order along it.
bool site_oracle::same_direction(vertex_index v, vertex_index w, vertex_index u) const {
  return precedes(v, w) == precedes(v, u);
}

bool site_oracle::nearer_on_ray(vertex_index v, vertex_index near, vertex_index far) const {
  const auto& s = *sites_;
  return strictly_between(s[v].position, s[near].position, s[far].position);
}

bool site_oracle::edge_test(vertex_index v, vertex_index w, vertex_index x, vertex_index y) const {
  const auto& s = *sites_;
  const auto ask = [&] { return kernel_->edge_test(s[v], s[w], s[x], s[y]); };
  return memory_ == nullptr ? ask() : memory_->recall(v, w, x, y, ask);
}

bool site_oracle::visible(vertex_index v, vertex_index w) const {
  return sees(*boundary_, *sites_, *kernel_, v, w, near_);
}

bool site_oracle::crosses(vertex_index v, vertex_index w, vertex_index a, vertex_index b) const {
  if (v == a || v == b || w == a || w == b) return false;
  const auto& s = *sites_;
  return properly_cross(*kernel_, s[v].position, s[w].position, s[a].position, s[b].position);
}

double site_oracle::squared_distance(vertex_index v, vertex_index w) const {
  const site& s = (*sites_)[v];
  return asterism::internal::squared_distance(s, (*sites_)[w].position);
}

bool site_oracle::precedes(vertex_index v, vertex_index w) const {
  return lexicographically_less((*sites_)[v].position, (*sites_)[w].position);
}

}  // namespace asterism::internal
