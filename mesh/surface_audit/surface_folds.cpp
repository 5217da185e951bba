// SPDX-License-Identifier: MIT
#include "asterism/mesh/surface_audit/surface_folds.hpp"

#include <cstddef>

namespace asterism::internal {
namespace {

using place = std::array<double, 2>;

struct seen {
  place at;
  plain_vector normal;
};

seen look_at(const bezier_piece& piece, const place& at) {
  const plain_jet jet = evaluate(piece, at[0], at[1]);
  return {at, cross(jet.by_s, jet.by_t)};
}

place between(const place& a, const place& b, double share) {
  return {a[0] + share * (b[0] - a[0]), a[1] + share * (b[1] - a[1])};
}

// Halves the way between two places of opposite normals. Where both halves turn by less than 90
// degrees it is a bend, however sharp.
std::optional<place> halved(const bezier_piece& piece, seen a, seen b) {
  constexpr int halvings = 45;  // 2^-45 of a part: beyond, places are the same doubles
  for (int k = 0; k < halvings; ++k) {
    const seen middle = look_at(piece, between(a.at, b.at, 0.5));
    if (dot(a.normal, middle.normal) <= 0)
      b = middle;
    else if (dot(middle.normal, b.normal) <= 0)
      a = middle;
    else
      return std::nullopt;
  }
  return a.at;
}

}  // namespace

std::optional<std::array<double, 2>> fold_in(const bezier_piece& piece,
                                             const parameter_triangle& corners) {
  constexpr double near = 63.0 / 64;  // there is no normal at a side that is one point
  const double third = 1.0 / 3;
  std::array<place, 3> corner;
  for (std::size_t k = 0; k < 3; ++k)
    corner[k] = {middle_of(corners[k].s), middle_of(corners[k].t)};
  const place middle = {third * (corner[0][0] + corner[1][0] + corner[2][0]),
                        third * (corner[0][1] + corner[1][1] + corner[2][1])};
  std::array<seen, 4> places;
  for (std::size_t k = 0; k < 3; ++k) places[k] = look_at(piece, between(middle, corner[k], near));
  places[3] = look_at(piece, middle);
  for (std::size_t i = 0; i < 4; ++i)
    for (std::size_t j = i + 1; j < 4; ++j)
      if (dot(places[i].normal, places[j].normal) < 0)
        if (const auto fold = halved(piece, places[i], places[j])) return fold;
  return std::nullopt;
}

}  // namespace asterism::internal
