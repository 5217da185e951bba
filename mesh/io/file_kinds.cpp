// SPDX-License-Identifier: MIT
#include "asterism/mesh/io/file_kinds.hpp"

#include <algorithm>
#include <array>
#include <vector>

#include "asterism/mesh/io/file_ending.hpp"
#include "asterism/mesh/io/geojson.hpp"
#include "asterism/mesh/io/gmsh.hpp"
#include "asterism/mesh/io/listed_readers.hpp"
#include "asterism/mesh/io/poly.hpp"
#include "asterism/mesh/io/text_scanner.hpp"
#include "asterism/mesh/io/vtu_mesh.hpp"
#include "asterism/mesh/io/wkt.hpp"

namespace asterism::internal {
namespace fs = std::filesystem;
namespace {

template <result<listed_mesh> (*parse)(std::string_view text, const std::string& file)>
result<listed_mesh> read_parsed(const fs::path& path, const medit_read_options& /*of a .sol*/) {
  const auto text = read_text_file(path);
  if (!text) return text.failure();
  return parse(text.value(), path.string());
}

result<listed_mesh> read_gmsh_file(const fs::path& path, const medit_read_options& /*of a .sol*/) {
  return read_gmsh(path);
}

constexpr kept_parts in_medit = {
    .regions = true, .inner_segments = true, .metric = true, .fields = true};
constexpr kept_parts in_gmsh = {true, true, true, true, true, true, true};
constexpr kept_parts in_vtu = {
    .regions = true, .inner_segments = true, .metric = true, .fields = true, .second_order = true};
constexpr kept_parts in_flow_solvers = {.names_of_markers = true};
constexpr kept_parts in_sms = {.regions = true, .inner_segments = true};
constexpr kept_parts in_node = {.regions = true, .inner_segments = true, .metric = true};

constexpr std::array<file_kind, 20> kinds_of_files = {{
    {".mesh", "Medit's text, with the metric in a .sol", read_listed_medit, "", nullptr,
     mesh_format::medit, in_medit},
    {".meshb", "Medit's binary, with the metric in a .solb", read_listed_medit, "", nullptr,
     mesh_format::medit_binary, in_medit},
    {".msh", "gmsh's 4.1; read are 1, 2 and 4.0 too, and FreeFEM's and BAMG's .msh", read_gmsh_file,
     "node data", nullptr, mesh_format::gmsh, in_gmsh},
    {".msh2", "gmsh's 2.2", read_gmsh_file, "node data", nullptr, mesh_format::gmsh2, in_gmsh},
    {".vtu", "VTK's unstructured grid, for ParaView", read_parsed<read_vtu_mesh>, "point data",
     nullptr, mesh_format::vtu, in_vtu},
    {".vtk", "VTK's older files: unstructured grids and polygons", read_parsed<read_vtk>},
    {".su2", "SU2: triangles and boundary markers", read_parsed<read_su2>, "", nullptr,
     mesh_format::su2, in_flow_solvers},
    {".14", "ADCIRC's grid, fort.14", read_parsed<read_adcirc>, "", nullptr, mesh_format::adcirc,
     in_flow_solvers},
    {".grd", "ADCIRC's grid", read_parsed<read_adcirc>, "", nullptr, mesh_format::adcirc,
     in_flow_solvers},
    {".2dm", "SMS", read_parsed<read_sms>, "", nullptr, mesh_format::sms, in_sms},
    {".stl", "a plane surface, text or binary", read_parsed<read_stl>},
    {".poly", "Triangle's: a domain, with its vertices there or in a .node", nullptr, "",
     read_poly},
    {".node", "Triangle's: points, a domain with --convex-hull; written with .ele and .edge",
     nullptr, "", read_nodes, mesh_format::node, in_node},
    {".geojson", "a domain of polygons, as geographers write them", nullptr, "", read_geojson},
    {".json", "a domain of polygons; of patches, a surface", nullptr, "", read_geojson},
    {".wkt", "a domain of polygons, as databases write them", nullptr, "", read_wkt},
    {".svg", "a picture", nullptr, "", nullptr, mesh_format::svg},
    {".png", "a picture", nullptr, "", nullptr, mesh_format::png},
    {".pdf", "a picture", nullptr, "", nullptr, mesh_format::pdf},
    {".html", "a page to look at and to judge by, which needs no network", nullptr, "", nullptr,
     mesh_format::html},
}};

}  // namespace

std::span<const file_kind> file_kinds() { return kinds_of_files; }

const file_kind* kind_of_file(std::string_view name) {
  const auto* const at =
      std::find_if(kinds_of_files.begin(), kinds_of_files.end(),
                   [name](const file_kind& kind) { return has_ending(name, kind.ending); });
  return at == kinds_of_files.end() ? nullptr : at;
}

const kept_parts& kept_in(mesh_format format) {
  const auto* const at =
      std::find_if(kinds_of_files.begin(), kinds_of_files.end(),
                   [format](const file_kind& kind) { return kind.format == format; });
  return at->keeps;
}

bool is_drawing(mesh_format format) {
  return format == mesh_format::svg || format == mesh_format::png || format == mesh_format::pdf ||
         format == mesh_format::html;
}

bool is_mesh_kind(const file_kind& kind) { return kind.read != nullptr; }

bool is_domain_kind(const file_kind& kind) { return kind.read_domain != nullptr; }

bool is_domain_name(std::string_view name) {
  const file_kind* const kind = kind_of_file(name);
  return name == "square" || name == "airfoil" || name == "naca0012" ||
         (kind != nullptr && is_domain_kind(*kind));
}

bool holds_fields(std::string_view name) {
  const file_kind* const kind = kind_of_file(name);
  return kind != nullptr && kind->keeps.fields && !kind->place_of_metric.empty();
}

bool is_written_kind(const file_kind& kind) { return kind.format.has_value(); }

std::string endings_of(bool (*is_meant)(const file_kind&), std::string_view last) {
  std::vector<std::string_view> meant;
  for (const file_kind& kind : kinds_of_files)
    if (is_meant(kind)) meant.push_back(kind.ending);
  std::string text;
  for (std::size_t i = 0; i < meant.size(); ++i) {
    const bool is_last = i > 0 && i + 1 == meant.size();
    if (is_last) text.append(" ").append(last).append(" ");
    if (i > 0 && !is_last) text.append(", ");
    text.append(meant[i]);
  }
  return text;
}

}  // namespace asterism::internal
