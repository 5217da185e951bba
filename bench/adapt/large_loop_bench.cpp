// SPDX-License-Identifier: MIT
//
//   large_loop_bench VERTICES THREADS [meshing]
//
// Measures one turn of the adaptation loop on a mesh of about VERTICES vertices: the metric without
// gradation and with it, the three transfers, and, when asked for, the meshing between. Without
// meshing the next mesh is the same grid, its vertices moved at random with another seed. Prints a
// line of JSON for each: wall and processor seconds, megabytes that were added to what was there,
// at their peak, and a fingerprint of the numbers that came out, which must not depend on the
// threads.
#include <sys/resource.h>

#include <bit>
#include <chrono>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <ctime>
#include <fstream>
#include <iostream>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "asterism/core/elementary.hpp"
#include "asterism/mesh/pipeline/adapt_to_metric.hpp"
#include "asterism/mesh/solution/solution_metric.hpp"
#include "asterism/mesh/support/thread_limit.hpp"
#include "asterism/mesh/transfer/transfer.hpp"

namespace asterism::bench {
namespace {

class fingerprint {
 public:
  void add(std::uint64_t bits) { sum_ = (sum_ ^ bits) * 0x100000001b3U; }
  void add(double x) { add(std::bit_cast<std::uint64_t>(x)); }
  std::string text() const { return std::to_string(sum_); }

 private:
  std::uint64_t sum_ = 0xcbf29ce484222325U;
};

// Returns the kilobytes in a line of /proc/self/status.
double status_of(const std::string& name) {
  std::ifstream in("/proc/self/status");
  for (std::string line; std::getline(in, line);)
    if (line.rfind(name + ":", 0) == 0) return std::strtod(line.c_str() + name.size() + 1, nullptr);
  return 0;
}

double processor_seconds() {
  timespec t{};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &t);
  return static_cast<double>(t.tv_sec) + 1e-9 * static_cast<double>(t.tv_nsec);
}

// Runs the work, which returns a fingerprint, and prints time and memory.
template <class Work>
void measure(const std::string& what, std::size_t vertices, int threads, const Work& work) {
  std::ofstream("/proc/self/clear_refs") << "5";  // resets the peak
  const double before = status_of("VmRSS"), spent = processor_seconds();
  const auto start = std::chrono::steady_clock::now();
  const std::string print = work();
  const std::chrono::duration<double> wall = std::chrono::steady_clock::now() - start;
  std::cout << nlohmann::ordered_json{{"what", what},
                                      {"vertices", vertices},
                                      {"threads", threads},
                                      {"wall", wall.count()},
                                      {"processor", processor_seconds() - spent},
                                      {"megabytes", (status_of("VmHWM") - before) / 1024},
                                      {"fingerprint", print}}
            << std::endl;
}

// Returns a grid of n by n cells on [-1,1]^2. Its inner vertices are moved by up to a quarter of a
// cell.
mesh shaken_grid(vertex_index n, std::uint64_t seed) {
  mesh m;
  const double h = 2.0 / n;
  const auto noise = [&] {
    seed = seed * 6364136223846793005U + 1442695040888963407U;
    return h / 2 * (static_cast<double>(seed >> 11U) * 0x1p-53 - 0.5);
  };
  for (vertex_index j = 0; j <= n; ++j)
    for (vertex_index i = 0; i <= n; ++i) {
      const bool inside = i > 0 && j > 0 && i < n && j < n;
      const double dx = inside ? noise() : 0, dy = inside ? noise() : 0;
      m.sites.push_back({{i == n ? 1 : -1 + i * h + dx, j == n ? 1 : -1 + j * h + dy}, {1, 0, 1}});
    }
  for (vertex_index j = 0; j < n; ++j)
    for (vertex_index i = 0; i < n; ++i) {
      const vertex_index a = j * (n + 1) + i;
      m.triangles.push_back({a, a + 1, a + n + 2});
      m.triangles.push_back({a, a + n + 2, a + n + 1});
    }
  const auto edge = [&](vertex_index a, vertex_index b, int marker) {
    m.boundary.push_back({a, b, static_cast<vertex_index>(m.boundary.size()), marker});
  };
  const vertex_index row = n + 1;
  for (vertex_index i = 0; i < n; ++i) {
    edge(i, i + 1, 1);
    edge(i * row + n, (i + 1) * row + n, 2);
    edge(n * row + i + 1, n * row + i, 3);
    edge((i + 1) * row, i * row, 4);
  }
  return m;
}

// A front around a circle, with waves on it.
nodal_values field_on(const mesh& m) {
  nodal_values made{"1", {}};
  for (const site& s : m.sites) {
    const double x = s.position.x, y = s.position.y;
    made.values.push_back(std::tanh(20 * (x * x + y * y - 0.5)) + 0.1 * std::sin(10 * x + 3 * y));
  }
  return made;
}

void measure_metrics(mesh& m, int threads) {
  const std::vector<nodal_values> fields{field_on(m)};
  for (const bool graded : {false, true})
    measure(graded ? "metric, graded" : "metric", m.sites.size(), threads, [&] {
      solution_metric_options options;
      if (graded) options.gradation = loop_gradation;
      const auto made = make_solution_metric(m, fields, options);
      fingerprint print;
      for (std::size_t v = 0; v < m.sites.size(); ++v) {
        m.sites[v].metric = made.value().tensors[v];
        print.add(m.sites[v].metric.m11);
        print.add(m.sites[v].metric.m12);
        print.add(m.sites[v].metric.m22);
      }
      return print.text();
    });
}

mesh measure_meshing(const mesh& m, int threads) {
  mesh made;
  measure("meshing", m.sites.size(), threads, [&] {
    mesh_adaptation_options options;
    options.refinement.vertices = m.sites.size();
    auto next = adapt_to_metric({m, {}}, options);
    made = std::move(next.value().made.outcome.result);
    fingerprint print;
    for (const site& s : made.sites) {
      print.add(s.position.x);
      print.add(s.position.y);
    }
    return print.text() + (next.value().made.certified() ? ", certified, " : ", not certified, ") +
           std::to_string(made.sites.size());
  });
  return made;
}

void measure_transfers(const mesh& from, const mesh& to, int threads) {
  const solution values{from.sites.size(), {{"1", field_kind::scalar, field_on(from).values}}};
  constexpr const char* names[] = {"interpolate", "project", "bounded"};
  for (const auto how :
       {transfer_method::interpolate, transfer_method::project, transfer_method::bounded})
    measure(names[static_cast<int>(how)], to.sites.size(), threads, [&] {
      const auto made = transfer_solution(from, values, to, how);
      fingerprint print;
      for (const double x : made.value().values.fields[0].values) print.add(x);
      return print.text();
    });
}

int run(int count, char** words) {
  if (count < 3) {
    std::cerr << "large_loop_bench VERTICES THREADS [meshing]\n";
    return 2;
  }
  const double vertices = std::strtod(words[1], nullptr);
  const int threads = std::max(1, std::atoi(words[2]));
  const internal::thread_limit limit(static_cast<std::size_t>(threads));
  const auto n = static_cast<vertex_index>(std::lround(std::sqrt(vertices)) - 1);
  mesh m = shaken_grid(n, 1);
  measure_metrics(m, threads);
  const bool with_meshing = count > 3 && std::string(words[3]) == "meshing";
  const mesh next = with_meshing ? measure_meshing(m, threads) : shaken_grid(n - n / 20, 2);
  measure_transfers(m, next, threads);
  return 0;
}

}  // namespace
}  // namespace asterism::bench

int main(int count, char** words) { return asterism::bench::run(count, words); }
