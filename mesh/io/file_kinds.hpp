// SPDX-License-Identifier: MIT
//
// Lists the kinds of files by the ends of their names: what each holds, who reads it, and in which
// format it is written. Help, completion, errors and the manual's tables are made from it.
#pragma once

#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "asterism/core/result.hpp"
#include "asterism/mesh/data/domain.hpp"
#include "asterism/mesh/io/format_names.hpp"
#include "asterism/mesh/io/listed_mesh.hpp"
#include "asterism/mesh/io/medit_read_options.hpp"

namespace asterism::internal {

// Tells the parts of a mesh that a format has a place for, beside vertices, triangles and markers.
// Pictures and pages show all parts, and a mesh cannot be read back from them: nobody asks for
// theirs.
struct kept_parts {
  bool regions = false, inner_segments = false;
  bool names_of_markers = false, names_of_regions = false;
  bool metric = false, fields = false;
  bool second_order = false;  // nodes on the sides of triangles
};

struct file_kind {
  std::string_view ending;  // in lower case, with its dot
  std::string_view holds;   // half a sentence
  // Reads a mesh, or edges alone; null where no mesh is read.
  result<listed_mesh> (*read)(const std::filesystem::path&, const medit_read_options&) = nullptr;
  std::string_view place_of_metric = {};  // in a file that is read; empty: it has none
  // Reads a domain that is no mesh; null where there is none.
  result<domain> (*read_domain)(const std::filesystem::path&) = nullptr;
  std::optional<mesh_format> format = {};  // empty: it is not written
  kept_parts keeps = {};
};

// Returns every kind, in the order of the manual.
std::span<const file_kind> file_kinds();

// Returns the kind that the end of the name says, in upper or lower case; null if there is none.
const file_kind* kind_of_file(std::string_view name);

// Returns what the format has a place for.
const kept_parts& kept_in(mesh_format format);

// True of pictures and pages.
bool is_drawing(mesh_format format);

// True if a mesh is read of such files.
bool is_mesh_kind(const file_kind& kind);
// True if they are read as domains and never as meshes.
bool is_domain_kind(const file_kind& kind);
// True of the name of a built-in domain, and of that of a file of such a kind.
bool is_domain_name(std::string_view name);
// True of the name of a mesh's file that holds fields at the vertices, too.
bool holds_fields(std::string_view name);
// True if a mesh is written to them.
bool is_written_kind(const file_kind& kind);

// Returns the endings of the kinds for which `is_meant` holds: ".mesh, .msh and .vtu", with `last`
// in the place of "and".
std::string endings_of(bool (*is_meant)(const file_kind&), std::string_view last);

}  // namespace asterism::internal
