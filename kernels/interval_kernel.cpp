// SPDX-License-Identifier: MIT
#include "asterism/kernels/interval_kernel.hpp"

#include "asterism/core/floating_point_environment.hpp"
#include "asterism/core/interval.hpp"
#include "asterism/kernels/double_arithmetic.hpp"
#include "asterism/kernels/interval_arc_point.hpp"
#include "asterism/kernels/interval_arithmetic.hpp"
#include "asterism/kernels/magnitude.hpp"
#include "asterism/kernels/predicate_kernel.hpp"
#include "asterism/kernels/proposal.hpp"
#include "asterism/kernels/staged_search.hpp"
#include "asterism/kernels/turn_scale.hpp"
#include "asterism/predicates/arc_intersections.hpp"
#include "asterism/predicates/compare_distance.hpp"
#include "asterism/predicates/domination.hpp"
#include "asterism/predicates/in_circle.hpp"
#include "asterism/predicates/orientation.hpp"
#include "asterism/predicates/positive_definite.hpp"
#include "asterism/predicates/tie_breaking.hpp"
#include "asterism/predicates/voronoi_vertices.hpp"
#include "asterism/predicates/wedge.hpp"

namespace asterism {
using namespace internal;

static_assert(predicate_kernel<interval_kernel>);

namespace {

struct interval_arithmetic {
  template <std::size_t Degree>
  static auto real_roots(const polynomial<interval, Degree>& p) {
    return certified::real_roots(p);
  }
  template <std::size_t Degree>
  static uncertain_sign sign_at(const polynomial<interval, Degree>& p,
                                const certified::enclosed_root& root) {
    return sign_of(evaluate(p, root.box.lambda, root.box.mu));
  }
  // Returns undecided: this is only needed when a norm vanishes identically, which rounding hides.
  template <class... Polynomials>
  static std::optional<std::vector<interval>> samples(const Polynomials&...) {
    return std::nullopt;
  }
  static uncertain_sign function_sign(const visible_arc<interval>&, const arc_function<interval>&,
                                      const interval&) {
    return {};
  }
};

double turn_scale(const site& v) { return std::ldexp(1.0, turn_scale_exponent(v.metric)); }

bool equal_metrics(const site& v, const site& w, const site& x, const site& y) {
  return v.metric == w.metric && v.metric == x.metric && v.metric == y.metric;
}

uncertain_bool equal_metric_answer(const site& v, const site& w, const site& x, const site& y,
                                   bool tie) {
  const auto position = [](const site& s) { return convert<interval>(s.position); };
  return insertion_test_equal_metrics(convert<interval>(v).metric, position(v), position(w),
                                      position(x), position(y),
                                      [tie] { return uncertain_bool(tie); });
}

constexpr int most_ranges = 48;

// Runs `ask` on the scaled input under upward rounding, out of line: the compiler must not move
// arithmetic across the change of the rounding mode.
template <class Answer, class Input, class Ask>
[[gnu::noinline]] Answer ask_out_of_line(const Input& input, const Ask& ask) {
  return ask(input);
}

template <class Answer, std::size_t Sites, std::size_t Points, class Ask>
Answer ask_interval(const std::array<const site*, Sites>& sites,
                    const std::array<const point*, Points>& points, const Ask& ask) {
  const floating_point_scope scope(rounding::upward);
  const scaled_input<Sites, Points> input(sites, points);
  if (!input.usable) return {};
  return ask_out_of_line<Answer>(input, ask);
}

using no_sites = std::array<const site*, 0>;
using no_points = std::array<const point*, 0>;

}  // namespace

uncertain_sign interval_kernel::orientation(const point& p, const point& q, const point& r) const {
  return ask_interval<uncertain_sign>(no_sites{}, std::array{&p, &q, &r}, [](const auto& in) {
    return asterism::internal::orientation(convert<interval>(in.points[0]),
                                           convert<interval>(in.points[1]),
                                           convert<interval>(in.points[2]));
  });
}

uncertain_bool interval_kernel::is_positive_definite(const metric_tensor& metric) const {
  const site carrier{{0, 0}, metric};
  return ask_interval<uncertain_bool>(std::array{&carrier}, no_points{}, [](const auto& in) {
    return asterism::internal::is_positive_definite(convert<interval>(in.sites[0]).metric);
  });
}

uncertain_sign interval_kernel::in_circle(const metric_tensor& m, const point& a, const point& b,
                                          const point& c, const point& p) const {
  const site carrier{a, m};
  return ask_interval<uncertain_sign>(
      std::array{&carrier}, std::array{&b, &c, &p}, [](const auto& in) {
        const auto of = convert<interval>(in.sites[0]);
        return asterism::internal::in_circle(
            of.metric, of.position, convert<interval>(in.points[0]),
            convert<interval>(in.points[1]), convert<interval>(in.points[2]));
      });
}

uncertain_sign interval_kernel::compare_distance(const site& v, const site& w,
                                                 const point& q) const {
  return ask_interval<uncertain_sign>(std::array{&v, &w}, std::array{&q}, [](const auto& in) {
    return asterism::internal::compare_distance(convert<interval>(in.sites[0]),
                                                convert<interval>(in.sites[1]),
                                                convert<interval>(in.points[0]));
  });
}

uncertain_bool interval_kernel::in_wedge(const site& v, const site& w, const point& q) const {
  return ask_interval<uncertain_bool>(std::array{&v, &w}, std::array{&q}, [](const auto& in) {
    return asterism::internal::in_wedge(convert<interval>(in.sites[0]),
                                        convert<interval>(in.sites[1]),
                                        convert<interval>(in.points[0]));
  });
}

uncertain_sign interval_kernel::dominates(const site& v, const site& w, const point& p) const {
  return ask_interval<uncertain_sign>(std::array{&v, &w}, std::array{&p}, [](const auto& in) {
    return asterism::internal::dominates(convert<interval>(in.sites[0]),
                                         convert<interval>(in.sites[1]),
                                         convert<interval>(in.points[0]));
  });
}

uncertain_int interval_kernel::voronoi_vertex_count(const site& u, const site& v,
                                                    const site& w) const {
  return ask_interval<uncertain_int>(std::array{&u, &v, &w}, no_points{}, [](const auto& in) {
    return asterism::internal::voronoi_vertex_count<interval_arithmetic>(
        convert<interval>(in.sites[0]), convert<interval>(in.sites[1]),
        convert<interval>(in.sites[2]));
  });
}

uncertain_int interval_kernel::arc_intersection_count(const site& v, const site& w,
                                                      const site& x) const {
  return ask_interval<uncertain_int>(std::array{&v, &w, &x}, no_points{}, [](const auto& in) {
    const visible_arc<interval> arc(convert<interval>(in.sites[0]), convert<interval>(in.sites[1]),
                                    interval(turn_scale(in.sites[0])));
    return asterism::internal::arc_intersection_count<interval_arithmetic>(
        arc, convert<interval>(in.sites[2]));
  });
}

uncertain_bool interval_kernel::encroaches(const site& a, const site& b, const site& w) const {
  return ask_interval<uncertain_bool>(std::array{&a, &b, &w}, no_points{}, [](const auto& in) {
    const auto& s = in.sites;
    const auto witness = proposal(
        [&] { return numeric::find_witness(encroachment_question<double>(s[0], s[1], s[2])); });
    return certified::exists(
        encroachment_question<interval>(convert<interval>(s[0]), convert<interval>(s[1]),
                                        convert<interval>(s[2])),
        witness);
  });
}

uncertain_bool interval_kernel::insertion_test(const site& v, const site& w, const site& x,
                                               const site& y) const {
  return ask_interval<uncertain_bool>(
      std::array{&v, &w, &x, &y}, no_points{}, [](const auto& in) -> uncertain_bool {
        const auto& s = in.sites;
        if (equal_metrics(s[0], s[1], s[2], s[3]))
          return equal_metric_answer(s[0], s[1], s[2], s[3], false);
        return search_in_stages<interval, interval_arc_point>(s, most_ranges);
      });
}

uncertain_bool interval_kernel::edge_test(const site& v, const site& w, const site& x,
                                          const site& y) const {
  return ask_interval<uncertain_bool>(
      std::array{&v, &w, &x, &y}, no_points{}, [](const auto& in) -> uncertain_bool {
        const auto& s = in.sites;
        if (equal_metrics(s[0], s[1], s[2], s[3]))
          return equal_metric_answer(s[0], s[1], s[2], s[3],
                                     equal_metric_tie_goes_to_edge(s[0].position, s[1].position,
                                                                   s[2].position, s[3].position));
        // Accepts a certain "no", which excludes a tie. At a tie f_v = f_w = f_x = f_y at some
        // point; there no condition certainly fails by domination, and none by containment if good
        // points are near (docs/math/insertion-test.md).
        return search_in_stages<interval, interval_arc_point>(s, most_ranges);
      });
}

}  // namespace asterism
