// SPDX-License-Identifier: MIT
#include "asterism/mesh/io/stl_facets.hpp"

#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <optional>
#include <utility>

#include "asterism/core/number_text.hpp"
#include "asterism/mesh/io/listed_readers.hpp"
#include "asterism/mesh/io/text_scanner.hpp"

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

// Distinguishes binary files by their length: text files begin with "solid", and so do some binary
// ones, but only these have the length that they state.
bool is_binary(std::string_view text) {
  return text.size() >= header_bytes &&
         text.size() == header_bytes + facet_bytes * std::size_t{word_at(text, 80)};
}

class facet_reader {
 public:
  facet_reader(std::string_view text, const std::string& file)
      : text_(text), file_(file), source_(file, text, '\0') {}

  failure read();
  stl_facets take() { return std::move(made_); }

 private:
  failure read_binary();
  failure read_text();
  failure read_facet();
  failure read_corner();
  failure expect(std::string_view wanted);

  std::string_view text_;
  const std::string& file_;
  text_scanner source_;
  stl_facets made_;
  int solid_ = 0;
};

failure facet_reader::read() {
  if (auto failed = is_binary(text_) ? read_binary() : read_text()) return failed;
  if (made_.corners.empty()) return source_.failure(source_.line(), "there is no facet");
  if (made_.corners.size() > std::numeric_limits<vertex_index>::max() / 4)
    return source_.failure(source_.line(), "more facets than 32-bit numbers can name");
  return {};
}

failure facet_reader::read_binary() {
  const std::size_t facets = word_at(text_, 80);
  for (std::size_t f = 0; f < facets; ++f)
    for (std::size_t k = 1; k < 4; ++k) {
      const std::size_t at = header_bytes + f * facet_bytes + 12 * k;
      std::array<double, 3> p{};
      for (std::size_t i = 0; i < 3; ++i) {
        p[i] = static_cast<double>(std::bit_cast<float>(word_at(text_, at + 4 * i)));
        if (!std::isfinite(p[i]))
          return error{file_ + ": facet " + std::to_string(f + 1) + ": a coordinate is not finite",
                       error_code::bad_number};
      }
      made_.corners.push_back({p[0] + 0.0, p[1] + 0.0, p[2] + 0.0, 1});
    }
  return {};
}

failure facet_reader::expect(std::string_view wanted) {
  const word w = source_.next();
  if (w.text == wanted) return {};
  return source_.failure(w.line, std::string(wanted) + " wanted, not " + quoted_token(w.text));
}

failure facet_reader::read_text() {
  if (const word first = text_scanner(source_).next(); first.text != "solid")
    return source_.failure(first.line,
                           "this is no .stl file: neither \"solid\" nor the size of a binary one");
  for (word w = source_.next(); !w.empty(); w = source_.next()) {
    if (w.text == "solid") {
      const std::string_view name = source_.rest_of_line();
      ++solid_;
      if (!name.empty()) made_.names[solid_] = without_controls(std::string(name));
    } else if (w.text == "facet") {
      if (auto failed = read_facet()) return failed;
    } else if (w.text == "endsolid" || w.text == "end") {
      source_.rest_of_line();
    } else {
      return source_.failure(w.line, "solid or facet wanted, not " + quoted_token(w.text));
    }
  }
  return {};
}

failure facet_reader::read_facet() {
  if (auto failed = expect("normal")) return failed;
  for (int i = 0; i < 3; ++i) source_.next();  // a normal of a flat facet may be no number
  for (const std::string_view wanted : {"outer", "loop"})
    if (auto failed = expect(wanted)) return failed;
  for (int k = 0; k < 3; ++k)
    if (auto failed = read_corner()) return failed;
  for (const std::string_view wanted : {"endloop", "endfacet"})
    if (auto failed = expect(wanted)) return failed;
  made_.solids.push_back(solid_);
  return {};
}

failure facet_reader::read_corner() {
  if (auto failed = expect("vertex")) return failed;
  std::array<double, 3> p{};
  const std::string_view names[] = {"x of a vertex", "y of a vertex", "z of a vertex"};
  for (std::size_t i = 0; i < 3; ++i) {
    const auto value = to_number(source_, source_.next(), names[i]);
    if (!value) return value.failure();
    p[i] = value.value();
  }
  // Adds zero, which makes -0 a 0.
  made_.corners.push_back({p[0] + 0.0, p[1] + 0.0, p[2] + 0.0, source_.line()});
  return {};
}

}  // namespace

result<stl_facets> read_stl_facets(std::string_view text, const std::string& file) {
  facet_reader reader(text, file);
  if (auto failed = reader.read()) return std::move(*failed);
  return reader.take();
}

}  // namespace asterism::internal
