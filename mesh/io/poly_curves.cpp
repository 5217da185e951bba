// SPDX-License-Identifier: MIT
#include "asterism/mesh/io/poly_curves.hpp"

#include <cmath>
#include <limits>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "asterism/core/number_text.hpp"

namespace asterism::internal {
namespace {

using words = std::vector<word>;
using failure = std::optional<error>;

double root(double x) { return std::sqrt(std::sqrt(x)); }

// Returns the square root of the distance between two points: their difference in a centripetal
// parameter.
double centripetal(const point& a, const point& b) {
  const double x = b.x - a.x, y = b.y - a.y;
  return root(x * x + y * y);
}

// Returns the control point after p1 of the centripetal Catmull-Rom curve from p1 to p2 that comes
// from p0.
point control_after(const point& p0, const point& p1, const point& p2) {
  const double d1 = centripetal(p0, p1), d2 = centripetal(p1, p2);
  const double of_p1 = 2 * d1 * d1 + 3 * d1 * d2 + d2 * d2, all = 3 * d1 * (d1 + d2);
  return {(d1 * d1 * p2.x - d2 * d2 * p0.x + of_p1 * p1.x) / all,
          (d1 * d1 * p2.y - d2 * d2 * p0.y + of_p1 * p1.y) / all};
}

class curve_reader {
 public:
  curve_reader(text_scanner& source, domain& d)
      : source_(source), d_(d), segments_(d.segments.size()) {}

  failure read() {
    const words header = source_.next_line();
    if (header.empty()) return std::nullopt;
    if (header[0].text != "curves")
      return source_.failure(header[0].line, quoted(header[0]) +
                                                 " is too much: the file should end here, or "
                                                 "'curves' and their number follow");
    if (header.size() != 2)
      return source_.failure(header[0].line, "this line holds 'curves' and their number");
    const auto count = to_count(source_, header[1], "number of curves");
    if (!count.ok()) return count.failure();
    for (std::size_t i = 0; i < count.value(); ++i)
      if (auto failed = read_record(i, count.value())) return failed;
    return std::nullopt;
  }

 private:
  static std::string quoted(const word& w) { return quoted_token(w.text); }

  failure read_record(std::size_t position, std::size_t count) {
    const words record = source_.next_line();
    if (record.empty())
      return source_.failure(source_.line(), "the file ends after " + std::to_string(position) +
                                                 " of " + std::to_string(count) + " curves");
    const auto number = to_integer(source_, record[0], "curve number");
    if (!number.ok()) return number.failure();
    if (position == 0 && (number.value() == 0 || number.value() == 1)) first_ = number.value();
    if (number.value() != first_ + static_cast<long long>(position))
      return source_.failure(record[0].line,
                             "curve number " + quoted(record[0]) + " where " +
                                 std::to_string(first_ + static_cast<long long>(position)) +
                                 " should follow");
    number_ = static_cast<std::size_t>(number.value());
    if (record.size() < 2) return source_.failure(record[0].line, "a curve line names its kind");
    const std::string_view kind = record[1].text;
    if (kind == "arc") return read_arc(record);
    if (kind == "circle") return read_circle(record);
    if (kind == "bezier") return read_bezier(record);
    if (kind == "spline") return read_spline(record);
    return source_.failure(record[1].line,
                           quoted(record[1]) + " is no kind of curve: arc, circle, bezier, spline");
  }

  failure expect(const words& record, std::size_t least, std::size_t most,
                 std::string_view wanted) const {
    if (record.size() >= least && record.size() <= most) return std::nullopt;
    return source_.failure(record[0].line, "this line should be: " + std::string(wanted));
  }

  // Reads the number of a vertex or segment, of which there are `count`.
  failure read_index(const word& w, std::string_view what, std::size_t count,
                     vertex_index& index) const {
    const std::string name(what);
    const auto number = to_integer(source_, w, name + " of a curve");
    if (!number.ok()) return number.failure();
    const long long first = d_.origin.first_number, n = static_cast<long long>(count);
    if (number.value() < first || number.value() >= first + n)
      return source_.failure(w.line, "curve " + std::to_string(number_) + ": " + name + " " +
                                         quoted(w) + " does not exist; there are " +
                                         std::to_string(n));
    index = static_cast<vertex_index>(number.value() - first);
    return std::nullopt;
  }

  failure read_point(const words& record, std::size_t at, std::string_view what, point& p) const {
    const auto read = to_point(source_, record[at], record[at + 1], what);
    if (!read.ok()) return read.failure();
    p = read.value();
    return std::nullopt;
  }

  void add(domain_curve curve, vertex_index from, vertex_index to, vertex_index on,
           std::size_t line) {
    curve.vertices = {from, to};
    curve.parameters = {0, 1};
    curve.segment = on;
    d_.curves.push_back(std::move(curve));
    d_.origin.curve_lines.push_back(line);
    d_.origin.curve_numbers.push_back(number_);
  }

