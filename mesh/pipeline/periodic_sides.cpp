// SPDX-License-Identifier: MIT
#include "asterism/mesh/pipeline/periodic_sides.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <set>
#include <string>
#include <utility>

#include "asterism/core/elementary.hpp"
#include "asterism/core/number_text.hpp"
#include "asterism/mesh/domain/curve_chords.hpp"
#include "asterism/mesh/domain/message_names.hpp"
#include "asterism/mesh/domain/point_algebra.hpp"
#include "asterism/mesh/support/first_numbers.hpp"

namespace asterism::internal {

// A side as a line, its vertices in the order in which they match those of the other side.
struct side_line {
  std::vector<vertex_index> vertices, segments;
  std::vector<double> at;  // the length up to each vertex
};

// A corner of the first side, of the second side or of both, by its indices in the lines of these
// sides.
struct corner_pair {
  std::optional<std::size_t> first, second;
};

namespace {

constexpr std::array<side_map, 4> quarter_turns = {
    {{false, 1, 0, {}}, {false, 0, 1, {}}, {false, -1, 0, {}}, {false, 0, -1, {}}}};

std::string marker_text(int marker) { return "marker " + std::to_string(marker); }

double unit_in_last_place(double size) {
  const double next = std::nextafter(std::abs(size), std::numeric_limits<double>::infinity());
  return next - std::abs(size);
}

// True if the sum is exact: its rounding error, computed by Knuth's method, is zero.
bool is_exact_sum(double a, double b, double sum) {
  const double from_b = sum - a;
  return sum - from_b == a && from_b == b && std::isfinite(sum);
}

// True if the map takes the one point exactly to the other. A turn by quarters is exact.
bool maps_exactly(const side_map& map, const point& from, const point& to) {
  const point t = map.turned(from);
  return is_exact_sum(t.x, map.shift.x, to.x) && is_exact_sum(t.y, map.shift.y, to.y);
}

point at_part(const point& a, const point& b, double part) {
  return {a.x + part * (b.x - a.x), a.y + part * (b.y - a.y)};
}

// Returns the parameter, from 0 at a to 1 at b, of the foot of a point on the line.
double part_of(const point& a, const point& b, const point& q) {
  const double x = b.x - a.x, y = b.y - a.y;
  return ((q.x - a.x) * x + (q.y - a.y) * y) / (x * x + y * y);
}

// True if a place may represent the point `on_line` of the line from a to b: it is within two units
// in the last place; or, if the line is along an axis, exactly on the line and within 2^-30 of its
// length.
bool is_near_enough(const point& a, const point& b, const point& on_line, const point& q) {
  constexpr double units = 2, along_axis = 0x1p-30;
  const double unit =
      unit_in_last_place(std::max({std::abs(a.x), std::abs(a.y), std::abs(b.x), std::abs(b.y)}));
  const double x = std::abs(q.x - on_line.x), y = std::abs(q.y - on_line.y);
  if (a.x == b.x) return q.x == a.x && y <= along_axis * std::abs(b.y - a.y);
  if (a.y == b.y) return q.y == a.y && x <= along_axis * std::abs(b.x - a.x);
  return x <= units * unit && y <= units * unit;
}

// Finds doubles near `from` and its image with to = sign * from + shift exactly. Tries fewer and
// fewer bits: a sum of doubles is exact if neither has bits below the last bit of the sum.
std::optional<std::array<double, 2>> exact_relation(double from, double sign, double shift) {
  constexpr int most_bits = 23;
  const double to = sign * from + shift;
  if (is_exact_sum(sign * from, shift, to)) return std::array{from, to};
  double grid = unit_in_last_place(std::max(std::abs(from), std::abs(to)));
  for (int bits = 0; bits < most_bits; ++bits, grid *= 2) {
    const double coarse = std::nearbyint(from / grid) * grid, image = sign * coarse + shift;
    if (is_exact_sum(sign * coarse, shift, image)) return std::array{coarse, image};
    const double coarse_image = std::nearbyint(to / grid) * grid,
                 origin = sign * (coarse_image - shift);
    if (is_exact_sum(sign * origin, shift, coarse_image)) return std::array{origin, coarse_image};
  }
  return std::nullopt;
}

// Returns a place near `from` whose image is a double, and that image.
std::optional<std::array<point, 2>> exact_images(const side_map& map, const point& from) {
  if (map.sine == 0) {
    const auto x = exact_relation(from.x, map.cosine, map.shift.x);
    const auto y = exact_relation(from.y, map.cosine, map.shift.y);
    if (!x || !y) return std::nullopt;
    return std::array{point{(*x)[0], (*y)[0]}, point{(*x)[1], (*y)[1]}};
  }
  const auto x = exact_relation(from.y, -map.sine, map.shift.x);
  const auto y = exact_relation(from.x, map.sine, map.shift.y);
  if (!x || !y) return std::nullopt;
  return std::array{point{(*y)[0], (*x)[0]}, point{(*x)[1], (*y)[1]}};
}

enum class slide { none, along_x, along_y };

// Moves a place along the line from a to b until its x or its y has an exact image. Near the origin
// doubles are much denser than near the image, and rounding alone would leave the line.
point slid(const side_map& map, const point& a, const point& b, const point& from, slide along) {
  const auto exact = exact_images(map, from);
  if (along == slide::none || !exact) return from;
  const bool by_x = along == slide::along_x;
  const double to = by_x ? (*exact)[0].x : (*exact)[0].y, begin = by_x ? a.x : a.y,
               whole = by_x ? b.x - a.x : b.y - a.y;
  if (whole == 0) return from;
  const point on_line = at_part(a, b, (to - begin) / whole);
  return by_x ? point{to, on_line.y} : point{on_line.x, to};
}

// Returns the markers of the boundary, as the end of a message.
std::string markers_of(const domain& d) {
  std::set<int> found;
  for (const segment& one : d.segments)
    if (!one.internal) found.insert(one.marker);
  return "; the markers there are: " + first_numbers(found);
}

// Returns the segments with a marker, each by its start.
result<std::map<vertex_index, vertex_index>> segments_with(const domain& d, int marker) {
  std::map<vertex_index, vertex_index> leaving;
  std::map<vertex_index, std::size_t> arriving;
  for (vertex_index s = 0; s < d.segments.size(); ++s) {
    const segment& one = d.segments[s];
    if (one.marker != marker) continue;
    if (one.internal)
      return error{"the domain is on both sides of the segment from " +
                   coordinates(d.vertices[one.a]) + " to " + coordinates(d.vertices[one.b]) +
                   " with " + marker_text(marker)};
    if (!leaving.emplace(one.a, s).second || ++arriving[one.b] > 1)
      return error{"the segments with " + marker_text(marker) + " branch"};
  }
  if (leaving.empty()) return error{"no segment has " + marker_text(marker) + markers_of(d)};
  return leaving;
}

result<side_line> line_of(const domain& d, int marker) {
  const auto leaving = segments_with(d, marker);
  if (!leaving) return leaving.failure();
  std::map<vertex_index, char> arrived;
  for (const auto& [start, s] : leaving.value()) arrived[d.segments[s].b] = 1;
  side_line line;
  for (const auto& [start, s] : leaving.value())
    if (!arrived.contains(start)) line.vertices.push_back(start);
  if (line.vertices.empty())
    return error{"the segments with " + marker_text(marker) + " are a closed line, without ends"};
  const bool is_one = line.vertices.size() == 1;
  for (auto step = leaving.value().find(line.vertices.back()); step != leaving.value().end();
       step = leaving.value().find(line.vertices.back())) {
    line.segments.push_back(step->second);
    line.vertices.push_back(d.segments[step->second].b);
  }
  if (!is_one || line.segments.size() != leaving.value().size())
    return error{"the segments with " + marker_text(marker) + " are more than one line"};
  return line;
}

// Fails where a segment of the line is a chord of a curve: its points would be on the curve.
std::optional<error> find_curve(const domain& d, const side_line& line, int marker) {
  const curve_chords chords(d);
  for (const vertex_index s : line.segments) {
    const segment& one = d.segments[s];
    if (chords.is_chord(s))
      return error{"the segment from " + coordinates(d.vertices[one.a]) + " to " +
                   coordinates(d.vertices[one.b]) + " with " + marker_text(marker) +
                   " is of a curve, and straight sides are wanted"};
  }
  return std::nullopt;
}

void measure(const domain& d, side_line& line) {
  line.at.assign(1, 0);
  for (std::size_t i = 0; i + 1 < line.vertices.size(); ++i)
    line.at.push_back(line.at.back() + distance_between(d.vertices[line.vertices[i]],
                                                        d.vertices[line.vertices[i + 1]]));
}

// Pairs the corners of the two sides that are at about the same length along their lines.
std::vector<corner_pair> paired(const side_line& first, const side_line& second, double allowed) {
  std::vector<corner_pair> pairs{{0, 0}};
  const std::size_t n = first.vertices.size() - 1, m = second.vertices.size() - 1;
  for (std::size_t i = 1, k = 1; i < n || k < m;) {
    const double apart = i == n ? 2 * allowed : k == m ? -2 * allowed : first.at[i] - second.at[k];
    corner_pair one;
    if (apart <= allowed) one.first = i++;
    if (apart >= -allowed) one.second = k++;
    pairs.push_back(one);
  }
  pairs.push_back({n, m});
  return pairs;
}

}  // namespace

// Matches the sides of one pair of markers.
class side_finder {
 public:
  side_finder(const domain& d, const periodic_pair& markers) : d_(d), markers_(markers) {}

