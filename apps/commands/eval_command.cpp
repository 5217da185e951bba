// SPDX-License-Identifier: MIT
#include <filesystem>
#include <fstream>
#include <iostream>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "asterism/apps/base/commands.hpp"
#include "asterism/apps/base/complain.hpp"
#include "asterism/kernels/batch_protocol.hpp"
#include "asterism/mesh/io/similar_file.hpp"

namespace asterism::apps {
namespace {

struct eval_options {
  std::vector<std::string> files;
  kernel_choice kernel = kernel_choice::filtered;
  bool statistics = false;
};

const std::map<std::string, kernel_choice> kernels_by_name = {
    {"filtered", kernel_choice::filtered},
    {"exact", kernel_choice::exact},
    {"interval", kernel_choice::interval},
    {"double", kernel_choice::plain_double},
};

constexpr const char* eval_examples =
    R"(Records, one a line: name, then decimal or C99 hexadecimal numbers.
A point is x y, a site is x y m11 m12 m22; '#' starts a comment line.
  orientation p q r            is_spd m11 m12 m22         compare_distance v w q
  in_wedge v w q               dominates v w p            voronoi_vertex_count u v w
  arc_intersection_count v w x encroaches a b w           insertion_test v w x y
  edge_test v w x y            in_circle m11 m12 m22  a b c p
  orient2d p q r               incircle a b c p           (in the plane)
One integer a line comes back; a record that cannot be answered gets 'error: ...'.

Exit status: 0 every record was answered; 1 some was answered by an error; 2 bad usage or input.

Examples:
  echo 'orientation 0 0  1 0  0x1p-3 1' | asterism eval
  asterism eval --kernel exact --stats records.txt)";

// Refuses a file whose first lines are all no records: it is of another kind, and each of its lines
// would be answered by an error. Blank lines and comments do not count. Leaves the file at its
// beginning.
std::optional<error> refuse_other_kind(const std::string& file, std::ifstream& in) {
  constexpr int lines_looked_at = 20;  // chosen: a file of records may begin with some mistakes
  int bad = 0;
  std::string first;
  for (std::string line; bad < lines_looked_at && std::getline(in, line);) {
    const auto record = parse_record(line);
    if (record && record.value()) break;
    if (!record && ++bad == 1) first = record.failure().message;
  }
  in.clear();
  in.seekg(0);
  if (bad < lines_looked_at) return std::nullopt;
  return error{file + ": none of its first " + std::to_string(bad) +
               " lines is a record (the first: " + first +
               "); a record is a predicate and its numbers, see 'asterism help eval'"};
}

// Answers the questions of all files. Opens every file before anything is answered, so that a wrong
// name leaves no partial output.
int run_eval(const eval_options& options) {
  std::vector<std::ifstream> streams;
  for (const std::string& file : options.files) {
    if (file == "-") {
      streams.emplace_back();
      continue;
    }
    std::error_code ignored;
    if (std::filesystem::is_directory(file, ignored))
      return complain({file + ": is a directory, not a file of records"}, refused);
    streams.emplace_back(file, std::ios::binary);
    if (!streams.back())
      return complain({file + ": cannot be opened for reading" + internal::similar_file(file)},
                      refused);
    if (!std::filesystem::is_regular_file(file, ignored)) continue;
    if (const auto failed = refuse_other_kind(file, streams.back()))
      return complain(*failed, refused);
  }

  std::ios::sync_with_stdio(false);
  std::cin.tie(nullptr);
  batch_evaluator evaluator(options.kernel);
  for (std::size_t i = 0; i < options.files.size(); ++i) {
    std::istream& in = options.files[i] == "-" ? std::cin : streams[i];
    evaluator.answer_all(in, std::cout);
    if (in.bad()) return complain({options.files[i] + ": reading failed"}, refused);
    if (!std::cout) return complain({"standard output: writing failed"}, refused);
  }
  if (options.statistics) write_statistics(std::cerr, evaluator.statistics());
  return evaluator.statistics().errors == 0 ? done : not_reached;
}

}  // namespace

void add_eval_command(CLI::App& program, command& chosen) {
  auto* const app = program.add_subcommand("eval", "Evaluate predicates, one record a line");
  const auto options = std::make_shared<eval_options>();
  app->add_option("FILES", options->files, "Files of records; '-' or none: standard input");
  app->add_option_function<std::string>(
         "--kernel",
         [options](const std::string& name) { options->kernel = kernels_by_name.at(name); },
         "filtered (default) and exact are always right and answer the same; interval answers ? "
         "where it cannot decide; double may be wrong")
      ->check(CLI::IsMember(kernels_by_name));
  app->add_flag("--stats", options->statistics,
                "Report on standard error how many records each tier decided");
  app->footer(eval_examples);
  app->callback([options, &chosen] {
    if (options->files.empty()) options->files.emplace_back("-");
    chosen = [options] { return run_eval(*options); };
  });
}

}  // namespace asterism::apps
