// SPDX-License-Identifier: MIT
#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <numeric>
#include <optional>
#include <utility>
#include <vector>

#include "asterism/core/number_text.hpp"
#include "asterism/mesh/io/listed_readers.hpp"

namespace asterism::internal {
namespace {

using failure = std::optional<error>;

constexpr std::size_t header_bytes = 84, facet_bytes = 50;

std::uint32_t word_at(std::string_view bytes, std::size_t at) {
  std::uint32_t value = 0;
  for (std::size_t i = 0; i < 4; ++i)
    value |= std::uint32_t{static_cast<unsigned char>(bytes[at + i])} << (8 * i);
  return value;
}

// Text files begin with "solid", and so do some binary ones: these have the length that they say.
bool is_binary(std::string_view text) {
  return text.size() >= header_bytes &&
         text.size() == header_bytes + facet_bytes * std::size_t{word_at(text, 80)};
}

class stl_reader {
 public:
  stl_reader(std::string_view text, const std::string& file)
      : text_(text), source_(file, text, '\0') {
    made_.file = file;
  }

  failure read();
  listed_mesh take() { return std::move(made_); }

 private:
  struct corner {
    point at;
    double z;
    std::size_t line;
  };

  failure read_binary();
  failure read_text();
  failure read_facet();
  failure read_corner();
  failure expect(std::string_view wanted);
  failure join_corners();

  std::string_view text_;
  text_scanner source_;
  listed_mesh made_;
  std::vector<corner> corners_;
  std::vector<int> solids_;  // of facets, from 1
  int solid_ = 0;
};

failure stl_reader::read() {
  if (auto failed = is_binary(text_) ? read_binary() : read_text()) return failed;
  if (corners_.empty()) return source_.failure(source_.line(), "there is no facet");
  if (corners_.size() > std::numeric_limits<vertex_index>::max() / 4)
    return source_.failure(source_.line(), "more facets than 32-bit numbers can name");
  if (auto failed = join_corners()) return failed;
  if (solid_ > 1) made_.content.regions = std::move(solids_);
  return put_in_order(made_, listed_order::put_right);
}

failure stl_reader::read_binary() {
  const std::size_t facets = word_at(text_, 80);
  for (std::size_t f = 0; f < facets; ++f)
    for (std::size_t k = 1; k < 4; ++k) {
      const std::size_t at = header_bytes + f * facet_bytes + 12 * k;
      std::array<double, 3> p{};
      for (std::size_t i = 0; i < 3; ++i) {
        p[i] = static_cast<double>(std::bit_cast<float>(word_at(text_, at + 4 * i)));
        if (!std::isfinite(p[i]))
          return error{
              made_.file + ": facet " + std::to_string(f + 1) + ": a coordinate is not finite",
              error_code::bad_number};
      }
      corners_.push_back({{p[0] + 0.0, p[1] + 0.0}, p[2], 1});
    }
  return {};
}

failure stl_reader::expect(std::string_view wanted) {
  const word w = source_.next();
  if (w.text == wanted) return {};
  return source_.failure(w.line, std::string(wanted) + " wanted, not " + quoted_token(w.text));
}

failure stl_reader::read_text() {
  for (word w = source_.next(); !w.empty(); w = source_.next()) {
    if (w.text == "solid") {
      const std::string_view name = source_.rest_of_line();
      ++solid_;
      if (!name.empty()) made_.names.regions[solid_] = without_controls(std::string(name));
    } else if (w.text == "facet") {
      if (solid_ == 0) return source_.failure(w.line, "a facet before the first solid");
      if (auto failed = read_facet()) return failed;
    } else if (w.text == "endsolid" || w.text == "end") {
      source_.rest_of_line();
    } else {
      return source_.failure(w.line, "solid or facet wanted, not " + quoted_token(w.text));
    }
  }
  return {};
}

failure stl_reader::read_facet() {
  if (auto failed = expect("normal")) return failed;
  for (int i = 0; i < 3; ++i) source_.next();  // a normal of a flat facet may be no number
  for (const std::string_view wanted : {"outer", "loop"})
    if (auto failed = expect(wanted)) return failed;
  for (int k = 0; k < 3; ++k)
    if (auto failed = read_corner()) return failed;
  for (const std::string_view wanted : {"endloop", "endfacet"})
    if (auto failed = expect(wanted)) return failed;
  solids_.push_back(solid_);
  return {};
}

failure stl_reader::read_corner() {
  if (auto failed = expect("vertex")) return failed;
  std::array<double, 3> p{};
  const std::string_view names[] = {"x of a vertex", "y of a vertex", "z of a vertex"};
  for (std::size_t i = 0; i < 3; ++i) {
    const auto value = to_number(source_, source_.next(), names[i]);
    if (!value) return value.failure();
    p[i] = value.value();
  }
  // Adding zero makes one of the two zeros.
  corners_.push_back({{p[0] + 0.0, p[1] + 0.0}, p[2], source_.line()});
  return {};
}

// Makes corners at one place one vertex, numbered in the order in which they first occur.
failure stl_reader::join_corners() {
  mesh& m = made_.content;
  std::vector<std::size_t> order(corners_.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  const auto before = [&](std::size_t i, std::size_t j) {
    const point &p = corners_[i].at, &q = corners_[j].at;
    return p.x != q.x ? p.x < q.x : p.y != q.y ? p.y < q.y : i < j;
  };
  std::sort(order.begin(), order.end(), before);
  std::vector<std::size_t> first(corners_.size());
  for (std::size_t k = 0; k < order.size(); ++k)
    first[order[k]] = k > 0 && corners_[order[k]].at == corners_[order[k - 1]].at
                          ? first[order[k - 1]]
                          : order[k];
  const double extent = corners_[order.back()].at.x - corners_[order.front()].at.x;
  std::vector<vertex_index> number(corners_.size());
  for (std::size_t i = 0; i < corners_.size(); ++i) {
    const corner& c = corners_[i];
    if (first[i] == i) {
      number[i] = static_cast<vertex_index>(m.sites.size());
      m.sites.push_back({c.at, {1, 0, 1}});
    }
    number[i] = number[first[i]];
    if (first[i] == i && c.z != 0) made_.heights.push_back({number[i], c.line, c.z});
    // Rounding is for put_in_order to judge, where it is of one vertex.
    if (!(std::abs(c.z - corners_[first[i]].z) <= rounding_of_heights * extent))
      return source_.failure(c.line,
                             "two corners are above each other: only plane meshes can be "
                             "read, parallel to x and y");
  }
  for (std::size_t i = 0; i + 2 < corners_.size(); i += 3)
    m.triangles.push_back({number[i], number[i + 1], number[i + 2]});
  return {};
}

}  // namespace

result<listed_mesh> read_stl(std::string_view text, const std::string& file) {
  stl_reader reader(text, file);
  if (auto failed = reader.read()) return *failed;
  return reader.take();
}

}  // namespace asterism::internal
