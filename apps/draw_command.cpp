// SPDX-License-Identifier: MIT
#include <filesystem>
#include <iostream>
#include <memory>
#include <string>

#include "asterism/apps/commands.hpp"
#include "asterism/apps/complain.hpp"
#include "asterism/apps/option_values.hpp"
#include "asterism/mesh/io/medit.hpp"
#include "asterism/mesh/io/write_mesh.hpp"

namespace asterism::apps {
namespace {

struct draw_options {
  std::filesystem::path mesh, picture;
  picture_options style;
};

constexpr const char* examples =
    R"(MESH is a Medit file NAME.mesh; its metric is read from NAME.sol, which may be missing when no
ellipses are asked for. PICTURE ends in .svg, .png or .pdf.

Examples:
  asterism draw swirl.mesh -o swirl.png --width 2000
  asterism draw swirl.mesh -o swirl.pdf --ellipses --no-sites)";

int run_draw(const draw_options& options) {
  const auto format = check_output(options.picture);
  if (!format) return complain(format.failure(), refused);
  if (format.value() == mesh_format::medit || format.value() == mesh_format::vtu)
    return complain({options.picture.string() + ": not a picture; use .svg, .png or .pdf"},
                    refused);
  const auto drawn =
      read_medit(options.mesh, {.identity_without_solution = !options.style.ellipses});
  if (!drawn) return complain(drawn.failure(), refused);
  const auto written = write_mesh(options.picture, drawn.value(), {.picture = options.style});
  return written ? done : complain(written.failure(), refused);
}

}  // namespace

void add_draw_command(CLI::App& program, command& chosen) {
  auto* const app = program.add_subcommand("draw", "Draw a mesh");
  const auto options = std::make_shared<draw_options>();
  app->add_option("MESH", options->mesh, "What to draw")->required();
  app->add_option("-o,--output", options->picture, "File to write")
      ->required()
      ->type_name("PICTURE");
  app->add_flag("--ellipses", options->style.ellipses, "Draw the metric");
  app->add_flag_callback(
      "--no-sites", [options] { options->style.sites = false; }, "No dots");
  add_count(
      *app, "--width", 16, 20000,
      [options](std::uint64_t n) { options->style.width = static_cast<int>(n); },
      "In pixels, or points (default 1000)")
      ->type_name("N");
  app->footer(examples);
  app->callback([options, &chosen] { chosen = [options] { return run_draw(*options); }; });
}

}  // namespace asterism::apps
