// SPDX-License-Identifier: MIT
//
// Reads options with numbers exactly, and checks them at once: a value that is no number, not
// finite or out of range ends the parsing with a message naming the option and the value.
#pragma once

#include <CLI/CLI.hpp>
#include <cstdint>
#include <optional>
#include <string>

namespace asterism::apps {

struct real_range {
  double low, high;
  bool low_allowed, high_allowed;
  const char* text;  // after "must be"
};

inline constexpr real_range positive_reals = {0, 1.7976931348623157e308, false, true, "positive"};

inline constexpr real_range reals_from_zero = {0, 1.7976931348623157e308, true, true,
                                               "a finite number, at least 0"};

inline constexpr real_range angle_bounds = {
    0, 60, true, false,
    "at least 0 and below 60 degrees, since no triangle has three angles above 60"};

// Range of --size. Beyond it the square of the size leaves the range of doubles, or nearly so.
inline constexpr real_range sizes = {1e-150, 1e150, true, true, "positive, from 1e-150 to 1e150"};

// Range of --gradation.
inline constexpr real_range gradations = {1, 1e100, false, true, "above 1, at most 1e100"};

// Returns the number in the text of an option. Throws CLI::ValidationError, as an option's reader
// may, where it is none or out of range.
double real_of(const std::string& name, const std::string& text, const real_range& range);

// Adds an option with a real number. Calls `assign` with a valid value.
CLI::Option* add_real(CLI::App& app, const std::string& name, const real_range& range,
                      const std::function<void(double)>& assign, const std::string& description);

// Adds an option with a count. Decimal digits alone: 10 is ten, 010 is ten too.
CLI::Option* add_count(CLI::App& app, const std::string& name, std::uint64_t low,
                       std::uint64_t high, const std::function<void(std::uint64_t)>& assign,
                       const std::string& description);

// Adds --max-seconds.
void add_seconds_option(CLI::App& app, std::optional<double>& seconds,
                        const std::string& description);

// Adds --quiet and --json of a command that ends with a summary.
void add_summary_flags(CLI::App& app, bool& quiet, bool& json, const std::string& without);

// Adds the flags that all commands which judge a mesh have in common.
void add_judging_flags(CLI::App& app, bool& all_findings, bool& all_edges);

}  // namespace asterism::apps
