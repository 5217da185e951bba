// SPDX-License-Identifier: MIT
#include "asterism/mesh/proof/curve_distance.hpp"

#include <algorithm>
#include <array>

namespace asterism::internal::proof_detail {
namespace {

using integer =
    boost::multiprecision::number<boost::multiprecision::gmp_int, boost::multiprecision::et_off>;
using rational_point = vector2<rational>;

// Square roots are rounded to multiples of 2^-200, outward.
constexpr unsigned root_bits = 200;
// Number of places of a cubic that are tried for each vertex, and number of times that the step is
// halved from there. Neither affects validity: a poor place only makes the bound larger.
constexpr int samples = 1024, most_steps = 60;

rational_point exact(const point& p) { return {rational(p.x), rational(p.y)}; }

// Returns a fraction that is at most the root of x, and less by at most 2^-200.
rational root_below(const rational& x) {
  const integer fine = integer(1) << root_bits;
  const integer whole = numerator(x) * fine * fine / denominator(x);
  return rational(integer(boost::multiprecision::sqrt(whole)), fine);
}
rational root_above(const rational& x) {
  return root_below(x) + rational(2) / rational(integer(1) << root_bits);
}

// Returns the square of the distance of p from a segment.
rational squared_distance(const rational_point& p, const rational_point& from,
                          const rational_point& to) {
  const rational_point along = to - from, way = p - from;
  const rational part = dot(along, way), length = dot(along, along);
  if (part <= 0) return dot(way, way);
  if (part >= length) return dot(p - to, p - to);
  const rational off = cross(along, way);
  return off * off / length;
}

// Bounds the distance by theorem 7. Returns nothing unless each chord turns around the centre by
// less than half a turn and the chords together by no more than one turn, which only those of a
// whole circle complete.
std::optional<rational> distance_of_arc(const domain_curve& curve,
                                        const std::vector<point>& chords) {
  const rational_point centre = exact(curve.centre);
  const rational side = curve.clockwise ? -1 : 1;
  const rational_point start = exact(chords.front()) - centre;
  const rational squared_radius = dot(start, start);
  const rational low = root_below(squared_radius), high = root_above(squared_radius);
  rational greatest = 0;
  for (std::size_t k = 0; k + 1 < chords.size(); ++k) {
    const rational_point p = exact(chords[k]) - centre, q = exact(chords[k + 1]) - centre;
    if (!(side * cross(p, q) > 0)) return std::nullopt;
    const bool comes_again = side * cross(start, p) < 0 && side * cross(start, q) >= 0;
    const bool is_end = chords.front() == chords.back() && k + 2 == chords.size();
    if (comes_again != is_end) return std::nullopt;
    const rational nearest = squared_distance({0, 0}, p, q);
    greatest = std::max({greatest, rational(high - root_below(nearest)),
                         rational(root_above(std::max(dot(p, p), dot(q, q))) - low)});
  }
  return greatest;
}

class cubic {
 public:
  cubic(const domain_curve& curve, const point& from, const point& to)
      : plain_{from, curve.control[0], curve.control[1], to},
        exact_{exact(from), exact(curve.control[0]), exact(curve.control[1]), exact(to)} {}

  // Returns the parameter above `after` of a point of the curve about nearest to `to`.
  double look_for(const point& to, double after) const {
    double best = 1, least = -1;
    for (int k = 1; k < samples; ++k) {
      const double t = static_cast<double>(k) / samples;
      if (t > after) improve(t, to, best, least);
    }
    if (least < 0) return best;
    double step = 1.0 / samples;
    for (int i = 0; i < most_steps; ++i) {
      step /= 2;
      const double middle = best;
      for (const double t : {middle - step, middle + step})
        if (after < t && t < 1) improve(t, to, best, least);
    }
    return best;
  }

  // Bounds the distance between a chord and the piece of the curve between two parameters, in both
  // directions.
  std::optional<rational> distance_of_piece(const rational& s, const rational& t,
                                            const rational_point& from,
                                            const rational_point& to) const {
    const std::array<rational_point, 4> b = {blossom(s, s, s), blossom(s, s, t), blossom(s, t, t),
                                             blossom(t, t, t)};
    const rational_point along = to - from;
    const rational length = dot(along, along);
    if (!(length > 0)) return std::nullopt;
    std::array<rational, 4> off;
    bool project = true;
    for (std::size_t i = 0; i < 4; ++i) {
      const rational across = cross(along, b[i] - from), part = dot(along, b[i] - from);
      off[i] = root_above(across * across / length);
      if (i == 1 || i == 2) project = project && part >= 0 && part <= length;
    }
    const rational e =
        root_above(std::max(dot(b[0] - from, b[0] - from), dot(b[3] - to, b[3] - to)));
    rational bound = std::max(off[0], off[3]) + rational(3, 4) * std::max(off[1], off[2]) + 2 * e;
    if (project) return bound;
    for (const rational_point& p : b)
      bound = std::max(bound, root_above(squared_distance(p, from, to)));
    return bound;
  }

 private:
  point place(double t) const {
    const double s = 1 - t;
    const std::array<double, 4> weight = {s * s * s, 3 * s * s * t, 3 * s * t * t, t * t * t};
    point sum{0, 0};
    for (std::size_t i = 0; i < 4; ++i)
      sum = {sum.x + weight[i] * plain_[i].x, sum.y + weight[i] * plain_[i].y};
    return sum;
  }
  void improve(double t, const point& to, double& best, double& least) const {
    const point p = place(t);
    const double x = p.x - to.x, y = p.y - to.y, square = x * x + y * y;
    if (least >= 0 && !(square < least)) return;
    best = t;
    least = square;
  }
  // Returns the value of the curve's polar form (blossom), which is affine in each parameter.
  rational_point blossom(const rational& u, const rational& v, const rational& w) const {
    std::array<rational_point, 4> p = exact_;
    std::size_t count = 4;
    for (const rational& t : {u, v, w}) {
      --count;
      for (std::size_t i = 0; i < count; ++i) p[i] = rational(1 - t) * p[i] + t * p[i + 1];
    }
    return p[0];
  }

  std::array<point, 4> plain_;
  std::array<rational_point, 4> exact_;
};

// Bounds the distance by theorem 7. Returns nothing unless the parameters of the vertices increase
// from 0 to 1.
std::optional<rational> distance_of_cubic(const domain_curve& curve,
                                          const std::vector<point>& chords) {
  const cubic whole(curve, chords.front(), chords.back());
  rational greatest = 0;
  double before = 0;
  for (std::size_t k = 0; k + 1 < chords.size(); ++k) {
    const double after = k + 2 == chords.size() ? 1 : whole.look_for(chords[k + 1], before);
    if (!(before < after)) return std::nullopt;
    const auto piece = whole.distance_of_piece(rational(before), rational(after), exact(chords[k]),
                                               exact(chords[k + 1]));
    if (!piece) return std::nullopt;
    greatest = std::max(greatest, *piece);
    before = after;
  }
  return greatest;
}

}  // namespace

std::optional<rational> distance_from_chords(const domain_curve& curve,
                                             const std::vector<point>& chords) {
  return curve.kind == curve_kind::arc ? distance_of_arc(curve, chords)
                                       : distance_of_cubic(curve, chords);
}

}  // namespace asterism::internal::proof_detail
