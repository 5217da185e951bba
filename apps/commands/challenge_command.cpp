// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <iostream>
#include <memory>
#include <sstream>
#include <string>
#include <vector>

#include "asterism/apps/base/commands.hpp"
#include "asterism/apps/base/complain.hpp"
#include "asterism/apps/base/notes.hpp"
#include "asterism/apps/options/option_values.hpp"
#include "asterism/challenge/report.hpp"
#include "asterism/core/number_text.hpp"
#include "asterism/core/similar_name.hpp"
#include "asterism/core/version.h"
#include "asterism/mesh/io/file_output.hpp"
#include "asterism/mesh/io/similar_file.hpp"

namespace asterism::apps {
namespace {

using namespace challenge;

struct challenge_options {
  std::vector<std::string> predicates, classes, command;
  std::vector<std::string> own;  // names of the options of challenge
  record_choice records;
  challenge::run_limits limits;
  std::filesystem::path report, record_file;
  bool list = false, undecided_passes = false;
};

constexpr real_range waits = {0.01, 86400, true, true, "from 0.01 to 86400 seconds"};

constexpr const char* challenge_examples =
    R"(asterism challenge [OPTIONS] COMMAND [ARGUMENTS...]: what follows COMMAND is its own,
-o too; a note names an option of challenge there.
COMMAND reads records of the batch protocol from standard input, one a line (asterism eval --help),
and answers each with one line: an integer, '?' if undecided, or 'error: ...'. It ends at the end of
its input. Without --predicate each name is tried first, and those it knows are asked.
A class is a name (--list) or a file of records, with lines '# class NAME' to tell classes apart.

Exit status: 0 all answers right; 1 some were not, or did not come; 2 bad usage.

Examples:
  asterism challenge ./my_predicates
  asterism challenge --predicate orient2d --predicate incircle --count 1000 -o report.html ./mine -v
  asterism challenge --classes cocircular,one-ulp,hard_cases.txt asterism eval --kernel double
  asterism challenge --count 1000 --records corpus.txt)";

std::vector<std::string> names_of(const auto& named) {
  std::vector<std::string> names;
  for (const auto& one : named) names.emplace_back(one.name);
  return names;
}

// Returns a clause about a class with a similar name, or else a file; empty if there is none.
std::string similar_source(const std::string& name) {
  const std::string meant = internal::did_you_mean(name, names_of(input_classes()));
  return meant.empty() ? internal::similar_file(name) : meant;
}

result<std::vector<question>> chosen_questions(const challenge_options& options) {
  std::vector<question> chosen;
  if (options.predicates.empty()) {
    const auto all = questions();
    return std::vector<question>(all.begin(), all.end());
  }
  for (const std::string& name : options.predicates) {
    const auto found = question_named(name);
    if (!found)
      return error{"--predicate: unknown predicate " + internal::quoted_token(name) +
                   internal::did_you_mean(name, names_of(questions()))};
    chosen.push_back(*found);
  }
  return chosen;
}

result<std::vector<record_source>> chosen_sources(const challenge_options& options) {
  std::vector<record_source> chosen;
  if (options.classes.empty())
    for (const input_class& made_by : input_classes()) chosen.push_back(source_of(made_by));
  for (const std::string& name : options.classes) {
    if (const input_class* const made_by = class_named(name)) {
      chosen.push_back(source_of(*made_by));
      continue;
    }
    std::error_code ignored;
    if (!std::filesystem::exists(name, ignored))
      return error{"--classes: " + internal::quoted_token(name) +
                   " is neither a class (--list) nor a file" + similar_source(name)};
    auto read = read_records(name);
    if (!read) return read.failure();
    for (record_source& source : read.value()) chosen.push_back(std::move(source));
  }
  return chosen;
}

// Takes questions only from the files named, if any: a predicate that no file contains is not
// tried.
void drop_unasked(challenge_plan& plan) {
  std::erase_if(plan.questions, [&](const question& q) {
    return std::none_of(plan.sources.begin(), plan.sources.end(), [&](const record_source& s) {
      return s.made_by != nullptr ||
             std::any_of(s.listed.begin(), s.listed.end(),
                         [&](const asked_record& r) { return r.asked.name == q.name; });
    });
  });
}

result<std::filesystem::path> check_report(const std::filesystem::path& path) {
  if (path.extension() != ".md" && path.extension() != ".html")
    return error{path.string() + ": a report ends in .md or .html"};
  return internal::check_writable(path);
}

int list_classes() {
  for (const input_class& c : input_classes()) std::cout << c.name << ": " << c.text << '\n';
  return done;
}

int write_record_file(const challenge_options& options, const challenge_plan& plan) {
  if (const auto place = internal::check_writable(options.record_file); !place)
    return complain(place.failure(), refused);
  std::ostringstream text;
  write_records(text, plan.sources, plan.questions, plan.records);
  const auto written = internal::write_files({{options.record_file, text.str()}});
  return written ? done : complain(written.failure(), refused);
}

int challenge_and_report(const challenge_options& options, const challenge_plan& plan) {
  const auto outcome = challenge_program(plan);
  if (!outcome) return complain(outcome.failure(), refused);
  std::cout << text_report(outcome.value());
  if (!options.report.empty()) {
    const report_heading heading = {fmt::format("{}", fmt::join(plan.command, " ")), plan.records,
                                    plan.limits, ASTERISM_VERSION_TEXT};
    const auto text = options.report.extension() == ".md"
                          ? markdown_report(outcome.value(), heading)
                          : html_report(outcome.value(), heading);
    const auto written = internal::write_files({{options.report, text}});
    if (!written) return complain(written.failure(), not_reached);
  }
  return outcome.value().all_right(options.undecided_passes) ? done : not_reached;
}

// Notes the first word behind the program's name that is an option of challenge: it is passed
// to the program.
void warn_of_own_options(const challenge_options& options) {
  for (const std::string& word : options.command) {
    const std::string name = word.substr(0, word.find('='));
    if (std::find(options.own.begin(), options.own.end(), name) == options.own.end()) continue;
    say_notes({name + " goes to " + internal::quoted_token(options.command.front()) +
               ", since it is behind it; options of challenge go before the program, as in "
               "asterism challenge " +
               name + " ... " + options.command.front()},
              {});
    return;
  }
}

int run_challenge(const challenge_options& options) {
  if (options.list) return list_classes();
  const bool writes = !options.record_file.empty();
  if (!writes && options.command.empty())
    return complain({"challenge: there is no COMMAND, the program to test, as in asterism "
                     "challenge ./my_predicates"},
                    refused);
  if (writes && !options.command.empty())
    return complain({"--records asks nobody: leave " +
                     internal::quoted_token(options.command.front()) + " out"},
                    refused);
  if (!options.command.empty() && options.command.front().starts_with('-'))
    return complain(
        {"challenge: unknown option " + internal::quoted_token(options.command.front()) +
         "; 'asterism challenge --help' lists those there are, and options of COMMAND stand behind "
         "it"},
        refused);
  warn_of_own_options(options);
  auto asked = chosen_questions(options);
  if (!asked) return complain(asked.failure(), refused);
  auto sources = chosen_sources(options);
  if (!sources) return complain(sources.failure(), refused);
  if (!options.report.empty())
    if (const auto place = check_report(options.report); !place)
      return complain(place.failure(), refused);
  challenge_plan plan = {options.command,          std::move(sources.value()),
                         std::move(asked.value()), options.records,
                         options.limits,           options.predicates.empty()};
  plan.limits.patience = plan.limits.silence;
  drop_unasked(plan);
  return writes ? write_record_file(options, plan) : challenge_and_report(options, plan);
}

void add_limits(CLI::App& app, challenge_options& options) {
  add_real(
      app, "--timeout", waits, [&options](double s) { options.limits.silence = s; },
      "Without an answer for so long the program is killed (default 10)")
      ->type_name("SECONDS");
  add_real(
      app, "--slow", waits, [&options](double s) { options.limits.slow = s; },
      "An answer that takes longer is called slow (default 1)")
      ->type_name("SECONDS");
  add_real(
      app, "--max-seconds", positive_reals, [&options](double s) { options.limits.whole = s; },
      "The run ends after this time; remaining records count as not asked (default 3600)")
      ->type_name("S");
}

void add_choices(CLI::App& app, challenge_options& options) {
  app.add_option(
         "--predicate", options.predicates,
         "Test this predicate; may be given several times (default: all that the program knows)")
      ->type_name("NAME")
      ->allow_extra_args(false);
  app.add_option("--classes", options.classes,
                 "Classes of input, by name or file, separated by commas (default: all names)")
      ->type_name("LIST")
      ->delimiter(',')
      ->allow_extra_args(false);
  app.add_flag("--list", options.list, "List the classes and end");
  add_count(
      app, "--seed", 0, 0xffffffffffffffffU,
      [&options](std::uint64_t n) { options.records.seed = n; },
      "Another seed, other records (default 1)")
      ->type_name("N");
  add_count(
      app, "--count", 1, 1000000, [&options](std::uint64_t n) { options.records.count = n; },
      "Records of each class and predicate (default 100)")
      ->type_name("N");
  app.add_flag("--decimal", options.records.decimal,
               "Write the shortest decimals in place of hexadecimal numbers");
}

}  // namespace

void add_challenge_command(CLI::App& program, command& chosen) {
  auto* const app = program.add_subcommand(
      "challenge", "Compare another program's predicates with the exact ones");
  const auto options = std::make_shared<challenge_options>();
  add_choices(*app, *options);
  add_limits(*app, *options);
  app->add_option("-o,--output", options->report, "Write a report, .md or .html")
      ->type_name("REPORT");
  app->add_option("--records", options->record_file,
                  "Run no program; write the records and their answers to a file")
      ->type_name("FILE");
  app->add_flag("--allow-undecided", options->undecided_passes,
                "'?' passes for right in the exit status");
  for (const CLI::Option* const option : app->get_options()) {
    for (const std::string& name : option->get_snames()) options->own.push_back("-" + name);
    for (const std::string& name : option->get_lnames()) options->own.push_back("--" + name);
  }
  app->footer(challenge_examples);
  app->prefix_command();
  app->callback([app, options, &chosen] {
    options->command = app->remaining();
    chosen = [options] { return run_challenge(*options); };
  });
}

}  // namespace asterism::apps
