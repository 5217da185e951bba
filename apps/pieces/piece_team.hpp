// SPDX-License-Identifier: MIT
//
// Defines the team of programs that share a run in pieces: one program alone, or the ranks of MPI.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace asterism::apps {

// Interface of one member to its team. This base class is a team of one; a team of several derives
// from it.
class piece_team {
 public:
  piece_team() = default;
  piece_team(const piece_team&) = delete;
  piece_team& operator=(const piece_team&) = delete;
  virtual ~piece_team() = default;

  // Returns this member's number, from 0.
  virtual std::size_t rank() const { return 0; }
  virtual std::size_t size() const { return 1; }
  // Gives the texts of all members, in the order of their numbers, to each of them. All members
  // must call it equally often.
  virtual std::vector<std::string> gather(const std::string& mine) { return {mine}; }

  bool is_first() const { return rank() == 0; }
};

}  // namespace asterism::apps
