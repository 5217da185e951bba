// SPDX-License-Identifier: MIT
#include "python_metric.hpp"

#include <pybind11/stl.h>

#include <algorithm>

#include "asterism/mesh/audit/audit.hpp"
#include "asterism/mesh/audit/certificate.hpp"
#include "asterism/mesh/c_interface/arrays.hpp"
#include "asterism/mesh/io/medit_solution.hpp"
#include "asterism/mesh/io/read_mesh.hpp"
#include "asterism/mesh/metric/interpolated_field.hpp"
#include "asterism/mesh/metric/make_metric_field.hpp"
#include "asterism/mesh/pipeline/foreign_mesh.hpp"
#include "asterism/mesh/pipeline/read_triangulation.hpp"
#include "py_mesh.hpp"

namespace asterism::python {

// Calls a function (n, 2) -> (n, 3) for many points at a time. After a failure, calls it for one
// point at a time.
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

  // Answers for many points; returns false where the function fails. Keeps no error of it
  // but an interrupt: calls for one point raise it again if it is not about the number of points.
  bool at_many(std::size_t count, const double* points, double* metrics) {
    try {
      answer(count, points, metrics);
    } catch (const py::error_already_set& raised) {
      takes_many_ = false;
      if (!raised.matches(PyExc_Exception)) errors_->keep();  // raised by an interrupt
    } catch (const input_error&) {
      takes_many_ = false;
    }
    return takes_many_;
  }

  // Refuses one tensor for many points: it may belong to the first point only.
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
  bool takes_many_ = true;  // read and set under the interpreter's lock
};

namespace {

std::unique_ptr<metric_field> sampled(const py::object& background, const py::object& tensors,
                                      double size) {
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
  const auto adopted =
      value_or_raise(adopt_mesh(std::move(copy), region_edges::segments, slit_rule::joined));
  audit_options options;
  options.check_stars = false;
  options.angle_bound = 0;
  const audit_report found = audit(adopted.subject, options);
  if (!found.certified)
    throw input_error("metric: its mesh is no triangulation: " + found.findings.at(0).witness);
  return make_interpolated_field(adopted.subject, size);
}

std::unique_ptr<metric_field> called(called_field& callable, const bounding_box& box, double size) {
  asterism_metric asked{};
  asked.batch_function = &called_field::ask;
  asked.context = &callable;
  asked.size = size;
  return value_or_raise(internal::field_of(asked, box));
}

std::vector<metric_tensor> tensors_in(const mesh& m) {
  std::vector<metric_tensor> tensors;
  tensors.reserve(m.sites.size());
  for (const asterism::site& s : m.sites) tensors.push_back(s.metric);
  return tensors;
}

// Reads a file of numbers for the vertices of a mesh.
std::vector<metric_tensor> numbers_at_vertices(const mesh& m, const std::string& file) {
  mesh numbered;
  numbered.sites = m.sites;
  medit_read_options how;
  how.solution = file;
  value_or_raise(internal::read_medit_solution(file, numbered, how));
  return tensors_in(numbered);
}

bounding_box box_of_vertices(const mesh& m) {
  if (m.sites.empty()) throw input_error("mesh: it has no points");
  bounding_box box{m.sites.front().position, m.sites.front().position};
  for (const asterism::site& s : m.sites) box.include(s.position);
  return box;
}

}  // namespace

python_metric::python_metric(const py::object& metric, const std::string& file,
                             const bounding_box& box, double size, raised_error& errors) {
  if (py::isinstance<py::str>(metric)) {
    name_ = metric.cast<system_text>().bytes;
    if (!internal::is_metric_on_mesh(name_)) {
      field_ = value_or_raise(make_metric_field(name_, box, size));
      return;
    }
    const auto read = value_or_raise(internal::read_metric_on_mesh(name_, file));
    field_ = make_interpolated_field(read.subject, size);
    fingerprint_ = std::to_string(mesh_fingerprint(*field_->background()));
    return;
  }
  if (py::isinstance<py::tuple>(metric) && py::len(metric) == 2) {
    const auto pair = metric.cast<py::tuple>();
    name_ = "of tensors at the vertices of a mesh";
    field_ = sampled(pair[0], pair[1], size);
    return;
  }
  name_ = "of a callable";
  callable_ = std::make_unique<called_field>(metric.cast<py::function>(), errors);
  field_ = called(*callable_, box, size);
}

python_metric::~python_metric() = default;
python_metric::python_metric(python_metric&&) noexcept = default;

std::vector<metric_tensor> metric_at_vertices(const mesh& m, const py::object& metric) {
  if (py::isinstance<py::str>(metric)) {
    const std::string name = metric.cast<system_text>().bytes;
    if (is_metric_file(name)) return numbers_at_vertices(m, name);
  }
  raised_error errors;
  const auto field = python_metric(metric, "", box_of_vertices(m), 1, errors).take_field();
  const py::gil_scoped_release unlocked;
  std::vector<metric_tensor> tensors;
  tensors.reserve(m.sites.size());
  for (const asterism::site& s : m.sites) tensors.push_back(value_or_raise(field->at(s.position)));
  return tensors;
}

}  // namespace asterism::python
