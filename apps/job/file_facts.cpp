// SPDX-License-Identifier: MIT
#include "asterism/apps/job/file_facts.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <system_error>

#include "asterism/apps/job/repair_hint.hpp"
#include "asterism/core/number_text.hpp"
#include "asterism/mesh/audit/certificate.hpp"
#include "asterism/mesh/domain/check_domain.hpp"
#include "asterism/mesh/domain/divide_curves.hpp"
#include "asterism/mesh/io/edges_domain.hpp"
#include "asterism/mesh/io/fields_of_mesh.hpp"
#include "asterism/mesh/io/file_ending.hpp"
#include "asterism/mesh/io/file_kinds.hpp"
#include "asterism/mesh/io/load_domain.hpp"
#include "asterism/mesh/io/other_kind.hpp"
#include "asterism/mesh/io/read_mesh.hpp"
#include "asterism/mesh/io/similar_file.hpp"
#include "asterism/mesh/io/solution_file.hpp"
#include "asterism/mesh/numerics/mesh_statistics.hpp"

namespace asterism::apps {
using namespace internal;
namespace fs = std::filesystem;
namespace {

std::string text_of(const bounding_box& box) {
  return fmt::format("x {} to {}, y {} to {}", number_text(box.low.x), number_text(box.high.x),
                     number_text(box.low.y), number_text(box.high.y));
}

// Returns each number with its count, "1 (12), 5 (3)", for the first ten numbers.
std::string text_of(const std::map<int, std::size_t>& counts,
                    const std::map<int, std::string>& names = {}) {
  std::string text;
  std::size_t told = 0;
  for (const auto& [number, count] : counts) {
    if (told++ == 10) return text + fmt::format(", and {} more", counts.size() - 10);
    const auto name = names.find(number);
    text += fmt::format("{}{}{} ({})", text.empty() ? "" : ", ", number,
                        name == names.end() ? "" : " \"" + name->second + "\"", count);
  }
  return text.empty() ? "none" : text;
}

std::string text_of(repair_answer answer) {
  switch (answer) {
    case repair_answer::mends:
      return "yes";
    case repair_answer::fails:
      return "no";
    case repair_answer::not_known:
      break;
  }
  return "not known: so much crosses that it takes long";
}

file_facts facts_of(const domain& d) {
  file_facts facts = {{"kind", "domain"},
                      {"vertices", d.vertices.size()},
                      {"segments", d.segments.size()},
                      {"hole points", d.holes.size()},
                      {"region points", d.regions.size()},
                      {"box", text_of(d.box())}};
  std::map<int, std::size_t> markers;
  for (const segment& s : d.segments) ++markers[s.marker];
  facts.emplace_back("markers", text_of(markers));
  if (!d.curves.empty()) facts.emplace_back("curves", std::to_string(d.curves.size()));
  if (!d.polygons.empty()) facts.emplace_back("polygons", d.polygons.size());
  if (!d.origin.notes.empty())
    facts.emplace_back("notes", fmt::format("{}", fmt::join(d.origin.notes, "; ")));
  domain_repairs repairs;
  const auto divided = divide_curves(d);
  const auto checked = divided ? check_domain(divided.value(), &repairs) : divided;
  if (!checked) {
    facts.emplace_back("can be meshed", "no: " + checked.failure().message);
    facts.emplace_back("with --repair-domain", text_of(try_repair(d).answer));
    return facts;
  }
  std::string put_in_order;
  for (const std::string& message : repairs.messages)
    put_in_order += (put_in_order.empty() ? "" : "; ") + message;
  facts.emplace_back("can be meshed", "yes");
  facts.emplace_back("put in order first", put_in_order.empty() ? "nothing" : put_in_order);
  const auto inside =
      std::count_if(checked.value().segments.begin(), checked.value().segments.end(),
                    [](const segment& s) { return s.internal; });
  facts.emplace_back("segments inside", static_cast<std::size_t>(inside));
  return facts;
}

void add_metric(const result<mesh>& measured, file_facts& facts) {
  if (!measured) {
    facts.emplace_back("metric", "none: " + measured.failure().message);
    return;
  }
  const mesh_statistics found = measure(measured.value());
  facts.emplace_back("metric", "a tensor at each vertex");
  facts.emplace_back("longest unit circle",
                     fmt::format("{:.4g} times as long as wide", found.aspect));
  facts.emplace_back("complexity", fmt::format("{:.6g}", found.metric_area));
  facts.emplace_back("unit edges",
                     fmt::format("{:.1f} % of {}", 100 * found.unit_edges, found.edges));
}

void add_certificate(const fs::path& path, const mesh& m, file_facts& facts) {
  const fs::path beside = fs::path(path).replace_extension(".certificate.json");
  std::error_code ignored;
  if (!fs::exists(beside, ignored)) {
    facts.emplace_back("certificate", "none beside it");
    return;
  }
  const auto claim = read_certificate(beside);
  facts.emplace_back("certificate",
                     !claim ? claim.failure().message
                     : claim.value().fingerprint != mesh_fingerprint(m)
                         ? beside.string() + ", of another mesh"
                         : beside.string() +
                               (claim.value().certified ? ": certified" : ": not certified") +
                               ", says it; asterism verify proves it");
}

std::string text_of(const solution_field& field) {
  const char* const kinds[] = {"", "scalar", "vector", "tensor"};
  const auto [least, most] = std::minmax_element(field.values.begin(), field.values.end());
  if (least == field.values.end()) return kinds[components_of(field.kind)];
  return fmt::format("{}, numbers from {} to {}", kinds[components_of(field.kind)],
                     number_text(*least), number_text(*most));
}

void add_solution(const solution& s, file_facts& facts) {
  for (const solution_field& f : s.fields) facts.emplace_back("field " + f.name, text_of(f));
}

// Adds the fields in the file of a mesh, or beside it, and the notes on both.
void add_fields(const fs::path& path, const mesh_file& read, file_facts& facts) {
  const auto found = fields_of_mesh(path, read);
  std::vector<std::string> notes = read.content.notes;
  if (!found) {
    facts.emplace_back("fields", "none: " + found.failure().message);
  } else {
    add_solution(found.value(), facts);
    notes.insert(notes.end(), found.value().notes.begin(), found.value().notes.end());
  }
  if (!notes.empty()) facts.emplace_back("notes", fmt::format("{}", fmt::join(notes, "; ")));
}

result<file_facts> facts_of_mesh(const fs::path& path) {
  auto read = read_mesh_file(path, {.identity_without_solution = true});
  if (!read) return read.failure();
  if (has_edges_alone(read.value())) {
    const auto bounded = domain_of_edges(std::move(read).value(), path.string());
    if (!bounded) return bounded.failure();
    return facts_of(bounded.value());
  }
  const mesh& m = read.value().content;
  file_facts facts = {{"kind", "mesh"},
                      {"vertices", m.sites.size()},
                      {"given vertices", std::size_t{m.given}},
                      {"triangles", m.triangles.size()},
                      {"boundary edges", m.boundary.size()}};
  if (!m.sites.empty()) {
    bounding_box box{m.sites[0].position, m.sites[0].position};
    for (const site& s : m.sites) box.include(s.position);
    facts.emplace_back("box", text_of(box));
  }
  const physical_names& names = read.value().names;
  std::map<int, std::size_t> markers, regions;
  for (const boundary_edge& e : m.boundary) ++markers[e.marker];
  for (const int region : m.regions) ++regions[region];
  if (m.regions.empty()) regions[1] = m.triangles.size();
  facts.emplace_back("markers", text_of(markers, names.markers));
  facts.emplace_back("regions", text_of(regions, names.regions));
  add_fields(path, read.value(), facts);
  add_metric(read_mesh(path), facts);
  add_certificate(path, m, facts);
  return facts;
}

// Reads numbers at vertices with the mesh beside them: without one they mean nothing.
result<file_facts> facts_of_solution(const fs::path& path) {
  std::error_code ignored;
  for (const char* const ending : {".mesh", ".meshb", ".msh"}) {
    const fs::path beside = fs::path(path).replace_extension(ending);
    if (!fs::exists(beside, ignored)) continue;
    const auto m = read_mesh(beside, {.without_solution = true});
    if (!m) return m.failure();
    file_facts facts = {
        {"kind", "solution"}, {"mesh", beside.string()}, {"vertices", m.value().sites.size()}};
    const auto read = read_solution(path, m.value());
    if (read) {
      add_solution(read.value(), facts);
      return facts;
    }
    const auto measured = read_mesh(beside, {.solution = path});
    if (!measured) return read.failure();  // the metric's would be about another use of the file
    facts[0].second = "metric";
    add_metric(measured, facts);
    return facts;
  }
  return error{
      path.string() + ": values at vertices can be described with their mesh beside the file, " +
      fs::path(path).replace_extension(".mesh").string() + "; 'asterism adapt MESH --solution " +
      path.string() + "' and commands like it take the file alone"};
}

result<file_facts> facts_of_certificate(const fs::path& path) {
  const auto read = read_certificate(path);
  if (!read) return read.failure();
  const certificate& c = read.value();
  const auto option = [&](const char* name) {
    const auto found = c.options.find(name);
    return found == c.options.end() ? std::string("none") : found->second;
  };
  return file_facts{
      {"kind", "certificate"},
      {"made by", "asterism " + c.version},
      {"says", std::string(c.certified ? "certified" : "not certified") +
                   (c.complete ? ", complete" : ", not complete")},
      {"reason", c.reason},
      {"domain", option("domain")},
      {"metric", c.metric},
      {"size", option("size")},
      {"angle bound", c.angle_bound ? number_text(*c.angle_bound) + " degrees" : "none"},
      {"worst angle", c.worst_angle < 180 ? number_text(c.worst_angle) + " degrees" : "none"},
      {"vertices", c.sites},
      {"triangles", c.triangles},
      {"fingerprint", fmt::format("{:016x}", c.fingerprint)}};
}

}  // namespace

result<file_facts> facts_of_file(const fs::path& path) {
  const std::string name = path.string();
  std::error_code ignored;
  if (fs::is_directory(path, ignored)) return error{name + ": is a directory, not a file"};
  // Finds whether a .vtu file is a mesh, a solution on one, or both.
  if (is_mesh_file(name)) {
    auto facts = facts_of_mesh(path);
    if (facts || !has_ending(name, ".vtu")) return facts;
  }
  if (has_ending(name, ".certificate.json")) return facts_of_certificate(path);
  for (const char* const ending : {".sol", ".solb", ".bb", ".mtr", ".vtu"})
    if (has_ending(name, ending)) return facts_of_solution(path);
  const file_kind* const kind = kind_of_file(name);
  const bool is_drawn = kind != nullptr && kind->format && is_drawing(*kind->format);
  if (is_drawn || has_ending(name, ".ele") || has_ending(name, ".edge"))
    return error{name + ": files of this kind are written here, not read"};
  if (!is_domain_name(name))
    return error{name +
                 (fs::exists(path, ignored) ? ": not a file that is known here by its name: "
                                            : ": no such file; these are known here by names: ") +
                 "domains (" + endings_of(is_domain_kind, "and") + "), meshes (" +
                 endings_of(is_mesh_kind, "and") +
                 "), solutions (.sol, .solb, .bb, .vtu), metrics (.sol, .solb, .mtr), certificates "
                 "(.certificate.json)" +
                 what_it_is(name) + similar_file(path)};
  const auto loaded = load_domain(name);
  if (loaded) return facts_of(loaded.value());
  // Tries a certificate, which may have any name; if the file is none either, the message about
  // domains is shown.
  if (has_ending(name, ".json"))
    if (auto facts = facts_of_certificate(path)) return facts;
  return loaded.failure();
}

}  // namespace asterism::apps
