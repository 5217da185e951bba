// SPDX-License-Identifier: MIT
//
// Holds a domain for Python, with the repairs that were made.
#pragma once

#include "asterism/mesh/data/domain.hpp"
#include "asterism/mesh/domain/check_domain.hpp"
#include "asterism/mesh/domain/cracks.hpp"

namespace asterism::python {

struct py_domain {
  domain shape;               // as check_domain returns it
  domain_repairs mended;      // distance 0 where no repair was asked for
  crack_markers cracks = {};  // of a mesh: meshes of the domain have the vertices of both sides
};

}  // namespace asterism::python
