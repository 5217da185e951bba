// SPDX-License-Identifier: MIT
//
// Metrics for the next mesh, from a solution on this one, and the solution brought to it.
#include "asterism/mesh/data/solution.hpp"

#include <pybind11/numpy.h>
#include <pybind11/stl.h>

#include <algorithm>
#include <cmath>

#include "arguments.hpp"
#include "asterism/mesh/solution/implied_metric.hpp"
#include "asterism/mesh/solution/solution_metric.hpp"
#include "asterism/mesh/transfer/transfer.hpp"
#include "bindings.hpp"
#include "py_mesh.hpp"

namespace asterism::python {
namespace {

using named_fields = std::vector<std::pair<std::string, py::array_t<double>>>;

py::array_t<double> array_of(const std::vector<metric_tensor>& tensors) {
  py::array_t<double> rows({static_cast<py::ssize_t>(tensors.size()), py::ssize_t{3}});
  auto to = rows.mutable_unchecked<2>();
  for (std::size_t k = 0; k < tensors.size(); ++k) {
    const auto row = static_cast<py::ssize_t>(k);
    to(row, 0) = tensors[k].m11;
    to(row, 1) = tensors[k].m12;
    to(row, 2) = tensors[k].m22;
  }
  return rows;
}

std::vector<metric_tensor> tensors_of(const py::object& from, std::size_t count, const char* name) {
  const number_table given(from, 3, name);
  if (given.rows() != count && !given.is_single())
    throw input_error(std::string(name) + ": " + std::to_string(given.rows()) + " tensors for " +
                      std::to_string(count) + " points");
  std::vector<metric_tensor> tensors(count);
  for (std::size_t k = 0; k < count; ++k) {
    const double* const t = given.row(given.is_single() ? 0 : k);
    tensors[k] = {t[0], t[1], t[2]};
  }
  return tensors;
}

std::vector<nodal_values> fields_of(const named_fields& given, std::size_t count) {
  std::vector<nodal_values> fields;
  for (const auto& [name, values] : given) {
    if (values.ndim() != 1 || static_cast<std::size_t>(values.size()) != count)
      throw input_error(name + ": an array of " + std::to_string(count) +
                        " numbers is wanted, one a point");
    nodal_values field{name, std::vector<double>(count)};
    const auto at = values.unchecked<1>();
    for (std::size_t k = 0; k < count; ++k) {
      field.values[k] = at(static_cast<py::ssize_t>(k));
      if (!std::isfinite(field.values[k]))
        throw input_error(name + ": number " + std::to_string(k) + " is not finite");
    }
    fields.push_back(std::move(field));
  }
  return fields;
}

hessian_method method_of(const std::string& name) {
  if (name == "l2") return hessian_method::l2_projection;
  if (name == "green") return hessian_method::green;
  if (name == "least_squares") return hessian_method::least_squares;
  throw input_error("hessian: 'l2', 'green' or 'least_squares' is wanted, not '" + name + "'");
}

py::dict dict_of(const solution_metric_report& r) {
  py::dict d;
  d["steps"] = r.steps;
  d["fields"] = r.fields;
  d["complexity_asked"] = r.complexity_asked;
  d["complexity_before_gradation"] = r.complexity_before_gradation;
  d["complexity_delivered"] = r.complexity_delivered;
  d["factor"] = r.factor;
  d["error_predicted"] = r.error_predicted;
  d["share_noise"] = r.share_noise;
  d["share_floored"] = r.share_floored;
  d["share_intersected"] = r.share_intersected;
  d["share_step"] = r.share_step;
  d["share_least_size"] = r.share_least_size;
  d["share_greatest_size"] = r.share_greatest_size;
  d["share_aspect"] = r.share_aspect;
  d["share_graded"] = r.share_graded;
  d["gradation_rounds"] = r.gradation_rounds;
  d["gradation_ended"] = r.gradation_ended;
  d["reached"] = r.reached;
  d["reason"] = r.reason;
  return d;
}

// Fills the options from Python's keywords, which asterism.metric() has checked the names of.
solution_metric_options options_of(const py::dict& given) {
  solution_metric_options options;
  const auto number = [&](const char* name) { return given[name].cast<std::optional<double>>(); };
  options.hessian = method_of(given["hessian"].cast<std::string>());
  options.norm = number("norm");
  if (options.norm && std::isinf(*options.norm) && *options.norm > 0) options.norm.reset();
  options.vertices = number("vertices");
  options.complexity = number("complexity");
  options.error = number("error");
  options.least_size = number("hmin").value_or(options.least_size);
  options.greatest_size = number("hmax").value_or(options.greatest_size);
  options.aspect = number("aspect").value_or(options.aspect);
  options.gradation = number("gradation");
  options.gradation_keeps_shape = given["gradation_keeps_shape"].cast<bool>();
  options.isotropic = given["isotropic"].cast<bool>();
  options.step = number("step");
  return options;
}

// Makes the metric of fields, or, where there are none, puts bounds on the one given.
py::tuple metric_for(const py_mesh& on, const named_fields& fields, const py::object& given,
                     const py::list& intersect, const py::dict& keywords) {
  const mesh& m = on.content;
  const solution_metric_options options = options_of(keywords);
  const std::vector<nodal_values> values = fields_of(fields, m.sites.size());
  std::vector<std::vector<metric_tensor>> besides;
  for (const py::handle& more : intersect)
    besides.push_back(
        tensors_of(py::reinterpret_borrow<py::object>(more), m.sites.size(), "intersect"));
  std::vector<metric_tensor> shaped;
  if (!given.is_none()) shaped = tensors_of(given, m.sites.size(), "values");
  std::optional<result<solution_metric>> made;
  {
    const py::gil_scoped_release unlocked;
    made = given.is_none() ? make_solution_metric(m, values, options, besides)
                           : shape_metric(m, shaped, options, besides);
  }
  const solution_metric answer = value_or_raise(std::move(*made));
  return py::make_tuple(array_of(answer.tensors), dict_of(answer.report));
}

py::array_t<double> implied(const py_mesh& on) {
  std::optional<result<std::vector<metric_tensor>>> made;
  {
    const py::gil_scoped_release unlocked;
    made = implied_metric(on.content);
  }
  return array_of(value_or_raise(std::move(*made)));
}

transfer_method way_of(const std::string& name) {
  if (name == "interpolate") return transfer_method::interpolate;
  if (name == "conservative") return transfer_method::project;
  if (name == "bounded") return transfer_method::bounded;
  throw input_error("how: 'interpolate', 'conservative' or 'bounded' is wanted, not '" + name +
                    "'");
}

// Fields of one, two or three numbers a point.
solution solution_of(const named_fields& given, std::size_t count) {
  solution s;
  s.vertices = count;
  for (const auto& [name, values] : given) {
    const py::ssize_t width = values.ndim() == 2 ? values.shape(1) : 1;
    if (values.ndim() < 1 || values.ndim() > 2 || width < 1 || width > 3 ||
        static_cast<std::size_t>(values.shape(0)) != count)
      throw input_error(name + ": " + std::to_string(count) +
                        " rows of one, two or three numbers are wanted");
    const auto packed = py::array_t<double, py::array::c_style | py::array::forcecast>(values);
    solution_field field{name, static_cast<field_kind>(width), {}};
    field.values.assign(packed.data(), packed.data() + packed.size());
    for (std::size_t k = 0; k < field.values.size(); ++k)
      if (!std::isfinite(field.values[k]))
        throw input_error(name + ": row " + std::to_string(k / static_cast<std::size_t>(width)) +
                          " is not finite");
    s.fields.push_back(std::move(field));
  }
  return s;
}

py::dict dict_of(const transfer_report& r) {
  py::dict d, components;
  for (const transferred_component& c : r.components) {
    py::dict of;
    of["integral_before"] = c.integral_before;
    of["integral_after"] = c.integral_after;
    of["least_before"] = c.least_before;
    of["greatest_before"] = c.greatest_before;
    of["least_after"] = c.least_after;
    of["greatest_after"] = c.greatest_after;
    components[py::str(c.name)] = of;
  }
  d["components"] = components;
  d["area_before"] = r.area_before;
  d["area_after"] = r.area_after;
  d["area_common"] = r.area_common;
  d["outside"] = r.outside;
  d["greatest_distance"] = r.greatest_distance;
  d["partly_covered"] = r.partly_covered;
  d["pieces"] = r.pieces;
  return d;
}

py::tuple transfer(const py_mesh& from, const named_fields& fields, const py_mesh& to,
                   const std::string& how) {
  const transfer_method way = way_of(how);
  const solution given = solution_of(fields, from.content.sites.size());
  std::optional<result<transferred_solution>> made;
  {
    const py::gil_scoped_release unlocked;
    made = transfer_solution(from.content, given, to.content, way);
  }
  const transferred_solution answer = value_or_raise(std::move(*made));
  py::list values;
  for (const solution_field& field : answer.values.fields) {
    const auto width = static_cast<py::ssize_t>(components_of(field.kind));
    const auto rows = static_cast<py::ssize_t>(field.values.size()) / width;
    py::array_t<double> array({rows, width});
    std::copy(field.values.begin(), field.values.end(), array.mutable_data());
    values.append(array);
  }
  return py::make_tuple(values, dict_of(answer.report));
}

}  // namespace

void define_solution(py::module_& m) {
  m.attr("_loop_gradation") = loop_gradation;
  m.def("_transfer", &transfer);
  m.def("_metric", &metric_for);
  m.def("_implied_metric", &implied);
}

}  // namespace asterism::python
