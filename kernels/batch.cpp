// SPDX-License-Identifier: MIT
#include "asterism/kernels/batch.hpp"

#include <functional>

#include "asterism/kernels/batch_first_pass.hpp"

namespace asterism {
using namespace internal;

namespace {

bool same_length(std::size_t rows, const point_columns& p) {
  return p.x.size() == rows && p.y.size() == rows;
}

bool same_length(std::size_t rows, const site_columns& s) {
  return same_length(rows, point_columns{s.x, s.y}) && s.m11.size() == rows &&
         s.m12.size() == rows && s.m22.size() == rows;
}

bool same_length(std::size_t rows, const metric_columns& m) {
  return m.m11.size() == rows && m.m12.size() == rows && m.m22.size() == rows;
}

metric_tensor row(const metric_columns& m, std::size_t k) { return {m.m11[k], m.m12[k], m.m22[k]}; }

site row(const site_columns& s, std::size_t k) {
  return {{s.x[k], s.y[k]}, {s.m11[k], s.m12[k], s.m22[k]}};
}

point row(const point_columns& p, std::size_t k) { return {p.x[k], p.y[k]}; }

signed char number_of(sign s) { return static_cast<signed char>(to_int(s)); }
signed char number_of(bool answer) { return static_cast<signed char>(answer); }

// Runs a batch: first(columns..., rows, answers) decides the rows it can; ask(kernel, arguments...)
// decides each row that is undecided after that.
template <class First, class Ask, class... Columns>
batch_status run(std::span<signed char> answers, predicate which, tier_counters* decided,
                 const First& first, const Ask& ask, const Columns&... columns) {
  if (!(same_length(answers.size(), columns) && ...)) return batch_status::length_mismatch;
  first(columns..., answers.size(), answers.data());
  const filtered_kernel by_row = decided != nullptr ? filtered_kernel(*decided) : filtered_kernel();
  std::size_t left = 0;
  for (std::size_t k = 0; k < answers.size(); ++k) {
    if (answers[k] != batch::undecided) continue;
    answers[k] = number_of(std::invoke(ask, by_row, row(columns, k)...));
    ++left;
  }
  if (decided != nullptr) decided->at(which, tier::semi_static) += answers.size() - left;
  return batch_status::ok;
}

}  // namespace

batch_status batch_kernel::orientation(const point_columns& p, const point_columns& q,
                                       const point_columns& r,
                                       std::span<signed char> answers) const {
  return run(answers, predicate::orientation, decided_, batch::orientation,
             &filtered_kernel::orientation, p, q, r);
}

batch_status batch_kernel::in_circle(const metric_columns& m, const point_columns& a,
                                     const point_columns& b, const point_columns& c,
                                     const point_columns& p, std::span<signed char> answers) const {
  return run(
      answers, predicate::in_circle, decided_, batch::in_circle,
      [](const filtered_kernel& kernel, const auto&... at) { return kernel.in_circle(at...); }, m,
      a, b, c, p);
}

batch_status batch_kernel::compare_distance(const site_columns& v, const site_columns& w,
                                            const point_columns& q,
                                            std::span<signed char> answers) const {
  return run(answers, predicate::compare_distance, decided_, batch::compare_distance,
             &filtered_kernel::compare_distance, v, w, q);
}

batch_status batch_kernel::in_wedge(const site_columns& v, const site_columns& w,
                                    const point_columns& q, std::span<signed char> answers) const {
  return run(answers, predicate::in_wedge, decided_, batch::in_wedge, &filtered_kernel::in_wedge, v,
             w, q);
}

batch_status batch_kernel::dominates(const site_columns& v, const site_columns& w,
                                     const point_columns& p, std::span<signed char> answers) const {
  return run(answers, predicate::dominates, decided_, batch::dominates, &filtered_kernel::dominates,
             v, w, p);
}

batch_status batch_kernel::edge_test(const site_columns& v, const site_columns& w,
                                     const site_columns& x, const site_columns& y,
                                     std::span<signed char> answers) const {
  return run(answers, predicate::edge_test, decided_, batch::edge_test, &filtered_kernel::edge_test,
             v, w, x, y);
}

}  // namespace asterism
