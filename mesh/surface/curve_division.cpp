// SPDX-License-Identifier: MIT
#include "asterism/mesh/surface/curve_division.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace asterism::internal {
namespace {

// Unit of places on curves: places are multiples of it, so that a place p and 1 - p are both exact.
constexpr double place_unit = 0x1p-30;
constexpr int side_samples = 256;  // of the length of a curve

double rounded_place(double x) {
  return std::clamp(std::round(x / place_unit) * place_unit, place_unit, 1 - place_unit);
}

// True for curves that only this class divides: those that two faces share, and those that trim.
bool is_divided(const side_curve& curve) {
  return !curve.is_point && (curve.sides.size() == 2 || curve.is_trim);
}

// Returns the metric length of the curve's derivative at a place.
double density_of(const patch_faces& of, const patch_side& side, double place) {
  const metric_tensor m = of.faces[side.patch].metric_at(chart_point(of, side, place));
  const surface_chart& chart = of.charts[side.patch];
  const double width = chart.high().x - chart.low().x, height = chart.high().y - chart.low().y;
  if (!of.borders[side.patch].is_trimmed())
    return side.side % 2 == 0 ? m.m11 * width * width : m.m22 * height * height;
  const point from = chart_point(of, side, place - 0.5 / side_samples),
              to = chart_point(of, side, place + 0.5 / side_samples);
  const double x = (to.x - from.x) * side_samples, y = (to.y - from.y) * side_samples;
  return m.m11 * x * x + 2 * m.m12 * x * y + m.m22 * y * y;
}

// Returns the metric length of a curve, by the greater of its two patches' densities at each place.
double length_of(const patch_faces& of, const side_curve& curve, std::vector<double>& sums) {
  sums.assign(1, 0);
  for (int k = 0; k < side_samples; ++k) {
    const double place = (k + 0.5) / side_samples;
    double density = 0;
    for (const patch_side& side : curve.sides)
      density = std::max(density, density_of(of, side, place));
    sums.push_back(sums.back() + std::sqrt(density) / side_samples);
  }
  return sums.back();
}

// Returns the metric length of the curve from its start to a place.
double length_until(const std::vector<double>& sums, double place) {
  const double x = std::clamp(place, 0.0, 1.0) * side_samples;
  const auto k = std::min(static_cast<std::size_t>(x), sums.size() - 2);
  return sums[k] + (x - static_cast<double>(k)) * (sums[k + 1] - sums[k]);
}

// Adds the places that divide a part of a curve into equal metric lengths.
void add_equal_parts(const std::vector<double>& sums, double start, double length,
                     std::vector<double>& places) {
  constexpr double longest_part = 0.95;
  const auto parts = static_cast<int>(std::max(1.0, std::ceil(length / longest_part)));
  std::size_t k = 0;
  for (int part = 1; part < parts; ++part) {
    const double wanted = start + length * part / parts;
    while (sums[k + 1] < wanted) ++k;
    const double share = (wanted - sums[k]) / (sums[k + 1] - sums[k]);
    const double place = rounded_place((static_cast<double>(k) + share) / side_samples);
    if (places.empty() || place > places.back()) places.push_back(place);
  }
}

std::vector<double> equal_parts(const std::vector<double>& sums) {
  std::vector<double> places;
  add_equal_parts(sums, 0, sums.back(), places);
  return places;
}

// Halves each chord until it has a place for each of the splits that meshes made on it. If two
// faces divided a chord each at its own place, a short piece between these would make both divide
// its neighbours, and so on.
std::vector<double> with_halves(const std::vector<double>& places,
                                const std::vector<std::size_t>& splits) {
  std::vector<double> all;
  for (std::size_t k = 0; k < splits.size(); ++k) {
    const double from = k == 0 ? 0 : places[k - 1], to = k == places.size() ? 1 : places[k];
    std::size_t parts = 1;
    while (parts < splits[k] + 1 && parts < 1024) parts *= 2;
    for (std::size_t i = 1; i < parts; ++i) {
      const double share = static_cast<double>(i) / static_cast<double>(parts);
      const double place = rounded_place(from + share * (to - from));
      if (place > (all.empty() ? 0 : all.back()) && place < to) all.push_back(place);
    }
    if (k < places.size()) all.push_back(to);
  }
  return all;
}

double distance_between(const space_point& a, const space_point& b) {
  return std::sqrt((a.x - b.x) * (a.x - b.x) + (a.y - b.y) * (a.y - b.y) +
                   (a.z - b.z) * (a.z - b.z));
}

// Returns an approximate distance in space between a part of a curve and its chord in the plane:
// the greatest at a few places.
double off_chord(const patch_faces& of, const patch_side& side, double from, double to) {
  const surface_chart& chart = of.charts[side.patch];
  const point a = chart_point(of, side, from), b = chart_point(of, side, to);
  double most = 0;
  for (const double share : {0.25, 0.5, 0.75}) {
    const point p = chart_point(of, side, from + share * (to - from));
    const double x = b.x - a.x, y = b.y - a.y, length = x * x + y * y;
    const double foot =
        length > 0 ? std::clamp(((p.x - a.x) * x + (p.y - a.y) * y) / length, 0.0, 1.0) : 0;
    most = std::max(most,
                    distance_between(chart.lift(p), chart.lift({a.x + foot * x, a.y + foot * y})));
  }
  return most;
}

// Returns the places that a curve must have, ascending: its corners and, for a closed curve, enough
// for a polygon with an inside.
std::vector<double> needed_places(const patch_faces& of, const side_curve& curve) {
  std::vector<double> places;
  for (const patch_side& side : curve.sides) {
    const face_border& border = of.borders[side.patch];
    const auto number = static_cast<std::size_t>(side.side);
    const trim_curve& c = border.curve(number);
    const std::vector<double> knots = knot_places(c);
    if (c.degree == 1)
      for (const double k : knots) places.push_back(rounded_place(own_place(side, k)));
    const std::size_t parts = border.curves_in_loop(number) == 1 ? 4 : 2;
    if (border.curves_in_loop(number) < 3)
      for (std::size_t k = 1; k < parts; ++k)
        places.push_back(static_cast<double>(k) / static_cast<double>(parts));
  }
  std::sort(places.begin(), places.end());
  places.erase(std::unique(places.begin(), places.end()), places.end());
  return places;
}

// Returns the parameters, ascending, at which a trimming curve is divided at first: those of
// needed_places, and between them parameters that make parts of equal length.
std::vector<double> parts_of_trim(const patch_faces& of, const side_curve& curve,
                                  const std::vector<double>& sums) {
  std::vector<double> needed = needed_places(of, curve), places;
  needed.push_back(1);
  double from = 0;
  for (const double to : needed) {
    const double start = length_until(sums, from);
    add_equal_parts(sums, start, length_until(sums, to) - start, places);
    if (to < 1 && (places.empty() || to > places.back())) places.push_back(to);
    from = to;
  }
  return places;
}

// Adds places until the chords are near the curve on both patches, in doubles.
std::vector<double> near_chords(const patch_faces& of, const side_curve& curve,
                                std::vector<double> places, double chord) {
  constexpr double share = 0.5;  // of the distance asked
  constexpr std::size_t most = 100'000;
  std::sort(places.begin(), places.end());
  places.erase(std::unique(places.begin(), places.end()), places.end());
  std::vector<double> waiting(places.rbegin(), places.rend()), done;
  waiting.insert(waiting.begin(), 1);
  double from = 0;
  while (!waiting.empty()) {
    const double to = waiting.back(), middle = rounded_place((from + to) / 2);
    double off = 0;
    for (const patch_side& side : curve.sides) off = std::max(off, off_chord(of, side, from, to));
    if (off > share * chord && from < middle && middle < to && done.size() < most) {
      waiting.push_back(middle);
      continue;
    }
    done.push_back(to);
    waiting.pop_back();
    from = to;
  }
  done.pop_back();  // the end
  return done;
}

}  // namespace

