// SPDX-License-Identifier: MIT
//
// Replaces the curves of a domain by chords: segments between points of the curve, each rounded
// once. The polygon of these is meshed.
//
// A curve as a file or a program gives it has two vertices, with parameters 0 and 1, and
// `segment` names the segment between them. (Of a whole circle both are the same, and that segment
// has no length.) Dividing puts chords in the segment's place, in its direction and with its
// marker; new vertices and the other chords come after those that are there, in the order of the
// curves and along each.
//
// A curve is divided until, computed in doubles,
//  - an arc turns by at most an eighth of a turn in each piece, and a cubic's control polygon goes
//    forward along the chord;
//  - no piece is farther from its chord than the tolerance;
//  - in a metric, no piece is longer than wanted, and without a tolerance none farther from its
//    chord than a fiftieth of the size wanted across it, or, of a metric on a mesh, a
//    hundredth, as long as that leaves pieces that are nearly half as long as wanted;
// and, by exact signs of rounded control points,
//  - nothing is between a piece and its chord: the hulls of the pieces have no point in
//    common with each other, with a straight segment or with a vertex, their common ends left out.
//    So the polygon has the topology of the curves: nothing inside of these is outside of it.
//
// Refused, by name and line:
//  - centres and control points that are not finite, a radius of 0;
//  - an arc whose ends differ in distance from the centre by more than a millionth of the radius,
//    which six digits explain;
//  - a curve on a segment without length, on one that another curve is on, or whose vertices are
//    not the segment's;
//  - curves that cross or touch each other, a segment or a vertex elsewhere than in a common end,
//    or themselves, or run into a common end in one direction: pieces of 2^-22 of the curve still
//    meet.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "asterism/core/export.h"
#include "asterism/core/result.hpp"
#include "asterism/mesh/data/domain.hpp"
#include "asterism/mesh/data/metric_field.hpp"

namespace asterism {

// Demands on the chords of curves.
struct curve_division {
  // Greatest distance of a curve from its chord; default: a fiftieth of the chord's length.
  std::optional<double> chord_tolerance = {};
  // Metric in which pieces are as long as edges of a mesh of unit edges, and near to their chords;
  // default: none. Either demand is dropped if it takes more than `most_chords`. Must outlive the
  // call.
  const metric_field* field = nullptr;
  std::size_t most_chords = 100000;
  // Greatest distance of a curve from its chord as a part of the metric's size across; default: as
  // described above. If it exceeds a fiftieth, it also bounds the distance in lengths of the chord.
  std::optional<double> part_of_size = {};
  // False to add no pieces for the metric length: present pieces are halved alone, and only while
  // they are longer than the least one halved for the size across.
  bool is_even = true;
};

// Returns the domain with chords for its curves, as check_domain takes it. Without curves it is
// returned unchanged. Fails also where the field does.
ASTERISM_EXPORT result<domain> divide_curves(const domain& d, const curve_division& wanted = {});

// Returns a domain that check_domain has accepted, divided already, with other chords: removes the
// vertices between the ends of its curves, and adds new ones after the others.
ASTERISM_EXPORT result<domain> divide_curves_anew(const domain& d, const curve_division& wanted);

// Returns the domain with curve i divided at `parameters[i]`, which increase from 0 to 1: the
// domain that a certificate refers to.
ASTERISM_EXPORT result<domain> divide_curves_at(const domain& d,
                                                const std::vector<std::vector<double>>& parameters);

}  // namespace asterism
