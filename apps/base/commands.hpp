// SPDX-License-Identifier: MIT
//
// Declares the subcommands of `asterism`. Each adds its options and help to the program and, when
// the arguments ask for it, stores in `chosen` what is to be run; running it returns the status.
#pragma once

#include <CLI/CLI.hpp>
#include <functional>

namespace asterism::apps {

using command = std::function<int()>;
class piece_team;  // apps/pieces/piece_team.hpp

void add_eval_command(CLI::App& program, command& chosen);
void add_challenge_command(CLI::App& program, command& chosen);
// Adds commands for pieces: with a team, which must outlive the command, `mesh` makes pieces alone
// and `verify` judges them, together with the team's other programs.
void add_mesh_command(CLI::App& program, command& chosen, piece_team* team = nullptr);
void add_verify_command(CLI::App& program, command& chosen, piece_team* team = nullptr);
void add_certify_command(CLI::App& program, command& chosen);
void add_check_command(CLI::App& program, command& chosen);
void add_convert_command(CLI::App& program, command& chosen);
void add_draw_command(CLI::App& program, command& chosen);
void add_adapt_command(CLI::App& program, command& chosen);
void add_metric_command(CLI::App& program, command& chosen);
void add_transfer_command(CLI::App& program, command& chosen);
void add_deviation_command(CLI::App& program, command& chosen);
void add_info_command(CLI::App& program, command& chosen);
void add_completion_command(CLI::App& program, command& chosen);
void add_help_command(CLI::App& program, command& chosen);
// Adds the command `help`. Requires that all other commands are there.
void add_man_command(CLI::App& program, command& chosen);

}  // namespace asterism::apps