point chart_point(const patch_faces& of, const patch_side& side, double place) {
  return of.borders[side.patch].at(static_cast<std::size_t>(side.side), own_place(side, place));
}

const patch_side& side_of_patch(const side_curve& curve, std::size_t patch, int side) {
  const patch_side& first = curve.sides[0];
  return first.patch == patch && first.side == side ? first : curve.sides[1];
}

void curve_division::put(const patch_faces& of, std::size_t curve, std::vector<double> places,
                         std::vector<unsigned char>& is_stale) {
  if (places == places_[curve]) return;
  places_[curve] = std::move(places);
  for (const patch_side& side : of.graph.curves[curve].sides) is_stale[side.patch] = 1;
}

void curve_division::divide(const patch_faces& of, std::vector<unsigned char>& is_stale) {
  std::vector<double> sums;
  kept_.resize(places_.size());
  for (std::size_t c = 0; c < of.graph.curves.size(); ++c) {
    const side_curve& curve = of.graph.curves[c];
    if (!is_divided(curve)) continue;
    length_of(of, curve, sums);
    std::vector<double> places = curve.is_trim ? parts_of_trim(of, curve, sums) : equal_parts(sums);
    if (curve.is_trim) {
      places.insert(places.end(), kept_[c].begin(), kept_[c].end());
      places = near_chords(of, curve, std::move(places), chord_);
    }
    put(of, c, std::move(places), is_stale);
  }
}

