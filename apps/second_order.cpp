// SPDX-License-Identifier: MIT
#include "asterism/apps/second_order.hpp"

#include <fmt/format.h>

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

// Pictures and pages are drawn of straight sides whatever the mesh is.
bool is_drawn(const fs::path& output) {
  const auto format = mesh_format_of(output);
  return format && (format.value() == mesh_format::svg || format.value() == mesh_format::png ||
                    format.value() == mesh_format::pdf || format.value() == mesh_format::html);
}

std::string refused_text(const second_order_report& report) {
  const bool is_certain = !report.folded.empty();
  const vertex_index first = is_certain ? report.folded.front() : report.undecided.front();
  return fmt::format("; {} folded, {} undecided, the first: triangle {}", report.folded.size(),
                     report.undecided.size(), first + 1);
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

std::string text_of(const second_order_report& report) {
  std::string text = fmt::format(
      "second order: {} triangles, {} curved sides, {} on curves of the "
      "domain",
      report.triangles, report.curved_sides, report.on_curves);
  if (report.kept_straight > 0) text += fmt::format(", {} kept straight", report.kept_straight);
  if (!report.folded.empty() || !report.undecided.empty()) return text + refused_text(report);
  return text + fmt::format(
                    "; no triangle folds, the Jacobian is at least {:.4g} of the straight "
                    "triangle's",
                    report.least_jacobian);
}

}  // namespace asterism::apps
