// SPDX-License-Identifier: MIT
#include "asterism/mesh/io/file_output.hpp"

#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <memory>
#include <optional>
#include <system_error>

namespace asterism::internal {

namespace {

namespace fs = std::filesystem;

error system_failure(const fs::path& path, const std::string& what) {
  return {path.string() + ": " + what + ": " + std::generic_category().message(errno),
          error_code::unwritable_file};
}

struct closer {
  void operator()(std::FILE* file) const { std::fclose(file); }
};

// Notes the path in `created` once the file is there, which it must not be before.
std::optional<error> write_bytes(const fs::path& path, const std::string& bytes,
                                 std::vector<fs::path>& created) {
  errno = 0;
  std::unique_ptr<std::FILE, closer> file(std::fopen(path.c_str(), "wbx"));
  if (!file) return system_failure(path, "cannot be created");
  created.push_back(path);
  // A full disk may show only when the buffer is flushed or the file is closed.
  const bool written = std::fwrite(bytes.data(), 1, bytes.size(), file.get()) == bytes.size() &&
                       std::fflush(file.get()) == 0;
  if (!written) return system_failure(path, "cannot be written");
  if (std::fclose(file.release()) != 0) return system_failure(path, "cannot be written");
  return {};
}

// A name beside `path` that nothing has; it is not ours to replace what is there.
fs::path temporary_path(const fs::path& path, const std::string& ending) {
  std::error_code status;
  fs::path part = path;
  part += ending;
  constexpr int most = 1000;
  for (int i = 2; i <= most && fs::symlink_status(part, status).type() != fs::file_type::not_found;
       ++i) {
    part = path;
    part += ending + std::to_string(i);
  }
  return part;
}

// Removes the temporary files that have not been renamed.
class temporary_files {
 public:
  ~temporary_files() {
    std::error_code ignored;
    for (const fs::path& path : paths) fs::remove(path, ignored);
  }
  std::vector<fs::path> paths;
};

// Renames temporary files to their places, or none.
class replacement {
 public:
  explicit replacement(std::vector<fs::path> temporary) : temporary_(std::move(temporary)) {}

  std::optional<error> run(const std::vector<output_file>& files) {
    for (std::size_t i = 0; i < files.size(); ++i) {
      std::error_code status;
      keep_old(files[i].path, status);
      if (!status) fs::rename(temporary_[i], files[i].path, status);
      if (!status) continue;
      put_back(files, i);
      return error{files[i].path.string() + ": " + status.message(), error_code::unwritable_file};
    }
    std::error_code ignored;
    for (const std::optional<fs::path>& old : old_)
      if (old) fs::remove(*old, ignored);
    return std::nullopt;
  }

 private:
  // A second name, or where there are no such links another one.
  void keep_old(const fs::path& path, std::error_code& status) {
    old_.emplace_back();
    std::error_code linked;
    if (!fs::exists(fs::symlink_status(path, linked))) return;
    old_.back() = temporary_path(path, ".old");
    fs::create_hard_link(path, *old_.back(), linked);
    if (linked) fs::rename(path, *old_.back(), status);
    if (status) old_.back().reset();
  }

  void put_back(const std::vector<output_file>& files, std::size_t failed) {
    std::error_code ignored;
    for (std::size_t i = 0; i < old_.size(); ++i)
      if (old_[i]) {
        // Renaming one name of a file to another of its names does nothing.
        fs::rename(*old_[i], files[i].path, ignored);
        fs::remove(*old_[i], ignored);
      } else if (i < failed) {
        fs::remove(files[i].path, ignored);
      }
  }

  std::vector<fs::path> temporary_;
  std::vector<std::optional<fs::path>> old_;
};

}  // namespace

result<std::vector<fs::path>> write_files(const std::vector<output_file>& files) {
  temporary_files temporary;
  for (const output_file& file : files) {
    const fs::path part = temporary_path(file.path, ".part");
    if (auto failed = write_bytes(part, file.bytes, temporary.paths)) return std::move(*failed);
  }
  if (auto failed = replacement(temporary.paths).run(files)) return std::move(*failed);
  std::vector<fs::path> written;
  for (const output_file& file : files) written.push_back(file.path);
  return written;
}

result<fs::path> check_writable(const fs::path& path) {
  std::error_code status;
  if (path.filename().empty())
    return error{path.string() + ": is not the name of a file", error_code::unwritable_file};
  const fs::path directory = path.has_parent_path() ? path.parent_path() : fs::path(".");
  if (!fs::is_directory(directory, status))
    return error{path.string() + ": there is no directory " + directory.string(),
                 error_code::unwritable_file};
  errno = 0;
  if (::access(directory.c_str(), W_OK | X_OK) != 0)
    return system_failure(path, "the directory " + directory.string() + " cannot be written to");
  if (fs::exists(path, status) && !fs::is_regular_file(path, status))
    return error{path.string() + ": exists and is not a regular file", error_code::unwritable_file};
  return path;
}

}  // namespace asterism::internal
