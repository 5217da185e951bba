// SPDX-License-Identifier: MIT
//
// Converts a domain to polygons with holes, as GeoJSON and shapely have them.
#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>

#include <algorithm>
#include <map>

#include "arguments.hpp"
#include "asterism/kernels/filtered_kernel.hpp"
#include "asterism/mesh/domain/face_map.hpp"
#include "bindings.hpp"
#include "py_domain.hpp"

namespace asterism::python {
namespace {

using ring = std::vector<vertex_index>;

// One part of the domain: the ring around it, and those around its holes.
struct covered_polygon {
  ring around;
  std::vector<ring> holes;
};

// Follows the boundary of a domain that check_domain accepted, with the domain on the left. Decides
// by exact signs only.
class boundary_walk {
 public:
  boundary_walk(const std::vector<point>& vertices,
                const std::vector<internal::covered_edge>& edges)
      : vertices_(vertices), edges_(edges), leaving_(vertices.size()), is_walked_(edges.size()) {
    for (std::size_t e = 0; e < edges.size(); ++e) leaving_[edges[e].a].push_back(e);
  }

  // Returns the rings of the closed walk from edge e, none if it was walked before. A walk that
  // meets a vertex again is divided there, so that a ring has each vertex once.
  std::vector<ring> rings_from(std::size_t e) {
    std::vector<ring> rings;
    std::map<vertex_index, std::size_t> place;
    ring open;
    while (!is_walked_[e]) {
      is_walked_[e] = true;
      const vertex_index v = edges_[e].a;
      const auto [met, is_new] = place.emplace(v, open.size());
      if (!is_new) rings.push_back(cut(open, met->second, place));
      open.push_back(v);
      e = next(e);
    }
    if (!open.empty()) rings.push_back(std::move(open));
    return rings;
  }

  // True if the domain is inside of the ring.
  bool is_counter_clockwise(const ring& r) const {
    const auto lowest = std::min_element(r.begin(), r.end(), [&](vertex_index a, vertex_index b) {
      const point &p = vertices_[a], &q = vertices_[b];
      return p.x != q.x ? p.x < q.x : p.y < q.y;
    });
    const auto at = static_cast<std::size_t>(lowest - r.begin());
    return side(r[(at + r.size() - 1) % r.size()], r[at], r[(at + 1) % r.size()]) == sign::positive;
  }

 private:
  sign side(vertex_index a, vertex_index b, vertex_index c) const {
    return kernel_.orientation(vertices_[a], vertices_[b], vertices_[c]);
  }

  // Removes the loop from place `first` on from an open walk that has returned to its vertex there.
  static ring cut(ring& open, std::size_t first, std::map<vertex_index, std::size_t>& place) {
    ring loop(open.begin() + static_cast<std::ptrdiff_t>(first), open.end());
    for (std::size_t k = first + 1; k < open.size(); ++k) place.erase(open[k]);
    open.resize(first);
    return loop;
  }

  // Returns the next edge of the boundary after edge e. Where several leave e's end, it is the
  // first one clockwise from e reversed, since the domain lies between the two.
  std::size_t next(std::size_t e) const {
    const vertex_index from = edges_[e].a, at = edges_[e].b;
    const auto turned = [&](std::size_t k) {
      const sign s = side(at, from, edges_[k].b);
      return s == sign::negative ? 0 : s == sign::zero ? 1 : 2;
    };
    return *std::min_element(leaving_[at].begin(), leaving_[at].end(),
                             [&](std::size_t k, std::size_t l) {
                               const int one = turned(k), other = turned(l);
                               if (one != other) return one < other;
                               return side(at, edges_[k].b, edges_[l].b) == sign::negative;
                             });
  }

  filtered_kernel kernel_;
  const std::vector<point>& vertices_;
  const std::vector<internal::covered_edge>& edges_;
  std::vector<std::vector<std::size_t>> leaving_;
  std::vector<bool> is_walked_;
};

// Returns the parts of the domain, in the order of their first segments. Leaves out segments
// inside. Curves are replaced by their chords.
std::vector<covered_polygon> covered_polygons(const domain& d) {
  std::vector<internal::covered_edge> edges;
  for (const segment& s : d.segments)
    if (!s.internal) edges.push_back({s.a, s.b, edges.size(), s.marker});
  const internal::face_map faces(d.vertices, edges);
  boundary_walk walk(d.vertices, edges);
  std::map<std::size_t, std::size_t> part_of_face;
  std::vector<covered_polygon> parts;
  for (std::size_t e = 0; e < edges.size(); ++e)
    for (ring& found : walk.rings_from(e)) {
      const auto [part, is_new] = part_of_face.emplace(faces.left_of(2 * e), parts.size());
      if (is_new) parts.emplace_back();
      covered_polygon& of = parts[part->second];
      if (walk.is_counter_clockwise(found))
        of.around = std::move(found);
      else
        of.holes.push_back(std::move(found));
    }
  return parts;
}

// Returns the ring's points, (n + 1, 2), the last one the first again.
py::array_t<double> points_of(const domain& d, const ring& r) {
  py::array_t<double> rows({static_cast<py::ssize_t>(r.size()) + 1, py::ssize_t{2}});
  double* to = rows.mutable_data();
  for (std::size_t k = 0; k <= r.size(); ++k) {
    const point& p = d.vertices[r[k % r.size()]];
    *to++ = p.x;
    *to++ = p.y;
  }
  return rows;
}

// Returns a list of polygons, each a list of rings, the outer one first.
py::list polygons_of(const py_domain& held) {
  const auto parts = [&] {
    const py::gil_scoped_release unlocked;
    return covered_polygons(held.shape);
  }();
  py::list all;
  for (const covered_polygon& part : parts) {
    py::list rings;
    rings.append(points_of(held.shape, part.around));
    for (const ring& hole : part.holes) rings.append(points_of(held.shape, hole));
    all.append(rings);
  }
  return all;
}

}  // namespace

void define_polygons(py::module_& m) { m.def("_polygons", &polygons_of, py::arg("domain")); }

}  // namespace asterism::python
