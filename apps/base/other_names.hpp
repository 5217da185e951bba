// SPDX-License-Identifier: MIT
//
// Accepts other words for the values of an option: older ones, and those of other interfaces. Help
// shows only the one name (docs/manual/names.md).
#pragma once

#include <CLI/CLI.hpp>
#include <map>
#include <string>

namespace asterism::apps {

// Returns a transformer that reads `other` as `name`, and leaves all other words unchanged.
inline CLI::Validator also(const std::string& other, const std::string& name) {
  return CLI::Transformer(std::map<std::string, std::string>{{other, name}}).description("");
}

}  // namespace asterism::apps
