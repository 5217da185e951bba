// SPDX-License-Identifier: MIT
//
// Answers existence questions along an arc in plain doubles, by the same sections as the exact
// kernel. The result is a guess: the double kernel's answer, or a witness to be checked.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>

#include "asterism/kernels/numeric_roots.hpp"
#include "asterism/predicates/encroachment.hpp"
#include "asterism/predicates/insertion_test.hpp"

namespace asterism::internal {

namespace numeric {

// Cut points of the parameter line, with room for every root of every critical function of an
// insertion question: 2 + 1 + 2 of the arc, 4 of each of the fourteen norms.
class cut_list {
 public:
  template <std::size_t Degree>
  void add(const polynomial<double, Degree>& p) {
    root_list roots = real_roots(p);
    for (const double x : roots)
      if (count_ < cuts_.size()) cuts_[count_++] = x;
  }
  template <class Visitor>
  void visit(Visitor&& visit) const {
    for (std::size_t k = 0; k < count_; ++k) visit(cuts_[k]);
  }
  // Calls visit(m) once for each section until it returns true; returns that m, if any.
  template <class Visitor>
  std::optional<double> first_sample(Visitor&& visit) {
    std::sort(cuts_.begin(), cuts_.begin() + static_cast<std::ptrdiff_t>(count_));
    if (count_ == 0) return visit(0.0) ? std::optional(0.0) : std::nullopt;
    const auto beyond = [](double x) { return 1 + std::abs(x); };
    for (std::size_t k = 0; k <= count_; ++k) {
      const double m = k == 0        ? cuts_[0] - beyond(cuts_[0])
                       : k == count_ ? cuts_[k - 1] + beyond(cuts_[k - 1])
                                     : 0.5 * (cuts_[k - 1] + cuts_[k]);
      if (visit(m)) return m;
    }
    return std::nullopt;
  }

 private:
  std::array<double, 72> cuts_;
  std::size_t count_ = 0;
};

enum class cuts { equidistance_only, all };

inline void add_function(cut_list& list, const visible_arc<double>& arc,
                         const arc_function<double>& f) {
  const auto norm = arc.norm(f);
  if (vanishes(norm).value()) {
    list.add(arc.rational_part(f));
    list.add(f.beta);
  } else {
    list.add(norm);
  }
}

inline cut_list critical_cuts(const insertion_question<double>& question, cuts which) {
  const visible_arc<double>& arc = question.arc;
  cut_list list;
  list.add(arc.e);
  list.add(arc.h);
  list.add(arc.a);
  add_function(list, arc, question.at_x.equidistance());
  add_function(list, arc, question.at_y.equidistance());
  if (which == cuts::all) {
    const auto add_other = [&](const arc_function<double>& f) { add_function(list, arc, f); };
    question.at_x.visit_other_critical_functions(add_other);
    question.at_y.visit_other_critical_functions(add_other);
  }
  return list;
}

inline bool is_good_point(const insertion_question<double>& question, double m) {
  const visible_arc<double>& arc = question.arc;
  if (!arc.contains(1.0, m).value()) return false;
  const double weight = arc.h(m) + std::sqrt(arc.e(m));
  const displacement<double> from_v = arc.c * arc.direction(1.0, m);
  return question.at_x.holds(from_v, weight).value() && question.at_y.holds(from_v, weight).value();
}

// Returns a parameter at which the question holds, in doubles.
inline std::optional<double> find_witness(const insertion_question<double>& question) {
  return critical_cuts(question, cuts::all).first_sample([&](double m) {
    return is_good_point(question, m);
  });
}

// Returns the ends of the arc, which contains 0: each a little beyond the true one, or infinite.
struct arc_extent {
  double low = -std::numeric_limits<double>::infinity();
  double high = std::numeric_limits<double>::infinity();
};

inline arc_extent find_extent(const visible_arc<double>& arc) {
  std::array<double, 4> ends;
  std::size_t count = 0;
  const auto insert = [&](double x) {
    std::size_t k = count++;
    for (; k > 0 && ends[k - 1] > x; --k) ends[k] = ends[k - 1];
    ends[k] = x;
  };
  const auto add_roots = [&](const polynomial<double, 2>& p) {
    const auto& [c, b, a] = p.coefficient;
    const double discriminant = b * b - 4 * a * c;
    if (!(discriminant >= 0)) return;
    const double q = -0.5 * (b + std::copysign(std::sqrt(discriminant), b));
    // Treats an end beyond this as infinite: the leading coefficient is then mere rounding error.
    constexpr double far_out = 0x1p12;
    for (const double end : {q / a, c / q})
      if (std::abs(end) < far_out) insert(end);
  };
  add_roots(arc.e);
  add_roots(arc.a);
  constexpr double beyond = 1 + 0x1p-5;
  arc_extent extent;
  for (std::size_t k = 0; k < count; ++k)
    if (ends[k] > 0 && !arc.contains(1.0, ends[k] * beyond).value()) {
      extent.high = ends[k] * beyond;
      break;
    }
  for (std::size_t k = count; k-- > 0;)
    if (ends[k] < 0 && !arc.contains(1.0, ends[k] * beyond).value()) {
      extent.low = ends[k] * beyond;
      break;
    }
  return extent;
}

// Parameters to try first in a search: one in each section of the arc between the equidistance
// cuts, in increasing order, and the first of them, if any, at which the condition holds in
// doubles. The cuts are in any order.
struct search_hints {
  static constexpr std::size_t most = 14;

  std::array<double, most> samples, cuts;
  std::size_t count = 0, cut_count = 0;
  std::optional<double> witness;
  arc_extent extent;
};

inline search_hints find_hints(const insertion_question<double>& question) {
  search_hints hints;
  hints.extent = find_extent(question.arc);
  cut_list found = critical_cuts(question, cuts::equidistance_only);
  found.visit([&](double m) {
    if (hints.cut_count < search_hints::most) hints.cuts[hints.cut_count++] = m;
  });
  found.first_sample([&](double m) {
    if (!question.arc.contains(1.0, m).value()) return false;
    if (hints.count < search_hints::most) hints.samples[hints.count++] = m;
    if (is_good_point(question, m)) hints.witness = m;
    return hints.witness.has_value();
  });
  return hints;
}

inline std::optional<double> find_witness(const encroachment_question<double>& question) {
  cut_list list;
  list.add(question.against_a);
  list.add(question.against_b);
  list.add(polynomial<double, 1>{{0.0, 1.0}});
  return list.first_sample([&](double m) { return question.holds(1.0, m).value(); });
}

}  // namespace numeric

}  // namespace asterism::internal
