// SPDX-License-Identifier: MIT
//
// Replaces mesh/io/vtu_mesh.cpp and vtu_solution.cpp: refuses files of VTK's XML, which need zlib.
#include "asterism/mesh/io/vtu_mesh.hpp"
#include "asterism/mesh/io/vtu_solution.hpp"

namespace asterism::internal {
namespace {

error not_read(const std::string& file) {
  return {file + ": files of VTK are not part of this module", error_code::malformed_file};
}

}  // namespace

result<listed_mesh> read_vtu_mesh(std::string_view, const std::string& file) {
  return not_read(file);
}

result<solution> read_vtu_solution(std::string_view, const std::string& file, const mesh&,
                                   const std::vector<vertex_index>&) {
  return not_read(file);
}

}  // namespace asterism::internal
