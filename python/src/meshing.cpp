// SPDX-License-Identifier: MIT
//
// Runs of the mesher. The interpreter's lock is free meanwhile, and taken for the metric, progress
// and interrupts.
#include <pybind11/stl.h>

#include <array>
#include <charconv>
#include <vector>

#include "arguments.hpp"
#include "asterism/mesh/pipeline/certified_mesh.hpp"
#include "asterism/mesh/pipeline/counted_mesh.hpp"
#include "asterism/mesh/pipeline/guaranteed_mesh.hpp"
#include "asterism/mesh/pipeline/periodic_mesh.hpp"
#include "bindings.hpp"
#include "periodic_arguments.hpp"
#include "py_domain.hpp"
#include "py_mesh.hpp"
#include "python_metric.hpp"
#include "watched_run.hpp"

namespace asterism::python {
namespace {

std::string text_of(double x) {
  std::array<char, 32> buffer{};
  return {buffer.data(), std::to_chars(buffer.data(), buffer.data() + buffer.size(), x).ptr};
}

struct mesh_arguments {
  std::optional<double> size, gradation, complexity, chord_tolerance;
  mesh_options options;
  size_wishes sizes;
  bool guarantee = false;
  std::vector<periodic_pair> periodic;
};

// Raises the default limit on sites to the count wanted, with room for boundaries and angles.
std::size_t room_for(const mesh_arguments& a, std::size_t vertices_of_domain) {
  constexpr double most = 1e8, times = 3, more = 1000, vertices_of_complexity = 1.2, growth = 10;
  const double least = std::max(1e5, growth * static_cast<double>(vertices_of_domain));
  const double asked = a.options.vertices ? static_cast<double>(*a.options.vertices)
                                          : vertices_of_complexity * a.complexity.value_or(0);
  return static_cast<std::size_t>(std::min(std::max(least, times * asked + more), most));
}

void check_ranges(const mesh_arguments& a) {
  const mesh_options& o = a.options;
  if (a.size.has_value() + o.vertices.has_value() + a.complexity.has_value() > 1)
    throw input_error("size, vertices, complexity: one of them at most is wanted");
  if (a.guarantee && (o.vertices || a.complexity || o.improve_passes > 0 || o.metric_tolerance))
    throw input_error(
        "guarantee: vertices, complexity, improve and metric_tolerance do not go with it");
  if (a.guarantee && !a.periodic.empty())
    throw input_error("guarantee: it is of meshes without periodic sides");
  if (o.vertices && *o.vertices > o.max_sites)
    throw input_error("vertices: from 3 to max_sites is wanted");
  if (!(o.angle_bound < 60))
    throw input_error("angle_bound: at least 0 and below 60 degrees is wanted");
  if (a.gradation && !(*a.gradation > 1))
    throw input_error("gradation: a finite number above 1 is wanted");
}

mesh_arguments arguments_of(const keywords& given, std::size_t vertices_of_domain) {
  mesh_arguments a;
  a.size = given.positive("size");
  // Bounds the sizes, whose squares must stay within the range of doubles.
  constexpr double least = 1e-150, most = 1e150;
  if (a.size && !(*a.size >= least && *a.size <= most))
    throw input_error("size: a number from 1e-150 to 1e150 is wanted, not " + text_of(*a.size));
  a.complexity = given.positive("complexity");
  a.gradation = given.positive("gradation");
  a.chord_tolerance = given.positive("chord_tolerance");
  a.options.vertices = given.count("vertices", 3);
  a.options.metric_tolerance = given.from_zero("metric_tolerance");
  a.options.angle_bound = given.from_zero("angle_bound").value_or(a.options.angle_bound);
  a.options.max_sites = given.count("max_sites", 3).value_or(room_for(a, vertices_of_domain));
  a.options.prove_voronoi = given.flag("voronoi");
  a.options.improve_passes = given.count("improve").value_or(0);
  a.options.keep_if_complete = given.flag("keep_if_complete");
  a.sizes = value_or_raise(size_wishes_of(given.has("sizes") ? given.word("sizes") : "none"));
  a.guarantee = given.flag("guarantee");
  if (a.guarantee && !a.size && !a.options.vertices && !a.complexity && a.sizes.is_empty())
    a.size = 1;
  a.options.limit_size = a.size || a.options.vertices || a.complexity || !a.sizes.is_empty();
  a.periodic = periodic_of(given);
  check_ranges(a);
  return a;
}

std::string places_text(const domain_repairs& mended) {
  std::string text;
  for (const repair_place& p : mended.places)
    text += (text.empty() ? "" : "; ") + p.what + " " + text_of(p.at.x) + " " + text_of(p.at.y);
  return text.empty() ? "none" : text;
}

std::string sentences_of(const domain_repairs& mended) {
  std::string text;
  for (const std::string& message : mended.messages) text += (text.empty() ? "" : "; ") + message;
  return text.empty() ? "none" : text;
}

py_mesh packaged(certified_mesh made, const python_metric& metric, const mesh_arguments& a,
                 const py_domain& held, const std::optional<double>& complexity) {
  const domain_repairs& mended = held.mended;
  made.claim.metric = metric.name();
  const mesh_outcome& outcome = made.outcome;
  const std::string size = a.size ? text_of(*a.size) : "none";
  const std::string delivered =
      a.size ? text_of(*a.size * outcome.ended.length_factor) : std::string("none");
  // Uses the command's names of options, by which verify() reads them.
  made.claim.options = {
      {"chord-tolerance", a.chord_tolerance ? text_of(*a.chord_tolerance) : "none"},
      {"domain", "given"},
      {"angle-bound", text_of(a.options.angle_bound)},
      {"size", size},
      {"sizes", asterism::text_of(a.sizes)},
      {"size-delivered", delivered},
      {"vertices", a.options.vertices ? std::to_string(*a.options.vertices) : "none"},
      {"complexity", a.complexity ? text_of(*a.complexity) : "none"},
      {"complexity-delivered", complexity ? text_of(*complexity) : "none"},
      {"gradation", a.gradation ? text_of(*a.gradation) : "none"},
      {"gradation-done", a.gradation ? "done" : "none"},
      {"refine", "fill"},
      {"tol", "chosen"},
      {"tol-at-end", text_of(outcome.ended.tolerance)},
      {"improve", std::to_string(a.options.improve_passes)},
      {"improve-done", outcome.improved ? "done" : "none"},
      {"certify", a.options.prove_voronoi ? "voronoi" : "stars"},
      {"max-sites", std::to_string(a.options.max_sites)},
      {"metric-fingerprint", metric.fingerprint()},
      {"regions", "as given"},
      {"random-points", "0"},
      {"repair-distance", mended.distance > 0 ? text_of(mended.distance) : "none"},
      {"repair-done", mended.distance > 0 ? sentences_of(mended) : "none"},
      {"repair-places", places_text(mended)},
      {"metric-tolerance",
       a.options.metric_tolerance ? text_of(*a.options.metric_tolerance) : "none"},
      {"seed", "1"}};
  if (a.guarantee) made.claim.options.emplace("guarantee", "asked");
  py_mesh m;
  m.complete = made.outcome.complete;
  m.certified = made.certified();
  m.reason = made.claim.reason;
  m.angle_bound = a.options.angle_bound;
  m.claim = std::move(made.claim);
  m.content = part_cracks(made.outcome.result, held.cracks).content;
  return m;
}

// Refuses sizes at places if no size is given for the rest of the domain.
void check_sizes(const mesh_arguments& a, const py::object& metric) {
  if (a.sizes.is_empty() || a.size || a.complexity || a.options.vertices) return;
  if (!py::isinstance<py::str>(metric) || metric.cast<system_text>().bytes != "identity")
    throw input_error("sizes at places: size says how long edges are in this metric");
}

void check_counts(const domain& d, const mesh_arguments& a) {
  if (a.chord_tolerance && d.curves.empty())
    throw input_error("chord_tolerance: the domain has no curves");
  if (d.vertices.size() > a.options.max_sites)
    throw input_error("max_sites: the domain has " + std::to_string(d.vertices.size()) +
                      " vertices already");
  if (a.options.vertices && d.vertices.size() > *a.options.vertices)
    throw input_error("vertices: the domain has " + std::to_string(d.vertices.size()) + " already");
}

py_mesh run(const py_domain& held, const py::object& metric, const py::dict& more) {
  const domain& d = held.shape;
  const keywords given(more);
  mesh_arguments a = arguments_of(given, d.vertices.size());
  check_counts(d, a);
  check_sizes(a, metric);
  watched_run watch(given);
  const std::string file = given.has("domain_file")
                               ? given.object("domain_file").cast<system_text>().bytes
                               : d.origin.file;
  // Keeps the metric's function alive as long as a field may call it.
  std::vector<python_metric> wanted;
  const field_in_box metric_of_size =
      [&](double size, const bounding_box& box) -> result<std::unique_ptr<metric_field>> {
    const py::gil_scoped_acquire locked;
    wanted.emplace_back(metric, file, box, size, watch.errors());
    return wanted.back().take_field();
  };
  a.options.stop = watch.stop();
  std::optional<result<counted_mesh>> made;
  {
    const py::gil_scoped_release unlocked;
    const mesh_source source{d,
                             metric_of_size,
                             {a.size, a.complexity, a.gradation, a.options.stop, a.sizes},
                             a.chord_tolerance};
    made = make_counted_mesh(source, a.options, [&](const mesh_input& of, const mesh_options& how) {
      return a.guarantee ? make_guaranteed_mesh(of.shape, *of.metric.field, how, watch.listener())
                         : make_periodic_mesh(of.shape, *of.metric.field, how, a.periodic,
                                              watch.listener());
    });
  }
  watch.errors().raise();
  counted_mesh done = value_or_raise(std::move(*made));
  const std::optional<double> complexity = done.input.metric.complexity;
  if (complexity || !a.sizes.is_empty()) a.size = done.input.metric.size;
  return packaged(std::move(done.made), wanted.back(), a, held, complexity);
}

}  // namespace

void define_meshing(py::module_& m) {
  m.def("_mesh", &run, py::arg("domain"), py::arg("metric"), py::arg("more"));
}

}  // namespace asterism::python
