// SPDX-License-Identifier: MIT
//
// Compares lengths and distances exactly, and rounds the point in which two segments cross. Works
// inside repair_domain; all coordinates must be finite.
#pragma once

#include "asterism/core/site.hpp"

namespace asterism::internal {

// True if p and q are less than `distance` apart.
bool are_nearer(const point& p, const point& q, double distance);

// True if p is nearer to q than to r.
bool is_nearer_to(const point& p, const point& q, const point& r);

// True if the perpendicular from v meets the segment between a and b inside, and is at most
// `distance` long.
bool is_beside(const point& v, const point& a, const point& b, double distance);

// True if p and q are nearer to each other than a and b.
bool is_shorter(const point& p, const point& q, const point& a, const point& b);

// True if each of v's distances to a and b is less than the distance between a and b.
bool shortens(const point& v, const point& a, const point& b);

// Returns the common point of the lines a b and c d, which must not be parallel: each coordinate
// the double nearest to it, rounded once.
point rounded_crossing(const point& a, const point& b, const point& c, const point& d);

}  // namespace asterism::internal
