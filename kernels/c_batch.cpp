// SPDX-License-Identifier: MIT
#include "asterism/kernels/c_batch.h"

#include <algorithm>
#include <array>
#include <span>

#include "asterism/kernels/batch.hpp"
#include "asterism/kernels/c_question.hpp"

namespace {

using namespace asterism;
using namespace asterism::internal;

// A batch, stored as one row after another or as columns.
class question_table {
 public:
  question_table(predicate question, std::span<const asterism_rows> arguments)
      : question_(question), arguments_(arguments) {}

  bool has_null() const {
    return std::any_of(arguments_.begin(), arguments_.end(),
                       [](const asterism_rows& rows) { return rows.first == nullptr; });
  }

  batch_record row(std::size_t k) const {
    batch_record record{question_, {}};
    visit_numbers(
        k, [&record](std::size_t column, double number) { record.numbers[column] = number; });
    return record;
  }

  std::span<const asterism_rows> arguments() const { return arguments_; }
  // True if the predicate is in_circle, whose metric must be positive definite. The metric of
  // another predicate may be indefinite: whether it is positive definite may be the question.
  bool asks_of_circles() const { return question_ == predicate::in_circle; }
  // Returns the number of numbers in a row of argument a, by its kind.
  std::size_t width(std::size_t a) const {
    const record_shape shape = shape_of(question_);
    return a < shape.metrics ? 3 : a < shape.metrics + shape.sites ? 5 : 2;
  }

  // Calls visit(column, number) for the numbers of row k.
  template <class Visit>
  void visit_numbers(std::size_t k, Visit&& visit) const {
    std::size_t column = 0;
    for (std::size_t a = 0; a < arguments_.size(); ++a) {
      const double* const from = arguments_[a].first + k * arguments_[a].stride;
      for (std::size_t i = 0; i < width(a); ++i) visit(column++, from[i]);
    }
  }

 private:
  predicate question_;
  std::span<const asterism_rows> arguments_;
};

// Checks a batch in doubles, argument by argument: accepts only records that check_record accepts,
// in any rounding mode and with subnormal numbers switched off.

template <std::size_t Width>
bool all_finite(const asterism_rows& rows, std::size_t count) {
  bool finite = true;
  for (std::size_t k = 0; k < count; ++k)
    for (std::size_t i = 0; i < Width; ++i) finite &= is_finite(rows.first[k * rows.stride + i]);
  return finite;
}

// True if the metrics, at `offset` in each row, are positive definite for certain.
bool all_positive_definite(const asterism_rows& rows, std::size_t offset, std::size_t count) {
  bool positive = true;
  for (std::size_t k = 0; k < count; ++k)
    positive &= is_surely_positive_definite(rows.first + k * rows.stride + offset);
  return positive;
}

// True if the points at the start of the rows differ, row by row.
bool all_apart(const asterism_rows& a, const asterism_rows& b, std::size_t count) {
  bool apart = true;
  for (std::size_t k = 0; k < count; ++k)
    apart &= are_surely_apart(a.first + k * a.stride, b.first + k * b.stride);
  return apart;
}

// True if certainly no row fails the checks.
bool all_sound(const question_table& table, std::size_t count) {
  const std::span<const asterism_rows> arguments = table.arguments();
  const auto is_site = [&](std::size_t a) { return table.width(a) == 5; };
  for (std::size_t a = 0; a < arguments.size(); ++a) {
    const asterism_rows& rows = arguments[a];
    const std::size_t different = rows.stride == 0 ? 1 : count;
    const bool finite = table.width(a) == 2   ? all_finite<2>(rows, different)
                        : table.width(a) == 3 ? all_finite<3>(rows, different)
                                              : all_finite<5>(rows, different);
    if (!finite) return false;
    if (is_site(a) && !all_positive_definite(rows, 2, different)) return false;
    if (table.asks_of_circles() && a == 0 && !all_positive_definite(rows, 0, different))
      return false;
    for (std::size_t b = 0; b < a; ++b)
      if (is_site(a) && is_site(b) && !all_apart(rows, arguments[b], count)) return false;
  }
  return true;
}

// Columns of a range of rows, as batch_kernel takes them.
class column_block {
 public:
  static constexpr std::size_t capacity = 128;

  void fill(const question_table& table, std::size_t first, std::size_t rows) {
    rows_ = rows;
    std::size_t column = 0;
    for (std::size_t a = 0; a < table.arguments().size(); ++a) {
      const std::size_t stride = table.arguments()[a].stride;
      const double* const from = table.arguments()[a].first + first * stride;
      for (std::size_t i = 0; i < table.width(a); ++i, ++column)
        for (std::size_t k = 0; k < rows; ++k) numbers_[column][k] = from[k * stride + i];
    }
  }

  // Ignores the status: every batch has as many rows as the columns.
  bool answer(const batch_kernel& kernel, predicate question, std::span<signed char> to) const {
    switch (question) {
      case predicate::orientation:
        return done(kernel.orientation(points(0), points(2), points(4), to));
      case predicate::in_circle:
        return done(kernel.in_circle({column(0), column(1), column(2)}, points(3), points(5),
                                     points(7), points(9), to));
      case predicate::compare_distance:
        return done(kernel.compare_distance(sites(0), sites(5), points(10), to));
      case predicate::in_wedge:
        return done(kernel.in_wedge(sites(0), sites(5), points(10), to));
      case predicate::dominates:
        return done(kernel.dominates(sites(0), sites(5), points(10), to));
      case predicate::edge_test:
        return done(kernel.edge_test(sites(0), sites(5), sites(10), sites(15), to));
      default:
        return false;
    }
  }

