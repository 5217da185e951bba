// SPDX-License-Identifier: MIT
#include "arguments.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "asterism/core/number_text.hpp"

namespace asterism::python {
namespace {

[[noreturn]] void refuse(const char* name, const std::string& why) {
  throw input_error(std::string(name) + ": " + why);
}

// Returns the argument as Python writes it, shortened, for a message.
std::string shown(const py::object& value) {
  constexpr std::size_t most = 60;
  std::string text = py::repr(value).cast<std::string>();
  std::replace(text.begin(), text.end(), '\n', ' ');
  if (text.size() > most) text = text.substr(0, most) + "...";
  return text;
}

// Refuses the entries that a masked array leaves out.
void check_mask(const py::object& from, const char* name) {
  if (!py::hasattr(from, "mask") || !py::isinstance<py::array>(from)) return;
  const py::object any = py::module_::import("numpy").attr("any")(from.attr("mask"));
  if (any.cast<bool>()) refuse(name, "some of its entries are masked, and every one is wanted");
}

// True if the doubles of a row lie side by side, and rows a whole number of doubles apart.
bool has_plain_rows(const py::array_t<double>& a) {
  constexpr py::ssize_t size = sizeof(double);
  const py::ssize_t last = a.ndim() - 1;
  return a.strides(last) == size && (last == 0 || (a.strides(0) >= 0 && a.strides(0) % size == 0));
}

py::array array_of(const py::object& from, const char* name, const char* of_what) {
  check_mask(from, name);
  auto array = py::array::ensure(from);
  if (!array) {
    PyErr_Clear();
    refuse(name, std::string("an array of ") + of_what + " is wanted, not " + shown(from));
  }
  return array;
}

}  // namespace

std::vector<system_text> system_texts(const std::vector<std::string>& all) {
  std::vector<system_text> texts;
  for (const std::string& text : all) texts.push_back({text});
  return texts;
}

void warn(const std::vector<std::string>& notes) {
  if (notes.empty()) return;
  const py::object say = py::module_::import("asterism._calls").attr("warn");
  for (const system_text& note : system_texts(notes)) say(note);
}

std::string shape_text(const py::array& array) {
  return py::str(array.attr("shape")).cast<std::string>();
}

py::array_t<double> doubles_of(const py::object& from, const char* name) {
  if (py::isinstance<py::array_t<double>>(from)) {
    check_mask(from, name);
    return py::reinterpret_borrow<py::array_t<double>>(from);
  }
  const py::array given = array_of(from, name, "numbers");
  const char kind = given.dtype().kind();
  if (kind == 'c') refuse(name, "complex numbers have no place here");
  if (kind == 'U' || kind == 'S') refuse(name, "an array of numbers is wanted, not " + shown(from));
  auto array = py::array_t<double>::ensure(given);
  if (array) return array;
  PyErr_Clear();
  refuse(name, "an array of numbers is wanted, not " + shown(from));
}

whole_array wholes_of(const py::object& from, const char* name) {
  const py::array given = array_of(from, name, "whole numbers");
  const char kind = given.dtype().kind();
  const auto as_wholes = [&given] {
    return given.attr("astype")("int64", py::arg("order") = "C").cast<whole_array>();
  };
  if (given.size() == 0) return as_wholes();  // an empty list is an array of doubles
  if (kind == 'i' || kind == 'b') return given.cast<whole_array>();
  if (kind != 'u' && kind != 'f' && kind != 'O')
    refuse(name, "an array of whole numbers is wanted, not " + shown(from));
  const auto numbers =
      py::array_t<double, py::array::c_style | py::array::forcecast>::ensure(given);
  if (!numbers) {
    PyErr_Clear();
    refuse(name, "an array of whole numbers is wanted, not " + shown(from));
  }
  // 2^62: a double, and well within 64 bits.
  constexpr double most = 4611686018427387904.0;
  for (py::ssize_t k = 0; k < numbers.size(); ++k)
    if (const double x = numbers.data()[k]; x != std::floor(x) || !(std::abs(x) <= most))
      refuse(name, "number " + std::to_string(k) + " is " + internal::format_number(x) +
                       ", and whole numbers are wanted");
  return as_wholes();
}

number_table::number_table(const py::object& from, py::ssize_t width, const char* name)
    : array_(doubles_of(from, name)) {
  const bool fits =
      (array_.ndim() == 1 || array_.ndim() == 2) && array_.shape(array_.ndim() - 1) == width;
  if (!fits && array_.size() != 0)
    refuse(name, "the shape (n, " + std::to_string(width) + ") or (" + std::to_string(width) +
                     ",) is wanted, not " + shape_text(array_));
  single_ = array_.ndim() == 1 && array_.size() != 0;
  rows_ = array_.size() == 0 ? 0 : single_ ? 1 : static_cast<std::size_t>(array_.shape(0));
  if (rows_ != 0 && !has_plain_rows(array_))
    array_ = py::array_t<double, py::array::c_style | py::array::forcecast>(array_);
  first_ = array_.data();
  if (rows_ > 0 && !single_) stride_ = static_cast<std::size_t>(array_.strides(0)) / sizeof(double);
}

py::object keywords::object(const char* name) const {
  return given_.contains(name) ? py::object(given_[name]) : py::object(py::none());
}

std::optional<double> keywords::real(const char* name) const {
  const py::object value = object(name);
  if (value.is_none()) return std::nullopt;
  const bool is_number = !PyBool_Check(value.ptr()) && !PyUnicode_Check(value.ptr());
  const double x = is_number ? PyFloat_AsDouble(value.ptr()) : -1;
  const bool failed = PyErr_Occurred() != nullptr;
  PyErr_Clear();
  if (!is_number || failed || std::isnan(x))
    refuse(name, "a number is wanted, not " + shown(value));
  return x;
}

std::optional<double> keywords::positive(const char* name) const {
  const auto x = real(name);
  if (x && !(*x > 0 && std::isfinite(*x)))
    refuse(name, "a positive finite number is wanted, not " + shown(object(name)));
  return x;
}

std::optional<double> keywords::from_zero(const char* name) const {
  const auto x = real(name);
  if (x && !(*x >= 0 && std::isfinite(*x)))
    refuse(name, "a finite number of at least 0 is wanted, not " + shown(object(name)));
  return x;
}

std::optional<std::size_t> keywords::count(const char* name, std::size_t least) const {
  const auto x = real(name);
  if (!x) return std::nullopt;
  constexpr double most = 1e15;  // all whole numbers up to here are doubles
  if (!(*x >= static_cast<double>(least) && *x <= most) || *x != std::floor(*x))
    refuse(name, "a whole number of at least " + std::to_string(least) + " is wanted, not " +
                     shown(object(name)));
  return static_cast<std::size_t>(*x);
}

bool keywords::flag(const char* name) const {
  const py::object value = object(name);
  if (value.is_none()) return false;
  const bool is_flag =
      PyBool_Check(value.ptr()) || PyLong_Check(value.ptr()) ||
      py::str(py::type::of(value)).cast<std::string>().find("numpy.bool") != std::string::npos;
  if (!is_flag) refuse(name, "True or False is wanted, not " + shown(value));
  const int is_true = PyObject_IsTrue(value.ptr());
  if (is_true < 0) throw py::error_already_set();
  return is_true == 1;
}

std::string keywords::word(const char* name) const {
  const py::object value = object(name);
  if (!py::isinstance<py::str>(value)) refuse(name, "a text is wanted, not " + shown(value));
  return value.cast<std::string>();
}

}  // namespace asterism::python
