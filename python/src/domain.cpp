// SPDX-License-Identifier: MIT
//
// Domains: from arrays, files and the built-in ones. Every one is checked when it is made.
#include "asterism/mesh/data/domain.hpp"

#include <pybind11/numpy.h>
#include <pybind11/stl.h>

#include "arguments.hpp"
#include "asterism/mesh/domain/check_domain.hpp"
#include "asterism/mesh/domain/convex_hull.hpp"
#include "asterism/mesh/domain/divide_curves.hpp"
#include "asterism/mesh/domain/repair_domain.hpp"
#include "asterism/mesh/io/geojson.hpp"
#include "asterism/mesh/io/load_domain.hpp"
#include "bindings.hpp"
#include "py_domain.hpp"
#include "states.hpp"

namespace asterism::python {
namespace {

point point_of(const double* numbers) { return {numbers[0], numbers[1]}; }

std::vector<int> markers_of(const py::object& markers, py::ssize_t count, const char* name,
                            const char* of_what) {
  const whole_array numbers = wholes_of(markers, name);
  if (numbers.size() != count)
    throw input_error(std::string(name) + ": one for each " + of_what + " is wanted, " +
                      std::to_string(count) + ", not " + std::to_string(numbers.size()));
  std::vector<int> all;
  for (py::ssize_t k = 0; k < count; ++k) {
    const std::int64_t n = numbers.data()[k];
    if (n != static_cast<int>(n))
      throw input_error(std::string(name) + ": number " + std::to_string(k) + " is " +
                        std::to_string(n) + ", which takes more than 32 bits");
    all.push_back(static_cast<int>(n));
  }
  return all;
}

std::vector<segment> segments_of(const py::object& given, const py::object& markers,
                                 std::size_t vertices) {
  const whole_array pairs = wholes_of(given, "segments");
  const py::ssize_t count = pairs.size() / 2;
  if (pairs.size() != 0 && (pairs.ndim() != 2 || pairs.shape(1) != 2))
    throw input_error("segments: the shape (n, 2) is wanted, not " + shape_text(pairs));
  std::vector<int> marked;
  if (!markers.is_none()) marked = markers_of(markers, count, "markers", "segment");
  std::vector<segment> segments;
  for (py::ssize_t k = 0; k < count; ++k) {
    segment s;
    for (const py::ssize_t end : {0, 1}) {
      const std::int64_t v = pairs.data()[2 * k + end];
      if (v < 0 || v >= static_cast<std::int64_t>(vertices))
        throw input_error("segments: row " + std::to_string(k) + " names point " +
                          std::to_string(v) + " of " + std::to_string(vertices) +
                          ", which count from 0");
      (end == 0 ? s.a : s.b) = static_cast<vertex_index>(v);
    }
    if (!marked.empty()) s.marker = marked[static_cast<std::size_t>(k)];
    segments.push_back(s);
  }
  return segments;
}

// Holds whether to repair a domain, and within which distance; if none is given, within the least
// that suffices.
struct repair_wish {
  bool is_wanted = false;
  std::optional<double> distance;
};

repair_wish repair_of(const py::object& given) {
  if (given.is_none() || PyBool_Check(given.ptr())) return {given.ptr() == Py_True, std::nullopt};
  py::dict words;
  words["repair"] = given;
  return {true, keywords(words).positive("repair")};
}

// Adds to a refusal that repair=True mends the domain, if it does.
error with_remedy(const error& refusal, const domain& d) {
  constexpr double units = 2e4;  // in units of kernels/work_units.hpp, ten microseconds each
  domain_repairs repairs;
  if (!repair_domain(d, {}, &repairs, cancellation().with_work(units))) return refusal;
  return {refusal.message + "; repair=True mends it: " + repairs.messages.front(), refusal.code};
}

result<domain> accepted(const domain& d, const repair_wish& repair, domain_repairs& mended) {
  const py::gil_scoped_release unlocked;
  const bool has_curves = !d.curves.empty();
  if (repair.is_wanted && !has_curves) return repair_domain(d, repair.distance, &mended);
  const auto divided = divide_curves(d);
  auto checked = divided ? check_domain(divided.value(), &mended) : divided;
  if (checked || !divided) return checked;
  if (repair.is_wanted)
    return error{checked.failure().message +
                 "; no domain with curves is repaired, because what moves would leave its curve"};
  return with_remedy(checked.failure(), d);
}

// Adds the sides of the convex hull of the points, if they are asked for.
domain closed(domain d, bool by_hull) {
  if (!by_hull) return d;
  auto made = internal::with_convex_hull(std::move(d));
  if (!made) throw input_error("convex_hull: " + made.failure().message);
  return std::move(made).value();
}

py_domain checked(domain given, const py::object& repair, bool by_hull) {
  const domain d = closed(std::move(given), by_hull);
  py_domain made;
  made.shape = value_or_raise(accepted(d, repair_of(repair), made.mended));
  warn(d.origin.notes);
  warn(made.mended.messages);
  return made;
}

py_domain from_arrays(const py::object& points, const py::object& segments,
                      const py::object& markers, const py::object& holes, const py::object& regions,
                      const py::object& region_numbers, const py::object& repair, bool by_hull) {
  domain d;
  d.name = "arrays";
  d.origin.first_number = 0;
  const number_table at(points, 2, "points");
  for (std::size_t k = 0; k < at.rows(); ++k) d.vertices.push_back(point_of(at.row(k)));
  d.segments = segments_of(segments, markers, d.vertices.size());
  const number_table inside_holes(holes, 2, "holes"), inside_regions(regions, 2, "regions");
  for (std::size_t k = 0; k < inside_holes.rows(); ++k)
    d.holes.push_back(point_of(inside_holes.row(k)));
  std::vector<int> numbers;
  const auto count = static_cast<py::ssize_t>(inside_regions.rows());
  if (!region_numbers.is_none() || count > 0)
    numbers = markers_of(region_numbers.is_none() ? py::object(py::list()) : region_numbers, count,
                         "region_numbers", "region point");
  for (std::size_t k = 0; k < inside_regions.rows(); ++k)
    d.regions.push_back({point_of(inside_regions.row(k)), numbers[k]});
  return checked(std::move(d), repair, by_hull);
}

// A view of the vertices: (n, 2), no copy.
py::array points_of(const py::object& self) {
  const auto& d = self.cast<const py_domain&>().shape;
  const double* const first = d.vertices.empty() ? nullptr : &d.vertices.front().x;
  py::array_t<double> view({static_cast<py::ssize_t>(d.vertices.size()), py::ssize_t{2}}, first,
                           self);
  view.attr("setflags")(py::arg("write") = false);
  return view;
}

py::array_t<std::int32_t> segment_pairs(const py_domain& held) {
  const domain& d = held.shape;
  py::array_t<std::int32_t> pairs({static_cast<py::ssize_t>(d.segments.size()), py::ssize_t{2}});
  auto to = pairs.mutable_unchecked<2>();
  for (std::size_t k = 0; k < d.segments.size(); ++k) {
    to(static_cast<py::ssize_t>(k), 0) = static_cast<std::int32_t>(d.segments[k].a);
    to(static_cast<py::ssize_t>(k), 1) = static_cast<std::int32_t>(d.segments[k].b);
  }
  return pairs;
}

py::array_t<int> segment_markers(const py_domain& held) {
  py::array_t<int> markers(static_cast<py::ssize_t>(held.shape.segments.size()));
  for (std::size_t k = 0; k < held.shape.segments.size(); ++k)
    markers.mutable_data()[k] = held.shape.segments[k].marker;
  return markers;
}

py::list repairs_of(const py_domain& held) {
  py::list all;
  for (const repair_place& p : held.mended.places)
    all.append(py::make_tuple(p.what, p.at.x, p.at.y));
  return all;
}

}  // namespace

void define_domain(py::module_& m) {
  const py::object none = py::array_t<double>(0);
  py::class_<py_domain>(m, "_Domain")
      .def(py::init(&from_arrays), py::arg("points"), py::arg("segments"),
           py::arg("markers") = py::none(), py::arg("holes") = none, py::arg("regions") = none,
           py::arg("region_numbers") = py::none(), py::arg("repair") = false,
           py::arg("convex_hull") = false)
      .def_static(
          "load",
          [](const system_text& what, const py::object& repair, bool by_hull) {
            return checked(value_or_raise(load_domain(what.bytes)), repair, by_hull);
          },
          py::arg("what"), py::arg("repair") = false, py::arg("convex_hull") = false)
      .def_static(
          "parse_geojson",
          [](const std::string& text, const std::string& name, const py::object& repair,
             bool by_hull) {
            return checked(value_or_raise(internal::parse_geojson(text, name)), repair, by_hull);
          },
          py::arg("text"), py::arg("name"), py::arg("repair") = false,
          py::arg("convex_hull") = false)
      .def(
          "repaired",
          [](const py_domain& d, const py::object& repair, bool by_hull) {
            return checked(d.shape, repair, by_hull);
          },
          py::arg("repair"), py::arg("convex_hull") = false)
      .def(py::pickle([](const py_domain& d) { return state_of(d); }, &domain_of_state))
      .def_property_readonly("points", &points_of)
      .def_property_readonly("segments", &segment_pairs)
      .def_property_readonly("markers", &segment_markers)
      .def_property_readonly("repairs", &repairs_of)
      .def_property_readonly("name", [](const py_domain& d) { return system_text{d.shape.name}; })
      .def_property_readonly("has_curves",
                             [](const py_domain& d) { return !d.shape.curves.empty(); })
      .def_property_readonly("box", [](const py_domain& d) {
        const bounding_box b = d.shape.box();
        return py::make_tuple(b.low.x, b.low.y, b.high.x, b.high.y);
      });
}

}  // namespace asterism::python
