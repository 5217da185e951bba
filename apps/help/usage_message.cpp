// SPDX-License-Identifier: MIT
#include "asterism/apps/help/usage_message.hpp"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <array>
#include <cctype>
#include <filesystem>
#include <string_view>
#include <system_error>
#include <utility>

#include "asterism/apps/help/foreign_names.hpp"
#include "asterism/core/similar_name.hpp"
#include "asterism/mesh/support/one_line.hpp"

namespace asterism::apps {
using internal::did_you_mean;
using internal::one_line;
namespace {

std::vector<std::string> options_of(const CLI::App& app) {
  std::vector<std::string> names;
  for (const CLI::Option* option : app.get_options()) {
    for (const std::string& name : option->get_snames()) names.push_back("-" + name);
    for (const std::string& name : option->get_lnames()) names.push_back("--" + name);
  }
  return names;
}

// Returns the first word that names an option which help does not show: messages about it have an
// empty name.
std::string hidden_option(const CLI::App& app, const std::vector<std::string>& words) {
  for (const std::string& word : words)
    for (const CLI::Option* option : app.get_options()) {
      const auto& names = option->get_lnames();
      const std::string name = word.substr(0, word.find('='));
      if (option->get_group().empty() && !names.empty() && name == "--" + names.front())
        return name;
    }
  return "";
}

// Returns a clause such as "; did you mean green?" for a message that ends in the list of possible
// values: "magic not in {a,b}".
std::string meant_value(const std::string& message) {
  const std::string between = " not in {";
  const std::size_t at = message.find(between);
  const std::size_t begin = message.rfind(": ", at);
  if (at == std::string::npos || begin == std::string::npos || message.back() != '}') return "";
  std::vector<std::string> values;
  std::string_view rest(message);
  rest = rest.substr(at + between.size(), rest.size() - at - between.size() - 1);
  while (!rest.empty()) {
    const std::size_t end = std::min(rest.find(','), rest.size());
    values.emplace_back(rest.substr(0, end));
    rest.remove_prefix(std::min(end + 1, rest.size()));
  }
  return did_you_mean(message.substr(begin + 2, at - begin - 2), values);
}

// Returns the parser's objection to a value, in the form of the other messages.
std::string plain_text(const CLI::App& app, const std::vector<std::string>& words,
                       const CLI::ParseError& failure) {
  std::string text = failure.what();
  if (text.compare(0, 2, ": ") == 0) text = hidden_option(app, words) + text;
  const std::string no_flag = "Could not convert: ", is = " = ";
  if (const std::size_t at = text.find(is);
      text.compare(0, no_flag.size(), no_flag) == 0 && at != std::string::npos)
    return text.substr(no_flag.size(), at - no_flag.size()) + ": stands alone, and takes no " +
           text.substr(at + is.size());
  const std::string most = ": At Most 1 required but received ";
  if (const std::size_t at = text.find(most); at != std::string::npos)
    return text.substr(0, at) + ": is given " + text.substr(at + most.size()) +
           " times, and can be given once";
  const std::string one = ": 1 required ", end = " missing";
  if (const std::size_t at = text.find(one);
      at != std::string::npos && text.size() > end.size() &&
      text.compare(text.size() - end.size(), end.size(), end) == 0)
    return text.substr(0, text.size() - end.size()).replace(at, one.size(), ": there is no ") +
           " behind it";
  return text + meant_value(text);
}

// Returns, as the end of a message, the option here that an unknown one corresponds to; empty if
// there is none known. Triangle and others write a value right behind the letter: -q30.
std::string hint_for(const std::string& word, const std::vector<std::string>& known) {
  std::string name = word.substr(std::min(word.find_first_not_of('-'), word.size()));
  if (word[1] != '-' && name.size() > 1 && std::isalpha(static_cast<unsigned char>(name[1])) == 0)
    name.resize(1);
  if (std::find(known.begin(), known.end(), "--" + name) != known.end())
    return "; did you mean --" + name + "?";
  for (const foreign_option& other : foreign_options) {  // the first that is an option here
    const bool is_ours = std::find(known.begin(), known.end(), other.ours) != known.end();
    if (other.name == name && is_ours)
      return "; " + (other.is_one ? "here it is " + std::string(other.ours) + " (" +
                                        std::string(other.what) + ")"
                                  : std::string(other.what));
  }
  return "";
}

// Returns the first word that looks like an option and is none of those known; empty if there is
// none.
std::string unknown_option(const std::vector<std::string>& words,
                           const std::vector<std::string>& known) {
  for (std::size_t i = 1; i < words.size(); ++i) {
    const std::string name = words[i].substr(0, words[i].find('='));
    const bool looks_so = name.size() > 1 && name[0] == '-' &&
                          (name[1] == '-' || std::isalpha(static_cast<unsigned char>(name[1])));
    // Recognises an option with its value in one word: -oFILE
    if (looks_so && name.size() > 2 && name[1] != '-' && name[1] != 'h' &&
        std::find(known.begin(), known.end(), name.substr(0, 2)) != known.end())
      continue;
    if (looks_so && std::find(known.begin(), known.end(), name) == known.end()) return name;
  }
  return "";
}

// True if a word with one dash begins with a short option and is the name of another one: -hmax,
// which would be read as -h max, and -output, as -o utput. No word but -help begins with -h.
bool is_misread(const std::string& word, const std::vector<std::string>& known) {
  if (word.size() < 3 || word[0] != '-' || word[1] == '-' || word == "-help") return false;
  if (word[1] == 'h') return true;
  const bool begins_short = std::find(known.begin(), known.end(), word.substr(0, 2)) != known.end();
  const std::string name = word.substr(1, word.find('=') - 1);
  const auto is_known = [&known](const std::string& option) {
    return std::find(known.begin(), known.end(), option) != known.end();
  };
  return begins_short &&
         (is_known("--" + name) ||
          std::any_of(foreign_options.begin(), foreign_options.end(), [&](const auto& other) {
            return other.name == name && is_known(std::string(other.ours));
          }));
}

// Returns the shortest usage, with required arguments alone: "usage: asterism check MESH PROOF
// --angle-bound B --metric SOL".
std::string shortest_use(const CLI::App& app) {
  std::string arguments, options;
  for (const CLI::Option* option : app.get_options()) {
    if (option->get_positional())
      arguments += " " + (option->get_required() ? option->get_name(true)
                                                 : "[" + option->get_name(true) + "]");
    else if (option->get_required() && !option->get_snames().empty())
      options += " -" + option->get_snames().front() + " " + option->get_type_name();
    else if (option->get_required())
      options += " --" + option->get_lnames().front() + " " + option->get_type_name();
  }
  return "usage: asterism " + app.get_name() + arguments + options + " ...";
}

// Returns a clause such as "; --repair-domain stands alone" if a value that was not expected
// follows a flag.
std::string flag_with_value(const CLI::App& app, const std::vector<std::string>& words,
                            const CLI::ParseError& failure) {
  if (dynamic_cast<const CLI::ExtrasError*>(&failure) == nullptr) return "";
  const std::string text = std::string(failure.what()) + " ";
  for (std::size_t i = 0; i + 1 < words.size(); ++i) {
    const CLI::Option* const option = app.get_option_no_throw(words[i]);
    const bool is_flag = option != nullptr && words[i][0] == '-' && option->get_expected_max() == 0;
    if (is_flag && text.find(" " + words[i + 1] + " ") != std::string::npos)
      return "; " + words[i] + " stands alone";
  }
  return "";
}

// Returns the end of a message about two values behind an option that may be repeated and takes one
// value each time: that the option must be repeated for the second. Empty in all other cases.
std::string once_for_each(const CLI::App& app, const std::vector<std::string>& words,
                          const CLI::ParseError& failure) {
  if (dynamic_cast<const CLI::ExtrasError*>(&failure) == nullptr) return "";
  const std::string text = std::string(failure.what()) + " ";
  for (std::size_t i = 0; i + 2 < words.size(); ++i) {
    const CLI::Option* const option = app.get_option_no_throw(words[i]);
    const bool repeats = option != nullptr && words[i][0] == '-' && option->get_expected_max() > 1;
    if (repeats && text.find(" " + words[i + 2] + " ") != std::string::npos)
      return "; " + words[i] + " takes one each time: " + words[i] + " " + words[i + 1] + " " +
             words[i] + " " + words[i + 2];
  }
  return "";
}

std::string listed(const std::vector<std::string>& words) {
  std::string text;
  for (std::size_t i = 0; i < words.size(); ++i)
    text += (i == 0 ? "" : i + 1 < words.size() ? ", " : " and ") + one_line(words[i]);
  return text;
}

// Returns a message about the first word for which a command has no place: what the command takes,
// and what it took for that. Empty if all words have a place.
std::string one_too_many(const CLI::App& app) {
  const std::vector<std::string> left = app.remaining();
  if (left.empty()) return "";
  std::vector<std::string> names, taken;
  for (const CLI::Option* option : app.get_options()) {
    if (!option->get_positional() || option->results().empty()) continue;
    names.push_back(option->get_name(true));
    taken.push_back(option->results().front());
  }
  std::string text = "there is no place for " + one_line(left.front()) + ": " + app.get_name();
  text += names.empty() ? " takes no such argument"
                        : " takes " + listed(names) + " alone, and has " + listed(taken) + " for " +
                              (names.size() == 1 ? "it" : "them");
  const bool is_file = !std::filesystem::path(left.front()).extension().empty();
  const CLI::Option* const output = app.get_option_no_throw("-o");
  if (is_file && output != nullptr && output->results().empty())
    text += "; a file to write follows -o";
  return text;
}

// Returns the first option that was given another option for its value; empty if there is none.
std::string without_value(const CLI::App& app, const std::vector<std::string>& words) {
  for (std::size_t i = 1; i + 1 < words.size(); ++i) {
    if (words[i].size() < 2 || words[i][0] != '-' || words[i + 1].size() < 2 ||
        words[i + 1][0] != '-')
      continue;
    const CLI::Option* const option = app.get_option_no_throw(words[i]);
    const bool takes_value = option != nullptr && option->get_type_size_max() > 0;
    if (takes_value && app.get_option_no_throw(words[i + 1]) != nullptr)
      return words[i] + ": there is no " + option->get_type_name() + " behind it, but the option " +
             words[i + 1];
  }
  return "";
}

// Returns the end of a message about an unknown option whose word is the name of a positional
// argument: "--MESH".
std::string is_positional(const CLI::App& app, const std::string& word) {
  std::string name = word.substr(std::min(word.find_first_not_of('-'), word.size()));
  for (char& c : name) c = static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
  for (const CLI::Option* option : app.get_options())
    if (option->get_positional() && option->get_name(true) == name)
      return "; " + name + " is named without an option";
  return "";
}

std::string no_such_option(const CLI::App& app, const std::string& word) {
  const std::vector<std::string> known = options_of(app);
  std::string hint = hint_for(word, known);
  if (hint.empty()) hint = is_positional(app, word);
  const std::string instead = hint.empty() ? did_you_mean(word, known) : hint;
  return app.get_name() + " has no option " + one_line(word) + instead +
         (instead.empty() ? "\n" + shortest_use(app) + "; '" : "\n'") + "asterism " +
         app.get_name() + " --help' lists the options.";
}

// Returns a message about an option that is named before any command.
std::string before_command(const CLI::App& program, const std::vector<std::string>& words) {
  const std::string text =
      one_line(words[0]) + ": the command comes first, and its options behind it";
  for (const CLI::App* one : program.get_subcommands([](const CLI::App*) { return true; }))
    if (std::find(words.begin(), words.end(), one->get_name()) != words.end())
      return text + ": asterism " + one->get_name() + " ... " + one_line(words[0]);
  return text;
}

}  // namespace

std::string usage_message(const CLI::App& program, const std::vector<std::string>& words,
                          const CLI::ParseError& failure) {
  const CLI::App* app = nullptr;
  for (const CLI::App* one : program.get_subcommands([](const CLI::App*) { return true; }))
    if (!words.empty() && words[0] == one->get_name()) app = one;
  if (app == nullptr) {
    const std::string help = "\n'asterism --help' lists the commands.";
    if (words.empty()) return one_line(failure.what()) + help;
    if (words[0][0] == '-') return before_command(program, words) + help;
    return no_such_command(program, words[0]);
  }
  const std::string help = "\n'asterism " + app->get_name() + " --help' lists the options.";
  const std::vector<std::string> known = options_of(*app);
  const std::string unknown = unknown_option(words, known);
  // Looks for a required argument that may have been given under a wrong name.
  const bool may_be_name = dynamic_cast<const CLI::ExtrasError*>(&failure) != nullptr ||
                           dynamic_cast<const CLI::RequiredError*>(&failure) != nullptr;
  if (!may_be_name) return one_line(plain_text(*app, words, failure)) + help;
  const std::string begun = unknown.empty() ? without_value(*app, words) : "";
  if (!begun.empty()) return begun + help;
  const std::string many = unknown.empty() ? one_too_many(*app) : "";
  if (unknown.empty())
    return one_line((many.empty() ? failure.what() : many) + flag_with_value(*app, words, failure) +
                    once_for_each(*app, words, failure)) +
           "\n" + shortest_use(*app) + "; " + help.substr(1);
  return no_such_option(*app, unknown);
}

// Suggests a command line for a first word that is no command: a domain, a file, or a command of
// another program.
std::string meant_instead(const std::string& word) {
  for (const auto& [theirs, ours] : foreign_commands)
    if (theirs == word) return "; here it is " + std::string(ours);
  std::error_code ignored;
  if (word == "square" || word == "airfoil") return "; did you mean asterism mesh " + word + "?";
  if (!std::filesystem::is_regular_file(word, ignored)) return "";
  return "; did you mean asterism info " + one_line(word) + ", or mesh, certify or draw?";
}

std::string no_such_command(const CLI::App& program, const std::string& word) {
  std::vector<std::string> commands;
  for (const CLI::App* one : program.get_subcommands([](const CLI::App*) { return true; }))
    commands.push_back(one->get_name());
  const std::string instead = meant_instead(word);
  return "there is no command '" + one_line(word) + "'" +
         (instead.empty() ? did_you_mean(word, commands) : instead) +
         "\n'asterism --help' lists the commands.";
}

std::optional<std::string> misread_option(const CLI::App& program,
                                          const std::vector<std::string>& words) {
  if (words.empty() || words[0] == "challenge") return std::nullopt;
  for (const CLI::App* app : program.get_subcommands([](const CLI::App*) { return true; })) {
    if (app->get_name() != words[0]) continue;
    for (const std::string& word : words)
      if (is_misread(word, options_of(*app))) return no_such_option(*app, word);
  }
  return std::nullopt;
}

std::optional<std::string> empty_file_name(const std::vector<std::string>& words) {
  if (words.empty() || words[0] == "challenge") return std::nullopt;
  for (std::size_t i = 0; i < words.size(); ++i) {
    const std::string before = i == 0 ? "" : words[i - 1];
    const bool is_value = before.starts_with('-') && before != "-o" && before != "--output";
    if (words[i].empty() && !is_value)
      return "argument " + std::to_string(i + 1) + " is empty" +
             (i == 0 ? "" : ", behind " + one_line(before)) +
             "; is a variable of the shell not set?";
  }
  return std::nullopt;
}

std::optional<std::string> misused_stream(const std::vector<std::string>& words) {
  constexpr std::array<std::string_view, 3> taken_by = {"eval", "challenge", "convert"};
  constexpr std::array<std::string_view, 3> streams = {"-", "/dev/stdin", "/dev/stdout"};
  if (words.empty() || std::find(taken_by.begin(), taken_by.end(), words[0]) != taken_by.end())
    return std::nullopt;
  for (const std::string& word : words)
    if (std::find(streams.begin(), streams.end(), word) != streams.end())
      return word + ": " + words[0] +
             " wants the name of a file, whose ending says what it holds; standard input and "
             "output are read and written by 'asterism convert - OUT --format EXT' and by eval";
  return std::nullopt;
}

}  // namespace asterism::apps
