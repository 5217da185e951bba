// SPDX-License-Identifier: MIT
//
// Makes a page that shows a mesh in space: one HTML file that works offline.
//
// A browser draws the triangles on the graphics card, or without one on a plain canvas. The page
// loads no other file, and proves nothing: it shows the lines of text that it is given.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "asterism/core/result.hpp"
#include "asterism/mesh/data/space_mesh.hpp"

namespace asterism::internal {

struct space_page_facts {
  std::string title;
  bool certified = false;
  std::string verdict;                                     // a sentence
  std::vector<std::pair<std::string, std::string>> table;  // what was asked and proved
  std::string repeat;  // a command that proves it again; or empty
};

// Returns the bytes of the page. Fails for a mesh without triangles and when zlib does. Every index
// must be in range.
result<std::string> space_page(const space_mesh& m, const space_page_facts& facts);

}  // namespace asterism::internal
