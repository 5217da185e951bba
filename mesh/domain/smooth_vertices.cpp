// SPDX-License-Identifier: MIT
#include "asterism/mesh/domain/smooth_vertices.hpp"

#include <cstddef>

#include "asterism/core/elementary.hpp"
#include "asterism/mesh/domain/curve_path.hpp"

namespace asterism::internal {
namespace {

// Directions in which the curves of chords leave a vertex.
struct leaving {
  std::size_t segments = 0, curves = 0;
  point sum;  // of unit vectors, so of opposite ones nothing
};

}  // namespace

std::vector<vertex_index> smooth_vertices(const domain& d) {
  if (d.curves.empty()) return {};
  std::vector<leaving> at(d.vertices.size());
  for (const segment& s : d.segments)
    for (const vertex_index v : {s.a, s.b}) ++at[v].segments;
  const auto leave = [&at](vertex_index v, const point& direction, double sign) {
    const double length = elementary::hypot(direction.x, direction.y);
    ++at[v].curves;
    at[v].sum.x += sign * direction.x / length;
    at[v].sum.y += sign * direction.y / length;
  };
  for (const domain_curve& c : d.curves) {
    const curve_path path(c, d.vertices[c.vertices.front()], d.vertices[c.vertices.back()]);
    for (std::size_t i = 0; i < c.vertices.size(); ++i) {
      const point along = path.derivative(c.parameters[i]);
      if (i > 0) leave(c.vertices[i], along, -1);
      if (i + 1 < c.vertices.size()) leave(c.vertices[i], along, 1);
    }
  }
  constexpr double rounding =
      1e-9;  // an arc may end a millionth off its circle, and is a corner then
  std::vector<vertex_index> smooth;
  for (vertex_index v = 0; v < at.size(); ++v)
    if (at[v].segments == 2 && at[v].curves == 2 &&
        elementary::hypot(at[v].sum.x, at[v].sum.y) < rounding)
      smooth.push_back(v);
  return smooth;
}

}  // namespace asterism::internal
