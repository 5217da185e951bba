// SPDX-License-Identifier: MIT
//
// Gives numbers of 32 bits to references of a file that have more.
#pragma once

#include <cstddef>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "asterism/core/result.hpp"
#include "asterism/mesh/io/physical_names.hpp"
#include "asterism/mesh/io/text_scanner.hpp"

namespace asterism::internal {

// References of one file. The number that replaces a wide one is chosen when all have been read:
// the least positive one that the file does not have.
class wide_references {
 public:
  // Returns the reference, or a place holder that settle() replaces.
  result<int> read(const text_scanner& source, const word& w, std::string_view meaning);
  int number(long long reference);
  // Returns whether the reference has no place holder.
  static bool is_plain(long long reference);
  bool empty() const { return holder_.empty(); }

  // Replaces the place holders in all lists and names. Returns a note, empty where all fit
  // into 32 bits. Requires !empty().
  std::string settle(const std::vector<std::vector<int>*>& lists, physical_names& names);

 private:
  std::map<long long, int> holder_;  // by reference
};

}  // namespace asterism::internal
