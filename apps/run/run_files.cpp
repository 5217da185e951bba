// SPDX-License-Identifier: MIT
#include "asterism/apps/run/run_files.hpp"

#include <new>

#include "asterism/apps/run/held_signals.hpp"
#include "asterism/apps/run/places.hpp"
#include "asterism/mesh/io/certificate_writer.hpp"
#include "asterism/mesh/io/mesh_format.hpp"
#include "asterism/mesh/io/render_mesh.hpp"

namespace asterism::apps {
using namespace internal;
namespace fs = std::filesystem;
namespace {

std::optional<error> add_mesh(const fs::path& output, const run_contents& contents,
                              pending_files& pending) {
  try {
    const auto rendered = render_mesh(output, contents.made, contents.how);
    if (!rendered) return rendered.failure();
    for (const output_file& file : rendered.value())
      if (auto failed = pending.add(file)) return failed;
  } catch (const std::bad_alloc&) {
    return error{output.string() + ": there is not enough memory to write it",
                 error_code::unwritable_file};
  }
  return std::nullopt;
}

}  // namespace

fs::path certificate_beside(const std::vector<fs::path>& outputs) {
  return fs::path(outputs.front()).replace_extension(".certificate.json");
}

std::optional<error> check_files(const run_files& files, const std::vector<fs::path>& read) {
  std::vector<fs::path> written;
  for (const fs::path& output : files.outputs) {
    const auto format = check_place_of_output(output);
    if (!format) return format.failure();
    for (const fs::path& file : files_of_output(output)) written.push_back(file);
  }
  written.insert(written.end(), files.solutions.begin(), files.solutions.end());
  for (const fs::path& file : {files.proof, files.certificate})
    if (!file.empty()) written.push_back(file);
  if (auto failure = check_distinct(read, written)) return failure;
  return check_all_writable(written);
}

std::vector<fs::path> written_files(const run_files& files, const proof_output& proof) {
  std::vector<fs::path> all;
  for (const fs::path& output : files.outputs)
    for (const fs::path& file : files_of_output(output)) all.push_back(file);
  all.insert(all.end(), files.solutions.begin(), files.solutions.end());
  if (proof.proof) all.push_back(files.proof);
  if (!files.certificate.empty()) all.push_back(files.certificate);
  return all;
}

std::optional<error> write_files(const run_files& files, const run_contents& contents) {
  const held_signals held;
  pending_files pending;
  for (const fs::path& output : files.outputs)
    if (auto failed = add_mesh(output, contents, pending)) return failed;
  for (const output_file& file : contents.solutions)
    if (auto failed = pending.add(file)) return failed;
  const mesh& proved = contents.proved != nullptr ? *contents.proved : contents.made;
  if (contents.proof.proof)
    if (auto failed = pending.add(proof_file(files.proof, proved, *contents.proof.proof)))
      return failed;
  if (!files.certificate.empty())
    if (auto failed = pending.add(certificate_file(files.certificate, contents.claim)))
      return failed;
  const auto written = pending.put_in_place();
  if (!written) return written.failure();
  return std::nullopt;
}

}  // namespace asterism::apps
