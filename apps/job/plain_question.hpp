// SPDX-License-Identifier: MIT
//
// Converts the question of a mesh into the forms that checkers of proofs read: a domain of segments
// and points, and a metric of tensors at the vertices of the mesh.
#pragma once

#include <optional>
#include <string>

#include "asterism/apps/base/notes.hpp"
#include "asterism/core/result.hpp"
#include "asterism/mesh/data/domain.hpp"
#include "asterism/mesh/data/mesh.hpp"

namespace asterism::apps {

// Options of the repair of a domain, within a distance (mesh/domain/repair_domain.hpp) or, without
// one, the least that suffices.
struct domain_repair {
  bool is_asked = false;
  std::optional<double> distance = {};
};

// Returns the domain that `asterism mesh NAME` takes, as segments, hole points and region points:
// its vertices are the first ones of every mesh of it. Writes notes on what was put in order. Fails
// for curves, which are divided for each mesh anew.
result<domain> plain_domain(const std::string& name, const note_options& notes,
                            const domain_repair& repair = {});

// Gives the vertices of a mesh the tensors of a metric, as --metric of `asterism mesh` names it,
// divided by the square of the size. Formulas are placed in the box of the vertices.
std::optional<error> take_metric(mesh& m, const std::string& metric, double size);

}  // namespace asterism::apps
