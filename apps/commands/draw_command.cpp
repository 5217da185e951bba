// SPDX-License-Identifier: MIT
#include <algorithm>
#include <chrono>
#include <filesystem>
#include <iostream>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "asterism/apps/base/commands.hpp"
#include "asterism/apps/base/complain.hpp"
#include "asterism/apps/commands/drawn_things.hpp"
#include "asterism/apps/options/option_values.hpp"
#include "asterism/apps/run/held_signals.hpp"
#include "asterism/apps/text/page_facts.hpp"
#include "asterism/apps/text/summary.hpp"
#include "asterism/mesh/audit/certificate.hpp"
#include "asterism/mesh/io/render_mesh.hpp"
#include "asterism/mesh/io/write_mesh.hpp"

namespace asterism::apps {
namespace fs = std::filesystem;
namespace {

struct draw_options {
  std::vector<std::string> things;  // meshes or domains
  std::vector<fs::path> solutions;  // of the meshes, in their order
  fs::path picture;
  fs::path certificate;  // of a page; default: NAME.certificate.json, if it is there
  std::string colours;   // what they tell; empty: nothing
  picture_options style;
  bool has_style = false;  // width, dots or ellipses are wanted
  bool quiet = false;
};

constexpr const char* draw_examples =
    R"(THING is a mesh in any format that is read, or a domain: .poly, .node, .geojson, .json, .wkt, or a
built-in name; a domain is drawn as it is written, faults and all. PICTURE ends in .svg, .png or .pdf;
or in .html: a page that works offline, with the mesh to move in, histograms, the solution as colour,
and what its certificate (default: NAME.certificate.json beside the mesh, if it is there) says. A page
shows several things, the rounds of a loop say, by buttons or a slider; its numbers are the last one's.

--colour-by takes angle (of the plane, where there is no metric), aspect, size, region, marker, or the
name of a scalar field of the mesh's file or of --solution; a legend says which colour is what.

Exit status: 0 drawn; 1 the picture could not be written; 2 bad usage or input.

Examples:
  asterism draw swirl.mesh -o swirl.png --width 2000
  asterism draw swirl.mesh -o swirl.pdf --ellipses --no-sites
  asterism draw part.poly -o part.svg --colour-by marker
  asterism draw swirl.mesh -o swirl.html
  asterism draw round1.vtu round2.vtu round3.vtu -o rounds.html)";

const std::map<std::string, picture_by> known_colours = {{"angle", picture_by::angle},
                                                         {"aspect", picture_by::aspect},
                                                         {"size", picture_by::size},
                                                         {"region", picture_by::region},
                                                         {"marker", picture_by::marker}};

// Collects the facts for a page about the mesh: with a certificate its claims, not proved again
// here.
result<report_facts> facts_of_page(const draw_options& options, const std::string& thing) {
  report_facts facts;
  facts.title = thing;
  fs::path path = options.certificate;
  if (path.empty()) path = fs::path(thing).replace_extension(".certificate.json");
  if (options.certificate.empty() && !fs::exists(path)) {
    facts.repeat = is_drawn_as_domain(thing) ? shell_words({"asterism", "info", thing})
                                             : shell_words({"asterism", "certify", thing});
    return facts;
  }
  auto claim = read_certificate(path);
  if (!claim) return claim.failure();
  facts.claim = std::move(claim).value();
  facts.claim_from = "As " + path.string() + " says, which this page did not prove again.";
  facts.repeat = repeating_command({thing}, path);
  return facts;
}

// Finds the kind of picture by its name, and checks whether it can be written there.
result<mesh_format> picture_format(const fs::path& picture) {
  const auto format = mesh_format_of(picture);
  if (format && (is_picture(format.value()) || format.value() == mesh_format::html))
    return check_output(picture);
  return error{picture.string() +
               ": not a picture; use .svg, .png, .pdf or .html, or convert for a mesh in another "
               "format"};
}

// Refuses options that contradict each other, before any file is read.
std::optional<error> check(const draw_options& options, mesh_format format) {
  const bool is_page = format == mesh_format::html;
  if (!is_page && !options.certificate.empty())
    return error{"--certificate: goes with a page, -o NAME.html"};
  if (!is_page && options.things.size() > 1)
    return error{options.things[1] +
                 ": a picture shows one mesh; a page, -o NAME.html, shows several"};
  if (is_page && !options.colours.empty())
    return error{"--colour-by: a page has all colours, to choose from"};
  if (is_page && options.has_style)
    return error{
        "--width, --ellipses and --no-sites are of pictures, -o NAME.png; a page fits its window "
        "and shows ellipses by a button"};
  if (!options.solutions.empty() && options.solutions.size() != options.things.size())
    return error{"--solution: there are " + std::to_string(options.solutions.size()) +
                 " of them, and " + std::to_string(options.things.size()) +
                 " meshes; give one for each, in the same order"};
  return std::nullopt;
}

result<std::vector<drawn_thing>> read_things(const draw_options& options) {
  std::vector<drawn_thing> read;
  for (std::size_t i = 0; i < options.things.size(); ++i) {
    auto one = read_drawn(options.things[i],
                          options.solutions.empty() ? fs::path() : options.solutions[i]);
    if (!one) return one.failure();
    read.push_back(std::move(one).value());
  }
  return read;
}

std::string listed(const solution& fields) {
  std::string names;
  for (const solution_field& field : fields.fields)
    names += (names.empty() ? "" : ", ") + field.name;
  return names.empty() ? "and there are no fields" : "and fields: " + names;
}

// Takes the value of --colour: one of the known words, or the name of a scalar field.
std::optional<error> take_colours(const draw_options& options, const drawn_thing& thing,
                                  picture_options& style) {
  if (options.colours.empty()) return std::nullopt;
  const auto field =
      std::find_if(thing.fields.fields.begin(), thing.fields.fields.end(),
                   [&](const solution_field& f) { return f.name == options.colours; });
  if (field != thing.fields.fields.end()) {
    style.colours = picture_by::field;
    style.field = *field;
    if (field->kind == field_kind::scalar) return std::nullopt;
    return error{"--colour-by " + options.colours +
                 ": is no scalar; a page, -o NAME.html, shows its length and components"};
  }
  const auto known = known_colours.find(options.colours);
  if (known == known_colours.end())
    return error{"--colour-by " + options.colours +
                 ": there are angle, aspect, size, region, marker, " + listed(thing.fields)};
  style.colours = known->second;
  if (style.colours != picture_by::marker && thing.content.triangles.empty())
    return error{"--colour-by " + options.colours + ": " + options.things[0] +
                 " is a domain, without triangles; there is marker"};
  if (style.colours == picture_by::marker && thing.content.boundary.empty())
    return error{"--colour-by marker: " + options.things[0] + " has no edges with markers"};
  return std::nullopt;
}

// Puts all meshes onto the page: the page describes the last one, and shows the others as earlier
// states.
result<report_facts> facts_of_things(const draw_options& options,
                                     std::vector<drawn_thing>& things) {
  auto facts = facts_of_page(options, options.things.back());
  if (!facts) return facts;
  drawn_thing& own = things.back();
  facts.value().label = fs::path(options.things.back()).stem().string();
  facts.value().fields = std::move(own.fields);
  if (!own.has_metric && !own.content.triangles.empty() && facts.value().claim_from.empty())
    facts.value().claim_from =
        "There is no metric with the mesh: angles and lengths are those of the plane.";
  for (std::size_t i = 0; i + 1 < things.size(); ++i)
    facts.value().before.push_back({fs::path(options.things[i]).stem().string(),
                                    std::move(things[i].content),
                                    std::move(things[i].fields),
                                    {}});
  return facts;
}

int run_draw(const draw_options& options) {
  const auto start = std::chrono::steady_clock::now();
  const auto format = picture_format(options.picture);
  if (!format) return complain(format.failure(), refused);
  if (const auto failed = check(options, format.value())) return complain(*failed, refused);
  auto things = read_things(options);
  if (!things) return complain(things.failure(), refused);
  write_options how{.picture = options.style};
  drawn_thing& shown = things.value().back();
  if (format.value() == mesh_format::html) {
    auto facts = facts_of_things(options, things.value());
    if (!facts) return complain(facts.failure(), refused);
    how.report = std::move(facts).value();
  } else if (const auto failed = take_colours(options, shown, how.picture)) {
    return complain(*failed, refused);
  }
  if (options.style.ellipses && !shown.has_metric)
    return complain({"--ellipses: there is no metric with " + options.things.back()}, refused);
  const auto rendered = internal::render_mesh(options.picture, shown.content, how);
  if (!rendered) return complain(rendered.failure(), not_reached);
  const held_signals held;
  const auto written = internal::write_files(rendered.value());
  if (!written) return complain(written.failure(), not_reached);
  if (!options.quiet) write_files_written(std::cout, {options.picture}, start);
  return done;
}

}  // namespace

