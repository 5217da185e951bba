// SPDX-License-Identifier: MIT
//
// Takes domains and meshes apart into what pickle knows, and puts them together again.
#pragma once

#include <pybind11/pybind11.h>

#include "py_domain.hpp"
#include "py_mesh.hpp"

namespace asterism::python {

pybind11::tuple state_of(const py_domain& d);
pybind11::tuple state_of(const py_mesh& m);
// Raise for a state of another version, and for what is no domain or mesh.
py_domain domain_of_state(const pybind11::tuple& state);
py_mesh mesh_of_state(const pybind11::tuple& state);

}  // namespace asterism::python
