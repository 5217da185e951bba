// SPDX-License-Identifier: MIT
#include "asterism/apps/usage_message.hpp"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <numeric>

namespace asterism::apps {
namespace {

// Returns how many letters must be changed, added or taken away to make one word of the other.
std::size_t distance(const std::string& a, const std::string& b) {
  std::vector<std::size_t> row(b.size() + 1);
  std::iota(row.begin(), row.end(), std::size_t{0});
  for (std::size_t i = 0; i < a.size(); ++i) {
    std::size_t before = row[0]++;  // of the row above, one to the left
    for (std::size_t j = 0; j < b.size(); ++j) {
      const std::size_t above = row[j + 1];
      row[j + 1] = std::min({above + 1, row[j] + 1, before + (a[i] == b[j] ? 0 : 1)});
      before = above;
    }
  }
  return row[b.size()];
}

// "; did you mean --size?" where a name is at most two letters off, and less than half of it.
std::string meant(const std::string& word, const std::vector<std::string>& names) {
  const auto nearest = std::min_element(
      names.begin(), names.end(),
      [&](const auto& a, const auto& b) { return distance(word, a) < distance(word, b); });
  if (nearest == names.end()) return "";
  const std::size_t off = distance(word, *nearest);
  return off <= 2 && 2 * off < word.size() ? "; did you mean " + *nearest + "?" : "";
}

std::vector<std::string> options_of(const CLI::App& app) {
  std::vector<std::string> names;
  for (const CLI::Option* option : app.get_options()) {
    for (const std::string& name : option->get_snames()) names.push_back("-" + name);
    for (const std::string& name : option->get_lnames()) names.push_back("--" + name);
  }
  return names;
}

// The first word that looks like an option and is none of them; empty if all are.
std::string unknown_option(const std::vector<std::string>& words,
                           const std::vector<std::string>& known) {
  for (std::size_t i = 1; i < words.size(); ++i) {
    const std::string name = words[i].substr(0, words[i].find('='));
    const bool looks_so = name.size() > 1 && name[0] == '-' && std::isalpha(name.back()) != 0;
    if (looks_so && std::find(known.begin(), known.end(), name) == known.end()) return name;
  }
  return "";
}

}  // namespace

std::string usage_message(const CLI::App& program, const std::vector<std::string>& words,
                          const CLI::ParseError& failure) {
  const CLI::App* app = nullptr;
  std::vector<std::string> commands;
  for (const CLI::App* one : program.get_subcommands([](const CLI::App*) { return true; })) {
    commands.push_back(one->get_name());
    if (!words.empty() && words[0] == one->get_name()) app = one;
  }
  if (app == nullptr) {
    const std::string help = "\n'asterism --help' lists the commands.";
    if (words.empty() || words[0][0] == '-') return failure.what() + help;
    return "there is no command '" + words[0] + "'" + meant(words[0], commands) + help;
  }
  const std::string help = "\n'asterism " + app->get_name() + " --help' lists the options.";
  const std::vector<std::string> known = options_of(*app);
  const std::string unknown = unknown_option(words, known);
  if (dynamic_cast<const CLI::ExtrasError*>(&failure) == nullptr || unknown.empty())
    return failure.what() + help;
  return app->get_name() + " has no option " + unknown + meant(unknown, known) + help;
}

}  // namespace asterism::apps
