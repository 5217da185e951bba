// SPDX-License-Identifier: MIT
#include "asterism/mesh/audit/periodic_match.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>
#include <vector>

#include "asterism/core/elementary.hpp"
#include "asterism/core/number_text.hpp"
#include "asterism/mesh/audit/number.hpp"
#include "asterism/mesh/audit/periodic_partners.hpp"
#include "asterism/mesh/audit/roots.hpp"

namespace asterism {
using namespace internal;
using namespace internal::audit_detail;

const std::array<std::string_view, 3> periodic_kind_names = {"translated exactly", "turned exactly",
                                                             "matched by lengths"};

namespace {

// A turn by the angle with this cosine and sine, then a shift.
struct rigid_map {
  double cosine = 1, sine = 0;
  point shift;
};

constexpr std::array<rigid_map, 4> quarter_turns = {
    {{1, 0, {}}, {0, 1, {}}, {-1, 0, {}}, {0, -1, {}}}};

using line = std::vector<vertex_index>;  // the vertices of a side, in their order

struct line_pair {
  line first, second;
};

std::string point_text(const point& q) {
  std::string text = number_text(q.x);
  text.append(", ").append(number_text(q.y)).append(")").insert(text.begin(), '(');
  return text;
}

point turned(const rigid_map& map, const point& q) {
  return {map.cosine * q.x - map.sine * q.y, map.sine * q.x + map.cosine * q.y};
}

// True if the vertices of the second line are the images of those of the first, exactly.
bool is_exact(const mesh& m, const line_pair& lines, const rigid_map& map) {
  for (std::size_t i = 0; i < lines.first.size(); ++i) {
    const point from = turned(map, m.sites[lines.first[i]].position);  // a quarter turn is exact
    const point& to = m.sites[lines.second[i]].position;
    if (rational(from.x) + rational(map.shift.x) != rational(to.x)) return false;
    if (rational(from.y) + rational(map.shift.y) != rational(to.y)) return false;
  }
  return true;
}

// Returns an upper bound of the distance of a vertex from its partner's image, exactly computed and
// rounded up once.
double offset(const rigid_map& map, const point& from, const point& to) {
  const rational cosine(map.cosine), sine(map.sine), x(from.x), y(from.y);
  const rational off_x = cosine * x - sine * y + rational(map.shift.x) - rational(to.x);
  const rational off_y = sine * x + cosine * y + rational(map.shift.y) - rational(to.y);
  return root_rounded_up(off_x * off_x + off_y * off_y);
}

double length_of(const mesh& m, const line& along) {
  double sum = 0;
  for (std::size_t i = 0; i + 1 < along.size(); ++i) {
    const point &p = m.sites[along[i]].position, &q = m.sites[along[i + 1]].position;
    sum += elementary::hypot(q.x - p.x, q.y - p.y);
  }
  return sum;
}

// Returns the map with this turn whose shift takes the first vertex to its partner, rounded.
rigid_map shifted(const mesh& m, const line_pair& lines, rigid_map map) {
  const point from = turned(map, m.sites[lines.first.front()].position);
  const point& to = m.sites[lines.second.front()].position;
  map.shift = {to.x - from.x, to.y - from.y};
  return map;
}

// Returns the turn that takes the direction of the first line's chord to that of the second.
std::optional<rigid_map> chord_turn(const mesh& m, const line_pair& lines) {
  const auto chord = [&m](const line& along) {
    const point &p = m.sites[along.front()].position, &q = m.sites[along.back()].position;
    return point{q.x - p.x, q.y - p.y};
  };
  const point a = chord(lines.first), b = chord(lines.second);
  const double real = a.x * b.x + a.y * b.y, imaginary = a.x * b.y - a.y * b.x;
  const double size = elementary::hypot(real, imaginary);
  if (!(size > 0) || !std::isfinite(size)) return std::nullopt;
  return rigid_map{real / size, imaginary / size, {}};
}

// Largest distance of a vertex from its partner's image, and the vertex's place in the line.
struct offsets {
  double greatest = 0;
  std::size_t at = 0;
};

offsets offsets_of(const mesh& m, const line_pair& lines, const rigid_map& map) {
  offsets found;
  for (std::size_t i = 0; i < lines.first.size(); ++i) {
    const double off =
        offset(map, m.sites[lines.first[i]].position, m.sites[lines.second[i]].position);
    if (off > found.greatest) found = {off, i};
  }
  return found;
}

// Returns the tensor of a partner as a tensor at the first vertex.
metric_tensor pulled_back(const rigid_map& map, const metric_tensor& t) {
  const double c = map.cosine, s = map.sine;
  return {c * c * t.m11 + 2 * (c * s) * t.m12 + s * s * t.m22,
          c * s * (t.m22 - t.m11) + (c * c - s * s) * t.m12,
          s * s * t.m11 - 2 * (c * s) * t.m12 + c * c * t.m22};
}

// Returns ln of the greatest ratio of a displacement's lengths in two metrics, from the eigenvalues
// of their difference in a frame of one of them, so that near metrics lose no digits.
double log_ratio(const metric_tensor& m, const metric_tensor& n) {
  const double d11 = n.m11 - m.m11, d12 = n.m12 - m.m12, d22 = n.m22 - m.m22;
  if (d11 == 0 && d12 == 0 && d22 == 0) return 0;
  const double shear = m.m12 / m.m11, across = m.m22 - shear * m.m12;
  const double x11 = d11 / m.m11, x12 = (d12 - shear * d11) / std::sqrt(m.m11 * across);
  const double x22 = (d22 - 2 * shear * d12 + shear * shear * d11) / across;
  const double middle = (x11 + x22) / 2, reach = elementary::hypot((x11 - x22) / 2, x12);
  const double most = std::max(std::abs(elementary::log(1 + middle + reach)),
                               std::abs(elementary::log(1 + middle - reach))) /
                      2;
  return std::isfinite(most) ? most : std::numeric_limits<double>::infinity();
}

double metrics_apart(const mesh& m, const line_pair& lines, const rigid_map& map) {
  double most = 0;
  for (std::size_t i = 0; i < lines.first.size(); ++i)
    most = std::max(most, log_ratio(m.sites[lines.first[i]].metric,
                                    pulled_back(map, m.sites[lines.second[i]].metric)));
  return most;
}

// Finds the map from the first line to the second: tries the exact kinds first.
result<periodic_match> matched(const mesh& m, const line_pair& lines) {
  periodic_match made;
  made.vertices = lines.first.size();
  for (std::size_t k = 0; k < quarter_turns.size(); ++k) {
    const rigid_map map = shifted(m, lines, quarter_turns[k]);
    if (!is_exact(m, lines, map)) continue;
    constexpr double quarter = 90;
    made.kind = k == 0 ? periodic_kind::translated : periodic_kind::turned;
    made.turn = quarter * static_cast<double>(k);
    made.shift = map.shift;
    made.metrics_apart = metrics_apart(m, lines, map);
    return made;
  }
  const double allowed = largest_periodic_offset * length_of(m, lines.first);
  std::vector<rigid_map> candidates(quarter_turns.begin(), quarter_turns.end());
  if (const auto chord = chord_turn(m, lines)) candidates.push_back(*chord);
  offsets last;
  for (const rigid_map& candidate : candidates) {
    const rigid_map map = shifted(m, lines, candidate);
    last = offsets_of(m, lines, map);
    if (!(last.greatest <= allowed)) continue;
    made.turn = elementary::atan2(map.sine, map.cosine) * 180 / std::numbers::pi;
    made.shift = map.shift;
    made.greatest_offset = last.greatest;
    made.metrics_apart = metrics_apart(m, lines, map);
    return made;
  }
  return error{"vertex " + std::to_string(lines.first[last.at] + 1) + " at " +
               point_text(m.sites[lines.first[last.at]].position) + " and vertex " +
               std::to_string(lines.second[last.at] + 1) + " at " +
               point_text(m.sites[lines.second[last.at]].position) +
               " are no partners: one side is not the other shifted or turned"};
}

error no_match(const periodic_pair& sides, const error& why) {
  return error{"the sides with markers " + std::to_string(sides.first) + " and " +
                   std::to_string(sides.second) + " do not match: " + why.message,
               error_code::invalid_mesh};
}

}  // namespace

result<periodic_match> match_periodic(const mesh& subject, const periodic_pair& sides) {
  const auto partners = periodic_partners(subject, sides.first, sides.second);
  if (!partners) return no_match(sides, partners.failure());
  line_pair lines;
  for (const auto& [a, b] : partners.value()) {
    lines.first.push_back(a);
    lines.second.push_back(b);
  }
  auto match = matched(subject, lines);
  if (!match) return no_match(sides, match.failure());
  match.value().sides = sides;
  return match;
}

std::string text_of(const periodic_match& match) {
  std::string text =
      std::to_string(match.sides.first) + " and " + std::to_string(match.sides.second) + ": ";
  if (match.kind == periodic_kind::matched) text += "matched by lengths, ";
  const std::string exactly = match.kind == periodic_kind::matched ? "" : " exactly";
  if (match.turn == 0)
    text.append("translated").append(exactly);
  else
    text.append("turned")
        .append(exactly)
        .append(" by ")
        .append(format_number(match.turn))
        .append(" degrees about the origin and shifted");
  text.append(" by ").append(point_text(match.shift));
  if (match.kind == periodic_kind::matched)
    text.append(" but for up to ").append(format_number(match.greatest_offset));
  text.append(", ").append(std::to_string(match.vertices)).append(" vertices each, ");
  if (match.metrics_apart == 0) return text.append("with the same metric");
  return text.append("lengths of partners apart by up to ")
      .append(format_number(match.metrics_apart));
}

}  // namespace asterism
