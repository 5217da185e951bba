// SPDX-License-Identifier: MIT
#include "asterism/mesh/draw/report.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <nlohmann/json.hpp>
#include <utility>

#include "asterism/core/elementary.hpp"
#include "asterism/core/version.h"
#include "asterism/mesh/draw/packed_arrays.hpp"
#include "asterism/mesh/draw/page_template.hpp"
#include "asterism/mesh/draw/page_text.hpp"
#include "asterism/mesh/numerics/mesh_statistics.hpp"
#include "asterism/mesh/support/markup.hpp"

namespace asterism {
using namespace internal;

namespace {

using json = nlohmann::ordered_json;

std::optional<error> refusal(const mesh& m, const solution& fields) {
  if (m.sites.empty()) return error{"there is nothing to show: the mesh has no sites"};
  for (std::size_t v = 0; v < m.sites.size(); ++v) {
    const auto& [p, t] = m.sites[v];
    for (const double number : {p.x, p.y, t.m11, t.m12, t.m22})
      if (!std::isfinite(number))
        return error{"vertex " + std::to_string(v + 1) + " is not finite",
                     error_code::invalid_mesh};
  }
  for (const solution_field& field : fields.fields)
    if (field.values.size() != m.sites.size() * components_of(field.kind))
      return error{"the field " + field.name + " has not one value for each site",
                   error_code::bad_option};
  return std::nullopt;
}

std::optional<error> refusal(const mesh& m, const report_facts& facts) {
  if (auto refused = refusal(m, facts.fields)) return refused;
  if (!facts.wanted.empty() && facts.wanted.size() != m.sites.size())
    return error{"there are not as many tensors wanted as sites", error_code::bad_option};
  for (const report_frame& frame : facts.before)
    if (auto refused = refusal(frame.content, frame.fields)) return refused->at(frame.label);
  return std::nullopt;
}

// Returns the logarithm of the greatest ratio of a length in the tensor delivered and in the one
// wanted; 0 where they are equal to the last bit.
std::vector<float> distances(const mesh& m, const std::vector<metric_tensor>& wanted) {
  std::vector<float> all;
  all.reserve(wanted.size());
  for (std::size_t v = 0; v < wanted.size(); ++v)
    all.push_back(
        identical(m.sites[v].metric, wanted[v])
            ? 0.0F
            : static_cast<float>(elementary::log(distortion(m.sites[v].metric, wanted[v]))));
  return all;
}

void add_sites(packed_arrays& arrays, const std::string& prefix, const mesh& m) {
  std::vector<double> positions, metrics;
  positions.reserve(2 * m.sites.size());
  metrics.reserve(3 * m.sites.size());
  for (const site& s : m.sites) {
    positions.insert(positions.end(), {s.position.x, s.position.y});
    metrics.insert(metrics.end(), {s.metric.m11, s.metric.m12, s.metric.m22});
  }
  arrays.add(prefix + "positions", "f64", positions);
  arrays.add(prefix + "metrics", "f64", metrics);
}

void add_boundary(packed_arrays& arrays, const std::string& prefix, const mesh& m) {
  std::vector<vertex_index> ends;
  std::vector<std::int32_t> markers;
  std::vector<std::uint8_t> inside;
  for (const boundary_edge& e : m.boundary) {
    ends.insert(ends.end(), {e.a, e.b});
    markers.push_back(e.marker);
    inside.push_back(e.internal ? 1 : 0);
  }
  arrays.add(prefix + "boundary", "u32", ends);
  arrays.add(prefix + "markers", "i32", markers);
  arrays.add(prefix + "inside", "u8", inside);
}

// Adds the arrays of one mesh, with names that begin with the prefix.
void add_mesh(packed_arrays& arrays, const std::string& prefix, const mesh& m) {
  add_sites(arrays, prefix, m);
  std::vector<vertex_index> corners;
  corners.reserve(3 * (m.triangles.size() + m.disagreeing.size()));
  for (const auto* triangles : {&m.triangles, &m.disagreeing})
    for (const triangle& t : *triangles) corners.insert(corners.end(), t.begin(), t.end());
  arrays.add(prefix + "triangles", "u32", corners);
  arrays.add(prefix + "regions", "i32",
             std::vector<std::int32_t>(m.regions.begin(), m.regions.end()));
  add_boundary(arrays, prefix, m);
}

std::string field_array(const std::string& prefix, std::size_t k) {
  return prefix + "field" + std::to_string(k);
}

void add_fields(packed_arrays& arrays, const std::string& prefix, const solution& fields) {
  for (std::size_t k = 0; k < fields.fields.size(); ++k)
    arrays.add(field_array(prefix, k), "f64", fields.fields[k].values);
}

std::string prefix_of_frame(std::size_t i) { return "frame" + std::to_string(i) + "."; }

packed_arrays pack(const mesh& m, const report_facts& facts) {
  packed_arrays arrays;
  add_mesh(arrays, "", m);
  arrays.add("distances", "f32", distances(m, facts.wanted));
  arrays.add("not_of_stars", "u32", facts.not_of_stars);
  add_fields(arrays, "", facts.fields);
  for (std::size_t i = 0; i < facts.before.size(); ++i) {
    const report_frame& frame = facts.before[i];
    const std::string prefix = prefix_of_frame(i);
    add_mesh(arrays, prefix, frame.content);
    arrays.add(prefix + "distances", "f32", std::vector<float>());
    arrays.add(prefix + "not_of_stars", "u32", frame.not_of_stars);
    add_fields(arrays, prefix, frame.fields);
  }
  return arrays;
}

json fields_json(const std::string& prefix, const solution& fields) {
  json all = json::array();
  for (std::size_t k = 0; k < fields.fields.size(); ++k)
    all.push_back({{"name", fields.fields[k].name},
                   {"components", components_of(fields.fields[k].kind)},
                   {"array", field_array(prefix, k)}});
  return all;
}

// Returns the counts of a mesh and the names of its fields, as a page lists them.
json counts_json(const mesh& m, const std::string& label, const std::string& prefix,
                 const solution& fields) {
  return {{"label", label},
          {"vertices", m.sites.size()},
          {"given", m.given},
          {"triangles", m.triangles.size()},
          {"disagreeing", m.disagreeing.size()},
          {"fields", fields_json(prefix, fields)}};
}

json facts_json(const mesh& m, const report_facts& facts, const packed_arrays& arrays) {
  const std::uint64_t fingerprint = mesh_fingerprint(m);
  json entries = json::array(), frames = json::array();
  for (const auto& entry : arrays.entries())
    entries.push_back({{"name", entry.name}, {"type", entry.type}, {"length", entry.length}});
  for (std::size_t i = 0; i < facts.before.size(); ++i) {
    const report_frame& frame = facts.before[i];
    frames.push_back(counts_json(frame.content, frame.label, prefix_of_frame(i), frame.fields));
  }
  json all = {{"format", "asterism report 1"},
              {"program", ASTERISM_VERSION_TEXT},
              {"title", facts.title.empty() ? "Mesh" : facts.title}};
  all.update(counts_json(m, facts.label.empty() ? "After" : facts.label, "", facts.fields));
  all.update({{"fingerprint", fmt::format("{:016x}", fingerprint)},
              {"is_of_this_mesh", facts.claim && facts.claim->fingerprint == fingerprint},
              {"claim_from", facts.claim_from},
              {"repeat", facts.repeat},
              {"frames", std::move(frames)},
              {"arrays", std::move(entries)}});
  return all;
}

}  // namespace

result<std::string> report_page(const mesh& m, const report_facts& facts) {
  if (const auto refused = refusal(m, facts)) return *refused;
  const packed_arrays arrays = pack(m, facts);
  const auto data = arrays.text();
  if (!data) return data.failure();
  const std::string told =
      for_script(facts_json(m, facts, arrays).dump(1, ' ', false, json::error_handler_t::replace));
  const std::string claim = facts.claim ? for_script(certificate_text(*facts.claim)) : "null";
  const std::string title = escaped_markup(facts.title.empty() ? "Mesh" : facts.title);
  return fill_in(page_template::page, {{"title", title},
                                       {"style", page_template::style},
                                       {"script", page_template::script},
                                       {"facts", told},
                                       {"certificate", claim},
                                       {"data", data.value()}});
}

}  // namespace asterism
