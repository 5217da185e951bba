// SPDX-License-Identifier: MIT
#include "asterism/mesh/pipeline/periodic_continuation.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <map>
#include <numbers>
#include <numeric>
#include <set>
#include <utility>

#include "asterism/core/elementary.hpp"
#include "asterism/mesh/audit/periodic_partners.hpp"

namespace asterism::internal {
namespace {

using partner_list = std::vector<std::array<vertex_index, 2>>;

// Number of rings of triangles that are copied: the metric at a seam is a mean over its neighbours,
// each of which is fitted to four rings at most.
constexpr int rings = 5;

// A turn, by its cosine and sine, then a shift.
struct rigid_map {
  double cosine = 1, sine = 0;
  point shift;

  point image(const point& q) const {
    return {cosine * q.x - sine * q.y + shift.x, sine * q.x + cosine * q.y + shift.y};
  }
  rigid_map inverse() const {
    return {cosine,
            -sine,
            {-(cosine * shift.x + sine * shift.y), -(cosine * shift.y - sine * shift.x)}};
  }
};

// Returns the map of two sides that match. The cosine and the sine of turns by quarters are exact.
rigid_map map_of(const periodic_match& match) {
  constexpr double quarter = 90, half = 180;
  const double quarters = std::nearbyint(match.turn / quarter);
  if (match.turn == quarter * quarters) {
    constexpr std::array<double, 4> sines = {0, 1, 0, -1};
    const auto k = static_cast<std::size_t>(static_cast<int>(quarters) & 3);
    return {sines[(k + 1) % 4], sines[k], match.shift};
  }
  const double angle = match.turn / half * std::numbers::pi;
  return {elementary::cos(angle), elementary::sin(angle), match.shift};
}

class continuation {
 public:
  explicit continuation(const mesh& m) : which_(m.sites.size(), 0) {
    made_.continued.sites = m.sites;
    made_.continued.triangles = m.triangles;
    made_.origin.resize(m.sites.size());
    std::iota(made_.origin.begin(), made_.origin.end(), vertex_index{0});
  }

  // Copies the mesh across both sides of a pair whose second side is the image of the first.
  void across(const partner_list& partners, const rigid_map& map) {
    std::map<vertex_index, vertex_index> to_second, to_first;
    for (const auto& [a, b] : partners) {
      to_second[a] = b;
      to_first[b] = a;
      made_.partners.push_back({a, b, map.cosine, map.sine});
    }
    const auto at_first = near(to_second), at_second = near(to_first);
    for (std::uint64_t& which : which_) which *= 3;
    places_.clear();
    for (std::size_t v = 0; v < which_.size(); ++v)
      places_[{made_.origin[v], which_[v]}] = static_cast<vertex_index>(v);
    copy(at_first, to_second, map, 1);
    copy(at_second, to_first, map.inverse(), 2);
  }

  glued_mesh take() && { return std::move(made_); }

 private:
  // Returns the triangles within some rings of the vertices of a side, copies of such vertices
  // included.
  std::vector<triangle> near(const std::map<vertex_index, vertex_index>& side) const {
    std::vector<char> reached(which_.size(), 0);
    for (std::size_t v = 0; v < reached.size(); ++v)
      reached[v] = side.contains(made_.origin[v]) ? 1 : 0;
    std::vector<triangle> found;
    for (int ring = 0; ring < rings; ++ring) {
      found.clear();
      for (const triangle& t : made_.continued.triangles)
        if (reached[t[0]] != 0 || reached[t[1]] != 0 || reached[t[2]] != 0) found.push_back(t);
      for (const triangle& t : found)
        for (const vertex_index v : t) reached[v] = 1;
    }
    return found;
  }

  void copy(const std::vector<triangle>& strip, const std::map<vertex_index, vertex_index>& partner,
            const rigid_map& by, std::uint64_t digit) {
    for (const triangle& t : strip)
      made_.continued.triangles.push_back({image(t[0], partner, by, digit),
                                           image(t[1], partner, by, digit),
                                           image(t[2], partner, by, digit)});
  }

  // Returns the vertex that is the copy of another: its partner where that exists, or a new one.
  vertex_index image(vertex_index v, const std::map<vertex_index, vertex_index>& partner,
                     const rigid_map& by, std::uint64_t digit) {
    const vertex_index own = made_.origin[v];
    if (const auto other = partner.find(own); other != partner.end())
      if (const auto there = places_.find({other->second, which_[v]}); there != places_.end())
        return there->second;
    const auto next = static_cast<vertex_index>(which_.size());
    const auto [place, is_new] = places_.try_emplace({own, which_[v] + digit}, next);
    if (!is_new) return place->second;
    site moved = made_.continued.sites[v];
    moved.position = by.image(moved.position);
    made_.continued.sites.push_back(moved);
    made_.origin.push_back(own);
    which_.push_back(which_[v] + digit);
    return next;
  }

  glued_mesh made_;
  // Keys, by vertex, that distinguish the copies of one original: one digit to the base of three
  // for each pair, 1 for a copy beyond its second side and 2 for one beyond its first.
  std::vector<std::uint64_t> which_;
  std::map<std::pair<vertex_index, std::uint64_t>, vertex_index> places_;
};

// True if two sides have a vertex in common, where copies may lie one above the other.
bool meet(const partner_list& partners) {
  std::set<vertex_index> first;
  for (const auto& [a, b] : partners) first.insert(a);
  return std::any_of(partners.begin(), partners.end(),
                     [&first](const auto& pair) { return first.contains(pair[1]); });
}

}  // namespace

std::optional<glued_mesh> continued_across(const mesh& m, const std::vector<periodic_pair>& pairs) {
  continuation made(m);
  bool any = false;
  for (const periodic_pair& sides : pairs) {
    const auto match = match_periodic(m, sides);
    const auto partners = periodic_partners(m, sides.first, sides.second);
    if (!match || !partners || (match.value().turn != 0 && meet(partners.value()))) continue;
    made.across(partners.value(), map_of(match.value()));
    any = true;
  }
  if (!any) return std::nullopt;
  return std::move(made).take();
}

}  // namespace asterism::internal
