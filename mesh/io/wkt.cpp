// SPDX-License-Identifier: MIT
//
// Reads well-known text (OGC 06-103r4, section 7): POLYGON, MULTIPOLYGON and GEOMETRYCOLLECTIONs of
// these, one or several in a file, with or without "SRID=4326;" before and Z, M or ZM after the
// name.
#include "asterism/mesh/io/wkt.hpp"

#include <algorithm>
#include <array>
#include <optional>
#include <string>
#include <utility>

#include "asterism/core/number_text.hpp"
#include "asterism/mesh/io/file_ending.hpp"
#include "asterism/mesh/io/polygon_domain.hpp"
#include "asterism/mesh/io/text_scanner.hpp"

namespace asterism::internal {
namespace {

using failure = std::optional<error>;

// Puts blanks around brackets, commas and semicolons, so that words are tokens.
std::string spaced(const std::string& text) {
  std::string out;
  for (const char c : text) {
    const bool alone = c == '(' || c == ')' || c == ',' || c == ';';
    if (alone) out += ' ';
    out += c;
    if (alone) out += ' ';
  }
  return out;
}

std::string lower(std::string_view text) {
  std::string out;
  for (const char c : text) out += lower_case(c);
  return out;
}

// Returns the name of a geometry without a Z, M or ZM at its end.
std::string plain_kind(std::string kind) {
  for (const std::string_view more : {"zm", "z", "m"})
    if (kind.ends_with(more)) {
      kind.resize(kind.size() - more.size());
      break;
    }
  return kind;
}

class wkt_reader {
 public:
  explicit wkt_reader(text_scanner& source) : source_(source) { advance(); }

  failure read();
  polygons_read made;

 private:
  void advance() { token_ = source_.next(); }
  bool take(std::string_view wanted) {
    if (token_.text != wanted) return false;
    advance();
    return true;
  }
  bool take_empty();
  failure wanted(std::string_view what) const {
    return source_.failure(
        token_.line, std::string(what) + " wanted, not " +
                         (token_.empty() ? "the end of the file" : quoted_token(token_.text)));
  }
  using reader = failure (wkt_reader::*)();
  failure read_list(reader one);
  failure read_geometry();
  failure read_polygon();
  failure read_ring();
  failure read_point();
  failure pass_over(const std::string& kind);

  text_scanner& source_;
  word token_;
  int depth_ = 0;
};

// Takes the word EMPTY for a geometry, polygon or ring without contents.
bool wkt_reader::take_empty() {
  if (lower(token_.text) != "empty") return false;
  made.empty.add([&] { return "on line " + std::to_string(token_.line); });
  advance();
  return true;
}

// Reads a list in brackets, "(item, item, item)"; `one` reads an item.
failure wkt_reader::read_list(reader one) {
  if (!take("(")) return wanted("'('");
  do {
    if (auto failed = (this->*one)()) return failed;
  } while (take(","));
  return take(")") ? failure() : wanted("')'");
}

failure wkt_reader::read() {
  if (token_.empty()) return source_.failure(token_.line, "there is no polygon");
  while (!token_.empty()) {
    if (lower(token_.text).starts_with("srid=")) {
      advance();
      if (!take(";")) return wanted("';' after SRID");
    }
    if (auto failed = read_geometry()) return failed;
    take(";");
  }
  return {};
}

failure wkt_reader::read_geometry() {
  constexpr int deepest = 16;
  constexpr std::array<std::string_view, 4> others = {"point", "multipoint", "linestring",
                                                      "multilinestring"};
  const std::string kind = plain_kind(lower(token_.text));
  const bool is_other = std::find(others.begin(), others.end(), kind) != others.end();
  if (kind != "polygon" && kind != "multipolygon" && kind != "geometrycollection" && !is_other)
    return wanted("POLYGON or MULTIPOLYGON");
  const std::size_t line = token_.line;
  advance();
  const std::string more = lower(token_.text);
  if (more == "z" || more == "m" || more == "zm") advance();
  if (take_empty()) return {};
  if (kind == "polygon") return read_polygon();
  if (kind == "multipolygon") return read_list(&wkt_reader::read_polygon);
  if (is_other) {
    made.others.add([&] { return "a " + kind + " on line " + std::to_string(line); });
    return pass_over(kind);
  }
  if (++depth_ > deepest) return source_.failure(line, "collections are nested too deeply");
  auto failed = read_list(&wkt_reader::read_geometry);
  --depth_;
  return failed;
}

// Skips brackets and everything between them.
failure wkt_reader::pass_over(const std::string& kind) {
  if (token_.text != "(") return wanted("'(' after " + kind);
  std::size_t open = 0;
  do {
    if (token_.empty()) return wanted("')'");
    if (token_.text == "(") ++open;
    if (token_.text == ")") --open;
    advance();
  } while (open > 0);
  return {};
}

failure wkt_reader::read_polygon() {
  if (take_empty()) return {};
  made.polygons.emplace_back();
  return read_list(&wkt_reader::read_ring);
}

failure wkt_reader::read_ring() {
  made.polygons.back().rings.emplace_back();
  return take_empty() ? failure() : read_list(&wkt_reader::read_point);
}

// Reads two numbers, and up to two more that are dropped.
failure wkt_reader::read_point() {
  point p;
  std::size_t count = 0;
  bool has_more = false;
  const std::size_t line = token_.line;
  for (; count < 4 && token_.text != "," && token_.text != ")" && !token_.empty(); ++count) {
    const auto x = to_number(source_, token_, "coordinate");
    if (!x.ok()) return x.failure();
    if (count == 0) p.x = x.value();
    if (count == 1) p.y = x.value();
    has_more = has_more || count == 3 || (count == 2 && x.value() != 0);
    advance();
  }
  if (count < 2) return wanted("two coordinates");
  if (has_more) made.heights.add([line] { return "on line " + std::to_string(line); });
  made.polygons.back().rings.back().push_back(p);
  return {};
}

}  // namespace

result<domain> read_wkt(const std::filesystem::path& path) {
  const auto text = read_text_file(path);
  if (!text.ok()) return text.failure();
  const std::string tokens = spaced(text.value());
  text_scanner source(path.string(), tokens);
  wkt_reader reader(source);
  if (auto failed = reader.read()) return std::move(*failed);
  return domain_of_polygons(reader.made, path.string());
}

}  // namespace asterism::internal
