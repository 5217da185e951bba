// SPDX-License-Identifier: MIT
#include "asterism/kernels/batch.hpp"

#include <algorithm>
#include <array>
#include <initializer_list>

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

// Runs a batch: first(answers) decides the rows it can; ask(kernel, k) decides each row left.
template <class First, class Ask>
void run(std::span<signed char> answers, predicate which, tier_counters* decided,
         const First& first, const Ask& ask) {
  first(answers.data());
  const filtered_kernel by_row = decided != nullptr ? filtered_kernel(*decided) : filtered_kernel();
  std::size_t left = 0;
  for (std::size_t k = 0; k < answers.size(); ++k) {
    if (answers[k] != batch::undecided) continue;
    answers[k] = static_cast<signed char>(ask(by_row, k));
    ++left;
  }
  if (decided != nullptr) decided->at(which, tier::semi_static) += answers.size() - left;
}

}  // namespace

batch_status batch_kernel::orientation(const point_columns& p, const point_columns& q,
                                       const point_columns& r,
                                       std::span<signed char> answers) const {
  const std::size_t rows = answers.size();
  if (!same_length(rows, p) || !same_length(rows, q) || !same_length(rows, r))
    return batch_status::length_mismatch;
  run(
      answers, predicate::orientation, decided_,
      [&](signed char* first) { batch::orientation(p, q, r, rows, first); },
      [&](const filtered_kernel& kernel, std::size_t k) {
        return to_int(kernel.orientation(row(p, k), row(q, k), row(r, k)));
      });
  return batch_status::ok;
}

batch_status batch_kernel::in_circle(const metric_columns& m, const point_columns& a,
                                     const point_columns& b, const point_columns& c,
                                     const point_columns& p, std::span<signed char> answers) const {
  const std::size_t rows = answers.size();
  if (!same_length(rows, m) || !same_length(rows, a) || !same_length(rows, b) ||
      !same_length(rows, c) || !same_length(rows, p))
    return batch_status::length_mismatch;
  run(
      answers, predicate::in_circle, decided_,
      [&](signed char* first) { batch::in_circle(m, a, b, c, p, rows, first); },
      [&](const filtered_kernel& kernel, std::size_t k) {
        return to_int(kernel.in_circle(row(m, k), row(a, k), row(b, k), row(c, k), row(p, k)));
      });
  return batch_status::ok;
}

batch_status batch_kernel::compare_distance(const site_columns& v, const site_columns& w,
                                            const point_columns& q,
                                            std::span<signed char> answers) const {
  const std::size_t rows = answers.size();
  if (!same_length(rows, v) || !same_length(rows, w) || !same_length(rows, q))
    return batch_status::length_mismatch;
  run(
      answers, predicate::compare_distance, decided_,
      [&](signed char* first) { batch::compare_distance(v, w, q, rows, first); },
      [&](const filtered_kernel& kernel, std::size_t k) {
        return to_int(kernel.compare_distance(row(v, k), row(w, k), row(q, k)));
      });
  return batch_status::ok;
}

batch_status batch_kernel::in_wedge(const site_columns& v, const site_columns& w,
                                    const point_columns& q, std::span<signed char> answers) const {
  const std::size_t rows = answers.size();
  if (!same_length(rows, v) || !same_length(rows, w) || !same_length(rows, q))
    return batch_status::length_mismatch;
  run(
      answers, predicate::in_wedge, decided_,
      [&](signed char* first) { batch::in_wedge(v, w, q, rows, first); },
      [&](const filtered_kernel& kernel, std::size_t k) {
        return kernel.in_wedge(row(v, k), row(w, k), row(q, k));
      });
  return batch_status::ok;
}

batch_status batch_kernel::dominates(const site_columns& v, const site_columns& w,
                                     const point_columns& p, std::span<signed char> answers) const {
  const std::size_t rows = answers.size();
  if (!same_length(rows, v) || !same_length(rows, w) || !same_length(rows, p))
    return batch_status::length_mismatch;
  run(
      answers, predicate::dominates, decided_,
      [&](signed char* first) { batch::dominates(v, w, p, rows, first); },
      [&](const filtered_kernel& kernel, std::size_t k) {
        return to_int(kernel.dominates(row(v, k), row(w, k), row(p, k)));
      });
  return batch_status::ok;
}

batch_status batch_kernel::edge_test(const site_columns& v, const site_columns& w,
                                     const site_columns& x, const site_columns& y,
                                     std::span<signed char> answers) const {
  const std::size_t rows = answers.size();
  if (!same_length(rows, v) || !same_length(rows, w) || !same_length(rows, x) ||
      !same_length(rows, y))
    return batch_status::length_mismatch;
  run(
      answers, predicate::edge_test, decided_,
      [&](signed char* first) { batch::edge_test(v, w, x, y, rows, first); },
      [&](const filtered_kernel& kernel, std::size_t k) {
        return kernel.edge_test(row(v, k), row(w, k), row(x, k), row(y, k));
      });
  return batch_status::ok;
}

}  // namespace asterism