  result<periodic_sides> find() {
    if (auto failed = find_lines()) return *failed;
    allowed_ = largest_periodic_offset * first_.at.back();
    if (!(std::abs(first_.at.back() - second_.at.back()) <= allowed_)) return unlike_lengths();
    pairs_ = paired(first_, second_, allowed_);
    for (const side_map& turn : quarter_turns) {
      side_map map = shifted(turn);
      map.is_exact = true;
      if (takes_corners_exactly(map) && place_corners(map)) return std::move(made_);
    }
    return match_by_lengths();
  }

 private:
  const point& first(std::size_t i) const { return d_.vertices[first_.vertices[i]]; }
  const point& second(std::size_t i) const { return d_.vertices[second_.vertices[i]]; }

  std::optional<error> find_lines() {
    if (markers_.first == markers_.second) return error{"a side is no partner of itself"};
    auto one = line_of(d_, markers_.first), other = line_of(d_, markers_.second);
    if (!one) return one.failure();
    if (!other) return other.failure();
    first_ = std::move(one).value();
    second_ = std::move(other).value();
    if (auto curve = find_curve(d_, first_, markers_.first)) return curve;
    if (auto curve = find_curve(d_, second_, markers_.second)) return curve;
    std::reverse(second_.vertices.begin(), second_.vertices.end());
    std::reverse(second_.segments.begin(), second_.segments.end());
    measure(d_, first_);
    measure(d_, second_);
    return std::nullopt;
  }

