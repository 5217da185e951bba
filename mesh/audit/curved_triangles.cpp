// SPDX-License-Identifier: MIT
#include "asterism/mesh/audit/curved_triangles.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <optional>
#include <utility>

#include "asterism/mesh/audit/curves.hpp"
#include "asterism/mesh/audit/number.hpp"
#include "asterism/mesh/audit/roots.hpp"
#include "asterism/mesh/audit/rounded_rational.hpp"

namespace asterism {
using namespace internal;
using namespace internal::audit_detail;
namespace {

// Largest number of halvings of one part. Two halvings halve the length of all sides, so that the
// sides of the smallest part are 2^-15 as long; a determinant that vanishes inside a side stays
// undecided after any number of halvings.
constexpr int most_halvings = 30;
// Largest number of parts of one triangle. A determinant that comes near to 0 along a line takes
// about as many as the root of the ratio of its greatest to its least value.
constexpr std::size_t most_parts = 10'000;

// Control points of a quadratic triangle: of the corners 0, 1, 2, and of the sides 01, 12, 20.
using net = std::array<point, 6>;

// Bernstein coefficients of a quadratic polynomial over a triangle, in the order of the control
// points.
template <class Number>
using coefficients = std::array<Number, 6>;

template <class Number>
vector2<Number> vector_of(const point& p) {
  return {Number(p.x), Number(p.y)};
}
template <class Number>
vector2<Number> minus(const vector2<Number>& a, const vector2<Number>& b) {
  return {a.x - b.x, a.y - b.y};
}

// Returns the coefficients of the determinant of the map whose nodes are given. With straight sides
// each is twice the area.
//
// With control points b of the corners and c = 2 m - (p + q) / 2 of a side with the node m, the
// derivatives along 01 and 02 are 2 (l0 S0 + l1 S1 + l2 S2) and 2 (l0 T0 + l1 T1 + l2 T2), where
// S = (c01 - b0, b1 - c01, c12 - c20) and T = (c20 - b0, c12 - c01, b2 - c20). So the coefficient
// of corner i is 4 Si x Ti, that of side ij is 2 (Si x Tj + Sj x Ti).
template <class Number>
coefficients<Number> determinant(const net& nodes) {
  std::array<vector2<Number>, 3> b, c;
  for (std::size_t i = 0; i < 3; ++i) b[i] = vector_of<Number>(nodes[i]);
  const Number half(0.5), two(2.0), four(4.0);
  for (std::size_t i = 0; i < 3; ++i) {
    const vector2<Number> m = vector_of<Number>(nodes[3 + i]);
    const vector2<Number>&p = b[i], &q = b[(i + 1) % 3];
    c[i] = {two * m.x - half * (p.x + q.x), two * m.y - half * (p.y + q.y)};
  }
  const std::array<vector2<Number>, 3> s = {minus(c[0], b[0]), minus(b[1], c[0]),
                                            minus(c[1], c[2])};
  const std::array<vector2<Number>, 3> t = {minus(c[2], b[0]), minus(c[1], c[0]),
                                            minus(b[2], c[2])};
  coefficients<Number> made;
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t j = (i + 1) % 3;
    made[i] = four * cross(s[i], t[i]);
    made[3 + i] = two * (cross(s[i], t[j]) + cross(s[j], t[i]));
  }
  return made;
}

template <class Number>
Number straight_determinant(const net& nodes) {
  const auto a = vector_of<Number>(nodes[0]);
  return cross(minus(vector_of<Number>(nodes[1]), a), minus(vector_of<Number>(nodes[2]), a));
}

enum class jacobian_answer { positive, folds, undecided };

struct jacobian_proof {
  jacobian_answer answer = jacobian_answer::undecided;
  double least = 0;  // lower bound of the ratio; positive alone
};

// Proves the sign in doubles with error bounds; returns nothing where these bounds do not suffice.
std::optional<double> proved_in_doubles(const net& nodes) {
  const coefficients<bounded> all = determinant<bounded>(nodes);
  const bounded straight = straight_determinant<bounded>(nodes);
  if (!straight.certainly_positive()) return std::nullopt;
  double least = std::numeric_limits<double>::infinity();
  for (const bounded& one : all) {
    if (!one.certainly_positive()) return std::nullopt;
    least = std::min(least, (one / straight).lower());
  }
  return least > 0 ? std::optional(least) : std::nullopt;
}

using exact_coefficients = coefficients<rational>;

// Returns the coefficients over the two halves, cut from the middle of side `cut` to the corner
// opposite. The parts keep the turn of the whole.
std::array<exact_coefficients, 2> halves(const exact_coefficients& whole, std::size_t cut) {
  const std::size_t i = cut, j = (cut + 1) % 3, k = (cut + 2) % 3;
  const rational half(0.5), quarter(0.25);
  const rational middle = quarter * (whole[i] + whole[j]) + half * whole[3 + i];
  const rational to_i = half * (whole[i] + whole[3 + i]), to_j = half * (whole[3 + i] + whole[j]);
  const rational across = half * (whole[3 + k] + whole[3 + j]);  // of the sides ki and jk
  return {exact_coefficients{whole[i], middle, whole[k], to_i, across, whole[3 + k]},
          exact_coefficients{middle, whole[j], whole[k], to_j, whole[3 + j], across}};
}

// Decides the sign in rationals. The list of undecided parts holds at most one for each halving.
jacobian_proof proved_exactly(const net& nodes) {
  struct part {
    exact_coefficients all;
    int halvings;
  };
  const rational straight = straight_determinant<rational>(nodes);
  std::vector<part> left = {{determinant<rational>(nodes), 0}};
  std::optional<rational> least;
  for (std::size_t parts = 0; !left.empty(); ++parts) {
    if (parts == most_parts) return {};
    const part next = std::move(left.back());
    left.pop_back();
    const auto lowest = std::min_element(next.all.begin(), next.all.end());
    if (*std::min_element(next.all.begin(), next.all.begin() + 3) <= 0)
      return {jacobian_answer::folds, 0};
    if (*lowest > 0) {
      if (!least || *lowest < *least) least = *lowest;
      continue;
    }
    if (next.halvings == most_halvings) return {};
    const auto cut = static_cast<std::size_t>(lowest - next.all.begin()) - 3;
    for (exact_coefficients& half : halves(next.all, cut))
      left.push_back({std::move(half), next.halvings + 1});
  }
  if (straight <= 0) return {jacobian_answer::folds, 0};
  return {jacobian_answer::positive,
          as_double(rounded(rational(*least / straight), 53, direction::down), direction::down)};
}

jacobian_proof prove(const net& nodes) {
  if (const auto least = proved_in_doubles(nodes)) return {jacobian_answer::positive, *least};
  return proved_exactly(nodes);
}

bool is_before(const side_node& s, vertex_index a, vertex_index b) {
  return s.a != a ? s.a < a : s.b < b;
}

// Finds the node of a side by the side's ends.
class node_finder {
 public:
  node_finder(const mesh& m, const std::vector<side_node>& curved) : m_(m), curved_(curved) {}

