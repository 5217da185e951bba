// SPDX-License-Identifier: MIT
#include "asterism/mesh/transfer/transfer_scale.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "asterism/mesh/data/bounding_box.hpp"

namespace asterism::internal {
namespace {

// Encloses the coordinates of two meshes.
bounding_box box_of(const mesh& from, const mesh& to) {
  bounding_box box{from.sites[0].position, from.sites[0].position};
  for (const mesh* const m : {&from, &to})
    for (const site& s : m->sites) box.include(s.position);
  return box;
}

// Returns an origin for coordinates between two ends, from which all their differences are exact: a
// number less half of it, up to twice it, is a double (Sterbenz 1974).
double origin_between(double low, double high) {
  if (low > 0 && high / 2 <= low) return low;
  if (high < 0 && low / 2 >= high) return high;
  return 0;
}

double largest_value(const solution_field& f) {
  double largest = 0;
  for (const double u : f.values) largest = std::max(largest, std::abs(u));
  return largest;
}

// Returns the binary exponent of a number if its modulus exceeds `ordinary`, else 0.
int power_beyond(double largest, int ordinary) {
  if (!(largest > 0)) return 0;
  const int power = std::ilogb(largest);
  return std::abs(power) > ordinary ? power : 0;
}

// Returns the exponent of the least power of two that divides values to ordinary size: a greater
// one would lose small values.
int power_to_ordinary(double largest, int ordinary) {
  const int power = power_beyond(largest, ordinary);
  return power - std::clamp(power, -ordinary, ordinary);
}

void multiply(solution& s, const transfer_scale& scale, int sign) {
  for (std::size_t f = 0; f < s.fields.size(); ++f)
    if (const int power = sign * scale.of_fields[f]; power != 0)
      for (double& u : s.fields[f].values) u = std::scalbn(u, power);
}

}  // namespace

bool transfer_scale::is_one() const {
  return origin == point{0, 0} && of_places == 0 &&
         std::all_of(of_fields.begin(), of_fields.end(), [](int power) { return power == 0; });
}

transfer_scale scale_of(const mesh& from, const solution& values, const mesh& to) {
  // Exponents of the greatest ordinary place and value: squares of products of an area and a value
  // are up to 2^(4 * 32 + 2 * 300).
  constexpr int ordinary_place = 32, ordinary_value = 300;
  transfer_scale scale;
  const bounding_box box = box_of(from, to);
  scale.origin = {origin_between(box.low.x, box.high.x), origin_between(box.low.y, box.high.y)};
  const auto farthest = [](double low, double high, double origin) {
    return std::max(std::abs(low - origin), std::abs(high - origin));
  };
  scale.of_places = power_beyond(std::max(farthest(box.low.x, box.high.x, scale.origin.x),
                                          farthest(box.low.y, box.high.y, scale.origin.y)),
                                 ordinary_place);
  for (const solution_field& f : values.fields)
    scale.of_fields.push_back(power_to_ordinary(largest_value(f), ordinary_value));
  return scale;
}

mesh placed(mesh m, const transfer_scale& scale) {
  for (site& s : m.sites)
    s.position = {std::scalbn(s.position.x - scale.origin.x, -scale.of_places),
                  std::scalbn(s.position.y - scale.origin.y, -scale.of_places)};
  return m;
}

solution divided(solution s, const transfer_scale& scale) {
  multiply(s, scale, -1);
  return s;
}

void multiply(transferred_solution& made, const transfer_scale& scale) {
  multiply(made.values, scale, 1);
  transfer_report& report = made.report;
  const int of_areas = 2 * scale.of_places;
  for (double* const area : {&report.area_before, &report.area_after, &report.area_common})
    *area = std::scalbn(*area, of_areas);
  report.greatest_distance = std::scalbn(report.greatest_distance, scale.of_places);
  auto component = report.components.begin();
  for (std::size_t f = 0; f < made.values.fields.size(); ++f) {
    const int power = scale.of_fields[f];
    for (std::size_t c = 0; c < components_of(made.values.fields[f].kind); ++c, ++component) {
      transferred_component& one = *component;
      for (double* const value :
           {&one.least_before, &one.greatest_before, &one.least_after, &one.greatest_after})
        *value = std::scalbn(*value, power);
      for (double* const integral : {&one.integral_before, &one.integral_after})
        *integral = std::scalbn(*integral, power + of_areas);
    }
  }
}

}  // namespace asterism::internal
