// SPDX-License-Identifier: MIT
#include "asterism/mesh/io/write_mesh.hpp"

#include "asterism/mesh/io/file_output.hpp"
#include "asterism/mesh/io/render_mesh.hpp"

namespace asterism {

result<mesh_format> check_output(const std::filesystem::path& path) {
  auto format = internal::check_place_of_output(path);
  if (!format.ok()) return format;
  if (const auto failed = internal::check_all_writable(files_of_output(path))) return *failed;
  return format;
}

result<std::vector<std::filesystem::path>> write_mesh(const std::filesystem::path& path,
                                                      const mesh& m, const write_options& options) {
  const auto files = internal::render_mesh(path, m, options);
  if (!files.ok()) return files.failure();
  return internal::write_files(files.value());
}

}  // namespace asterism
