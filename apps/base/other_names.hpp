// SPDX-License-Identifier: MIT
//
// Takes other words for the values of an option: older ones, and those of other interfaces. Help
// shows the one name alone (docs/manual/names.md).
#pragma once

#include <CLI/CLI.hpp>
#include <map>
#include <string>

namespace asterism::apps {

// Returns what reads `other` as `name`. Words that are neither pass as they are.
inline CLI::Validator also(const std::string& other, const std::string& name) {
  return CLI::Transformer(std::map<std::string, std::string>{{other, name}}).description("");
}

}  // namespace asterism::apps
