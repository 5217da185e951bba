// SPDX-License-Identifier: MIT
#include <array>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

#include "asterism/core/number_text.hpp"
#include "asterism/mesh/io/listed_numbers.hpp"
#include "asterism/mesh/io/listed_readers.hpp"

namespace asterism::internal {
namespace {

using failure = std::optional<error>;
using words = std::vector<word>;

class adcirc_reader {
 public:
  adcirc_reader(std::string_view text, const std::string& file) : source_(file, text, '\0') {
    made_.file = file;
  }

  failure read();
  listed_mesh take() { return std::move(made_); }

 private:
  failure next_line(words& line, std::size_t least, std::string_view what);
  result<std::size_t> count(const word& w, std::string_view what);
  failure read_nodes(std::size_t count);
  failure read_elements(std::size_t count);
  failure read_boundaries(bool open);
  failure read_boundary(bool open);
  failure read_string(std::size_t nodes, bool paired, int marker, bool closed);
  void add_edges(const std::vector<vertex_index>& nodes, int marker, bool closed);

  text_scanner source_;
  listed_mesh made_;
  listed_numbers numbers_;
  bool has_depths_ = false;
  std::size_t open_ = 0, land_ = 0;
};

failure adcirc_reader::next_line(words& line, std::size_t least, std::string_view what) {
  source_.next_line(line);
  if (line.size() >= least) return {};
  return source_.failure(
      source_.line(), line.empty() ? "the file ends where " + std::string(what) + " should follow"
                                   : std::string(what) + " wanted");
}

result<std::size_t> adcirc_reader::count(const word& w, std::string_view what) {
  auto made = to_count(source_, w, what);
  if (made && made.value() > std::numeric_limits<vertex_index>::max() / 4)
    return source_.failure(w.line, std::string(what) + ": more than 32-bit numbers can name");
  return made;
}

failure adcirc_reader::read() {
  source_.rest_of_line();  // the title
  words line;
  if (auto failed = next_line(line, 2, "the numbers of elements and nodes")) return failed;
  const auto elements = count(line[0], "number of elements"),
             nodes = count(line[1], "number of nodes");
  if (!elements) return elements.failure();
  if (!nodes) return nodes.failure();
  if (auto failed = read_nodes(nodes.value())) return failed;
  if (auto failed = read_elements(elements.value())) return failed;
  // Accepts a grid that ends without its boundaries.
  for (const bool open : {true, false})
    if (!text_scanner(source_).next().empty())
      if (auto failed = read_boundaries(open)) return failed;
  if (has_depths_)
    made_.content.notes.push_back(source_.file() +
                                  ": depths of nodes are no part of a plane mesh and are left out");
  made_.all_edges = made_.edges_are_strings = true;
  return put_in_order(made_, listed_order::put_right);
}

failure adcirc_reader::read_nodes(std::size_t nodes) {
  words line;
  for (std::size_t i = 0; i < nodes; ++i) {
    if (auto failed = next_line(line, 3, "number, x, y and depth of a node")) return failed;
    if (auto failed = numbers_.add(source_, line[0])) return failed;
    const auto at = to_point(source_, line[1], line[2], "a node");
    if (!at) return at.failure();
    if (line.size() > 3) {
      const auto depth = to_number(source_, line[3], "depth of a node");
      has_depths_ = has_depths_ || !depth || depth.value() != 0;
    }
    made_.content.sites.push_back({at.value(), {1, 0, 1}});
  }
  return {};
}

failure adcirc_reader::read_elements(std::size_t elements) {
  words line;
  for (std::size_t i = 0; i < elements; ++i) {
    if (auto failed = next_line(line, 5, "number, 3 and the nodes of an element")) return failed;
    const auto corners = to_integer(source_, line[1], "nodes of an element");
    if (!corners) return corners.failure();
    if ((corners.value() != 3 && corners.value() != 4) ||
        line.size() < 2 + static_cast<std::size_t>(corners.value()))
      return source_.failure(line[1].line, "an element of " + quoted_token(line[1].text) +
                                               " nodes: triangles and quadrilaterals can be read");
    const auto count = static_cast<std::size_t>(corners.value());
    std::array<vertex_index, 4> c{};
    for (std::size_t k = 0; k < count; ++k) {
      const auto v = numbers_.find(source_, line[2 + k], "node of an element");
      if (!v) return v.failure();
      c[k] = v.value();
    }
    if (count == 3)
      made_.content.triangles.push_back({c[0], c[1], c[2]});
    else
      made_.quadrilaterals.push_back({c, 1, line[1].line});
  }
  return {};
}

failure adcirc_reader::read_boundaries(bool open) {
  words line;
  const char* const what = open ? "the number of open boundaries" : "the number of land boundaries";
  if (auto failed = next_line(line, 1, what)) return failed;
  const auto strings = count(line[0], what);
  if (!strings) return strings.failure();
  if (text_scanner(source_).next().empty() && strings.value() == 0) return {};
  if (auto failed = next_line(line, 1, "the number of their nodes")) return failed;
  for (std::size_t i = 0; i < strings.value(); ++i)
    if (auto failed = read_boundary(open)) return failed;
  return {};
}

// Reads the kind of a boundary. Kinds 4, 5, 24 and 25, barriers inside, list pairs of nodes; kinds
// 1, 11 and 21, islands, are closed.
failure adcirc_reader::read_boundary(bool open) {
  words line;
  if (auto failed = next_line(line, 1, "the number of nodes of a boundary")) return failed;
  const auto nodes = count(line[0], "number of nodes of a boundary");
  if (!nodes) return nodes.failure();
  long long kind = 0;
  if (line.size() > 1)
    if (const auto read = to_integer(source_, line[1], "kind of a boundary")) kind = read.value();
  const bool paired = !open && (kind == 4 || kind == 5 || kind == 24 || kind == 25);
  const bool closed = !open && (kind == 1 || kind == 11 || kind == 21);
  const auto marker = static_cast<int>(open_ + land_ + 1);
  const std::size_t number = open ? ++open_ : ++land_;
  made_.names.markers[marker] = (open ? "open " : "land ") + std::to_string(number) +
                                (open ? "" : " of type " + std::to_string(kind));
  return read_string(nodes.value(), paired, marker, closed);
}

failure adcirc_reader::read_string(std::size_t nodes, bool paired, int marker, bool closed) {
  std::vector<vertex_index> front, back;
  words line;
  for (std::size_t i = 0; i < nodes; ++i) {
    if (auto failed = next_line(line, paired ? 2 : 1, "a node of a boundary")) return failed;
    const auto v = numbers_.find(source_, line[0], "node of a boundary");
    if (!v) return v.failure();
    front.push_back(v.value());
    if (!paired) continue;
    const auto w = numbers_.find(source_, line[1], "node of a boundary");
    if (!w) return w.failure();
    back.push_back(w.value());
  }
  add_edges(front, marker, closed);
  add_edges(back, marker, closed);
  return {};
}

void adcirc_reader::add_edges(const std::vector<vertex_index>& nodes, int marker, bool closed) {
  auto& edges = made_.content.boundary;
  const auto add = [&](vertex_index a, vertex_index b) {
    if (a != b) edges.push_back({a, b, static_cast<vertex_index>(edges.size()), marker});
  };
  for (std::size_t i = 0; i + 1 < nodes.size(); ++i) add(nodes[i], nodes[i + 1]);
  if (closed && nodes.size() > 2) add(nodes.back(), nodes.front());
}

}  // namespace

result<listed_mesh> read_adcirc(std::string_view text, const std::string& file) {
  adcirc_reader reader(text, file);
  if (auto failed = reader.read()) return *failed;
  return reader.take();
}

}  // namespace asterism::internal
