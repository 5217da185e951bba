// SPDX-License-Identifier: MIT
#include "asterism/apps/commands/surface_command.hpp"

#include <chrono>
#include <filesystem>
#include <iostream>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "asterism/apps/base/complain.hpp"
#include "asterism/apps/base/notes.hpp"
#include "asterism/apps/options/option_values.hpp"
#include "asterism/apps/options/thread_limit.hpp"
#include "asterism/apps/run/held_signals.hpp"
#include "asterism/apps/run/places.hpp"
#include "asterism/apps/run/run_limits.hpp"
#include "asterism/apps/text/summary.hpp"
#include "asterism/apps/text/surface_summary.hpp"
#include "asterism/apps/verify/surface_input.hpp"
#include "asterism/mesh/draw/picture.hpp"
#include "asterism/mesh/draw/space_page.hpp"
#include "asterism/mesh/draw/space_picture.hpp"
#include "asterism/mesh/io/file_ending.hpp"
#include "asterism/mesh/io/file_output.hpp"
#include "asterism/mesh/support/one_line.hpp"
#include "asterism/mesh/surface/surface_mesher.hpp"
#include "asterism/mesh/surface/unit_patches.hpp"
#include "asterism/mesh/surface_audit/shell_triangles.hpp"
#include "asterism/mesh/surface_io/shell_certificate.hpp"
#include "asterism/mesh/surface_io/space_mesh_writer.hpp"

