// SPDX-License-Identifier: MIT
#include "asterism/apps/help/manual_page.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "asterism/core/version.h"

namespace asterism::apps {
namespace {

// Returns the text escaped for roff: no line begins a request, and a hyphen stays one.
std::string roff(const std::string& text) {
  std::string safe;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const bool starts = i == 0 || text[i - 1] == '\n';
    if (starts && (text[i] == '.' || text[i] == '\'')) safe += "\\&";
    if (text[i] == '\\')
      safe += "\\e";
    else if (text[i] == '-')
      safe += "\\-";
    else if (text[i] == '\'')
      safe += "\\(aq";
    else
      safe += text[i];
  }
  return safe;
}

std::string upper(std::string text) {
  std::transform(text.begin(), text.end(), text.begin(), [](char c) {
    return c >= 'a' && c <= 'z' ? static_cast<char>(c - 'a' + 'A') : c;
  });
  return text;
}

std::string synopsis(const command_entry& command, bool is_program) {
  std::string text =
      ".B asterism" + (is_program ? std::string() : fmt::format(" {}", command.name)) + "\n";
  if (is_program) return text + ".I COMMAND\n.RI [ arguments ]\n";
  for (const option_entry& option : command.options) {
    if (option.positional)
      text += (option.required ? ".I " : ".RI [ ") + option.names[0] +
              (option.required ? "" : " ]") + "\n";
    else if (option.required)
      text += ".B " + roff(option.names[0]) + "\n.I " + option.value + "\n";
  }
  return text + ".RI [ options ]\n";
}

std::string option_paragraph(const option_entry& option) {
  std::string text = ".TP\n";
  if (option.positional) return text + ".I " + option.names[0] + "\n" + roff(option.text) + "\n";
  for (std::size_t i = 0; i < option.names.size(); ++i)
    text += std::string(i > 0 ? ", " : "") + "\\fB" + roff(option.names[i]) + "\\fR";
  if (!option.value.empty()) text += " \\fI" + roff(option.value) + "\\fR";
  text += fmt::format("\n{}\n", roff(option.text));
  if (!option.choices.empty()) {
    std::string all;
    for (const std::string& choice : option.choices) all += (all.empty() ? "" : ", ") + choice;
    text += "One of: " + roff(all) + ".\n";
  }
  return text;
}

std::string see_also(const std::vector<command_entry>& tree, std::size_t which) {
  std::string text = ".SH SEE ALSO\n";
  for (std::size_t i = 0; i < tree.size(); ++i)
    if (i != which)
      text += ".BR asterism" + (i == 0 ? std::string() : fmt::format("\\-{}", tree[i].name)) +
              " (1)" +
              (i + 1 == tree.size() || (i + 2 == tree.size() && which == i + 1) ? "\n" : ",\n");
  return text;
}

}  // namespace

std::string manual_page(const std::vector<command_entry>& tree, std::size_t which) {
  const command_entry& command = tree[which];
  const bool is_program = which == 0;
  const std::string name = is_program ? "asterism" : "asterism\\-" + command.name;
  std::string text = ".\\\" Written by `asterism man`.\n.TH " + upper(name) +
                     " 1 \"\" \"asterism " ASTERISM_VERSION_TEXT "\" \"User Commands\"\n";
  text += ".SH NAME\n" + name + " \\- " + roff(command.text) + "\n";
  text += ".SH SYNOPSIS\n" + synopsis(command, is_program);
  if (is_program) {
    text += ".SH COMMANDS\n";
    for (std::size_t i = 1; i < tree.size(); ++i)
      text += ".TP\n.B " + tree[i].name + "\n" + roff(tree[i].text) + "\n";
  }
  text += ".SH OPTIONS\n";
  for (const option_entry& option : command.options) text += option_paragraph(option);
  if (!command.footer.empty()) text += ".SH NOTES\n.nf\n" + roff(command.footer) + "\n.fi\n";
  return text + see_also(tree, which);
}

}  // namespace asterism::apps
