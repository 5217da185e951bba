// SPDX-License-Identifier: MIT
#include "asterism/apps/verify/verify_mesh.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <memory>
#include <string>
#include <string_view>
#include <utility>

#include "asterism/apps/verify/verify_metric.hpp"
#include "asterism/mesh/claims/field_claims.hpp"
#include "asterism/mesh/domain/cracks.hpp"
#include "asterism/mesh/io/file_ending.hpp"
#include "asterism/mesh/io/file_kinds.hpp"
#include "asterism/mesh/io/read_mesh.hpp"
#include "asterism/mesh/io/write_mesh.hpp"
#include "asterism/mesh/pipeline/completed_mesh.hpp"

namespace asterism::apps {
using namespace internal;
namespace {

// True for formats that have writers, list the sides of the boundary, by numbers or by a solver's
// names, and have no metric.
bool is_of_solver(std::string_view name) {
  const file_kind* const kind = kind_of_file(name);
  return kind != nullptr && is_mesh_kind(*kind) && is_written_kind(*kind) && !kind->keeps.metric;
}

bool is_written_alone(const std::filesystem::path& path) {
  return mesh_format_of(path).ok() && !is_mesh_file(path.string());
}

// Sets the tensors at the vertices to those of a field.
std::optional<error> measure_by(const metric_field& field, mesh& m) {
  for (std::size_t v = 0; v < m.sites.size(); ++v) {
    const auto metric = field.at(m.sites[v].position);
    if (!metric) return metric.failure().at("vertex " + std::to_string(v + 1));
    m.sites[v].metric = metric.value();
  }
  return std::nullopt;
}

// Returns the nodes of sides by the vertex numbers of a mesh whose cracks are joined.
std::vector<side_node> nodes_of_joined(const joined_cracks& joined, std::vector<side_node> nodes) {
  if (joined.number.empty()) return nodes;
  std::map<std::pair<vertex_index, vertex_index>, point> made;
  for (const side_node& s : nodes) made[std::minmax(joined.number[s.a], joined.number[s.b])] = s.at;
  nodes.clear();
  for (const auto& [ends, at] : made) nodes.push_back({ends.first, ends.second, at});
  return nodes;
}

error no_metric(const verify_options& options, const std::string& why) {
  return {
      fmt::format("{}: there is no metric in the file{}{}; --metric names one, and a .mesh, "
                  ".msh or .vtu of the mesh has its own",
                  options.mesh.string(), why.empty() ? "" : ", and not the certificate's: ", why),
      error_code::invalid_metric};
}

// Returns the metric asked for, by --metric or the certificate.
result<std::unique_ptr<metric_field>> field_for(const judged_mesh& subject,
                                                const verify_options& options,
                                                const std::optional<certificate>& claim,
                                                const domain* shape) {
  if (!options.metric.empty()) return field_named(options, subject.content, claim, shape);
  if (!claim) return no_metric(options, "");
  auto field = field_in(*claim);
  if (!field) return no_metric(options, field.failure().message);
  return field;
}

}  // namespace

result<judged_mesh> read_judged(const verify_options& options) {
  const std::string name = options.mesh.string();
  if (is_written_alone(options.mesh))
    return error{name +
                     ": files of this kind are written and not read as meshes; verify the .mesh, "
                     ".msh or .vtu of the mesh",
                 error_code::bad_option};
  medit_read_options how;
  how.all_edges = options.all_edges;
  judged_mesh made;
  if (!is_mesh_file(name) || has_ending(name, ".mesh") || has_ending(name, ".meshb")) {
    auto read = read_medit(options.mesh, how);
    if (!read) return read.failure();
    (void)join_cracks(read.value());  // what is no slit the audit finds
    made.content = std::move(read).value();
    return made;
  }
  how.identity_without_solution = true;
  auto read = read_mesh_file(options.mesh, how);
  if (!read) return read.failure();
  if (read.value().content.triangles.empty())
    return error{name + ": there are no triangles", error_code::invalid_mesh};
  take_back_note_of_corners(read.value());
  const auto joined = join_cracks(read.value().content);
  made.second_order = read.value().second_order;
  made.curved = std::move(read.value().curved);
  if (joined) made.curved = nodes_of_joined(joined.value(), std::move(made.curved));
  made.content = std::move(read.value().content);
  made.has_metric = read.value().has_metric;
  made.has_segments = !is_of_solver(name);
  return made;
}

std::optional<std::string> complete_segments(judged_mesh& subject, const domain& shape) {
  if (subject.has_segments || subject.took_segments) return std::nullopt;
  auto whole = completed_by(shape, subject.content);
  if (!whole) return whole.failure().message;
  subject.took_regions = subject.content.regions.empty() && !whole.value().regions.empty();
  subject.content = std::move(whole).value();
  subject.took_segments = true;
  return std::nullopt;
}

std::optional<error> complete_metric(judged_mesh& subject, const verify_options& options,
                                     const std::optional<certificate>& claim, const domain* shape) {
  if (subject.has_metric) return std::nullopt;
  const auto field = field_for(subject, options, claim, shape);
  if (!field) return field.failure();
  subject.took_metric = true;
  if (auto failed = measure_by(*field.value(), subject.content))
    return failed->at(options.mesh.string());
  return std::nullopt;
}

std::string text_of_completion(const judged_mesh& subject, bool is_claimed) {
  if (!subject.took_segments) return "";
  const std::string from = is_claimed ? "certificate" : "domain";
  return "; not in the file and taken from the " + from + ": segments, markers" +
         (subject.took_regions ? ", regions" : "");
}

}  // namespace asterism::apps
