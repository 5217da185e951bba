// SPDX-License-Identifier: MIT
#include <algorithm>
#include <array>
#include <cstddef>
#include <map>
#include <optional>
#include <string_view>
#include <unordered_map>
#include <utility>
#include <vector>

#include "asterism/core/number_text.hpp"
#include "asterism/kernels/filtered_kernel.hpp"
#include "asterism/mesh/io/gmsh.hpp"
#include "asterism/mesh/io/medit_edges.hpp"
#include "asterism/mesh/io/text_scanner.hpp"

namespace asterism::internal {
namespace {

using failure = std::optional<error>;

constexpr long long line_element = 1, triangle_element = 2, point_element = 15;

class gmsh_reader {
 public:
  explicit gmsh_reader(text_scanner& source) : source_(source) {}

  failure read();
  gmsh_file take() { return std::move(file_); }

 private:
  failure read_format();
  failure read_section(const word& head);
  failure read_names();
  failure read_entities();
  failure read_entity(int dimension);
  failure read_nodes_of_two();
  failure read_nodes_of_four();
  failure read_node_block();
  failure read_elements_of_two();
  failure read_elements_of_four();
  failure read_element_block();
  // Reads the vertices of an element, which is in `number` of its kind.
  failure read_element(long long type, std::size_t line, int number);
  failure read_node_data();
  failure read_metric();
  failure skip_to_end(const std::string& section, std::size_t line);
  failure expect(const std::string& wanted);
  failure finish();

  failure add_node(const word& tag);
  failure read_position(site& s);
  failure read_numbers(std::size_t count, std::string_view what);
  result<long long> integer(std::string_view what) {
    return to_integer(source_, source_.next(), what);
  }
  result<std::size_t> count(std::string_view what) {
    return to_count(source_, source_.next(), what);
  }
  result<vertex_index> vertex(std::string_view what);
  // Returns the number that a physical group stands for: its tag, or what its name says.
  int number_of(int dimension, int tag) const;

