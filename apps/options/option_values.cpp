// SPDX-License-Identifier: MIT
#include "asterism/apps/options/option_values.hpp"

#include <charconv>

#include "asterism/core/number_text.hpp"

namespace asterism::apps {
using namespace internal;
namespace {

[[noreturn]] void refuse(const std::string& name, const std::string& what) {
  throw CLI::ValidationError(name, what);
}

// Returns the clause "; did you mean 0.1?" for 0,1: decimal commas are not read.
std::string meant_number(std::string text) {
  const std::size_t comma = text.find(',');
  if (comma == std::string::npos) return "";
  text[comma] = '.';
  return parse_number(text) ? "; did you mean " + text + "?" : "";
}

}  // namespace

double real_of(const std::string& name, const std::string& text, const real_range& range) {
  const auto value = parse_number(text);
  if (!value)
    refuse(name, value.failure().message + "; it must be " + range.text + meant_number(text));
  const double x = value.value();
  const bool inside = (range.low < x || (range.low_allowed && x == range.low)) &&
                      (x < range.high || (range.high_allowed && x == range.high));
  if (!inside) refuse(name, text + " is out of range: it must be " + range.text);
  return x;
}

CLI::Option* add_real(CLI::App& app, const std::string& name, const real_range& range,
                      const std::function<void(double)>& assign, const std::string& description) {
  const auto read = [name, range, assign](const std::string& text) {
    assign(real_of(name, text, range));
  };
  return app.add_option_function<std::string>(name, read, description);
}

CLI::Option* add_count(CLI::App& app, const std::string& name, std::uint64_t low,
                       std::uint64_t high, const std::function<void(std::uint64_t)>& assign,
                       const std::string& description) {
  const auto read = [name, low, high, assign](const std::string& text) {
    std::uint64_t value = 0;
    const char* const end = text.data() + text.size();
    const auto [stop, failure] = std::from_chars(text.data(), end, value);
    if (text.empty() || failure == std::errc::invalid_argument || stop != end)
      refuse(name, quoted_token(text) + " is not a whole number; it must be from " +
                       std::to_string(low) + " to " + std::to_string(high));
    if (failure != std::errc() || value < low || value > high)
      refuse(name, text + " is out of range: it must be from " + std::to_string(low) + " to " +
                       std::to_string(high));
    assign(value);
  };
  return app.add_option_function<std::string>(name, read, description);
}

void add_seconds_option(CLI::App& app, std::optional<double>& seconds,
                        const std::string& description) {
  add_real(
      app, "--max-seconds", positive_reals, [&seconds](double x) { seconds = x; }, description)
      ->type_name("S");
}

void add_summary_flags(CLI::App& app, bool& quiet, bool& json, const std::string& without) {
  auto* const no_summary = app.add_flag("--quiet", quiet, without);
  app.add_flag("--json", json, "The summary as a JSON object, in place of lines")
      ->excludes(no_summary);
}

void add_judging_flags(CLI::App& app, bool& all_findings, bool& all_edges) {
  app.add_flag("--all-findings", all_findings,
               "List every finding, not the first ten of each kind");
  app.add_flag("--all-edges", all_edges,
               "Every edge the mesh lists is a segment of its domain, marked or not");
}

}  // namespace asterism::apps
