// SPDX-License-Identifier: MIT
#include "asterism/mesh/io/load_domain.hpp"

#include <filesystem>
#include <string>
#include <utility>

#include "asterism/core/similar_name.hpp"
#include "asterism/mesh/domain/built_in_domains.hpp"
#include "asterism/mesh/io/edges_domain.hpp"
#include "asterism/mesh/io/file_kinds.hpp"
#include "asterism/mesh/io/other_kind.hpp"
#include "asterism/mesh/io/read_mesh.hpp"
#include "asterism/mesh/io/similar_file.hpp"

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

// Returns a clause about a built-in domain with a similar name, or a file that a domain can be read
// of; empty if there is none.
std::string similar_domain(std::string_view what) {
  const std::string built_in = did_you_mean(what, {"square", "airfoil"});
  if (!built_in.empty()) return built_in;
  return similar_file(std::filesystem::path(what), [](std::string_view name) {
    const file_kind* const kind = kind_of_file(name);
    return kind != nullptr && (is_domain_kind(*kind) || is_mesh_kind(*kind));
  });
}

}  // namespace

result<domain> load_domain(std::string_view what) {
  if (what == "square") return square();
  if (what == "airfoil" || what == "naca0012") return airfoil();
  const file_kind* const kind = kind_of_file(what);
  if (kind != nullptr && kind->read_domain != nullptr)
    return kind->read_domain(std::filesystem::path(what));
  if (kind != nullptr && kind->read != nullptr) return load_edges(std::string(what));
  const std::string known = what_it_is(what), meant = known.empty() ? similar_domain(what) : "";
  if (!meant.empty())
    return error{"unknown domain '" + std::string(what) + "'" + meant, error_code::bad_option};
  return error{"unknown domain '" + std::string(what) +
                   "': square, airfoil, or a file whose name ends in " +
                   endings_of(is_domain_kind, "or") + ", or as those of meshes do, " +
                   endings_of(is_mesh_kind, "or") + known,
               error_code::bad_option};
}

}  // namespace asterism
