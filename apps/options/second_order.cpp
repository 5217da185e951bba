// SPDX-License-Identifier: MIT
#include "asterism/apps/options/second_order.hpp"

#include <algorithm>

#include "asterism/mesh/io/write_mesh.hpp"
#include "asterism/mesh/pipeline/curved_sides.hpp"

namespace asterism::apps {
namespace fs = std::filesystem;
namespace {

bool can_hold(const fs::path& output) {
  const auto format = mesh_format_of(output);
  return format && holds_second_order(format.value());
}

// Skips pictures and pages, which show straight sides for every mesh.
bool is_drawn(const fs::path& output) {
  const auto format = mesh_format_of(output);
  return format && (is_picture(format.value()) || format.value() == mesh_format::html);
}

}  // namespace

CLI::Option* add_order_option(CLI::App& app, int& order) {
  return app
      .add_option("--order", order,
                  "1 (default): triangles with straight sides; 2: of second order, in .msh, .msh2 "
                  "and .vtu, with nodes of sides on the domain's curves, and proved to fold "
                  "nowhere")
      ->check(CLI::IsMember({1, 2}))
      ->type_name("ORDER");
}

std::optional<error> check_order(int order, const std::vector<fs::path>& outputs) {
  if (order == 1 || std::any_of(outputs.begin(), outputs.end(), can_hold)) return std::nullopt;
  return error{"--order 2: " + outputs.front().string() +
                   " has no place for triangles of second order; .msh, .msh2 and .vtu have",
               error_code::bad_option};
}

std::vector<std::string> notes_of_order(const std::vector<fs::path>& outputs,
                                        const second_order_report& report) {
  std::vector<std::string> notes;
  for (const fs::path& output : outputs)
    if (!can_hold(output) && !is_drawn(output))
      notes.push_back(output.string() +
                      ": triangles of second order have no place in it and have straight sides");
  const std::string kept = note_of_straight_sides(report);
  if (!kept.empty()) notes.push_back(kept);
  return notes;
}

}  // namespace asterism::apps
