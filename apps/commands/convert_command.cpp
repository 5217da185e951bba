// SPDX-License-Identifier: MIT
#include <unistd.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <iterator>
#include <memory>
#include <optional>
#include <string>
#include <system_error>
#include <utility>
#include <vector>

#include "asterism/apps/base/commands.hpp"
#include "asterism/apps/base/complain.hpp"
#include "asterism/apps/base/notes.hpp"
#include "asterism/apps/help/value_lists.hpp"
#include "asterism/apps/job/plain_question.hpp"
#include "asterism/apps/options/option_values.hpp"
#include "asterism/apps/options/second_order.hpp"
#include "asterism/apps/run/held_signals.hpp"
#include "asterism/apps/run/places.hpp"
#include "asterism/apps/text/summary.hpp"
#include "asterism/mesh/io/fields_of_mesh.hpp"
#include "asterism/mesh/io/file_ending.hpp"
#include "asterism/mesh/io/file_kinds.hpp"
#include "asterism/mesh/io/file_output.hpp"
#include "asterism/mesh/io/other_kind.hpp"
#include "asterism/mesh/io/poly_writer.hpp"
#include "asterism/mesh/io/read_mesh.hpp"
#include "asterism/mesh/io/render_mesh.hpp"
#include "asterism/mesh/io/write_mesh.hpp"
#include "asterism/mesh/pipeline/curved_sides.hpp"

namespace asterism::apps {
using namespace internal;
namespace fs = std::filesystem;
namespace {

struct convert_job {
  std::string in, out;
  std::vector<std::string> formats;  // of what is '-', in order
  int order = 1;
  std::string metric;  // empty: the tensors that are there
  double size = 1;
  domain_repair repair;
  bool quiet = false, strict = false;
};

constexpr const char* convert_examples =
    R"(Vertices, triangles, regions, markers, names, the metric and fields at the vertices go over, bit for
bit; what OUT has no place for is told. With --order 2 the nodes of sides that IN has go over, too;
sides without one are straight. '-' is standard input or output, and --format says what is there.

With --metric the tensors at the vertices are those of a metric, as 'asterism mesh' takes it, in
place of any that IN has. Where OUT is a .poly file, IN is a domain in any form that 'asterism mesh'
takes, and OUT says it by segments, hole points and region points alone; with --repair-domain as it
is repaired, of which the notes tell. Both are the forms in which 'asterism check' and
tools/check_mesh.py are asked.

Exit status: 0 converted; 1 OUT could not be written; 2 bad usage or input, nothing is written.

Examples:
  asterism convert part.msh part.su2
  asterism convert flow.vtu flow.mesh
  cat part.msh | asterism convert - - --format msh --format vtu > part.vtu
  asterism convert lake.geojson lake.poly
  asterism convert crossing.poly repaired.poly --repair-domain
  asterism convert lake.mesh asked.mesh --metric swirl:24 --size 0.1)";

// A temporary folder for data from standard input or to standard output, removed at the end.
class passing_folder {
 public:
  passing_folder() = default;
  passing_folder(const passing_folder&) = delete;
  passing_folder& operator=(const passing_folder&) = delete;
  ~passing_folder() {
    std::error_code ignored;
    if (!path_.empty()) fs::remove_all(path_, ignored);
  }

  // Creates the folder; fails where the system does.
  std::optional<error> make() {
    std::error_code failed;
    std::string name = (fs::temp_directory_path(failed) / "asterism-XXXXXX").string();
    if (failed || ::mkdtemp(name.data()) == nullptr)
      return error{"there is no place for a temporary file", error_code::unwritable_file};
    path_ = name;
    return std::nullopt;
  }
  const fs::path& path() const { return path_; }
  // Removes the temporary folder's name from a text: it means nothing to users.
  std::string without_it(std::string text) const {
    const std::string prefix = path_.string() + "/";
    for (std::size_t at = text.find(prefix); !path_.empty() && at != std::string::npos;
         at = text.find(prefix))
      text.erase(at, prefix.size());
    return text;
  }

