// SPDX-License-Identifier: MIT
#include "asterism/kernels/double_kernel.hpp"

#include <vector>

#include "asterism/kernels/double_arithmetic.hpp"
#include "asterism/kernels/predicate_kernel.hpp"
#include "asterism/kernels/turn_scale.hpp"
#include "asterism/predicates/arc_intersections.hpp"
#include "asterism/predicates/compare_distance.hpp"
#include "asterism/predicates/in_circle.hpp"
#include "asterism/predicates/orientation.hpp"
#include "asterism/predicates/positive_definite.hpp"
#include "asterism/predicates/tie_breaking.hpp"
#include "asterism/predicates/wedge.hpp"

namespace asterism {
using namespace internal;

static_assert(predicate_kernel<double_kernel>);

namespace {

struct double_arithmetic {
  template <std::size_t Degree>
  static std::optional<numeric::root_list> real_roots(const polynomial<double, Degree>& p) {
    return numeric::real_roots(p);
  }
  template <std::size_t Degree>
  static uncertain_sign sign_at(const polynomial<double, Degree>& p, double root) {
    return sign_of(p(root));
  }
  template <class... Polynomials>
  static std::optional<std::vector<double>> samples(const Polynomials&... polynomials) {
    numeric::cut_list list;
    (list.add(polynomials), ...);
    std::vector<double> result;
    list.first_sample([&](double m) {
      result.push_back(m);
      return false;
    });
    return result;
  }
  static uncertain_sign function_sign(const visible_arc<double>& arc, const arc_function<double>& f,
                                      double m) {
    return sign_of(arc.rational_part(f)(m) + f.beta(m) * std::sqrt(arc.e(m)));
  }
};

double turn_scale(const site& v) { return std::ldexp(1.0, turn_scale_exponent(v.metric)); }

bool equal_metrics(const site& v, const site& w, const site& x, const site& y) {
  return v.metric == w.metric && v.metric == x.metric && v.metric == y.metric;
}

bool insertion_answer(const site& v, const site& w, const site& x, const site& y, bool tie) {
  if (equal_metrics(v, w, x, y))
    return insertion_test_equal_metrics(v.metric, v.position, w.position, x.position, y.position,
                                        [tie] { return uncertain_bool(tie); })
        .value();
  const insertion_question<double> question(v, w, x, y, turn_scale(v));
  return numeric::find_witness(question).has_value();
}

}  // namespace

sign double_kernel::orientation(const point& p, const point& q, const point& r) const {
  return asterism::internal::orientation(p, q, r).value();
}

bool double_kernel::is_positive_definite(const metric_tensor& metric) const {
  return asterism::internal::is_positive_definite(metric).value();
}

sign double_kernel::in_circle(const metric_tensor& m, const point& a, const point& b,
                              const point& c, const point& p) const {
  return asterism::internal::in_circle(m, a, b, c, p).value();
}

sign double_kernel::compare_distance(const site& v, const site& w, const point& q) const {
  return asterism::internal::compare_distance(v, w, q).value();
}

bool double_kernel::in_wedge(const site& v, const site& w, const point& q) const {
  return asterism::internal::in_wedge(v, w, q).value();
}

sign double_kernel::dominates(const site& v, const site& w, const point& p) const {
  return asterism::internal::dominates(v, w, p).value();
}

int double_kernel::voronoi_vertex_count(const site& u, const site& v, const site& w) const {
  const uncertain_int count = asterism::internal::voronoi_vertex_count<double_arithmetic>(u, v, w);
  return count.certain() ? count.value() : 0;  // no usable direction: only after an overflow
}

int double_kernel::arc_intersection_count(const site& v, const site& w, const site& x) const {
  return asterism::internal::arc_intersection_count<double_arithmetic>(
             visible_arc<double>(v, w, turn_scale(v)), x)
      .value();
}

bool double_kernel::encroaches(const site& a, const site& b, const site& w) const {
  return numeric::find_witness(encroachment_question<double>(a, b, w)).has_value();
}

bool double_kernel::insertion_test(const site& v, const site& w, const site& x,
                                   const site& y) const {
  return insertion_answer(v, w, x, y, false);
}

bool double_kernel::edge_test(const site& v, const site& w, const site& x, const site& y) const {
  // Breaks only ties of equal metrics: whether four bisectors of different metrics meet in a point
  // cannot be decided from rounded numbers.
  return insertion_answer(
      v, w, x, y, equal_metric_tie_goes_to_edge(v.position, w.position, x.position, y.position));
}

}  // namespace asterism
