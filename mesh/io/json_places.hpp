// SPDX-License-Identifier: MIT
//
// Finds where the values of a JSON text are, for messages that name a line.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace asterism::internal {

struct json_place {
  std::string name;  // "audit.worst_angle"; elements of a list have the list's
  std::size_t line = 0;
};

// Finds the lines of the members of objects in a text. Refers to the text, which must outlive it,
// so that its memory is proportional to the number of members, however long their names.
class json_places {
 public:
  // Returns the line of the first member with this name, or else of the first whose name ends in
  // it after a dot; 0 if there is none. Lines count from 1.
  std::size_t line_of(std::string_view name) const;

  std::optional<json_place> repeated;        // the first name that an object has twice
  std::optional<json_place> beyond_doubles;  // the first number that overflows
  std::optional<json_place> too_deep;        // where lists and objects are nested without end

 private:
  friend class place_finder;
  static constexpr std::size_t root = static_cast<std::size_t>(-1);
  struct member {
    std::size_t parent = root;  // the member whose value it is in
    std::string_view key;       // escapes stay as they are written
    std::size_t line = 0;       // of the value
  };

  std::string name_of(std::size_t m) const;
  bool is_named(std::size_t m, std::string_view name, bool whole) const;

  std::vector<member> members_;  // in the order of the text
};

// Reads as far as the text is JSON. Another reader reports errors.
json_places find_json_places(std::string_view text);

// Returns the line where lists and objects are more than `most` deep in each other, if they are.
// Programs that follow them by calls within calls would run out of stack.
std::optional<std::size_t> line_nested_beyond(std::string_view text, std::size_t most);

// Returns the line of a byte, counted from 1; `byte` may be beyond the end.
std::size_t line_of_byte(std::string_view text, std::size_t byte);

}  // namespace asterism::internal
