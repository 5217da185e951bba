// SPDX-License-Identifier: MIT
#include "asterism/mesh/draw/space_page.hpp"

#include <cstdint>
#include <nlohmann/json.hpp>

#include "asterism/core/version.h"
#include "asterism/mesh/draw/packed_arrays.hpp"
#include "asterism/mesh/draw/page_template.hpp"
#include "asterism/mesh/draw/page_text.hpp"
#include "asterism/mesh/support/markup.hpp"

namespace asterism::internal {
namespace {

using json = nlohmann::ordered_json;

packed_arrays pack(const space_mesh& m) {
  packed_arrays arrays;
  std::vector<double> positions;
  positions.reserve(3 * m.points.size());
  for (const space_point& p : m.points) positions.insert(positions.end(), {p.x, p.y, p.z});
  std::vector<std::uint32_t> corners;
  corners.reserve(3 * m.triangles.size());
  for (const space_triangle& t : m.triangles) corners.insert(corners.end(), t.begin(), t.end());
  arrays.add("positions", "f64", positions);
  arrays.add("triangles", "u32", corners);
  arrays.add("faces", "u32", m.faces);
  return arrays;
}

json json_of(const space_page_facts& facts, const packed_arrays& arrays) {
  json entries = json::array(), table = json::array();
  for (const auto& entry : arrays.entries())
    entries.push_back({{"name", entry.name}, {"type", entry.type}, {"length", entry.length}});
  for (const auto& [name, value] : facts.table) table.push_back({name, value});
  return {{"format", "asterism space 1"}, {"program", ASTERISM_VERSION_TEXT},
          {"title", facts.title},         {"certified", facts.certified},
          {"verdict", facts.verdict},     {"table", std::move(table)},
          {"repeat", facts.repeat},       {"arrays", std::move(entries)}};
}

}  // namespace

result<std::string> space_page(const space_mesh& m, const space_page_facts& facts) {
  if (m.triangles.empty()) return error{"there is nothing to show: the mesh has no triangles"};
  const packed_arrays arrays = pack(m);
  const auto data = arrays.text();
  if (!data) return data.failure();
  const std::string told =
      for_script(json_of(facts, arrays).dump(1, ' ', false, json::error_handler_t::replace));
  const std::string title = escaped_markup(facts.title);
  return fill_in(page_template::space_page, {{"title", title},
                                             {"style", page_template::space_style},
                                             {"script", page_template::space_script},
                                             {"facts", told},
                                             {"data", data.value()}});
}

}  // namespace asterism::internal