 private:
  fs::path path_;
};

// Files of a job; '-' is replaced by files in the temporary folder.
struct places {
  fs::path in, out;
  bool from_standard_input = false, to_standard_output = false;
};

result<places> places_of(const convert_job& job, passing_folder& folder) {
  places made{job.in, job.out, job.in == "-", job.out == "-"};
  const std::size_t wanted =
      (made.from_standard_input ? 1U : 0U) + (made.to_standard_output ? 1U : 0U);
  if (job.formats.size() != wanted)
    return error{wanted == 0
                     ? std::string("--format: neither IN nor OUT is '-'")
                     : "--format: one is wanted for each '-', as --format msh, and there are " +
                           std::to_string(job.formats.size()),
                 error_code::bad_option};
  if (wanted == 0) return made;
  if (auto failed = folder.make()) return *failed;
  const auto named = [&](const char* name, std::string format) {
    if (!format.empty() && format.front() == '.') format.erase(0, 1);
    return folder.path() / (std::string(name) + "." + format);
  };
  if (made.from_standard_input) made.in = named("standard-input", job.formats.front());
  if (made.to_standard_output) made.out = named("standard-output", job.formats.back());
  return made;
}

std::optional<error> take_standard_input(const fs::path& file) {
  std::ofstream to(file, std::ios::binary);
  to << std::cin.rdbuf();
  to.flush();
  if (!to) return error{"standard input: nothing could be read"};
  return std::nullopt;
}

bool is_medit(mesh_format format) {
  return format == mesh_format::medit || format == mesh_format::medit_binary;
}

// Returns a sentence for each thing that the format has no place for.
std::vector<std::string> losses(const mesh_file& read, const solution& fields, mesh_format format,
                                const std::string& out) {
  const mesh& m = read.content;
  const kept_parts& keeps = kept_in(format);
  const bool has_regions =
      std::any_of(m.regions.begin(), m.regions.end(), [](int r) { return r != 1; });
  const bool has_internal = std::any_of(m.boundary.begin(), m.boundary.end(),
                                        [](const boundary_edge& e) { return e.internal; });
  std::vector<std::string> all;
  const auto lose = [&](bool there, bool kept, const char* what) {
    if (there && !kept) all.push_back(out + ": " + what + " have no place in it and are left out");
  };
  lose(has_regions, keeps.regions, "regions");
  lose(has_internal, keeps.inner_segments, "segments inside");
  lose(!read.names.markers.empty(), keeps.names_of_markers, "names of markers");
  lose(!read.names.regions.empty(), keeps.names_of_regions, "names of regions");
  lose(read.has_metric, keeps.metric, "tensors of the metric");
  lose(!fields.fields.empty(), keeps.fields, "fields");
  if (is_medit(format) && !fields.fields.empty())
    all.push_back(out + ": fields have numbers there, from 1, in place of names");
  return all;
}

// Writes the first file, which contains the mesh.
std::optional<error> put_to_standard_output(const output_file& file) {
  const byte_sink put = [](std::string_view bytes) {
    std::cout.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  };
  put(file.bytes);
  if (file.rest) file.rest(put);
  if (!std::cout.flush()) return error{"standard output: writing failed"};
  return std::nullopt;
}

std::optional<error> check_output_differs(const places& where) {
  std::error_code ignored;
  if (!fs::equivalent(where.in, where.out, ignored)) return std::nullopt;
  return error{where.out.string() + ": is the file to read; name another one to write",
               error_code::bad_option};
}

// Checks names and places before anything is read.
std::optional<error> check_places(const places& where, int order) {
  if (!is_mesh_file(where.in.string()))
    return error{where.in.string() + ": unknown kind of file '" + where.in.extension().string() +
                     "'; meshes are read of " + endings_of(is_mesh_kind, "and") +
                     what_it_is(where.in.string()),
                 error_code::bad_option};
  const auto format = check_output(where.out);
  if (!format) return format.failure();
  if (auto refused = check_order(order, {where.out})) return refused;
  return check_output_differs(where);
}

struct conversion {
  mesh_file read;
  solution fields;
  std::vector<output_file> files;
};

// Converts a domain to a file of a domain, and fills in `made`.
std::optional<error> convert_domain(const convert_job& job, const places& where, conversion& made) {
  if (job.order != 1 || !job.metric.empty())
    return error{where.out.string() +
                     ": --order and --metric are of meshes, and a .poly file is of a domain",
                 error_code::bad_option};
  if (auto refused = check_output_differs(where)) return refused;
  if (auto place = check_writable(where.out); !place) return place.failure();
  const auto plain = plain_domain(where.in.string(), {job.quiet, job.strict}, job.repair);
  if (!plain) return plain.failure();
  made.files.push_back({where.out, poly_text(plain.value())});
  return std::nullopt;
}

// Converts and fills in `made`; files of meshes and fields are rendered while they are written.
std::optional<error> convert(const convert_job& job, const places& where,
                             const passing_folder& folder, conversion& made) {
  auto read = read_mesh_file(where.in, {.identity_without_solution = true});
  if (!read) return read.failure();
  made.read = std::move(read).value();
  if (made.read.content.triangles.empty())
    return error{where.in.string() +
                 ": there are no triangles: it is a domain, which `asterism "
                 "mesh` takes"};
  if (job.order == 2) {
    const auto sides = given_sides(made.read.content, made.read.curved);
    if (!sides) return sides.failure().at(where.in.string());
    take_back_note_of_corners(made.read);
  }
  if (!job.metric.empty()) {
    if (auto failed = take_metric(made.read.content, job.metric, job.size)) return failed;
    made.read.has_metric = true;
  }
  auto fields = fields_of_mesh(where.in, made.read);
  if (!fields) return fields.failure();
  made.fields = std::move(fields).value();
  const mesh_format format = mesh_format_of(where.out).value();
  std::vector<std::string> notes = made.read.content.notes;
  notes.insert(notes.end(), made.fields.notes.begin(), made.fields.notes.end());
  if (!is_drawing(format))
    for (std::string& lost : losses(made.read, made.fields, format, where.out.string()))
      notes.push_back(std::move(lost));
  std::error_code ignored;
  const fs::path beside = solution_path(where.out);
  if (is_medit(format) && !made.read.has_metric && made.fields.fields.empty() &&
      fs::exists(beside, ignored))
    notes.push_back(beside.string() +
                    ": is there already, of another mesh, and would be taken for " +
                    where.out.string() + "'s");
  for (std::string& note : notes) note = folder.without_it(note);
  if (auto refused = say_notes(notes, {job.quiet, job.strict})) return *refused;
  write_options how;
  how.names = made.read.names;
  how.with_metric = made.read.has_metric;
  how.fields = &made.fields;
  how.order = job.order;
  how.curved = made.read.curved;
  how.report.title = where.in.string();
  how.report.repeat = "asterism certify " + where.in.string();
  auto files = render_mesh(where.out, made.read.content, how);
  if (!files) return files.failure();
  made.files = std::move(files).value();
  return std::nullopt;
}

int run_convert(const convert_job& job) {
  const auto start = std::chrono::steady_clock::now();
  passing_folder folder;
  const auto fail = [&folder](const error& what, exit_status status) {
    return complain({folder.without_it(what.message), what.code}, status);
  };
  const auto where = places_of(job, folder);
  if (!where) return fail(where.failure(), refused);
  if (where.value().from_standard_input)
    if (const auto failed = take_standard_input(where.value().in)) return fail(*failed, refused);
  conversion made;
  if (has_ending(where.value().out.string(), ".poly")) {
    if (const auto failed = convert_domain(job, where.value(), made)) return fail(*failed, refused);
  } else {
    if (job.repair.is_asked)
      return fail(
          {"--repair-domain is of domains, and OUT is no .poly file", error_code::bad_option},
          refused);
    if (const auto failed = check_places(where.value(), job.order)) return fail(*failed, refused);
    if (const auto failed = convert(job, where.value(), folder, made))
      return fail(*failed, refused);
  }
  const held_signals held;
  if (where.value().to_standard_output) {
    const auto failed = put_to_standard_output(made.files.front());
    return failed ? fail(*failed, not_reached) : done;
  }
  const auto written = write_files(made.files);
  if (!written) return fail(written.failure(), not_reached);
  std::vector<fs::path> names;
  for (const output_file& file : made.files) names.push_back(file.path);
  if (!job.quiet) write_files_written(std::cout, names, start);
  return done;
}

}  // namespace

