// SPDX-License-Identifier: MIT
//
// Makes a metric field of a text, a callable, or a mesh with tensors.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "asterism/mesh/data/domain.hpp"
#include "asterism/mesh/data/mesh.hpp"
#include "asterism/mesh/data/metric_field.hpp"
#include "watched_run.hpp"

namespace asterism::python {

class called_field;

// Holds a metric field, and the objects that must live as long as it.
class python_metric {
 public:
  // Makes the field for edges of length `size`, for a domain from this file, or from none, with
  // this box. With the interpreter's lock.
  python_metric(const py::object& metric, const std::string& file, const bounding_box& box,
                double size, raised_error& errors);
  ~python_metric();
  python_metric(python_metric&&) noexcept;
  python_metric& operator=(python_metric&&) = delete;

  const std::string& name() const { return name_; }  // the metric's words in certificates
  std::unique_ptr<metric_field> take_field() { return std::move(field_); }
  // Fingerprint, in digits, of the file that it was read from; "none" where there was no file.
  const std::string& fingerprint() const { return fingerprint_; }

 private:
  std::string name_, fingerprint_ = "none";
  std::unique_ptr<called_field> callable_;  // used by the field
  std::unique_ptr<metric_field> field_;
};

// Returns a metric's tensors at the vertices of a mesh. The metric is a text, placed in the
// bounding box of these vertices, or a pair of another mesh and tensors at its vertices. Of the
// texts, a file of numbers alone has them for the vertices of `m`, in their order.
std::vector<metric_tensor> metric_at_vertices(const mesh& m, const py::object& metric);

}  // namespace asterism::python
