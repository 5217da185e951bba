// SPDX-License-Identifier: MIT
#include "asterism/apps/help/completion_script.hpp"

#include <fmt/format.h>

namespace asterism::apps {
namespace {

std::string joined(const std::vector<std::string>& words, const char* between) {
  std::string text;
  for (const std::string& word : words) text += (text.empty() ? "" : between) + word;
  return text;
}

std::string commands_of(const std::vector<command_entry>& tree) {
  std::vector<std::string> names;
  for (std::size_t i = 1; i < tree.size(); ++i) names.push_back(tree[i].name);
  return joined(names, " ");
}

// True if the value is a number or a name, and not a file.
bool is_no_file(const option_entry& option) {
  const std::string& v = option.value;
  return v.size() == 1 || v == "BETA" || v == "DEG" || v == "MB" || v == "SECONDS" || v == "NAME";
}

// Returns commands that write the possible words for an argument, one a line. These include files
// unless the argument is an option's number or name, or has a closed list of values.
std::string bash_words(const option_entry& option) {
  std::string known;
  const auto& names = option.choices.empty() ? option.names_of_values : option.choices;
  if (!names.empty()) known = "compgen -W '" + joined(names, " ") + "' -- \"$word\"";
  if (!option.choices.empty() || (is_no_file(option) && !option.positional))
    return known.empty() ? ":" : known;
  return (known.empty() ? "" : known + "; ") + "compgen -f -- \"$word\"";
}

std::string bash_case(const command_entry& command) {
  std::vector<std::string> options;
  std::string values, positional = bash_words({});
  for (const option_entry& option : command.options) {
    if (option.positional && bash_words(option) != bash_words({})) positional = bash_words(option);
    if (option.positional) continue;
    options.insert(options.end(), option.names.begin(), option.names.end());
    if (option.value.empty()) continue;
    values += fmt::format("        {}) mapfile -t COMPREPLY < <({}); return ;;\n",
                          joined(option.names, "|"), bash_words(option));
  }
  return fmt::format(
      "    {})\n      case \"$before\" in\n{}      esac\n      options='{}'\n"
      "      case \"$word\" in -*) ;; *) mapfile -t COMPREPLY < <({}); return ;; esac ;;\n",
      command.name, values.empty() ? "        *) ;;\n" : values, joined(options, " "), positional);
}

std::string bash_script(const std::vector<command_entry>& tree) {
  std::string cases;
  for (std::size_t i = 1; i < tree.size(); ++i) cases += bash_case(tree[i]);
  return "# Completes the arguments of asterism in bash. Written by `asterism completion bash`.\n"
         "_asterism() {\n"
         "  local word=${COMP_WORDS[COMP_CWORD]} before=${COMP_WORDS[COMP_CWORD - 1]} options\n"
         "  COMPREPLY=()\n"
         "  if [ \"$COMP_CWORD\" -eq 1 ]; then\n"
         "    COMPREPLY=($(compgen -W '" +
         commands_of(tree) +
         " --help --version' -- \"$word\"))\n"
         "    return\n"
         "  fi\n"
         "  case \"${COMP_WORDS[1]}\" in\n" +
         cases +
         "  esac\n"
         "  COMPREPLY=($(compgen -W \"$options\" -- \"$word\"))\n"
         "}\n"
         "complete -o filenames -F _asterism asterism\n";
}

// Returns the text in single quotes, with a backslash before the characters in `special`.
std::string quoted(const std::string& text, const std::string& special) {
  std::string safe = "'";
  for (const char c : text) {
    if (c == '\'')
      safe += "'\\''";
    else if (special.find(c) != std::string::npos)
      safe += std::string("\\") + c;
    else
      safe += c;
  }
  return safe + "'";
}

std::string zsh_action(const option_entry& option) {
  if (!option.choices.empty()) return fmt::format("({})", joined(option.choices, " "));
  if (is_no_file(option) && !option.positional)
    return option.names_of_values.empty()
               ? " "
               : fmt::format("({})", joined(option.names_of_values, " "));
  if (option.names_of_values.empty()) return "_files";
  return fmt::format("{{compadd {}; _files}}", joined(option.names_of_values, " "));
}

std::string zsh_argument(const option_entry& option) {
  const std::string action = zsh_action(option);
  if (option.positional)
    return fmt::format("        {}",
                       quoted((option.repeats ? "*:" : ":") + option.names[0] + ":" + action, ""));
  std::string lines;
  for (const std::string& name : option.names) {
    // Marks with "=" that the value is the next word or, after that sign, in the same one.
    const bool joins = !option.value.empty() && name.rfind("--", 0) == 0;
    std::string spec = fmt::format("*{}{}[", name, joins ? "=" : "");
    for (const char c : option.text)
      spec += (c == '[' || c == ']' || c == '\\') ? std::string("\\") + c : std::string(1, c);
    spec += "]";
    if (!option.value.empty()) spec += fmt::format(":{}:{}", option.value, action);
    lines += (lines.empty() ? "        " : " \\\n        ") + quoted(spec, "");
  }
  return lines;
}

std::string zsh_script(const std::vector<command_entry>& tree) {
  std::string names, cases;
  for (std::size_t i = 1; i < tree.size(); ++i) {
    names += "    " + quoted(tree[i].name + ":" + tree[i].text, "") + "\n";
    cases += "    " + tree[i].name + ")\n      _arguments";
    for (const option_entry& option : tree[i].options) cases += " \\\n" + zsh_argument(option);
    cases += " ;;\n";
  }
  return "#compdef asterism\n"
         "# Completes the arguments of asterism in zsh. Written by `asterism completion zsh`.\n"
         "_asterism() {\n"
         "  local -a commands\n"
         "  commands=(\n" +
         names +
         "  )\n"
         "  if (( CURRENT == 2 )); then\n"
         "    _describe command commands\n"
         "    return\n"
         "  fi\n"
         "  local command=${words[2]}\n"
         "  shift words\n"
         "  (( CURRENT-- ))\n"
         "  case $command in\n" +
         cases +
         "  esac\n"
         "}\n"
         "# Completes if called for that, of a folder of $fpath; if sourced, says what it is for.\n"
         "if [[ $funcstack[1] == _asterism ]]; then _asterism \"$@\"; else compdef _asterism "
         "asterism; fi\n";
}

std::string fish_option(const std::string& command, const option_entry& option) {
  std::string line = "complete -c asterism -n '__fish_seen_subcommand_from " + command + "'";
  if (option.positional) {
    const bool closed = !option.choices.empty();
    if (!closed && option.names_of_values.empty()) return "";
    return line + (closed ? " -f -a " : " -a ") +
           quoted(joined(closed ? option.choices : option.names_of_values, " "), "\\") + "\n";
  }
  for (const std::string& name : option.names)
    line += name.rfind("--", 0) == 0 ? fmt::format(" -l {}", name.substr(2))
                                     : fmt::format(" -s {}", name.substr(1));
  if (!option.value.empty())
    line += option.choices.empty() && !is_no_file(option) ? " -r -F" : " -x";
  const auto& known = option.choices.empty() ? option.names_of_values : option.choices;
  if (!known.empty()) line += " -a " + quoted(joined(known, " "), "\\");
  return line + " -d " + quoted(option.text, "\\") + "\n";
}

std::string fish_script(const std::vector<command_entry>& tree) {
  std::string text =
      "# Completes the arguments of asterism in fish. Written by `asterism completion fish`.\n";
  for (std::size_t i = 1; i < tree.size(); ++i)
    text += "complete -c asterism -n __fish_use_subcommand -f -a " + tree[i].name + " -d " +
            quoted(tree[i].text, "\\") + "\n";
  for (std::size_t i = 1; i < tree.size(); ++i)
    for (const option_entry& option : tree[i].options) text += fish_option(tree[i].name, option);
  return text;
}

}  // namespace

std::string completion_script(const std::vector<command_entry>& tree, const std::string& shell) {
  if (shell == "bash") return bash_script(tree);
  return shell == "zsh" ? zsh_script(tree) : fish_script(tree);
}

}  // namespace asterism::apps
