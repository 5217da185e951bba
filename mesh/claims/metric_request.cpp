// SPDX-License-Identifier: MIT
#include "asterism/mesh/claims/metric_request.hpp"

#include <optional>
#include <string>
#include <utility>

#include "asterism/mesh/io/read_mesh.hpp"
#include "asterism/mesh/io/solution_file.hpp"
#include "asterism/mesh/io/solution_output.hpp"
#include "asterism/mesh/pipeline/given_hessians.hpp"
#include "asterism/mesh/pipeline/periodic_continuation.hpp"
#include "asterism/mesh/pipeline/read_triangulation.hpp"
#include "asterism/mesh/solution/implied_metric.hpp"

namespace asterism::internal {
namespace {

using tensors = std::vector<metric_tensor>;

result<std::vector<tensors>> read_intersected(const metric_request& request) {
  std::vector<tensors> all;
  for (const std::string& file : request.intersected) {
    auto read = read_metric_at_vertices(request.mesh, file);
    if (!read) return read.failure();
    all.push_back(std::move(read).value());
  }
  return all;
}

// Adds the notes on values to those on their mesh.
void add_notes(const std::vector<std::string>& of_values, mesh& on) {
  on.notes.insert(on.notes.end(), of_values.begin(), of_values.end());
}

std::optional<error> read_values(const metric_request& request,
                                 const std::vector<vertex_index>& left_out,
                                 requested_metric& made) {
  if (request.solution.empty()) return std::nullopt;
  auto values = read_solution(request.solution, made.background, left_out);
  if (!values) return values.failure();
  made.values = std::move(values).value();
  add_notes(made.values.notes, made.background);
  return std::nullopt;
}

result<solution_metric> metric_of_hessians(const metric_request& request,
                                           const std::vector<tensors>& intersected,
                                           const std::vector<vertex_index>& left_out,
                                           requested_metric& made) {
  const auto given = read_hessians(request.hessians, made.background, left_out, request.fields);
  if (!given) return given.failure();
  add_notes(given.value().notes, made.background);
  auto metric =
      make_hessian_metric(made.background, given.value().fields, request.wishes, intersected);
  if (!metric && metric.failure().code != error_code::bad_option)
    return metric.failure().at(request.hessians);
  return metric;
}

result<solution_metric> metric_of_solution(const metric_request& request,
                                           const std::vector<tensors>& intersected,
                                           const requested_metric& made) {
  const auto fields = select_values(made.values, request.fields);
  if (!fields) return fields.failure().at(request.solution);
  const auto glued = continued_across(made.background, request.periodic);
  auto metric =
      glued
          ? make_glued_metric(made.background, *glued, fields.value(), request.wishes, intersected)
          : make_solution_metric(made.background, fields.value(), request.wishes, intersected);
  if (!metric && metric.failure().code != error_code::bad_option)
    return metric.failure().at(request.solution);
  return metric;
}

result<solution_metric> metric_given(const metric_request& request,
                                     const std::vector<tensors>& intersected,
                                     const requested_metric& made) {
  const auto given = request.implied ? implied_metric(made.background)
                                     : read_metric_at_vertices(request.mesh, request.metric);
  if (!given) return given.failure();
  return shape_metric(made.background, given.value(), request.wishes, intersected);
}

// Appends the fields that are only transferred to those of the solution.
std::optional<error> add_carried(const metric_request& request,
                                 const std::vector<vertex_index>& left_out,
                                 requested_metric& made) {
  made.own_fields = made.values.fields.size();
  if (request.carried.empty()) return std::nullopt;
  auto read = read_fields(request.carried, made.background, left_out);
  if (read && read.value().fields.empty())
    return error{request.carried + ": there is no field in it to carry",
                 error_code::malformed_file};
  if (!read) return read.failure();
  made.values.vertices = read.value().vertices;
  add_notes(read.value().notes, made.background);
  for (solution_field& field : read.value().fields) {
    field.name = carried_prefix + field.name;
    made.values.fields.push_back(std::move(field));
  }
  return std::nullopt;
}

}  // namespace

std::optional<error> check_sources(const metric_request& request) {
  const int sources = (is_of_fields(request) ? 1 : 0) + (request.metric.empty() ? 0 : 1) +
                      (request.implied ? 1 : 0);
  if (sources != 1)
    return error{
        "one of --solution, --given-hessian, --metric and --implied is wanted, and there " +
            std::string(sources == 0 ? "is none" : "are several"),
        error_code::bad_option};
  const solution_metric_options& w = request.wishes;
  if (w.vertices.has_value() + w.complexity.has_value() + w.error.has_value() > 1)
    return error{"one of --vertices, --complexity and --error can be wanted, not several",
                 error_code::bad_option};
  return std::nullopt;
}

std::string name_of(const metric_request& request) {
  if (!request.hessians.empty()) return "hessian " + request.hessians;
  if (!request.solution.empty()) return "solution " + request.solution;
  return request.implied ? "implied by " + request.mesh : "metric " + request.metric;
}

result<requested_metric> answer(const metric_request& request) {
  auto read = read_plain_mesh_file(request.mesh);
  if (!read) return read.failure();
  requested_metric made{std::move(read.value().content), {}, 0, {}};
  const auto intersected = read_intersected(request);
  if (!intersected) return intersected.failure();
  const auto& left_out = read.value().left_out;
  if (auto failed = read_values(request, left_out, made)) return *failed;
  auto metric = !request.hessians.empty()
                    ? metric_of_hessians(request, intersected.value(), left_out, made)
                : !request.solution.empty() ? metric_of_solution(request, intersected.value(), made)
                                            : metric_given(request, intersected.value(), made);
  if (!metric) return metric.failure();
  for (std::size_t v = 0; v < made.background.sites.size(); ++v)
    made.background.sites[v].metric = metric.value().tensors[v];
  made.report = std::move(metric.value().report);
  if (auto failed = add_carried(request, left_out, made)) return *failed;
  made.left_out = std::move(read.value().left_out);
  return made;
}

}  // namespace asterism::internal
