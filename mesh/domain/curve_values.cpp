// SPDX-License-Identifier: MIT
#include "asterism/mesh/domain/curve_values.hpp"

#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "asterism/core/number_text.hpp"
#include "asterism/mesh/domain/message_names.hpp"
#include "asterism/mesh/domain/point_algebra.hpp"

namespace asterism::internal {
namespace {

// Returns the distance of two points; infinite or NaN where its square is.
double distance(const point& a, const point& b) {
  const double x = a.x - b.x, y = a.y - b.y;
  return std::sqrt(x * x + y * y);
}

// Returns the fault in the vertices and the segment of a curve, or nothing.
std::string fault_of_segment(const domain& d, const domain_curve& c, std::vector<char>& taken) {
  const domain_names names(d);
  if (c.vertices.size() != 2 || c.parameters != std::vector<double>{0, 1})
    return " is divided already";
  if (c.segment >= d.segments.size()) return " is on a segment that does not exist";
  const segment& s = d.segments[c.segment];
  for (const vertex_index v : {s.a, s.b})
    if (v >= d.vertices.size()) return " is on a segment that uses a vertex that does not exist";
  for (const vertex_index v : {s.a, s.b})
    if (!is_finite(d.vertices[v])) return ": " + names.vertex(v) + " is not finite";
  const vertex_index from = c.vertices.front(), to = c.vertices.back();
  if (!(s.a == from && s.b == to) && !(s.a == to && s.b == from))
    return " does not end where " + names.segment(c.segment) + " does";
  if (std::exchange(taken[c.segment], 1) != 0)
    return " is on " + names.segment(c.segment) + ", which another curve is on";
  const bool is_circle = c.kind == curve_kind::arc && from == to;
  if (!is_circle && d.vertices[from] == d.vertices[to])
    return " is on " + names.segment(c.segment) + ", which has no length";
  return "";
}

std::string fault_of_arc(const domain& d, const domain_curve& c) {
  // Accepts a difference that coordinates with six digits explain.
  constexpr double digits = 1e-6;
  const domain_names names(d);
  if (!is_finite(c.centre)) return ": the centre is not finite";
  const vertex_index from = c.vertices.front(), to = c.vertices.back();
  const double first = distance(d.vertices[from], c.centre);
  const double last = distance(d.vertices[to], c.centre);
  if (!std::isfinite(first) || !std::isfinite(last))
    return ": the radius is beyond the range of doubles";
  if (!(first > 0) || !(last > 0))
    return " has a radius of 0: " + names.vertex(first > 0 ? to : from) + " is its centre";
  if (std::abs(first - last) <= digits * first) return "";
  return " does not end on its circle: from the centre " + coordinates(c.centre) + " it is " +
         number_text(first) + " to " + names.vertex(from) + ", and " + number_text(last) + " to " +
         names.vertex(to);
}

std::string fault_of(const domain& d, const domain_curve& c, std::vector<char>& taken) {
  std::string fault = fault_of_segment(d, c, taken);
  if (!fault.empty()) return fault;
  if (c.kind == curve_kind::arc) return fault_of_arc(d, c);
  for (const point& p : c.control)
    if (!is_finite(p)) return ": a control point is not finite";
  return "";
}

}  // namespace

std::optional<error> check_curve_values(const domain& d) {
  const domain_names names(d);
  std::vector<char> taken(d.segments.size(), 0);
  for (std::size_t i = 0; i < d.curves.size(); ++i) {
    const std::string fault = fault_of(d, d.curves[i], taken);
    if (!fault.empty()) return error{names.at_curve(i) + names.curve(i) + fault};
  }
  return std::nullopt;
}

}  // namespace asterism::internal
