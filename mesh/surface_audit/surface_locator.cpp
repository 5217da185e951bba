// SPDX-License-Identifier: MIT
#include "asterism/mesh/surface_audit/surface_locator.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

namespace asterism::internal {
namespace {

double squared(const plain_vector& a) { return dot(a, a); }

// Returns whether the side of the piece is about one point: its derivative along s (at t = 0 or 1)
// or along t (at s = 0 or 1) is negligible compared with that in the middle of the piece. Only
// affects where projections start.
bool is_about_a_point(const bezier_piece& piece, bool along_s, double side) {
  constexpr double nothing = 1e-16;  // of the square
  const plain_jet there = along_s ? evaluate(piece, 0.5, side) : evaluate(piece, side, 0.5);
  const plain_jet middle = evaluate(piece, 0.5, 0.5);
  return along_s ? squared(there.by_s) <= nothing * squared(middle.by_s)
                 : squared(there.by_t) <= nothing * squared(middle.by_t);
}

// Returns a parameter for each line of the grid. A line on a side that is one point is moved
// inward: all places of that side are equally near, and from a place on another meridian the
// projection may end at a side of the piece.
std::vector<double> grid_lines(const bezier_piece& piece, bool along_s, int count) {
  constexpr double inward = 0.25;  // of a step
  std::vector<double> lines;
  for (int j = 0; j <= count; ++j) lines.push_back(static_cast<double>(j) / count);
  if (is_about_a_point(piece, along_s, 0)) lines.front() = inward / count;
  if (is_about_a_point(piece, along_s, 1)) lines.back() = 1 - inward / count;
  return lines;
}

std::vector<surface_place> grid_places(const std::vector<bezier_piece>& pieces) {
  std::vector<surface_place> places;
  for (std::uint32_t k = 0; k < pieces.size(); ++k) {
    const bezier_piece& piece = pieces[k];
    const auto lines_t = grid_lines(piece, true, 2 * piece.degree_v + 2);
    for (const double s : grid_lines(piece, false, 2 * piece.degree_u + 2))
      for (const double t : lines_t) places.push_back({k, s, t});
  }
  return places;
}

std::vector<plain_vector> samples_at(const std::vector<bezier_piece>& pieces,
                                     const std::vector<surface_place>& places) {
  std::vector<plain_vector> samples;
  samples.reserve(places.size());
  for (const surface_place& at : places)
    samples.push_back(evaluate(pieces[at.piece], at.s, at.t).at);
  return samples;
}

std::vector<space_box> boxes_of(const std::vector<plain_vector>& samples) {
  std::vector<space_box> boxes;
  boxes.reserve(samples.size());
  for (const plain_vector& p : samples) boxes.push_back(space_box::of({p.x, p.y, p.z}));
  return boxes;
}

// Returns the step of Gauss and Newton; a variable that would leave its bound stays there.
std::array<double, 2> step(const plain_jet& jet, const plain_vector& gap, bool hold_s,
                           bool hold_t) {
  const double a = dot(jet.by_s, jet.by_s), b = dot(jet.by_s, jet.by_t),
               c = dot(jet.by_t, jet.by_t), f = dot(jet.by_s, gap), g = dot(jet.by_t, gap);
  if (hold_s || a == 0) return {0, hold_t || c == 0 ? 0 : g / c};
  if (hold_t || c == 0) return {f / a, 0};
  const double d = a * c - b * b;
  if (!(d > 1e-14 * a * c)) return {f / (2 * a), g / (2 * c)};
  return {(f * c - g * b) / d, (g * a - f * b) / d};
}

bool leaves(double x, double by, double low, double high) {
  return (x <= low && by < 0) || (x >= high && by > 0);
}

}  // namespace

located project(const std::vector<bezier_piece>& pieces, surface_place from, const plain_vector& p,
                double beyond) {
  constexpr int most_steps = 16;
  constexpr double negligible = 1e-9;  // of the parameters: its square is what is lost
  const bezier_piece& piece = pieces[from.piece];
  const double low = -beyond, high = 1 + beyond;
  plain_jet jet = evaluate(piece, from.s, from.t);
  located best{from, squared(p - jet.at)};
  for (int i = 0; i < most_steps; ++i) {
    const plain_vector gap = p - jet.at;
    const surface_place& at = best.at;
    std::array<double, 2> by = step(jet, gap, false, false);
    const bool hold_s = leaves(at.s, by[0], low, high), hold_t = leaves(at.t, by[1], low, high);
    if (hold_s || hold_t) by = step(jet, gap, hold_s, hold_t);
    // Ends if the step is negligible: at the nearest point neither a step nor a part of it leads
    // nearer.
    if (!(std::max(std::abs(by[0]), std::abs(by[1])) >= negligible)) break;
    bool nearer = false;
    double moved = 0;
    for (double share = 1; share > 0.05 && !nearer; share /= 2) {
      surface_place next = at;
      next.s = std::clamp(at.s + share * by[0], low, high);
      next.t = std::clamp(at.t + share * by[1], low, high);
      const plain_jet there = evaluate(piece, next.s, next.t);
      const double far = squared(p - there.at);
      if (!(far < best.squared_distance)) continue;
      moved = std::max(std::abs(next.s - at.s), std::abs(next.t - at.t));
      nearer = true;
      jet = there;
      best = {next, far};
    }
    if (!nearer || moved < negligible) break;
  }
  return best;
}

surface_locator::surface_locator(const std::vector<bezier_piece>& pieces)
    : pieces_(&pieces),
      places_(grid_places(pieces)),
      samples_(samples_at(pieces, places_)),
      tree_(boxes_of(samples_)) {}

located surface_locator::nearest(const plain_vector& p) const {
  // Starts from the three nearest samples, and from all others as near as the third: at a corner or
  // at a side that is one point any of the pieces that meet there may contain the nearest point.
  constexpr std::size_t starts_wanted = 3, most_starts = 12;
  struct start {
    double far;
    std::uint32_t sample;
  };
  std::array<start, most_starts> starts;
  std::size_t count = 0;
  const auto limit = [&] {
    return count < starts_wanted ? std::numeric_limits<double>::infinity()
                                 : starts[starts_wanted - 1].far;
  };
  const auto before = [](const start& a, const start& b) {
    return a.far != b.far ? a.far < b.far : a.sample < b.sample;
  };
  // Keeps the nearest sample of each piece, in order of distance, equal ones by number.
  const auto offer = [&](std::uint32_t sample) {
    const start mine{squared(p - samples_[sample]), sample};
    std::size_t k = 0;
    while (k < count && places_[starts[k].sample].piece != places_[sample].piece) ++k;
    if (k == most_starts) --k;
    if (k == count)
      ++count;
    else if (!before(mine, starts[k]))
      return;
    starts[k] = mine;
    for (; k > 0 && before(starts[k], starts[k - 1]); --k) std::swap(starts[k], starts[k - 1]);
  };
  tree_.visit_near(p, limit, offer);
  located best;
  for (std::size_t k = 0; k < count; ++k) {
    if (k >= starts_wanted && starts[k].far > starts[starts_wanted - 1].far) break;
    const located found = project(*pieces_, places_[starts[k].sample], p);
    if (k == 0 || found.squared_distance < best.squared_distance) best = found;
  }
  return best;
}

}  // namespace asterism::internal
