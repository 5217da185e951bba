// SPDX-License-Identifier: MIT
//
// The programs that share one run in pieces out among them: one alone, or the ranks of MPI.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace asterism::apps {

// One member's view of a team. This one is a team of one; a team of several derives from it.
class piece_team {
 public:
  piece_team() = default;
  piece_team(const piece_team&) = delete;
  piece_team& operator=(const piece_team&) = delete;
  virtual ~piece_team() = default;

  // Returns this member's number, from 0.
  virtual std::size_t rank() const { return 0; }
  virtual std::size_t size() const { return 1; }
  // Gives what each member brings, in the order of their numbers, to all of them. All must call it
  // equally often.
  virtual std::vector<std::string> gather(const std::string& mine) { return {mine}; }

  bool is_first() const { return rank() == 0; }
};

}  // namespace asterism::apps
