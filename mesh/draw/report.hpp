// SPDX-License-Identifier: MIT
//
// Makes a page that shows a mesh and its measures: one HTML file that works offline.
//
// The page holds the mesh itself, every coordinate and tensor the double it is, and the certificate
// where there is one. A browser draws it on the graphics card, measures it again, and shows the
// wanted beside the delivered values, histograms, conspicuous places, and the nine angles of any
// triangle. The page loads no other file, and proves nothing: the line at its end names the command
// that does.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "asterism/core/export.h"
#include "asterism/core/result.hpp"
#include "asterism/core/site.hpp"
#include "asterism/mesh/audit/certificate.hpp"
#include "asterism/mesh/data/mesh.hpp"
#include "asterism/mesh/data/solution.hpp"

namespace asterism {

// A mesh that a page shows before its own: as it was before a repair or an adaptation, or in an
// earlier round of a loop. A domain without triangles is one, too (mesh/draw/outline.hpp).
struct report_frame {
  std::string label;  // a word or two, for a button
  mesh content = {};
  solution fields = {};  // on it
  // Triangles that are not in the stars of all their vertices, if stars were compared.
  std::vector<vertex_index> not_of_stars = {};
};

// Facts that a page shows beside the mesh.
struct report_facts {
  std::string title = {};  // default: "Mesh"
  // The certificate; without one the page says that the mesh is not judged.
  std::optional<certificate> claim = {};
  // Sentence on the source of the claim; empty by default.
  std::string claim_from = {};
  // Command that repeats the judgement; empty by default.
  std::string repeat = {};
  // Tensors wanted at the sites, one for each; by default none, and no distances are shown.
  std::vector<metric_tensor> wanted = {};
  // Triangles that are not in the stars of all their vertices, if stars were compared.
  std::vector<vertex_index> not_of_stars = {};
  solution fields = {};                   // on the mesh, to colour by; default: none
  std::string label = {};                 // of the mesh among those before it; default: "After"
  std::vector<report_frame> before = {};  // shown by buttons or a slider, in this order
};

// Returns the bytes of the file, which depend on the arguments and on the version of zlib. Every
// index of the meshes must be in range. Fails for a mesh without sites, for positions and tensors
// that are not finite, for tensors wanted or fields whose number is not that of the sites, and when
// zlib does.
ASTERISM_EXPORT result<std::string> report_page(const mesh& m, const report_facts& facts);

}  // namespace asterism
