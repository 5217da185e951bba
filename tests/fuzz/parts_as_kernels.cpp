// SPDX-License-Identifier: MIT
#include "parts_as_kernels.hpp"

#include <array>

#include "asterism/kernels/batch.hpp"
#include "asterism/kernels/fixed_width.hpp"
#include "asterism/kernels/star_gap.hpp"

namespace asterism::fuzz {
using namespace internal;

namespace {

bool equal_metrics(const site& v, const site& w, const site& x, const site& y) {
  return identical(v.metric, w.metric) && identical(v.metric, x.metric) &&
         identical(v.metric, y.metric);
}

template <std::size_t Rows>
struct site_table {
  std::array<double, Rows> x, y, m11, m12, m22;
  explicit site_table(const site& s) {
    x.fill(s.position.x);
    y.fill(s.position.y);
    m11.fill(s.metric.m11);
    m12.fill(s.metric.m12);
    m22.fill(s.metric.m22);
  }
  site_columns columns() const { return {x, y, m11, m12, m22}; }
};

// Puts the question in every row and returns the last row's answer: that row is not in the first
// lane of a block.
template <std::size_t Rows, auto Question>
int ask_about_point(const site& v, const site& w, const point& q) {
  const site_table<Rows> of_v(v), of_w(w), of_q(site{q, {1, 0, 1}});
  std::array<signed char, Rows> answers{};
  const point_columns points{of_q.x, of_q.y};
  const batch_status status =
      (batch_kernel{}.*Question)(of_v.columns(), of_w.columns(), points, answers);
  return status == batch_status::ok ? answers.back() : 99;
}

template <std::size_t Rows>
bool ask_edge(const site& v, const site& w, const site& x, const site& y) {
  const site_table<Rows> of_v(v), of_w(w), of_x(x), of_y(y);
  std::array<signed char, Rows> answers{};
  const batch_status status = batch_kernel{}.edge_test(of_v.columns(), of_w.columns(),
                                                       of_x.columns(), of_y.columns(), answers);
  return status == batch_status::ok && answers.back() != 0;
}

template <std::size_t Rows>
sign ask_orientation(const point& p, const point& q, const point& r) {
  const site_table<Rows> of_p(site{p, {}}), of_q(site{q, {}}), of_r(site{r, {}});
  std::array<signed char, Rows> answers{};
  const batch_status status =
      batch_kernel{}.orientation({of_p.x, of_p.y}, {of_q.x, of_q.y}, {of_r.x, of_r.y}, answers);
  return to_sign(status == batch_status::ok ? answers.back() : 99);
}

template <std::size_t Rows>
sign ask_in_circle(const metric_tensor& m, const point& a, const point& b, const point& c,
                   const point& p) {
  const site_table<Rows> of_a(site{a, m}), of_b(site{b, m}), of_c(site{c, m}), of_p(site{p, m});
  std::array<signed char, Rows> answers{};
  const batch_status status =
      batch_kernel{}.in_circle({of_a.m11, of_a.m12, of_a.m22}, {of_a.x, of_a.y}, {of_b.x, of_b.y},
                               {of_c.x, of_c.y}, {of_p.x, of_p.y}, answers);
  return to_sign(status == batch_status::ok ? answers.back() : 99);
}

constexpr std::size_t block = 8;

}  // namespace

uncertain_bool gap_of_v_kernel::edge_test(const site& v, const site& w, const site& x,
                                          const site& y) const {
  const uncertain_bool one = star_gap(v, y, x).accepts(w);
  return one.certain() ? one : star_gap(v, x, y).accepts(w);
}

uncertain_bool gap_of_w_kernel::edge_test(const site& v, const site& w, const site& x,
                                          const site& y) const {
  return gap_of_v_kernel().edge_test(w, v, x, y);
}

uncertain_sign fixed_width_kernel::orientation(const point& p, const point& q,
                                               const point& r) const {
  return fixed_width::orientation(p, q, r);
}
uncertain_bool fixed_width_kernel::is_positive_definite(const metric_tensor& metric) const {
  return fixed_width::is_positive_definite(metric);
}
uncertain_sign fixed_width_kernel::compare_distance(const site& v, const site& w,
                                                    const point& q) const {
  return fixed_width::compare_distance(v, w, q);
}
uncertain_bool fixed_width_kernel::in_wedge(const site& v, const site& w, const point& q) const {
  return fixed_width::in_wedge(v, w, q);
}
uncertain_sign fixed_width_kernel::dominates(const site& v, const site& w, const point& p) const {
  return fixed_width::dominates(v, w, p);
}
uncertain_bool fixed_width_kernel::insertion_test(const site& v, const site& w, const site& x,
                                                  const site& y) const {
  return equal_metrics(v, w, x, y) ? fixed_width::insertion_test_equal_metrics(v, w, x, y)
                                   : uncertain_bool();
}
uncertain_bool fixed_width_kernel::edge_test(const site& v, const site& w, const site& x,
                                             const site& y) const {
  return equal_metrics(v, w, x, y) ? fixed_width::edge_test_equal_metrics(v, w, x, y)
                                   : uncertain_bool();
}

uncertain_sign block_of_rows_kernel::compare_distance(const site& v, const site& w,
                                                      const point& q) const {
  return to_sign(ask_about_point<block, &batch_kernel::compare_distance>(v, w, q));
}
uncertain_bool block_of_rows_kernel::in_wedge(const site& v, const site& w, const point& q) const {
  return ask_about_point<block, &batch_kernel::in_wedge>(v, w, q) != 0;
}
uncertain_sign block_of_rows_kernel::dominates(const site& v, const site& w, const point& p) const {
  return to_sign(ask_about_point<block, &batch_kernel::dominates>(v, w, p));
}
uncertain_bool block_of_rows_kernel::edge_test(const site& v, const site& w, const site& x,
                                               const site& y) const {
  return ask_edge<block>(v, w, x, y);
}

uncertain_sign single_row_kernel::compare_distance(const site& v, const site& w,
                                                   const point& q) const {
  return to_sign(ask_about_point<1, &batch_kernel::compare_distance>(v, w, q));
}
uncertain_bool single_row_kernel::in_wedge(const site& v, const site& w, const point& q) const {
  return ask_about_point<1, &batch_kernel::in_wedge>(v, w, q) != 0;
}
uncertain_sign single_row_kernel::dominates(const site& v, const site& w, const point& p) const {
  return to_sign(ask_about_point<1, &batch_kernel::dominates>(v, w, p));
}
uncertain_bool single_row_kernel::edge_test(const site& v, const site& w, const site& x,
                                            const site& y) const {
  return ask_edge<1>(v, w, x, y);
}

uncertain_sign fixed_width_kernel::in_circle(const metric_tensor& m, const point& a, const point& b,
                                             const point& c, const point& p) const {
  return fixed_width::in_circle(m, a, b, c, p);
}
uncertain_sign block_of_rows_kernel::in_circle(const metric_tensor& m, const point& a,
                                               const point& b, const point& c,
                                               const point& p) const {
  return ask_in_circle<block>(m, a, b, c, p);
}
uncertain_sign single_row_kernel::in_circle(const metric_tensor& m, const point& a, const point& b,
                                            const point& c, const point& p) const {
  return ask_in_circle<1>(m, a, b, c, p);
}
uncertain_sign block_of_rows_kernel::orientation(const point& p, const point& q,
                                                 const point& r) const {
  return ask_orientation<block>(p, q, r);
}
uncertain_sign single_row_kernel::orientation(const point& p, const point& q,
                                              const point& r) const {
  return ask_orientation<1>(p, q, r);
}

}  // namespace asterism::fuzz
