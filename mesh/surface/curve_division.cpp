// SPDX-License-Identifier: MIT
#include "asterism/mesh/surface/curve_division.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace asterism::internal {
namespace {

// Places on curves are multiples of this, so that a place and 1 less it are both exact.
constexpr double place_unit = 0x1p-30;
constexpr int side_samples = 256;  // of the length of a curve

double rounded_place(double x) {
  return std::clamp(std::round(x / place_unit) * place_unit, place_unit, 1 - place_unit);
}

bool is_common(const side_curve& curve) { return !curve.is_point && curve.sides.size() == 2; }

// The metric length of a curve, the greater of what its two patches say at each place.
double length_of(const patch_faces& of, const side_curve& curve, std::vector<double>& sums) {
  sums.assign(1, 0);
  for (int k = 0; k < side_samples; ++k) {
    const double place = (k + 0.5) / side_samples;
    double density = 0;
    for (const patch_side& side : curve.sides) {
      const surface_chart& chart = of.charts[side.patch];
      const metric_tensor m = of.faces[side.patch].metric_at(chart_point(chart, side, place));
      const double width = chart.high().x - chart.low().x, height = chart.high().y - chart.low().y;
      density =
          std::max(density, side.side % 2 == 0 ? m.m11 * width * width : m.m22 * height * height);
    }
    sums.push_back(sums.back() + std::sqrt(density) / side_samples);
  }
  return sums.back();
}

std::vector<double> equal_parts(const std::vector<double>& sums) {
  constexpr double longest_part = 0.95;
  const double length = sums.back();
  const auto parts = static_cast<int>(std::max(1.0, std::ceil(length / longest_part)));
  std::vector<double> places;
  std::size_t k = 0;
  for (int part = 1; part < parts; ++part) {
    const double wanted = length * part / parts;
    while (sums[k + 1] < wanted) ++k;
    const double share = (wanted - sums[k]) / (sums[k + 1] - sums[k]);
    const double place = rounded_place((static_cast<double>(k) + share) / side_samples);
    if (places.empty() || place > places.back()) places.push_back(place);
  }
  return places;
}

}  // namespace

point chart_point(const surface_chart& chart, const patch_side& side, double place) {
  const point low = chart.low(), high = chart.high();
  const double own = own_place(side, place);
  const double x = low.x + own * (high.x - low.x), y = low.y + own * (high.y - low.y);
  return side.side == 0   ? point{x, low.y}
         : side.side == 1 ? point{high.x, y}
         : side.side == 2 ? point{x, high.y}
                          : point{low.x, y};
}

const patch_side& side_of_patch(const side_curve& curve, std::size_t patch, int side) {
  const patch_side& first = curve.sides[0];
  return first.patch == patch && first.side == side ? first : curve.sides[1];
}

void curve_division::divide(const patch_faces& of, std::vector<unsigned char>& is_stale) {
  std::vector<double> sums;
  for (std::size_t c = 0; c < of.graph.curves.size(); ++c) {
    const side_curve& curve = of.graph.curves[c];
    if (!is_common(curve)) continue;
    length_of(of, curve, sums);
    std::vector<double> places = equal_parts(sums);
    if (places == places_[c]) continue;
    places_[c] = std::move(places);
    for (const patch_side& side : curve.sides) is_stale[side.patch] = 1;
  }
}

bool curve_division::take_splits(const patch_faces& of, std::vector<unsigned char>& is_stale) {
  bool any = false;
  for (std::size_t p = 0; p < of.faces.size(); ++p) {
    const mesh& m = of.faces[p].plane();
    for (vertex_index v = m.given; v < m.sites.size(); ++v) {
      const auto on = of.faces[p].side_of(v);
      if (!on) continue;
      const std::size_t c = of.graph.curve_of[p][static_cast<std::size_t>(on->side)];
      const side_curve& curve = of.graph.curves[c];
      if (!is_common(curve)) continue;
      const double place = rounded_place(own_place(side_of_patch(curve, p, on->side), on->place));
      std::vector<double>& places = places_[c];
      const auto after = std::lower_bound(places.begin(), places.end(), place);
      any = true;
      if (after == places.end() || *after != place) places.insert(after, place);
      for (const patch_side& side : curve.sides) is_stale[side.patch] = 1;
    }
  }
  return any;
}

side_places curve_division::on_sides_of(const patch_faces& of, std::size_t patch) const {
  side_places own;
  for (std::size_t side = 0; side < 4; ++side) {
    const std::size_t c = of.graph.curve_of[patch][side];
    own.is_common[side] = is_common(of.graph.curves[c]);
    for (const patch_side& at : of.graph.curves[c].sides) {
      if (at.patch != patch || at.side != static_cast<int>(side)) continue;
      for (const double place : places_[c]) own.at[side].push_back(own_place(at, place));
      if (at.backward) std::reverse(own.at[side].begin(), own.at[side].end());
    }
  }
  return own;
}

}  // namespace asterism::internal
