// SPDX-License-Identifier: MIT
//
// Meshes as numpy sees them: views of the library's own arrays, which live as long as a view does.
#include <pybind11/numpy.h>
#include <pybind11/stl.h>

#include <algorithm>
#include <filesystem>
#include <limits>
#include <map>
#include <optional>
#include <utility>

#include "arguments.hpp"
#include "asterism/mesh/domain/mesh_outline.hpp"
#include "asterism/mesh/domain/smooth_vertices.hpp"
#include "asterism/mesh/draw/picture.hpp"
#include "asterism/mesh/io/clockwise_triangles.hpp"
#include "asterism/mesh/io/fields_of_mesh.hpp"
#include "asterism/mesh/io/file_kinds.hpp"
#include "asterism/mesh/io/medit.hpp"
#include "asterism/mesh/io/medit_edges.hpp"
#include "asterism/mesh/io/read_mesh.hpp"
#include "asterism/mesh/io/write_mesh.hpp"
#include "asterism/mesh/numerics/mesh_statistics.hpp"
#include "asterism/mesh/pipeline/foreign_mesh.hpp"
#include "asterism/mesh/pipeline/joined_marks.hpp"
#include "asterism/mesh/pipeline/read_triangulation.hpp"
#include "asterism/mesh/support/tensor_text.hpp"
#include "bindings.hpp"
#include "pages.hpp"
#include "py_domain.hpp"
#include "py_mesh.hpp"
#include "slits.hpp"
#include "solution_arguments.hpp"
#include "states.hpp"

