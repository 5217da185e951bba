// SPDX-License-Identifier: MIT
//
// Makes metrics for the next mesh from a solution, and transfers the solution to it.
#include "asterism/mesh/data/solution.hpp"

#include "asterism/mesh/io/solution_file.hpp"
#include "asterism/mesh/solution/implied_metric.hpp"
#include "asterism/mesh/solution/solution_metric.hpp"
#include "asterism/mesh/support/tensor_text.hpp"
#include "asterism/mesh/transfer/transfer.hpp"
#include "bindings.hpp"
#include "py_mesh.hpp"
#include "python_metric.hpp"
#include "solution_arguments.hpp"

namespace asterism::python {
namespace {

// Makes the metric of fields, or, where there are none, bounds the given one.
py::tuple metric_for(const py_mesh& on, const named_fields& fields, const py::object& given,
                     const py::dict& more) {
  const mesh& m = on.content;
  const keywords words(more);
  const solution_metric_options options = wishes_of(words);
  const solution values = solution_of(fields, m.sites.size());
  const auto besides = all_tensors_of(words.object("intersect"), m.sites.size(), "intersect");
  std::vector<metric_tensor> shaped;
  if (!given.is_none()) shaped = tensors_of(given, m.sites.size(), "values");
  const auto hessians = hessians_of(words.object("hessians"), m.sites.size());
  std::optional<result<solution_metric>> made;
  {
    const py::gil_scoped_release unlocked;
    if (!hessians.empty())
      made = make_hessian_metric(m, hessians, options, besides);
    else if (given.is_none())
      made = make_solution_metric(m, value_or_raise(select_values(values, {})), options, besides);
    else
      made = shape_metric(m, shaped, options, besides);
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
  return py::make_tuple(arrays_of(answer.values), dict_of(answer.report));
}

}  // namespace

void define_solution(py::module_& m) {
  m.attr("_loop_gradation") = loop_gradation;
  m.def(
      "_doubles",
      [](const std::string& name, const py::object& values) {
        return doubles_of(values, name.c_str());
      },
      py::arg("name"), py::arg("values"));
  m.def(
      "_tensor_text",
      [](double m11, double m12, double m22) {
        return internal::tensor_text({m11, m12, m22});
      },
      py::arg("m11"), py::arg("m12"), py::arg("m22"));
  m.def("_transfer", &transfer, py::arg("mesh"), py::arg("fields"), py::arg("to"), py::arg("how"));
  m.def("_metric", &metric_for, py::arg("mesh"), py::arg("fields"), py::arg("given"),
        py::arg("more"));
  m.def("_implied_metric", &implied, py::arg("mesh"));
  m.def(
      "_metric_at",
      [](const py_mesh& on, const py::object& metric) {
        return array_of(metric_at_vertices(on.content, metric));
      },
      py::arg("mesh"), py::arg("metric"));
}

}  // namespace asterism::python
