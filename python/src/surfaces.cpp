// SPDX-License-Identifier: MIT
//
// Surfaces in space, as texts of JSON, and their meshes.
#include <pybind11/stl.h>

#include <cmath>
#include <filesystem>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "arguments.hpp"
#include "asterism/mesh/surface/built_in_surfaces.hpp"
#include "asterism/mesh/surface/surface_mesher.hpp"
#include "asterism/mesh/surface/unit_patches.hpp"
#include "asterism/mesh/surface_audit/shell_audit.hpp"
#include "asterism/mesh/surface_audit/shell_triangles.hpp"
#include "asterism/mesh/surface_io/shell_certificate.hpp"
#include "asterism/mesh/surface_io/space_mesh_writer.hpp"
#include "asterism/mesh/surface_io/surface_json.hpp"
#include "bindings.hpp"
#include "watched_run.hpp"

namespace asterism::python {
using namespace internal;
namespace {

surface checked(const std::string& text) {
  surface s = value_or_raise(parse_surface(text, "surface"));
  value_or_raise(bezier_pieces(s));
  return s;
}

std::string text_of_named(const std::string& name) {
  const auto known = built_in_surface(name);
  if (known) return surface_text(*known);
  std::string names;
  for (const std::string& one : built_in_surface_names())
    names += (names.empty() ? "" : ", ") + one;
  throw input_error("surface " + name + ": one of " + names + " is wanted");
}

std::string text_of_file(const system_text& path) {
  const surface s = value_or_raise(read_surface(path.bytes));
  value_or_raise(bezier_pieces(s));
  return surface_text(s);
}

surface_mesh_options options_of(const keywords& given) {
  surface_mesh_options how;
  const auto chord = given.positive("chord");
  if (!chord) throw input_error("chord: the greatest distance is wanted");
  how.chord = *chord;
  how.normal = given.positive("normal");
  if (how.normal && *how.normal > 90) throw input_error("normal: at most 90 degrees is wanted");
  how.longest = given.positive("hmax");
  how.aspect = given.positive("aspect").value_or(how.aspect);
  if (how.aspect < 1) throw input_error("aspect: at least 1 is wanted");
  how.vertices = given.count("vertices", 4);
  const auto bound = given.from_zero("angle_bound");
  how.angle_bound = bound.value_or(how.angle_bound);
  how.keeps_angle_bound = bound.has_value();
  if (!(how.angle_bound < 60))
    throw input_error("angle_bound: at least 0 and below 60 degrees is wanted");
  return how;
}

py::array_t<double> points_of(const space_mesh& m) {
  py::array_t<double> all({static_cast<py::ssize_t>(m.points.size()), py::ssize_t{3}});
  auto to = all.mutable_unchecked<2>();
  for (py::ssize_t v = 0; v < to.shape(0); ++v) {
    const space_point& p = m.points[static_cast<std::size_t>(v)];
    to(v, 0) = p.x, to(v, 1) = p.y, to(v, 2) = p.z;
  }
  return all;
}

py::array_t<std::int32_t> triangles_of(const space_mesh& m) {
  py::array_t<std::int32_t> all({static_cast<py::ssize_t>(m.triangles.size()), py::ssize_t{3}});
  auto to = all.mutable_unchecked<2>();
  for (py::ssize_t t = 0; t < to.shape(0); ++t)
    for (py::ssize_t k = 0; k < 3; ++k)
      to(t, k) = static_cast<std::int32_t>(
          m.triangles[static_cast<std::size_t>(t)][static_cast<std::size_t>(k)]);
  return all;
}

// Maps a parameter of the meshed patch to one of the given patch. Patches without inner knots are
// meshed on [0, 1].
double given_parameter(double x, const std::vector<double>& meshed,
                       const std::vector<double>& given) {
  if (meshed == given) return x;
  return x >= 1 ? given.back() : given.front() + x * (given.back() - given.front());
}

// Returns the parameters of the corners of the triangles in space, in their order.
py::array_t<double> parameters_of(const shell_certificate& claim, const surface& asked,
                                  const std::vector<shell_triangle>& triangles, std::size_t kept) {
  py::array_t<double> all({static_cast<py::ssize_t>(kept), py::ssize_t{3}, py::ssize_t{2}});
  auto to = all.mutable_unchecked<3>();
  py::ssize_t at = 0;
  for (const shell_triangle& t : triangles) {
    if (t.collapsed) continue;
    const shell_face& face = claim.shell.faces[t.face];
    const surface_patch &meshed = claim.of.patches[face.patch], &given = asked.patches[face.patch];
    for (py::ssize_t k = 0; k < 3; ++k) {
      const auto& [u, v] = t.at[static_cast<std::size_t>(face.reversed ? (3 - k) % 3 : k)];
      to(at, k, 0) = given_parameter(u, meshed.knots_u, given.knots_u);
      to(at, k, 1) = given_parameter(v, meshed.knots_v, given.knots_v);
    }
    ++at;
  }
  return all;
}

py::dict answer_of(const shell_certificate& claim, const surface& asked) {
  const auto triangles = internal::triangles_of(claim.shell);
  const space_mesh m = mesh_of(claim.shell, triangles);
  py::array_t<std::int32_t> patches(static_cast<py::ssize_t>(m.faces.size()));
  for (std::size_t t = 0; t < m.faces.size(); ++t)
    patches.mutable_at(static_cast<py::ssize_t>(t)) =
        static_cast<std::int32_t>(claim.shell.faces[m.faces[t]].patch);
  py::dict d;
  d["points"] = points_of(m);
  d["triangles"] = triangles_of(m);
  d["patches"] = patches;
  d["uv"] = parameters_of(claim, asked, triangles, m.triangles.size());
  d["certified"] = claim.report.certified && claim.complete;
  d["reason"] = !claim.complete                 ? claim.reason
                : claim.report.findings.empty() ? std::string()
                                                : claim.report.findings[0];
  d["certificate"] = shell_certificate_text(claim);
  return d;
}

py::dict mesh_surface(const std::string& text, const py::dict& more) {
  const keywords given(more);
  const surface asked = checked(text);
  surface s = with_unit_patches(asked);
  warn(s.notes);
  surface_mesh_options how = options_of(given);
  watched_run watch(given);
  how.stop = watch.stop();
  const bool no_crossings = given.flag("no_crossings");
  shell_certificate claim;
  std::vector<std::string> notes;
  std::optional<error> failed;
  {
    const py::gil_scoped_release unlocked;
    auto made = make_surface_mesh(s, how);
    if (!made) {
      failed = made.failure();
    } else {
      claim.asked = {how.chord, made.value().angle_bound, no_crossings};
      notes = std::move(made.value().notes);
      claim.shell = std::move(made.value().shell);
      claim.complete = made.value().complete;
      claim.reason = made.value().reason;
      auto report = audit_shell(s, claim.shell, claim.asked);
      if (report)
        claim.report = std::move(report).value();
      else
        failed = report.failure();
    }
  }
  watch.errors().raise();
  if (failed) throw input_error(failed->message);
  warn(notes);
  claim.of = std::move(s);
  return answer_of(claim, asked);
}

// Returns the content of a file in the format of its ending.
std::string file_text(const py::array_t<double, py::array::c_style>& points,
                      const py::array_t<std::int32_t, py::array::c_style>& triangles,
                      const py::array_t<std::int32_t, py::array::c_style>& patches,
                      const std::string& name) {
  space_mesh m;
  const auto p = points.unchecked<2>();
  const auto t = triangles.unchecked<2>();
  const auto f = patches.unchecked<1>();
  for (py::ssize_t v = 0; v < p.shape(0); ++v) m.points.push_back({p(v, 0), p(v, 1), p(v, 2)});
  for (py::ssize_t k = 0; k < t.shape(0); ++k) {
    m.triangles.push_back({static_cast<std::uint32_t>(t(k, 0)), static_cast<std::uint32_t>(t(k, 1)),
                           static_cast<std::uint32_t>(t(k, 2))});
    m.faces.push_back(static_cast<std::uint32_t>(f(k)));
  }
  return value_or_raise(space_mesh_text(m, name));
}

}  // namespace

void define_surfaces(py::module_& m) {
  m.def(
      "_surface_checked", [](const std::string& text) { return surface_text(checked(text)); },
      py::arg("text"));
  m.def("_surface_named", &text_of_named, py::arg("name"));
  m.def("_surface_read", &text_of_file, py::arg("path"));
  m.def("_mesh_surface", &mesh_surface, py::arg("text"), py::arg("more"));
  m.def("_space_mesh_text", &file_text, py::arg("points"), py::arg("triangles"), py::arg("patches"),
        py::arg("name"));
}

}  // namespace asterism::python
