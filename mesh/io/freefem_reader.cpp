// SPDX-License-Identifier: MIT
#include <limits>
#include <optional>
#include <string_view>

#include "asterism/core/number_text.hpp"
#include "asterism/mesh/io/listed_readers.hpp"

namespace asterism::internal {
namespace {

using failure = std::optional<error>;

class freefem_reader {
 public:
  explicit freefem_reader(text_scanner& source) : source_(source) { made_.file = source.file(); }

  failure read();
  listed_mesh take() { return std::move(made_); }

 private:
  failure read_vertices(std::size_t count);
  failure read_triangles(std::size_t count);
  failure read_edges(std::size_t count);
  result<vertex_index> vertex(std::string_view meaning);
  result<int> label(std::string_view meaning) {
    return made_.wide.read(source_, source_.next(), meaning);
  }

  text_scanner& source_;
  listed_mesh made_;
};

failure freefem_reader::read() {
  std::size_t counts[3] = {};
  const std::string_view names[] = {"number of vertices", "number of triangles", "number of edges"};
  for (std::size_t i = 0; i < 3; ++i) {
    const word w = source_.next();
    const auto count = to_count(source_, w, names[i]);
    if (!count) return count.failure();
    if (count.value() > std::numeric_limits<vertex_index>::max() / 4)
      return source_.failure(w.line, "more than 32-bit numbers can name");
    counts[i] = count.value();
  }
  if (auto failed = read_vertices(counts[0])) return failed;
  if (auto failed = read_triangles(counts[1])) return failed;
  if (auto failed = read_edges(counts[2])) return failed;
  const word more = source_.next();
  if (!more.empty())
    return source_.failure(more.line, quoted_token(more.text) + " after the last edge");
  return put_in_order(made_, listed_order::put_right);
}

failure freefem_reader::read_vertices(std::size_t count) {
  for (std::size_t i = 0; i < count; ++i) {
    const word x = source_.next(), y = source_.next();
    const auto at = to_point(source_, x, y, "a vertex");
    if (!at) return at.failure();
    const auto reference = label("label of a vertex");
    if (!reference) return reference.failure();
    made_.content.sites.push_back({at.value(), {1, 0, 1}});
    made_.content.references.push_back(reference.value());
  }
  return {};
}

result<vertex_index> freefem_reader::vertex(std::string_view meaning) {
  const word w = source_.next();
  const auto number = to_integer(source_, w, meaning);
  if (!number) return number.failure();
  const auto count = static_cast<long long>(made_.content.sites.size());
  if (number.value() < 1 || number.value() > count)
    return source_.failure(w.line, std::string(meaning) + ": vertex " + quoted_token(w.text) +
                                       " does not exist; there are " + std::to_string(count));
  return static_cast<vertex_index>(number.value() - 1);
}

failure freefem_reader::read_triangles(std::size_t count) {
  for (std::size_t i = 0; i < count; ++i) {
    triangle t{};
    for (vertex_index& corner : t) {
      const auto v = vertex("corner of a triangle");
      if (!v) return v.failure();
      corner = v.value();
    }
    const auto region = label("label of a triangle");
    if (!region) return region.failure();
    made_.content.triangles.push_back(t);
    made_.content.regions.push_back(region.value());
  }
  return {};
}

failure freefem_reader::read_edges(std::size_t count) {
  for (std::size_t i = 0; i < count; ++i) {
    const auto a = vertex("end of an edge");
    if (!a) return a.failure();
    const auto b = vertex("end of an edge");
    if (!b) return b.failure();
    const auto marker = label("label of an edge");
    if (!marker) return marker.failure();
    made_.content.boundary.push_back(
        {a.value(), b.value(), static_cast<vertex_index>(i), marker.value()});
  }
  return {};
}

}  // namespace

bool is_freefem_mesh(text_scanner source) {
  for (int i = 0; i < 3; ++i)
    if (const word w = source.next(); w.empty() || !to_integer(source, w, "")) return false;
  return true;
}

result<listed_mesh> read_freefem(text_scanner& source) {
  freefem_reader reader(source);
  if (auto failed = reader.read()) return *failed;
  return reader.take();
}

}  // namespace asterism::internal
