// SPDX-License-Identifier: MIT
#include <CLI/CLI.hpp>
#include <csignal>
#include <exception>
#include <iostream>
#include <new>
#include <string>
#include <vector>

#include "asterism/apps/commands.hpp"
#include "asterism/apps/complain.hpp"
#include "asterism/apps/freed_memory.hpp"
#include "asterism/apps/help_text.hpp"
#include "asterism/apps/surface_command.hpp"
#include "asterism/apps/usage_message.hpp"
#include "asterism/core/version.h"

namespace {

int run(int argc, char** argv) {
  using namespace asterism::apps;
  CLI::App program("Anisotropic triangular meshes by star stitching, on exact predicates.");
  program.name("asterism");
  program.set_version_flag("--version", "asterism " ASTERISM_VERSION_TEXT);
  program.require_subcommand(0, 1);  // none is told below: an unknown one is told by its name
  program.footer(
      "Exit status: 0 done; 1 not reached (what is certain is written, and says so);\n"
      "2 bad usage or input (nothing is written).\n\n"
      "Begin with:\n  asterism mesh square --metric swirl:3 --size 0.1 -o swirl.html\n\n"
      "'asterism help COMMAND' shows the options and examples of one command.");
  command chosen;
  add_mesh_command(program, chosen);
  add_verify_command(program, chosen);
  add_certify_command(program, chosen);
  add_check_command(program, chosen);
  add_adapt_command(program, chosen);
  add_metric_command(program, chosen);
  add_transfer_command(program, chosen);
  add_eval_command(program, chosen);
  add_challenge_command(program, chosen);
  add_surface_command(program, chosen);
  add_deviation_command(program, chosen);
  add_convert_command(program, chosen);
  add_draw_command(program, chosen);
  add_info_command(program, chosen);
  add_completion_command(program, chosen);
  add_help_command(program, chosen);
  add_man_command(program, chosen);
  group_options(program);
  const std::vector<std::string> words(argv + 1, argv + argc);
  auto message = misread_help(program, words);
  if (!message) message = misused_stream(words);
  if (message) {
    std::cerr << "asterism: " << without_controls(*message) << '\n';
    return refused;
  }
  try {
    program.parse(argc, argv);
    if (!chosen)
      throw CLI::RequiredError(
          "a command (mesh, adapt, metric, transfer, verify, certify, check, eval, challenge, "
          "surface, deviation, convert, draw, info, completion or man)");
  } catch (const CLI::CallForHelp&) {
    std::cout << wrapped(program.help(), help_columns());
    return done;
  } catch (const CLI::ParseError& failure) {
    if (failure.get_exit_code() == 0) return program.exit(failure);  // --help, --version
    std::cerr << "asterism: " << without_controls(usage_message(program, words, failure)) << '\n';
    return refused;
  }
  const int status = chosen();
  if (std::cout.flush() || status != done) return status;
  std::cerr << "asterism: standard output: writing failed\n";
  return not_reached;
}

}  // namespace

int main(int argc, char** argv) {
  // A file that gets too large for a limit on files is an error like a full disk.
  std::signal(SIGXFSZ, SIG_IGN);
  asterism::apps::give_back_large_blocks();
  try {
    return run(argc, argv);
  } catch (const std::bad_alloc&) {
    std::cerr << "asterism: there is not enough memory\n";
    return asterism::apps::not_reached;
  } catch (const std::exception& failure) {  // of a failing stream library
    std::cerr << "asterism: " << failure.what() << '\n';
    return asterism::apps::not_reached;
  }
}
