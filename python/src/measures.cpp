// SPDX-License-Identifier: MIT
//
// Measures each triangle of a mesh, numbers edges, and finds the triangles that points are in.
#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <numeric>
#include <vector>

#include "arguments.hpp"
#include "asterism/mesh/numerics/mesh_statistics.hpp"
#include "asterism/mesh/numerics/metric_angle.hpp"
#include "asterism/mesh/numerics/metric_length.hpp"
#include "asterism/mesh/pipeline/read_triangulation.hpp"
#include "asterism/mesh/search/hilbert_order.hpp"
#include "asterism/mesh/search/mesh_links.hpp"
#include "asterism/mesh/transfer/triangle_finder.hpp"
#include "bindings.hpp"
#include "py_mesh.hpp"

namespace asterism::python {
namespace {

triangle_sites sites_of(const mesh& m, const triangle& t) {
  return {m.sites[t[0]], m.sites[t[1]], m.sites[t[2]]};
}

// Returns the least angle at each corner, in degrees, over the metrics of the triangle's three
// corners.
std::array<double, 3> angles_of(const triangle_sites& t) {
  std::array<double, 3> least{180, 180, 180};
  for (std::size_t i = 0; i < 3; ++i)
    for (const site& measuring : t)
      least[i] = std::min(
          least[i], internal::angle_in_metric(measuring.metric, t[i].position,
                                              t[(i + 1) % 3].position, t[(i + 2) % 3].position));
  return least;
}

// Returns the length of the side opposite to each corner.
std::array<double, 3> lengths_of(const triangle_sites& t) {
  std::array<double, 3> lengths{};
  for (std::size_t i = 0; i < 3; ++i)
    lengths[i] = internal::edge_length(t[(i + 1) % 3], t[(i + 2) % 3]);
  return lengths;
}

template <class Measure>
py::array_t<double> of_each_corner(const py_mesh& held, const Measure& measure) {
  const mesh& m = held.content;
  py::array_t<double> table({static_cast<py::ssize_t>(m.triangles.size()), py::ssize_t{3}});
  double* to = table.mutable_data();
  const py::gil_scoped_release unlocked;
  for (const triangle& t : m.triangles)
    for (const double x : measure(sites_of(m, t))) *to++ = x;
  return table;
}

py::array_t<double> qualities(const py_mesh& held) {
  const mesh& m = held.content;
  py::array_t<double> column(static_cast<py::ssize_t>(m.triangles.size()));
  double* to = column.mutable_data();
  const py::gil_scoped_release unlocked;
  for (const triangle& t : m.triangles) *to++ = shape_of(sites_of(m, t)).quality;
  return column;
}

// Refuses a mesh in which no triangle can be searched for.
void check_triangulation(const py_mesh& held) {
  value_or_raise(internal::checked_triangulation(held.content, "the mesh", slit_rule::joined));
}

std::int32_t number_or_none(vertex_index t) {
  return t == internal::no_triangle ? -1 : static_cast<std::int32_t>(t);
}

py::array_t<std::int32_t> neighbours(const py_mesh& held) {
  const mesh& m = held.content;
  py::array_t<std::int32_t> table({static_cast<py::ssize_t>(m.triangles.size()), py::ssize_t{3}});
  std::int32_t* to = table.mutable_data();
  const py::gil_scoped_release unlocked;
  check_triangulation(held);
  const internal::mesh_links links(m);
  for (vertex_index t = 0; t < m.triangles.size(); ++t)
    for (std::size_t i = 0; i < 3; ++i) *to++ = number_or_none(links.across(t, i));
  return table;
}

std::vector<point> points_of(const py::object& points) {
  const number_table at(points, 2, "points");
  std::vector<point> places;
  for (std::size_t k = 0; k < at.rows(); ++k) {
    places.push_back({at.row(k)[0], at.row(k)[1]});
    if (!std::isfinite(places[k].x) || !std::isfinite(places[k].y))
      throw input_error("points: row " + std::to_string(k) + " is not finite");
  }
  return places;
}

py::array_t<std::int32_t> located(const py_mesh& held, const py::object& points) {
  const std::vector<point> places = points_of(points);
  py::array_t<std::int32_t> column(static_cast<py::ssize_t>(places.size()));
  std::int32_t* to = column.mutable_data();
  const py::gil_scoped_release unlocked;
  check_triangulation(held);
  for (const vertex_index t : internal::locate_points(held.content, places))
    *to++ = number_or_none(t);
  return column;
}

// Returns the numbers of points in their order along a curve through their box.
py::array_t<std::int32_t> order_along_curve(const py::object& points) {
  const std::vector<point> places = points_of(points);
  std::vector<std::uint32_t> order(places.size());
  std::iota(order.begin(), order.end(), 0U);
  if (!places.empty()) {
    bounding_box box{places.front(), places.front()};
    for (const point& p : places) box.include(p);
    internal::sort_along_curve(order, places, box);
  }
  py::array_t<std::int32_t> column(static_cast<py::ssize_t>(order.size()));
  std::copy(order.begin(), order.end(), column.mutable_data());
  return column;
}

// Edges by their two ends, in the order in which triangles come upon them, chained at the lesser
// end: an edge is found in a few steps, without a sort.
class edge_numbers {
 public:
  explicit edge_numbers(std::size_t points) : first_(points, -1) {}