  error unlike_lengths() const {
    const auto lengths = numbers_apart(first_.at.back(), second_.at.back());
    return {"their lengths are " + lengths[0] + " and " + lengths[1]};
  }

  side_map shifted(side_map turn) const {
    const point from = turn.turned(first(0));
    turn.shift = {second(0).x - from.x, second(0).y - from.y};
    return turn;
  }

  bool takes_corners_exactly(const side_map& map) const {
    return std::all_of(pairs_.begin(), pairs_.end(), [&](const corner_pair& one) {
      return !one.first || !one.second || maps_exactly(map, first(*one.first), second(*one.second));
    });
  }

  // Returns the turn from the direction between the first side's ends to the direction between the
  // second side's ends.
  side_map chord_turn() const {
    const point a{first(first_.segments.size()).x - first(0).x,
                  first(first_.segments.size()).y - first(0).y};
    const point b{second(second_.segments.size()).x - second(0).x,
                  second(second_.segments.size()).y - second(0).y};
    const double real = a.x * b.x + a.y * b.y, imaginary = a.x * b.y - a.y * b.x;
    const double size = elementary::hypot(real, imaginary);
    return {false, real / size, imaginary / size, {}};
  }

  result<periodic_sides> match_by_lengths() {
    std::vector<side_map> turns(quarter_turns.begin(), quarter_turns.end());
    turns.push_back(chord_turn());
    for (const side_map& turn : turns)
      if (place_corners(shifted(turn))) return std::move(made_);
    return error{"the one is not the other shifted or turned: " + lost_};
  }

  // Places the stations at the corners. Returns false, with the reason in `lost_`, where a corner
  // has no partner on the other side.
  bool place_corners(const side_map& map) {
    made_ = {};
    made_.map_ = map;
    std::size_t on_first = 0, on_second = 0;  // the corners before
    for (const corner_pair& one : pairs_) {
      if (one.first) on_first = *one.first;
      if (one.second) on_second = *one.second;
      side_station station;
      if (one.first) station.first_vertex = first_.vertices[on_first];
      if (one.second) station.second_vertex = second_.vertices[on_second];
      if (!(one.first && one.second ? place_pair(on_first, on_second, station)
            : one.first             ? place_image(on_first, on_second, station)
                                    : place_origin(on_second, on_first, station)))
        return false;
      made_.stations_.push_back(station);
      if (on_first == first_.segments.size() || on_second == second_.segments.size()) break;
      made_.intervals_.push_back(
          {first_.segments[on_first], second_.segments[on_second], {}, {}, {}, {}});
    }
    for (std::size_t i = 0; i < made_.intervals_.size(); ++i) {
      const side_station &from = made_.stations_[i], &to = made_.stations_[i + 1];
      side_interval& in = made_.intervals_[i];
      in.first_from = from.first;
      in.first_to = to.first;
      in.second_from = from.second;
      in.second_to = to.second;
    }
    return true;
  }

