// SPDX-License-Identifier: MIT
//
// Runs of the mesher and of the auditor. The interpreter's lock is free meanwhile, and taken for
// the metric, progress and interrupts.
#include <pybind11/numpy.h>
#include <pybind11/stl.h>

#include <array>
#include <charconv>
#include <cmath>
#include <exception>
#include <functional>
#include <mutex>
#include <vector>

#include "arguments.hpp"
#include "asterism/mesh/audit/audit.hpp"
#include "asterism/mesh/c_interface/arrays.hpp"
#include "asterism/mesh/domain/divide_curves.hpp"
#include "asterism/mesh/metric/interpolated_field.hpp"
#include "asterism/mesh/metric/make_metric_field.hpp"
#include "asterism/mesh/pipeline/certified_mesh.hpp"
#include "asterism/mesh/pipeline/counted_mesh.hpp"
#include "asterism/mesh/pipeline/foreign_mesh.hpp"
#include "bindings.hpp"
#include "py_mesh.hpp"

namespace asterism::python {
namespace {

// Keeps what Python raised in a callback until the run has ended.
class raised_error {
 public:
  void keep() {
    const std::lock_guard<std::mutex> alone(lock_);
    if (!error_) error_ = std::current_exception();
  }
  bool any() const {
    const std::lock_guard<std::mutex> alone(lock_);
    return error_ != nullptr;
  }
  // With the interpreter's lock.
  void raise() const {
    if (error_) std::rethrow_exception(error_);
  }

 private:
  mutable std::mutex lock_;
  std::exception_ptr error_;
};

// A callable (n, 2) -> (n, 3), asked for many points at a time; one that cannot do that, for one.
class called_field {
 public:
  called_field(py::function function, raised_error& errors)
      : function_(std::move(function)), errors_(&errors) {}

  static int ask(void* context, std::size_t count, const double* points, double* metrics) {
    return static_cast<called_field*>(context)->at(count, points, metrics);
  }

 private:
  int at(std::size_t count, const double* points, double* metrics) {
    const py::gil_scoped_acquire locked;
    if (count > 1) return takes_many_ && at_many(count, points, metrics) ? 0 : 1;
    try {
      answer(1, points, metrics);
      return 0;
    } catch (...) {
      errors_->keep();
      return 1;
    }
  }

  // Leaves it to the calls for one point to raise what they raise.
  bool at_many(std::size_t count, const double* points, double* metrics) {
    try {
      answer(count, points, metrics);
    } catch (const py::error_already_set& raised) {
      takes_many_ = false;
      if (!raised.matches(PyExc_Exception)) errors_->keep();  // an interrupt
    } catch (const input_error&) {
      takes_many_ = false;
    }
    return takes_many_;
  }

  // One tensor for many points is refused: it may be meant for the first alone.
  void answer(std::size_t count, const double* points, double* metrics) {
    py::array_t<double> places({static_cast<py::ssize_t>(count), py::ssize_t{2}});
    std::copy_n(points, 2 * count, places.mutable_data());
    const number_table tensors(function_(places), 3, "the metric's answer");
    if (tensors.rows() != count || (count > 1 && tensors.is_single()))
      throw input_error("the metric's answer: " + std::to_string(tensors.rows()) + " tensors for " +
                        std::to_string(count) + " points");
    for (std::size_t k = 0; k < count; ++k) std::copy_n(tensors.row(k), 3, metrics + 3 * k);
  }

