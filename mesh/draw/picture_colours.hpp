// SPDX-License-Identifier: MIT
//
// Chooses the colours of a picture's triangles and boundary edges, and the entries of its legend.
// The colours are those of pages (mesh/draw/page/colours.js, fields.js).
#pragma once

#include <vector>

#include "asterism/core/result.hpp"
#include "asterism/mesh/data/mesh.hpp"
#include "asterism/mesh/draw/canvas.hpp"
#include "asterism/mesh/draw/picture_legend.hpp"
#include "asterism/mesh/draw/picture_options.hpp"

namespace asterism::internal {

struct picture_colouring {
  std::vector<colour> triangles;  // one for each of mesh::triangles; empty: they are not filled
  std::vector<colour> boundary;   // one for each boundary edge; empty: all are ink
  picture_legend legend;
};

// Returns the most informative measure of a mesh with triangles, with which pages begin: aspects;
// sizes if nine of ten aspects are below 4; angles if sizes hardly differ either.
picture_by most_telling(const mesh& m);

// Fails for a field that has not one number for each site, for colours of triangles in a mesh
// without triangles, and for colours of markers in one without boundary.
result<picture_colouring> colours_of(const mesh& m, const picture_options& options);

}  // namespace asterism::internal