void add_convert_command(CLI::App& program, command& chosen) {
  auto* const app =
      program.add_subcommand("convert", "Write a mesh, or a domain, in another format");
  const auto job = std::make_shared<convert_job>();
  app->add_option("IN", job->in, "The mesh, or the domain, to read")->required();
  app->add_option("OUT", job->out, "The file to write")->required();
  app->add_option("--format", job->formats,
                  "The format of IN or OUT that is '-': the ending of its files, as msh; twice "
                  "where both are")
      ->type_name("ENDING")
      ->allow_extra_args(false);
  add_order_option(*app, job->order);
  auto* const metric =
      app->add_option("--metric", job->metric,
                      "Tensors of this metric, as 'asterism mesh' takes it, at the vertices")
          ->type_name("SPEC");
  add_real(
      *app, "--size", sizes, [job](double x) { job->size = x; },
      "Length of an edge in that metric that is 1 (default 1)")
      ->type_name("H")
      ->needs(metric);
  auto* const repair = app->add_flag(
      "--repair-domain", job->repair.is_asked,
      "Where OUT is a .poly file: write the domain as 'asterism mesh --repair-domain' repairs it");
  add_real(
      *app, "--repair-distance", positive_reals, [job](double x) { job->repair.distance = x; },
      "Distance within which points are joined (default: the least that suffices)")
      ->type_name("D")
      ->needs(repair);
  app->add_flag("--strict", job->strict, "Refuse what would be changed or left out, with a note");
  app->add_flag("--quiet", job->quiet, "No notes, and no names of files");
  app->footer(convert_values() + "\n" + convert_examples);
  app->callback([job, &chosen] { chosen = [job] { return run_convert(*job); }; });
}

}  // namespace asterism::apps
