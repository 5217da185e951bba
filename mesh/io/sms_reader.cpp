// SPDX-License-Identifier: MIT
#include <array>
#include <charconv>
#include <cmath>
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

// Cards of elements: the number of nodes around the element, and whether every second one is a
// corner.
struct element_card {
  std::string_view name;
  std::size_t corners, nodes;
};
constexpr std::array<element_card, 7> element_cards = {{{"E3T", 3, 3},
                                                        {"E6T", 3, 6},
                                                        {"E4Q", 4, 4},
                                                        {"E8Q", 4, 8},
                                                        {"E9Q", 4, 9},
                                                        {"E2L", 2, 2},
                                                        {"E3L", 2, 3}}};
constexpr std::array<std::string_view, 6> solid_cards = {"E4T", "E5P",  "E6W",
                                                         "E8H", "E10T", "E20H"};

class sms_reader {
 public:
  sms_reader(std::string_view text, const std::string& file) : source_(file, text) {
    made_.file = file;
  }

  failure read();
  listed_mesh take() { return std::move(made_); }

 private:
  struct element {
    const element_card* card;
    std::array<word, 4> corners;
    int material;
  };

  failure read_card(const words& line);
  failure read_node(const words& line);
  failure read_element(const element_card& card, const words& line);
  failure read_string(const words& line);
  failure skip_parameters();
  failure add_elements();
  void name_string(const std::string& name);
  void end_string();

  text_scanner source_;
  listed_mesh made_;
  listed_numbers numbers_;
  std::vector<element> elements_;  // nodes may follow them
  std::vector<word> string_;
  struct node_string {
    std::vector<word> nodes;
    int marker;
  };
  std::vector<node_string> strings_;
  bool has_heights_ = false;
};

failure sms_reader::read() {
  words line;
  source_.next_line(line);
  if (line.empty() || line.front().text != "MESH2D")
    return source_.failure(source_.line(), "MESH2D wanted on the first line");
  for (source_.next_line(line); !line.empty(); source_.next_line(line))
    if (auto failed = read_card(line)) return failed;
  if (!string_.empty()) end_string();
  if (auto failed = add_elements()) return failed;
  if (has_heights_)
    made_.content.notes.push_back(
        source_.file() +
        ": heights of nodes, a bed's, are no part of a plane mesh and are "
        "left out");
  made_.all_edges = made_.edges_are_strings = true;
  return put_in_order(made_, listed_order::put_right);
}

failure sms_reader::read_card(const words& line) {
  const std::string_view name = line.front().text;
  if (name == "ND") return read_node(line);
  if (name == "NS") return read_string(line);
  for (const element_card& card : element_cards)
    if (name == card.name) return read_element(card, line);
  for (const std::string_view solid : solid_cards)
    if (name == solid)
      return source_.failure(line.front().line,
                             quoted_token(name) + ": only plane elements can be read");
  if (name == "BEGPARAMDEF") return skip_parameters();
  return {};
}

failure sms_reader::skip_parameters() {
  words line;
  for (source_.next_line(line); !line.empty(); source_.next_line(line))
    if (line.front().text == "ENDPARAMDEF") return {};
  return {};
}

failure sms_reader::read_node(const words& line) {
  if (line.size() < 4)
    return source_.failure(line.front().line, "number, x, y and z of a node wanted");
  if (auto failed = numbers_.add(source_, line[1])) return failed;
  const auto at = to_point(source_, line[2], line[3], "a node");
  if (!at) return at.failure();
  if (line.size() > 4) {
    const auto z = to_number(source_, line[4], "z of a node");
    has_heights_ = has_heights_ || !z || z.value() != 0;
  }
  made_.content.sites.push_back({at.value(), {1, 0, 1}});
  return {};
}

failure sms_reader::read_element(const element_card& card, const words& line) {
  if (line.size() < 2 + card.nodes)
    return source_.failure(line.front().line, quoted_token(card.name) + " has a number and " +
                                                  std::to_string(card.nodes) + " nodes");
  element made{&card, {}, 1};
  const std::size_t step = card.nodes > card.corners ? 2 : 1;
  for (std::size_t k = 0; k < card.corners; ++k) made.corners[k] = line[2 + k * step];
  if (line.size() > 2 + card.nodes) {
    const word& w = line[2 + card.nodes];
    const auto material = to_number(source_, w, "material of an element");
    if (!material) return material.failure();
    if (std::floor(material.value()) != material.value() || std::abs(material.value()) > 1e15)
      return source_.failure(
          w.line, "material of an element: " + quoted_token(w.text) + " is no whole number");
    made.material = made_.wide.number(static_cast<long long>(material.value()));
  }
  if (card.nodes > card.corners) ++made_.second_order;
  elements_.push_back(made);
  return {};
}

// Reads a string over several lines, up to a negative number; its own number, or name, may follow.
failure sms_reader::read_string(const words& line) {
  for (std::size_t i = 1; i < line.size(); ++i) {
    word node = line[i];
    const bool is_last = node.text.starts_with('-');
    if (is_last) node.text.remove_prefix(1);
    string_.push_back(node);
    if (!is_last) continue;
    end_string();
    if (i + 1 < line.size()) {
      const char* const begin = line[i + 1].text.data();
      std::string_view name(begin, line.back().text.data() + line.back().text.size() - begin);
      if (name.size() > 1 && name.front() == '"' && name.back() == '"')
        name = name.substr(1, name.size() - 2);
      name_string(without_controls(std::string(name)));
    }
    break;
  }
  return {};
}

// Takes a whole number as the string's marker. With another name the string keeps the number of its
// place in the file as its marker.
void sms_reader::name_string(const std::string& name) {
  int number = 0;
  const auto [end, failed] = std::from_chars(name.data(), name.data() + name.size(), number);
  if (failed == std::errc() && end == name.data() + name.size())
    strings_.back().marker = number;
  else
    made_.names.markers[strings_.back().marker] = "string " + name;
}

void sms_reader::end_string() {
  const int marker = static_cast<int>(strings_.size()) + 1;
  strings_.push_back({std::move(string_), marker});
  string_.clear();
}

failure sms_reader::add_elements() {
  mesh& m = made_.content;
  for (const element& e : elements_) {
    std::array<vertex_index, 4> c{};
    for (std::size_t k = 0; k < e.card->corners; ++k) {
      const auto v = numbers_.find(source_, e.corners[k], "node of an element");
      if (!v) return v.failure();
      c[k] = v.value();
    }
    if (e.card->corners == 4) {
      made_.quadrilaterals.push_back({c, e.material, e.corners[0].line});
    } else if (e.card->corners == 3) {
      m.triangles.push_back({c[0], c[1], c[2]});
      m.regions.push_back(e.material);
    } else {
      m.boundary.push_back({c[0], c[1], static_cast<vertex_index>(m.boundary.size()), e.material});
    }
  }
  for (const node_string& s : strings_)
    for (std::size_t i = 0; i < s.nodes.size(); ++i) {
      const auto v = numbers_.find(source_, s.nodes[i], "node of a string");
      if (!v) return v.failure();
      if (i == 0) continue;
      const auto u = numbers_.find(source_, s.nodes[i - 1], "node of a string");
      if (u.value() != v.value())
        m.boundary.push_back(
            {u.value(), v.value(), static_cast<vertex_index>(m.boundary.size()), s.marker});
    }
  return {};
}

}  // namespace

result<listed_mesh> read_sms(std::string_view text, const std::string& file) {
  sms_reader reader(text, file);
  if (auto failed = reader.read()) return *failed;
  return reader.take();
}

}  // namespace asterism::internal
