// SPDX-License-Identifier: MIT
//
// Reads numpy arrays as the library's rows of numbers, without copies where their layout allows it,
// keyword arguments as numbers, and errors as Python's. Nothing of an argument is left out in
// silence: imaginary parts, masks and fractions of whole numbers are refused.
#pragma once

#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>

#include <cstdint>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include "asterism/core/result.hpp"
#include "asterism/kernels/c_batch.h"

namespace asterism::python {

namespace py = pybind11;

// asterism.InputError, a ValueError.
class input_error : public std::runtime_error {
 public:
  explicit input_error(const std::string& message)
      : std::runtime_error(message), message_(message) {}

  // Returns the whole message, of which what() ends at a NUL.
  const std::string& message() const { return message_; }

 private:
  std::string message_;
};

// Text that holds names of files, whose bytes need not be UTF-8. In Python it is a str in which a
// surrogate stands for each byte that is none, as open() and os.fsencode() take it.
struct system_text {
  std::string bytes;
};
std::vector<system_text> system_texts(const std::vector<std::string>& all);

template <class T>
T value_or_raise(result<T> from) {
  if (!from) throw input_error(from.failure().message);
  return std::move(from).value();
}

// Warns, as Python does, of what was changed or passed over.
void warn(const std::vector<std::string>& notes);

// Returns the shape of an array, as Python writes it.
std::string shape_text(const py::array& array);

// Returns an array of doubles. `name` is the argument's, for messages.
py::array_t<double> doubles_of(const py::object& from, const char* name);

using whole_array = py::array_t<std::int64_t, py::array::c_style>;
// Returns an array of whole numbers, whatever type holds them.
whole_array wholes_of(const py::object& from, const char* name);

// Views an array with `width` doubles in a row, and keeps the array alive.
class number_table {
 public:
  // `name` is the argument's, for messages.
  number_table(const py::object& from, py::ssize_t width, const char* name);

  bool is_single() const { return single_; }
  // Returns the number of rows, 1 where a single row stands for all.
  std::size_t rows() const { return rows_; }
  // Returns the rows; a single one stands for as many as are read.
  asterism_rows every() const { return {first_, rows_ == 1 ? 0 : stride_}; }
  const double* row(std::size_t k) const { return first_ + k * stride_; }

 private:
  py::array_t<double> array_;
  const double* first_ = nullptr;
  std::size_t stride_ = 0, rows_ = 0;
  bool single_ = false;
};

// Holds keyword arguments by name. A missing one counts as None.
class keywords {
 public:
  explicit keywords(py::dict given) : given_(std::move(given)) {}

  py::object object(const char* name) const;
  bool has(const char* name) const { return !object(name).is_none(); }
  // Returns a number, which may be infinite; none for None.
  std::optional<double> real(const char* name) const;
  // The same, refused unless it is positive and finite.
  std::optional<double> positive(const char* name) const;
  // The same, refused unless it is at least 0 and finite.
  std::optional<double> from_zero(const char* name) const;
  // Returns a whole number of at least `least`; none for None.
  std::optional<std::size_t> count(const char* name, std::size_t least = 0) const;
  // Returns False for None.
  bool flag(const char* name) const;
  std::string word(const char* name) const;

 private:
  py::dict given_;
};

}  // namespace asterism::python

namespace pybind11::detail {

// Converts str to system_text, and back.
template <>
struct type_caster<asterism::python::system_text> {
  PYBIND11_TYPE_CASTER(asterism::python::system_text, const_name("str"));

  bool load(handle from, bool) {
    if (!PyUnicode_Check(from.ptr())) return false;
    const auto encoded = reinterpret_steal<bytes>(PyUnicode_EncodeFSDefault(from.ptr()));
    if (!encoded) {
      PyErr_Clear();
      return false;
    }
    value.bytes = encoded;
    return true;
  }

  static handle cast(const asterism::python::system_text& from, return_value_policy, handle) {
    return PyUnicode_DecodeFSDefaultAndSize(from.bytes.data(),
                                            static_cast<Py_ssize_t>(from.bytes.size()));
  }
};

}  // namespace pybind11::detail
