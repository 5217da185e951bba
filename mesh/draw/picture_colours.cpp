// SPDX-License-Identifier: MIT
#include "asterism/mesh/draw/picture_colours.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <span>

#include "asterism/core/elementary.hpp"
#include "asterism/mesh/numerics/metric_angle.hpp"

namespace asterism::internal {
namespace {

constexpr colour rgb(int red, int green, int blue) {
  return {red / 255.0, green / 255.0, blue / 255.0};
}

constexpr std::array bad_to_good = {rgb(165, 0, 38),    rgb(215, 90, 60),   rgb(253, 190, 110),
                                    rgb(255, 250, 200), rgb(171, 217, 233), rgb(90, 150, 200),
                                    rgb(49, 70, 149)};
constexpr colour below_bound = rgb(185, 0, 45);
constexpr std::array light_to_dark = {rgb(250, 247, 235), rgb(220, 225, 170), rgb(120, 190, 160),
                                      rgb(50, 130, 150),  rgb(40, 70, 120),   rgb(30, 20, 70)};
constexpr std::array dark_to_light = {rgb(68, 1, 84),    rgb(65, 68, 135),  rgb(42, 120, 142),
                                      rgb(34, 168, 132), rgb(122, 209, 81), rgb(253, 231, 37)};
constexpr std::array both_signs = {rgb(30, 60, 150), rgb(110, 150, 215), rgb(245, 245, 245),
                                   rgb(225, 130, 90), rgb(150, 15, 35)};
constexpr std::array distinct = {rgb(102, 166, 214), rgb(244, 165, 96),  rgb(120, 190, 120),
                                 rgb(220, 120, 140), rgb(170, 150, 210), rgb(200, 180, 90),
                                 rgb(100, 190, 190), rgb(210, 140, 200), rgb(150, 170, 110),
                                 rgb(190, 150, 130)};
// Factor that darkens the colours for lines, which are thin; the hues stay.
constexpr double darker = 0.7;
constexpr std::size_t most_boxes = 12;

using stops = std::span<const colour>;

colour mix(stops of, double s) {
  const double at = std::clamp(s, 0.0, 1.0) * static_cast<double>(of.size() - 1);
  const std::size_t i = std::min(of.size() - 2, static_cast<std::size_t>(at));
  const double part = at - static_cast<double>(i);
  const auto between = [part](double a, double b) { return a + (b - a) * part; };
  return {between(of[i].red, of[i + 1].red), between(of[i].green, of[i + 1].green),
          between(of[i].blue, of[i + 1].blue)};
}

std::string text_of(double x) { return fmt::format("{:.4g}", x); }

// Colours the triangles by numbers, between two end colours.
picture_colouring by_number(const std::vector<double>& values, double low, double high, stops of) {
  picture_colouring made;
  made.triangles.reserve(values.size());
  const double width = high > low ? high - low : 1;
  for (const double x : values) made.triangles.push_back(mix(of, (x - low) / width));
  made.legend.bar.assign(of.begin(), of.end());
  made.legend.low = text_of(low);
  made.legend.high = text_of(high);
  return made;
}

template <class Of>
std::vector<double> of_triangles(const mesh& m, const Of& of) {
  std::vector<double> values;
  values.reserve(m.triangles.size());
  for (const triangle& t : m.triangles) values.push_back(of(t));
  return values;
}

// Colours each triangle by its least angle, on a scale from the bound to 60 degrees; angles below
// the bound all get the scale's first colour. Without a bound the scale begins at the least angle.
picture_colouring by_angle(const mesh& m, double bound) {
  const std::vector<double> values =
      of_triangles(m, [&](const triangle& t) { return smallest_angle(m, t); });
  const double least = std::min(59.0, *std::min_element(values.begin(), values.end()));
  const bool has_bound = bound > 0;
  const stops scale = has_bound ? stops(bad_to_good).subspan(2) : stops(bad_to_good);
  picture_colouring made = by_number(values, has_bound ? bound : least, 60, scale);
  made.legend.title = "least angle, degrees";
  if (!has_bound) return made;
  std::size_t below = 0;
  for (std::size_t t = 0; t < values.size(); ++t)
    if (values[t] < bound) {
      made.triangles[t] = below_bound;
      ++below;
    }
  made.legend.boxes.emplace_back(below_bound, fmt::format("below the bound: {}", below));
  return made;
}

// Computes twice the area of a triangle, and its longest edge.
std::pair<double, double> extent(const mesh& m, const triangle& t) {
  const std::array<point, 3> p = {m.sites[t[0]].position, m.sites[t[1]].position,
                                  m.sites[t[2]].position};
  double longest = 0;
  for (std::size_t i = 0; i < 3; ++i)
    longest =
        std::max(longest, elementary::hypot(p[(i + 1) % 3].x - p[i].x, p[(i + 1) % 3].y - p[i].y));
  const double twice =
      (p[1].x - p[0].x) * (p[2].y - p[0].y) - (p[2].x - p[0].x) * (p[1].y - p[0].y);
  return {std::fabs(twice), longest};
}

std::vector<double> aspects(const mesh& m) {
  return of_triangles(m, [&](const triangle& t) {
    const auto [twice, longest] = extent(m, t);
    return longest * longest / twice;
  });
}

std::vector<double> sizes(const mesh& m) {
  return of_triangles(m, [&](const triangle& t) { return std::sqrt(extent(m, t).first / 2); });
}

// Returns the quantile: the value below which the share `part` of the values lies.
double quantile(std::vector<double> values, double part) {
  const auto at =
      values.begin() + static_cast<std::ptrdiff_t>(part * static_cast<double>(values.size() - 1));
  std::nth_element(values.begin(), at, values.end());
  return *at;
}

// Scales logarithms from the least value to the one that a thousandth of the values exceed.
picture_colouring by_logarithm(std::vector<double> values, const char* title) {
  std::vector<double> sorted = values;
  std::sort(sorted.begin(), sorted.end());
  const double low = sorted.front(),
               high = std::max(sorted[(sorted.size() - 1) * 999 / 1000], 1.1 * low);
  for (double& x : values) x = elementary::log(x);
  picture_colouring made =
      by_number(values, elementary::log(low), elementary::log(high), light_to_dark);
  made.legend.title = title;
  made.legend.low = text_of(low);
  made.legend.high = text_of(high);
  return made;
}

// Makes a legend's box for each number, as far as there is room.
template <class Name>
std::map<int, colour> boxes_of(const std::vector<int>& numbers, double shade,
                               picture_legend& legend, const Name& name) {
  std::map<int, colour> colours;
  for (const int n : numbers) colours.emplace(n, colour{});
  std::size_t i = 0;
  for (auto& [n, c] : colours) {
    const colour& hue = distinct[i++ % distinct.size()];
    c = {shade * hue.red, shade * hue.green, shade * hue.blue};
    if (i <= most_boxes) legend.boxes.emplace_back(c, name(n));
  }
  if (i > most_boxes)
    legend.boxes.emplace_back(colour{1, 1, 1}, fmt::format("and {} more", i - most_boxes));
  return colours;
}

picture_colouring by_region(const mesh& m) {
  picture_colouring made;
  std::vector<int> regions = m.regions;
  if (regions.empty()) regions.assign(m.triangles.size(), 1);
  const auto colours =
      boxes_of(regions, 1, made.legend, [](int n) { return fmt::format("region {}", n); });
  for (const int n : regions) made.triangles.push_back(colours.at(n));
  return made;
}

picture_colouring by_marker(const mesh& m) {
  picture_colouring made;
  std::vector<int> markers;
  for (const boundary_edge& e : m.boundary) markers.push_back(e.marker);
  const auto colours =
      boxes_of(markers, darker, made.legend, [](int n) { return fmt::format("marker {}", n); });
  for (const int n : markers) made.boundary.push_back(colours.at(n));
  return made;
}

result<picture_colouring> by_field(const mesh& m, const solution_field& field) {
  if (field.kind != field_kind::scalar || field.values.size() != m.sites.size())
    return error{"the field " + field.name + " has not one number for each vertex",
                 error_code::bad_option};
  const auto values = of_triangles(m, [&](const triangle& t) {
    return field.values[t[0]] / 3 + field.values[t[1]] / 3 + field.values[t[2]] / 3;
  });
  const auto [low, high] = std::minmax_element(field.values.begin(), field.values.end());
  // Makes 0 white if values have both signs, unless those of one sign are all close to 0.
  const bool signs = *low < 0 && *high > 0 && std::min(-*low, *high) > 0.02 * (*high - *low);
  const double end = std::max(-*low, *high);
  picture_colouring made = signs ? by_number(values, -end, end, both_signs)
                                 : by_number(values, *low, *high, dark_to_light);
  made.legend.title = field.name;
  return made;
}

}  // namespace

picture_by most_telling(const mesh& m) {
  if (quantile(aspects(m), 0.9) > 4) return picture_by::aspect;
  const std::vector<double> all = sizes(m);
  return quantile(all, 0.95) > 3 * quantile(all, 0.05) ? picture_by::size : picture_by::angle;
}

result<picture_colouring> colours_of(const mesh& m, const picture_options& options) {
  const picture_by by = options.colours;
  if (by == picture_by::nothing) return picture_colouring{};
  if (by == picture_by::marker && m.boundary.empty())
    return error{"there are no boundary edges to colour by marker", error_code::bad_option};
  if (by != picture_by::marker && m.triangles.empty())
    return error{"there are no triangles to colour", error_code::bad_option};
  switch (by) {
    case picture_by::angle:
      return by_angle(m, options.angle_bound);
    case picture_by::aspect:
      return by_logarithm(aspects(m), "length over width");
    case picture_by::size:
      return by_logarithm(sizes(m), "root of the area");
    case picture_by::region:
      return by_region(m);
    case picture_by::marker:
      return by_marker(m);
    case picture_by::field:
    case picture_by::nothing:
      break;
  }
  return by_field(m, options.field);
}

}  // namespace asterism::internal
