// SPDX-License-Identifier: MIT
#include "asterism/apps/help/command_tree.hpp"

#include <CLI/CLI.hpp>

#include "asterism/mesh/metric/make_metric_field.hpp"

namespace asterism::apps {
namespace {

// Removes the names of checks that the parser appends to the type: "HOW:{darts,fill,voronoi}".
std::vector<std::string> choices_in(const std::string& type) {
  std::vector<std::string> choices;
  const std::size_t open = type.find('{'), close = type.find('}');
  if (open == std::string::npos || close == std::string::npos) return choices;
  // Removes the map that the parser appends for several checks: "{a->0,b->1}".
  for (const std::string& item : CLI::detail::split(type.substr(open + 1, close - open - 1), ','))
    choices.push_back(item.substr(0, item.find("->")));
  return choices;
}

// Lists the names that a domain or a metric may have; each may be a file or formula as well.
std::vector<std::string> names_of_values(const std::string& value) {
  if (value == "DOMAIN") return {"square", "airfoil"};
  std::vector<std::string> names;
  if (value == "SPEC")
    for (const metric_name& metric : metric_names())
      if (metric.arguments.empty() || metric.arguments.front() == '[')
        names.emplace_back(metric.name);
  return names;
}

option_entry entry_of(const CLI::Option& option) {
  option_entry entry;
  for (const std::string& name : option.get_snames()) entry.names.push_back("-" + name);
  for (const std::string& name : option.get_lnames()) entry.names.push_back("--" + name);
  entry.positional = entry.names.empty();
  if (entry.positional) entry.names.push_back(option.get_name());
  entry.text = option.get_description();
  entry.required = option.get_required();
  entry.repeats = option.get_expected_max() > 1;
  if (option.get_type_size_max() == 0) return entry;
  const std::string type = option.get_type_name();
  entry.choices = choices_in(type);
  if (!entry.positional) entry.value = type.substr(0, type.find(':'));
  entry.names_of_values = names_of_values(entry.positional ? entry.names[0] : entry.value);
  return entry;
}

command_entry entry_of(const CLI::App& app) {
  command_entry entry{app.get_name(), app.get_description(), app.get_footer(), {}};
  for (const CLI::Option* option : app.get_options())  // those without a group are older spellings
    if (!option->get_group().empty()) entry.options.push_back(entry_of(*option));
  return entry;
}

}  // namespace

std::vector<command_entry> command_tree(const CLI::App& program) {
  std::vector<command_entry> tree = {entry_of(program)};
  for (const CLI::App* app : program.get_subcommands([](const CLI::App*) { return true; }))
    tree.push_back(entry_of(*app));
  return tree;
}

}  // namespace asterism::apps
