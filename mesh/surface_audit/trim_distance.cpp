// SPDX-License-Identifier: MIT
#include "asterism/mesh/surface_audit/trim_distance.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "asterism/core/floating_point_environment.hpp"
#include "asterism/mesh/surface_audit/curve_composition.hpp"
#include "asterism/mesh/surface_audit/narrowing.hpp"

namespace asterism::internal {
namespace {

constexpr int deepest_part = 60;  // halvings: places are no finer
constexpr double unproved = std::numeric_limits<double>::infinity();  // no bound

struct trim_cell {
  double from = 0, to = 1;  // places of the first curve
  int depth = 0;
  double above = 0, below = 0;
};

using plane_point = std::array<double, 2>;

plain_vector lifted(const curve_on_patch& c, const plane_point& p) {
  const surface_place at = place_in(c.pieces, c.spans, p[0], p[1]);
  return evaluate(c.pieces[at.piece], at.s, at.t).at;
}

double squared_size(const plain_vector& a) { return dot(a, a); }

interval_vector exact_origin(const plain_vector& p) { return {p.x, p.y, p.z}; }

// Adds the images of a plane curve on all pieces of the patch that it may reach. Returns false if
// one is not known: a bound by the other images would not be valid.
bool add_images(const curve_on_patch& on, const plane_curve& curve, const interval_vector& origin,
                std::vector<space_curve>& images) {
  const std::vector<std::uint32_t> along = pieces_along(on.spans, curve);
  for (const std::uint32_t k : along) images.push_back(composed(on.pieces[k], curve, origin));
  return !along.empty();
}

std::vector<const trim_piece*> pieces_between(const std::vector<trim_piece>& pieces, double from,
                                              double to) {
  std::vector<const trim_piece*> some;
  for (const trim_piece& p : pieces)
    if (p.low.inf() < to && p.high.sup() > from) some.push_back(&p);
  return some;
}

double greatest_difference(const std::vector<space_curve>& a, const std::vector<space_curve>& b) {
  double most = 0;
  for (const space_curve& x : a)
    for (const space_curve& y : b) most = std::max(most, squared_difference_above(x, y));
  return most;
}

// Returns the place at which a cell is divided: the knot inside it nearest to its middle, else the
// middle.
double cut_of(const trim_cell& cell, const std::vector<double>& knots) {
  const double middle = (cell.from + cell.to) / 2;
  double best = middle, off = std::numeric_limits<double>::infinity();
  for (const double k : knots)
    if (k > cell.from && k < cell.to && std::abs(k - middle) < off)
      best = k, off = std::abs(k - middle);
  return best;
}

template <class Look>
double greatest_over(trim_cell whole, const std::vector<double>& knots, double negligible,
                     const Look& look) {
  narrowing_limits limits;
  limits.relative_width = 0.05;
  limits.negligible = negligible;
  limits.most_cells = 20'000;
  look(whole);
  const auto divide = [&](const trim_cell& cell) {
    const double middle = cut_of(cell, knots);
    std::vector<trim_cell> parts;
    if (cell.depth >= deepest_part || !(cell.from < middle && middle < cell.to)) return parts;
    for (const auto& [from, to] : {std::pair{cell.from, middle}, std::pair{middle, cell.to}}) {
      trim_cell part{from, to, cell.depth + 1, 0, 0};
      look(part);
      part.above = std::min(part.above, cell.above);
      parts.push_back(part);
    }
    return parts;
  };
  const auto found = narrow(std::vector<trim_cell>{whole}, limits, divide);
  const floating_point_scope scope(rounding::upward);
  return rounded_root(found.above);
}

struct two_curves {
  const curve_on_patch &a, &b;
  bool opposite;
  std::vector<trim_piece> of_a, of_b;
};

[[gnu::noinline]] void look_at_gap(const two_curves& two, trim_cell& cell) {
  const auto place = [&](double x) {
    return two.opposite ? rounded_interval(1) - rounded_interval(x) : rounded_interval(x);
  };
  const double middle = (cell.from + cell.to) / 2;
  const plain_vector here = lifted(two.a, trim_at(two.a.curve, middle));
  cell.below = squared_size(here - lifted(two.b, trim_at(two.b.curve, middle_of(place(middle)))));
  const interval_vector origin = exact_origin(here);
  std::vector<space_curve> first, second;
  bool known = true;
  for (const trim_piece* p : pieces_between(two.of_a, cell.from, cell.to))
    known = known && add_images(two.a, part_of_trim(*p, cell.from, cell.to), origin, first);
  const rounded_interval from = place(cell.from), to = place(cell.to), range = hull(from, to);
  for (const trim_piece* p : pieces_between(two.of_b, range.inf(), range.sup()))
    known = known && add_images(two.b, part_of_trim(*p, from, to), origin, second);
  cell.above = known ? greatest_difference(first, second) : unproved;
}

struct curve_and_chord {
  const curve_on_patch& on;
  const trim_chord& chord;
  std::array<double, 2> units;
  std::vector<trim_piece> pieces;

