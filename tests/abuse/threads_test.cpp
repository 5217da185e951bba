// SPDX-License-Identifier: MIT
//
// Eight threads put the same questions at the same time, to the C functions and to shared kernels.
// All answers equal those of one thread, and the counts of each thread's own kernels add up.
#include <array>
#include <catch2/catch.hpp>
#include <thread>
#include <vector>

#include "asterism/challenge/input_classes.hpp"
#include "asterism/kernels/c_api.h"
#include "asterism/kernels/exact_kernel.hpp"
#include "asterism/kernels/filtered_kernel.hpp"
#include "asterism/kernels/interval_kernel.hpp"

namespace asterism::abuse {
using namespace challenge;
namespace {

constexpr int threads = 8;
constexpr int undecided = 99;

struct answers {
  std::vector<int> filtered, exact, interval, by_c_api;
  friend bool operator==(const answers&, const answers&) = default;
};

std::vector<batch_record> draw_records(int of_each) {
  std::vector<batch_record> records;
  random_source random(8);
  for (const input_class& from : input_classes())
    for (std::size_t p = 0; p < predicate_count; ++p)
      for (int i = 0; i < of_each; ++i)
        records.push_back(draw_record(from, static_cast<predicate>(p), random));
  return records;
}

answers ask_all(const std::vector<batch_record>& records, const filtered_kernel& filtered,
                const exact_kernel& exact, const interval_kernel& interval) {
  answers result;
  for (const batch_record& r : records) {
    result.filtered.push_back(ask(filtered, r).value());
    result.exact.push_back(ask(exact, r).value());
    const uncertain_int enclosed = ask(interval, r);
    result.interval.push_back(enclosed.certain() ? enclosed.value() : undecided);
    if (r.question != predicate::edge_test) continue;
    int answer = undecided;
    const double* const n = r.numbers.data();
    if (asterism_edge_test(n, n + 5, n + 10, n + 15, &answer) != ASTERISM_OK) answer = undecided;
    result.by_c_api.push_back(answer);
  }
  return result;
}

TEST_CASE("eight threads get the answers of one", "[threads]") {
  const auto records = draw_records(3);
  const filtered_kernel filtered;
  const exact_kernel exact;
  const interval_kernel interval;
  const answers alone = ask_all(records, filtered, exact, interval);
  CHECK(alone.filtered == alone.exact);

  std::array<answers, threads> together;
  std::vector<std::thread> running;
  running.reserve(threads);
  for (answers& own : together)
    running.emplace_back([&] { own = ask_all(records, filtered, exact, interval); });
  for (std::thread& t : running) t.join();
  for (const answers& own : together) CHECK(own == alone);
}

TEST_CASE("what threads count apart adds up to what one counts", "[threads]") {
  const auto records = draw_records(1);
  const auto count = [&](tier_counters& decided, std::size_t first, std::size_t step) {
    const filtered_kernel kernel(decided);
    for (std::size_t i = first; i < records.size(); i += step) (void)ask(kernel, records[i]);
  };
  tier_counters alone, sum;
  count(alone, 0, 1);
  std::array<tier_counters, threads> apart;
  std::vector<std::thread> running;
  running.reserve(threads);
  for (std::size_t i = 0; i < apart.size(); ++i)
    running.emplace_back([&, i] { count(apart[i], i, threads); });
  for (std::thread& t : running) t.join();
  for (const tier_counters& own : apart) sum += own;
  CHECK(sum.decided == alone.decided);
}

}  // namespace
}  // namespace asterism::abuse