  py::function function_;
  raised_error* errors_;
  bool takes_many_ = true;  // with the interpreter's lock
};

using field_pointer = std::unique_ptr<metric_field>;

// A metric as Python gives it: text, callable, or a mesh with a tensor at each point.
struct python_metric {
  std::string name;
  field_pointer field;
  std::unique_ptr<called_field> callable;  // used by the field
};

field_pointer sampled(const py::object& background, const py::object& tensors, double size) {
  mesh copy = background.cast<const py_mesh&>().content;
  const number_table given(tensors, 3, "metric");
  if (given.rows() != copy.sites.size() && !given.is_single())
    throw input_error("metric: " + std::to_string(given.rows()) + " tensors for " +
                      std::to_string(copy.sites.size()) + " points");
  for (std::size_t k = 0; k < copy.sites.size(); ++k) {
    const double* const t = given.row(given.is_single() ? 0 : k);
    copy.sites[k].metric = {t[0], t[1], t[2]};
  }
  const py::gil_scoped_release unlocked;
  const auto adopted = value_or_raise(adopt_mesh(std::move(copy)));
  audit_options options;
  options.check_stars = false;
  options.angle_bound = 0;
  const audit_report found = audit(adopted.subject, options);
  if (!found.certified)
    throw input_error("metric: its mesh is no triangulation: " + found.findings.at(0).witness);
  return make_sampled_field(adopted.subject, size);
}

python_metric metric_of(const py::object& metric, const domain& d, double size,
                        raised_error& errors) {
  if (py::isinstance<py::str>(metric)) {
    const auto text = metric.cast<std::string>();
    return {text, value_or_raise(make_metric_field(text, d.box(), size)), nullptr};
  }
  if (py::isinstance<py::tuple>(metric) && py::len(metric) == 2) {
    const auto pair = metric.cast<py::tuple>();
    if (!py::isinstance<py_mesh>(pair[0]))
      throw input_error("metric: a pair must be a mesh and its tensors");
    return {"of tensors at the vertices of a mesh", sampled(pair[0], pair[1], size), nullptr};
  }
  if (!PyCallable_Check(metric.ptr()))
    throw input_error("metric: a text, a callable or a pair of a mesh and tensors is wanted");
  python_metric made{"of a callable", nullptr, nullptr};
  made.callable = std::make_unique<called_field>(metric.cast<py::function>(), errors);
  asterism_metric asked{};
  asked.batch_function = &called_field::ask;
  asked.context = made.callable.get();
  asked.size = size;
  made.field = value_or_raise(internal::field_of(asked, d.box()));
  return made;
}

struct mesh_arguments {
  std::optional<double> size, gradation, complexity;
  mesh_options options;
  py::object progress;
  std::optional<double> chord_tolerance = {};
};

mesh_arguments arguments_of(const std::optional<double>& size, double angle_bound,
                            std::size_t max_sites, const std::optional<double>& gradation,
                            bool prove_voronoi, std::size_t improve,
                            const std::optional<std::size_t>& vertices,
                            const std::optional<double>& complexity,
                            const std::optional<double>& metric_tolerance,
                            const std::optional<double>& chord_tolerance,
                            const py::object& progress) {
  mesh_arguments a{size, gradation, complexity, {}, progress, chord_tolerance};
  if (size.has_value() + vertices.has_value() + complexity.has_value() > 1)
    throw input_error("size, vertices, complexity: one of them at most is wanted");
  if (vertices && (*vertices < 3 || *vertices > max_sites))
    throw input_error("vertices: from 3 to max_sites is wanted");
  if (complexity && !(*complexity > 0 && std::isfinite(*complexity)))
    throw input_error("complexity: a positive finite number is wanted");
  if (size && !(*size > 0 && std::isfinite(*size)))
    throw input_error("size: a positive finite number is wanted");
  if (!(angle_bound >= 0 && angle_bound < 60))
    throw input_error("angle_bound: at least 0 and below 60 degrees is wanted");
  if (gradation && !(*gradation > 1 && std::isfinite(*gradation)))
    throw input_error("gradation: a finite number above 1 is wanted");
  if (metric_tolerance && !(*metric_tolerance >= 0 && std::isfinite(*metric_tolerance)))
    throw input_error("metric_tolerance: a finite number of at least 0 is wanted");
  if (chord_tolerance && !(*chord_tolerance > 0 && std::isfinite(*chord_tolerance)))
    throw input_error("chord_tolerance: a positive finite number is wanted");
  a.options.metric_tolerance = metric_tolerance;
  a.options.angle_bound = angle_bound;
  a.options.limit_size = size || vertices || complexity;
  a.options.vertices = vertices;
  a.options.max_sites = max_sites;
  a.options.prove_voronoi = prove_voronoi;
  a.options.improve_passes = improve;
  return a;
}

// Ctrl-C, seen where the mesher asks whether to stop; an error in a callback ends the run, too.
std::optional<std::string> reason_to_stop(raised_error& errors) {
  if (errors.any()) return "a callback failed";
  const py::gil_scoped_acquire locked;
  try {
    if (PyErr_CheckSignals() != 0) throw py::error_already_set();
    return std::nullopt;
  } catch (...) {
    errors.keep();
    return "interrupted";
  }
}

void tell(const py::object& progress, const mesh_progress& now, raised_error& errors) {
  const py::gil_scoped_acquire locked;
  try {
    constexpr const char* phases[] = {"filling", "refining", "auditing"};
    py::dict state;
    state["phase"] = phases[static_cast<std::size_t>(now.phase)];
    state["sites"] = now.sites;
    state["disagreeing"] = now.disagreeing;
    state["low_angle"] = now.low_angle;
    state["too_large"] = now.too_large;
    progress(state);
  } catch (...) {
    errors.keep();
  }
}

std::string text_of(double x) {
  std::array<char, 32> buffer{};
  return {buffer.data(), std::to_chars(buffer.data(), buffer.data() + buffer.size(), x).ptr};
}

py_mesh packaged(certified_mesh made, const std::string& metric, const mesh_arguments& a,
                 const std::optional<double>& complexity) {
  made.claim.metric = metric;
  const mesh_outcome& outcome = made.outcome;
  const std::string size = a.size ? text_of(*a.size) : "none";
  const std::string delivered =
      a.size ? text_of(*a.size * outcome.ended.length_factor) : std::string("none");
  // The names are those of the command, which verify() looks for.
  made.claim.options = {
      {"chord-tolerance", a.chord_tolerance ? text_of(*a.chord_tolerance) : "none"},
      {"domain", "given"},
      {"angle-bound", text_of(a.options.angle_bound)},
      {"size", size},
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
      {"metric-fingerprint", "none"},
      {"regions", "as given"},
      {"random-points", "0"},
      {"repair-distance", "none"},
      {"repair-done", "none"},
      {"repair-places", "none"},
      {"metric-tolerance",
       a.options.metric_tolerance ? text_of(*a.options.metric_tolerance) : "none"},
      {"seed", "1"}};
  py_mesh m;
  m.complete = made.outcome.complete;
  m.certified = made.certified();
  m.reason = made.claim.reason;
  m.angle_bound = a.options.angle_bound;
  m.claim = std::move(made.claim);
  m.content = std::move(made.outcome.result);
  return m;
}

// Returns the domain with chords for the metric and the tolerance, as the command divides them.
result<domain> divided_for(const domain& d, const field_of_size& metric, const scale_demand& scale,
                           const mesh_arguments& a) {
  curve_division chords;
  chords.chord_tolerance = a.chord_tolerance;
  if (!a.options.limit_size) return divide_curves_anew(d, chords);
  scale_demand wanted = scale;
  if (a.options.vertices) wanted.complexity = complexity_of_vertices(*a.options.vertices);
  const auto scaled = make_scaled_metric(d, metric, wanted);
  if (!scaled) return scaled.failure();
  chords.field = scaled.value().field.get();
  chords.most_chords = a.options.vertices.value_or(a.options.max_sites);
  return divide_curves_anew(d, chords);
}

py_mesh run(const domain& d, const py::object& metric, mesh_arguments a) {
  if (a.chord_tolerance && d.curves.empty())
    throw input_error("chord_tolerance: the domain has no curves");
  if (d.vertices.size() > a.options.max_sites)
    throw input_error("max_sites: the domain has " + std::to_string(d.vertices.size()) +
                      " vertices already");
  if (a.options.vertices && d.vertices.size() > *a.options.vertices)
    throw input_error("vertices: the domain has " + std::to_string(d.vertices.size()) + " already");
  raised_error errors;
  // A function called for a metric must live as long as the last field that calls it.
  std::vector<python_metric> wanted;
  const field_of_size metric_of_size = [&](double size) -> result<std::unique_ptr<metric_field>> {
    const py::gil_scoped_acquire locked;
    wanted.push_back(metric_of(metric, d, size, errors));
    return std::move(wanted.back().field);
  };
  a.options.stop = [&errors] { return reason_to_stop(errors); };
  std::function<void(const mesh_progress&)> progress;
  if (!a.progress.is_none())
    progress = [&](const mesh_progress& now) { tell(a.progress, now, errors); };
  const scale_demand scale{a.size, a.complexity, a.gradation, a.options.stop};
  std::optional<result<counted_mesh>> made;
  {
    const py::gil_scoped_release unlocked;
    const bool is_divided = !d.curves.empty() && (a.options.limit_size || a.chord_tolerance);
    const auto shape = is_divided ? divided_for(d, metric_of_size, scale, a) : result<domain>(d);
    if (shape)
      made = make_counted_mesh(shape.value(), metric_of_size, scale, a.options, progress);
    else
      made = shape.failure();
  }
  errors.raise();
  counted_mesh done = value_or_raise(std::move(*made));
  if (done.metric.complexity) a.size = done.metric.size;
  return packaged(std::move(done.made), wanted.back().name, a, done.metric.complexity);
}

// Returns the findings of the auditor, as Python reads them.
py::dict findings_of(const audit_report& audit) {
  py::list witnesses;
  for (const audit_finding& f : audit.findings)
    witnesses.append(py::make_tuple(
        std::string(finding_kind_names[static_cast<std::size_t>(f.kind)]), f.witness));
  py::dict d;
  d["sites"] = audit.sites;
  d["triangles"] = audit.triangles;
  d["worst_angle"] = audit.worst().degrees;
  d["low_triangles"] = audit.refused_triangles();
  d["exempt_corners"] = audit.exempt_corners;
  d["findings"] = witnesses;
  return d;
}

py::dict verify_mesh(const py_mesh& m, const std::optional<std::string>& text,
                     const std::optional<double>& angle_bound) {
  std::optional<certificate> claim = m.claim;
  if (text) claim = value_or_raise(parse_certificate(*text, "certificate"));
  verify_report report;
  {
    const py::gil_scoped_release unlocked;
    audit_options options;
    options.angle_bound = angle_bound;
    report = verify(m.content, claim, options);
  }
  py::dict d = findings_of(report.audit);
  d["verified"] = report.verified;
  d["contradictions"] = report.contradictions;
  return d;
}

py::dict certify_mesh(const py_mesh& m, double angle_bound, bool prove_voronoi) {
  if (!(angle_bound >= 0 && angle_bound < 60))
    throw input_error("angle_bound: at least 0 and below 60 degrees is wanted");
  certify_report report;
  {
    const py::gil_scoped_release unlocked;
    const auto adopted = value_or_raise(adopt_mesh(m.content, region_edges::as_listed));
    report = certify(adopted, angle_bound, prove_voronoi);
  }
  py::dict d = findings_of(report.audit);
  d["certified"] = report.certified();
  d["inverted"] = report.inverted;
  d["in_stars"] = report.in_stars;
  d["not_in_all_stars"] = report.not_in_all;
  d["below_bound"] = report.below_bound;
  d["edges"] = report.edges;
  d["unit_edges"] = report.unit_edges;
  d["voronoi"] = std::string(voronoi_verdict_names[static_cast<std::size_t>(report.audit.voronoi)]);
  return d;
}

}  // namespace

void define_meshing(py::module_& m) {
  m.def("_mesh",
        [](const domain& d, const py::object& metric, const std::optional<double>& size,
           double angle_bound, std::size_t max_sites, const std::optional<double>& gradation,
           bool prove_voronoi, std::size_t improve, const std::optional<std::size_t>& vertices,
           const std::optional<double>& complexity, const std::optional<double>& metric_tolerance,
           const std::optional<double>& chord_tolerance, const py::object& progress) {
          return run(
              d, metric,
              arguments_of(size, angle_bound, max_sites, gradation, prove_voronoi, improve,
                           vertices, complexity, metric_tolerance, chord_tolerance, progress));
        });
  m.def("_verify", &verify_mesh);
  m.def("_certify", &certify_mesh);
}

}  // namespace asterism::python
