// SPDX-License-Identifier: MIT
//
// Chooses an origin from which places are measured while a solution is transferred, and powers of
// two by which places and values are divided. Far from the origin the places of crossings would be
// rounded by units of the coordinates, and integrals would change by that. Areas, their products
// with values, and the squares of these have to be in the range of doubles: beyond it a projection
// would be wrong. The differences from the origin are exact, and division changes no bit of a
// mantissa, so that all signs are the same.
#pragma once

#include <vector>

#include "asterism/mesh/data/mesh.hpp"
#include "asterism/mesh/data/solution.hpp"
#include "asterism/mesh/transfer/transferred_solution.hpp"

namespace asterism::internal {

struct transfer_scale {
  point origin{0, 0};
  int of_places = 0;           // as a power of two, and so are the others
  std::vector<int> of_fields;  // one a field of the solution

  bool is_one() const;
};

// Returns the origin: on each axis the end of both meshes that is nearer to 0, if no vertex is more
// than twice as far from 0, else 0. Returns the exponents: 0 where the largest place, or a field's
// largest value, is of ordinary size. Otherwise places are brought to about 1, and a field's values
// just to ordinary size.
transfer_scale scale_of(const mesh& from, const solution& values, const mesh& to);

// Return the mesh with places moved and divided, or the solution with values divided. Numbers that
// become too small for a double are rounded: they are 2^-700 of the largest, or less.
mesh placed(mesh m, const transfer_scale& scale);
solution divided(solution s, const transfer_scale& scale);

// Multiplies the results, values and report, back. Numbers beyond the doubles become infinite.
void multiply(transferred_solution& made, const transfer_scale& scale);

}  // namespace asterism::internal
