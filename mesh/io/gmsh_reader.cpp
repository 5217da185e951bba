// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdlib>
#include <limits>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <unordered_map>
#include <utility>
#include <vector>

#include "asterism/core/number_text.hpp"
#include "asterism/kernels/filtered_kernel.hpp"
#include "asterism/mesh/io/gmsh.hpp"
#include "asterism/mesh/io/gmsh_groups.hpp"
#include "asterism/mesh/io/gmsh_source.hpp"
#include "asterism/mesh/io/listed_readers.hpp"
#include "asterism/mesh/io/text_scanner.hpp"

namespace asterism::internal {
namespace {

// Element types by number: the number of corners, which are the first of its nodes, and the number
// of nodes.
struct element_kind {
  long long type;
  std::size_t corners, nodes;
};
constexpr std::array<element_kind, 19> element_kinds = {{{15, 1, 1},
                                                         {1, 2, 2},
                                                         {8, 2, 3},
                                                         {26, 2, 4},
                                                         {27, 2, 5},
                                                         {28, 2, 6},
                                                         {2, 3, 3},
                                                         {9, 3, 6},
                                                         {20, 3, 9},
                                                         {21, 3, 10},
                                                         {22, 3, 12},
                                                         {23, 3, 15},
                                                         {24, 3, 15},
                                                         {25, 3, 21},
                                                         {3, 4, 4},
                                                         {16, 4, 8},
                                                         {10, 4, 9},
                                                         {36, 4, 16},
                                                         {37, 4, 25}}};

class gmsh_reader : private gmsh_source {
 public:
  explicit gmsh_reader(text_scanner& source) : gmsh_source(source) {}

  // Reads all sections in the order of the file.
  failure read();
  // Turns the sections read into a plane mesh: groups become markers and regions.
  failure finish();
  listed_mesh take() { return std::move(file_); }

 private:
  failure read_section(const word& head);
  void note_values_on_triangles();  // once for all sections of such values
  failure read_names();
  failure read_entities(const std::string& section);
  failure read_partitioned_entities(const std::string& section);
  failure read_entity(int dimension, bool is_part);
  failure read_parent();
  failure read_element_list(const std::string& end);
  result<int> read_group_of_one();
  result<int> read_group_of_two();
  failure read_elements_of_four();
  failure read_element_block();
  // Reads the vertices of an element, which is in the set of groups with this number.
  failure read_element(const element_kind& kind, std::size_t line, int groups);
  using element_nodes = std::array<vertex_index, 9>;
  void add_element(const element_kind& kind, const element_nodes& nodes, std::size_t line,
                   int groups);
  // Takes the nodes of sides, which follow the corners, in their order.
  void add_sides(const element_kind& kind, const element_nodes& nodes);
  // Returns the dimension whose groups an element of these corners is in.
  static int dimension_of(const element_kind& kind) {
    return static_cast<int>(std::min<std::size_t>(kind.corners, 3)) - 1;
  }
  result<element_kind> read_kind();
  failure read_node_data();
  failure read_metric();

