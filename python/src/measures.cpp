// SPDX-License-Identifier: MIT
//
// Measures each triangle of a mesh, and finds the triangles that points are in.
#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>

#include <algorithm>
#include <numeric>

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
}

}  // namespace asterism::python
