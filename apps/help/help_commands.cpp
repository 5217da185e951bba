// SPDX-License-Identifier: MIT
#include <iostream>
#include <memory>
#include <string>
#include <vector>

#include "asterism/apps/base/commands.hpp"
#include "asterism/apps/base/complain.hpp"
#include "asterism/apps/help/command_tree.hpp"
#include "asterism/apps/help/completion_script.hpp"
#include "asterism/apps/help/help_text.hpp"
#include "asterism/apps/help/manual_page.hpp"
#include "asterism/apps/help/usage_message.hpp"

namespace asterism::apps {
namespace {

int write_manual_page(const CLI::App& program, const std::string& name) {
  const std::vector<command_entry> tree = command_tree(program);
  for (std::size_t i = 0; i < tree.size(); ++i)
    if (name.empty() ? i == 0 : tree[i].name == name) {
      std::cout << manual_page(tree, i);
      return done;
    }
  return complain({"there is no command '" + name + "'"}, refused);
}

}  // namespace

void add_completion_command(CLI::App& program, command& chosen) {
  auto* const app = program.add_subcommand("completion", "Write a completion script for a shell");
  const auto shell = std::make_shared<std::string>();
  app->add_option("SHELL", *shell, "bash, zsh or fish")
      ->required()
      ->check(CLI::IsMember({"bash", "zsh", "fish"}));
  app->footer(
      "Installed packages have these scripts where the shells look for them. Else:\n"
      "  source <(asterism completion bash)\n"
      "  asterism completion zsh > ~/.zfunc/_asterism\n"
      "  asterism completion fish > ~/.config/fish/completions/asterism.fish");
  app->callback([&program, shell, &chosen] {
    chosen = [&program, shell] {
      std::cout << completion_script(command_tree(program), *shell);
      return static_cast<int>(done);
    };
  });
}

void add_help_command(CLI::App& program, command& chosen) {
  auto* const app = program.add_subcommand("help", "Show the options and examples of a command");
  const auto name = std::make_shared<std::string>();
  app->add_option("COMMAND", *name, "The command; default: the program");
  app->footer("Example:\n  asterism help mesh");
  app->callback([&program, name, &chosen] {
    chosen = [&program, name]() -> int {
      if (name->empty()) {
        // Calls the formatter: program.help() would return the help of the command that was parsed,
        // `help`.
        const std::string all = program.get_formatter()->make_help(&program, program.get_name(),
                                                                   CLI::AppFormatMode::Normal);
        std::cout << wrapped(all, help_columns());
        return done;
      }
      for (const CLI::App* other : program.get_subcommands([](const CLI::App*) { return true; }))
        if (other->get_name() == *name) {
          std::cout << wrapped(other->help(program.get_name()), help_columns());
          return done;
        }
      std::cerr << "asterism: " << no_such_command(program, *name) << '\n';
      return refused;
    };
  });
}

void add_man_command(CLI::App& program, command& chosen) {
  auto* const app =
      program.add_subcommand("man", "Write a manual page, of the program or of a command");
  const auto name = std::make_shared<std::string>();
  std::vector<std::string> known = {"man"};
  for (const CLI::App* other : program.get_subcommands([](const CLI::App*) { return true; }))
    if (other != app) known.push_back(other->get_name());
  app->add_option("COMMAND", *name, "The command; default: the program")
      ->check(CLI::IsMember(known));
  app->footer("Example:\n  asterism man mesh | man -l -");
  app->callback([&program, name, &chosen] {
    chosen = [&program, name] { return write_manual_page(program, *name); };
  });
}

}  // namespace asterism::apps
