// SPDX-License-Identifier: MIT
//
// Reads numpy arrays as the library's rows of numbers, without copies where their layout allows it,
// and errors as Python's.
#pragma once

#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>

#include <stdexcept>
#include <string>

#include "asterism/core/result.hpp"
#include "asterism/kernels/c_batch.h"

namespace asterism::python {

namespace py = pybind11;

// asterism.InputError, a ValueError.
class input_error : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

template <class T>
T value_or_raise(result<T> from) {
  if (!from) throw input_error(from.failure().message);
  return std::move(from).value();
}

// An array of doubles with `width` numbers in a row; keeps what it looks at alive.
class number_table {
 public:
  // `name` is the argument's, for messages.
  number_table(const py::object& from, py::ssize_t width, const char* name);

  bool is_single() const { return single_; }
  // Returns the number of rows, 1 where a single row stands for all.
  std::size_t rows() const { return rows_; }
  // A single row stands for as many as there are.
  asterism_rows every() const { return {first_, rows_ == 1 ? 0 : stride_}; }
  const double* row(std::size_t k) const { return first_ + k * stride_; }

 private:
  py::array_t<double> array_;
  const double* first_ = nullptr;
  std::size_t stride_ = 0, rows_ = 0;
  bool single_ = false;
};

}  // namespace asterism::python
