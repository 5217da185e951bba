// SPDX-License-Identifier: MIT
#include "asterism/mesh/io/gmsh_solution.hpp"

#include <fmt/format.h>

#include <array>
#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

#include "asterism/core/number_text.hpp"
#include "asterism/mesh/io/gmsh_source.hpp"

namespace asterism::internal {
namespace {

class node_data_reader : private gmsh_source {
 public:
  explicit node_data_reader(text_scanner& source) : gmsh_source(source) {}

  failure read();
  solution take() { return made_; }
  // Returns a note for each field of which there are several steps.
  std::vector<std::string> notes(const std::string& file) const;

 private:
  failure read_data(std::size_t line);
  failure read_values(const std::string& name, std::size_t width, std::size_t step);

  // Counts the steps of a field, and names the one taken, the last in the file.
  struct steps {
    std::size_t count = 0, taken = 0;
  };

  solution made_;
  std::vector<steps> steps_;  // of each field
};

// Skips all sections except those of nodes and node data.
failure node_data_reader::read() {
  if (auto failed = read_version()) return failed;
  for (word head = source_.next(); !head.empty(); head = source_.next()) {
    const std::string name(head.text);
    failure failed;
    if (name == "$Nodes" || name == "$NOD")
      failed = read_nodes(head);
    else if (name == "$NodeData")
      failed = read_data(head.line);
    else if (name.starts_with("$"))
      failed = skip_to_end((version_ == 1 ? "$END" : "$End") + name.substr(1), head.line);
    if (failed) return failed;
  }
  made_.vertices = vertex_of_.size();
  return {};
}

failure node_data_reader::read_data(std::size_t line) {
  const auto strings = count("number of string tags");
  if (!strings) return strings.failure();
  std::string name;
  for (std::size_t i = 0; i < strings.value(); ++i) {
    const std::vector<word> tag = source_.next_line();
    if (tag.empty()) return source_.failure(source_.line(), "a name in \" wanted");
    if (i > 0) continue;
    const char* const begin = tag[0].text.data();
    name.assign(begin, tag.back().text.data() + tag.back().text.size());
    if (name.size() > 1 && name.front() == '"' && name.back() == '"')
      name = name.substr(1, name.size() - 2);
  }
  const auto reals = count("number of real tags");
  if (!reals) return reals.failure();
  if (auto failed = read_numbers(reals.value(), "real tag")) return failed;
  const auto integers = count("number of integer tags");
  if (!integers) return integers.failure();
  std::vector<std::size_t> tags;
  for (std::size_t i = 0; i < integers.value(); ++i) {
    const auto tag = count("integer tag");
    if (!tag) return tag.failure();
    tags.push_back(tag.value());
  }
  if (tags.size() < 3) return source_.failure(line, "node data have three integer tags");
  const std::size_t width = tags[1];
  const bool is_field = width == 1 || width == 3 || width == 9;
  if (name == "metric" || !is_field) return skip_to_end("$EndNodeData", line);
  if (tags[2] != vertex_of_.size())
    return source_.failure(line, "node data " + quoted_token(name) + " of " +
                                     std::to_string(tags[2]) + " nodes, and there are " +
                                     std::to_string(vertex_of_.size()));
  if (auto failed = read_values(name, width, tags[0])) return failed;
  return skip_to_end("$EndNodeData", line);
}

// Returns the values of a field of the plane; none if it has other components.
std::optional<std::vector<double>> in_plane(const std::array<double, 9>& x, std::size_t width) {
  if (width == 1) return std::vector{x[0]};
  if (width == 3) return x[2] == 0 ? std::optional(std::vector{x[0], x[1]}) : std::nullopt;
  const bool is_plane = x[1] == x[3] && x[2] == 0 && x[5] == 0 && x[6] == 0 && x[7] == 0;
  return is_plane ? std::optional(std::vector{x[0], x[1], x[4]}) : std::nullopt;
}

failure node_data_reader::read_values(const std::string& name, std::size_t width,
                                      std::size_t step) {
  const std::size_t kept = width == 1 ? 1 : width == 3 ? 2 : 3;
  solution_field field{name, static_cast<field_kind>(kept),
                       std::vector<double>(kept * vertex_of_.size())};
  std::vector<char> seen(vertex_of_.size(), 0);
  for (std::size_t i = 0; i < vertex_of_.size(); ++i) {
    const word w = source_.next();
    const auto tag = to_integer(source_, w, "node of node data");
    if (!tag) return tag.failure();
    const auto at = vertex_of_.find(tag.value());
    if (at == vertex_of_.end() || std::exchange(seen[at->second], 1) != 0)
      return source_.failure(w.line, "node " + quoted_token(w.text) +
                                         " does not exist, or has a value of " +
                                         quoted_token(name) + " already");
    std::array<double, 9> numbers{};
    for (std::size_t k = 0; k < width; ++k) {
      const auto x = to_number(source_, source_.next(), "value of node data");
      if (!x) return x.failure();
      numbers[k] = x.value();
    }
    const auto values = in_plane(numbers, width);
    if (!values) return {};
    for (std::size_t k = 0; k < kept; ++k) field.values[kept * at->second + k] = (*values)[k];
  }
  std::size_t at = 0;
  while (at < made_.fields.size() && made_.fields[at].name != name) ++at;
  if (at == made_.fields.size()) {
    made_.fields.emplace_back();
    steps_.emplace_back();
  }
  made_.fields[at] = std::move(field);
  steps_[at] = {steps_[at].count + 1, step};
  return {};
}

std::vector<std::string> node_data_reader::notes(const std::string& file) const {
  std::vector<std::string> all;
  for (std::size_t k = 0; k < steps_.size(); ++k)
    if (steps_[k].count > 1)
      all.push_back(
          fmt::format("{}: the field {} is there {} times, and the last one is taken: step {}",
                      file, quoted_token(made_.fields[k].name), steps_[k].count, steps_[k].taken));
  return all;
}

}  // namespace

result<solution> read_gmsh_solution(std::string_view text, const std::string& file) {
  text_scanner source(file, text);
  node_data_reader reader(source);
  if (auto failed = reader.read()) return *failed;
  solution made = reader.take();
  made.notes = reader.notes(file);
  return made;
}

}  // namespace asterism::internal
