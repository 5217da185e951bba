// SPDX-License-Identifier: MIT
#include "asterism/mesh/io/load_domain.hpp"

#include <filesystem>
#include <string>

#include "asterism/mesh/domain/built_in_domains.hpp"
#include "asterism/mesh/io/file_ending.hpp"
#include "asterism/mesh/io/poly.hpp"
#include "asterism/mesh/io/polygons.hpp"

namespace asterism {
using namespace internal;

result<domain> load_domain(std::string_view what) {
  if (what == "square") return square();
  if (what == "airfoil" || what == "naca0012") return airfoil();
  if (has_ending(what, ".poly")) return read_poly(std::filesystem::path(what));
  if (has_ending(what, ".geojson") || has_ending(what, ".json"))
    return read_geojson(std::filesystem::path(what));
  if (has_ending(what, ".wkt")) return read_wkt(std::filesystem::path(what));
  return error{
      "unknown domain '" + std::string(what) +
          "': square, airfoil, or a file whose name ends in .poly, .geojson, .json, .wkt, .mesh or "
          ".msh",
      error_code::bad_option};
}

}  // namespace asterism
