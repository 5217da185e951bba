// SPDX-License-Identifier: MIT
//
// The main job on three kernels side by side: the square with ten random points in swirl:12, 20
// degrees, as the command does it, without a size and with one that takes some 5000 triangles;
// domains whose symmetry makes ties, or nearly; and a metric so thin that doubles lose most of
// their digits. The mesh each kernel ends with is judged by the auditor, which trusts none of them.
// Rounds alternate between the kernels. JSON on standard output. Argument: rounds (5).
#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdlib>
#include <exception>
#include <iomanip>
#include <iostream>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <sstream>
#include <string>

#include "asterism/kernels/double_kernel.hpp"
#include "asterism/kernels/exact_kernel.hpp"
#include "asterism/kernels/filtered_kernel.hpp"
#include "asterism/mesh/audit/audit.hpp"
#include "asterism/mesh/data/metric_field.hpp"
#include "asterism/mesh/domain/built_in_domains.hpp"
#include "asterism/mesh/domain/check_domain.hpp"
#include "asterism/mesh/metric/make_metric_field.hpp"
#include "asterism/mesh/pipeline/outcome_text.hpp"
#include "asterism/mesh/refine/mesh_domain.hpp"

namespace asterism::bench {
using namespace internal;

namespace {

using json = nlohmann::ordered_json;

struct job {
  std::string name;
  domain shape;
  std::unique_ptr<metric_field> field;
  mesh_options options;
};

// Adds a grid of n x n points inside the square, rotated by `angle`. The corners of each grid
// square are a tie. After rounding, those of a rotated grid are nearly one.
void add_grid(domain& shape, int n, double angle) {
  const double c = std::cos(angle), s = std::sin(angle);
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < n; ++j) {
      const double x = (2.0 * i / (n - 1) - 1) * 0.625, y = (2.0 * j / (n - 1) - 1) * 0.625;
      shape.vertices.push_back({c * x - s * y, s * x + c * y});
    }
}

// Builds the grid in a square that is a million times thinner across, turned, and the metric in
// which it is a square again: of condition number 10^12, in which doubles lose twelve of sixteen
// digits.
constexpr double thinness = 0x1p-20;

point thin(const point& p, double angle) {
  const double c = std::cos(angle), s = std::sin(angle), across = thinness * p.y;
  return {c * p.x - s * across, s * p.x + c * across};
}

std::string thin_metric(double angle) {
  const double c = std::cos(angle), s = std::sin(angle), across = 1 / (thinness * thinness);
  std::ostringstream text;
  text << std::setprecision(17) << "expr:" << c * c + across * s * s << ';' << (1 - across) * c * s
       << ';' << s * s + across * c * c;
  return text.str();
}

struct request {
  std::string name;
  domain given;
  std::string metric;
  std::size_t random_points = 0;
  std::uint64_t seed = 1;
  std::size_t max_sites = 3000;
  std::optional<double> size = std::nullopt;
};

result<job> make_job(const request& asked) {
  const auto checked = check_domain(asked.given);
  if (!checked) return checked.failure();
  auto shape = add_random_points(checked.value(), asked.random_points, asked.seed);
  if (!shape) return shape.failure();
  auto field = make_metric_field(asked.metric, shape.value().box(), asked.size.value_or(1));
  if (!field) return field.failure();
  mesh_options options;
  options.angle_bound = 20;
  options.limit_size = asked.size.has_value();
  options.max_sites = asked.max_sites;
  options.seed = asked.seed;
  return job{asked.name, std::move(shape).value(), std::move(field).value(), options};
}

json judge(const job& j, const mesh_outcome& outcome) {
  audit_options options;
  options.angle_bound = j.options.angle_bound;
  options.original = &j.shape;
  for (const exempt_corner& corner : outcome.exempt)
    options.exempt_corners.push_back(corner.vertex);
  const audit_report report = audit(outcome.result, options);
  json findings = json::object();
  for (std::size_t k = 0; k < finding_kind_count; ++k)
    if (report.found[k] > 0) findings[std::string(finding_kind_names[k])] = report.found[k];
  return {{"complete", outcome.complete},
          {"reason", ending_text(outcome)},
          {"sites", outcome.sites},
          {"triangles", outcome.triangles},
          {"disagreeing", outcome.disagreeing},
          {"certified", report.certified},
          {"findings", findings}};
}

template <class Kernel>
void run(const job& j, json& into) {
  tier_counters decided;
  const auto start = std::chrono::steady_clock::now();
  const auto outcome =
      mesh_domain({star_predicates_on<Kernel>(decided), j.shape, *j.field, j.options});
  const std::chrono::duration<double, std::milli> taken = std::chrono::steady_clock::now() - start;
  into["milliseconds"].push_back(taken.count());
  if (into.contains("outcome")) return;
  if (outcome)
    into["outcome"] = judge(j, outcome.value());
  else
    into["outcome"] = {{"complete", false}, {"reason", outcome.failure().message}};
}

json run_job(const job& j, int rounds) {
  json result = {{"name", j.name}};
  for (int round = 0; round < rounds; ++round) {
    run<double_kernel>(j, result["kernels"]["double"]);
    run<filtered_kernel>(j, result["kernels"]["filtered"]);
    // Runs exact arithmetic once, since it takes long.
    if (round == 0) run<exact_kernel>(j, result["kernels"]["exact"]);
  }
  return result;
}

int run_all(int rounds) {
  json all = json::array();
  bool good = true;
  const auto add = [&](const request& asked) {
    const auto j = make_job(asked);
    good = good && j.ok();
    if (j)
      all.push_back(run_job(j.value(), rounds));
    else
      std::cerr << "whole_run_bench: " << j.failure().message << '\n';
  };
  for (const std::uint64_t seed : {1U, 2U, 3U})
    add({"swirl:12, ten random points, seed " + std::to_string(seed), square(), "swirl:12", 10,
         seed});
  for (const std::uint64_t seed : {1U, 2U})
    add({"swirl:12, size 0.075, ten random points, seed " + std::to_string(seed), square(),
         "swirl:12", 10, seed, 20000, 0.075});
  add({"swirl:12, no point given", square(), "swirl:12"});
  domain grid = square(), turned = square();
  add_grid(grid, 6, 0);
  add_grid(turned, 6, 0.1);
  add({"swirl:12, 6 x 6 grid given", grid, "swirl:12"});
  add({"identity, 6 x 6 grid given", grid, "identity"});
  add({"identity, 6 x 6 grid given, turned by 0.1", turned, "identity"});
  for (const double angle : {0.1, 0.7, 1.2}) {
    domain thinned = grid;
    for (point& p : thinned.vertices) p = thin(p, angle);
    std::ostringstream name;
    name << "6 x 6 grid, 2^20 times thinner and turned by " << angle << ", in its own metric";
    add({name.str(), thinned, thin_metric(angle)});
  }
  std::cout << all.dump(1) << '\n';
  return good && std::cout.good() ? 0 : 1;
}

}  // namespace

}  // namespace asterism::bench

int main(int argc, char** argv) try {
  const int rounds = argc > 1 ? std::clamp(std::atoi(argv[1]), 1, 1000) : 5;
  return asterism::bench::run_all(rounds);
} catch (const std::exception& failure) {
  std::cerr << "whole_run_bench: " << failure.what() << '\n';
  return 1;
}
