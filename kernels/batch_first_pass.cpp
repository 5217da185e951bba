// SPDX-License-Identifier: MIT
#include "asterism/kernels/batch_first_pass.hpp"

#include <bit>
#include <cstdint>

#include "asterism/kernels/semi_static_filter.hpp"

// Inlines one body into functions that differ in their target, so that every instruction set runs
// the same code.
#define ASTERISM_INLINE [[gnu::always_inline]] inline

#if defined(__x86_64__) && defined(__GNUC__)
#define ASTERISM_HAS_VECTOR_TARGETS 1
#else
#define ASTERISM_HAS_VECTOR_TARGETS 0
#endif

namespace asterism::internal::batch {

namespace {

using semi_static::bound_factor;
using vector = displacement<double>;

// Number of 64 bits that holds one answer of the semi-static tier's decide(): a vector of
// comparisons has the width of what was compared.
using number = std::int64_t;

struct verdict {
  number positive, negative;  // 1 when certain
};

ASTERISM_INLINE verdict decide(double value, double magnitude, double factor) {
  const double bound = factor * magnitude + semi_static::smallest_decided;
  return {value > bound, value < -bound};
}

ASTERISM_INLINE double absolute(double x) { return std::abs(x); }

// Repeats the helpers of core/ and of the semi-static tier, for the compiler must inline them.
ASTERISM_INLINE double length(const metric_tensor& m, const vector& u) {
  const double mixed = m.m12 * (u.x * u.y);
  return m.m11 * (u.x * u.x) + m.m22 * (u.y * u.y) + (mixed + mixed);
}
ASTERISM_INLINE double length_magnitude(const metric_tensor& m, const vector& u) {
  return 2 * (m.m11 * (u.x * u.x) + m.m22 * (u.y * u.y));
}
ASTERISM_INLINE number harmless(const metric_tensor& m) {
  return m.m11 + m.m22 <= semi_static::largest_operand;
}
ASTERISM_INLINE number harmless(const vector& u) {
  return u.x * u.x + u.y * u.y <= semi_static::largest_operand * semi_static::largest_operand;
}
ASTERISM_INLINE vector to(const point& a, const point& b) { return {b.x - a.x, b.y - a.y}; }

ASTERISM_INLINE site row(const site_columns& s, std::size_t k) {
  return {{s.x[k], s.y[k]}, {s.m11[k], s.m12[k], s.m22[k]}};
}
ASTERISM_INLINE metric_tensor row(const metric_columns& m, std::size_t k) {
  return {m.m11[k], m.m12[k], m.m22[k]};
}
ASTERISM_INLINE point row(const point_columns& p, std::size_t k) { return {p.x[k], p.y[k]}; }

// Returns 1, -1, or undecided; `usable` is 0 where the bound does not hold.
ASTERISM_INLINE number sign_answer(const verdict& s, number usable) {
  return undecided - usable * (s.positive + 3 * s.negative);
}
// Returns 1, 0, or undecided.
ASTERISM_INLINE number truth_answer(number yes, number no, number usable) {
  return undecided - usable * (yes + 2 * no);
}

ASTERISM_INLINE number compare_distance_row(const site& v, const site& w, const point& q) {
  const vector from_v = to(v.position, q), from_w = to(w.position, q);
  const number usable =
      harmless(v.metric) & harmless(w.metric) & harmless(from_v) & harmless(from_w);
  return sign_answer(decide(length(v.metric, from_v) - length(w.metric, from_w),
                            length_magnitude(v.metric, from_v) + length_magnitude(w.metric, from_w),
                            bound_factor(semi_static::compare_distance_depth)),
                     usable);
}

// Returns u^T M d, and a bound on the sum of its absolute monomials.
struct bounded {
  double value, magnitude;
};
ASTERISM_INLINE bounded inner_product(const metric_tensor& m, const vector& u, const vector& d) {
  return {u.x * (m.m11 * d.x + m.m12 * d.y) + u.y * (m.m12 * d.x + m.m22 * d.y),
          (absolute(u.x) + absolute(u.y)) * ((absolute(d.x) + absolute(d.y)) * (m.m11 + m.m22))};
}
ASTERISM_INLINE verdict wedge(const metric_tensor& m, const vector& u, const vector& d) {
  const bounded b = inner_product(m, u, d);
  return decide(b.value, b.magnitude, bound_factor(semi_static::wedge_depth));
}

ASTERISM_INLINE number in_wedge_row(const site& v, const site& w, const point& q) {
  const vector d = to(v.position, w.position), from_v = to(v.position, q),
               from_w = to(w.position, q);
  const number usable =
      harmless(v.metric) & harmless(w.metric) & harmless(from_v) & harmless(from_w) & harmless(d);
  const verdict at_v = wedge(v.metric, from_v, d), at_w = wedge(w.metric, from_w, {-d.x, -d.y});
  return truth_answer(at_v.positive & at_w.positive, at_v.negative | at_w.negative, usable);
}

ASTERISM_INLINE double choose(number first, double a, double b) { return first != 0 ? a : b; }
ASTERISM_INLINE metric_tensor choose(number first, const metric_tensor& a, const metric_tensor& b) {
  return {choose(first, a.m11, b.m11), choose(first, a.m12, b.m12), choose(first, a.m22, b.m22)};
}

ASTERISM_INLINE number dominates_row(const site& v, const site& w, const point& p) {
  const vector d = to(v.position, w.position), from_v = to(v.position, p),
               from_w = to(w.position, p);
  const number usable =
      harmless(v.metric) & harmless(w.metric) & harmless(from_v) & harmless(from_w) & harmless(d);
  const double of_v = length(v.metric, from_v), of_w = length(w.metric, from_w);
  const verdict nearer =
      decide(of_v - of_w, length_magnitude(v.metric, from_v) + length_magnitude(w.metric, from_w),
             bound_factor(semi_static::compare_distance_depth));
  // d may be w - v or v - w: squared lengths are the same.
  const metric_tensor near = choose(nearer.negative, v.metric, w.metric),
                      far = choose(nearer.negative, w.metric, v.metric);
  const vector u = {choose(nearer.negative, from_v.x, from_w.x),
                    choose(nearer.negative, from_v.y, from_w.y)};
  const double seen_near = length(near, u), seen_far = length(far, u), apart = length(far, d);
  const double magnitude =
      length_magnitude(near, u) + length_magnitude(far, u) + length_magnitude(far, d);
  const verdict room =
      decide((seen_near - seen_far) + apart, magnitude, bound_factor(semi_static::steepness_depth));
  return sign_answer({nearer.negative & room.positive, nearer.positive & room.positive}, usable);
}

ASTERISM_INLINE bounded cross_product(const vector& a, const vector& b) {
  const double left = a.x * b.y, right = a.y * b.x;
  return {left - right, absolute(left) + absolute(right)};
}

ASTERISM_INLINE number orientation_row(const point& p, const point& q, const point& r) {
  const vector a = to(p, q), b = to(p, r);
  const bounded turn = cross_product(a, b);
  return sign_answer(
      decide(turn.value, turn.magnitude, bound_factor(semi_static::orientation_depth)),
      harmless(a) & harmless(b));
}

ASTERISM_INLINE number in_circle_row(const metric_tensor& m, const point& a, const point& b,
                                     const point& c, const point& p) {
  const vector u = to(p, a), v = to(p, b), w = to(p, c);
  const bounded vw = cross_product(v, w), wu = cross_product(w, u), uv = cross_product(u, v);
  const double value =
      (length(m, u) * vw.value + length(m, v) * wu.value) + length(m, w) * uv.value;
  const double magnitude =
      (length_magnitude(m, u) * vw.magnitude + length_magnitude(m, v) * wu.magnitude) +
      length_magnitude(m, w) * uv.magnitude;
  return sign_answer(decide(value, magnitude, bound_factor(semi_static::in_circle_depth)),
                     harmless(m) & harmless(u) & harmless(v) & harmless(w));
}

// Tests for equality bit for bit, also on processors that flush subnormal numbers.
ASTERISM_INLINE number same_metric(const metric_tensor& a, const metric_tensor& b) {
  const auto difference = [](double x, double y) __attribute__((always_inline)) {
    return std::bit_cast<number>(x) ^ std::bit_cast<number>(y);
  };
  return (difference(a.m11, b.m11) | difference(a.m12, b.m12) | difference(a.m22, b.m22)) == 0;
}

ASTERISM_INLINE number edge_test_row(const site& v, const site& w, const site& x, const site& y) {
  const vector d = to(v.position, w.position), v_to_x = to(v.position, x.position),
               v_to_y = to(v.position, y.position), w_to_x = to(w.position, x.position),
               w_to_y = to(w.position, y.position);
  const number usable = same_metric(v.metric, w.metric) & same_metric(v.metric, x.metric) &
                        same_metric(v.metric, y.metric) & harmless(v.metric) & harmless(d) &
                        harmless(v_to_x) & harmless(v_to_y) & harmless(w_to_x) & harmless(w_to_y);
  const bounded of_x = cross_product(d, v_to_x), of_y = cross_product(d, v_to_y);
  constexpr double factor = bound_factor(semi_static::orientation_depth);
  const verdict side_x = decide(of_x.value, of_x.magnitude, factor),
                side_y = decide(of_y.value, of_y.magnitude, factor);
  const number same = (side_x.positive & side_y.positive) | (side_x.negative & side_y.negative);
  const number apart = (side_x.positive & side_y.negative) | (side_x.negative & side_y.positive);
  // Evaluates the in-circle test by opposite angles (predicates/in_circle.hpp).
  const bounded at_x = inner_product(v.metric, v_to_x, w_to_x),
                at_y = inner_product(v.metric, v_to_y, w_to_y);
  const verdict outside =
      decide(at_x.value * absolute(of_y.value) + at_y.value * absolute(of_x.value),
             at_x.magnitude * of_y.magnitude + at_y.magnitude * of_x.magnitude,
             bound_factor(semi_static::opposite_angles_depth));
  return truth_answer(same | (apart & outside.positive), apart & outside.negative, usable);
}

// Processes blocks of rows, as many at once as the instruction set allows. Within a block every
// number has 64 bits, or compilers would fill a vector with answers of 8 bits and ask for 32 rows.
// Contraction is off, so every instruction set computes the same numbers.
template <class Row>
ASTERISM_INLINE void loop(std::size_t rows, signed char* answers, const Row& ask) {
  constexpr std::size_t block = 8;
  std::size_t k = 0;
  for (; k + block <= rows; k += block) {
    number wide[block];
    for (std::size_t j = 0; j < block; ++j) wide[j] = ask(k + j);
    for (std::size_t j = 0; j < block; ++j) answers[k + j] = static_cast<signed char>(wide[j]);
  }
  for (; k < rows; ++k) answers[k] = static_cast<signed char>(ask(k));
}

#if ASTERISM_HAS_VECTOR_TARGETS
template <class Row>
[[gnu::target("avx512f,avx512dq,avx512vl")]] void loop_avx512(std::size_t rows,
                                                              signed char* answers,
                                                              const Row& ask) {
  loop(rows, answers, ask);
}
template <class Row>
[[gnu::target("avx2")]] void loop_avx2(std::size_t rows, signed char* answers, const Row& ask) {
  loop(rows, answers, ask);
}
#endif

template <class Row>
void over_rows(std::size_t rows, signed char* answers, const Row& ask) {
#if ASTERISM_HAS_VECTOR_TARGETS
  if (__builtin_cpu_supports("avx512dq") && __builtin_cpu_supports("avx512vl"))
    return loop_avx512(rows, answers, ask);
  if (__builtin_cpu_supports("avx2")) return loop_avx2(rows, answers, ask);
#endif
  loop(rows, answers, ask);
}

struct orientation_rows {
  const point_columns &p, &q, &r;
  [[gnu::always_inline]] number operator()(std::size_t k) const {
    return orientation_row(row(p, k), row(q, k), row(r, k));
  }
};
struct in_circle_rows {
  const metric_columns& m;
  const point_columns &a, &b, &c, &p;
  [[gnu::always_inline]] number operator()(std::size_t k) const {
    return in_circle_row(row(m, k), row(a, k), row(b, k), row(c, k), row(p, k));
  }
};
struct compare_distance_rows {
  const site_columns &v, &w;
  const point_columns& q;
  [[gnu::always_inline]] number operator()(std::size_t k) const {
    return compare_distance_row(row(v, k), row(w, k), row(q, k));
  }
};
struct in_wedge_rows {
  const site_columns &v, &w;
  const point_columns& q;
  [[gnu::always_inline]] number operator()(std::size_t k) const {
    return in_wedge_row(row(v, k), row(w, k), row(q, k));
  }
};
struct dominates_rows {
  const site_columns &v, &w;
  const point_columns& p;
  [[gnu::always_inline]] number operator()(std::size_t k) const {
    return dominates_row(row(v, k), row(w, k), row(p, k));
  }
};
struct edge_test_rows {
  const site_columns &v, &w, &x, &y;
  [[gnu::always_inline]] number operator()(std::size_t k) const {
    return edge_test_row(row(v, k), row(w, k), row(x, k), row(y, k));
  }
};

}  // namespace

void orientation(const point_columns& p, const point_columns& q, const point_columns& r,
                 std::size_t rows, signed char* answers) {
  over_rows(rows, answers, orientation_rows{p, q, r});
}

void in_circle(const metric_columns& m, const point_columns& a, const point_columns& b,
               const point_columns& c, const point_columns& p, std::size_t rows,
               signed char* answers) {
  over_rows(rows, answers, in_circle_rows{m, a, b, c, p});
}

void compare_distance(const site_columns& v, const site_columns& w, const point_columns& q,
                      std::size_t rows, signed char* answers) {
  over_rows(rows, answers, compare_distance_rows{v, w, q});
}

void in_wedge(const site_columns& v, const site_columns& w, const point_columns& q,
              std::size_t rows, signed char* answers) {
  over_rows(rows, answers, in_wedge_rows{v, w, q});
}

void dominates(const site_columns& v, const site_columns& w, const point_columns& p,
               std::size_t rows, signed char* answers) {
  over_rows(rows, answers, dominates_rows{v, w, p});
}

void edge_test(const site_columns& v, const site_columns& w, const site_columns& x,
               const site_columns& y, std::size_t rows, signed char* answers) {
  over_rows(rows, answers, edge_test_rows{v, w, x, y});
}

}  // namespace asterism::internal::batch
