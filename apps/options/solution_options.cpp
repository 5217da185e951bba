// SPDX-License-Identifier: MIT
#include "asterism/apps/options/solution_options.hpp"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <map>
#include <string>
#include <system_error>
#include <utility>

#include "asterism/apps/base/other_names.hpp"
#include "asterism/apps/options/option_values.hpp"
#include "asterism/apps/options/size_options.hpp"
#include "asterism/core/number_text.hpp"
#include "asterism/mesh/io/file_kinds.hpp"
#include "asterism/mesh/metric/make_metric_field.hpp"

namespace asterism::apps {
using namespace internal;
namespace {

const std::map<std::string, hessian_method> hessian_methods = {
    {"l2", hessian_method::l2_projection},
    {"green", hessian_method::green},
    {"lsq", hessian_method::least_squares}};

constexpr real_range norms = {1, 1e6, true, true, "from 1 to 1e6, or inf"};
constexpr real_range factors = {1, 1e100, false, true, "above 1, at most 1e100"};
constexpr real_range cutoffs = {0, 1, false, true, "above 0, at most 1"};
constexpr real_range targets = {0, 1e9, false, true, "positive, at most 1e9"};

// Takes 1e5 as well as 100000.
double whole_vertices(double n) {
  if (n != std::floor(n))
    throw CLI::ValidationError("--vertices", number_text(n) + " is not a whole number");
  return n;
}

void add_source_options(CLI::App& app, metric_request& request) {
  app.add_option(
         "MESH", request.mesh,
         "The mesh that the solution is on: .mesh, .meshb, .msh, .vtu or another that is read")
      ->required();
  app.add_option(
         "--solution", request.solution,
         "Values at its vertices: Medit's .sol, BAMG's .bb, node data of a .msh or point data "
         "of a .vtu (default: those in MESH, if it is one of these)")
      ->type_name("FILE");
  app.add_option(
         "--field", request.fields,
         "A field of the solution: its name, or its number where there are no names, with .x "
         "or .y for a component (default: all scalars and vectors); several times")
      ->type_name("NAME")
      ->allow_extra_args(false);
  app.add_option("--given-hessian", request.hessians,
                 "Second derivatives xx xy yy at the vertices, of either sign, that the metric is "
                 "made of in place of recovered ones: tensors of a .sol, node data of a .msh, "
                 "point data of a .vtu; --field then chooses among them")
      ->type_name("FILE");
  app.add_option("--intersect", request.intersected,
                 "A metric at the same vertices, .sol or .mtr, or on another mesh, to intersect "
                 "with; several "
                 "times")
      ->type_name("FILE")
      ->allow_extra_args(false);
  app.add_flag("--implied", request.implied,
               "The metric that the mesh implies by its edges, in place of a solution's");
  app.add_option("--metric", request.metric,
                 "A metric at the vertices, .sol (a size or a tensor each) or .mtr, or that of "
                 "another mesh, in place of a solution's")
      ->type_name("FILE");
}

void take_norm(const std::string& text, metric_request& request) {
  request.names_norm = true;
  request.wishes.norm.reset();
  if (text == "inf") return;
  request.wishes.norm = real_of("--norm", text, norms);
}

void add_target_options(CLI::App& app, metric_request& request) {
  solution_metric_options& wishes = request.wishes;
  app.add_option_function<std::string>(
         "--hessian",
         [&request](const std::string& name) {
           request.names_hessian = true;
           request.wishes.hessian = hessian_methods.at(name);
         },
         "green (default): weak form; lsq: fitted quadratics; l2: averages of averages")
      ->transform(also("least_squares", "lsq"))
      ->check(CLI::IsMember(hessian_methods))
      ->type_name("HOW");
  app.add_option_function<std::string>(
         "--norm", [&request](const std::string& text) { take_norm(text, request); },
         "The P of the L^P norm in which the error is to be least (default 2)")
      ->type_name("P");
  add_real(
      app, "--vertices", targets, [&wishes](double x) { wishes.vertices = whole_vertices(x); },
      "Vertices wanted (default: as many as the mesh has)")
      ->type_name("N");
  add_real(
      app, "--complexity", targets, [&wishes](double x) { wishes.complexity = x; },
      "Complexity wanted: the area as the metric measures it, 0.866 of the vertices")
      ->type_name("C");
  add_real(
      app, "--error", positive_reals, [&wishes](double x) { wishes.error = x; },
      "Error wanted, of linear interpolation in the norm")
      ->type_name("E");
  app.add_flag(
      "--relative", wishes.relative,
      "E is a part of the greatest less the least value of each field, as adaptmesh's err");
  add_real(
      app, "--cutoff", cutoffs, [&wishes](double x) { wishes.cutoff = x; },
      "E is a part of the value at each vertex, and of C times the greatest at least")
      ->type_name("C");
}

void take_gradation(const std::string& text, metric_request& request) {
  request.names_gradation = true;
  request.wishes.gradation.reset();
  if (text == "none") return;
  request.wishes.gradation = real_of("--gradation", text, factors);
}

void add_bound_options(CLI::App& app, metric_request& request) {
  solution_metric_options& wishes = request.wishes;
  add_size_bounds(app, wishes.least_size, wishes.greatest_size, wishes.aspect,
                  "Least length of an edge");
  app.add_option_function<std::string>(
         "--gradation", [&request](const std::string& text) { take_gradation(text, request); },
         "Greatest factor between the sizes of neighbours, about, or none (default: 6 for a "
         "solution, none for a metric)")
      ->type_name("B");
  app.add_option_function<std::string>(
         "--gradation-space",
         [&wishes](const std::string& name) { wishes.gradation_keeps_shape = name == "metric"; },
         "mixed (default): shapes round off with the distance; metric: they stay")
      ->check(CLI::IsMember({"mixed", "metric"}))
      ->type_name("SPACE");
  app.add_flag("--isotropic", wishes.isotropic, "One size in all directions, the least of them");
  add_real(
      app, "--step", factors, [&wishes](double x) { wishes.step = x; },
      "Greatest factor by which a size differs from that of the mesh")
      ->type_name("F");
}

}  // namespace

void add_solution_options(CLI::App& app, metric_request& request) {
  add_source_options(app, request);
  add_target_options(app, request);
  add_bound_options(app, request);
}

// Adapts to the fields in the mesh's own file where no other source is named.
void set_defaults(metric_request& request) {
  const bool has_source = is_of_fields(request) || !request.metric.empty() || request.implied;
  if (!has_source && holds_fields(request.mesh)) request.solution = request.mesh;
  if (!request.names_gradation && is_of_fields(request)) request.wishes.gradation = loop_gradation;
}

namespace {

std::optional<error> refuse(std::string what) {
  return error{std::move(what), error_code::bad_option};
}

// Refuses a relative error so large that it was probably not intended.
std::optional<error> check_relative(const metric_request& request) {
  const solution_metric_options& w = request.wishes;
  if (w.relative && !w.error) return refuse("--relative is of an --error, and there is none");
  if (w.cutoff && !w.relative) return refuse("--cutoff is of --relative, which is not there");
  if (w.relative && request.names_norm)
    return refuse("--norm has no part in a --relative error: leave one of the two out");
  if (w.relative && !request.hessians.empty())
    return refuse(
        "--relative is of the values of a --solution, and the metric is made of --given-hessian: "
        "divide the second derivatives by what the error is to be a part of");
  return std::nullopt;
}

// Refuses options about fields if there are no fields.
std::optional<error> check_fields(const metric_request& request) {
  const solution_metric_options& w = request.wishes;
  const std::pair<bool, const char*> of_fields[] = {{!request.fields.empty(), "--field"},
                                                    {w.error.has_value(), "--error"},
                                                    {request.names_hessian, "--hessian"},
                                                    {request.names_norm, "--norm"}};
  for (const auto& [is_named, name] : of_fields)
    if (is_named && !is_of_fields(request))
      return refuse(std::string(name) + " is of a --solution, and there is none");
  if (request.names_hessian && !request.hessians.empty())
    return refuse(
        "--hessian says how second derivatives are recovered, and --given-hessian has "
        "them already: leave one of the two out");
  return check_relative(request);
}

}  // namespace

namespace {

// Refuses the name or formula of a metric where a file of one is wanted.
std::optional<error> check_metric(const metric_request& request) {
  const std::string name = request.metric.substr(0, request.metric.find(':'));
  const auto names = metric_names();
  std::error_code ignored;
  if (std::none_of(names.begin(), names.end(),
                   [&name](const metric_name& known) { return known.name == name; }) ||
      std::filesystem::exists(request.metric, ignored))
    return std::nullopt;
  return refuse(
      "--metric: " + request.metric +
      " is the name of a metric, which `asterism mesh` takes; here a file with one at the "
      "vertices is wanted, and `asterism convert " +
      request.mesh + " ASKED.mesh --metric '" + request.metric + "'` writes ASKED.sol");
}

}  // namespace

std::optional<error> check_request(const metric_request& request) {
  if (auto failed = internal::check_sources(request)) return failed;
  if (auto failed = check_metric(request)) return failed;
  if (auto failed = check_fields(request)) return failed;
  const solution_metric_options& w = request.wishes;
  if (!(w.least_size < w.greatest_size))
    return error{"--hmin " + number_text(w.least_size) + " is not less than --hmax " +
                     number_text(w.greatest_size),
                 error_code::bad_option};
  for (const auto& files : {request.fields, request.intersected, {request.carried}})
    for (const std::string& text : files)
      if (text.find('\n') != std::string::npos)
        return error{"a name has a line end in it: " + quoted_token(text), error_code::bad_option};
  return std::nullopt;
}

std::vector<std::filesystem::path> files_of(const metric_request& request) {
  std::vector<std::filesystem::path> files = {request.mesh};
  for (const std::string& file :
       {request.solution, request.hessians, request.metric, request.carried})
    if (!file.empty() && file != request.mesh) files.emplace_back(file);
  for (const std::string& file : request.intersected) files.emplace_back(file);
  return files;
}

}  // namespace asterism::apps
