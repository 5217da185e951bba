// SPDX-License-Identifier: MIT
#include "batch_bench.hpp"

#include <span>
#include <type_traits>

#include "asterism/kernels/batch.hpp"
#include "asterism/kernels/double_kernel.hpp"
#include "asterism/kernels/filtered_kernel.hpp"
#include "contender.hpp"
#include "inputs.hpp"

namespace asterism::bench {

namespace {

constexpr std::size_t rows = 8, batches = 128;

struct site_table {
  std::array<std::array<double, rows>, 5> column;
  void set(std::size_t k, const site& s) {
    const std::array<double, 5> values = {s.position.x, s.position.y, s.metric.m11, s.metric.m12,
                                          s.metric.m22};
    for (std::size_t c = 0; c < values.size(); ++c) column[c][k] = values[c];
  }
  site_columns view() const { return {column[0], column[1], column[2], column[3], column[4]}; }
};

struct point_batch {
  site_table v, w;
  std::array<double, rows> x, y;
  point_columns q() const { return {x, y}; }
};
using edge_batch = std::array<site_table, 4>;

point_batch to_batch(std::span<const point_question> questions) {
  point_batch batch{};
  for (std::size_t k = 0; k < rows; ++k) {
    batch.v.set(k, questions[k].v);
    batch.w.set(k, questions[k].w);
    batch.x[k] = questions[k].q.x;
    batch.y[k] = questions[k].q.y;
  }
  return batch;
}

edge_batch to_batch(std::span<const edge_question> questions) {
  edge_batch batch{};
  for (std::size_t k = 0; k < rows; ++k)
    for (std::size_t role = 0; role < 4; ++role) batch[role].set(k, questions[k][role]);
  return batch;
}

// A contender that puts its rows as one batch. Time is per row.
template <class Question, class Ask>
void add_batch_contender(const std::string& name, const lazy<std::vector<Question>>& questions,
                         Ask ask) {
  using batch = decltype(to_batch(std::span<const Question>{}));
  const lazy<std::vector<batch>> tables([=] {
    std::vector<batch> all;
    const std::span<const Question> list = questions.get();
    for (std::size_t k = 0; k < batches; ++k) all.push_back(to_batch(list.subspan(k * rows, rows)));
    return all;
  });
  benchmark::RegisterBenchmark(name.c_str(), [=](benchmark::State& state) {
    const batch_kernel kernel;
    std::array<signed char, rows> answers{};
    for (auto _ : state)
      for (const batch& b : tables.get()) {
        if (ask(kernel, b, std::span<signed char>(answers)) != batch_status::ok)
          state.SkipWithError("columns differ in length");
        benchmark::DoNotOptimize(answers);
      }
    state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(rows * batches));
  });
}

template <class Question, class Ask, class AskBatch>
void add_row(const std::string& name, const lazy<std::vector<Question>>& questions, Ask ask,
             AskBatch ask_batch) {
  const auto on = [ask](const auto& kernel) {
    return [ask, kernel](const Question& q) { return to_number(ask(kernel, q)); };
  };
  add_contender(name + "/double", questions, on(double_kernel()));
  add_contender(name + "/filtered", questions, on(filtered_kernel()));
  add_batch_contender(name + "/batch of 8", questions, ask_batch);
}

void add_point_rows() {
  const lazy<std::vector<point_question>> questions(
      [] { return point_questions(input_class::uniform, border::bisector, rows * batches); });
  add_row(
      "batch/compare_distance", questions,
      [](const auto& k, const point_question& q) { return k.compare_distance(q.v, q.w, q.q); },
      [](const batch_kernel& k, const point_batch& b, std::span<signed char> answers) {
        return k.compare_distance(b.v.view(), b.w.view(), b.q(), answers);
      });
  add_row(
      "batch/in_wedge", questions,
      [](const auto& k, const point_question& q) { return k.in_wedge(q.v, q.w, q.q); },
      [](const batch_kernel& k, const point_batch& b, std::span<signed char> answers) {
        return k.in_wedge(b.v.view(), b.w.view(), b.q(), answers);
      });
  add_row(
      "batch/dominates", questions,
      [](const auto& k, const point_question& q) { return k.dominates(q.v, q.w, q.q); },
      [](const batch_kernel& k, const point_batch& b, std::span<signed char> answers) {
        return k.dominates(b.v.view(), b.w.view(), b.q(), answers);
      });
}

void add_edge_row(const std::string& name, const lazy<std::vector<edge_question>>& questions) {
  add_row(
      name, questions,
      [](const auto& k, const edge_question& q) { return k.edge_test(q[0], q[1], q[2], q[3]); },
      [](const batch_kernel& k, const edge_batch& b, std::span<signed char> answers) {
        return k.edge_test(b[0].view(), b[1].view(), b[2].view(), b[3].view(), answers);
      });
}

}  // namespace

void add_batches() {
  add_point_rows();
  using list = std::vector<edge_question>;
  add_edge_row("batch/edge_test, equal metrics",
               lazy<list>([] { return circle_questions(input_class::uniform, rows * batches); }));
  add_edge_row("batch/edge_test, smooth metrics",
               lazy<list>([] { return edge_questions(input_class::uniform, rows * batches); }));
}

}  // namespace asterism::bench