namespace asterism::apps {
using namespace internal;
namespace fs = std::filesystem;
namespace {

struct surface_job {
  std::string of;
  surface_mesh_options how;
  bool no_crossings = false;
  std::vector<fs::path> outputs;
  fs::path certificate;
  std::optional<double> max_seconds;
  std::size_t threads = 0;
  bool quiet = false, json = false;
};

constexpr const char* examples =
    R"(Meshes a surface in space by triangles that are within D of it and it within D of them, and proves it:
patch by patch in the plane of the parameters, in the metric of the curvature, lifted and judged in
space. SURFACE is a .json file of Bezier, B-spline or NURBS patches, or a name: torus, wing, teapot,
saddle, octant. Beside a .mesh file its certificate NAME.certificate.json is written, from which
`asterism verify NAME.mesh` proves it all again.

Exit status: 0 certified; 1 not (what there is is written, and says so); 2 bad usage or input, nothing
is written.

Examples:
  asterism surface torus --chord 0.003 -o torus.obj
  asterism surface hull.json --chord 1e-3 --normal 10 -o hull.mesh -o hull.stl
  asterism surface teapot --chord 0.03 -o teapot.png)";

std::optional<picture_format> picture_format_of(const fs::path& path) {
  const std::string name = path.string();
  if (has_ending(name, ".svg")) return picture_format::svg;
  if (has_ending(name, ".png")) return picture_format::png;
  if (has_ending(name, ".pdf")) return picture_format::pdf;
  return std::nullopt;
}

std::optional<error> check_files(const surface_job& job) {
  std::vector<fs::path> used = job.outputs;
  if (!job.certificate.empty()) used.push_back(job.certificate);
  for (const fs::path& path : used)
    if (auto place = check_writable(path); !place) return place.failure();
  for (const fs::path& path : job.outputs) {
    if (has_ending(path.string(), ".html")) continue;
    if (picture_format_of(path)) {
      if (const auto missing = missing_for_pictures()) return missing->at(path.string());
      continue;
    }
    const auto text = space_mesh_text({}, path.string());
    if (!text) return error{text.failure().message + "; .html is a page to turn it on"};
  }
  std::vector<fs::path> read;
  if (has_ending(job.of, ".json")) read.emplace_back(job.of);
  return check_distinct(read, used);
}

bool is_certified(const shell_certificate& claim) {
  return claim.report.certified && claim.complete;
}

std::string command_of_proof(const surface_job& job) {
  for (const fs::path& path : job.outputs)
    if (has_ending(path.string(), ".mesh")) return "asterism verify " + path.filename().string();
  return "";
}

result<std::string> page_of(const surface_job& job, const space_mesh& mesh,
                            const shell_certificate& claim) {
  space_page_facts facts;
  facts.title = fs::path(job.of).stem().string();
  facts.certified = is_certified(claim);
  facts.verdict = text_of(claim.report, claim.asked);
  if (!claim.report.findings.empty()) facts.verdict = claim.report.findings[0];
  if (!claim.complete) facts.verdict = claim.reason;
  facts.table = table_of(claim.report, claim.asked);
  facts.repeat = command_of_proof(job);
  return space_page(mesh, facts);
}

// Lists the files that the run wrote, in the words of the other commands.
void tell_files(const surface_job& job, std::chrono::steady_clock::time_point start) {
  if (job.json || job.quiet) return;
  std::vector<fs::path> files = job.outputs;
  if (!job.certificate.empty()) files.push_back(job.certificate);
  write_files_written(std::cout, files, start);
}

result<std::vector<output_file>> files_of(const surface_job& job, const space_mesh& mesh,
                                          const shell_certificate& claim) {
  std::vector<output_file> files;
  for (const fs::path& path : job.outputs) {
    const auto picture = picture_format_of(path);
    auto text = picture                              ? draw_space_picture(mesh, *picture)
                : has_ending(path.string(), ".html") ? page_of(job, mesh, claim)
                                                     : space_mesh_text(mesh, path.string());
    if (!text) return text.failure();
    files.push_back({path, std::move(text).value()});
  }
  if (!job.certificate.empty()) files.push_back({job.certificate, shell_certificate_text(claim)});
  return files;
}

void tell(const surface_job& job, const shell_certificate& claim, int status) {
  if (job.json) {
    std::cout << json_of(claim.report, claim.asked, claim.complete, claim.reason, status);
    return;
  }
  if (job.quiet) return;
  if (!claim.complete) std::cout << "not reached: " << one_line(claim.reason) << '\n';
  for (const std::string& finding : claim.report.findings) std::cout << one_line(finding) << '\n';
  std::cout << (status == done ? in_colour("certified", ink::green, 1) + ": "
                               : in_colour("not certified", ink::yellow, 1) + ": ")
            << text_of(claim.report, claim.asked) << '\n';
}

int run_surface(surface_job job) {
  const auto start = std::chrono::steady_clock::now();
  const thread_limit threads(job.threads);
  for (const fs::path& path : job.outputs)
    if (job.certificate.empty() && has_ending(path.string(), ".mesh"))
      job.certificate = fs::path(path).replace_extension(".certificate.json");
  if (const auto failed = check_files(job)) return complain(*failed, refused);
  auto found = find_surface(job.of);
  if (!found) return complain(found.failure(), refused);
  surface of = with_unit_patches(std::move(found).value());
  if (auto refusal = say_notes(of.notes, {job.quiet, false})) return complain(*refusal, refused);
  run_limits limits(job.max_seconds, std::nullopt);
  job.how.stop = [&limits] { return limits.reason(); };
  auto made = make_surface_mesh(of, job.how);
  if (!made) return complain(made.failure().at(job.of), refused);
  shell_certificate claim;
  if (auto refusal = say_notes(made.value().notes, {job.quiet, false}))
    return complain(*refusal, refused);
  claim.asked = {job.how.chord, made.value().angle_bound, job.no_crossings};
  claim.shell = std::move(made.value().shell);
  claim.complete = made.value().complete;
  claim.reason = made.value().reason;
  auto report = audit_shell(of, claim.shell, claim.asked);
  if (!report) return complain(report.failure().at(job.of), not_reached);
  limits.conclude();
  claim.report = std::move(report).value();
  claim.of = std::move(of);
  const space_mesh mesh = mesh_of(claim.shell, triangles_of(claim.shell));
  if (mesh.triangles.empty())
    return complain(
        error{job.of + ": " + claim.reason + ", and there is no triangle yet; nothing is written"},
        not_reached);
  const held_signals held;
  auto files = files_of(job, mesh, claim);
  if (!files) return complain(files.failure(), refused);
  const auto written = write_files(files.value());
  if (!written) return complain(written.failure(), not_reached);
  const int status = is_certified(claim) ? done : not_reached;
  tell(job, claim, status);
  tell_files(job, start);
  return status;
}

void add_sizes(CLI::App& app, surface_job& job) {
  add_real(
      app, "--chord", positive_reals, [&job](double x) { job.how.chord = x; },
      "The greatest distance, of the surface from the mesh and of the mesh from the surface")
      ->type_name("D")
      ->required();
  add_real(
      app, "--normal", {0, 90, false, true, "above 0, at most 90 degrees"},
      [&job](double x) { job.how.normal = x; }, "How far the normal may turn along an edge, about")
      ->type_name("DEG");
  add_real(
      app, "--hmax", sizes, [&job](double x) { job.how.longest = x; },
      "About the longest edge in space")
      ->type_name("H");
  add_real(
      app, "--aspect", {1, 1e6, true, true, "from 1 to 1e6"},
      [&job](double x) { job.how.aspect = x; },
      "The greatest ratio of lengths that triangles may have where the curvature wants one "
      "(default 100)")
      ->type_name("A");
  add_count(
      app, "--vertices", 4, 10'000'000,
      [&job](std::uint64_t n) { job.how.vertices = static_cast<std::size_t>(n); },
      "About so many vertices, at any distance; the distance is then compared with D")
      ->type_name("N");
  add_real(
      app, "--angle-bound", angle_bounds,
      [&job](double x) { job.how.angle_bound = x, job.how.keeps_angle_bound = true; },
      "Least angle of the plane meshes, in their metrics (default: 20, or none where faces cannot "
      "agree with it how to divide their common sides)")
      ->type_name("DEG");
}

}  // namespace

void add_surface_command(CLI::App& program, command& chosen) {
  auto* const app = program.add_subcommand("surface", "Mesh a surface in space, certified");
  const auto job = std::make_shared<surface_job>();
  app->add_option("SURFACE", job->of, "A .json file of patches, or a built-in surface")->required();
  add_sizes(*app, *job);
  app->add_flag(
      "--no-crossings", job->no_crossings,
      "Prove also that no two triangles cross, or touch outside of common vertices and edges");
  app->add_option("-o,--output", job->outputs,
                  "File to write: .obj, .stl, .ply, .mesh, .msh, .vtu; .html, a page that shows it "
                  "in space; "
                  ".png, .svg, .pdf, a picture; may be given again")
      ->required()
      ->type_name("OUT");
  app->add_option("--certificate", job->certificate, "File for the certificate")->type_name("FILE");
  add_seconds_option(*app, job->max_seconds,
                     "Meshing ends after this time; the mesh so far is judged and written");
  add_threads_option(*app, job->threads, "the mesh is");
  add_summary_flags(*app, job->quiet, job->json, "No summary");
  app->footer(examples);
  app->callback([job, &chosen] { chosen = [job] { return run_surface(*job); }; });
}

}  // namespace asterism::apps
