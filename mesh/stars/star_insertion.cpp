// SPDX-License-Identifier: MIT
#include "asterism/mesh/stars/star_insertion.hpp"

#include <algorithm>

namespace asterism::internal {
namespace {

void erase_at(sector& s, std::size_t i) {
  s.neighbours.erase(s.neighbours.begin() + static_cast<std::ptrdiff_t>(i));
}

// True if neighbour i passes INSERTIONTEST against the star without it.
bool stands(const site_oracle& oracle, vertex_index v, const sector& s, std::size_t i) {
  if (s.is_forced(i) || s.size() < 2) return true;
  return accepts(oracle, v, s.neighbours[i], s.neighbours[s.before(i)], s.neighbours[s.after(i)]);
}

// Removes neighbours that fail their test, on the counter-clockwise side of neighbour i, then on
// the clockwise side. The thesis stops while fewer than three sites are left; there a lone second
// neighbour always passes.
void remove_beside(const site_oracle& oracle, vertex_index v, sector& s, std::size_t i) {
  const vertex_index w = s.neighbours[i];
  const auto at_w = [&] {
    std::size_t k = 0;
    while (s.neighbours[k] != w) ++k;
    return k;
  };
  const auto falls = [&](std::size_t next) {
    return s.neighbours[next] != w && !oracle.is_over() && !stands(oracle, v, s, next);
  };
  for (std::size_t next = s.after(at_w()); falls(next); next = s.after(at_w())) erase_at(s, next);
  for (std::size_t next = s.before(at_w()); falls(next); next = s.before(at_w())) erase_at(s, next);
}

void insert_in_gap(const site_oracle& oracle, vertex_index v, sector& s, std::size_t gap,
                   vertex_index w) {
  const std::size_t at = s.neighbours.empty() ? 0 : gap + 1;
  s.neighbours.insert(s.neighbours.begin() + static_cast<std::ptrdiff_t>(at), w);
  remove_beside(oracle, v, s, at);
}

bool fits_gap(const site_oracle& oracle, vertex_index v, const sector& s, std::size_t gap,
              vertex_index w) {
  if (!s.neighbours.empty() &&
      !accepts(oracle, v, w, s.neighbours[gap], s.neighbours[s.after(gap)]))
    return false;
  return oracle.visible(v, w);
}

bool offer_to_sector(const site_oracle& oracle, vertex_index v, sector& s, vertex_index w) {
  placement where = locate(oracle, v, s, w);
  if (where.kind == placement_kind::outside) return false;
  bool changed = false;
  if (where.kind == placement_kind::on_ray) {
    if (s.is_forced(where.at) || !oracle.nearer_on_ray(v, w, s.neighbours[where.at])) return false;
    erase_at(s, where.at);
    changed = true;
    where.at = s.neighbours.empty() ? 0 : s.before(where.at < s.size() ? where.at : 0);
  }
  if (!fits_gap(oracle, v, s, where.at, w)) return changed;
  insert_in_gap(oracle, v, s, where.at, w);
  return true;
}

}  // namespace

bool accepts(const site_oracle& oracle, vertex_index v, vertex_index w, vertex_index y,
             vertex_index x) {
  if (y == x || oracle.orientation(v, y, x) != sign::positive) return true;
  if (oracle.orientation(y, x, w) == sign::positive) return true;
  if (oracle.edges().is_subsegment(y, x)) return false;
  return oracle.edge_test(v, w, y, x);
}

bool offer(const site_oracle& oracle, vertex_index v, star& s, vertex_index w) {
  bool changed = false;
  for (sector& part : s.sectors) changed |= offer_to_sector(oracle, v, part, w);
  return changed;
}

bool would_accept(const site_oracle& oracle, vertex_index v, const star& s, vertex_index w) {
  return std::any_of(s.sectors.begin(), s.sectors.end(), [&](const sector& part) {
    const placement where = locate(oracle, v, part, w);
    if (where.kind == placement_kind::outside) return false;
    if (where.kind == placement_kind::on_ray)
      return !part.is_forced(where.at) && oracle.nearer_on_ray(v, w, part.neighbours[where.at]);
    return fits_gap(oracle, v, part, where.at, w);
  });
}

bool prune(const site_oracle& oracle, vertex_index v, star& s) {
  bool removed = false;
  for (sector& part : s.sectors) {
    for (std::size_t i = 0, in_order = 0; in_order < part.size();) {
      if (oracle.is_over() || stands(oracle, v, part, i)) {
        ++in_order;
        i = part.after(i);
      } else {
        erase_at(part, i);
        removed = true;
        in_order = 0;
        if (i >= part.size()) i = 0;
      }
    }
  }
  return removed;
}

}  // namespace asterism::internal