namespace asterism::python {
namespace {

template <class Number, class Row>
py::array_t<Number> view(const py::object& self, const std::vector<Row>& rows, py::ssize_t offset,
                         py::ssize_t width) {
  const auto* const first =
      rows.empty() ? nullptr : reinterpret_cast<const Number*>(rows.data()) + offset;
  py::array_t<Number> seen(
      {static_cast<py::ssize_t>(rows.size()), width},
      {static_cast<py::ssize_t>(sizeof(Row)), static_cast<py::ssize_t>(sizeof(Number))}, first,
      self);
  seen.attr("setflags")(py::arg("write") = false);
  return seen;
}

const mesh& content_of(const py::object& self) { return self.cast<const py_mesh&>().content; }

py::array_t<std::int32_t> edges_of(const mesh& m) {
  py::array_t<std::int32_t> edges({static_cast<py::ssize_t>(m.boundary.size()), py::ssize_t{2}});
  auto to = edges.mutable_unchecked<2>();
  for (std::size_t k = 0; k < m.boundary.size(); ++k) {
    to(static_cast<py::ssize_t>(k), 0) = static_cast<std::int32_t>(m.boundary[k].a);
    to(static_cast<py::ssize_t>(k), 1) = static_cast<std::int32_t>(m.boundary[k].b);
  }
  return edges;
}

template <class Value>
py::array_t<int> one_each(std::size_t count, const Value& value) {
  py::array_t<int> column(static_cast<py::ssize_t>(count));
  for (std::size_t k = 0; k < count; ++k) column.mutable_data()[k] = value(k);
  return column;
}

std::string svg_of(const py_mesh& m, int width, bool ellipses) {
  picture_options options;
  options.width = width;
  options.ellipses = ellipses;
  options.angle_bound = m.angle_bound;
  const py::gil_scoped_release unlocked;
  return value_or_raise(draw_picture(m.content, picture_format::svg, options));
}

// True if the format has a place for fields, in the file or beside it, or shows them.
bool holds_fields(mesh_format format) {
  return internal::kept_in(format).fields || format == mesh_format::html;
}

// Returns a mesh from elsewhere as it is written: the vertices that must stay are required, and all
// others, which `smooth` gets, may go where the file is adapted.
mesh with_required(const py_mesh& m, std::vector<vertex_index>& smooth) {
  mesh written = m.content;
  std::vector<char> stays(written.sites.size(), 0);
  for (const auto* list : {&m.marks.corners, &m.marks.required_vertices})
    for (const vertex_index v : *list) stays.at(v) = 1;
  written.given = static_cast<vertex_index>(written.sites.size());
  for (vertex_index v = 0; v < written.given; ++v)
    if (stays[v] == 0) smooth.push_back(v);
  return written;
}

std::vector<system_text> save_unlocked(const py_mesh& m, const std::filesystem::path& path,
                                       const solution& fields) {
  const py::gil_scoped_release unlocked;
  write_options options;
  options.picture.angle_bound = m.angle_bound;
  options.report = facts_of(m, path.filename().string());
  options.report.fields = fields;
  if (!fields.fields.empty()) options.fields = &fields;
  options.names = m.names;
  if (m.claim && m.claim->original) options.smooth = internal::smooth_vertices(*m.claim->original);
  if (m.claim && !m.certified) options.note = "Incomplete, not certified: " + m.reason;
  std::optional<mesh> changed;
  if (!m.claim && m.content.given == 0 &&
      !(m.marks.corners.empty() && m.marks.required_vertices.empty()))
    changed = with_required(m, options.smooth);
  std::vector<system_text> names;
  for (const auto& file : value_or_raise(write_mesh(path, changed ? *changed : m.content, options)))
    names.push_back({file.string()});
  if (m.claim) {
    auto beside = path;
    beside.replace_extension(".certificate.json");
    names.push_back({value_or_raise(write_certificate(beside, *m.claim)).string()});
  }
  return names;
}

std::vector<system_text> save(const py_mesh& m, const system_text& path,
                              const named_fields& values) {
  const std::string& name = path.bytes;
  const solution fields = solution_of(values, m.content.sites.size());
  std::vector<system_text> names = save_unlocked(m, name, fields);
  const auto format = mesh_format_of(name);
  if (!fields.fields.empty() && format && !holds_fields(format.value()))
    warn({name + ": values have no place in it and are left out"});
  return names;
}

vertex_index point_number(const whole_array& table, const char* name, py::ssize_t row,
                          py::ssize_t column, std::size_t points) {
  const std::int64_t v = table.data()[table.shape(1) * row + column];
  if (v < 0 || v >= static_cast<std::int64_t>(points))
    throw input_error(std::string(name) + ": row " + std::to_string(row) + " names point " +
                      std::to_string(v) + " of " + std::to_string(points) + ", which count from 0");
  return static_cast<vertex_index>(v);
}

// Refuses a mask, of which True and False would be the numbers 1 and 0.
whole_array numbers_of_points(const py::object& given, const char* name) {
  const auto array = py::array::ensure(given);
  if (array && array.size() != 0 && array.dtype().kind() == 'b')
    throw input_error(std::string(name) +
                      ": numbers of points are wanted, not a mask; np.flatnonzero(mask) has them");
  if (!array) PyErr_Clear();
  return wholes_of(given, name);
}

// Returns a table of point numbers with `width` in a row.
whole_array point_numbers(const py::object& given, const char* name, py::ssize_t width) {
  whole_array table = numbers_of_points(given, name);
  if (table.ndim() != 2 || table.shape(1) != width)
    throw input_error(std::string(name) + ": the shape (n, " + std::to_string(width) +
                      ") is wanted, not " + shape_text(table));
  return table;
}

// Returns whole numbers that an int holds, one for each of `count`.
std::vector<int> numbers_of(const py::object& given, const char* name, std::size_t count,
                            const char* of_what) {
  const whole_array numbers = wholes_of(given, name);
  if (numbers.ndim() != 1 || static_cast<std::size_t>(numbers.size()) != count)
    throw input_error(std::string(name) + ": the shape (" + std::to_string(count) +
                      ",) is wanted, one for each " + of_what + ", not " + shape_text(numbers));
  std::vector<int> found;
  for (std::size_t k = 0; k < count; ++k) {
    const std::int64_t n = numbers.data()[k];
    if (n < std::numeric_limits<int>::min() || n > std::numeric_limits<int>::max())
      throw input_error(std::string(name) + ": number " + std::to_string(k) + " is " +
                        std::to_string(n) + ", which takes more than 32 bits");
    found.push_back(static_cast<int>(n));
  }
  return found;
}

std::string row_text(const char* name, std::size_t row, vertex_index a, vertex_index b) {
  return std::string(name) + ": row " + std::to_string(row) + ", (" + std::to_string(a) + ", " +
         std::to_string(b) + "),";
}

// Refuses edges that no triangle has, and an edge with two markers. Leaves out edges that are
// listed again, with a note.
void put_edges_in_order(mesh& m, const internal::triangle_sides& sides) {
  std::map<std::pair<vertex_index, vertex_index>, std::size_t> first;
  std::vector<boundary_edge> kept;
  for (std::size_t k = 0; k < m.boundary.size(); ++k) {
    boundary_edge e = m.boundary[k];
    if (!sides.find(e.a, e.b) && !sides.find(e.b, e.a))
      throw input_error(row_text("edges", k, e.a, e.b) + " is a side of no triangle");
    const auto [at, is_new] = first.try_emplace(std::minmax(e.a, e.b), k);
    if (is_new) {
      e.segment = static_cast<vertex_index>(kept.size());
      kept.push_back(e);
    } else if (m.boundary[at->second].marker != e.marker) {
      throw input_error(row_text("edges", k, e.a, e.b) + " is row " + std::to_string(at->second) +
                        " again, with the marker " + std::to_string(e.marker) + " in place of " +
                        std::to_string(m.boundary[at->second].marker));
    }
  }
  const std::size_t again = m.boundary.size() - kept.size();
  m.boundary = std::move(kept);
  if (again > 0)
    m.notes.push_back(std::to_string(again) + (again == 1 ? " edge is" : " edges are") +
                      " listed again and left out");
}

void add_edges(mesh& m, const py::object& edges, const py::object& markers) {
  if (edges.is_none()) return;
  const whole_array ends = point_numbers(edges, "edges", 2);
  const auto count = static_cast<std::size_t>(ends.shape(0));
  const std::vector<int> marked = markers.is_none()
                                      ? std::vector<int>(count, 0)
                                      : numbers_of(markers, "edge_markers", count, "edge");
  for (std::size_t k = 0; k < count; ++k) {
    const auto row = static_cast<py::ssize_t>(k);
    m.boundary.push_back({point_number(ends, "edges", row, 0, m.sites.size()),
                          point_number(ends, "edges", row, 1, m.sites.size()),
                          static_cast<vertex_index>(k), marked[k], false});
  }
}

// Reads the corners, vertices and edges that must stay when the mesh is adapted.
mesh_marks marks_of(const keywords& given, std::size_t points) {
  mesh_marks marks;
  for (const auto& [name, list] :
       {std::pair{"corners", &marks.corners}, {"required_points", &marks.required_vertices}}) {
    if (!given.has(name)) continue;
    const whole_array numbers = numbers_of_points(given.object(name), name);
    const whole_array column = numbers.attr("reshape")(-1, 1).cast<whole_array>();
    for (py::ssize_t k = 0; k < column.shape(0); ++k)
      list->push_back(point_number(column, name, k, 0, points));
  }
  if (!given.has("required_edges")) return marks;
  const char* const name = "required_edges";
  const whole_array ends = point_numbers(given.object(name), name, 2);
  for (py::ssize_t k = 0; k < ends.shape(0); ++k)
    marks.required_edges.push_back(
        {point_number(ends, name, k, 0, points), point_number(ends, name, k, 1, points)});
  return marks;
}

// Notes the points that no triangle uses. They stay, as rows of other arrays have their numbers.
void note_lone_points(mesh& m) {
  std::vector<char> is_used(m.sites.size(), 0);
  for (const triangle& t : m.triangles)
    for (const vertex_index v : t) is_used[v] = 1;
  const auto first = std::find(is_used.begin(), is_used.end(), 0);
  if (first == is_used.end()) return;
  const auto k = static_cast<std::size_t>(first - is_used.begin());
  const auto count = std::count(first, is_used.end(), 0);
  m.notes.push_back((count == 1 ? "1 point is" : std::to_string(count) + " points are") +
                    " in no triangle, the first: row " + std::to_string(k) + " at " +
                    internal::point_text(m.sites[k].position) +
                    "; no mesh with such points is certified, and adapt() refuses it");
}

// Makes a mesh from elsewhere: nothing is known of how it was made. more may have "is_judged": the
// triangles stay as they are, since whether they are clockwise is what is asked.
py_mesh from_arrays(const py::object& points, const py::object& triangles, const py::object& metric,
                    const py::dict& more) {
  const keywords given(more);
  const number_table at(points, 2, "points"), tensors(metric, 3, "metric");
  const whole_array corners = point_numbers(triangles, "triangles", 3);
  if (!tensors.is_single() && tensors.rows() != at.rows())
    throw input_error("metric: one tensor for each point, or one for all, is wanted");
  mesh m;
  for (std::size_t k = 0; k < at.rows(); ++k) {
    const double* const t = tensors.row(tensors.is_single() ? 0 : k);
    m.sites.push_back({{at.row(k)[0], at.row(k)[1]}, {t[0], t[1], t[2]}});
  }
  m.given = static_cast<vertex_index>(m.sites.size());
  for (py::ssize_t k = 0; k < corners.shape(0); ++k) {
    triangle t;
    for (std::size_t c = 0; c < 3; ++c)
      t[c] = point_number(corners, "triangles", k, static_cast<py::ssize_t>(c), m.sites.size());
    if (t[0] == t[1] || t[1] == t[2] || t[2] == t[0])
      throw input_error("triangles: row " + std::to_string(k) + " names point " +
                        std::to_string(t[0] == t[1] ? t[0] : t[2]) + " twice");
    m.triangles.push_back(t);
  }
  if (!given.has("is_judged")) {
    internal::turn_over_clockwise(m, "row", 0);
    note_lone_points(m);
  }
  if (given.has("regions"))
    m.regions = numbers_of(given.object("regions"), "regions", m.triangles.size(), "triangle");
  add_edges(m, given.object("edges"), given.object("edge_markers"));
  const internal::triangle_sides sides(m);
  if (!given.has("is_judged")) put_edges_in_order(m, sides);
  internal::list_sides(m, sides);
  py_mesh made;
  made.marks = marks_of(given, m.sites.size());
  for (std::size_t k = 0; k < made.marks.required_edges.size(); ++k) {
    const auto [a, b] = made.marks.required_edges[k];
    if (!sides.find(a, b) && !sides.find(b, a))
      throw input_error(row_text("required_edges", k, a, b) + " is a side of no triangle");
  }
  auto adopted = value_or_raise(adopt_mesh(m, region_edges::as_listed, slit_rule::joined));
  // Keeps given points at slits: the mesh has one for each side, and the domain has one.
  if (!adopted.cracks.empty()) internal::keep_segments(m, internal::triangle_sides(m), {{}, true});
  made.content = adopted.cracks.empty() ? std::move(adopted.subject) : std::move(m);
  made.content.given = 0;
  warn(std::exchange(made.content.notes, {}));
  made.reason = "it came from elsewhere";
  return made;
}

// Returns the domain that the mesh covers. Every vertex is one of the domain, or with a corner
// angle only those that keep its shape.
py_domain domain_of(const py_mesh& m, const py::object& corner) {
  py::dict words;
  words["corner_angle"] = corner;
  const std::optional<double> corner_angle = keywords(words).positive("corner_angle");
  if (corner_angle && *corner_angle > 180)
    throw input_error("corner_angle: degrees above 0 and at most 180 are wanted");
  const auto make = [&]() -> result<adopted_mesh> {
    const py::gil_scoped_release unlocked;
    auto adopted = internal::checked_triangulation(m.content, "the mesh", slit_rule::joined);
    if (!adopted || !corner_angle) return adopted;
    const mesh_marks marks = internal::joined_marks(m.marks, adopted.value().number);
    auto outline = outline_of_mesh(adopted.value().subject, marks, {*corner_angle, {}});
    if (!outline) return outline.failure();
    if (!outline.value().keeps_all) adopted.value().shape = std::move(outline.value().shape);
    return adopted;
  };
  adopted_mesh made = value_or_raise(make());
  warn(made.subject.notes);
  return {std::move(made.shape), {}, std::move(made.cracks)};
}

// Reads a mesh, and with_fields the fields in its file, or beside it.
std::pair<py_mesh, solution> read_unlocked(const std::filesystem::path& path, bool with_fields) {
  const py::gil_scoped_release unlocked;
  medit_read_options options;
  options.identity_without_solution = true;
  std::pair<py_mesh, solution> read;
  auto& [made, fields] = read;
  mesh_file file = value_or_raise(read_mesh_file(path, options));
  if (with_fields) fields = value_or_raise(internal::fields_of_mesh(path, file));
  made.content = std::move(file.content);
  made.marks = std::move(file.marks);
  made.names = std::move(file.names);
  made.reason = "it was read from " + path.string();
  auto beside = path;
  beside.replace_extension(".certificate.json");
  if (!std::filesystem::exists(beside)) return read;
  made.claim = value_or_raise(read_certificate(beside));
  made.angle_bound = made.claim->angle_bound.value_or(0);
  made.complete = made.claim->complete;
  made.reason = made.claim->reason;
  return read;
}

// Returns a mesh, and the names and values of its fields.
py::tuple read(const system_text& path, bool with_fields) {
  auto [made, fields] = read_unlocked(path.bytes, with_fields);
  warn(std::exchange(made.content.notes, {}));
  warn(fields.notes);
  std::vector<system_text> names;
  for (const solution_field& field : fields.fields) names.push_back({field.name});
  return py::make_tuple(std::move(made), names, arrays_of(fields));
}

py::dict statistics(const py_mesh& m) {
  py::dict named;
  std::map<std::string, double> values;
  {
    const py::gil_scoped_release unlocked;
    values = by_name(measure(m.content));
  }
  for (const auto& [name, value] : values) named[py::str(name)] = value;
  return named;
}

}  // namespace

void define_mesh(py::module_& m) {
  m.def(
      "_is_metric_file", [](const system_text& name) { return is_metric_file(name.bytes); },
      py::arg("name"));
  m.def(
      "_is_mesh_file", [](const system_text& name) { return is_mesh_file(name.bytes); },
      py::arg("name"));
  py::class_<py_mesh>(m, "_Mesh")
      .def_static("from_arrays", &from_arrays, py::arg("points"), py::arg("triangles"),
                  py::arg("metric"), py::arg("more"))
      .def_static("read", &read, py::arg("path"), py::arg("with_fields"))
      .def(py::pickle([](const py_mesh& held) { return state_of(held); }, &mesh_of_state))
      .def_property_readonly(
          "points",
          [](const py::object& self) { return view<double>(self, content_of(self).sites, 0, 2); })
      .def_property_readonly(
          "metric",
          [](const py::object& self) { return view<double>(self, content_of(self).sites, 2, 3); })
      .def_property_readonly(
          "sites",
          [](const py::object& self) { return view<double>(self, content_of(self).sites, 0, 5); })
      .def_property_readonly("triangles",
                             [](const py::object& self) {
                               return view<std::int32_t>(self, content_of(self).triangles, 0, 3);
                             })
      .def_property_readonly("disagreeing",
                             [](const py::object& self) {
                               return view<std::int32_t>(self, content_of(self).disagreeing, 0, 3);
                             })
      .def_property_readonly("regions",
                             [](const py_mesh& self) {
                               const auto& r = self.content.regions;
                               return one_each(self.content.triangles.size(),
                                               [&](std::size_t k) { return r.empty() ? 1 : r[k]; });
                             })
      .def_property_readonly("edges", [](const py_mesh& self) { return edges_of(self.content); })
      .def_property_readonly("edge_markers",
                             [](const py_mesh& self) {
                               const auto& b = self.content.boundary;
                               return one_each(b.size(),
                                               [&](std::size_t k) { return b[k].marker; });
                             })
      .def_property_readonly("given", [](const py_mesh& self) { return self.content.given; })
      .def_readonly("complete", &py_mesh::complete)
      .def_readonly("certified", &py_mesh::certified)
      .def_property_readonly("reason", [](const py_mesh& self) { return system_text{self.reason}; })
      .def_property_readonly("certificate_text",
                             [](const py_mesh& self) -> std::optional<std::string> {
                               if (!self.claim) return std::nullopt;
                               return certificate_text(*self.claim);
                             })
      .def_property_readonly(
          "claims_certified",
          [](const py_mesh& self) { return self.claim && self.claim->certified; })
      .def("domain", &domain_of, py::arg("corner_angle") = py::none())
      .def("original",
           [](const py_mesh& self) -> std::optional<py_domain> {
             if (!self.claim || !self.claim->original) return std::nullopt;
             return py_domain{*self.claim->original, {}, joined(self.content).second};
           })
      .def("statistics", &statistics)
      .def("svg", &svg_of, py::arg("width") = 600, py::arg("ellipses") = false)
      .def("save", &save, py::arg("path"), py::arg("values"));
}

}  // namespace asterism::python
