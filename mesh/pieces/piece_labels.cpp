// SPDX-License-Identifier: MIT
#include "asterism/mesh/pieces/piece_labels.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <numeric>
#include <utility>

#include "asterism/mesh/numerics/constructions.hpp"

namespace asterism::internal {
namespace {

constexpr std::size_t no_triangle = std::numeric_limits<std::size_t>::max();

// Neighbour across each side of a triangle, if there is one, and the length of that side as a cut:
// 0 along segments, where two pieces may meet at no cost.
struct neighbours {
  std::array<std::size_t, 3> across{no_triangle, no_triangle, no_triangle};
  std::array<double, 3> length{};
};

double length_of(const mesh& m, vertex_index a, vertex_index b) {
  const site &p = m.sites[a], &q = m.sites[b];
  return (std::sqrt(squared_distance(p, q.position)) + std::sqrt(squared_distance(q, p.position))) /
         2;
}

std::vector<neighbours> neighbours_of(const mesh& m) {
  std::map<std::array<vertex_index, 2>, std::array<std::size_t, 2>> sides;  // triangle, corner
  for (std::size_t t = 0; t < m.triangles.size(); ++t)
    for (std::size_t i = 0; i < 3; ++i)
      sides[{m.triangles[t][i], m.triangles[t][(i + 1) % 3]}] = {t, i};
  std::vector<neighbours> all(m.triangles.size());
  for (const auto& [ends, place] : sides) {
    const auto other = sides.find({ends[1], ends[0]});
    if (other == sides.end()) continue;
    all[place[0]].across[place[1]] = other->second[0];
    all[place[0]].length[place[1]] = length_of(m, ends[0], ends[1]);
  }
  for (const boundary_edge& e : m.boundary)
    for (const std::array<vertex_index, 2> ends : {std::array{e.a, e.b}, std::array{e.b, e.a}})
      if (const auto side = sides.find(ends); side != sides.end())
        all[side->second[0]].length[side->second[1]] = 0;
  return all;
}

// Returns the metric area of a triangle, sampled in the middles of 16 parts.
result<double> area_in(const metric_field& field, const point& a, const point& b, const point& c) {
  constexpr int parts = 4;
  double sum = 0;
  for (int i = 0; i < parts; ++i)
    for (int j = 0; i + j < parts; ++j)
      for (int upside = 0; upside < (i + j + 1 < parts ? 2 : 1); ++upside) {
        const double shift = upside == 0 ? 1.0 / 3 : 2.0 / 3;
        const double u = (i + shift) / parts, v = (j + shift) / parts;
        const auto m = field.at(
            {a.x + u * (b.x - a.x) + v * (c.x - a.x), a.y + u * (b.y - a.y) + v * (c.y - a.y)});
        if (!m) return m.failure();
        const metric_tensor& t = m.value();
        sum += std::sqrt(std::max(0.0, t.m11 * t.m22 - t.m12 * t.m12));
      }
  const double twice = (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
  return sum / (parts * parts) * std::abs(twice) / 2;
}

class labelling {
 public:
  labelling(const mesh& m, std::vector<double> areas, std::size_t pieces)
      : mesh_(m),
        areas_(std::move(areas)),
        around_(neighbours_of(m)),
        label_(m.triangles.size(), 0),
        pieces_(pieces) {}

  std::vector<piece_index> run() {
    std::vector<std::size_t> all(mesh_.triangles.size());
    std::iota(all.begin(), all.end(), std::size_t{0});
    bisect(std::move(all), 0, pieces_);
    shorten_cuts();
    return std::move(label_);
  }

 private:
  // Unit vectors at multiples of 22.5 degrees, to six digits, which is enough.
  static constexpr std::array<point, 8> directions = {{{1, 0},
                                                       {0.923880, 0.382683},
                                                       {0.707107, 0.707107},
                                                       {0.382683, 0.923880},
                                                       {0, 1},
                                                       {-0.382683, 0.923880},
                                                       {-0.707107, 0.707107},
                                                       {-0.923880, 0.382683}}};

  double along(std::size_t t, const point& direction) const {
    double sum = 0;
    for (const vertex_index v : mesh_.triangles[t]) {
      const point& q = mesh_.sites[v].position;
      sum += q.x * direction.x + q.y * direction.y;
    }
    return sum;
  }

  double total_area(const std::vector<std::size_t>& which) const {
    double sum = 0;
    for (const std::size_t t : which) sum += areas_[t];
    return sum;
  }

  // Sorts the triangles along the direction and returns how many of them make up this part of their
  // area.
  std::size_t order(std::vector<std::size_t>& which, const point& direction, double part) const {
    std::vector<std::pair<double, std::size_t>> keys;
    keys.reserve(which.size());
    for (const std::size_t t : which) keys.emplace_back(along(t, direction), t);
    std::sort(keys.begin(), keys.end());
    const double wanted = part * total_area(which);
    double sum = 0;
    std::size_t first = 0;
    for (std::size_t i = 0; i < keys.size(); ++i) {
      which[i] = keys[i].second;
      if (sum + areas_[which[i]] / 2 <= wanted) first = i + 1;
      sum += areas_[which[i]];
    }
    return std::clamp<std::size_t>(first, 1, which.size() - 1);
  }

  // Returns the length of the cut between the first triangles and the others.
  double cut_length(const std::vector<std::size_t>& which, std::size_t first,
                    std::vector<char>& side) const {
    for (std::size_t i = 0; i < which.size(); ++i) side[which[i]] = i < first ? 1 : 2;
    double sum = 0;
    for (std::size_t i = 0; i < first; ++i)
      for (std::size_t k = 0; k < 3; ++k) {
        const std::size_t other = around_[which[i]].across[k];
        if (other != no_triangle && side[other] == 2) sum += around_[which[i]].length[k];
      }
    for (const std::size_t t : which) side[t] = 0;
    return sum;
  }

  void bisect(std::vector<std::size_t> which, piece_index first_piece, std::size_t pieces) {
    if (pieces <= 1 || which.size() < 2) {
      for (const std::size_t t : which) label_[t] = first_piece;
      return;
    }
    const std::size_t half = pieces / 2;
    const double part = static_cast<double>(half) / static_cast<double>(pieces);
    std::vector<char> side(mesh_.triangles.size(), 0);
    double shortest = std::numeric_limits<double>::infinity();
    point best = directions[0];
    for (const point& direction : directions) {
      const std::size_t first = order(which, direction, part);
      const double length = cut_length(which, first, side);
      if (length < shortest) {
        shortest = length;
        best = direction;
      }
    }
    const std::size_t first = order(which, best, part);
    const auto middle = which.begin() + static_cast<std::ptrdiff_t>(first);
    std::vector<std::size_t> rest(middle, which.end());
    which.erase(middle, which.end());
    bisect(std::move(which), first_piece, half);
    bisect(std::move(rest), static_cast<piece_index>(first_piece + half), pieces - half);
  }

  // Moves each triangle to the neighbouring piece with which it shares the greatest length of
  // sides.
  void shorten_cuts() {
    constexpr int passes = 20;
    constexpr double slack = 1.02;
    std::vector<double> area(pieces_, 0);
    std::vector<std::size_t> count(pieces_, 0);
    for (std::size_t t = 0; t < label_.size(); ++t) {
      area[label_[t]] += areas_[t];
      ++count[label_[t]];
    }
    double most = slack * total(area) / static_cast<double>(pieces_);
    for (int pass = 0; pass < passes; ++pass) {
      bool moved = false;
      for (std::size_t t = 0; t < label_.size(); ++t) {
        const piece_index from = label_[t], to = better_piece(t);
        if (to == from || count[from] == 1 || area[to] + areas_[t] > most) continue;
        label_[t] = to;
        area[from] -= areas_[t];
        area[to] += areas_[t];
        --count[from];
        ++count[to];
        moved = true;
      }
      if (!moved) return;
    }
  }

  static double total(const std::vector<double>& area) {
    return std::accumulate(area.begin(), area.end(), 0.0);
  }

  // Returns the piece beyond most of the triangle's sides, by length; its own unless another has
  // clearly more.
  piece_index better_piece(std::size_t t) const {
    constexpr double clearly = 1 + 1e-9;
    std::array<std::pair<piece_index, double>, 3> to{};
    std::size_t found = 0;
    double own = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      const std::size_t other = around_[t].across[k];
      if (other == no_triangle) continue;
      const piece_index label = label_[other];
      if (label == label_[t]) {
        own += around_[t].length[k];
        continue;
      }
      std::size_t i = 0;
      while (i < found && to[i].first != label) ++i;
      if (i == found) to[found++] = {label, 0};
      to[i].second += around_[t].length[k];
    }
    piece_index best = label_[t];
    double longest = clearly * own;
    for (std::size_t i = 0; i < found; ++i)
      if (to[i].second > longest) {
        longest = to[i].second;
        best = to[i].first;
      }
    return best;
  }

  const mesh& mesh_;
  const std::vector<double> areas_;
  const std::vector<neighbours> around_;
  std::vector<piece_index> label_;
  std::size_t pieces_;
};

}  // namespace

result<std::vector<piece_index>> label_triangles(const mesh& coarse, const metric_field& field,
                                                 std::size_t pieces) {
  std::vector<double> areas;
  areas.reserve(coarse.triangles.size());
  for (const triangle& t : coarse.triangles) {
    const auto area = area_in(field, coarse.sites[t[0]].position, coarse.sites[t[1]].position,
                              coarse.sites[t[2]].position);
    if (!area) return area.failure();
    areas.push_back(area.value());
  }
  return labelling(coarse, std::move(areas), pieces).run();
}

}  // namespace asterism::internal
