// SPDX-License-Identifier: MIT
#include <filesystem>
#include <iostream>
#include <memory>
#include <string>

#include "asterism/apps/commands.hpp"
#include "asterism/apps/complain.hpp"
#include "asterism/apps/held_signals.hpp"
#include "asterism/apps/notes.hpp"
#include "asterism/apps/option_values.hpp"
#include "asterism/apps/page_facts.hpp"
#include "asterism/mesh/audit/certificate.hpp"
#include "asterism/mesh/io/read_mesh.hpp"
#include "asterism/mesh/io/render_mesh.hpp"
#include "asterism/mesh/io/write_mesh.hpp"

namespace asterism::apps {
namespace {

struct draw_options {
  std::filesystem::path mesh, picture;
  std::filesystem::path certificate;  // of a page; default: NAME.certificate.json, if it is there
  picture_options style;
};

constexpr const char* draw_examples =
    R"(MESH is a Medit file NAME.mesh; its metric is read from NAME.sol, which may be missing when no
ellipses are asked for. PICTURE ends in .svg, .png or .pdf; or in .html: a page that works offline,
with the mesh to move in, histograms, and what its certificate (default: NAME.certificate.json
beside MESH, if it is there) says.

Exit status: 0 drawn; 1 the picture could not be written; 2 bad usage or input.

Examples:
  asterism draw swirl.mesh -o swirl.png --width 2000
  asterism draw swirl.mesh -o swirl.pdf --ellipses --no-sites
  asterism draw swirl.mesh -o swirl.html)";

// Collects what a page about the mesh says: with a certificate its claims, not proved again here.
result<report_facts> facts_of_page(const draw_options& options) {
  report_facts facts;
  facts.title = options.mesh.string();
  std::filesystem::path path = options.certificate;
  if (path.empty())
    path = std::filesystem::path(options.mesh).replace_extension(".certificate.json");
  if (options.certificate.empty() && !std::filesystem::exists(path)) {
    facts.repeat = shell_words({"asterism", "certify", options.mesh.string()});
    return facts;
  }
  auto claim = read_certificate(path);
  if (!claim) return claim.failure();
  facts.claim = std::move(claim).value();
  facts.claim_from = "As " + path.string() + " says, which this page did not prove again.";
  facts.repeat = repeating_command({options.mesh}, path);
  return facts;
}

bool is_picture(mesh_format format) {
  return format == mesh_format::svg || format == mesh_format::png || format == mesh_format::pdf ||
         format == mesh_format::html;
}

int run_draw(const draw_options& options) {
  const auto format = check_output(options.picture);
  if (!format) return complain(format.failure(), refused);
  if (!is_picture(format.value()))
    return complain(
        {options.picture.string() + ": not a picture; use .svg, .png, .pdf or .html, or certify -o "
                                    "for a mesh in another format"},
        refused);
  write_options how{.picture = options.style};
  const bool is_page = format.value() == mesh_format::html;
  if (is_page) {
    auto facts = facts_of_page(options);
    if (!facts) return complain(facts.failure(), refused);
    how.report = std::move(facts).value();
  } else if (!options.certificate.empty()) {
    return complain({"--certificate: goes with a page, -o NAME.html"}, refused);
  }
  const auto drawn =
      read_mesh(options.mesh, {.identity_without_solution = !options.style.ellipses && !is_page});
  if (!drawn) return complain(drawn.failure(), refused);
  if (const auto failed = say_notes(drawn.value().notes, {})) return complain(*failed, refused);
  const auto rendered = internal::render_mesh(options.picture, drawn.value(), how);
  if (!rendered) return complain(rendered.failure(), not_reached);
  const held_signals held;
  const auto written = internal::write_files(rendered.value());
  return written ? done : complain(written.failure(), not_reached);
}

}  // namespace

void add_draw_command(CLI::App& program, command& chosen) {
  auto* const app = program.add_subcommand("draw", "Draw a mesh");
  const auto options = std::make_shared<draw_options>();
  app->add_option("MESH", options->mesh, "What to draw")->required();
  app->add_option("-o,--output", options->picture, "File to write")
      ->required()
      ->type_name("PICTURE");
  app->add_option("--certificate", options->certificate, "What a page says of the mesh")
      ->type_name("FILE");
  app->add_flag("--ellipses", options->style.ellipses, "Draw the metric");
  app->add_flag_callback(
      "--no-sites", [options] { options->style.sites = false; }, "No dots");
  add_count(
      *app, "--width", 16, 20000,
      [options](std::uint64_t n) { options->style.width = static_cast<int>(n); },
      "In pixels, or points (default 1000)")
      ->type_name("N");
  app->footer(draw_examples);
  app->callback([options, &chosen] { chosen = [options] { return run_draw(*options); }; });
}

}  // namespace asterism::apps
