// SPDX-License-Identifier: MIT
#include "asterism/mesh/claims/metric_series.hpp"

#include <cstddef>
#include <optional>
#include <utility>

#include "asterism/core/number_text.hpp"
#include "asterism/mesh/io/fields_of_mesh.hpp"
#include "asterism/mesh/io/read_mesh.hpp"
#include "asterism/mesh/io/solution_file.hpp"
#include "asterism/mesh/numerics/nodal_sums.hpp"
#include "asterism/mesh/pipeline/read_triangulation.hpp"
#include "asterism/mesh/search/mesh_links.hpp"
#include "asterism/mesh/solution/optimal_metric.hpp"

namespace asterism::internal {
namespace {

using tensors = std::vector<metric_tensor>;

// One window: its mesh and its fields, as read.
struct window {
  mesh on;
  std::string mesh_file;
  std::vector<nodal_values> fields;
  std::vector<vertex_index> left_out;
};

result<window> read_window(const metric_request& request, const std::string& file) {
  const bool is_own = is_mesh_file(file);
  window made;
  made.mesh_file = is_own ? file : request.mesh;
  auto read = read_plain_mesh_file(made.mesh_file);
  if (!read) return read.failure();
  const auto values = is_own ? fields_of_mesh(file, read.value())
                             : read_solution(file, read.value().content, read.value().left_out);
  if (!values) return values.failure();
  auto fields = select_values(values.value(), request.fields);
  if (!fields) return fields.failure().at(file);
  made.fields = std::move(fields).value();
  made.on = std::move(read.value().content);
  made.on.notes.insert(made.on.notes.end(), values.value().notes.begin(),
                       values.value().notes.end());
  made.left_out = std::move(read.value().left_out);
  return made;
}

// Returns a sentence on how the fields of a window differ from those of the first one.
std::optional<error> check_names(const window& first, const window& other, const std::string& file,
                                 const std::string& first_file) {
  bool are_same = first.fields.size() == other.fields.size();
  for (std::size_t k = 0; are_same && k < first.fields.size(); ++k)
    are_same = first.fields[k].name == other.fields[k].name;
  if (are_same) return std::nullopt;
  std::string names;
  for (const nodal_values& f : first.fields)
    names += (names.empty() ? "" : ", ") + quoted_token(f.name);
  return error{file + ": all windows have the same fields, and those of " + first_file + " are " +
               names + ": --field chooses"};
}

// Appends the mesh and the fields of a window to those of all windows.
void append(const window& part, mesh& whole, std::vector<nodal_values>& fields) {
  const auto first = static_cast<vertex_index>(whole.sites.size());
  whole.sites.insert(whole.sites.end(), part.on.sites.begin(), part.on.sites.end());
  for (const triangle& t : part.on.triangles)
    whole.triangles.push_back({t[0] + first, t[1] + first, t[2] + first});
  if (fields.empty())
    for (const nodal_values& f : part.fields) fields.push_back({f.name, {}});
  for (std::size_t k = 0; k < fields.size(); ++k)
    fields[k].values.insert(fields[k].values.end(), part.fields[k].values.begin(),
                            part.fields[k].values.end());
}

result<std::vector<window>> read_windows(const metric_request& request,
                                         const std::vector<std::string>& files) {
  std::vector<window> all;
  for (const std::string& file : files) {
    auto read = read_window(request, file);
    if (!read) return read.failure();
    all.push_back(std::move(read).value());
    if (auto failed = check_names(all.front(), all.back(), file, files.front())) return *failed;
  }
  return all;
}

// Returns the metrics to be intersected with, joined over all windows.
result<std::vector<tensors>> intersected_over(const metric_request& request,
                                              const std::vector<window>& windows) {
  std::vector<tensors> all;
  for (const std::string& file : request.intersected) {
    tensors& whole = all.emplace_back();
    for (const window& w : windows) {
      const auto read = read_metric_at_vertices(w.mesh_file, file);
      if (!read) return read.failure();
      whole.insert(whole.end(), read.value().begin(), read.value().end());
    }
  }
  return all;
}

// Divides the metric among the windows.
metric_series divided(std::vector<window> windows, solution_metric made) {
  metric_series series;
  series.report = std::move(made.report);
  std::size_t first = 0;
  for (window& w : windows) {
    const std::size_t count = w.on.sites.size();
    const auto begin = made.tensors.begin() + static_cast<std::ptrdiff_t>(first);
    const tensors own(begin, begin + static_cast<std::ptrdiff_t>(count));
    for (std::size_t v = 0; v < count; ++v) w.on.sites[v].metric = own[v];
    series.complexities.push_back(complexity_of(own, nodal_areas(w.on, mesh_links(w.on))));
    series.windows.push_back(std::move(w.on));
    series.left_out.push_back(std::move(w.left_out));
    first += count;
  }
  return series;
}

}  // namespace

result<metric_series> answer_series(const metric_request& request,
                                    const std::vector<std::string>& files) {
  auto windows = read_windows(request, files);
  if (!windows) return windows.failure();
  const auto intersected = intersected_over(request, windows.value());
  if (!intersected) return intersected.failure();
  mesh whole;
  std::vector<nodal_values> fields;
  for (const window& w : windows.value()) append(w, whole, fields);
  solution_metric_options wishes = request.wishes;
  const auto count = static_cast<double>(files.size());
  if (wishes.vertices) *wishes.vertices *= count;
  if (wishes.complexity) *wishes.complexity *= count;
  auto made = make_solution_metric(whole, fields, wishes, intersected.value());
  if (!made) return made.failure();
  return divided(std::move(windows).value(), std::move(made).value());
}

}  // namespace asterism::internal
