// SPDX-License-Identifier: MIT
#include "asterism/apps/help/help_text.hpp"

#include <sys/ioctl.h>
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <array>
#include <charconv>
#include <cstdlib>
#include <sstream>
#include <string>
#include <string_view>
#include <vector>

namespace asterism::apps {
namespace {

struct heading {
  std::string_view text;
  std::string_view options;  // their long names, each between blanks
};

constexpr std::array<heading, 5> headings = {{
    {"What is wanted",
     " metric size hmin hmax aspect vertices complexity gradation angle-bound metric-tolerance tol "
     "improve "
     "refine voronoi guarantee repair solution carry hessian norm target error relative cutoff "
     "field intersect implied isotropic step gradation-space given-hessian series floor keep "
     "chord normal no-crossings width at-most "
     "size-at size-in size-near size-box layers frozen sizes-of-file transfer how "},
    {"Domain",
     " domain repair-domain repair-distance regions random-points seed chord-tolerance "
     "corner-angle hausd boundary-part strict "
     "all-edges convex-hull periodic no-split-across "},
    {"Files and words",
     " output certificate colour-by ellipses no-sites quiet json long all-findings values format "
     "proof order solution-out carry-out report "},
    {"Limits", " max-sites max-seconds max-memory threads "},
    {"In pieces", " pieces piece-format resume "},
}};

// Column at which CLI11 begins descriptions.
constexpr std::size_t description = 30;

// Returns the number of columns by which continuation lines are indented. Those of a list behind
// the names of an option do not begin as other options do.
std::size_t indent_of(std::string_view line) {
  const std::size_t words = line.find_first_not_of(' ');
  const bool is_entry = words == 2 && line.size() > description && line[description - 1] == ' ';
  const bool is_option = words == 2 && line[words] == '-';
  return is_entry ? description : words + (is_option ? 4 : 0);
}

bool is_example(std::string_view line) {
  return line.find("  asterism ") == 0 || line.find("  source ") == 0 || line.back() == '\\';
}

void append_wrapped(std::string& out, std::string_view line, std::size_t columns) {
  const std::size_t indent = indent_of(line);
  std::size_t room = columns;  // less the indent from the second line on
  while (line.size() > room) {
    std::size_t end = line.rfind(' ', room);
    std::size_t next = end + 1;
    if (end == std::string_view::npos || line.find_first_not_of(' ') > end) {
      end = next = line.rfind(',', room - 1) + 1;  // of a list without blanks: {bash,zsh,fish}
      if (end == 0) break;
    }
    out.append(line.substr(0, end)).append("\n").append(indent, ' ');
    line.remove_prefix(next);
    room = columns - indent;
  }
  out.append(line).append("\n");
}

// True if a line continues the paragraph of the line before: neither is indented or empty.
bool goes_on(std::string_view before, std::string_view line) {
  const auto is_text = [](std::string_view text) { return !text.empty() && text.front() != ' '; };
  return is_text(before) && is_text(line) && line.find("Usage:") != 0;
}

// Splits help into lines, and joins the lines of each paragraph into one: they were broken for
// another width.
std::vector<std::string> paragraphs_of(const std::string& help) {
  std::vector<std::string> lines;
  std::istringstream text(help);
  for (std::string line; std::getline(text, line);) {
    if (!lines.empty() && goes_on(lines.back(), line))
      lines.back() += " " + line;
    else
      lines.push_back(line);
  }
  return lines;
}

}  // namespace

void group_options(CLI::App& program) {
  for (CLI::App* app : program.get_subcommands([](CLI::App*) { return true; }))
    for (CLI::Option* option : app->get_options()) {
      if (option->get_lnames().empty()) continue;
      const std::string name = " " + option->get_lnames().front() + " ";
      for (const heading& h : headings)
        if (h.options.find(name) != std::string_view::npos) option->group(std::string(h.text));
    }
}

std::size_t help_columns() {
  constexpr std::size_t least = 50, usual = 100;
  std::size_t columns = 0;
  if (const char* const asked = std::getenv("COLUMNS"))
    std::from_chars(asked, asked + std::string_view(asked).size(), columns);
  winsize window{};
  if (columns == 0 && ioctl(STDOUT_FILENO, TIOCGWINSZ, &window) == 0) columns = window.ws_col;
  return columns == 0 ? usual : std::max(least, columns);
}

std::string wrapped(const std::string& help, std::size_t columns) {
  std::string out, before;
  for (const std::string& line : paragraphs_of(help)) {
    const bool is_second_gap = line.empty() && before.empty();
    before = line;
    if (is_second_gap) continue;
    if (line.size() <= columns || is_example(line))
      out += line + '\n';
    else
      append_wrapped(out, line, columns);
  }
  return out;
}

}  // namespace asterism::apps
