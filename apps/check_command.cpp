// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <filesystem>
#include <fstream>
#include <iostream>
#include <iterator>
#include <memory>
#include <optional>
#include <string>

#include "asterism/apps/commands.hpp"
#include "asterism/apps/complain.hpp"
#include "asterism/apps/option_values.hpp"
#include "asterism/mesh/io/file_ending.hpp"
#include "asterism/mesh/io/load_domain.hpp"
#include "asterism/mesh/io/medit.hpp"
#include "asterism/mesh/proof/check_proof.hpp"
#include "asterism/mesh/proof/proof_reader.hpp"

namespace asterism::apps {
using namespace internal;
namespace fs = std::filesystem;
namespace {

constexpr const char* check_examples =
    R"(Checks the proof that --proof wrote beside a mesh: that MESH triangulates the domain D, that no
angle is below B degrees but the domain's own, and that its triangles are the stars of its vertices
in the metric SOL. All of the question is in the arguments; PROOF holds witnesses, and nothing in it
is believed. tools/check_mesh.py does the same in Python, from the files alone.

Exit status: 0 proved; 1 not proved, with the reason; 2 a question or a file of which nothing can be
said: curves, domains that are no .poly file, a metric that is not given at the vertices.

Examples:
  asterism check plate.mesh plate.proof --domain plate.poly --angle-bound 20 --metric plate.sol)";

struct check_options {
  fs::path mesh, proof;
  std::string domain, metric;
  double angle_bound = 0;
  std::string metric_tolerance;
};

// Returns why the question cannot be asked yet.
std::optional<error> check_kind(const check_options& options) {
  if (!options.metric_tolerance.empty())
    return error{"--metric-tolerance cannot be checked yet", error_code::bad_option};
  if (!has_ending(options.metric, ".sol"))
    return error{
        options.metric + ": only a .sol file with a tensor at each vertex can be checked yet",
        error_code::bad_option};
  if (!has_ending(options.mesh.string(), ".mesh"))
    return error{options.mesh.string() + ": only .mesh files can be checked yet",
                 error_code::bad_option};
  if (!options.domain.empty() && !has_ending(options.domain, ".poly"))
    return error{options.domain + ": only .poly files can be checked yet", error_code::bad_option};
  return std::nullopt;
}

result<std::string> bytes_of_file(const fs::path& path) {
  std::ifstream file(path, std::ios::binary);
  std::string bytes{std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
  if (!file.good() && !file.eof())
    return error{path.string() + ": cannot be read", error_code::unreadable_file};
  return bytes;
}

result<std::optional<domain>> read_shape(const check_options& options) {
  if (options.domain.empty()) return std::optional<domain>();
  auto read = load_domain(options.domain);
  if (!read) return read.failure();
  if (!read.value().curves.empty())
    return error{options.domain + ": curves cannot be checked yet", error_code::invalid_domain};
  return std::optional<domain>(std::move(read).value());
}

int refuse(const error& why) {
  std::cout << "NOT proved: " << why.message << '\n';
  return not_reached;
}

int run_check(const check_options& options) {
  if (const auto failure = check_kind(options)) return complain(*failure, refused);
  medit_read_options how;
  how.solution = options.metric;
  how.all_edges = true;
  const auto subject = read_medit(options.mesh, how);
  if (!subject) return complain(subject.failure(), refused);
  const auto shape = read_shape(options);
  if (!shape) return complain(shape.failure(), refused);
  const auto bytes = bytes_of_file(options.proof);
  if (!bytes) return complain(bytes.failure(), refused);
  const auto proof = read_proof(bytes.value(), subject.value());
  if (!proof) return refuse(proof.failure());
  const proof_question asked{subject.value(), shape.value() ? &*shape.value() : nullptr,
                             options.angle_bound};
  if (const auto failure = check_proof(asked, proof.value())) return refuse(*failure);
  std::cout << fmt::format(
      "proved: {} sites, {} triangles, no angle below {:g} degrees but the domain's own; domain "
      "{}; "
      "metric {}\n",
      subject.value().sites.size(), subject.value().triangles.size(), options.angle_bound,
      options.domain.empty() ? "as the boundary encloses it" : options.domain, options.metric);
  return done;
}

}  // namespace

void add_check_command(CLI::App& program, command& chosen) {
  auto* const app = program.add_subcommand("check", "Check the proof of a mesh");
  const auto options = std::make_shared<check_options>();
  app->add_option("MESH", options->mesh, "The mesh, in Medit's format")->required();
  app->add_option("PROOF", options->proof, "Its proof, as --proof wrote it")->required();
  app->add_option("--domain", options->domain,
                  "A .poly file (default: what the mesh's boundary encloses)")
      ->type_name("D");
  add_real(
      *app, "--angle-bound", angle_bounds, [options](double x) { options->angle_bound = x; },
      "Least angle, in degrees")
      ->type_name("B")
      ->required();
  app->add_option("--metric", options->metric, "A .sol file with a tensor at each vertex")
      ->type_name("SOL")
      ->required();
  app->add_option("--metric-tolerance", options->metric_tolerance, "Cannot be checked yet")
      ->type_name("T");
  app->footer(check_examples);
  app->callback([options, &chosen] { chosen = [options] { return run_check(*options); }; });
}

}  // namespace asterism::apps
