// SPDX-License-Identifier: MIT
//
// Well-known text (OGC 06-103r4, section 7): POLYGON, MULTIPOLYGON and a GEOMETRYCOLLECTION of
// these, one or several a file, with or without "SRID=4326;" before and Z, M or ZM after the name.
#include <optional>
#include <string>
#include <utility>

#include "asterism/core/number_text.hpp"
#include "asterism/mesh/io/file_ending.hpp"
#include "asterism/mesh/io/polygon_domain.hpp"
#include "asterism/mesh/io/polygons.hpp"
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

class wkt_reader {
 public:
  explicit wkt_reader(text_scanner& source) : source_(source) { advance(); }

  failure read();
  std::vector<polygon> polygons;

 private:
  void advance() { token_ = source_.next(); }
  bool take(std::string_view wanted) {
    if (token_.text != wanted) return false;
    advance();
    return true;
  }
  failure wanted(std::string_view what) const {
    return source_.failure(
        token_.line, std::string(what) + " wanted, not " +
                         (token_.empty() ? "the end of the file" : quoted_token(token_.text)));
  }
  failure read_geometry(bool inner);
  failure read_polygons();
  failure read_collection();
  failure read_polygon();
  failure read_ring(ring& corners);
  failure read_point(point& p);

  text_scanner& source_;
  word token_;
};

failure wkt_reader::read() {
  if (token_.empty()) return source_.failure(token_.line, "there is no polygon");
  while (!token_.empty())
    if (auto failed = read_geometry(false)) return failed;
  return {};
}

// `inner`: within a collection, which holds no other one.
failure wkt_reader::read_geometry(bool inner) {
  if (!inner && lower(token_.text).starts_with("srid=")) {
    advance();
    if (!take(";")) return wanted("';' after SRID");
  }
  const std::string kind = lower(token_.text);
  const bool collection = !inner && kind == "geometrycollection";
  if (kind != "polygon" && kind != "multipolygon" && !collection)
    return wanted("POLYGON or MULTIPOLYGON");
  advance();
  const std::string more = lower(token_.text);
  if (more == "z" || more == "m" || more == "zm") advance();
  if (auto failed = collection          ? read_collection()
                    : kind == "polygon" ? read_polygon()
                                        : read_polygons())
    return failed;
  if (!inner) take(";");
  return {};
}

failure wkt_reader::read_polygons() {
  if (!take("(")) return wanted("'('");
  do {
    if (auto failed = read_polygon()) return failed;
  } while (take(","));
  return take(")") ? failure() : wanted("')'");
}

failure wkt_reader::read_collection() {
  if (!take("(")) return wanted("'('");
  do {
    if (auto failed = read_geometry(true)) return failed;
  } while (take(","));
  return take(")") ? failure() : wanted("')'");
}

failure wkt_reader::read_polygon() {
  if (!take("(")) return wanted("'('");
  polygon made;
  do {
    if (auto failed = read_ring(made.rings.emplace_back())) return failed;
  } while (take(","));
  if (!take(")")) return wanted("')'");
  polygons.push_back(std::move(made));
  return {};
}

failure wkt_reader::read_ring(ring& corners) {
  const std::size_t line = token_.line;
  if (!take("(")) return wanted("'('");
  do {
    if (auto failed = read_point(corners.emplace_back())) return failed;
  } while (take(","));
  if (!take(")")) return wanted("')'");
  open_ring(corners);
  if (corners.size() < 3) return source_.failure(line, "a ring of fewer than three corners");
  return {};
}

// Two numbers, and up to two more that are dropped.
failure wkt_reader::read_point(point& p) {
  std::size_t count = 0;
  for (; count < 4 && token_.text != "," && token_.text != ")" && !token_.empty(); ++count) {
    const auto x = to_number(source_, token_, "coordinate");
    if (!x.ok()) return x.failure();
    if (count == 0) p.x = x.value();
    if (count == 1) p.y = x.value();
    advance();
  }
  if (count < 2) return wanted("two coordinates");
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
  auto made = domain_of_polygons(reader.polygons, false);
  if (!made.ok()) return made.failure().at(path.string());
  made.value().name = path.string();
  return made;
}

}  // namespace asterism::internal