  const side_node* find(vertex_index p, vertex_index q) const {
    const auto [a, b] = std::minmax(p, q);
    const auto at = std::lower_bound(
        curved_.begin(), curved_.end(), std::pair(a, b),
        [](const side_node& s, const auto& key) { return is_before(s, key.first, key.second); });
    return at != curved_.end() && at->a == a && at->b == b ? &*at : nullptr;
  }
  net nodes_of(const triangle& t) const {
    net nodes;
    for (std::size_t i = 0; i < 3; ++i) {
      const vertex_index p = t[i], q = t[(i + 1) % 3];
      const side_node* const node = find(p, q);
      nodes[i] = m_.sites[p].position;
      nodes[3 + i] =
          node != nullptr ? node->at : middle_of_side(m_.sites[p].position, m_.sites[q].position);
    }
    return nodes;
  }

 private:
  const mesh& m_;
  const std::vector<side_node>& curved_;
};

// Judges whether nodes are on the curves whose chords are segments of the domain.
class curve_finder {
 public:
  explicit curve_finder(const domain& shape) : shape_(shape) {
    for (const domain_curve& c : shape.curves) {
      if (!is_usable(c)) continue;
      for (std::size_t i = 0; i + 1 < c.vertices.size(); ++i)
        chords_[std::minmax(c.vertices[i], c.vertices[i + 1])] = {&c, i};
    }
  }

  bool is_on_curve(const boundary_edge& e, const side_node& node, const mesh& m) const {
    if (e.segment >= shape_.segments.size()) return false;
    const segment& s = shape_.segments[e.segment];
    const auto found = chords_.find(std::minmax(s.a, s.b));
    if (found == chords_.end()) return false;
    const domain_curve& c = *found->second.curve;
    const curve_measure measure(shape_, c);
    const std::size_t i = found->second.first;
    const auto t = measure.parameter_of(node.at, c.parameters[i], c.parameters[i + 1]);
    const point &p = m.sites[node.a].position, &q = m.sites[node.b].position;
    if (!t || !(measure.is_within(p, node.at, q) || measure.is_within(q, node.at, p))) return false;
    // Bounds the rounding of a place on a curve, as for vertices (curves.cpp).
    constexpr double units_off = 16;
    return measure.distance_to(node.at, *t) <=
           rational(units_off * unit_in_last_place(measure.reach()));
  }

 private:
  struct chord {
    const domain_curve* curve = nullptr;
    std::size_t first = 0;
  };

  bool is_usable(const domain_curve& c) const {
    const auto is_finite = [](const point& p) { return std::isfinite(p.x) && std::isfinite(p.y); };
    return c.vertices.size() >= 2 && c.parameters.size() == c.vertices.size() &&
           is_finite(c.centre) && is_finite(c.control[0]) && is_finite(c.control[1]) &&
           std::all_of(c.vertices.begin(), c.vertices.end(), [&](vertex_index v) {
             return v < shape_.vertices.size() && is_finite(shape_.vertices[v]);
           });
  }

  const domain& shape_;
  std::map<std::pair<vertex_index, vertex_index>, chord> chords_;
};

std::size_t count_on_curves(const mesh& m, const node_finder& nodes, const domain& shape) {
  if (shape.curves.empty()) return 0;
  const curve_finder curves(shape);
  return static_cast<std::size_t>(
      std::count_if(m.boundary.begin(), m.boundary.end(), [&](const boundary_edge& e) {
        const side_node* const node = nodes.find(e.a, e.b);
        return node != nullptr && curves.is_on_curve(e, *node, m);
      }));
}

}  // namespace

second_order_report prove_second_order(const mesh& subject, const std::vector<side_node>& curved,
                                       const domain* shape) {
  second_order_report report;
  report.triangles = subject.triangles.size();
  report.curved_sides = curved.size();
  const node_finder nodes(subject, curved);
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t t = 0; t < subject.triangles.size(); ++t) {
    const jacobian_proof proof = prove(nodes.nodes_of(subject.triangles[t]));
    if (proof.answer == jacobian_answer::positive)
      least = std::min(least, proof.least);
    else
      (proof.answer == jacobian_answer::folds ? report.folded : report.undecided)
          .push_back(static_cast<vertex_index>(t));
  }
  report.least_jacobian = std::isfinite(least) ? least : 0;
  if (shape != nullptr) report.on_curves = count_on_curves(subject, nodes, *shape);
  return report;
}

}  // namespace asterism
