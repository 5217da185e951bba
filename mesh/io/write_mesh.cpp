// SPDX-License-Identifier: MIT
#include "asterism/mesh/io/write_mesh.hpp"

#include "asterism/mesh/io/file_output.hpp"
#include "asterism/mesh/io/render_mesh.hpp"

namespace asterism {

result<std::vector<std::filesystem::path>> write_mesh(const std::filesystem::path& path,
                                                      const mesh& m, const write_options& options) {
  const auto files = internal::render_mesh(path, m, options);
  if (!files.ok()) return files.failure();
  return internal::write_files(files.value());
}

}  // namespace asterism
