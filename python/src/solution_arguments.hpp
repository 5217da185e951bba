// SPDX-License-Identifier: MIT
//
// Reads fields, tensors and options of metrics from Python, and returns fields and reports.
#pragma once

#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

#include <string>
#include <utility>
#include <vector>

#include "arguments.hpp"
#include "asterism/mesh/data/solution.hpp"
#include "asterism/mesh/solution/solution_metric.hpp"
#include "asterism/mesh/transfer/transfer.hpp"

namespace asterism::python {

// Names, and arrays of one, two or three numbers at each point.
using named_fields = std::vector<std::pair<system_text, py::object>>;

py::array_t<double> array_of(const std::vector<metric_tensor>& tensors);
std::vector<metric_tensor> tensors_of(const py::object& from, std::size_t count, const char* name);
// Returns the tensors of each metric of a sequence.
std::vector<std::vector<metric_tensor>> all_tensors_of(const py::object& from, std::size_t count,
                                                       const char* name);

// Returns second derivatives by name. Raises unless all numbers are finite.
std::vector<nodal_hessian> hessians_of(const py::object& from, std::size_t count);

// Raises unless all numbers are finite.
solution solution_of(const named_fields& given, std::size_t count);
// Returns a list of arrays, (n, c) with c components.
py::list arrays_of(const solution& values);

// Reads the keywords of asterism.metric().
solution_metric_options wishes_of(const keywords& given);
transfer_method way_of(const std::string& name);

py::dict dict_of(const solution_metric_report& report);
py::dict dict_of(const transfer_report& report);

}  // namespace asterism::python
