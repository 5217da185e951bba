// SPDX-License-Identifier: MIT
//
// Decides the conditions on rows of points around a gap of a star: a row spans a region that
// contains every point for which the gap could accept a site (docs/math/proof-format.md, lemma 2
// and theorem 3).
#pragma once

#include <optional>
#include <span>
#include <unordered_map>
#include <vector>

#include "asterism/mesh/proof/mesh_proof.hpp"
#include "asterism/mesh/proof/star_conditions.hpp"

namespace asterism::internal::proof_detail {

inline constexpr std::size_t most_points = 32;

// The gap from x counter-clockwise to y in the star of v.
struct gap_sites {
  const site &v, &x, &y;
};

inline grid_point as_grid_point(const proof_point& p) { return {p[0], p[1]}; }

// Points in order from the ray to x to the ray to y. The segments between them are no nearer to v
// than to x up to the point at `turn`, and no nearer to v than to y from there on.
struct gap_row {
  std::span<const grid_point> points;
  std::size_t turn = 0;
};

// True if the row starts on the ray to x and ends on the ray to y, no point is at v or to the right
// of the one before, and its segments are no nearer to v than to x before `turn`, or to y after it.
bool is_sound(const gap_sites& g, const gap_row& row);
// True if all points are within the radius of v in v's metric, and the first and the last point
// also within the radius of x and of y in the metrics of these.
bool is_within(const gap_sites& g, const gap_row& row, double squared_radius);
// Returns an upper bound of the square of the least radius for which is_within() holds.
double squared_reach(const gap_sites& g, const gap_row& row);
// True if w is farther than v from each point of the region of a sound row, and farther than x, or
// y, from each point of the rest of the edge from v to it: then the gap refuses w.
bool refuses(const gap_sites& g, const gap_row& row, const site& w);
// True if refuses() holds without the triangle of the point at which the row turns and the two
// points beside it. False if the row turns at its first or its last point.
bool refuses_but_at_turn(const gap_sites& g, const gap_row& row, const site& w);

// The rows of the gaps of a mesh, by number.
class gap_rows {
 public:
  explicit gap_rows(std::size_t gaps) : plain_(gaps) {}

  void set(std::uint32_t gap, const proof_gap& row) { plain_[gap] = row; }
  // Sets a row of any number of points; plain(gap) is then zero.
  void set(std::uint32_t gap, const proof_exception& row);
  std::size_t size() const { return plain_.size(); }
  const proof_gap& plain(std::uint32_t gap) const { return plain_[gap]; }

  // Returns visit(row) for the row of the gap.
  template <class Visit>
  auto with(std::uint32_t gap, const Visit& visit) const {
    const proof_gap& p = plain_[gap];
    if (p.on_x == 0)
      if (const auto wide = wide_.find(gap); wide != wide_.end())
        return visit(gap_row{wide->second.points, wide->second.turn});
    const std::array<grid_point, 3> points = {grid_point{p.on_x, 0}, as_grid_point(p.between),
                                              grid_point{0, p.on_y}};
    return visit(gap_row{points, 1});
  }

 private:
  struct wide_row {
    std::vector<grid_point> points;
    std::size_t turn = 0;
  };

  std::vector<proof_gap> plain_;
  std::unordered_map<std::uint32_t, wide_row> wide_;
};

// Returns the points of an exception.
std::vector<grid_point> points_of(const proof_exception& exception);

}  // namespace asterism::internal::proof_detail
