// SPDX-License-Identifier: MIT
#include "asterism/mesh/surface/surface_sides.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <numeric>
#include <optional>
#include <string>
#include <utility>

#include "asterism/mesh/io/text_scanner.hpp"
#include "asterism/mesh/support/joined_sets.hpp"

namespace asterism::internal {
namespace {

using curve_key = std::vector<double>;

// Key of a curve from one of its ends: its control points and knots, knots from the first on.
curve_key key_of(const surface_patch& p, int side) {
  const bool along_u = side % 2 == 0;
  const std::size_t count = along_u ? p.count_u : p.count_v;
  curve_key key;
  for (std::size_t k = 0; k < count; ++k) {
    const control_point& c =
        along_u ? p.at(k, side == 0 ? 0 : p.count_v - 1) : p.at(side == 3 ? 0 : p.count_u - 1, k);
    // Adds 0, which makes -0 a 0.
    for (const double x : {c.at.x + 0.0, c.at.y + 0.0, c.at.z + 0.0, c.weight}) key.push_back(x);
  }
  const std::vector<double>& knots = along_u ? p.knots_u : p.knots_v;
  if (knots.size() == 2 * count)  // a Bezier curve is one whatever its knots
    return key;
  for (const double k : knots) key.push_back(k - knots.front());
  return key;
}

curve_key reversed_key(const surface_patch& p, int side) {
  surface_patch back = p;
  std::reverse(back.control.begin(), back.control.end());
  const auto turn = [](std::vector<double>& knots) {
    if (knots.empty()) return;
    const double last = knots.back();
    std::reverse(knots.begin(), knots.end());
    for (double& k : knots) k = last - k;
  };
  turn(back.knots_u), turn(back.knots_v);
  return key_of(back, (side + 2) % 4);
}

// Returns the patches in an order that does not depend on the file: by degrees, control points and
// knots. Curves have the direction that they have on the first of their patches in this order, so
// that the same patches in another order give the same triangles.
std::vector<std::size_t> order_by_content(const surface& s) {
  std::vector<std::vector<double>> keys;
  for (const surface_patch& p : s.patches) {
    std::vector<double>& key = keys.emplace_back();
    key = {static_cast<double>(p.degree_u), static_cast<double>(p.degree_v),
           static_cast<double>(p.count_u), static_cast<double>(p.count_v)};
    for (const control_point& c : p.control)
      key.insert(key.end(), {c.at.x, c.at.y, c.at.z, c.weight});
    key.insert(key.end(), p.knots_u.begin(), p.knots_u.end());
    key.insert(key.end(), p.knots_v.begin(), p.knots_v.end());
    for (const trim_link& trim : trims_of(p))
      for (const trim_point& c : trim.curve->control) key.insert(key.end(), {c.u, c.v, c.weight});
  }
  std::vector<std::size_t> order(keys.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return keys[a] < keys[b]; });
  return order;
}

error three_sides(std::array<std::size_t, 3> patches) {
  std::sort(patches.begin(), patches.end());
  return {fmt::format("patches {}, {} and {} have one side in common: only two may", patches[0] + 1,
                      patches[1] + 1, patches[2] + 1),
          error_code::invalid_input};
}

bool is_point(const surface_patch& p, int side) {
  const bool along_u = side % 2 == 0;
  const std::size_t count = along_u ? p.count_u : p.count_v;
  const auto at = [&](std::size_t k) {
    return along_u ? p.at(k, side == 0 ? 0 : p.count_v - 1).at
                   : p.at(side == 3 ? 0 : p.count_u - 1, k).at;
  };
  for (std::size_t k = 1; k < count; ++k)
    if (!(at(k) == at(0))) return false;
  return true;
}

error three_curves(const std::string& edge, const std::array<std::size_t, 3>& patches) {
  return {fmt::format("patches {}, {} and {} have edge \"{}\": only two curves may", patches[0] + 1,
                      patches[1] + 1, patches[2] + 1, without_controls(edge)),
          error_code::invalid_input};
}

// Adds the curves that trim a patch. Curves with one name are one curve.
std::optional<error> add_trims(const surface_patch& p, std::size_t patch,
                               std::map<std::string, std::size_t>& known, side_graph& g) {
  int side = 0;
  for (const trim_link& trim : trims_of(p)) {
    const trim_curve& c = *trim.curve;
    std::size_t number = g.curves.size();
    const auto found = c.edge.empty() || c.is_point ? known.end() : known.find(c.edge);
    if (found == known.end()) {
      g.curves.push_back({{{patch, side, c.backward}}, c.is_point, true});
      if (!c.edge.empty() && !c.is_point) known.emplace(c.edge, number);
    } else {
      number = found->second;
      side_curve& curve = g.curves[number];
      if (curve.sides.size() == 2)
        return three_curves(c.edge, {curve.sides[0].patch, curve.sides[1].patch, patch});
      curve.sides.push_back({patch, side, c.backward});
    }
    g.curve_of[patch].push_back(number);
    ++side;
  }
  return {};
}

result<side_graph> match_sides(const surface& s, const std::vector<std::size_t>& order) {
  side_graph g;
  g.curve_of.resize(s.patches.size());
  std::map<curve_key, std::size_t> known;
  std::map<std::string, std::size_t> known_trims;
  for (const std::size_t p : order) {
    if (!s.patches[p].loops.empty()) {
      if (auto wrong = add_trims(s.patches[p], p, known_trims, g)) return *wrong;
      continue;
    }
    g.curve_of[p].resize(4);
    for (int side = 0; side < 4; ++side) {
      auto& number = g.curve_of[p][static_cast<std::size_t>(side)];
      number = g.curves.size();
      if (is_point(s.patches[p], side)) {
        g.curves.push_back({{{p, side, false}}, true, false});
        continue;
      }
      const curve_key key = key_of(s.patches[p], side), back = reversed_key(s.patches[p], side);
      auto found = known.find(key);
      const bool backward = found == known.end() && known.contains(back);
      if (backward) found = known.find(back);
      if (found == known.end()) {
        known.emplace(key, number);
        g.curves.push_back({{{p, side, false}}, false, false});
        continue;
      }
      number = found->second;
      side_curve& curve = g.curves[number];
      if (curve.sides.size() == 2)
        return three_sides({curve.sides[0].patch, curve.sides[1].patch, p});
      curve.sides.push_back({p, side, backward});
    }
  }
  return g;
}

void number_corners(side_graph& g, const std::vector<face_border>& borders) {
  const std::size_t patches = g.curve_of.size();
  std::vector<std::size_t> first(1, 0);  // corner of each patch
  for (const face_border& b : borders) first.push_back(first.back() + b.sides());
  joined_sets corners(first.back());
  for (const side_curve& c : g.curves) {
    const auto end = [&](const patch_side& s, std::size_t which) {
      return first[s.patch] + borders[s.patch].ends_of(
                                  static_cast<std::size_t>(s.side))[s.backward ? 1 - which : which];
    };
    if (c.is_point) corners.join(end(c.sides[0], 0), end(c.sides[0], 1));
    if (c.sides.size() < 2) continue;
    corners.join(end(c.sides[0], 0), end(c.sides[1], 0));
    corners.join(end(c.sides[0], 1), end(c.sides[1], 1));
  }
  std::map<std::size_t, std::size_t> numbers;
  g.corner_of.resize(patches);
  for (std::size_t p = 0; p < patches; ++p)
    for (std::size_t k = first[p]; k < first[p + 1]; ++k)
      g.corner_of[p].push_back(numbers.emplace(corners.find(k), numbers.size()).first->second);
  g.corners = numbers.size();
}

// Returns +1 if going around the patch counter-clockwise follows the curve, else -1.
int direction_of(const patch_side& s, const std::vector<face_border>& borders) {
  const int around = borders[s.patch].runs_around(static_cast<std::size_t>(s.side)) ? 1 : -1;
  return s.backward ? -around : around;
}

// Assigns signs of orientation to all patches connected with a given one, whose sign is +1; zero
// means none yet. Neighbours run along their common curve in opposite directions. Returns the
// connected patches.
result<std::vector<std::size_t>> turn_from(const side_graph& g,
                                           const std::vector<face_border>& borders,
                                           std::size_t first, std::vector<int>& sign) {
  sign[first] = 1;
  std::vector<std::size_t> reached = {first};
  for (std::size_t k = 0; k < reached.size(); ++k) {
    const std::size_t p = reached[k];
    for (const std::size_t c : g.curve_of[p]) {
      const auto& sides = g.curves[c].sides;
      if (sides.size() < 2) continue;
      const patch_side &mine = sides[0].patch == p ? sides[0] : sides[1],
                       &other = sides[0].patch == p ? sides[1] : sides[0];
      const int wanted = -sign[p] * direction_of(mine, borders) * direction_of(other, borders);
      if (sign[other.patch] == 0) {
        sign[other.patch] = wanted;
        reached.push_back(other.patch);
      } else if (sign[other.patch] != wanted) {
        return error{fmt::format("patches {} and {}: the surface has one side alone, or they "
                                 "lie on each other",
                                 p + 1, other.patch + 1),
                     error_code::invalid_input};
      }
    }
  }
  return reached;
}

// Orients connected patches as most of them are; if equally many are turned each way, as the first
// in the order.
result<side_graph> turn_patches(side_graph g, const std::vector<face_border>& borders,
                                const std::vector<std::size_t>& order) {
  std::vector<int> sign(order.size(), 0);
  for (const std::size_t first : order) {
    if (sign[first] != 0) continue;
    const auto reached = turn_from(g, borders, first, sign);
    if (!reached) return reached.failure();
    std::size_t turned = 0;
    for (const std::size_t p : reached.value()) turned += sign[p] < 0 ? 1 : 0;
    if (2 * turned > reached.value().size())
      for (const std::size_t p : reached.value()) sign[p] = -sign[p];
  }
  for (const int s : sign) g.reversed.push_back(s < 0);
  return g;
}

}  // namespace

result<side_graph> graph_of_sides(const surface& s, const std::vector<face_border>& borders) {
  const std::vector<std::size_t> order = order_by_content(s);
  auto matched = match_sides(s, order);
  if (!matched) return matched;
  number_corners(matched.value(), borders);
  return turn_patches(std::move(matched).value(), borders, order);
}

}  // namespace asterism::internal
