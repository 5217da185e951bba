// SPDX-License-Identifier: MIT
//
// Says, in the place of mesh/io/vtu_mesh.cpp, that this build reads no files of VTK, which zlib
// unpacks.
#include "asterism/mesh/io/vtu_mesh.hpp"

namespace asterism::internal {

result<vtu_mesh> read_vtu_mesh(std::string_view, const std::string& file) {
  return error{file + ": files of VTK are not part of this module", error_code::malformed_file};
}

}  // namespace asterism::internal
