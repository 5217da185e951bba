// SPDX-License-Identifier: MIT
#include "solution_arguments.hpp"

#include <algorithm>
#include <cmath>

namespace asterism::python {
namespace {

hessian_method method_of(const std::string& name) {
  if (name == "l2") return hessian_method::l2_projection;
  if (name == "green") return hessian_method::green;
  if (name == "least_squares" || name == "lsq") return hessian_method::least_squares;
  throw input_error("hessian: 'l2', 'green' or 'lsq' is wanted, not '" + name + "'");
}

}  // namespace

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

std::vector<std::vector<metric_tensor>> all_tensors_of(const py::object& from, std::size_t count,
                                                       const char* name) {
  std::vector<std::vector<metric_tensor>> all;
  if (from.is_none()) return all;
  for (const py::handle& one : from)
    all.push_back(tensors_of(py::reinterpret_borrow<py::object>(one), count, name));
  return all;
}

std::vector<nodal_hessian> hessians_of(const py::object& from, std::size_t count) {
  std::vector<nodal_hessian> all;
  for (const auto& [text, rows] : from.cast<named_fields>()) {
    const std::string& name = text.bytes;
    all.push_back({name, tensors_of(rows, count, name.c_str())});
    for (std::size_t v = 0; v < count; ++v) {
      const metric_tensor& h = all.back().at[v];
      if (!std::isfinite(h.m11) || !std::isfinite(h.m12) || !std::isfinite(h.m22))
        throw input_error(name + ": row " + std::to_string(v) + " is not finite");
    }
  }
  return all;
}

solution solution_of(const named_fields& given, std::size_t count) {
  solution s;
  s.vertices = count;
  for (const auto& [text, values] : given) {
    const std::string& name = text.bytes;
    const auto packed = py::array_t<double, py::array::c_style | py::array::forcecast>(
        doubles_of(values, name.c_str()));
    const py::ssize_t width = packed.ndim() == 2 ? packed.shape(1) : 1;
    if (packed.ndim() < 1 || packed.ndim() > 2 || width < 1 || width > 3 ||
        static_cast<std::size_t>(packed.shape(0)) != count)
      throw input_error(name + ": " + std::to_string(count) +
                        " rows of one, two or three numbers are wanted, one row a point");
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

py::list arrays_of(const solution& values) {
  py::list all;
  for (const solution_field& field : values.fields) {
    const auto width = static_cast<py::ssize_t>(components_of(field.kind));
    const auto rows = static_cast<py::ssize_t>(field.values.size()) / width;
    py::array_t<double> array({rows, width});
    std::copy(field.values.begin(), field.values.end(), array.mutable_data());
    all.append(array);
  }
  return all;
}

solution_metric_options wishes_of(const keywords& given) {
  solution_metric_options options;
  options.hessian = method_of(given.word("hessian"));
  options.norm = given.real("norm");
  if (options.norm && std::isinf(*options.norm) && *options.norm > 0) options.norm.reset();
  if (const auto n = given.count("vertices", 1)) options.vertices = static_cast<double>(*n);
  options.complexity = given.positive("complexity");
  options.error = given.positive("error");
  options.relative = given.flag("relative");
  options.cutoff = given.positive("cutoff");
  if (options.relative && !options.error)
    throw input_error("relative: it is of an error, and none is wanted");
  constexpr double usual_norm = 2;
  if (options.relative && options.norm != usual_norm)
    throw input_error("norm: a relative error is of no norm; leave it out");
  if (options.cutoff && !options.relative) throw input_error("cutoff: it is of relative=True");
  if (options.cutoff && *options.cutoff > 1)
    throw input_error("cutoff: above 0 and at most 1 is wanted");
  options.least_size = given.from_zero("hmin").value_or(options.least_size);
  options.greatest_size = given.positive("hmax").value_or(options.greatest_size);
  options.aspect = given.positive("aspect").value_or(options.aspect);
  options.gradation = given.real("gradation");
  options.gradation_keeps_shape = given.flag("gradation_keeps_shape");
  options.isotropic = given.flag("isotropic");
  options.step = given.positive("step");
  if (!(options.least_size < options.greatest_size))
    throw input_error("hmin: less than hmax is wanted");
  return options;
}

transfer_method way_of(const std::string& name) {
  if (name == "interpolate") return transfer_method::interpolate;
  if (name == "conservative" || name == "project") return transfer_method::project;
  if (name == "bounded") return transfer_method::bounded;
  throw input_error("how: 'interpolate', 'project' or 'bounded' is wanted, not '" + name + "'");
}

py::dict dict_of(const solution_metric_report& r) {
  py::dict d;
  d["steps"] = r.steps;
  d["fields"] = system_texts(r.fields);
  d["complexity_asked"] = r.complexity_asked;
  d["complexity_before_gradation"] = r.complexity_before_gradation;
  d["complexity_delivered"] = r.complexity_delivered;
  d["factor"] = r.factor;
  d["error_predicted"] = r.error_predicted;
  d["share_noise"] = r.share_noise;
  d["share_floored"] = r.share_floored;
  d["complexity_flat"] = r.complexity_at_least_density;
  d["complexity_at_longest"] = r.complexity_along_ridges;
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

}  // namespace asterism::python
