// SPDX-License-Identifier: MIT
//
// Reads what `draw` shows: meshes with their fields, or the outline of a domain.
#pragma once

#include <filesystem>
#include <string>

#include "asterism/core/result.hpp"
#include "asterism/mesh/data/mesh.hpp"
#include "asterism/mesh/data/solution.hpp"

namespace asterism::apps {

// Something to be drawn: a mesh, or a domain as a mesh without triangles.
struct drawn_thing {
  mesh content;
  solution fields = {};
  bool has_metric = false;
};

// True if the name is that of a domain: a built-in one, or a file that is no mesh.
bool is_drawn_as_domain(const std::string& name);

// Reads a mesh, in the plane metric where it has none, with its own fields, or those of
// `solution_file`, where that is not empty; or a domain, its curves divided into many chords.
// Writes the notes of the readers.
result<drawn_thing> read_drawn(const std::string& name, const std::filesystem::path& solution_file);

}  // namespace asterism::apps
