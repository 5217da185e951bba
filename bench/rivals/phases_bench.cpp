// SPDX-License-Identifier: MIT
//
//   phases_bench METRIC SIZE [ROUNDS]
//
// Measures the phases of the main job on the square, on one thread and on all of them, by turns:
// refinement (fill, stars, bad-triangle queue, mending), the audit, and bulk building: all stars at
// once from the sites and the boundary of the mesh that came out. Measures refinement also on plain
// doubles. Prints medians as JSON.

#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <exception>
#include <iostream>
#include <map>
#include <memory>
#include <nlohmann/json.hpp>
#include <string>
#include <utility>
#include <vector>

#include "asterism/kernels/double_kernel.hpp"
#include "asterism/kernels/filtered_kernel.hpp"
#include "asterism/mesh/audit/audit.hpp"
#include "asterism/mesh/data/metric_field.hpp"
#include "asterism/mesh/domain/built_in_domains.hpp"
#include "asterism/mesh/metric/make_metric_field.hpp"
#include "asterism/mesh/pipeline/foreign_mesh.hpp"
#include "asterism/mesh/refine/mesh_domain.hpp"
#include "asterism/mesh/stars/boundary.hpp"
#include "asterism/mesh/stars/proximity.hpp"
#include "asterism/mesh/stars/star_oracle.hpp"
#include "asterism/mesh/stars/star_predicates.hpp"
#include "asterism/mesh/stars/star_set.hpp"
#include "asterism/mesh/support/thread_limit.hpp"

namespace asterism::bench {
using namespace internal;
namespace {

using json = nlohmann::ordered_json;

class stopwatch {
 public:
  template <class Work>
  void time(const std::string& what, const Work& work) {
    const auto start = std::chrono::steady_clock::now();
    work();
    const std::chrono::duration<double> taken = std::chrono::steady_clock::now() - start;
    seconds_[what].push_back(taken.count());
  }

  json medians() {
    json all;
    for (auto& [what, seconds] : seconds_) {
      std::sort(seconds.begin(), seconds.end());
      all[what] = seconds[seconds.size() / 2];
    }
    return all;
  }

 private:
  std::map<std::string, std::vector<double>> seconds_;
};

struct job {
  domain shape = square();
  std::unique_ptr<metric_field> field;
  mesh_options options;
};

template <class Kernel>
mesh_outcome refined(const job& j) {
  tier_counters decided;
  auto outcome = mesh_domain({star_predicates_on<Kernel>(decided), j.shape, *j.field, j.options});
  return outcome ? std::move(outcome).value() : mesh_outcome{};
}

bool audited(const job& j, const mesh_outcome& outcome) {
  audit_options options;
  options.angle_bound = j.options.angle_bound;
  options.original = &j.shape;
  for (const exempt_corner& corner : outcome.exempt)
    options.exempt_corners.push_back(corner.vertex);
  return audit(outcome.result, options).certified;
}

std::size_t stars_at_once(const adopted_mesh& adopted) {
  tier_counters decided;
  const star_predicates_on<filtered_kernel> kernel(decided);
  const auto edges = boundary::build(adopted.shape, kernel);
  if (!edges) return 0;
  const proximity near(adopted.subject.sites, edges.value());
  const site_oracle oracle(adopted.subject.sites, edges.value(), kernel, nullptr, &near);
  star_set stars;
  stars.construct_all(oracle);
  return stars.size();
}

// Times all phases on `threads` threads. Returns whether all succeeded. Plain doubles take long and
// run once.
bool round(const job& j, std::size_t threads, bool in_doubles, stopwatch& watch, json& about) {
  const internal::thread_limit limit(threads);
  const std::string suffix = threads == 1 ? ", one thread" : ", all threads";
  mesh_outcome outcome;
  bool good = true;
  watch.time("refinement" + suffix, [&] { outcome = refined<filtered_kernel>(j); });
  watch.time("audit" + suffix, [&] { good = audited(j, outcome); });
  about["triangles"] = outcome.triangles;
  auto adopted = adopt_mesh(std::move(outcome.result));
  if (!adopted) return false;
  watch.time("bulk building" + suffix, [&] { good &= stars_at_once(adopted.value()) > 0; });
  if (in_doubles) watch.time("refinement in doubles" + suffix, [&] { refined<double_kernel>(j); });
  return good;
}

int run(const std::string& metric, double size, int rounds) {
  job j;
  auto field = make_metric_field(metric, j.shape.box(), size);
  if (!field) {
    std::cerr << "phases_bench: " << field.failure().message << '\n';
    return 2;
  }
  j.field = std::move(field).value();
  j.options.limit_size = true;
  j.options.max_sites = 100000000;
  const auto threads = internal::processor_count();
  json about = {{"metric", metric}, {"size", size}, {"rounds", rounds}, {"threads", threads}};
  stopwatch watch;
  bool good = true;
  for (int i = 0; i < rounds; ++i)
    good = round(j, 1, i == 0, watch, about) && round(j, threads, i == 0, watch, about) && good;
  about["certified"] = good;
  about["seconds"] = watch.medians();
  std::cout << about.dump(1) << '\n';
  return good ? 0 : 1;
}

}  // namespace
}  // namespace asterism::bench

int main(int argc, char** argv) try {
  if (argc < 3) {
    std::cerr << "usage: phases_bench METRIC SIZE [ROUNDS]\n";
    return 2;
  }
  const int rounds = argc > 3 ? std::clamp(std::atoi(argv[3]), 1, 100) : 3;
  return asterism::bench::run(argv[1], std::atof(argv[2]), rounds);
} catch (const std::exception& failure) {
  std::cerr << "phases_bench: " << failure.what() << '\n';
  return 1;
}
