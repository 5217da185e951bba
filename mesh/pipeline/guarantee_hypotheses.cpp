// SPDX-License-Identifier: MIT
#include "asterism/mesh/pipeline/guarantee_hypotheses.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "asterism/core/elementary.hpp"
#include "asterism/core/number_text.hpp"
#include "asterism/mesh/domain/message_names.hpp"
#include "asterism/mesh/metric/variation_bound.hpp"
#include "asterism/mesh/pipeline/field_variation.hpp"

namespace asterism::internal {
namespace {

// Returns the direction of u in coordinates in which m is round: up to a rotation, u times the
// upper triangular root of m. In radians, from -pi to pi.
double direction_in(const metric_tensor& m, const point& u) {
  const double root = std::sqrt(m.m11);
  const double across = std::sqrt(std::max(0.0, m.m11 * m.m22 - m.m12 * m.m12)) / root;
  return elementary::atan2(across * u.y, root * u.x + m.m12 / root * u.y);
}

// The least angle, in degrees, between two adjacent segments at a vertex.
struct narrow_corner {
  double degrees = 360;
  bool inside = true;  // is the domain between them?
};

// A segment at a vertex, by its direction away from it.
struct segment_end {
  double direction = 0;
  bool domain_behind = true;  // is the domain counter-clockwise of it?
};

narrow_corner narrowest(std::vector<segment_end> ends) {
  narrow_corner found;
  if (ends.size() < 2) return found;
  std::sort(ends.begin(), ends.end(),
            [](const segment_end& a, const segment_end& b) { return a.direction < b.direction; });
  for (std::size_t i = 0; i < ends.size(); ++i) {
    const segment_end& next = ends[(i + 1) % ends.size()];
    double turn = next.direction - ends[i].direction;
    if (i + 1 == ends.size()) turn += 2 * std::numbers::pi;
    const double degrees = turn * (180 / std::numbers::pi);
    if (degrees < found.degrees) found = {degrees, ends[i].domain_behind};
  }
  return found;
}

result<std::vector<std::vector<segment_end>>> ends_of_segments(const domain& d,
                                                               const metric_field& field) {
  std::vector<std::vector<segment_end>> ends(d.vertices.size());
  const auto add = [&](vertex_index at, vertex_index to, bool left) {
    const auto metric = field.at(d.vertices[at]);
    if (!metric) return std::optional(metric.failure());
    const point u{d.vertices[to].x - d.vertices[at].x, d.vertices[to].y - d.vertices[at].y};
    ends[at].push_back({direction_in(metric.value(), u), left});
    return std::optional<error>();
  };
  for (const segment& s : d.segments) {
    // Decides by orientation: the domain is on the left of a segment, and on its right too where it
    // is internal.
    if (auto failure = add(s.a, s.b, true)) return *failure;
    if (auto failure = add(s.b, s.a, s.internal)) return *failure;
  }
  return ends;
}

// Finds the narrowest corner; refuses it where it is narrower than a guarantee can be given for.
std::optional<error> refused_corner(const domain& d, const metric_field& field,
                                    double& narrowest_corner) {
  const auto ends = ends_of_segments(d, field);
  if (!ends) return ends.failure();
  const domain_names names(d);
  for (std::size_t v = 0; v < d.vertices.size(); ++v) {
    const narrow_corner corner = narrowest(ends.value()[v]);
    narrowest_corner = std::min(narrowest_corner, corner.degrees);
    if (!(corner.degrees < least_guaranteed_corner)) continue;
    return error{names.at_vertex(v) + "no guarantee: the " +
                     (corner.inside ? "corner" : "outer corner") + " at " + names.vertex(v) +
                     " has " + format_number(corner.degrees) +
                     " degrees as its own metric measures it, and at least " +
                     format_number(least_guaranteed_corner) +
                     " are needed: vertices on its two sides would be too near to each other for "
                     "the theorem, at any size",
                 error_code::invalid_domain};
  }
  return std::nullopt;
}

}  // namespace

std::optional<error> refused_guarantee(const domain& d, const metric_field& field,
                                       const mesh_options& options, field_steepness& steepness) {
  if (!(options.angle_bound <= greatest_guaranteed_bound))
    return error{"a guarantee is given for angle bounds of at most " +
                     format_number(greatest_guaranteed_bound) + " degrees, not for " +
                     format_number(options.angle_bound),
                 error_code::bad_option};
  double narrowest_corner = 360;
  if (auto refused = refused_corner(d, field, narrowest_corner)) return refused;
  const auto samples = sample_variation(d, field);
  if (!samples) return samples.failure();
  const variation_bounds bounds = bound_variation(d, field);
  steepness = {samples.value().variation, bounds.above, narrowest_corner};
  if (!samples.value().jump) return std::nullopt;
  const field_jump& jump = *samples.value().jump;
  return error{"no guarantee: between " + coordinates(jump.from) + " and " + coordinates(jump.to) +
                   " the metric changes by a factor of " + format_number(jump.factor) +
                   " in lengths, and no jump is allowed",
               error_code::invalid_metric};
}

}  // namespace asterism::internal
