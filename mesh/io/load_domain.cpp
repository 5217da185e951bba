// SPDX-License-Identifier: MIT
#include "asterism/mesh/io/load_domain.hpp"

#include <filesystem>
#include <string>
#include <utility>

#include "asterism/mesh/domain/built_in_domains.hpp"
#include "asterism/mesh/io/edges_domain.hpp"
#include "asterism/mesh/io/file_ending.hpp"
#include "asterism/mesh/io/poly.hpp"
#include "asterism/mesh/io/polygons.hpp"
#include "asterism/mesh/io/read_mesh.hpp"

namespace asterism {
using namespace internal;
namespace {

result<domain> load_edges(const std::string& name) {
  auto read = read_mesh_file(name, {.without_solution = true});
  if (!read) return read.failure();
  if (has_edges_alone(read.value())) return domain_of_edges(std::move(read).value(), name);
  return error{name + (read.value().content.triangles.empty()
                           ? ": there are no edges, and a domain is wanted"
                           : ": this is a mesh, and a domain is wanted here"),
               error_code::bad_option};
}

}  // namespace

result<domain> load_domain(std::string_view what) {
  if (what == "square") return square();
  if (what == "airfoil" || what == "naca0012") return airfoil();
  if (has_ending(what, ".poly")) return read_poly(std::filesystem::path(what));
  if (has_ending(what, ".geojson") || has_ending(what, ".json"))
    return read_geojson(std::filesystem::path(what));
  if (has_ending(what, ".wkt")) return read_wkt(std::filesystem::path(what));
  if (has_ending(what, ".node")) return read_nodes(std::filesystem::path(what));
  if (is_mesh_file(what)) return load_edges(std::string(what));
  return error{
      "unknown domain '" + std::string(what) +
          "': square, airfoil, or a file whose name ends in .poly, .node, .geojson, .json or .wkt, "
          "or as those of meshes do, .mesh, .meshb, .msh, .vtu, .vtk, .su2, .14, .grd, .2dm or "
          ".stl",
      error_code::bad_option};
}

}  // namespace asterism
