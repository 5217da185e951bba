// SPDX-License-Identifier: MIT
//
// Holds a triangulation of a polygon that changes, which the three methods share. Orientations of
// triangles are decided exactly, so that rounding causes no fault of a method.
#pragma once

#include <array>
#include <asterism/core/site.hpp>
#include <asterism/kernels/filtered_kernel.hpp>
#include <cstddef>
#include <functional>
#include <optional>
#include <vector>

namespace baselines {

using asterism::metric_tensor;
using asterism::point;
using index = std::size_t;
inline constexpr index none = static_cast<index>(-1);
using corners = std::array<index, 3>;

// A triangle. Corners are counter-clockwise; across[k] is the triangle opposite to corner[k],
// `none` on the border.
struct triangle {
  corners corner{none, none, none};
  corners across{none, none, none};
  bool alive() const { return corner[0] != none; }
};

// Returns the metric of an edge's circle test, from its ends v, w and the opposite corners x, y.
using metric_of_edge = std::function<metric_tensor(index v, index w, index x, index y)>;

class triangulation {
 public:
  // Cuts ears off a simple polygon, counter-clockwise. Its edges become the border. Empty where
  // there is no ear, since the polygon is not simple.
  static std::optional<triangulation> of_polygon(const std::vector<point>& ring);

  const std::vector<point>& points() const { return points_; }
  const std::vector<triangle>& triangles() const { return triangles_; }
  bool on_border(index v) const { return v < border_; }
  bool removed(index v) const { return triangle_at_[v] == none; }

  // Finds a triangle that contains p, on its edges too; `none` outside. Walks from the place where
  // the last search ended, and tests all triangles if the walk fails.
  index locate(const point& p) const;
  // Returns the triangles around v in counter-clockwise order.
  std::vector<index> around(index v) const;
  // Returns the vertices that v has edges to.
  std::vector<index> neighbours(index v) const;

  // Inserts p in place of the triangles, which must be connected. Refuses, with `none`, if p does
  // not see every edge around them from the inside: nothing is changed then.
  index insert(const point& p, const std::vector<index>& cavity);
  // Returns what insertion by splitting replaces: the triangle with p, or both at the edge with p
  // on it. Empty if p is outside, on the border or on a vertex.
  std::vector<index> cell_of(const point& p) const;
  // True if p is on the inner side of the triangle's edges that would bound a cavity.
  bool sees_border(const point& p, index t, const std::vector<index>& cavity) const;
  // Removes an inner vertex and cuts ears off the hole. False if there was no ear.
  bool remove(index v);
  // Moves an inner vertex if its triangles stay counter-clockwise.
  bool move(index v, const point& to);
  // Flips edges that fail the circle test, from those of the triangles given outward, at most
  // `most` times, since tests whose metrics differ can go in circles. Returns how many were
  // flipped.
  std::size_t flip_from(std::vector<index> waiting, const metric_of_edge& metric, std::size_t most);
  // Flips edges of all triangles, at most twenty times as often as there are triangles.
  std::size_t flip_all(const metric_of_edge& metric);

 private:
  bool turns_left(const point& a, const point& b, const point& c) const;
  std::optional<std::vector<corners>> cut_ears(std::vector<index> ring) const;
  void replace(const std::vector<index>& old, const std::vector<corners>& made);
  bool flip(index t, std::size_t k, const metric_of_edge& metric);

  std::vector<point> points_;
  std::vector<triangle> triangles_;
  std::vector<index> triangle_at_;  // a triangle at each vertex; none: removed
  std::vector<index> free_;         // unused places in the list of triangles
  index border_ = 0;                // vertices with lower numbers are on the border
  mutable index last_ = 0;          // where the last search ended
  asterism::filtered_kernel kernel_;
};

}  // namespace baselines