  // Returns the parameter, from 0 to 1, of the chord's point near the foot of the point p of the
  // plane. The distance from p is measured to that point.
  double share_at(const plane_point& p) const {
    double along = 0, length = 0;
    for (std::size_t k = 0; k < 2; ++k) {
      const double e = (chord.end[k] - chord.start[k]) / units[k];
      along += (p[k] - chord.start[k]) / units[k] * e;
      length += e * e;
    }
    return length > 0 ? std::clamp(along / length, 0.0, 1.0) : 0;
  }
  double share_of_place(double place) const {
    if (place <= chord.from) return 0;
    if (place >= chord.to) return 1;
    return share_at(trim_at(on.curve, place));
  }
  interval_vector on_chord(double share) const {
    const rounded_interval s = share;
    const auto at = [&](std::size_t k) {
      const rounded_interval from = chord.start[k];
      return from + s * (rounded_interval(chord.end[k]) - from);
    };
    return {at(0), at(1), 0};
  }
};

// Returns the part of the chord that is compared with a part of the curve. The parameters at its
// ends are those of the adjacent parts, so that the whole chord is covered.
plane_curve along_chord(const curve_and_chord& both, const trim_cell& cell,
                        const plane_curve& part) {
  plane_curve chord;
  for (std::size_t k = 0; k < part.size(); ++k) {
    const rounded_interval& w = part[k].weight;
    const plain_vector p = middle_of(part[k].at);
    const double share = k == 0 ? both.share_of_place(cell.from)
                         : k + 1 == part.size()
                             ? both.share_of_place(cell.to)
                             : both.share_at({p.x / middle_of(w), p.y / middle_of(w)});
    chord.push_back({w * both.on_chord(share), w});
  }
  return chord;
}

[[gnu::noinline]] void look_at_chord(const curve_and_chord& both, trim_cell& cell) {
  const curve_on_patch& on = both.on;
  const double middle = (cell.from + cell.to) / 2;
  const plane_point p = trim_at(on.curve, middle);
  const interval_vector foot = both.on_chord(both.share_of_place(middle));
  const plain_vector here = lifted(on, p);
  cell.below = squared_size(here - lifted(on, {middle_of(foot.x), middle_of(foot.y)}));
  const interval_vector origin = exact_origin(here);
  std::vector<space_curve> curves, chords;
  bool known = true;
  for (const trim_piece* piece : pieces_between(both.pieces, cell.from, cell.to)) {
    const plane_curve part = part_of_trim(*piece, cell.from, cell.to);
    known =
        known && (!chords.empty() || add_images(on, along_chord(both, cell, part), origin, chords));
    known = known && add_images(on, part, origin, curves);
  }
  cell.above = known ? greatest_difference(curves, chords) : unproved;
}

[[gnu::noinline]] std::vector<trim_piece> pieces_upward(const trim_curve& c) {
  const floating_point_scope scope(rounding::upward);
  return trim_pieces(c);
}

}  // namespace

double trim_gap_above(const curve_on_patch& a, const curve_on_patch& b, bool opposite,
                      double negligible) {
  const two_curves two{a, b, opposite, pieces_upward(a.curve), pieces_upward(b.curve)};
  std::vector<double> knots = knot_places(a.curve);
  for (const double k : knot_places(b.curve)) knots.push_back(opposite ? 1 - k : k);
  return greatest_over({}, knots, negligible, [&](trim_cell& cell) {
    const floating_point_scope scope(rounding::upward);
    look_at_gap(two, cell);
  });
}

double chord_distance_above(const curve_on_patch& c, const trim_chord& chord,
                            const std::array<double, 2>& units, double negligible) {
  const curve_and_chord both{c, chord, units, pieces_upward(c.curve)};
  return greatest_over({chord.from, chord.to, 0, 0, 0}, knot_places(c.curve), negligible,
                       [&](trim_cell& cell) {
                         const floating_point_scope scope(rounding::upward);
                         look_at_chord(both, cell);
                       });
}

}  // namespace asterism::internal