  bool elements_seen_ = false, values_on_triangles_ = false;
  std::map<std::pair<int, long long>, int> physical_;  // groups of each entity, by its dimension
  std::vector<std::string> unlisted_;  // entities of elements that $Entities leaves out, and lines
  gmsh_groups groups_;
};

failure gmsh_reader::read() {
  if (auto failed = read_version()) return failed;
  while (true) {
    const word head = source_.next();
    if (head.empty()) break;
    if (auto failed = read_section(head)) return failed;
  }
  if (!elements_seen_) return source_.failure(source_.line(), "there is no section $Elements");
  if (!unlisted_.empty())
    file_.content.notes.push_back(
        fmt::format("elements of entities that $Entities does not list are in no physical group: "
                    "{}, the first {}",
                    unlisted_.size(), unlisted_.front()));
  return {};
}

failure gmsh_reader::read_section(const word& head) {
  const std::string name(head.text);
  if (name.empty() || name.front() != '$')
    return source_.failure(head.line, "a section wanted, not " + quoted_token(head.text));
  if (name == "$PhysicalNames") return read_names();
  if (name == "$Entities") return read_entities(name);
  if (name == "$PartitionedEntities") return read_partitioned_entities(name);
  if (name == "$Nodes" || name == "$NOD") return read_nodes(head);
  if (name == "$Elements" || name == "$ELM") {
    if (!has_nodes()) return source_.failure(head.line, name + " before $Nodes");
    if (std::exchange(elements_seen_, true)) return source_.failure(head.line, "a second " + name);
    if (version_ == 4) return read_elements_of_four();
    return read_element_list(version_ == 1 ? "$ENDELM" : "$EndElements");
  }
  if (name == "$NodeData") return read_node_data();
  if (name == "$ElementData" || name == "$ElementNodeData") note_values_on_triangles();
  return skip_to_end("$End" + name.substr(1), head.line);
}

void gmsh_reader::note_values_on_triangles() {
  if (std::exchange(values_on_triangles_, true)) return;
  file_.content.notes.push_back("values on triangles have no place here and are passed over");
}

failure gmsh_reader::read_names() {
  const auto names = count("number of names");
  if (!names.ok()) return names.failure();
  for (std::size_t i = 0; i < names.value(); ++i) {
    const std::vector<word> words = source_.next_line();
    if (words.size() < 3)
      return source_.failure(source_.line(), "dimension, tag and name of a physical group wanted");
    const auto dimension = to_marker(source_, words[0], "dimension of a physical group");
    if (!dimension.ok()) return dimension.failure();
    const auto tag = to_marker(source_, words[1], "tag of a physical group");
    if (!tag.ok()) return tag.failure();
    const char* begin = words[2].text.data();
    const std::string_view name(begin, words.back().text.data() + words.back().text.size() - begin);
    if (name.size() < 2 || name.front() != '"' || name.back() != '"')
      return source_.failure(words[2].line, "a name in \" wanted, not " + quoted_token(name));
    groups_.set_name(dimension.value(), tag.value(), std::string(name.substr(1, name.size() - 2)));
  }
  return expect("$EndPhysicalNames");
}

failure gmsh_reader::read_entities(const std::string& section) {
  std::size_t counts[4] = {};
  for (std::size_t& n : counts) {
    const auto wanted = count("number of entities");
    if (!wanted.ok()) return wanted.failure();
    n = wanted.value();
  }
  const bool are_parts = section == "$PartitionedEntities";
  for (int dimension = 0; dimension < 4; ++dimension)
    for (std::size_t i = 0; i < counts[dimension]; ++i)
      if (auto failed = read_entity(dimension, are_parts)) return failed;
  return expect("$End" + section.substr(1));
}

// Reads the entities of partitions: elements belong to these, and to the groups that these are in.
failure gmsh_reader::read_partitioned_entities(const std::string& section) {
  const auto partitions = count("number of partitions");
  if (!partitions.ok()) return partitions.failure();
  const auto ghosts = count("number of ghost entities");
  if (!ghosts.ok()) return ghosts.failure();
  for (std::size_t i = 0; i < ghosts.value(); ++i)
    if (auto failed = read_numbers(2, "ghost entity")) return failed;
  return read_entities(section);
}

// Skips the parent of an entity, and its partitions.
failure gmsh_reader::read_parent() {
  if (auto failed = read_numbers(2, "parent of an entity")) return failed;
  const auto partitions = count("number of partitions");
  if (!partitions.ok()) return partitions.failure();
  return read_numbers(partitions.value(), "partition");
}

failure gmsh_reader::read_entity(int dimension, bool is_part) {
  const word w = source_.next();
  const auto tag = to_integer(source_, w, "tag of an entity");
  if (!tag.ok()) return tag.failure();
  if (is_part)
    if (auto failed = read_parent()) return failed;
  // Reads the place of a point, or the box of another entity; in version 4.0 points have a box,
  // too.
  if (auto failed = read_numbers(dimension == 0 && minor_ > 0 ? 3 : 6, "box of an entity"))
    return failed;
  const auto groups = count("number of physical groups");
  if (!groups.ok()) return groups.failure();
  std::vector<int> tags;
  for (std::size_t i = 0; i < groups.value(); ++i) {
    const auto number = to_marker(source_, source_.next(), "physical group");
    if (!number.ok()) return number.failure();
    // Drops the sign of the physical group: it is the entity's orientation, and edges and triangles
    // are oriented by their own vertices.
    if (number.value() != std::numeric_limits<int>::min()) tags.push_back(std::abs(number.value()));
  }
  if (dimension < 3)
    physical_[{dimension, tag.value()}] = groups_.number_of_set(dimension, std::move(tags));
  if (dimension == 0) return {};
  const auto bounding = count("number of bounding entities");
  if (!bounding.ok()) return bounding.failure();
  return read_numbers(bounding.value(), "bounding entity");
}

result<element_kind> gmsh_reader::read_kind() {
  const word w = source_.next();
  const auto type = to_integer(source_, w, "type of an element");
  if (!type.ok()) return type.failure();
  for (const element_kind& kind : element_kinds)
    if (kind.type == type.value()) return kind;
  return source_.failure(w.line, "element of type " + quoted_token(w.text) +
                                     ": points, lines, triangles and quadrilaterals can be read");
}

failure gmsh_reader::read_element(const element_kind& kind, std::size_t line, int groups) {
  constexpr std::array<std::string_view, 5> meanings = {
      "", "point", "end of a line", "corner of a triangle", "corner of a quadrilateral"};
  element_nodes nodes{};
  for (std::size_t k = 0; k < kind.nodes; ++k) {
    const auto v = vertex(meanings[kind.corners]);
    if (!v.ok()) return v.failure();
    if (k < nodes.size()) nodes[k] = v.value();
  }
  add_element(kind, nodes, line, groups);
  return {};
}

void gmsh_reader::add_sides(const element_kind& kind, const element_nodes& nodes) {
  constexpr std::array<long long, 4> second_order = {8, 9, 16, 10};
  if (std::find(second_order.begin(), second_order.end(), kind.type) == second_order.end()) return;
  const std::size_t sides = kind.corners == 2 ? 1 : kind.corners;
  for (std::size_t k = 0; k < sides; ++k)
    file_.sides.push_back({nodes[k], nodes[(k + 1) % kind.corners], nodes[kind.corners + k]});
}

void gmsh_reader::add_element(const element_kind& kind, const element_nodes& corners,
                              std::size_t line, int groups) {
  mesh& m = file_.content;
  if (kind.nodes > kind.corners) ++file_.second_order;
  add_sides(kind, corners);
  if (kind.corners == 1) file_.marks.required_vertices.push_back(corners[0]);
  if (kind.corners == 2)
    m.boundary.push_back(
        {corners[0], corners[1], static_cast<vertex_index>(m.boundary.size()), groups});
  if (kind.corners == 4)
    file_.quadrilaterals.push_back(
        {{corners[0], corners[1], corners[2], corners[3]}, groups, line});
  if (kind.corners != 3) return;
  m.triangles.push_back({corners[0], corners[1], corners[2]});
  m.regions.push_back(groups);
}

// Reads the elements of versions 1 and 2: number, type, groups, and the nodes.
failure gmsh_reader::read_element_list(const std::string& end) {
  const auto elements = count("number of elements");
  if (!elements.ok()) return elements.failure();
  for (std::size_t i = 0; i < elements.value(); ++i) {
    if (auto failed = read_numbers(1, "tag of an element")) return failed;
    const auto kind = read_kind();
    if (!kind.ok()) return kind.failure();
    const std::size_t line = source_.line();
    const auto group = version_ == 1 ? read_group_of_one() : read_group_of_two();
    if (!group.ok()) return group.failure();
    const int groups =
        group.value() == 0 ? 0 : groups_.number_of_set(dimension_of(kind.value()), {group.value()});
    if (auto failed = read_element(kind.value(), line, groups)) return failed;
  }
  return expect(end);
}

// Returns the physical group of an element of version 1. Skips its entity and its number of nodes,
// which follows from its type.
result<int> gmsh_reader::read_group_of_one() {
  const auto group = to_marker(source_, source_.next(), "physical group");
  if (!group.ok()) return group;
  if (auto failed = read_numbers(2, "entity of an element")) return std::move(*failed);
  return group;
}

// Reads the tags, of which the first is the physical group; 0 if there are none.
result<int> gmsh_reader::read_group_of_two() {
  const auto tags = count("number of tags");
  if (!tags.ok()) return tags.failure();
  int group = 0;
  for (std::size_t k = 0; k < tags.value(); ++k) {
    const auto tag = to_marker(source_, source_.next(), "tag");
    if (!tag.ok()) return tag;
    if (k == 0) group = tag.value();
  }
  return group;
}

failure gmsh_reader::read_elements_of_four() {
  const auto blocks = count("number of blocks");
  if (!blocks.ok()) return blocks.failure();
  if (auto failed = read_numbers(minor_ > 0 ? 3 : 1, "count of elements")) return failed;
  for (std::size_t i = 0; i < blocks.value(); ++i)
    if (auto failed = read_element_block()) return failed;
  return expect("$EndElements");
}

failure gmsh_reader::read_element_block() {
  // Reads the entity first in version 4.0, the dimension first in 4.1.
  const auto first = integer("entity of elements"), second = integer("entity of elements");
  if (!first.ok()) return first.failure();
  if (!second.ok()) return second.failure();
  const long long entity = minor_ > 0 ? second.value() : first.value();
  const auto kind = read_kind();
  if (!kind.ok()) return kind.failure();
  const auto elements = count("number of elements");
  if (!elements.ok()) return elements.failure();
  const int dimension = dimension_of(kind.value());
  const auto group = physical_.find({dimension, entity});
  const int groups = group == physical_.end() ? 0 : group->second;
  if (group == physical_.end() && !physical_.empty() && dimension > 0)
    unlisted_.push_back(fmt::format("{} {} on line {}", dimension == 1 ? "curve" : "surface",
                                    entity, source_.line()));
  for (std::size_t i = 0; i < elements.value(); ++i) {
    if (auto failed = read_numbers(1, "tag of an element")) return failed;
    if (auto failed = read_element(kind.value(), source_.line(), groups)) return failed;
  }
  return {};
}

// Reads string tags, real tags and integer tags; the first string is the name, the second integer
// the number of components.
failure gmsh_reader::read_node_data() {
  const std::size_t line = source_.line();
  const auto strings = count("number of string tags");
  if (!strings.ok()) return strings.failure();
  const std::string name = strings.value() == 1 ? std::string(source_.next().text) : std::string();
  if (name != "\"metric\"" || !has_nodes()) return skip_to_end("$EndNodeData", line);
  const auto reals = count("number of real tags");
  if (!reals.ok()) return reals.failure();
  if (auto failed = read_numbers(reals.value(), "real tag")) return failed;
  const auto integers = count("number of integer tags");
  if (!integers.ok()) return integers.failure();
  std::vector<long long> tags;
  for (std::size_t i = 0; i < integers.value(); ++i) {
    const auto tag = integer("integer tag");
    if (!tag.ok()) return tag.failure();
    tags.push_back(tag.value());
  }
  const auto vertices = static_cast<long long>(file_.content.sites.size());
  if (tags.size() < 3 || tags[1] != 9 || tags[2] != vertices)
    return source_.failure(line, "a metric has nine components at each node");
  return read_metric();
}

failure gmsh_reader::read_metric() {
  std::vector<char> seen(file_.content.sites.size(), 0);
  for (std::size_t i = 0; i < seen.size(); ++i) {
    const word w = source_.next();
    const auto tag = to_integer(source_, w, "node of a metric");
    if (!tag.ok()) return tag.failure();
    const auto v = vertex_of_.find(tag.value());
    if (v == vertex_of_.end() || std::exchange(seen[v->second], 1) != 0)
      return source_.failure(
          w.line, "metric: node " + quoted_token(w.text) + " does not exist, or has one already");
    double entries[9] = {};
    for (double& x : entries) {
      const auto value = to_number(source_, source_.next(), "entry of a metric");
      if (!value.ok()) return value.failure();
      x = value.value();
    }
    const metric_tensor m{entries[0], entries[1], entries[4]};
    if (entries[1] != entries[3] || !filtered_kernel().is_positive_definite(m))
      return source_.failure(w.line, "the metric of node " + quoted_token(w.text) +
                                         " is not symmetric and positive definite");
    file_.content.sites[v->second].metric = m;
  }
  file_.has_metric = true;
  return expect("$EndNodeData");
}

failure gmsh_reader::finish() {
  mesh& m = file_.content;
  if (version_ < 4) groups_.unite_repeated(file_);
  groups_.settle(file_);
  file_.all_edges = true;
  if (auto failed = put_in_order(file_, listed_order::put_right)) return failed;
  const std::vector<vertex_index> points = std::exchange(file_.marks.required_vertices, {});
  bool in_order = true;
  for (std::size_t i = 0; i < points.size(); ++i) in_order = in_order && points[i] == i;
  m.given = in_order ? static_cast<vertex_index>(points.size()) : 0;
  return {};
}

}  // namespace

result<listed_mesh> read_gmsh(const std::filesystem::path& path) {
  const auto text = read_text_file(path);
  if (!text.ok()) return text.failure();
  text_scanner source(path.string(), text.value(), '\0');
  if (is_freefem_mesh(source)) return read_freefem(source);
  gmsh_reader reader(source);
  if (auto failed = reader.read()) return std::move(*failed);
  if (auto failed = reader.finish()) return std::move(*failed);
  return reader.take();
}

result<listed_mesh> read_gmsh_as_listed(text_scanner& source) {
  gmsh_reader reader(source);
  if (auto failed = reader.read()) return std::move(*failed);
  return reader.take();
}

}  // namespace asterism::internal
