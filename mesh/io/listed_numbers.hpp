// SPDX-License-Identifier: MIT
//
// Finds vertices by their numbers in a file, for formats with arbitrary numbers.
#pragma once

#include <limits>
#include <string>
#include <string_view>
#include <unordered_map>

#include "asterism/core/number_text.hpp"
#include "asterism/mesh/io/listed_mesh.hpp"
#include "asterism/mesh/io/text_scanner.hpp"

namespace asterism::internal {

class listed_numbers {
 public:
  // Adds the next vertex by its number in the file.
  std::optional<error> add(const text_scanner& source, const word& w) {
    const auto number = to_integer(source, w, "number of a node");
    if (!number) return number.failure();
    if (vertices_.size() > std::numeric_limits<vertex_index>::max() / 4)
      return source.failure(w.line, "more nodes than 32-bit numbers can name");
    const auto v = static_cast<vertex_index>(vertices_.size());
    if (vertices_.emplace(number.value(), v).second) return {};
    return source.failure(w.line, "node " + quoted_token(w.text) + " is there twice");
  }

  result<vertex_index> find(const text_scanner& source, const word& w,
                            std::string_view meaning) const {
    const auto number = to_integer(source, w, meaning);
    if (!number) return number.failure();
    const auto found = vertices_.find(number.value());
    if (found != vertices_.end()) return found->second;
    return source.failure(
        w.line, std::string(meaning) + ": node " + quoted_token(w.text) + " does not exist");
  }

 private:
  std::unordered_map<long long, vertex_index> vertices_;
};

}  // namespace asterism::internal
