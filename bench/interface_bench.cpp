// SPDX-License-Identifier: MIT
//
// Measures what the C border costs: the same random questions to the filtered kernel, to the C
// function, and to the C batch; time is given a question. bench/interface_bench.py asks numpy's
// way.
#include <benchmark/benchmark.h>

#include <array>
#include <cstdint>
#include <vector>

#include "asterism/kernels/c_batch.h"
#include "asterism/kernels/filtered_kernel.hpp"

namespace {

using namespace asterism;

constexpr std::size_t count = 1000;

// Draws by splitmix64, in [-1, 1).
double next(std::uint64_t& state) {
  std::uint64_t z = (state += 0x9E3779B97F4A7C15U);
  z = (z ^ (z >> 30)) * 0xBF58476D1CE4E5B9U;
  z = (z ^ (z >> 27)) * 0x94D049BB133111EBU;
  return static_cast<double>((z ^ (z >> 31)) >> 11) * 0x1p-52 - 1;
}

// Sites of a smooth metric, four near each other for each question.
struct questions {
  std::vector<std::array<double, 20>> rows;
  questions() {
    std::uint64_t state = 1;
    for (std::size_t k = 0; k < count; ++k) {
      const double cx = next(state), cy = next(state);
      std::array<double, 20> row;
      for (std::size_t s = 0; s < 4; ++s) {
        const double x = cx + 0.05 * next(state), y = cy + 0.05 * next(state);
        const std::array<double, 5> site = {x, y, 1 + 12 * x * x, 12 * x * y, 1 + 12 * y * y};
        for (std::size_t i = 0; i < 5; ++i) row[5 * s + i] = site[i];
      }
      rows.push_back(row);
    }
  }
  asterism_rows column(std::size_t first) const { return {rows.front().data() + first, 20}; }
};
const questions asked;

site site_of(const double* n) { return {{n[0], n[1]}, {n[2], n[3], n[4]}}; }
point point_of(const double* n) { return {n[0], n[1]}; }

template <class Ask>
void run(benchmark::State& state, const Ask& ask) {
  for (auto _ : state)
    for (const auto& row : asked.rows) benchmark::DoNotOptimize(ask(row.data()));
  state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(count));
}
template <class Ask>
void run_batch(benchmark::State& state, const Ask& ask) {
  std::array<signed char, count> answers;
  for (auto _ : state) {
    if (ask(answers.data()) != ASTERISM_OK) state.SkipWithError("refused");
    benchmark::DoNotOptimize(answers);
  }
  state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(count));
}

void orientation_cpp(benchmark::State& state) {
  const filtered_kernel kernel;
  run(state, [&](const double* n) {
    return to_int(kernel.orientation(point_of(n), point_of(n + 5), point_of(n + 10)));
  });
}
void orientation_c(benchmark::State& state) {
  run(state, [](const double* n) {
    int answer = 0;
    (void)asterism_orientation(n, n + 5, n + 10, &answer);
    return answer;
  });
}
void orientation_batch(benchmark::State& state) {
  run_batch(state, [](signed char* answers) {
    return asterism_orientations(count, asked.column(0), asked.column(5), asked.column(10), answers,
                                 nullptr);
  });
}
void in_circle_cpp(benchmark::State& state) {
  const filtered_kernel kernel;
  run(state, [&](const double* n) {
    return to_int(kernel.in_circle({n[2], n[3], n[4]}, point_of(n), point_of(n + 5),
                                   point_of(n + 10), point_of(n + 15)));
  });
}
void in_circle_c(benchmark::State& state) {
  run(state, [](const double* n) {
    int answer = 0;
    (void)asterism_in_circle(n + 2, n, n + 5, n + 10, n + 15, &answer);
    return answer;
  });
}
void in_circle_batch(benchmark::State& state) {
  run_batch(state, [](signed char* answers) {
    return asterism_in_circles(count, asked.column(2), asked.column(0), asked.column(5),
                               asked.column(10), asked.column(15), answers, nullptr);
  });
}
void compare_distance_cpp(benchmark::State& state) {
  const filtered_kernel kernel;
  run(state, [&](const double* n) {
    return to_int(kernel.compare_distance(site_of(n), site_of(n + 5), point_of(n + 10)));
  });
}
void compare_distance_c(benchmark::State& state) {
  run(state, [](const double* n) {
    int answer = 0;
    (void)asterism_compare_distance(n, n + 5, n + 10, &answer);
    return answer;
  });
}
void compare_distance_batch(benchmark::State& state) {
  run_batch(state, [](signed char* answers) {
    return asterism_compare_distances(count, asked.column(0), asked.column(5), asked.column(10),
                                      answers, nullptr);
  });
}
void edge_test_cpp(benchmark::State& state) {
  const filtered_kernel kernel;
  run(state, [&](const double* n) {
    return kernel.edge_test(site_of(n), site_of(n + 5), site_of(n + 10), site_of(n + 15));
  });
}
void edge_test_c(benchmark::State& state) {
  run(state, [](const double* n) {
    int answer = 0;
    (void)asterism_edge_test(n, n + 5, n + 10, n + 15, &answer);
    return answer;
  });
}
void edge_test_counted(benchmark::State& state) {
  asterism_tier_counts counts = {0, 0, 0};
  run(state, [&counts](const double* n) {
    const std::array<const double*, 4> sites = {n, n + 5, n + 10, n + 15};
    int answer = 0;
    (void)asterism_ask(ASTERISM_EDGE_TEST, sites.data(), &answer, &counts);
    return answer;
  });
}
void edge_test_batch(benchmark::State& state) {
  run_batch(state, [](signed char* answers) {
    return asterism_edge_tests(count, asked.column(0), asked.column(5), asked.column(10),
                               asked.column(15), answers, nullptr);
  });
}

BENCHMARK(orientation_cpp);
BENCHMARK(orientation_c);
BENCHMARK(orientation_batch);
BENCHMARK(in_circle_cpp);
BENCHMARK(in_circle_c);
BENCHMARK(in_circle_batch);
BENCHMARK(compare_distance_cpp);
BENCHMARK(compare_distance_c);
BENCHMARK(compare_distance_batch);
BENCHMARK(edge_test_cpp);
BENCHMARK(edge_test_c);
BENCHMARK(edge_test_counted);
BENCHMARK(edge_test_batch);

}  // namespace

BENCHMARK_MAIN();