 private:
  static bool done(batch_status status) { return status == batch_status::ok; }
  std::span<const double> column(std::size_t c) const {
    return std::span(numbers_[c]).first(rows_);
  }
  point_columns points(std::size_t c) const { return {column(c), column(c + 1)}; }
  site_columns sites(std::size_t c) const {
    return {column(c), column(c + 1), column(c + 2), column(c + 3), column(c + 4)};
  }

  std::size_t rows_ = 0;
  std::array<std::array<double, capacity>, longest_record> numbers_;
};

void answer_checked(predicate question, const question_table& table, std::size_t count,
                    signed char* answers, tier_counters& counters) {
  const batch_kernel columns(counters);
  const filtered_kernel rows(counters);
  column_block block;
  for (std::size_t first = 0; first < count; first += column_block::capacity) {
    const std::size_t size = std::min(column_block::capacity, count - first);
    block.fill(table, first, size);
    if (block.answer(columns, question, {answers + first, size})) continue;
    for (std::size_t k = first; k < first + size; ++k)
      answers[k] = static_cast<signed char>(ask(rows, table.row(k)).value());
  }
}

asterism_status answer_rows(predicate question, std::span<const asterism_rows> arguments,
                            std::size_t count, signed char* answers,
                            asterism_batch_report* report) noexcept {
  asterism_batch_report found{};
  const asterism_status status = without_exceptions([&] {
    found.failed_row = count;
    const question_table table(question, arguments);
    if (count == 0) return ASTERISM_OK;
    if (answers == nullptr || table.has_null()) return ASTERISM_NULL_POINTER;
    const filtered_kernel checks;  // its own counters: these are no questions
    for (std::size_t k = all_sound(table, count) ? count : 0; k < count; ++k)
      if (const asterism_status bad = check_record(checks, table.row(k)); bad != ASTERISM_OK) {
        found.failed_row = k;
        return bad;
      }
    tier_counters counters;
    answer_checked(question, table, count, answers, counters);
    found.by_semi_static = counters.at(question, tier::semi_static);
    found.by_interval = counters.at(question, tier::interval);
    found.by_exact = counters.at(question, tier::exact);
    return ASTERISM_OK;
  });
  if (report != nullptr) *report = found;
  return status;
}

}  // namespace

asterism_status asterism_orientations(size_t count, asterism_rows p, asterism_rows q,
                                      asterism_rows r, signed char* answers,
                                      asterism_batch_report* report) {
  return answer_rows(predicate::orientation, std::array{p, q, r}, count, answers, report);
}

asterism_status asterism_are_spd(size_t count, asterism_rows metric, signed char* answers,
                                 asterism_batch_report* report) {
  return answer_rows(predicate::is_positive_definite, std::array{metric}, count, answers, report);
}

asterism_status asterism_in_circles(size_t count, asterism_rows metric, asterism_rows a,
                                    asterism_rows b, asterism_rows c, asterism_rows p,
                                    signed char* answers, asterism_batch_report* report) {
  return answer_rows(predicate::in_circle, std::array{metric, a, b, c, p}, count, answers, report);
}

asterism_status asterism_compare_distances(size_t count, asterism_rows v, asterism_rows w,
                                           asterism_rows q, signed char* answers,
                                           asterism_batch_report* report) {
  return answer_rows(predicate::compare_distance, std::array{v, w, q}, count, answers, report);
}

asterism_status asterism_in_wedges(size_t count, asterism_rows v, asterism_rows w, asterism_rows q,
                                   signed char* answers, asterism_batch_report* report) {
  return answer_rows(predicate::in_wedge, std::array{v, w, q}, count, answers, report);
}

asterism_status asterism_dominations(size_t count, asterism_rows v, asterism_rows w,
                                     asterism_rows p, signed char* answers,
                                     asterism_batch_report* report) {
  return answer_rows(predicate::dominates, std::array{v, w, p}, count, answers, report);
}

asterism_status asterism_voronoi_vertex_counts(size_t count, asterism_rows u, asterism_rows v,
                                               asterism_rows w, signed char* answers,
                                               asterism_batch_report* report) {
  return answer_rows(predicate::voronoi_vertex_count, std::array{u, v, w}, count, answers, report);
}

asterism_status asterism_arc_intersection_counts(size_t count, asterism_rows v, asterism_rows w,
                                                 asterism_rows x, signed char* answers,
                                                 asterism_batch_report* report) {
  return answer_rows(predicate::arc_intersection_count, std::array{v, w, x}, count, answers,
                     report);
}

asterism_status asterism_encroachments(size_t count, asterism_rows a, asterism_rows b,
                                       asterism_rows w, signed char* answers,
                                       asterism_batch_report* report) {
  return answer_rows(predicate::encroaches, std::array{a, b, w}, count, answers, report);
}

asterism_status asterism_insertion_tests(size_t count, asterism_rows v, asterism_rows w,
                                         asterism_rows x, asterism_rows y, signed char* answers,
                                         asterism_batch_report* report) {
  return answer_rows(predicate::insertion_test, std::array{v, w, x, y}, count, answers, report);
}

asterism_status asterism_edge_tests(size_t count, asterism_rows v, asterism_rows w, asterism_rows x,
                                    asterism_rows y, signed char* answers,
                                    asterism_batch_report* report) {
  return answer_rows(predicate::edge_test, std::array{v, w, x, y}, count, answers, report);
}
