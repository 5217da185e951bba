// SPDX-License-Identifier: MIT
//
// Writes the proof of a certified mesh where --proof asks for it.
#pragma once

#include <CLI/CLI.hpp>
#include <filesystem>
#include <optional>

#include "asterism/core/result.hpp"
#include "asterism/mesh/data/domain.hpp"
#include "asterism/mesh/data/mesh.hpp"
#include "asterism/mesh/io/file_output.hpp"
#include "asterism/mesh/proof/mesh_proof.hpp"

namespace asterism::apps {

// Adds --proof.
void add_proof_option(CLI::App& app, std::filesystem::path& proof);

// The proof that --proof asks for, or the reason why there is none.
struct proof_output {
  std::optional<internal::mesh_proof> proof;
  std::optional<error> missing;

  // Returns the status of the run, which would be `status` without a proof: a missing proof is
  // reported, and counts as a goal not reached.
  int conclude(int status) const;
};

// Finds the proof of a mesh, unless no file is named for it. A mesh that is not certified has none.
proof_output find_proof(const std::filesystem::path& path, const mesh& subject, const domain* shape,
                        bool is_certified);

// Returns the file of the proof; it refers to proof and mesh.
internal::output_file proof_file(const std::filesystem::path& path, const mesh& subject,
                                 const internal::mesh_proof& proof);

}  // namespace asterism::apps