  // Returns the number of the edge from a to b, a new one where it is not there yet.
  std::int32_t number_of(std::int64_t a, std::int64_t b) {
    std::int32_t* next = &first_[static_cast<std::size_t>(std::min(a, b))];
    const std::int64_t greater = std::max(a, b);
    while (*next >= 0 && greater_[static_cast<std::size_t>(*next)] != greater)
      next = &next_[static_cast<std::size_t>(*next)];
    if (*next >= 0) return *next;
    const auto number = static_cast<std::int32_t>(ends_.size());
    *next = number;  // before next_ grows, which moves what it points to
    ends_.push_back({a, b});
    greater_.push_back(greater);
    next_.push_back(-1);
    return number;
  }
  const std::vector<std::array<std::int64_t, 2>>& ends() const { return ends_; }

 private:
  std::vector<std::int32_t> first_, next_;
  std::vector<std::int64_t> greater_;
  std::vector<std::array<std::int64_t, 2>> ends_;
};

// Returns the ends of all edges, each as the first triangle that has it runs along it, and the
// numbers of each triangle's sides 01, 12 and 20.
py::tuple numbered_edges(const py::object& triangles, std::size_t points) {
  const whole_array corners = wholes_of(triangles, "triangles");
  if (corners.ndim() != 2 || corners.shape(1) != 3)
    throw input_error("triangles: rows of three numbers of points are wanted");
  py::array_t<std::int64_t> sides({corners.shape(0), py::ssize_t{3}});
  std::int64_t* side = sides.mutable_data();
  const std::int64_t* t = corners.data();
  if (std::any_of(t, t + corners.size(),
                  [&](std::int64_t v) { return v < 0 || static_cast<std::size_t>(v) >= points; }))
    throw input_error("triangles: a number of no point");
  edge_numbers edges(points);
  for (py::ssize_t k = 0; k < corners.shape(0); ++k, t += 3)
    for (std::size_t i = 0; i < 3; ++i) *side++ = edges.number_of(t[i], t[(i + 1) % 3]);
  py::array_t<std::int64_t> ends({static_cast<py::ssize_t>(edges.ends().size()), py::ssize_t{2}});
  std::int64_t* to = ends.mutable_data();
  for (const auto& [a, b] : edges.ends()) *to++ = a, *to++ = b;
  return py::make_tuple(ends, sides);
}

}  // namespace

void define_measures(py::module_& m) {
  m.def(
      "_angles", [](const py_mesh& held) { return of_each_corner(held, angles_of); },
      py::arg("mesh"));
  m.def(
      "_lengths", [](const py_mesh& held) { return of_each_corner(held, lengths_of); },
      py::arg("mesh"));
  m.def("_qualities", &qualities, py::arg("mesh"));
  m.def("_neighbors", &neighbours, py::arg("mesh"));
  m.def("_locate", &located, py::arg("mesh"), py::arg("points"));
  m.def("_order_along_curve", &order_along_curve, py::arg("points"));
  m.def("_numbered_edges", &numbered_edges, py::arg("triangles"), py::arg("points"));
}

}  // namespace asterism::python
