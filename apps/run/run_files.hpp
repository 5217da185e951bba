// SPDX-License-Identifier: MIT
//
// Checks and writes the files of a run that makes or judges one mesh: the mesh in several formats,
// solutions on it, its proof and its certificate.
#pragma once

#include <filesystem>
#include <optional>
#include <vector>

#include "asterism/apps/options/proof_output.hpp"
#include "asterism/core/result.hpp"
#include "asterism/mesh/audit/certificate.hpp"
#include "asterism/mesh/data/mesh.hpp"
#include "asterism/mesh/io/file_output.hpp"
#include "asterism/mesh/io/write_options.hpp"

namespace asterism::apps {

// Names the files that a run writes; an empty path is none.
struct run_files {
  std::vector<std::filesystem::path> outputs;  // of the mesh, pictures and pages
  std::vector<std::filesystem::path> solutions = {};
  std::filesystem::path proof = {}, certificate = {};
};

// Contents of the files of a run. `solutions` are files with their contents.
struct run_contents {
  const mesh& made;
  const certificate& claim;
  const write_options& how;
  const proof_output& proof;
  std::vector<internal::output_file> solutions = {};
  const mesh* proved = nullptr;  // what the proof is of, if not all that is written
};

// Returns the name of the certificate: the first output with the extension .certificate.json.
std::filesystem::path certificate_beside(const std::vector<std::filesystem::path>& outputs);

// Checks that every file that is written is a different one and none of those `read`, and can be
// written.
std::optional<error> check_files(const run_files& files,
                                 const std::vector<std::filesystem::path>& read);

// Returns the files that were written, in order.
std::vector<std::filesystem::path> written_files(const run_files& files, const proof_output& proof);

// Writes all files under temporary names before the first is renamed, the certificate last: where
// it exists, all other files do too. Each is written as soon as it is made, since all of them
// together may take more room than the mesh.
std::optional<error> write_files(const run_files& files, const run_contents& contents);

}  // namespace asterism::apps
