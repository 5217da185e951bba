// SPDX-License-Identifier: MIT
#include <pybind11/pybind11.h>

#include "arguments.hpp"
#include "asterism/core/version.h"
#include "bindings.hpp"

PYBIND11_MODULE(_asterism, m) {
  using namespace asterism::python;
  m.doc() = "Exact anisotropic predicates and certified meshes; use the package asterism.";
  m.attr("__version__") = ASTERISM_VERSION_TEXT;
  pybind11::register_exception<input_error>(m, "InputError", PyExc_ValueError);
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
