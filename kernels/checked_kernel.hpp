// SPDX-License-Identifier: MIT
//
// Evaluates every question by two kernels, returns the answer of the first, and reports every
// difference with the source text of a test that reproduces it. It tests a new arithmetic inside a
// program that is known to work with another, after CGAL's Filtered_kernel_checker.
//
// First and Second are any classes with the member functions of filtered_kernel, whose answers may
// be `uncertain`; an empty answer agrees with every answer. Second is taken for the reference. Each
// call costs what both kernels cost; reporting costs only where answers differ. Exceptions of the
// report pass through. As thread-safe as the two kernels and the report are.
#pragma once

#include <functional>
#include <ostream>
#include <string>
#include <string_view>
#include <utility>

#include "asterism/core/sign.hpp"
#include "asterism/core/site.hpp"
#include "asterism/kernels/batch_question.hpp"
#include "asterism/kernels/replay.hpp"

namespace asterism {

// A question that the two kernels answer differently; integers as in the batch protocol.
struct kernel_difference {
  batch_record record;
  int first_answer = 0, second_answer = 0;

  // Returns a Catch2 test case that passes if `kernel_type` answers as the second kernel did.
  std::string test(std::string_view kernel_type) const {
    return replay_test(kernel_type, record, second_answer, first_answer);
  }
};

// Function that is called for each difference.
using difference_report = std::function<void(const kernel_difference&)>;

// Returns a report that writes the test case. `kernel_type` is the C++ name of the first kernel's
// class; `out` must outlive the report.
inline difference_report tests_written_to(std::ostream& out, std::string kernel_type) {
  return [&out, type = std::move(kernel_type)](const kernel_difference& difference) {
    out << difference.test(type) << '\n';
  };
}

// Evaluates by First and Second, returns First's answer, and reports where Second differs. Example:
//
//   checked_kernel<my_kernel, exact_kernel> kernel(tests_written_to(std::cerr, "my_kernel"));
//   const bool keep = kernel.edge_test(v, w, x, y);
template <class First, class Second>
class checked_kernel {
 public:
  explicit checked_kernel(difference_report report, First first = {}, Second second = {})
      : report_(std::move(report)), first_(std::move(first)), second_(std::move(second)) {}

  auto orientation(const point& p, const point& q, const point& r) const {
    const auto put = [&](const auto& k) { return k.orientation(p, q, r); };
    return compared(predicate::orientation, put, p, q, r);
  }
  auto is_positive_definite(const metric_tensor& metric) const {
    const auto put = [&](const auto& k) { return k.is_positive_definite(metric); };
    return compared(predicate::is_positive_definite, put, metric);
  }
  auto compare_distance(const site& v, const site& w, const point& q) const {
    const auto put = [&](const auto& k) { return k.compare_distance(v, w, q); };
    return compared(predicate::compare_distance, put, v, w, q);
  }
  auto in_wedge(const site& v, const site& w, const point& q) const {
    const auto put = [&](const auto& k) { return k.in_wedge(v, w, q); };
    return compared(predicate::in_wedge, put, v, w, q);
  }
  auto dominates(const site& v, const site& w, const point& p) const {
    const auto put = [&](const auto& k) { return k.dominates(v, w, p); };
    return compared(predicate::dominates, put, v, w, p);
  }
  auto voronoi_vertex_count(const site& u, const site& v, const site& w) const {
    const auto put = [&](const auto& k) { return k.voronoi_vertex_count(u, v, w); };
    return compared(predicate::voronoi_vertex_count, put, u, v, w);
  }
  auto arc_intersection_count(const site& v, const site& w, const site& x) const {
    const auto put = [&](const auto& k) { return k.arc_intersection_count(v, w, x); };
    return compared(predicate::arc_intersection_count, put, v, w, x);
  }
  auto encroaches(const site& a, const site& b, const site& w) const {
    const auto put = [&](const auto& k) { return k.encroaches(a, b, w); };
    return compared(predicate::encroaches, put, a, b, w);
  }
  auto insertion_test(const site& v, const site& w, const site& x, const site& y) const {
    const auto put = [&](const auto& k) { return k.insertion_test(v, w, x, y); };
    return compared(predicate::insertion_test, put, v, w, x, y);
  }
  auto edge_test(const site& v, const site& w, const site& x, const site& y) const {
    const auto put = [&](const auto& k) { return k.edge_test(v, w, x, y); };
    return compared(predicate::edge_test, put, v, w, x, y);
  }
  auto in_circle(const metric_tensor& m, const point& a, const point& b, const point& c,
                 const point& p) const {
    const auto put = [&](const auto& k) { return k.in_circle(m, a, b, c, p); };
    return compared(predicate::in_circle, put, m, a, b, c, p);
  }

  const First& first() const { return first_; }
  const Second& second() const { return second_; }

 private:
  struct record_writer {
    batch_record& record;
    std::size_t count = 0;

    void add(double number) { record.numbers[count++] = number; }
    void add(const point& p) {
      add(p.x);
      add(p.y);
    }
    void add(const metric_tensor& m) {
      add(m.m11);
      add(m.m12);
      add(m.m22);
    }
    void add(const site& s) {
      add(s.position);
      add(s.metric);
    }
  };

  template <class Put, class... Arguments>
  auto compared(predicate question, const Put& put, const Arguments&... arguments) const {
    const auto answer = put(first_);
    const uncertain_int first = as_integer(answer), second = as_integer(put(second_));
    if (first.certain() && second.certain() && first.value() != second.value()) {
      kernel_difference difference{{question, {}}, first.value(), second.value()};
      record_writer writer{difference.record};
      (writer.add(arguments), ...);
      report_(difference);
    }
    return answer;
  }

  difference_report report_;
  First first_;
  Second second_;
};

}  // namespace asterism
