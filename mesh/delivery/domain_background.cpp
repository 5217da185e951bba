// SPDX-License-Identifier: MIT
#include "asterism/mesh/delivery/domain_background.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "asterism/core/number_text.hpp"
#include "asterism/mesh/data/site_box.hpp"
#include "asterism/mesh/numerics/nodal_sums.hpp"

namespace asterism::internal {
namespace {

double cross(const point& origin, const point& a, const point& b) {
  return (a.x - origin.x) * (b.y - origin.y) - (b.x - origin.x) * (a.y - origin.y);
}

double area_of(const mesh& m) {
  double doubled = 0;
  for (const triangle& t : m.triangles) doubled += doubled_area(m, t);
  return doubled / 2;
}

// Returns the area on the left of the boundary segments, which is the domain's.
double area_of(const domain& d) {
  double doubled = 0;
  for (const segment& s : d.segments)
    if (!s.internal) doubled += cross(d.vertices.front(), d.vertices[s.a], d.vertices[s.b]);
  return doubled / 2;
}

}  // namespace

namespace {

constexpr double allowed = 0.01;  // share of an area or of a length

// Returns the domain's first vertex that is outside of the box by more than the tolerance.
const point* first_outside(const domain& d, const bounding_box& box) {
  const double slack = allowed * std::max(box.high.x - box.low.x, box.high.y - box.low.y);
  const auto is_outside = [&](const point& q) {
    return q.x < box.low.x - slack || q.x > box.high.x + slack || q.y < box.low.y - slack ||
           q.y > box.high.y + slack;
  };
  const auto found = std::find_if(d.vertices.begin(), d.vertices.end(), is_outside);
  return found == d.vertices.end() ? nullptr : &*found;
}

}  // namespace

std::optional<std::string> note_on_uncovered(const domain& d, const metric_field& field) {
  const mesh* const given = field.background();
  if (given == nullptr) return std::nullopt;
  const double share = area_of(*given) / area_of(d);
  const point* const outside = first_outside(d, box_of_sites(given->sites));
  if (!(share < 1 - allowed) && outside == nullptr) return std::nullopt;
  const std::string where = outside != nullptr
                                ? fmt::format(", and not the vertex at ({}, {})",
                                              format_number(outside->x), format_number(outside->y))
                                : "";
  return fmt::format(
      "the mesh that the metric is given on has {} % of the domain's area{}: beyond it the metric "
      "is "
      "that of its nearest triangles",
      format_number(std::round(1000 * share) / 10), where);
}

const mesh* background_of_domain(const domain& d, const metric_field& field) {
  const mesh* const given = field.background();
  return given != nullptr && area_of(*given) <= (1 + allowed) * area_of(d) ? given : nullptr;
}

}  // namespace asterism::internal
