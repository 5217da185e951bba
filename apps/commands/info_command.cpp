// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <filesystem>
#include <iostream>
#include <memory>
#include <nlohmann/json.hpp>
#include <utility>
#include <variant>

#include "asterism/apps/base/commands.hpp"
#include "asterism/apps/base/complain.hpp"
#include "asterism/apps/job/file_facts.hpp"
#include "asterism/mesh/support/one_line.hpp"

namespace asterism::apps {
namespace {

struct info_options {
  std::filesystem::path file;
  bool json = false;
};

constexpr const char* info_examples =
    R"(FILE  a domain (.poly, .geojson, .wkt), a mesh (.mesh, .msh and others) with the metric and the
      certificate beside it, a solution or metric (.sol, .solb, .bb) with its mesh beside it, or a
      certificate. Nothing is proved and nothing is written.

Exit status: 0 told; 2 unreadable.

Examples:
  asterism info lake.poly
  asterism info wing.mesh --json)";

int run_info(const info_options& options) {
  auto facts = facts_of_file(options.file);
  if (!facts) return complain(facts.failure(), refused);
  if (options.json) {
    nlohmann::ordered_json object;
    for (auto& [name, value] : facts.value())
      std::visit([&](auto& known) { object[name] = std::move(known); }, value);
    std::cout << object.dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace)
              << '\n';
    return done;
  }
  for (const auto& [name, value] : facts.value())
    std::visit(
        [&](const auto& known) {
          std::cout << internal::printable(fmt::format("{:<22} {}", name, known)) << '\n';
        },
        value);
  return done;
}

}  // namespace

void add_info_command(CLI::App& program, command& chosen) {
  auto* const app = program.add_subcommand("info", "Say what a file holds");
  const auto options = std::make_shared<info_options>();
  app->add_option("FILE", options->file, "File to describe")->required();
  app->add_flag("--json", options->json, "As a JSON object");
  app->footer(info_examples);
  app->callback([options, &chosen] { chosen = [options] { return run_info(*options); }; });
}

}  // namespace asterism::apps
