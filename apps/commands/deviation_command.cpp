// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <iostream>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>

#include "asterism/apps/base/commands.hpp"
#include "asterism/apps/base/complain.hpp"
#include "asterism/apps/base/notes.hpp"
#include "asterism/apps/options/option_values.hpp"
#include "asterism/apps/options/thread_limit.hpp"
#include "asterism/apps/verify/surface_input.hpp"
#include "asterism/mesh/surface_audit/deviation.hpp"
#include "asterism/mesh/surface_io/space_mesh_reader.hpp"

namespace asterism::apps {
using namespace internal;
namespace {

struct deviation_job {
  std::string mesh, of;
  std::optional<double> at_most;
  std::size_t threads = 0;
  double width = 0.01;
  bool json = false;
};

constexpr const char* deviation_examples =
    R"(Encloses two distances: the greatest of a point of the mesh from the surface, and the greatest of a
point of the surface from the mesh. Each is proved to be in [low, high]: the upper ends by control
points in intervals, the lower by a witness, a point that is farther than low from all of the other.
SURFACE is a .json file of Bezier, B-spline or NURBS patches, or a name: torus, octant, saddle, wing.

Exit status: 0 done, and neither beyond D; 1 one is beyond D, or it could not be decided; 2 bad usage
or input.

Examples:
  asterism deviation part.stl part.json
  asterism deviation torus.obj torus --at-most 0.01)";

enum class verdict { unasked, within, beyond, undecided };

verdict judge(const deviation_report& report, const std::optional<double>& at_most) {
  if (!at_most) return verdict::unasked;
  const auto& a = report.from_mesh;
  const auto& b = report.from_surface;
  if (a.low > *at_most || b.low > *at_most) return verdict::beyond;
  return a.high <= *at_most && b.high <= *at_most ? verdict::within : verdict::undecided;
}

std::string witness_text(const deviation_witness& w, const surface& of) {
  const std::string at = fmt::format("({:.9g}, {:.9g}, {:.9g})", w.at.x, w.at.y, w.at.z);
  if (w.on_mesh) return fmt::format("{} in triangle {}", at, w.of + 1);
  const std::string& name = of.patches[w.of].name;
  return fmt::format("{} at u = {:.9g}, v = {:.9g} of patch {}{}", at, w.first, w.second, w.of + 1,
                     name.empty() ? "" : " (" + name + ")");
}

void write_lines(const deviation_report& report, const surface& of,
                 const std::optional<double>& at_most) {
  const auto line = [&](const char* what, const one_sided_distance& d) {
    std::cout << fmt::format("{}: from {:.6g} to {:.6g}, witness {}{}\n", what, d.low, d.high,
                             witness_text(d.witness, of),
                             d.narrowed ? "" : "; not narrowed as far as asked for");
  };
  line("mesh to surface", report.from_mesh);
  line("surface to mesh", report.from_surface);
  switch (judge(report, at_most)) {
    case verdict::unasked:
      break;
    case verdict::within:
      std::cout << fmt::format("within {:.9g}: proved\n", *at_most);
      break;
    case verdict::beyond:
      std::cout << fmt::format("REFUSED: farther than {:.9g}\n", *at_most);
      break;
    case verdict::undecided:
      std::cout << fmt::format("undecided: {:.9g} is inside an enclosure\n", *at_most);
      break;
  }
}

nlohmann::ordered_json json_of(const one_sided_distance& d) {
  nlohmann::ordered_json at = {{"x", d.witness.at.x}, {"y", d.witness.at.y}, {"z", d.witness.at.z}};
  at[d.witness.on_mesh ? "triangle" : "patch"] = d.witness.of + 1;
  at[d.witness.on_mesh ? "s" : "u"] = d.witness.first;
  at[d.witness.on_mesh ? "t" : "v"] = d.witness.second;
  return {{"low", d.low}, {"high", d.high}, {"witness", at}, {"narrowed", d.narrowed}};
}

void write_json(const deviation_job& job, const deviation_report& report) {
  constexpr const char* words[] = {"not asked for", "within", "beyond", "undecided"};
  nlohmann::ordered_json object = {{"mesh", job.mesh},
                                   {"surface", job.of},
                                   {"mesh_to_surface", json_of(report.from_mesh)},
                                   {"surface_to_mesh", json_of(report.from_surface)}};
  if (job.at_most) object["at_most"] = *job.at_most;
  object["verdict"] = words[static_cast<std::size_t>(judge(report, job.at_most))];
  std::cout << object.dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace) << '\n';
}

// Refuses a mesh in the place of the surface: only its file's name shows that.
std::optional<error> check_order_of_names(const deviation_job& job) {
  if (!internal::is_space_mesh_file(job.of) || internal::is_space_mesh_file(job.mesh))
    return std::nullopt;
  return error{job.of + ": is a mesh by its name, and the surface comes last: 'asterism " +
               "deviation MESH SURFACE'"};
}

int run_deviation(const deviation_job& job) {
  const thread_limit threads(job.threads);
  if (auto failed = check_order_of_names(job)) return complain(*failed, refused);
  const auto of = find_surface(job.of);
  if (!of) return complain(of.failure(), refused);
  const auto mesh = read_space_mesh(job.mesh);
  if (!mesh) return complain(mesh.failure(), refused);
  if (auto refusal = say_notes(mesh.value().notes, {})) return complain(*refusal, refused);
  deviation_options options;
  options.at_most = job.at_most;
  options.relative_width = job.width;
  const auto report = deviation(mesh.value(), of.value(), options);
  if (!report)
    return complain(
        report.failure().at(report.failure().code == error_code::invalid_mesh ? job.mesh : job.of),
        refused);
  if (job.json)
    write_json(job, report.value());
  else
    write_lines(report.value(), of.value(), job.at_most);
  const verdict end = judge(report.value(), job.at_most);
  return end == verdict::unasked || end == verdict::within ? done : not_reached;
}

}  // namespace

void add_deviation_command(CLI::App& program, command& chosen) {
  auto* const app = program.add_subcommand(
      "deviation", "Enclose how far a mesh in space is from a surface, both ways");
  const auto job = std::make_shared<deviation_job>();
  app->add_option("MESH", job->mesh, "Triangles in space: .obj, .stl, .ply, .mesh, .msh or .vtu")
      ->required();
  app->add_option("SURFACE", job->of, "A .json file of patches, or a built-in surface")->required();
  add_real(
      *app, "--at-most", positive_reals, [job](double x) { job->at_most = x; },
      "Prove both distances to be at most this, or refuse")
      ->type_name("D");
  add_real(
      *app, "--width", {1e-6, 1, true, true, "from 1e-6 to 1"}, [job](double x) { job->width = x; },
      "How wide the enclosures may be, as a share (default 0.01)")
      ->type_name("W");
  add_threads_option(*app, job->threads, "the answer is");
  app->add_flag("--json", job->json, "The answer as a JSON object, in place of lines");
  app->footer(deviation_examples);
  app->callback([job, &chosen] { chosen = [job] { return run_deviation(*job); }; });
}

}  // namespace asterism::apps
