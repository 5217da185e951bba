// SPDX-License-Identifier: MIT
//
// Asks CGAL the same questions: its filtered kernel for orientation and in-circle, its
// algebraic kernel for the one sign that an edge test needs at a Voronoi vertex.
#pragma once

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <cstddef>
#include <memory>

#include "inputs.hpp"

namespace asterism::bench {

using epick = CGAL::Exact_predicates_inexact_constructions_kernel;

inline epick::Point_2 to_epick(const point& p) { return {p.x, p.y}; }

// Builds, from the four sites v, w, x, y of a question, the curves f_v = f_w, f_v = f_x and f_v =
// f_y.
class algebraic_rival {
 public:
  explicit algebraic_rival(const edge_question& sites);
  ~algebraic_rival();
  algebraic_rival(algebraic_rival&&) noexcept;
  algebraic_rival& operator=(algebraic_rival&&) = delete;
  algebraic_rival(const algebraic_rival&) = delete;
  algebraic_rival& operator=(const algebraic_rival&) = delete;

  // Solves f_v = f_w = f_x and keeps the solutions. Returns their number.
  std::size_t solve();
  // Returns the signs of f_v - f_y at the solutions, packed into a number.
  int signs() const;

 private:
  struct content;
  std::unique_ptr<content> content_;
};

}  // namespace asterism::bench
