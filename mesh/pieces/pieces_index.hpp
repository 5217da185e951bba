// SPDX-License-Identifier: MIT
//
// States the whole that the pieces of a mesh belong to, in a file beside them.
//
// The file is JSON, UTF-8, with the same bytes for the same request, whatever the number of threads
// and runs that shared the work. Pieces, vertices and edges are counted from 1 there, and 0 is
// none. It ends with a digest of itself, which distinguishes files and does not protect against
// forgery; verify_pieces.hpp states what is proved.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "asterism/core/result.hpp"
#include "asterism/mesh/audit/certificate.hpp"
#include "asterism/mesh/data/domain.hpp"
#include "asterism/mesh/pieces/domain_cut.hpp"
#include "asterism/mesh/pieces/piece_shape.hpp"

namespace asterism::internal {

// Entry of the index for one piece.
struct piece_entry {
  std::string mesh, certificate;  // files, beside the index
  std::uint64_t fingerprint = 0;  // of the mesh (audit/certificate.hpp)
  std::uint64_t digest = 0;       // of the certificate's bytes
  std::size_t sites = 0, triangles = 0;
  double worst_angle = 180;  // degrees, 180 where there is none to judge
  bool certified = false;    // and complete
  std::string reason;        // how its run ended
};

// Digest of each seam in the pieces on both sides, over positions and tensors of all its
// vertices.
using seam_digests = std::vector<std::uint64_t>;  // by edge of the cut; 0 but on seams

// An index in memory.
struct pieces_index {
  std::string version;
  std::string metric;                          // as --metric takes it
  std::map<std::string, std::string> options;  // the question, as certificates word it
  double angle_bound = 0;                      // degrees
  bool certified = false;                      // all pieces are
  std::size_t rounds = 0;                      // until no piece asked for more on its seams
  std::size_t made = 0;                        // pieces made in all rounds
  std::size_t sites = 0, triangles = 0;        // of the whole, those on seams counted once
  domain original;
  domain_cut cut;
  seam_points points;
  seam_digests digests;
  std::vector<piece_entry> pieces;
};

// Returns a 64-bit FNV-1a hash of the bytes.
std::uint64_t digest_of(const std::string& bytes);

std::string index_text(const pieces_index& index);
// Reads the text of a file. `name` is the file's, for messages. Refuses a text with parts that are
// not read.
result<pieces_index> parse_index(const std::string& text, const std::string& name);
result<pieces_index> read_index(const std::filesystem::path& path);

// Returns the base name of a piece's files, with the digits that the number of pieces needs:
// "piece_03" for up to 99.
std::string name_of_piece(piece_index piece, std::size_t pieces, const std::string& ending);

// State of an unfinished run: the next round, the pieces it makes, and the present
// seams.
struct rounds_done {
  std::string question;  // digest of what the whole run was asked
  std::size_t rounds = 0, made = 0;
  std::vector<piece_index> next;
  seam_points points;
};

std::string rounds_text(const rounds_done& done);
// Returns the state; nothing for a text that does not belong to a run with this cut.
std::optional<rounds_done> parse_rounds(const std::string& text, std::size_t edges,
                                        std::size_t pieces);

}  // namespace asterism::internal
