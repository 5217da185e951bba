// SPDX-License-Identifier: MIT
#include <pybind11/pybind11.h>

#include <exception>
#include <string>

#include "arguments.hpp"
#include "asterism/core/version.h"
#include "bindings.hpp"

namespace {

// Raises InputError with the whole message. pybind11 itself would end it at a NUL, and leave it out
// where a byte is no UTF-8. Such bytes become surrogates, which the package shows as `?`.
void raise_input_error(std::exception_ptr thrown) {
  namespace py = pybind11;
  if (!thrown) return;
  try {
    std::rethrow_exception(thrown);
  } catch (const asterism::python::input_error& e) {
    const std::string& text = e.message();
    const auto size = static_cast<Py_ssize_t>(text.size());
    const auto shown = py::reinterpret_steal<py::object>(
        PyUnicode_DecodeUTF8(text.data(), size, "surrogateescape"));
    const py::object type = py::module_::import("asterism._asterism").attr("InputError");
    PyErr_SetObject(type.ptr(), shown.ptr());
  }
}

}  // namespace

PYBIND11_MODULE(_asterism, m) {
  using namespace asterism::python;
  m.doc() = "Exact anisotropic predicates and certified meshes; use the package asterism.";
  m.attr("__version__") = ASTERISM_VERSION_TEXT;
  pybind11::register_exception<input_error>(m, "InputError", PyExc_ValueError);
  pybind11::register_exception_translator(&raise_input_error);
  define_predicates(m);
  define_domain(m);
  define_mesh(m);
  define_measures(m);
  define_pages(m);
  define_polygons(m);
  define_meshing(m);
  define_adapting(m);
  define_judging(m);
  define_solution(m);
  define_surfaces(m);
}
