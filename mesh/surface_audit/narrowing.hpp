// SPDX-License-Identifier: MIT
//
// Narrows an enclosure of a greatest distance by branch and bound, in rounds: cells that cannot
// hold more than is known, but for the width allowed, are dropped, the others divided. All cells of
// a round are looked at in parallel, and the outcome is the same for any number of threads.
#pragma once

#include <algorithm>
#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

#include "asterism/mesh/support/parallel_for.hpp"

namespace asterism::internal {

struct narrowing_limits {
  double relative_width = 0.01;
  double negligible = 0;  // a distance; cells below it are not divided
  std::optional<double> at_most;
  std::size_t most_cells = 0;
};

// Squared distances: no point is farther than `above`; some point is about as far as `below`, which
// is a proposal. `best` is the cell that has it.
template <class Cell>
struct narrowed {
  double above = 0, below = 0;
  std::optional<Cell> best;
  bool done = false;
  std::size_t cells = 0;
};

// A Cell has squared distances `above` and `below`. divide(cell) returns its parts, looked at.
template <class Cell, class Divide>
narrowed<Cell> narrow(std::vector<Cell> cells, const narrowing_limits& limits,
                      const Divide& divide) {
  narrowed<Cell> found;
  const double ratio = (1 + limits.relative_width) * (1 + limits.relative_width);
  while (true) {
    found.cells += cells.size();
    for (const Cell& c : cells)
      if (!found.best || c.below > found.below) found.best = c, found.below = c.below;
    double enough = std::max(found.below * ratio, limits.negligible * limits.negligible);
    if (limits.at_most) {
      const double limit = *limits.at_most * *limits.at_most;
      // Undecided as long as the limit is inside.
      if (found.below <= limit && limit < enough) enough = limit;
    }
    std::vector<Cell> kept;
    for (Cell& c : cells) {
      if (c.above > enough)
        kept.push_back(std::move(c));
      else
        found.above = std::max(found.above, c.above);
    }
    if (kept.empty() || found.cells > limits.most_cells) {
      for (const Cell& c : kept) found.above = std::max(found.above, c.above);
      found.done = kept.empty();
      return found;
    }
    std::vector<std::vector<Cell>> parts(kept.size());
    parallel_for(kept.size(), [&](std::size_t i) { parts[i] = divide(kept[i]); });
    cells.clear();
    for (std::vector<Cell>& some : parts)
      std::move(some.begin(), some.end(), std::back_inserter(cells));
  }
}

}  // namespace asterism::internal
