// SPDX-License-Identifier: MIT
//
// Domains: from arrays, files and the built-in ones. Every one is checked when it is made.
#include "asterism/mesh/data/domain.hpp"

#include <pybind11/numpy.h>
#include <pybind11/stl.h>

#include "arguments.hpp"
#include "asterism/mesh/domain/check_domain.hpp"
#include "asterism/mesh/domain/divide_curves.hpp"
#include "asterism/mesh/io/load_domain.hpp"
#include "asterism/mesh/io/polygons.hpp"
#include "bindings.hpp"

namespace asterism::python {
namespace {

point point_of(const double* numbers) { return {numbers[0], numbers[1]}; }

using index_array = py::array_t<std::int64_t, py::array::c_style | py::array::forcecast>;
using marker_array = py::array_t<int, py::array::c_style | py::array::forcecast>;

std::vector<segment> segments_of(const index_array& pairs,
                                 const std::optional<marker_array>& markers, std::size_t vertices) {
  const py::ssize_t count = pairs.size() / 2;
  if (pairs.size() != 0 && (pairs.ndim() != 2 || pairs.shape(1) != 2))
    throw input_error("segments: the shape (n, 2) is wanted");
  if (markers && markers->size() != count)
    throw input_error("markers: one for each segment is wanted");
  std::vector<segment> segments;
  for (py::ssize_t k = 0; k < count; ++k) {
    segment s;
    for (const py::ssize_t end : {0, 1}) {
      const std::int64_t v = pairs.data()[2 * k + end];
      if (v < 0 || v >= static_cast<std::int64_t>(vertices))
        throw input_error("segments: row " + std::to_string(k) + " names vertex " +
                          std::to_string(v) + " of " + std::to_string(vertices));
      (end == 0 ? s.a : s.b) = static_cast<vertex_index>(v);
    }
    if (markers) s.marker = markers->data()[k];
    segments.push_back(s);
  }
  return segments;
}

// Warns, as Python does, of what was passed over or put in order.
void warn(const std::vector<std::string>& notes) {
  for (const std::string& note : notes)
    if (PyErr_WarnEx(PyExc_UserWarning, note.c_str(), 2) != 0) throw py::error_already_set();
}

domain checked(const domain& d) {
  domain_repairs repairs;
  const auto accept = [&] {
    const py::gil_scoped_release unlocked;
    return check_domain(value_or_raise(divide_curves(d)), &repairs);
  };
  domain accepted = value_or_raise(accept());
  warn(d.origin.notes);
  warn(repairs.messages);
  return accepted;
}

std::string shown(const domain& d) {
  return "<Domain: " + std::to_string(d.vertices.size()) + " points, " +
         std::to_string(d.segments.size()) + " segments>";
}

domain from_arrays(const py::object& points, const index_array& segments,
                   const std::optional<marker_array>& markers, const py::object& holes,
                   const py::object& regions, const std::optional<marker_array>& region_numbers) {
  domain d;
  d.name = "arrays";
  d.origin.first_number = 0;
  const number_table at(points, 2, "points");
  for (std::size_t k = 0; k < at.rows(); ++k) d.vertices.push_back(point_of(at.row(k)));
  d.segments = segments_of(segments, markers, d.vertices.size());
  const number_table inside_holes(holes, 2, "holes"), inside_regions(regions, 2, "regions");
  for (std::size_t k = 0; k < inside_holes.rows(); ++k)
    d.holes.push_back(point_of(inside_holes.row(k)));
  const auto numbers = static_cast<std::size_t>(region_numbers ? region_numbers->size() : 0);
  if (numbers != inside_regions.rows())
    throw input_error("region_numbers: one for each region point is wanted");
  for (std::size_t k = 0; k < inside_regions.rows(); ++k)
    d.regions.push_back({point_of(inside_regions.row(k)), region_numbers->data()[k]});
  return checked(d);
}

// A view of the vertices: (n, 2), no copy.
py::array points_of(const py::object& self) {
  const auto& d = self.cast<const domain&>();
  const double* const first = d.vertices.empty() ? nullptr : &d.vertices.front().x;
  py::array_t<double> view({static_cast<py::ssize_t>(d.vertices.size()), py::ssize_t{2}}, first,
                           self);
  view.attr("setflags")(py::arg("write") = false);
  return view;
}

py::array_t<std::int32_t> segment_pairs(const domain& d) {
  py::array_t<std::int32_t> pairs({static_cast<py::ssize_t>(d.segments.size()), py::ssize_t{2}});
  auto to = pairs.mutable_unchecked<2>();
  for (std::size_t k = 0; k < d.segments.size(); ++k) {
    to(static_cast<py::ssize_t>(k), 0) = static_cast<std::int32_t>(d.segments[k].a);
    to(static_cast<py::ssize_t>(k), 1) = static_cast<std::int32_t>(d.segments[k].b);
  }
  return pairs;
}

py::array_t<int> segment_markers(const domain& d) {
  py::array_t<int> markers(static_cast<py::ssize_t>(d.segments.size()));
  for (std::size_t k = 0; k < d.segments.size(); ++k)
    markers.mutable_data()[k] = d.segments[k].marker;
  return markers;
}

}  // namespace

void define_domain(py::module_& m) {
  const py::object none = py::array_t<double>(0);
  py::class_<domain>(m, "_Domain")
      .def(py::init(&from_arrays), py::arg("points"), py::arg("segments"),
           py::arg("markers") = py::none(), py::arg("holes") = none, py::arg("regions") = none,
           py::arg("region_numbers") = py::none())
      .def_static(
          "load",
          [](const std::string& what) { return checked(value_or_raise(load_domain(what))); })
      .def_static(
          "parse_geojson",
          [](const std::string& text, const std::string& name) {
            return checked(value_or_raise(internal::parse_geojson(text, name)));
          },
          py::arg("text"), py::arg("name"))
      .def("__repr__", &shown)
      .def_property_readonly("points", &points_of)
      .def_property_readonly("segments", &segment_pairs)
      .def_property_readonly("markers", &segment_markers)
      .def_property_readonly("name", [](const domain& d) { return d.name; })
      .def_property_readonly("box", [](const domain& d) {
        const bounding_box b = d.box();
        return py::make_tuple(b.low.x, b.low.y, b.high.x, b.high.y);
      });
}

}  // namespace asterism::python