  bool lose(const point& corner, const point& image, const char* wanted) {
    lost_ = "at the image of " + coordinates(corner) + ", " + coordinates(image) + ", " + wanted;
    return false;
  }

  bool place_pair(std::size_t i, std::size_t k, side_station& station) {
    station.first = first(i);
    station.second = second(k);
    const point image = made_.map_.image(station.first);
    return distance_between(image, station.second) <= allowed_ ||
           lose(station.first, image, "the other side has no corner");
  }

  // Places the image of a corner on a segment of the second side.
  bool place_image(std::size_t i, std::size_t k, side_station& station) {
    const point image = made_.map_.image(first(i)), &a = second(k), &b = second(k + 1);
    const point on_line = at_part(a, b, part_of(a, b, image));
    station.first = first(i);
    station.second = made_.map_.is_exact ? image : on_line;
    return made_.map_.is_exact
               ? maps_exactly(made_.map_, first(i), image) && is_near_enough(a, b, on_line, image)
               : distance_between(image, on_line) <= allowed_ ||
                     lose(first(i), image, "the other side is not");
  }

  // Places the point of the first side whose image is this corner of the second side.
  bool place_origin(std::size_t k, std::size_t i, side_station& station) {
    const side_map& map = made_.map_;
    const point back{second(k).x - map.shift.x, second(k).y - map.shift.y}, &a = first(i),
                                                                            &b = first(i + 1);
    const point origin{map.cosine * back.x + map.sine * back.y,
                       map.cosine * back.y - map.sine * back.x};
    const point on_line = at_part(a, b, part_of(a, b, origin));
    station.second = second(k);
    station.first = map.is_exact ? origin : on_line;
    return map.is_exact
               ? maps_exactly(map, origin, second(k)) && is_near_enough(a, b, on_line, origin)
               : distance_between(origin, on_line) <= allowed_ ||
                     lose(second(k), origin, "the other side is not");
  }

  const domain& d_;
  const periodic_pair markers_;
  side_line first_, second_;
  std::vector<corner_pair> pairs_;
  double allowed_ = 0;
  std::string lost_;
  periodic_sides made_;
};

result<periodic_sides> periodic_sides::find(const domain& d, const periodic_pair& markers) {
  auto found = side_finder(d, markers).find();
  if (found) return found;
  return error{"the sides with markers " + std::to_string(markers.first) + " and " +
                   std::to_string(markers.second) +
                   " cannot be periodic: " + found.failure().message,
               error_code::bad_option};
}

side_station periodic_sides::station_at(const side_interval& in, const point& place) {
  const double part = part_of(in.first_from, in.first_to, place);
  side_station made;
  made.first = at_part(in.first_from, in.first_to, part);
  made.second = at_part(in.second_from, in.second_to, part);
  if (!map_.is_exact) return made;
  for (const slide along : {slide::none, slide::along_x, slide::along_y}) {
    const point near = slid(map_, in.first_from, in.first_to, made.first, along);
    const auto exact = exact_images(map_, near);
    const double there = part_of(in.first_from, in.first_to, near);
    constexpr double farthest = 0x1p-30;  // part of the interval, as along an axis
    if (!exact || !(std::abs(there - part) <= farthest) ||
        !is_near_enough(in.first_from, in.first_to, near, (*exact)[0]) ||
        !is_near_enough(in.second_from, in.second_to, at_part(in.second_from, in.second_to, there),
                        (*exact)[1]))
      continue;
    made.first = (*exact)[0];
    made.second = (*exact)[1];
    return made;
  }
  map_.is_exact = false;
  return made;
}

std::size_t periodic_sides::insert(std::size_t interval, const std::vector<point>& places) {
  const side_interval in = intervals_[interval];
  std::vector<side_station> made;
  const auto follows = [&in](const side_station& a, const side_station& b) {
    return part_of(in.first_from, in.first_to, a.first) <
               part_of(in.first_from, in.first_to, b.first) &&
           part_of(in.second_from, in.second_to, a.second) <
               part_of(in.second_from, in.second_to, b.second);
  };
  for (const point& q : places) {
    const side_station one = station_at(in, q);
    if (follows(made.empty() ? stations_[interval] : made.back(), one) &&
        follows(one, stations_[interval + 1]))
      made.push_back(one);
  }
  const auto at = static_cast<std::ptrdiff_t>(interval);
  stations_.insert(stations_.begin() + at + 1, made.begin(), made.end());
  intervals_.insert(intervals_.begin() + at + 1, made.size(), in);
  return made.size();
}

point periodic_sides::first_of(std::size_t interval, const point& on_second) const {
  const side_interval& in = intervals_[interval];
  return at_part(in.first_from, in.first_to, part_of(in.second_from, in.second_to, on_second));
}

}  // namespace asterism::internal
