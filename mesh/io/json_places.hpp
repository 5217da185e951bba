// SPDX-License-Identifier: MIT
//
// Finds where the values of a JSON text are, for messages that name a line.
#pragma once

#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <string_view>

namespace asterism::internal {

struct json_place {
  std::string name;  // "audit.worst_angle"; elements of a list have the list's
  std::size_t line = 0;
};

struct json_places {
  std::map<std::string, std::size_t> lines;  // of each named value, from 1
  std::optional<json_place> repeated;        // the first name that an object has twice
  std::optional<json_place> beyond_doubles;  // the first number that overflows
  std::optional<json_place> too_deep;        // where lists and objects are nested without end
};

// Reads as far as the text is JSON. Whether it is is another reader's to say.
json_places find_json_places(std::string_view text);

// Counts from 1; `byte` may be beyond the end.
std::size_t line_of_byte(std::string_view text, std::size_t byte);

}  // namespace asterism::internal
