// SPDX-License-Identifier: MIT
//
// Narrows an enclosure of a greatest distance by branch and bound, in rounds: cells that cannot
// exceed the known lower bound by more than the width allowed are dropped, the others divided. All
// cells of a round are bounded in parallel, and the outcome is the same for any number of threads.
#pragma once

#include <algorithm>
#include <cstddef>
#include <iterator>
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

// Result in squared distances: no point is farther than `above`; some point is about as far as
// `below`, which is a proposal. `best` is the cell of that point.
template <class Cell>
struct narrowed {
  double above = 0, below = 0;
  std::optional<Cell> best;
  bool done = false;
  std::size_t cells = 0;
};

// A Cell has squared distances `above` and `below`. divide(cell) returns its parts with their
// distances, or none if the cell cannot be divided further; give_up(cell) is then called, for one
// cell after the other. confirm(cell) is called before a cell's proposal `below` becomes the
// greatest, and may reduce it. Cells that cannot exceed the greatest proposal are not divided, so
// that a wrong proposal would widen all bounds.
template <class Cell, class Divide, class GiveUp, class Confirm>
narrowed<Cell> narrow(std::vector<Cell> cells, const narrowing_limits& limits, const Divide& divide,
                      const GiveUp& give_up, const Confirm& confirm) {
  narrowed<Cell> found;
  const double ratio = (1 + limits.relative_width) * (1 + limits.relative_width);
  while (true) {
    found.cells += cells.size();
    // Ignores a proposal above a proved bound: its projection went astray.
    const auto is_greatest = [&](const Cell& c) {
      return !found.best || std::min(c.below, c.above) > found.below;
    };
    for (Cell& c : cells) {
      if (!is_greatest(c)) continue;
      confirm(c);
      if (is_greatest(c)) found.best = c, found.below = std::min(c.below, c.above);
    }
    double enough = std::max(found.below * ratio, limits.negligible * limits.negligible);
    if (limits.at_most) {
      const double limit = *limits.at_most * *limits.at_most;
      // Continues as long as the distance to decide about is between both bounds.
      if (found.below <= limit && limit < enough) enough = limit;
    }
    std::vector<Cell> kept;
    kept.reserve(static_cast<std::size_t>(std::count_if(
        cells.begin(), cells.end(), [&](const Cell& c) { return c.above > enough; })));
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
    std::size_t count = 0;
    for (const std::vector<Cell>& some : parts) count += some.size();
    cells.clear();
    cells.reserve(count);
    for (std::size_t i = 0; i < parts.size(); ++i) {
      if (parts[i].empty()) {
        found.above = std::max(found.above, kept[i].above);
        give_up(kept[i]);
      }
      std::move(parts[i].begin(), parts[i].end(), std::back_inserter(cells));
    }
  }
}

template <class Cell, class Divide, class GiveUp>
narrowed<Cell> narrow(std::vector<Cell> cells, const narrowing_limits& limits, const Divide& divide,
                      const GiveUp& give_up) {
  return narrow(std::move(cells), limits, divide, give_up, [](const Cell&) {});
}

template <class Cell, class Divide>
narrowed<Cell> narrow(std::vector<Cell> cells, const narrowing_limits& limits,
                      const Divide& divide) {
  return narrow(std::move(cells), limits, divide, [](const Cell&) {});
}

}  // namespace asterism::internal
