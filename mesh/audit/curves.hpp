// SPDX-License-Identifier: MIT
//
// Measures how far the boundary of a mesh is from the curves of its domain, by upper bounds that
// are rounded upwards once; inside the auditor alone. docs/math/curves.md proves them.
#pragma once

#include <map>
#include <optional>
#include <utility>
#include <vector>

#include "asterism/mesh/audit/context.hpp"

namespace asterism::internal::audit_detail {

// A curve of the domain in exact numbers.
class curve_measure {
 public:
  // Requires vertices in range and finite numbers.
  curve_measure(const domain& d, const domain_curve& curve);

  // Returns an upper bound of the distance from q to the curve's point at t; of an arc, to the
  // circle.
  rational distance_to(const point& q, double t) const;
  // Returns an upper bound of the distance from any point of the piece to its chord and of any
  // point of the chord to the piece. The piece leads from t0 to t1, or from the direction of q0 to
  // that of q1; the chord from q0 to q1. Nothing where an arc's piece is half a turn or more, or
  // runs backwards.
  std::optional<rational> distance_of_chord(const point& q0, double t0, const point& q1,
                                            double t1) const;
  // Returns the parameter of the point of a cubic's piece that is nearest to q, in doubles; nothing
  // if an end is nearest. Returns t0 for an arc.
  std::optional<double> parameter_of(const point& q, double t0, double t1) const;
  // True if the direction of q lies within the arc's piece from q0 to q1, its ends left out; always
  // of a cubic.
  bool is_within(const point& q0, const point& q, const point& q1) const;
  // Returns the sign of the turn from a to b around an arc's centre, positive along the arc.
  sign turn(const point& a, const point& b) const;
  // Returns the largest coordinate or radius that points of the curve are computed with.
  double reach() const;

 private:
  std::optional<rational> arc_distance(const point& q0, const point& q1) const;
  rational cubic_distance(const point& q0, double t0, const point& q1, double t1) const;
  vector2<rational> blossom(double u, double v, double w) const;

  const domain_curve* curve_;
  std::array<point, 4> control_;          // of a cubic
  rational radius_below_, radius_above_;  // of an arc
};

// Judges the chords of curves while the segments of the domain are compared with the mesh.
class curve_audit {
 public:
  explicit curve_audit(audit_context& context);

  // Judges the mesh's vertices along a segment of the domain, ends included, if the segment is a
  // chord of a curve; returns false otherwise. Vertices that are on the curve but for rounding
  // divide the chord; for those between two of them `straight` is called.
  template <class Straight>
  bool judge(const std::vector<vertex_index>& along, const Straight& straight) {
    const auto found = chords_.find(std::minmax(along.front(), along.back()));
    if (found == chords_.end()) return false;
    for (const std::vector<vertex_index>& part : parts_of(along, found->second)) straight(part);
    return true;
  }
  // Reports chords of curves that no segment of the domain was found for.
  void finish();

 private:
  struct chord {
    std::size_t curve = 0, first = 0;  // first vertex: of the curve's list
    bool seen = false;
  };

  bool add(std::size_t curve);
  bool check_vertices(std::size_t curve);
  bool check_turn(std::size_t curve);
  std::vector<std::vector<vertex_index>> parts_of(std::vector<vertex_index> along, chord& at);
  void measure(const curve_measure& curve, std::size_t number, vertex_index a, double t0,
               vertex_index b, double t1);
  std::string text(std::size_t curve) const;

  audit_context* context_;
  std::vector<std::optional<curve_measure>> curves_;
  std::map<std::pair<vertex_index, vertex_index>, chord> chords_;
};

}  // namespace asterism::internal::audit_detail
