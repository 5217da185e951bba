// SPDX-License-Identifier: MIT
#include "asterism/mesh/io/file_output.hpp"

#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <cstdlib>
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

// Creates the file, which must not exist yet, and writes it. Adds its path to `created` as soon as
// it exists.
std::optional<error> write_bytes(const fs::path& path, const output_file& contents,
                                 std::vector<fs::path>& created) {
  errno = 0;
  std::unique_ptr<std::FILE, closer> file(std::fopen(path.c_str(), "wbx"));
  if (!file) return system_failure(path, "cannot be created");
  created.push_back(path);
  bool written = true;
  const byte_sink put = [&file, &written](std::string_view bytes) {
    written = written && std::fwrite(bytes.data(), 1, bytes.size(), file.get()) == bytes.size();
  };
  put(contents.bytes);
  if (contents.rest) contents.rest(put);
  // Checks the flush and the close: a full disk may show only there.
  written = written && std::fflush(file.get()) == 0;
  if (!written) return system_failure(path, "cannot be written");
  if (std::fclose(file.release()) != 0) return system_failure(path, "cannot be written");
  return {};
}

// Returns a name beside `path` that no file has, so that none is replaced.
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

// Renames all temporary files to their final names, or none of them.
class replacement {
 public:
  explicit replacement(const std::vector<fs::path>& places) : places_(places) {}

  std::optional<error> run(const std::vector<fs::path>& temporary) {
    for (std::size_t i = 0; i < places_.size(); ++i) {
      std::error_code status;
      keep_old(places_[i], status);
      if (!status) fs::rename(temporary[i], places_[i], status);
      if (!status) continue;
      put_back(i);
      return error{places_[i].string() + ": " + status.message(), error_code::unwritable_file};
    }
    std::error_code ignored;
    for (const std::optional<fs::path>& old : old_)
      if (old) fs::remove(*old, ignored);
    return std::nullopt;
  }

 private:
  // Gives the file at `path` a second name, by a link or, where there are none, by renaming it.
  // Fails for a directory, which may have been created since the place was checked.
  void keep_old(const fs::path& path, std::error_code& status) {
    old_.emplace_back();
    std::error_code linked;
    const fs::file_status there = fs::symlink_status(path, linked);
    if (!fs::exists(there)) return;
    if (fs::is_directory(there)) {
      status = std::make_error_code(std::errc::is_a_directory);
      return;
    }
    old_.back() = temporary_path(path, ".old");
    fs::create_hard_link(path, *old_.back(), linked);
    if (linked) fs::rename(path, *old_.back(), status);
    if (status) old_.back().reset();
  }

  // Undoes the renamings before number `failed`.
  void put_back(std::size_t failed) {
    std::error_code ignored;
    for (std::size_t i = 0; i < old_.size(); ++i)
      if (old_[i]) {
        // Compares the files first: renaming one name of a file to another name of it does nothing.
        fs::rename(*old_[i], places_[i], ignored);
        fs::remove(*old_[i], ignored);
      } else if (i < failed) {
        fs::remove(places_[i], ignored);
      }
  }

  const std::vector<fs::path>& places_;
  std::vector<std::optional<fs::path>> old_;
};

}  // namespace

fs::path place_of(const fs::path& path) {
  constexpr int most_links = 40;  // the limit of Linux, too
  fs::path place = path;
  for (int i = 0; i < most_links; ++i) {
    std::error_code none;
    const fs::path next = fs::read_symlink(place, none);
    if (none) return place;
    place = next.is_absolute() ? next : place.parent_path() / next;
  }
  return place;
}

std::string bytes_of(const std::function<void(const byte_sink&)>& write) {
  std::string bytes;
  write([&bytes](std::string_view piece) { bytes += piece; });
  return bytes;
}

pending_files::~pending_files() {
  std::error_code ignored;
  for (const fs::path& path : temporary_) fs::remove(path, ignored);
}

std::optional<error> pending_files::add(const output_file& file) {
  const fs::path place = place_of(file.path);
  if (auto failed = write_bytes(temporary_path(place, ".part"), file, temporary_)) return failed;
  places_.push_back(place);
  return std::nullopt;
}

result<std::vector<fs::path>> pending_files::put_in_place() {
  if (auto failed = replacement(places_).run(temporary_)) return *std::move(failed);
  temporary_.clear();
  return places_;
}

result<std::vector<fs::path>> write_files(const std::vector<output_file>& files) {
  pending_files pending;
  for (const output_file& file : files)
    if (auto failed = pending.add(file)) return *std::move(failed);
  return pending.put_in_place();
}

namespace {

fs::path folder_of(const fs::path& file) {
  return file.has_parent_path() ? file.parent_path() : fs::path(".");
}

error not_written_to(const fs::path& file) {
  return system_failure(file,
                        "the directory " + folder_of(file).string() + " cannot be written to");
}

// True if a file can be created there: a file system may forbid what the permissions of the folder
// allow.
bool takes_files(const fs::path& folder) {
  std::string name = (folder / ".asterism-XXXXXX").string();
  const int made = ::mkstemp(name.data());
  if (made < 0) return false;
  ::close(made);
  ::unlink(name.c_str());
  return true;
}

}  // namespace

std::optional<error> check_place(const fs::path& path) {
  std::error_code status;
  if (path.filename().empty())
    return error{path.string() + ": is not the name of a file", error_code::unwritable_file};
  const fs::path directory = folder_of(path);
  if (!fs::is_directory(directory, status))
    return error{path.string() + ": there is no directory " + directory.string(),
                 error_code::unwritable_file};
  errno = 0;
  if (::access(directory.c_str(), W_OK | X_OK) != 0) return not_written_to(path);
  if (fs::exists(path, status) && !fs::is_regular_file(path, status))
    return error{path.string() + ": exists and is not a regular file", error_code::unwritable_file};
  return std::nullopt;
}

result<fs::path> check_writable(const fs::path& path) {
  if (auto failed = check_all_writable({path})) return *std::move(failed);
  return path;
}

std::optional<error> check_all_writable(const std::vector<fs::path>& files) {
  std::vector<fs::path> tried;
  for (const fs::path& file : files) {
    const fs::path place = place_of(file);
    if (auto failed = check_place(place)) return failed;
    const fs::path folder = folder_of(place);
    if (std::find(tried.begin(), tried.end(), folder) != tried.end()) continue;
    errno = 0;
    if (!takes_files(folder)) return not_written_to(place);
    tried.push_back(folder);
  }
  return std::nullopt;
}

}  // namespace asterism::internal
