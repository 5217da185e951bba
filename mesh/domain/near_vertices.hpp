// SPDX-License-Identifier: MIT
//
// Finds the vertices near a place, in squares of the width `distance`. Works inside repair_domain.
#pragma once

#include <cmath>
#include <cstdint>
#include <map>
#include <utility>
#include <vector>

#include "asterism/core/site.hpp"
#include "asterism/mesh/data/domain.hpp"

namespace asterism::internal {

class near_vertices {
 public:
  // Finds vertices within `distance` of a place.
  explicit near_vertices(double distance) : width_(distance) {}

  void add(vertex_index v, const point& p) { squares_[square_of(p)].push_back(v); }

  // Returns the vertices in the nine squares around p, in the order of the squares.
  std::vector<vertex_index> around(const point& p) const {
    std::vector<vertex_index> found;
    const auto [column, row] = square_of(p);
    for (std::int64_t i = column - 1; i <= column + 1; ++i)
      for (std::int64_t j = row - 1; j <= row + 1; ++j)
        if (const auto at = squares_.find({i, j}); at != squares_.end())
          found.insert(found.end(), at->second.begin(), at->second.end());
    return found;
  }

 private:
  using square = std::pair<std::int64_t, std::int64_t>;
  // Computes the square's number. A coordinate is at most 2^51 widths, so the error of the quotient
  // is far below one.
  square square_of(const point& p) const {
    return {static_cast<std::int64_t>(std::floor(p.x / width_)),
            static_cast<std::int64_t>(std::floor(p.y / width_))};
  }

  double width_;
  std::map<square, std::vector<vertex_index>> squares_;
};

}  // namespace asterism::internal