void add_draw_command(CLI::App& program, command& chosen) {
  auto* const app = program.add_subcommand("draw", "Draw a mesh or a domain");
  const auto options = std::make_shared<draw_options>();
  app->add_option("THING", options->things, "Mesh or domain to draw; several for a page")
      ->required();
  app->add_option("-o,--output", options->picture, "File to write")
      ->required()
      ->type_name("PICTURE");
  app->add_option("--certificate", options->certificate, "What a page says of the mesh")
      ->type_name("FILE");
  app->add_option("--solution", options->solutions,
                  "Fields on the mesh, from another file; one for each mesh")
      ->type_name("SOL")
      ->allow_extra_args(false);
  app->add_option("--colour-by", options->colours, "Quantity that the colours show, with a legend")
      ->type_name("WHAT");
  app->add_option("--color-by", options->colours)->type_name("WHAT")->group("");
  app->add_flag("--ellipses", options->style.ellipses, "Draw the metric");
  app->add_flag_callback(
      "--no-sites", [options] { options->style.sites = false; },
      "No dots at sites; a mesh of more than 300 has none");
  add_count(
      *app, "--width", 16, 20000,
      [options](std::uint64_t n) { options->style.width = static_cast<int>(n); },
      "In pixels, or points (default 1000)")
      ->type_name("N");
  app->add_flag("--quiet", options->quiet, "No names of files");
  app->footer(draw_examples);
  app->callback([app, options, &chosen] {
    for (const char* const name : {"--width", "--ellipses", "--no-sites"})
      options->has_style = options->has_style || app->count(name) > 0;
    chosen = [options] { return run_draw(*options); };
  });
}

}  // namespace asterism::apps
