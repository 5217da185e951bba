// SPDX-License-Identifier: MIT
//
// Lists the kinds of files by the ends of their names: the contents of each, its readers, and its
// format. Help, completion, errors and the manual's tables are made from it.
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

// Parts of a mesh that a format has a place for, in addition to vertices, triangles and markers.
// Pictures and pages show all parts, and a mesh cannot be read back from them: their parts are
// never listed.
struct kept_parts {
  bool regions = false, inner_segments = false;
  bool names_of_markers = false, names_of_regions = false;
  bool metric = false, fields = false;
  bool second_order = false;  // nodes on the sides of triangles
};

struct file_kind {
  std::string_view ending;  // in lower case, with its dot
  std::string_view holds;   // half a sentence
  // Function that reads a mesh, or edges alone; null if no mesh is read from such files.
  result<listed_mesh> (*read)(const std::filesystem::path&, const medit_read_options&) = nullptr;
  std::string_view place_of_metric = {};  // in a file that is read; empty: it has none
  // Function that reads a domain that is no mesh; null if there is none.
  result<domain> (*read_domain)(const std::filesystem::path&) = nullptr;
  std::optional<mesh_format> format = {};  // empty: it is not written
  kept_parts keeps = {};
};

// Returns all kinds of files, in the order of the manual.
std::span<const file_kind> file_kinds();

// Returns the kind for the ending of the name, in upper or lower case; null if there is none.
const file_kind* kind_of_file(std::string_view name);

// Returns the parts of a mesh that the format has a place for.
const kept_parts& kept_in(mesh_format format);

// True for pictures and pages.
bool is_drawing(mesh_format format);

// True if meshes can be read from files of this kind.
bool is_mesh_kind(const file_kind& kind);
// True if files of this kind are read as domains, and never as meshes.
bool is_domain_kind(const file_kind& kind);
// True for the name of a built-in domain or of a file that is read as a domain alone.
bool is_domain_name(std::string_view name);
// True for the name of a mesh's file that can hold fields at the vertices as well.
bool holds_fields(std::string_view name);
// True if meshes can be written to files of this kind.
bool is_written_kind(const file_kind& kind);

// Returns the endings of the kinds for which `is_meant` is true: ".mesh, .msh and .vtu", with
// `last` in the place of "and".
std::string endings_of(bool (*is_meant)(const file_kind&), std::string_view last);

}  // namespace asterism::internal
