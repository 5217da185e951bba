// SPDX-License-Identifier: MIT
//
// Reads and writes the folder of a mesh in pieces.
#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "asterism/apps/base/mesh_job.hpp"
#include "asterism/apps/job/job_input.hpp"
#include "asterism/mesh/data/metric_field.hpp"
#include "asterism/mesh/io/physical_names.hpp"
#include "asterism/mesh/metric/metric_part.hpp"
#include "asterism/mesh/pieces/pieces_index.hpp"
#include "asterism/mesh/pipeline/certified_mesh.hpp"

namespace asterism::apps {

// The index of the folder of a mesh in pieces.
std::filesystem::path index_in(const std::filesystem::path& folder);

// Refuses file endings for which there is no writer of meshes.
std::optional<error> check_piece_formats(const std::vector<std::string>& endings);
// Refuses a folder with other contents, or without a parent folder.
std::optional<error> check_piece_places(const mesh_job& job);

// Writes one line about all pieces.
std::string text_of_pieces(const internal::pieces_index& index);

// A piece as its files hold it; `digest` is of the certificate's bytes.
struct stored_piece {
  mesh subject;
  certificate claim;
  std::uint64_t digest = 0;
};

class piece_files {
 public:
  piece_files(const mesh_job& job, const prepared_input& input);

  std::filesystem::path index_path() const { return index_in(folder_); }
  // Makes the folder, and removes an old index: the pieces that follow belong to another mesh.
  std::optional<error> prepare_folder() const;
  // Writes all files of a piece, together or not at all. Returns the digest of its certificate.
  result<std::uint64_t> write_piece(internal::piece_index p, const certified_mesh& made) const;
  // Returns the piece if all its files exist, belong together and were made for this job.
  std::optional<stored_piece> read_piece(internal::piece_index p,
                                         const std::string& question) const;
  std::optional<error> write_rounds(const internal::rounds_done& done) const;
  std::optional<internal::rounds_done> read_rounds(std::size_t edges, std::size_t pieces) const;
  // Write and read the part of a metric on a mesh that a piece needs.
  std::optional<error> write_metric(internal::piece_index p,
                                    const internal::metric_part& part) const;
  result<std::unique_ptr<metric_field>> read_metric(internal::piece_index p) const;
  // Writes the index, which ends the run, and removes the files that only a continued run would
  // need.
  std::optional<error> write_index(const internal::pieces_index& index) const;

 private:
  // Writes one gmsh file with all pieces, where .msh is asked for.
  std::optional<error> write_partitioned(const internal::pieces_index& index) const;
  std::filesystem::path file_of(internal::piece_index p, const std::string& ending) const;

  std::filesystem::path folder_;
  std::size_t pieces_;
  std::vector<std::string> endings_;  // of the meshes, ".mesh" first
  physical_names names_;
  picture_options picture_;
};

}  // namespace asterism::apps
