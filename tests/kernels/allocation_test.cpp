// SPDX-License-Identifier: MIT
//
// The exact tier allocates no memory for the questions that a mesh generator puts: calls of
// operator new and of GMP's allocator are counted. A program of its own, since it replaces operator
// new.
#include <gmp.h>

#include <array>
#include <catch2/catch.hpp>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <new>

#include "asterism/core/dyadic.hpp"
#include "asterism/core/random.hpp"
#include "asterism/kernels/exact_kernel.hpp"
#include "asterism/predicates/compare_distance.hpp"
#include "asterism/predicates/domination.hpp"
#include "asterism/predicates/insertion_test.hpp"
#include "asterism/predicates/orientation.hpp"
#include "asterism/predicates/wedge.hpp"

namespace {

std::uint64_t allocations = 0;

void* counted(std::size_t size) {
  ++allocations;
  if (void* memory = std::malloc(size == 0 ? 1 : size)) return memory;
  throw std::bad_alloc();
}
void* gmp_new(std::size_t size) { return counted(size); }
void* gmp_more(void* memory, std::size_t, std::size_t size) {
  ++allocations;
  return std::realloc(memory, size);
}
void gmp_delete(void* memory, std::size_t) { std::free(memory); }

}  // namespace

void* operator new(std::size_t size) { return counted(size); }
void* operator new[](std::size_t size) { return counted(size); }
void operator delete(void* memory) noexcept { std::free(memory); }
void operator delete[](void* memory) noexcept { std::free(memory); }
void operator delete(void* memory, std::size_t) noexcept { std::free(memory); }
void operator delete[](void* memory, std::size_t) noexcept { std::free(memory); }

using namespace asterism;
using namespace asterism::internal;

namespace {

using sequence = internal::splitmix64;

site swirl_site(double x, double y) {
  return {{x, y}, {1 + 12 * x * x, 12 * x * y, 1 + 12 * y * y}};
}

using four_sites = std::array<site, 4>;

// Draws four sites of a smooth field. v w may be an edge, with x and y on its two sides.
four_sites smooth(sequence& random) {
  const double x = random.real(-1, 1), y = random.real(-1, 1), h = 0.02;
  const auto near = [&](double dx, double dy) {
    return swirl_site(x + h * (dx + 0.2 * random.real(-1, 1)),
                      y + h * (dy + 0.2 * random.real(-1, 1)));
  };
  return {near(0, 0), near(1, 0), near(0.5, -0.9), near(0.5, 0.9)};
}

// Counts the allocations that `ask` makes over many questions.
template <class Ask>
std::uint64_t allocations_of(const Ask& ask) {
  mp_set_memory_functions(gmp_new, gmp_more, gmp_delete);
  sequence random{31};
  std::uint64_t worst = 0;
  for (int round = 0; round < 500; ++round) {
    const four_sites s = smooth(random);
    const std::uint64_t before = allocations;
    ask(s);
    worst = std::max(worst, allocations - before);
  }
  mp_set_memory_functions(nullptr, nullptr, nullptr);
  return worst;
}

int used = 0;  // kept, so that the answers are computed

}  // namespace

TEST_CASE("the counters of this test count", "[allocation]") {
  CHECK(allocations_of([](const four_sites&) { delete new int(used); }) == 1);
  CHECK(allocations_of([](const four_sites&) {
          mpz_t x;
          mpz_init_set_ui(x, 7);
          mpz_clear(x);
        }) >= 1);
}

TEST_CASE("pointwise predicates of the exact tier ask for no memory", "[allocation]") {
  const exact_kernel exact;
  CHECK(allocations_of([&](const four_sites& s) {
          const point& q = s[2].position;
          used += to_int(exact.orientation(s[0].position, s[1].position, q));
          used += static_cast<int>(exact.is_positive_definite(s[0].metric));
          used += to_int(exact.compare_distance(s[0], s[1], q));
          used += static_cast<int>(exact.in_wedge(s[0], s[1], q));
          used += to_int(exact.dominates(s[0], s[1], q));
        }) == 0);
}

// Draws numbers that fit no fixed width.
TEST_CASE("nor do they in numbers of any size", "[allocation]") {
  CHECK(allocations_of([&](const four_sites& s) {
          const auto v = convert<dyadic>(s[0]), w = convert<dyadic>(s[1]);
          const auto q = convert<dyadic>(s[2].position), y = convert<dyadic>(s[3].position);
          used += to_int(orientation(v.position, w.position, q).value());
          used += to_int(compare_distance(v, w, q).value());
          used += static_cast<int>(in_wedge(v, w, q).value());
          used += to_int(dominates(v, w, q).value());
          used += static_cast<int>(
              insertion_test_equal_metrics(v.metric, v.position, w.position, q, y, [] {
                return false;
              }).value());
        }) == 0);
}

TEST_CASE("edge_test of the exact tier asks for no memory on smooth metrics", "[allocation]") {
  const exact_kernel exact;
  CHECK(allocations_of([&](const four_sites& s) {
          used += static_cast<int>(exact.edge_test(s[0], s[1], s[2], s[3]));
          used += static_cast<int>(exact.insertion_test(s[0], s[1], s[2], s[3]));
        }) == 0);
}

TEST_CASE("edge_test of equal metrics asks for no memory, ties included", "[allocation]") {
  const exact_kernel exact;
  CHECK(allocations_of([&](const four_sites& s) {
          const point &v = s[0].position, &w = s[1].position;
          const metric_tensor round{1, 0, 1};
          // The corners of a square, numbered so that v w and x y are its diagonals.
          const point x{v.x - (w.y - v.y), v.y + (w.x - v.x)},
              y{x.x + (w.x - v.x), x.y + (w.y - v.y)};
          used += static_cast<int>(exact.edge_test({v, round}, {y, round}, {w, round}, {x, round}));
          used += static_cast<int>(exact.edge_test({v, s[0].metric}, {w, s[0].metric},
                                                   {x, s[0].metric}, {s[2].position, s[0].metric}));
        }) == 0);
}
