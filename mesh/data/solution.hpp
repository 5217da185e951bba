// SPDX-License-Identifier: MIT
//
// Holds a solution on a mesh: fields given by their values at its vertices, linear in between.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace asterism {

// Kinds of fields, by the number of values at a vertex.
enum class field_kind { scalar = 1, vector = 2, tensor = 3 };

// Returns the number of values that a field has at a vertex: 1, 2 or 3.
constexpr std::size_t components_of(field_kind kind) { return static_cast<std::size_t>(kind); }

// A field. Vertex v has the values v * c to v * c + c - 1 of the list, with c components: of a
// vector x and y, of a symmetric tensor t11, t12, t22.
struct solution_field {
  std::string name;  // as the file names it; in formats without names the number, from 1
  field_kind kind = field_kind::scalar;
  std::vector<double> values;
};

// A solution: fields on one mesh, all numbers finite.
struct solution {
  std::size_t vertices = 0;  // of the mesh
  std::vector<solution_field> fields;
  std::vector<std::string> notes = {};  // on what was chosen where it was read
};

// One value for each vertex: a scalar field, or one component of another field.
struct nodal_values {
  std::string name;  // of the field; for a component with .x, .y, or .xx, .xy, .yy after it
  std::vector<double> values;
};

}  // namespace asterism