  text_scanner& source_;
  gmsh_file file_;
  int version_ = 0;
  bool nodes_seen_ = false, elements_seen_ = false, grouped_ = false;
  std::unordered_map<long long, vertex_index> vertex_of_;
  std::map<std::pair<int, long long>, int> physical_;  // tag of each entity, by its dimension
  std::map<std::pair<int, int>, std::string> names_;   // of physical groups, by dimension and tag
  std::vector<vertex_index> points_;
};

failure gmsh_reader::read() {
  if (auto failed = read_format()) return failed;
  while (true) {
    const word head = source_.next();
    if (head.empty()) break;
    if (auto failed = read_section(head)) return failed;
  }
  return finish();
}

failure gmsh_reader::read_format() {
  const word head = source_.next();
  if (head.text != "$MeshFormat")
    return source_.failure(head.line, "$MeshFormat wanted, not " + quoted_token(head.text));
  const word version = source_.next();
  if (version.text == "4.1")
    version_ = 4;
  else if (version.text == "2.2")
    version_ = 2;
  else
    return source_.failure(version.line, "version " + quoted_token(version.text) +
                                             ": 4.1 and 2.2 can be read; gmsh -save -format msh41 "
                                             "writes the first");
  const auto kind = integer("kind of file");
  if (!kind.ok()) return kind.failure();
  if (kind.value() != 0)
    return source_.failure(
        version.line, "a binary file: only text can be read; gmsh -save -format msh41 writes it");
  const auto size = integer("size of numbers");
  if (!size.ok()) return size.failure();
  return expect("$EndMeshFormat");
}

failure gmsh_reader::read_section(const word& head) {
  const std::string name(head.text);
  if (name.empty() || name.front() != '$')
    return source_.failure(head.line, "a section wanted, not " + quoted_token(head.text));
  if (name == "$PhysicalNames") return read_names();
  if (name == "$Entities") return read_entities();
  if (name == "$Nodes") {
    if (std::exchange(nodes_seen_, true)) return source_.failure(head.line, "a second $Nodes");
    return version_ == 2 ? read_nodes_of_two() : read_nodes_of_four();
  }
  if (name == "$Elements") {
    if (!nodes_seen_) return source_.failure(head.line, "$Elements before $Nodes");
    if (std::exchange(elements_seen_, true))
      return source_.failure(head.line, "a second $Elements");
    return version_ == 2 ? read_elements_of_two() : read_elements_of_four();
  }
  if (name == "$NodeData") return read_node_data();
  return skip_to_end("$End" + name.substr(1), head.line);
}

failure gmsh_reader::expect(const std::string& wanted) {
  const word w = source_.next();
  if (w.text == wanted) return {};
  return source_.failure(w.line, wanted + " wanted, not " + quoted_token(w.text));
}

failure gmsh_reader::skip_to_end(const std::string& section, std::size_t line) {
  for (word w = source_.next(); !w.empty(); w = source_.next())
    if (w.text == section) return {};
  return source_.failure(line, section + " is missing");
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
    names_[{dimension.value(), tag.value()}] = name.substr(1, name.size() - 2);
  }
  return expect("$EndPhysicalNames");
}

failure gmsh_reader::read_numbers(std::size_t count, std::string_view what) {
  for (std::size_t i = 0; i < count; ++i)
    if (const auto x = to_number(source_, source_.next(), what); !x.ok()) return x.failure();
  return {};
}

failure gmsh_reader::read_entities() {
  std::size_t counts[4] = {};
  for (std::size_t& n : counts) {
    const auto wanted = count("number of entities");
    if (!wanted.ok()) return wanted.failure();
    n = wanted.value();
  }
  for (int dimension = 0; dimension < 4; ++dimension)
    for (std::size_t i = 0; i < counts[dimension]; ++i)
      if (auto failed = read_entity(dimension)) return failed;
  return expect("$EndEntities");
}

failure gmsh_reader::read_entity(int dimension) {
  const word w = source_.next();
  const auto tag = to_integer(source_, w, "tag of an entity");
  if (!tag.ok()) return tag.failure();
  if (auto failed = read_numbers(dimension == 0 ? 3 : 6, "box of an entity")) return failed;
  const auto groups = count("number of physical groups");
  if (!groups.ok()) return groups.failure();
  for (std::size_t i = 0; i < groups.value(); ++i) {
    const word group = source_.next();
    const auto number = to_marker(source_, group, "physical group");
    if (!number.ok()) return number.failure();
    if (i > 0 && dimension > 0)
      return source_.failure(group.line, "entity " + quoted_token(w.text) +
                                             " is in several physical groups, and a marker or a "
                                             "region is one number");
    physical_[{dimension, tag.value()}] = number.value();
  }
  if (dimension == 0) return {};
  const auto bounding = count("number of bounding entities");
  if (!bounding.ok()) return bounding.failure();
  return read_numbers(bounding.value(), "bounding entity");
}

failure gmsh_reader::add_node(const word& tag) {
  const auto number = to_integer(source_, tag, "tag of a node");
  if (!number.ok()) return number.failure();
  const auto v = static_cast<vertex_index>(vertex_of_.size());
  if (!vertex_of_.emplace(number.value(), v).second)
    return source_.failure(tag.line, "node " + quoted_token(tag.text) + " is there twice");
  file_.content.sites.emplace_back();
  return {};
}

failure gmsh_reader::read_position(site& s) {
  const auto x = to_number(source_, source_.next(), "x of a node");
  if (!x.ok()) return x.failure();
  const auto y = to_number(source_, source_.next(), "y of a node");
  if (!y.ok()) return y.failure();
  const word w = source_.next();
  const auto z = to_number(source_, w, "z of a node");
  if (!z.ok()) return z.failure();
  if (z.value() != 0)
    return source_.failure(w.line, "z of a node: " + quoted_token(w.text) +
                                       " is not 0: only plane meshes can be read");
  s = {{x.value(), y.value()}, {1, 0, 1}};
  return {};
}

failure gmsh_reader::read_nodes_of_two() {
  const auto nodes = count("number of nodes");
  if (!nodes.ok()) return nodes.failure();
  for (std::size_t i = 0; i < nodes.value(); ++i) {
    if (auto failed = add_node(source_.next())) return failed;
    if (auto failed = read_position(file_.content.sites.back())) return failed;
  }
  return expect("$EndNodes");
}

failure gmsh_reader::read_nodes_of_four() {
  const auto blocks = count("number of blocks");
  if (!blocks.ok()) return blocks.failure();
  if (auto failed = read_numbers(3, "count of nodes")) return failed;
  for (std::size_t i = 0; i < blocks.value(); ++i)
    if (auto failed = read_node_block()) return failed;
  return expect("$EndNodes");
}

failure gmsh_reader::read_node_block() {
  if (auto failed = read_numbers(2, "entity of nodes")) return failed;
  const word w = source_.next();
  const auto parametric = to_integer(source_, w, "parametric");
  if (!parametric.ok()) return parametric.failure();
  if (parametric.value() != 0)
    return source_.failure(w.line, "parametric nodes cannot be read; save without them");
  const auto nodes = count("number of nodes");
  if (!nodes.ok()) return nodes.failure();
  const std::size_t first = file_.content.sites.size();
  for (std::size_t i = 0; i < nodes.value(); ++i)
    if (auto failed = add_node(source_.next())) return failed;
  for (std::size_t i = 0; i < nodes.value(); ++i)
    if (auto failed = read_position(file_.content.sites[first + i])) return failed;
  return {};
}

result<vertex_index> gmsh_reader::vertex(std::string_view what) {
  const word w = source_.next();
  const auto tag = to_integer(source_, w, what);
  if (!tag.ok()) return tag.failure();
  const auto found = vertex_of_.find(tag.value());
  if (found != vertex_of_.end()) return found->second;
  return source_.failure(w.line,
                         std::string(what) + ": node " + quoted_token(w.text) + " does not exist");
}

// The name "marker -7" stands for a number that no physical group can have.
int gmsh_reader::number_of(int dimension, int tag) const {
  const auto named = names_.find({dimension, tag});
  const std::string_view what = dimension == 1 ? "marker " : "region ";
  if (named == names_.end() || !named->second.starts_with(what)) return tag;
  const text_scanner nowhere("", "");
  const auto number = to_marker(nowhere, {std::string_view(named->second).substr(what.size()), 0},
                                "number in a name");
  return number.ok() && number.value() <= 0 ? number.value() : tag;
}

failure gmsh_reader::read_element(long long type, std::size_t line, int number) {
  mesh& m = file_.content;
  if (type == point_element) {
    const auto v = vertex("point");
    if (!v.ok()) return v.failure();
    points_.push_back(v.value());
    return {};
  }
  if (type == line_element) {
    const auto a = vertex("end of a line");
    if (!a.ok()) return a.failure();
    const auto b = vertex("end of a line");
    if (!b.ok()) return b.failure();
    m.boundary.push_back(
        {a.value(), b.value(), static_cast<vertex_index>(m.boundary.size()), number_of(1, number)});
    return {};
  }
  if (type != triangle_element)
    return source_.failure(line, "element of type " + std::to_string(type) +
                                     ": points, lines and triangles of first order can be read");
  triangle t{};
  for (vertex_index& corner : t) {
    const auto v = vertex("corner of a triangle");
    if (!v.ok()) return v.failure();
    corner = v.value();
  }
  m.triangles.push_back(t);
  m.regions.push_back(number_of(2, number));
  grouped_ = grouped_ || number != 0;
  return {};
}

failure gmsh_reader::read_elements_of_two() {
  const auto elements = count("number of elements");
  if (!elements.ok()) return elements.failure();
  for (std::size_t i = 0; i < elements.value(); ++i) {
    if (auto failed = read_numbers(1, "tag of an element")) return failed;
    const word w = source_.next();
    const auto type = to_integer(source_, w, "type of an element");
    if (!type.ok()) return type.failure();
    const auto tags = count("number of tags");
    if (!tags.ok()) return tags.failure();
    int number = 0;
    for (std::size_t k = 0; k < tags.value(); ++k) {
      const auto tag = to_marker(source_, source_.next(), "tag");
      if (!tag.ok()) return tag.failure();
      if (k == 0) number = tag.value();
    }
    if (auto failed = read_element(type.value(), w.line, number)) return failed;
  }
  return expect("$EndElements");
}

failure gmsh_reader::read_elements_of_four() {
  const auto blocks = count("number of blocks");
  if (!blocks.ok()) return blocks.failure();
  if (auto failed = read_numbers(3, "count of elements")) return failed;
  for (std::size_t i = 0; i < blocks.value(); ++i)
    if (auto failed = read_element_block()) return failed;
  return expect("$EndElements");
}

failure gmsh_reader::read_element_block() {
  const auto dimension = to_marker(source_, source_.next(), "dimension of an entity");
  if (!dimension.ok()) return dimension.failure();
  const auto entity = integer("entity of elements");
  if (!entity.ok()) return entity.failure();
  const word w = source_.next();
  const auto type = to_integer(source_, w, "type of an element");
  if (!type.ok()) return type.failure();
  const auto elements = count("number of elements");
  if (!elements.ok()) return elements.failure();
  const auto group = physical_.find({dimension.value(), entity.value()});
  const int number = group == physical_.end() ? 0 : group->second;
  for (std::size_t i = 0; i < elements.value(); ++i) {
    if (auto failed = read_numbers(1, "tag of an element")) return failed;
    if (auto failed = read_element(type.value(), w.line, number)) return failed;
  }
  return {};
}

// String tags, real tags, integer tags; the first string is the name, the second integer the number
// of components.
failure gmsh_reader::read_node_data() {
  const std::size_t line = source_.line();
  const auto strings = count("number of string tags");
  if (!strings.ok()) return strings.failure();
  const std::string name = strings.value() == 1 ? std::string(source_.next().text) : std::string();
  if (name != "\"metric\"" || !nodes_seen_) return skip_to_end("$EndNodeData", line);
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
  if (!elements_seen_) return source_.failure(source_.line(), "there is no section $Elements");
  if (!grouped_ || std::all_of(m.regions.begin(), m.regions.end(), [](int r) { return r == 1; }))
    m.regions.clear();
  bool in_order = true;
  for (std::size_t i = 0; i < points_.size(); ++i) in_order = in_order && points_[i] == i;
  m.given = in_order ? static_cast<vertex_index>(points_.size()) : 0;
  keep_segments(m, {std::vector<char>(m.boundary.size(), 1), true});
  list_sides(m);
  for (const auto& [place, name] : names_) {
    if (place.first == 1) file_.names.markers[number_of(1, place.second)] = name;
    if (place.first == 2) file_.names.regions[number_of(2, place.second)] = name;
  }
  return {};
}

}  // namespace

result<gmsh_file> read_gmsh(const std::filesystem::path& path) {
  const auto text = read_text_file(path);
  if (!text.ok()) return text.failure();
  text_scanner source(path.string(), text.value());
  gmsh_reader reader(source);
  if (auto failed = reader.read()) return std::move(*failed);
  return reader.take();
}

}  // namespace asterism::internal
