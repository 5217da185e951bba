// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <filesystem>
#include <iostream>
#include <memory>
#include <optional>
#include <string>
#include <utility>

#include "asterism/apps/base/commands.hpp"
#include "asterism/apps/base/complain.hpp"
#include "asterism/apps/job/plain_question.hpp"
#include "asterism/apps/options/option_values.hpp"
#include "asterism/mesh/io/file_ending.hpp"
#include "asterism/mesh/io/load_domain.hpp"
#include "asterism/mesh/io/medit.hpp"
#include "asterism/mesh/io/other_kind.hpp"
#include "asterism/mesh/io/text_scanner.hpp"
#include "asterism/mesh/proof/check_proof.hpp"
#include "asterism/mesh/proof/check_tolerance.hpp"
#include "asterism/mesh/proof/proof_reader.hpp"
#include "asterism/mesh/support/one_line.hpp"

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
said: a metric that is not given at the vertices.

Of a domain with curves it is proved that the chords of each lead along it from end to end, no point
of a curve farther than --chord-tolerance from its chords, and none of these farther from the curve;
the rest is of the polygon of the chords. A spline is the cubics that 'asterism mesh' makes of it,
with control points in doubles.

A domain that is no .poly file is taken as 'asterism convert' writes it as one. With
--metric-tolerance T the tensors beside MESH, in its own .sol, are those in which the stars are
proved, and SOL has those that were asked for: that no length differs by more than the factor exp(T)
is proved at every vertex.

Examples:
  asterism check plate.mesh plate.proof --domain plate.poly --angle-bound 20 --metric plate.sol
  asterism convert near.mesh asked.mesh --metric 'expr:(x>0)?100:1;0;1' --size 0.5
  asterism check disc.mesh disc.proof --domain disc.poly --chord-tolerance 0.01 --angle-bound 20 \
      --metric disc.sol
  asterism check near.mesh near.proof --angle-bound 20 --metric asked.sol --metric-tolerance 3)";

struct check_options {
  fs::path mesh, proof;
  std::string domain, metric;
  double angle_bound = 0;
  std::optional<double> metric_tolerance, chord_tolerance;
};

// Returns an error if an option names a file of another kind.
std::optional<error> check_kind(const check_options& options) {
  if (!has_ending(options.metric, ".sol"))
    return error{options.metric +
                     ": only a .sol file with a tensor at each vertex can be checked; "
                     "'asterism convert MESH ASKED.mesh --metric METRIC' writes ASKED.sol",
                 error_code::bad_option};
  if (!has_ending(options.mesh.string(), ".mesh"))
    return error{options.mesh.string() +
                     ": only .mesh files can be checked; 'asterism convert' writes one of a mesh" +
                     what_it_is(options.mesh.string()),
                 error_code::bad_option};
  return std::nullopt;
}

result<std::string> bytes_of_proof(const fs::path& path) {
  auto bytes = read_text_file(path);
  if (!bytes)
    return error{bytes.failure().message + "; --proof of 'asterism mesh' writes a proof",
                 bytes.failure().code};
  return bytes;
}

result<std::optional<domain>> read_shape(const check_options& options) {
  if (options.domain.empty()) return std::optional<domain>();
  auto read = has_ending(options.domain, ".poly") ? load_domain(options.domain)
                                                  : plain_domain(options.domain, {});
  if (!read) return read.failure();
  if (!read.value().curves.empty() && !options.chord_tolerance)
    return error{options.domain +
                     " has curves: --chord-tolerance says how far they and the mesh's boundary may "
                     "be from each other",
                 error_code::bad_option};
  return std::optional<domain>(std::move(read).value());
}

int refuse(const error& why) {
  std::cout << "NOT proved: " << one_line(why.message) << '\n';
  return not_reached;
}

// Reads the mesh with the metric of a file; if no file is named, with its own metric.
result<mesh> read_subject(const check_options& options, const fs::path& metric) {
  medit_read_options how;
  how.solution = metric;
  how.all_edges = true;
  return read_medit(options.mesh, how);
}