void curve_division::divide_border(const patch_faces& of, std::size_t patch,
                                   std::vector<unsigned char>& is_stale) {
  kept_.resize(places_.size());
  for (const std::size_t c : of.graph.curve_of[patch]) {
    const side_curve& curve = of.graph.curves[c];
    if (!is_divided(curve) || !curve.is_trim) continue;
    std::vector<double> ends = places_[c], finer;
    ends.insert(ends.begin(), 0), ends.push_back(1);
    for (std::size_t k = 0; k + 1 < ends.size(); ++k) {
      if (k > 0) finer.push_back(ends[k]);
      const double middle = rounded_place((ends[k] + ends[k + 1]) / 2);
      if (middle > ends[k] && middle < ends[k + 1]) finer.push_back(middle);
    }
    kept_[c] = finer;
    put(of, c, std::move(finer), is_stale);
  }
}

bool curve_division::take_splits(const patch_faces& of, std::vector<unsigned char>& is_stale) {
  bool any = false;
  std::vector<std::vector<std::size_t>> most(places_.size());  // of a trim's chords, on a patch
  for (std::size_t p = 0; p < of.faces.size(); ++p) {
    std::vector<std::vector<std::size_t>> splits(places_.size());
    const mesh& m = of.faces[p].plane();
    for (vertex_index v = m.given; v < m.sites.size(); ++v) {
      const auto on = of.faces[p].side_of(v);
      if (!on) continue;
      const std::size_t c = of.graph.curve_of[p][static_cast<std::size_t>(on->side)];
      const side_curve& curve = of.graph.curves[c];
      if (!is_divided(curve)) continue;
      any = true;
      for (const patch_side& side : curve.sides) is_stale[side.patch] = 1;
      const double place = rounded_place(own_place(side_of_patch(curve, p, on->side), on->place));
      std::vector<double>& places = places_[c];
      const auto after = std::lower_bound(places.begin(), places.end(), place);
      if (curve.is_trim) {
        splits[c].resize(places.size() + 1);
        ++splits[c][static_cast<std::size_t>(after - places.begin())];
      } else if (after == places.end() || *after != place) {
        places.insert(after, place);
      }
    }
    for (std::size_t c = 0; c < splits.size(); ++c) {
      most[c].resize(std::max(most[c].size(), splits[c].size()));
      for (std::size_t k = 0; k < splits[c].size(); ++k)
        most[c][k] = std::max(most[c][k], splits[c][k]);
    }
  }
  for (std::size_t c = 0; c < most.size(); ++c)
    if (!most[c].empty()) places_[c] = with_halves(places_[c], most[c]);
  return any;
}

side_places curve_division::on_sides_of(const patch_faces& of, std::size_t patch) const {
  const std::size_t sides = of.borders[patch].sides();
  side_places own{std::vector<std::vector<double>>(sides), std::vector<bool>(sides)};
  for (std::size_t side = 0; side < sides; ++side) {
    const std::size_t c = of.graph.curve_of[patch][side];
    own.is_common[side] = is_divided(of.graph.curves[c]);
    for (const patch_side& at : of.graph.curves[c].sides) {
      if (at.patch != patch || at.side != static_cast<int>(side)) continue;
      for (const double place : places_[c]) own.at[side].push_back(own_place(at, place));
      if (at.backward) std::reverse(own.at[side].begin(), own.at[side].end());
    }
  }
  return own;
}

}  // namespace asterism::internal
