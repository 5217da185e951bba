// SPDX-License-Identifier: MIT
#include "asterism/mesh/surface_audit/trimmed_places.hpp"

#include <algorithm>
#include <limits>

namespace asterism::internal {
namespace {

rounded_interval between(double low, double high, double share) {
  const rounded_interval from = low;
  return from + rounded_interval(share) * (rounded_interval(high) - from);
}

parameter_box box_of(const bezier_piece& piece, const std::array<surface_place, 3>& at) {
  constexpr double infinite = std::numeric_limits<double>::infinity();
  parameter_box box{{infinite, infinite}, {-infinite, -infinite}};
  for (const surface_place& p : at) {
    const rounded_interval u = between(piece.u_low, piece.u_high, p.s),
                           v = between(piece.v_low, piece.v_high, p.t);
    box.low = {std::min(box.low[0], u.inf()), std::min(box.low[1], v.inf())};
    box.high = {std::max(box.high[0], u.sup()), std::max(box.high[1], v.sup())};
  }
  return box;
}

// Returns the barycentric coordinates of the point of a triangle's plane that is nearest to p.
std::array<double, 3> shares_of(const std::array<plain_vector, 3>& t, const plain_vector& p) {
  const plain_vector e = t[1] - t[0], f = t[2] - t[0], d = p - t[0];
  const double a = dot(e, e), b = dot(e, f), c = dot(f, f), x = dot(d, e), y = dot(d, f);
  const double area = a * c - b * b;
  if (!(area > 0)) return {1.0 / 3, 1.0 / 3, 1.0 / 3};
  const double s = (x * c - y * b) / area, r = (y * a - x * b) / area;
  return {1 - s - r, s, r};
}

std::array<double, 3> shares_in_plane(const std::array<parameter_point, 3>& t,
                                      const parameter_point& p) {
  const auto turn = [&](const parameter_point& a, const parameter_point& b) {
    return (b[0] - a[0]) * (p[1] - a[1]) - (b[1] - a[1]) * (p[0] - a[0]);
  };
  const std::array<double, 3> areas = {turn(t[1], t[2]), turn(t[2], t[0]), turn(t[0], t[1])};
  const double all = areas[0] + areas[1] + areas[2];
  if (all == 0) return {1.0 / 3, 1.0 / 3, 1.0 / 3};
  return {areas[0] / all, areas[1] / all, areas[2] / all};
}

// Returns a point of the triangle with about these coordinates, moved slightly towards the middle,
// so that rounding does not move it out.
parameter_point inner_point(const std::array<parameter_point, 3>& t, std::array<double, 3> shares) {
  constexpr double inward = 0x1p-40;
  double sum = 0;
  for (double& x : shares) x = std::clamp(x, 0.0, 1.0), sum += x;
  parameter_point p{0, 0};
  for (std::size_t k = 0; k < 3; ++k) {
    const double share = (1 - inward) * shares[k] / sum + inward / 3;
    p[0] += share * t[k][0], p[1] += share * t[k][1];
  }
  return p;
}

bool is_in(const bezier_piece& piece, const parameter_point& p) {
  return p[0] >= piece.u_low && p[0] <= piece.u_high && p[1] >= piece.v_low && p[1] <= piece.v_high;
}

parameter_corner corner_in(const bezier_piece& piece, const parameter_point& p) {
  const auto local = [](double x, double low, double high) {
    if (x == high) return rounded_interval(1);
    const rounded_interval from = low;
    return quotient(rounded_interval(x) - from, rounded_interval(high) - from);
  };
  return {local(p[0], piece.u_low, piece.u_high), local(p[1], piece.v_low, piece.v_high)};
}

held_triangle one_place(const std::vector<bezier_piece>& pieces, std::uint32_t piece,
                        const parameter_point& p) {
  const parameter_corner c = corner_in(pieces[piece], p);
  return {piece, {c, c, c}};
}

}  // namespace

bool is_on_surface(const std::vector<bezier_piece>& pieces, const trim_scene& trims,
                   const std::array<surface_place, 3>& at) {
  const bezier_piece& piece = pieces[at[0].piece];
  const trim_region& region = trims.regions[piece.patch];
  return region.is_whole() || region.side_of(box_of(piece, at)) == region_side::inside;
}

std::optional<held_triangle> places_in_origin(const std::vector<bezier_piece>& pieces,
                                              const trim_scene& trims,
                                              const trim_scene::origin& origin,
                                              const std::array<plain_vector, 3>& whole,
                                              const std::array<plain_vector, 3>& corners) {
  const patch_spans& spans = trims.spans[origin.patch];
  const plain_vector middle = (1.0 / 3) * (corners[0] + corners[1] + corners[2]);
  const parameter_point centre = inner_point(origin.at, shares_of(whole, middle));
  if (!is_within(origin.at, centre)) return std::nullopt;
  const surface_place hint = place_in(pieces, spans, centre[0], centre[1]);
  const bezier_piece& piece = pieces[hint.piece];
  if (!is_in(piece, centre)) return std::nullopt;
  held_triangle held{hint.piece, {}};
  for (std::size_t k = 0; k < 3; ++k) {
    const surface_place at = project(pieces, hint, corners[k]).at;
    const parameter_point near{piece.u_low + at.s * (piece.u_high - piece.u_low),
                               piece.v_low + at.t * (piece.v_high - piece.v_low)};
    const parameter_point p = inner_point(origin.at, shares_in_plane(origin.at, near));
    if (!is_in(piece, p) || !is_within(origin.at, p)) return one_place(pieces, hint.piece, centre);
    held.corners[k] = corner_in(piece, p);
  }
  return held;
}

}  // namespace asterism::internal