// Returns the question of the check, without the domain and the metric, which are read later.
result<proof_question> question_of(const check_options& options, const mesh& subject,
                                   const std::optional<domain>& shape) {
  proof_question asked{subject, shape ? &*shape : nullptr, options.angle_bound,
                       options.chord_tolerance.value_or(0)};
  if (!shape || shape->curves.empty()) return asked;
  auto marks = read_medit_marks(options.mesh);
  if (!marks) return marks.failure();
  asked.required = std::move(marks.value().required_vertices);
  return asked;
}

std::string domain_text(const check_options& options, const std::optional<domain>& shape) {
  if (!shape) return "as the boundary encloses it";
  if (shape->curves.empty()) return options.domain;
  return fmt::format("{}, its curves within {:g}", options.domain, *options.chord_tolerance);
}

std::string metric_text(const check_options& options) {
  if (!options.metric_tolerance) return options.metric;
  return fmt::format("{}, within a tolerance of {:g}", options.metric, *options.metric_tolerance);
}

int run_check(const check_options& options) {
  if (const auto failure = check_kind(options)) return complain(*failure, refused);
  const auto wanted = read_subject(options, options.metric);
  if (!wanted) return complain(wanted.failure(), refused);
  const auto subject = options.metric_tolerance ? read_subject(options, {}) : wanted;
  if (!subject) return complain(subject.failure(), refused);
  const auto shape = read_shape(options);
  if (!shape) return complain(shape.failure(), refused);
  const auto bytes = bytes_of_proof(options.proof);
  if (!bytes) return complain(bytes.failure(), refused);
  const auto proof = read_proof(bytes.value(), subject.value());
  if (!proof) return refuse(proof.failure().at(options.proof.string()));
  const auto asked = question_of(options, subject.value(), shape.value());
  if (!asked) return complain(asked.failure(), refused);
  if (const auto failure = check_proof(asked.value(), proof.value())) return refuse(*failure);
  if (options.metric_tolerance)
    if (const auto failure =
            check_tolerance(subject.value(), wanted.value(), *options.metric_tolerance))
      return refuse(*failure);
  std::cout << fmt::format(
      "proved: {} sites, {} triangles, no angle below {:g} degrees but the domain's own; domain "
      "{}; metric {}\n",
      subject.value().sites.size(), subject.value().triangles.size(), options.angle_bound,
      printable(domain_text(options, shape.value())), printable(metric_text(options)));
  return done;
}

}  // namespace

void add_check_command(CLI::App& program, command& chosen) {
  auto* const app = program.add_subcommand("check", "Check the proof of a mesh");
  const auto options = std::make_shared<check_options>();
  app->add_option("MESH", options->mesh, "The mesh, in Medit's format")->required();
  app->add_option("PROOF", options->proof, "Its proof, as --proof wrote it")->required();
  app->add_option("--domain", options->domain,
                  "A .poly file, or another domain that 'asterism mesh' takes (default: what the "
                  "mesh's boundary encloses)")
      ->type_name("D");
  add_real(
      *app, "--angle-bound", angle_bounds, [options](double x) { options->angle_bound = x; },
      "Least angle, in degrees")
      ->type_name("B")
      ->required();
  app->add_option("--metric", options->metric, "A .sol file with a tensor at each vertex")
      ->type_name("SOL")
      ->required();
  add_real(
      *app, "--metric-tolerance", reals_from_zero,
      [options](double x) { options->metric_tolerance = x; },
      "How far the metric of the mesh, in the .sol beside it, may be from that of --metric: the "
      "logarithm of the greatest ratio of lengths")
      ->type_name("T");
  add_real(
      *app, "--chord-tolerance", reals_from_zero,
      [options](double x) { options->chord_tolerance = x; },
      "Greatest distance of the domain's curves and their chords from each other")
      ->type_name("E");
  app->footer(check_examples);
  app->callback([options, &chosen] { chosen = [options] { return run_check(*options); }; });
}

}  // namespace asterism::apps