  failure read_arc(const words& record) {
    if (auto failed = expect(record, 6, 6, "<number> arc <segment> <centre x> <centre y> ccw|cw"))
      return failed;
    vertex_index on = 0;
    if (auto failed = read_index(record[2], "segment", segments_, on)) return failed;
    domain_curve arc;
    if (auto failed = read_point(record, 3, "the centre", arc.centre)) return failed;
    const std::string_view way = record[5].text;
    if (way != "ccw" && way != "cw")
      return source_.failure(record[5].line, quoted(record[5]) +
                                                 " is no direction: ccw (counter-clockwise from "
                                                 "the segment's first vertex) or cw");
    arc.clockwise = way == "cw";
    add(std::move(arc), d_.segments[on].a, d_.segments[on].b, on, record[0].line);
    return std::nullopt;
  }

  // Adds a segment without length for the circle, which its chords replace.
  failure read_circle(const words& record) {
    if (auto failed =
            expect(record, 5, 6, "<number> circle <vertex> <centre x> <centre y> [marker]"))
      return failed;
    vertex_index v = 0;
    if (auto failed = read_index(record[2], "vertex", d_.vertices.size(), v)) return failed;
    domain_curve circle;
    if (auto failed = read_point(record, 3, "the centre", circle.centre)) return failed;
    int marker = 0;
    if (record.size() == 6) {
      const auto given = to_marker(source_, record[5], "marker of a circle");
      if (!given.ok()) return given.failure();
      marker = given.value();
    }
    const auto on = static_cast<vertex_index>(d_.segments.size());
    d_.segments.push_back({v, v, marker});
    d_.origin.segment_lines.push_back(record[0].line);
    add(std::move(circle), v, v, on, record[0].line);
    return std::nullopt;
  }

  failure read_bezier(const words& record) {
    if (auto failed = expect(record, 7, 7, "<number> bezier <segment> <x1> <y1> <x2> <y2>"))
      return failed;
    vertex_index on = 0;
    if (auto failed = read_index(record[2], "segment", segments_, on)) return failed;
    domain_curve cubic;
    cubic.kind = curve_kind::cubic;
    if (auto failed = read_point(record, 3, "a control point", cubic.control[0])) return failed;
    if (auto failed = read_point(record, 5, "a control point", cubic.control[1])) return failed;
    add(std::move(cubic), d_.segments[on].a, d_.segments[on].b, on, record[0].line);
    return std::nullopt;
  }

  // Collects the vertices along the segments, each of which must start where the one before it
  // ends.
  failure chain_of(const words& record, const std::vector<vertex_index>& on,
                   std::vector<vertex_index>& chain) const {
    const auto has = [&](std::size_t i, vertex_index v) {
      return d_.segments[on[i]].a == v || d_.segments[on[i]].b == v;
    };
    const segment& first = d_.segments[on[0]];
    chain = {has(1, first.b) ? first.a : first.b};
    for (std::size_t i = 0; i < on.size(); ++i) {
      const segment& s = d_.segments[on[i]];
      if (!has(i, chain.back()))
        return source_.failure(record[i + 2].line,
                               "curve " + std::to_string(number_) + ": segment " +
                                   quoted(record[i + 2]) +
                                   " does not start where the one before it ends");
      chain.push_back(s.a == chain.back() ? s.b : s.a);
      if (d_.vertices[chain[i]] == d_.vertices[chain[i + 1]])
        return source_.failure(record[i + 2].line, "curve " + std::to_string(number_) +
                                                       ": segment " + quoted(record[i + 2]) +
                                                       " has no length");
    }
    return std::nullopt;
  }

  failure read_spline(const words& record) {
    if (auto failed = expect(record, 4, std::numeric_limits<std::size_t>::max(),
                             "<number> spline <segment> <segment> ..., two segments or more"))
      return failed;
    std::vector<vertex_index> on(record.size() - 2), chain;
    for (std::size_t i = 0; i < on.size(); ++i)
      if (auto failed = read_index(record[i + 2], "segment", segments_, on[i])) return failed;
    if (auto failed = chain_of(record, on, chain)) return failed;
    const bool is_closed = on.size() > 2 && chain.front() == chain.back();
    const auto at = [&](std::size_t i) { return d_.vertices[chain[i]]; };
    const auto beyond = [](const point& end, const point& next) {
      return point{2 * end.x - next.x, 2 * end.y - next.y};
    };
    const std::size_t n = on.size();
    for (std::size_t i = 0; i < n; ++i) {
      const point before = i > 0 ? at(i - 1) : is_closed ? at(n - 1) : beyond(at(0), at(1));
      const point after = i + 2 <= n ? at(i + 2) : is_closed ? at(1) : beyond(at(n), at(n - 1));
      domain_curve cubic;
      cubic.kind = curve_kind::cubic;
      cubic.control = {control_after(before, at(i), at(i + 1)),
                       control_after(after, at(i + 1), at(i))};
      add(std::move(cubic), chain[i], chain[i + 1], on[i], record[0].line);
    }
    return std::nullopt;
  }

  text_scanner& source_;
  domain& d_;
  std::size_t segments_;  // of the file: those of circles are not among them
  long long first_ = 1;
  std::size_t number_ = 0;  // of the curve that is being read
};

}  // namespace

std::optional<error> read_poly_curves(text_scanner& source, domain& d) {
  return curve_reader(source, d).read();
}

}  // namespace asterism::internal
