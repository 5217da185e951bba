// SPDX-License-Identifier: MIT
//
// Has `operator new` fail at one place after another of a run.
#include <atomic>
#include <catch2/catch.hpp>
#include <cstdlib>
#include <limits>
#include <new>

#include "asterism/mesh/mesher.hpp"

namespace {

std::atomic<long> left = std::numeric_limits<long>::max(), used = 0;

void* take(std::size_t size) {
  used.fetch_add(1, std::memory_order_relaxed);
  // Only this allocation fails. Later ones succeed, as after memory was released.
  if (left.fetch_sub(1, std::memory_order_relaxed) == 0) throw std::bad_alloc();
  if (void* const block = std::malloc(size == 0 ? 1 : size)) return block;
  throw std::bad_alloc();
}

}  // namespace

void* operator new(std::size_t size) { return take(size); }
void operator delete(void* block) noexcept { std::free(block); }
void operator delete(void* block, std::size_t) noexcept { std::free(block); }

namespace asterism {
namespace {

enum class run_end { threw, mesh_without_audit, certified };

// Runs the mesher with `allowed` allocations, after which one fails.
run_end run_with(long allowed, const domain& d, const metric_field& field) {
  constexpr long unlimited = std::numeric_limits<long>::max();
  mesh_options options;
  options.limit_size = true;
  options.angle_bound = 20;
  left = allowed;
  try {
    const auto made = make_certified_mesh(d, field, options);
    left = unlimited;
    REQUIRE(made.ok());
    REQUIRE(made.value().outcome.complete);
    if (made.value().certified()) return run_end::certified;
    REQUIRE(made.value().report.findings.size() == 1);
    REQUIRE(made.value().report.findings[0].kind == finding_kind::stopped);
    REQUIRE_FALSE(made.value().claim.certified);
    return run_end::mesh_without_audit;
  } catch (const std::bad_alloc&) {
    left = unlimited;
    return run_end::threw;
  }
}

TEST_CASE("a run without memory throws or is not certified, wherever that shows") {
  const domain d = square();
  const auto field = make_metric_field("swirl:3", d.box(), 0.5);
  REQUIRE(field.ok());
  constexpr long plenty = 1L << 40;
  used = 0;
  REQUIRE(run_with(plenty, d, *field.value()) == run_end::certified);
  const long needed = used;
  constexpr long moments = 200;
  int threw = 0, unaudited = 0;
  const auto fail_at = [&](long allocation) {
    const run_end end = run_with(allocation, d, *field.value());
    threw += end == run_end::threw;
    unaudited += end == run_end::mesh_without_audit;
  };
  for (long k = 0; k < moments; ++k) fail_at(needed * k / moments);
  for (long k = 0; k < moments; ++k) fail_at(needed - 4 * k);
  CHECK(threw > moments / 4);
  CHECK(unaudited > 0);
}

}  // namespace
}  // namespace asterism
