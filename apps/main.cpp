// SPDX-License-Identifier: MIT
#include <CLI/CLI.hpp>
#include <algorithm>
#include <array>
#include <csignal>
#include <exception>
#include <iostream>
#include <new>
#include <string>
#include <string_view>
#include <vector>

#include "asterism/apps/base/commands.hpp"
#include "asterism/apps/base/complain.hpp"
#include "asterism/apps/commands/surface_command.hpp"
#include "asterism/apps/help/help_text.hpp"
#include "asterism/apps/help/usage_message.hpp"
#include "asterism/apps/run/freed_memory.hpp"
#include "asterism/core/version.h"

namespace {

using namespace asterism::apps;

// A subcommand by its name. The commands help, completion and man describe all other ones.
struct known_command {
  std::string_view name;
  void (*add)(CLI::App& program, command& chosen);
  bool tells_of_others = false;
};
constexpr std::array<known_command, 17> known_commands = {{
    {"mesh", [](CLI::App& program, command& chosen) { add_mesh_command(program, chosen); }},
    {"verify", [](CLI::App& program, command& chosen) { add_verify_command(program, chosen); }},
    {"certify", add_certify_command},
    {"check", add_check_command},
    {"adapt", add_adapt_command},
    {"metric", add_metric_command},
    {"transfer", add_transfer_command},
    {"eval", add_eval_command},
    {"challenge", add_challenge_command},
    {"surface", add_surface_command},
    {"deviation", add_deviation_command},
    {"convert", add_convert_command},
    {"draw", add_draw_command},
    {"info", add_info_command},
    {"completion", add_completion_command, true},
    {"help", add_help_command, true},
    {"man", add_man_command, true},
}};

const known_command* find_command(std::string_view name) {
  const auto* const found = std::find_if(known_commands.begin(), known_commands.end(),
                                         [name](const known_command& k) { return k.name == name; });
  return found != known_commands.end() ? found : nullptr;
}

bool takes_files(const known_command* known) { return known != nullptr && !known->tells_of_others; }

// Adds only the command that the first word names and parses the words: a fourth of the time of
// adding all commands, which was a tenth of a small job. Returns whether that was enough: false
// where a message or help is needed, or another command is named as well.
bool is_read_by_one(CLI::App& program, const std::vector<std::string>& words, command& chosen) {
  const known_command* const named = words.empty() ? nullptr : find_command(words[0]);
  if (!takes_files(named) ||
      std::any_of(words.begin() + 1, words.end(),
                  [](const std::string& word) { return find_command(word) != nullptr; }))
    return false;
  named->add(program, chosen);
  if (empty_file_name(words) || misread_option(program, words) || misused_stream(words))
    return false;
  try {
    program.parse(std::vector<std::string>(words.rbegin(), words.rend()));
  } catch (const CLI::ParseError&) {
    return false;
  }
  return static_cast<bool>(chosen);
}

void describe(CLI::App& program) {
  program.name("asterism");
  program.set_version_flag("--version", "asterism " ASTERISM_VERSION_TEXT);
  program.require_subcommand(0, 1);  // none is told below: an unknown one is told by its name
  program.footer(
      "Exit status: 0 done; 1 not reached (what is certain is written, and says so);\n"
      "2 bad usage or input (nothing is written).\n\n"
      "Begin with:\n  asterism mesh square --metric swirl:3 --size 0.1 -o swirl.html\n\n"
      "'asterism help COMMAND' shows the options and examples of one command.");
}

int conclude(const command& chosen) {
  const int status = chosen();
  if (std::cout.flush() || status != done) return status;
  std::cerr << "asterism: standard output: writing failed\n";
  return not_reached;
}

// Parses the words with all commands added, so that help and messages list them.
int run_with_all(const std::vector<std::string>& words) {
  CLI::App program("Anisotropic triangular meshes by star stitching, on exact predicates.");
  describe(program);
  command chosen;
  for (const known_command& known : known_commands) known.add(program, chosen);
  group_options(program);
  auto message = empty_file_name(words);
  if (!message) message = misread_option(program, words);
  if (!message && !words.empty() && takes_files(find_command(words[0])))
    message = misused_stream(words);
  if (message) {
    std::cerr << "asterism: " << *message << '\n';
    return refused;
  }
  try {
    program.parse(std::vector<std::string>(words.rbegin(), words.rend()));
    if (!chosen)
      throw CLI::RequiredError(
          "a command (mesh, adapt, metric, transfer, verify, certify, check, eval, challenge, "
          "surface, deviation, convert, draw, info, completion or man)");
  } catch (const CLI::CallForHelp&) {
    std::cout << wrapped(program.help(), help_columns());
    return done;
  } catch (const CLI::ParseError& failure) {
    if (failure.get_exit_code() == 0) return program.exit(failure);  // --help, --version
    std::cerr << "asterism: " << usage_message(program, words, failure) << '\n';
    return refused;
  }
  return conclude(chosen);
}

int run(const std::vector<std::string>& words) {
  CLI::App program;
  command chosen;
  return is_read_by_one(program, words, chosen) ? conclude(chosen) : run_with_all(words);
}

}  // namespace

int main(int argc, char** argv) {
  // Ignores the signal of a limit on files: a file that gets too large is then an error like a full
  // disk.
  std::signal(SIGXFSZ, SIG_IGN);
  asterism::apps::give_back_large_blocks();
  try {
    return run({argv + 1, argv + argc});
  } catch (const std::bad_alloc&) {
    std::cerr << "asterism: there is not enough memory\n";
    return asterism::apps::not_reached;
  } catch (const std::exception& failure) {  // of a failing stream library
    std::cerr << "asterism: " << failure.what() << '\n';
    return asterism::apps::not_reached;
  }
}
