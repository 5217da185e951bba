// SPDX-License-Identifier: MIT
#include "arguments.hpp"

namespace asterism::python {
namespace {

py::array_t<double> as_doubles(const py::object& from, const char* name) {
  auto array = py::array_t<double>::ensure(from);
  if (array) return array;
  PyErr_Clear();
  throw input_error(std::string(name) + ": an array of numbers is wanted");
}

// Rows of doubles side by side, any whole number of doubles apart.
bool has_plain_rows(const py::array_t<double>& a) {
  constexpr py::ssize_t size = sizeof(double);
  const py::ssize_t last = a.ndim() - 1;
  return a.strides(last) == size && (last == 0 || (a.strides(0) >= 0 && a.strides(0) % size == 0));
}

}  // namespace

number_table::number_table(const py::object& from, py::ssize_t width, const char* name)
    : array_(as_doubles(from, name)) {
  const bool fits =
      (array_.ndim() == 1 || array_.ndim() == 2) && array_.shape(array_.ndim() - 1) == width;
  if (!fits && array_.size() != 0)
    throw input_error(std::string(name) + ": the shape (n, " + std::to_string(width) + ") or (" +
                      std::to_string(width) + ",) is wanted");
  single_ = array_.ndim() == 1 && array_.size() != 0;
  rows_ = array_.size() == 0 ? 0 : single_ ? 1 : static_cast<std::size_t>(array_.shape(0));
  if (rows_ != 0 && !has_plain_rows(array_))
    array_ = py::array_t<double, py::array::c_style | py::array::forcecast>(array_);
  first_ = array_.data();
  if (rows_ > 0 && !single_) stride_ = static_cast<std::size_t>(array_.strides(0)) / sizeof(double);
}

}  // namespace asterism::python
