// SPDX-License-Identifier: MIT
//
// Names the parts of a domain in messages: by the numbers and lines of the file it came from, or by
// numbers from 1 when it came from none.
#pragma once

#include <cstddef>
#include <optional>
#include <string>

#include "asterism/mesh/data/domain.hpp"

namespace asterism::internal {

class domain_names {
 public:
  explicit domain_names(const domain& d) : d_(d) {}

  // Returns names such as "vertex 5 (0.25, 1)", "segment 3 (vertices 5-6)", "hole 1 (0.5, 0)",
  // "region 2 (3, 3)", "curve 4". Require indices in range.
  std::string vertex(std::size_t v) const;
  // Names a segment of a polygon, as a side between its two ends.
  std::string segment(std::size_t s) const;
  std::string polygon(std::size_t p) const;  // "polygon 3 (feature 2)"
  std::string ring(std::size_t p, std::size_t r) const;
  std::string feature(const std::optional<int>& region) const;
  std::string hole(std::size_t h) const;
  std::string region(std::size_t r) const;
  std::string curve(std::size_t c) const;

  // Returns "file:line: ", or "name: " where no line is known, with which messages start.
  std::string at_vertex(std::size_t v) const;
  std::string at_segment(std::size_t s) const;
  std::string at_hole(std::size_t h) const;
  std::string at_region(std::size_t r) const;
  std::string at_curve(std::size_t c) const;
  std::string at_start() const;

  // Returns " on line 12", or an empty text where no line is known.
  std::string line_of_segment(std::size_t s) const;

 private:
  const domain& d_;
};

// Returns "(x, y)" with at most 17 significant digits: the shortest that read back to the same
// doubles.
std::string coordinates(const point& p);

}  // namespace asterism::internal
