// SPDX-License-Identifier: MIT
#include "states.hpp"

#include <pybind11/stl.h>

#include "arguments.hpp"

namespace asterism::python {
namespace {

constexpr int state_version = 1;

// Converts rows of a struct of numbers of one type to an array, and back.
template <class Number, class Row>
py::array_t<Number> rows_of(const std::vector<Row>& rows) {
  static_assert(sizeof(Row) % sizeof(Number) == 0);
  constexpr auto width = static_cast<py::ssize_t>(sizeof(Row) / sizeof(Number));
  py::array_t<Number> array({static_cast<py::ssize_t>(rows.size()), width});
  const auto* const first = reinterpret_cast<const Number*>(rows.data());
  std::copy_n(first, array.size(), array.mutable_data());
  return array;
}

template <class Number, class Row>
std::vector<Row> rows_from(const py::handle& of) {
  const auto array = of.cast<py::array_t<Number, py::array::c_style>>();
  constexpr auto width = static_cast<py::ssize_t>(sizeof(Row) / sizeof(Number));
  if (array.ndim() != 2 || array.shape(1) != width)
    throw input_error("a pickle of another shape of arrays");
  std::vector<Row> rows(static_cast<std::size_t>(array.shape(0)));
  std::copy_n(array.data(), array.size(), reinterpret_cast<Number*>(rows.data()));
  return rows;
}

py::list segments_state(const domain& d) {
  py::list all;
  for (const segment& s : d.segments)
    all.append(py::make_tuple(s.a, s.b, s.marker, s.internal, s.left_region, s.right_region));
  return all;
}

py::list curves_state(const domain& d) {
  py::list all;
  for (const domain_curve& c : d.curves)
    all.append(py::make_tuple(static_cast<int>(c.kind), c.centre.x, c.centre.y, c.clockwise,
                              c.control[0].x, c.control[0].y, c.control[1].x, c.control[1].y,
                              c.vertices, c.parameters, c.segment));
  return all;
}

domain_curve curve_from(const py::tuple& t) {
  const auto real = [&](std::size_t k) { return t[k].cast<double>(); };
  domain_curve c;
  c.kind = static_cast<curve_kind>(t[0].cast<int>());
  c.centre = {real(1), real(2)};
  c.clockwise = t[3].cast<bool>();
  c.control = {point{real(4), real(5)}, point{real(6), real(7)}};
  c.vertices = t[8].cast<std::vector<std::uint32_t>>();
  c.parameters = t[9].cast<std::vector<double>>();
  c.segment = t[10].cast<std::uint32_t>();
  return c;
}

py::list regions_state(const domain& d) {
  py::list all;
  for (const region_point& r : d.regions)
    all.append(py::make_tuple(r.at.x, r.at.y, r.number, r.largest_area));
  return all;
}

py::list polygons_state(const domain& d) {
  py::list all;
  for (const domain_polygon& p : d.polygons) all.append(py::make_tuple(p.region, p.rings));
  return all;
}

py::list cracks_state(const crack_markers& cracks) {
  py::list all;
  for (const auto& [number, sides] : cracks)
    all.append(py::make_tuple(number, sides.left, sides.right));
  return all;
}

py::list boundary_state(const mesh& m) {
  py::list all;
  for (const boundary_edge& e : m.boundary)
    all.append(py::make_tuple(e.a, e.b, e.segment, e.marker, e.internal));
  return all;
}

void check_version(const py::tuple& state, std::size_t parts) {
  if (state.size() != parts || state[0].cast<int>() != state_version)
    throw input_error("a pickle of another version of asterism");
}

// Refuses indices beyond the mesh's own arrays.
void check_indices(const mesh& m) {
  const auto is_wrong = [&](vertex_index v) { return v >= m.sites.size(); };
  bool wrong = m.given > m.sites.size() ||
               (!m.regions.empty() && m.regions.size() != m.triangles.size()) ||
               (!m.references.empty() && m.references.size() != m.sites.size());
  for (const auto* list : {&m.triangles, &m.disagreeing})
    for (const triangle& t : *list)
      for (const vertex_index v : t) wrong = wrong || is_wrong(v);
  for (const boundary_edge& e : m.boundary) wrong = wrong || is_wrong(e.a) || is_wrong(e.b);
  if (wrong) throw input_error("a pickle of no mesh: numbers out of range");
}

}  // namespace

py::tuple state_of(const py_domain& held) {
  const domain& d = held.shape;
  py::list places;
  for (const repair_place& p : held.mended.places)
    places.append(py::make_tuple(p.what, p.at.x, p.at.y));
  return py::make_tuple(state_version, system_text{d.name}, rows_of<double>(d.vertices),
                        segments_state(d), rows_of<double>(d.holes), regions_state(d),
                        d.number_all_regions, d.origin.first_number, system_text{d.origin.file},
                        curves_state(d), polygons_state(d), held.mended.distance, places,
                        cracks_state(held.cracks));
}

py_domain domain_of_state(const py::tuple& state) {
  check_version(state, 14);
  domain d;
  d.name = state[1].cast<system_text>().bytes;
  d.vertices = rows_from<double, point>(state[2]);
  for (const py::handle of : state[3]) {
    const auto t = of.cast<py::tuple>();
    d.segments.push_back({t[0].cast<vertex_index>(), t[1].cast<vertex_index>(), t[2].cast<int>(),
                          t[3].cast<bool>(), t[4].cast<int>(), t[5].cast<int>()});
  }
  d.holes = rows_from<double, point>(state[4]);
  for (const py::handle of : state[5]) {
    const auto t = of.cast<py::tuple>();
    d.regions.push_back(
        {{t[0].cast<double>(), t[1].cast<double>()}, t[2].cast<int>(), t[3].cast<double>()});
  }
  d.number_all_regions = state[6].cast<bool>();
  d.origin.first_number = state[7].cast<int>();
  d.origin.file = d.origin.vertex_file = state[8].cast<system_text>().bytes;
  for (const py::handle of : state[9]) d.curves.push_back(curve_from(of.cast<py::tuple>()));
  for (const py::handle of : state[10]) {
    const auto t = of.cast<py::tuple>();
    d.polygons.push_back(
        {t[0].cast<std::optional<int>>(), t[1].cast<std::vector<std::vector<std::uint32_t>>>()});
  }
  // The domain was accepted before, and is accepted again unchanged.
  py_domain held{value_or_raise(check_domain(d)), {}};
  held.mended.distance = state[11].cast<double>();
  for (const py::handle of : state[12]) {
    const auto t = of.cast<py::tuple>();
    held.mended.places.push_back(
        {t[0].cast<std::string>(), {t[1].cast<double>(), t[2].cast<double>()}});
  }
  for (const py::handle of : state[13]) {
    const auto t = of.cast<py::tuple>();
    held.cracks[t[0].cast<int>()] = {t[1].cast<int>(), t[2].cast<int>()};
  }
  return held;
}

py::tuple state_of(const py_mesh& held) {
  const mesh& m = held.content;
  std::optional<std::string> claim;
  if (held.claim) claim = certificate_text(*held.claim);
  return py::make_tuple(state_version, rows_of<double>(m.sites), m.given,
                        rows_of<std::uint32_t>(m.triangles), m.regions, boundary_state(m),
                        rows_of<std::uint32_t>(m.disagreeing), m.references, held.complete,
                        held.certified, system_text{held.reason}, held.angle_bound, claim,
                        held.marks.corners, held.marks.required_vertices, held.marks.required_edges,
                        held.names.markers, held.names.regions);
}

py_mesh mesh_of_state(const py::tuple& state) {
  check_version(state, 18);
  py_mesh held;
  mesh& m = held.content;
  m.sites = rows_from<double, site>(state[1]);
  m.given = state[2].cast<vertex_index>();
  m.triangles = rows_from<std::uint32_t, triangle>(state[3]);
  m.regions = state[4].cast<std::vector<int>>();
  for (const py::handle of : state[5]) {
    const auto t = of.cast<py::tuple>();
    m.boundary.push_back({t[0].cast<vertex_index>(), t[1].cast<vertex_index>(),
                          t[2].cast<vertex_index>(), t[3].cast<int>(), t[4].cast<bool>()});
  }
  m.disagreeing = rows_from<std::uint32_t, triangle>(state[6]);
  m.references = state[7].cast<std::vector<int>>();
  check_indices(m);
  held.complete = state[8].cast<bool>();
  held.certified = state[9].cast<bool>();
  held.reason = state[10].cast<system_text>().bytes;
  held.angle_bound = state[11].cast<double>();
  if (const auto claim = state[12].cast<std::optional<std::string>>())
    held.claim = value_or_raise(parse_certificate(*claim, "the pickle's certificate"));
  held.marks.corners = state[13].cast<std::vector<vertex_index>>();
  held.marks.required_vertices = state[14].cast<std::vector<vertex_index>>();
  held.marks.required_edges = state[15].cast<std::vector<std::array<vertex_index, 2>>>();
  held.names.markers = state[16].cast<std::map<int, std::string>>();
  held.names.regions = state[17].cast<std::map<int, std::string>>();
  return held;
}

}  // namespace asterism::python
