// SPDX-License-Identifier: MIT
//
// Holds the result of a piece in one round, as the members of a team exchange it.
#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "asterism/mesh/pieces/pieces_index.hpp"
#include "asterism/mesh/pieces/seam_points.hpp"

namespace asterism::apps {

struct piece_report {
  internal::piece_index piece = 0;
  internal::piece_entry entry;
  std::vector<internal::seam_in_mesh> asked;
  std::vector<std::pair<std::size_t, std::uint64_t>> digests;  // of seams: edge, digest
  // Reason why the piece has no mesh; empty where it has one.
  std::string failure;
};

// Returns the reports as one text, in which numbers are exact.
std::string text_of(const std::vector<piece_report>& reports);
// Reads what text_of wrote.
std::vector<piece_report> reports_of(const std::string& text);

}  // namespace asterism::apps
