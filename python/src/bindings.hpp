// SPDX-License-Identifier: MIT
//
// Declares the parts of the module asterism._asterism, one for each source file.
#pragma once

#include <pybind11/pybind11.h>

namespace asterism::python {

void define_predicates(pybind11::module_& m);
void define_domain(pybind11::module_& m);
void define_mesh(pybind11::module_& m);
void define_measures(pybind11::module_& m);
void define_pages(pybind11::module_& m);
void define_polygons(pybind11::module_& m);
void define_meshing(pybind11::module_& m);
void define_adapting(pybind11::module_& m);
void define_judging(pybind11::module_& m);
void define_solution(pybind11::module_& m);
void define_surfaces(pybind11::module_& m);

}  // namespace asterism::python
