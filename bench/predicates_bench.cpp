// SPDX-License-Identifier: MIT
//
// Measures the time of one predicate for contenders that answer the same questions. A benchmark is
// named predicate/input/contender. An iteration asks every question of its list once. Run it by
// scripts/bench, which interleaves repetitions and reports medians and ratios.
#include <benchmark/benchmark.h>

#include "asterism/kernels/double_kernel.hpp"
#include "asterism/kernels/exact_kernel.hpp"
#include "asterism/kernels/filtered_kernel.hpp"
#include "asterism/kernels/interval_kernel.hpp"
#include "asterism/predicates/in_circle.hpp"
#include "asterism/predicates/orientation.hpp"
#include "batch_bench.hpp"
#include "cgal_rivals.hpp"
#include "contender.hpp"
#include "inputs.hpp"
#include "two_vertices.hpp"

namespace asterism::bench {
using namespace internal;

namespace {

constexpr std::size_t many = 1024, few = 64, fewest = 16;
constexpr std::array timed_classes = {input_class::uniform, input_class::one_ulp,
                                      input_class::degenerate, input_class::grid};

std::string name_of(input_class which) {
  return std::string(input_classes[static_cast<std::size_t>(which)].name);
}

// Registers ask(kernel, question) for every kernel, with fewer questions where exact arithmetic
// takes long.
template <class Question, class Ask>
void add_kernels(const std::string& name, const lazy<std::vector<Question>>& questions, Ask ask,
                 std::size_t asked_exactly = 0) {
  const auto on = [ask](const auto& kernel) {
    return [ask, kernel](const Question& q) { return to_number(ask(kernel, q)); };
  };
  add_contender(name + "/double", questions, on(double_kernel()));
  add_contender(name + "/filtered", questions, on(filtered_kernel()));
  add_contender(name + "/interval", questions, on(interval_kernel()));
  add_contender(name + "/exact", questions, on(exact_kernel()), asked_exactly);
}

// Returns the list with every question converted by `convert(question)`.
template <class Question, class Convert>
auto converted(const lazy<std::vector<Question>>& questions, Convert convert) {
  using list = std::vector<decltype(convert(std::declval<const Question&>()))>;
  return lazy<list>([=] {
    list all;
    for (const Question& q : questions.get()) all.push_back(convert(q));
    return all;
  });
}

void add_point_predicates(input_class which) {
  using list = std::vector<point_question>;
  const lazy<list> bisector([=] { return point_questions(which, border::bisector, many); });
  const lazy<list> wedge([=] { return point_questions(which, border::wedge, many); });
  add_kernels(
      "compare_distance/" + name_of(which), bisector,
      [](const auto& k, const point_question& q) { return k.compare_distance(q.v, q.w, q.q); });
  add_kernels("in_wedge/" + name_of(which), wedge,
              [](const auto& k, const point_question& q) { return k.in_wedge(q.v, q.w, q.q); });
  add_kernels("dominates/" + name_of(which), bisector,
              [](const auto& k, const point_question& q) { return k.dominates(q.v, q.w, q.q); });
}

void add_orientation(input_class which) {
  const std::string name = "orientation/" + name_of(which);
  const lazy<std::vector<line_question>> questions([=] { return line_questions(which, many); });
  add_kernels(name, questions, [](const auto& k, const line_question& q) {
    return k.orientation(q[0], q[1], q[2]);
  });
  add_contender(name + "/double, inlined", questions, [](const line_question& q) {
    return to_number(asterism::internal::orientation(q[0], q[1], q[2]));
  });
  const auto points = converted(questions, [](const line_question& q) {
    return std::array{to_epick(q[0]), to_epick(q[1]), to_epick(q[2])};
  });
  add_contender(name + "/CGAL EPICK", points, [](const auto& q) {
    return static_cast<int>(epick::Orientation_2()(q[0], q[1], q[2]));
  });
}

// With equal metrics an edge test needs at most two orientations and an in-circle test. The
// contender "with orientations" computes these, as a mesh generator on CGAL would.
void add_in_circle(input_class which) {
  const std::string name = "in_circle/" + name_of(which);
  const lazy<std::vector<edge_question>> questions([=] { return circle_questions(which, many); });
  add_kernels(name, questions, [](const auto& k, const edge_question& q) {
    return k.edge_test(q[0], q[1], q[2], q[3]);
  });
  add_contender(name + "/double, in-circle alone, inlined", questions, [](const edge_question& q) {
    const auto& [v, w, x, y] = q;
    return to_number(
        asterism::internal::in_circle(v.metric, v.position, w.position, x.position, y.position));
  });
  const auto points = converted(questions, [](const edge_question& q) {
    return std::array{to_epick(q[0].position), to_epick(q[1].position), to_epick(q[2].position),
                      to_epick(q[3].position)};
  });
  add_contender(name + "/CGAL EPICK, in-circle alone", points, [](const auto& q) {
    return static_cast<int>(epick::Side_of_oriented_circle_2()(q[0], q[1], q[2], q[3]));
  });
  add_contender(name + "/CGAL EPICK, with orientations", points, [](const auto& q) {
    const auto side_x = epick::Orientation_2()(q[0], q[1], q[2]);
    if (side_x == epick::Orientation_2()(q[0], q[1], q[3])) return 1;
    return static_cast<int>(epick::Side_of_oriented_circle_2()(q[0], q[1], q[2], q[3])) * side_x;
  });
}

void add_edge_test(input_class which) {
  const std::string name = "edge_test/" + name_of(which);
  const lazy<std::vector<edge_question>> questions([=] { return edge_questions(which, many); });
  add_kernels(
      name, questions,
      [](const auto& k, const edge_question& q) { return k.edge_test(q[0], q[1], q[2], q[3]); },
      few);
  add_contender(name + "/double, two vertices", questions,
                [](const edge_question& q) { return to_number(edge_test_by_two_vertices(q)); });
}

void add_algebraic_rival() {
  const lazy<std::vector<algebraic_rival>> rivals([] {
    std::vector<algebraic_rival> all;
    for (const edge_question& q : edge_questions(input_class::uniform, fewest)) {
      all.emplace_back(q);
      all.back().solve();
    }
    return all;
  });
  const auto add_part = [&](const std::string& name, auto part) {
    benchmark::RegisterBenchmark(name.c_str(), [rivals, part](benchmark::State& state) {
      for (auto _ : state)
        for (algebraic_rival& r : rivals.get()) benchmark::DoNotOptimize(part(r));
      state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(fewest));
    });
  };
  add_part("edge_test/uniform/CGAL algebraic, solve", [](algebraic_rival& r) { return r.solve(); });
  add_part("edge_test/uniform/CGAL algebraic, solve and signs",
           [](algebraic_rival& r) { return static_cast<int>(r.solve()) + r.signs(); });
}

}  // namespace

}  // namespace asterism::bench

int main(int argc, char** argv) {
  benchmark::Initialize(&argc, argv);
  if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 2;
  for (const asterism::bench::input_class which : asterism::bench::timed_classes) {
    asterism::bench::add_point_predicates(which);
    asterism::bench::add_orientation(which);
    asterism::bench::add_in_circle(which);
    asterism::bench::add_edge_test(which);
  }
  asterism::bench::add_algebraic_rival();
  asterism::bench::add_batches();
  benchmark::RunSpecifiedBenchmarks();
  benchmark::Shutdown();
  return 0;
}
