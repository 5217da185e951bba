// SPDX-License-Identifier: MIT
//
// The guaranteed refinement: whole meshes, certified by the auditor, equal for any number of
// threads. Problems that it cannot solve are named.
#include <bit>
#include <catch2/catch.hpp>
#include <cmath>
#include <cstdint>
#include <numbers>

#include "asterism/core/random.hpp"
#include "asterism/kernels/filtered_kernel.hpp"
#include "asterism/mesh/fill/segment_division.hpp"
#include "asterism/mesh/mesher.hpp"
#include "asterism/mesh/refine/mesh_domain.hpp"
#include "asterism/mesh/support/thread_limit.hpp"
#include "fixtures/domain_kinds.hpp"
#include "fixtures/judged_mesh.hpp"

using namespace asterism;
using namespace asterism::internal;
using namespace asterism::testing;

namespace {

mesh_options with_size(bool limit) {
  mesh_options options;
  options.limit_size = limit;
  return options;
}

mesh_options as_given(mesh_options options) {
  options.metric_tolerance = 0;
  return options;
}

// Lengths across the y axis are five times as short there.
formula_field layer_field() {
  return formula_field([](const point& q) {
    const double h = 0.2 + 0.8 * std::min(1.0, std::abs(q.x));
    return metric_tensor{1 / (h * h), 0, 1};
  });
}

bool same_bits(double a, double b) {
  return std::bit_cast<std::uint64_t>(a) == std::bit_cast<std::uint64_t>(b);
}

bool same(const mesh& a, const mesh& b) {
  const auto same_site = [](const site& s, const site& t) {
    return same_bits(s.position.x, t.position.x) && same_bits(s.position.y, t.position.y) &&
           same_bits(s.metric.m11, t.metric.m11) && same_bits(s.metric.m12, t.metric.m12) &&
           same_bits(s.metric.m22, t.metric.m22);
  };
  return a.triangles == b.triangles &&
         std::equal(a.sites.begin(), a.sites.end(), b.sites.begin(), b.sites.end(), same_site);
}

}  // namespace

TEST_CASE("guaranteed: domains and smooth metrics, with and without a size, are certified") {
  const domain slit = with_dangling_segments(), hole = accepted(square_with_hole()),
               plain = accepted(square());
  for (const domain* d : {&plain, &hole, &slit}) {
    for (const formula_field& f : {identity_field(), swirl_field(3), layer_field()}) {
      make_and_check(*d, f, with_size(false));
      make_and_check(*d, sized(f, 0.25), with_size(true));
    }
    mesh_options modest = with_size(true);
    modest.angle_bound = 15;
    make_and_check(*d, sized(sink_field(3), 0.25), modest);
  }
}

TEST_CASE("guaranteed: the same mesh with one thread and with two") {
  const domain d = with_dangling_segments();
  const formula_field field = sized(swirl_field(3), 0.06);
  const auto made_by = [&](std::size_t threads) {
    const internal::thread_limit limit(threads);
    return mesh_of(d, field, with_size(true));
  };
  const mesh_outcome one = made_by(1), two = made_by(2);
  CHECK(one.sites > 1000);
  CHECK(same(one.result, two.result));
  CHECK(ending_text(one) == ending_text(two));
}

// Vertices on opposite walls are level up to 1e-10 of their distance. Each four of them are nearly
// on one circle, and diagonals are longer than the search from near vertices reaches.
TEST_CASE("guaranteed: a ladder between slanted walls needs no site to be agreed upon") {
  const formula_field linear([](const point& q) {
    const double h = 0.002 + 0.198 * std::fabs(q.y);
    return metric_tensor{25, 0, 1 / (h * h)};
  });
  for (const double lean : {0.0, 1e-16, 1e-10, 1e-4}) {
    domain d;
    add_ring(d, {{-lean, -0.8}, {0.1, -0.8}, {0.1 + lean, 0.8}, {0, 0.8}});
    const mesh_outcome made = mesh_of(accepted(d), linear, with_size(true));
    INFO(lean << ": " << ending_text(made));
    CHECK(made.complete);
    CHECK(made.sites < 120);
  }
}

TEST_CASE(
    "guaranteed: beyond the first pieces at a sharp corner sites come nearer than the floor of "
    "wide domains") {
  for (const double height : {0.9, 0.2, 0.05}) {
    domain d;
    add_ring(d, {{0, 0}, {10, 0}, {10, height}});
    make_and_check(accepted(d), constant_field({4, 0, 4}), with_size(true));
  }
}

TEST_CASE("guaranteed: a steep metric that sites can resolve is not given up") {
  const formula_field shock([](const point& q) {
    const double t = std::tanh((q.y - 0.3 * std::sin(2 * q.x)) / 0.1);
    const double h = 0.25 + 0.75 * t * t;
    return metric_tensor{1, 0, 1 / (h * h)};
  });
  make_and_check(accepted(square()), shock, with_size(true));
}

// Rounding can put the last division at a share of the whole length one ulp below 1, which would
// leave a subsegment of one ulp.
TEST_CASE("guaranteed: dividing a segment leaves no subsegment of a rounding error's length") {
  splitmix64 random(7);
  const formula_field field = sized(swirl_field(5), 0.12);
  for (int i = 0; i < 300; ++i) {
    domain d;
    for (int k = 0; k < 2; ++k) {
      const double x = random.real(-1, 1), y = random.real(-1, 1);
      d.vertices.push_back({x, y});
    }
    d.segments.push_back({0, 1});
    const auto made = divide_segments(d, field, 0.9, 1000);
    REQUIRE(made.ok());
    const division& one = made.value().of_each[0];
    CHECK(one.points.back() == d.vertices[1]);
    for (std::size_t k = 1; one.lengths.size() > 2 && k < one.lengths.size(); ++k)
      CHECK(one.lengths[k] - one.lengths[k - 1] > 0.3);
  }
}

// Sites are offered up to twice as far away as the neighbours before them. The field varies so fast
// that a fifth of the questions need more than one direction of the gap.
TEST_CASE("guaranteed: in a steep field doubles decide nearly every edge test") {
  const formula_field field = sized(swirl_field(24), 0.06);
  const mesh_outcome made = mesh_of(accepted(square()), field, with_size(true));
  CHECK(made.complete);
  const auto by = [&](tier t) {
    return static_cast<double>(made.counters.at(predicate::edge_test, t));
  };
  INFO(by(tier::semi_static) << ", " << by(tier::interval) << ", " << by(tier::exact));
  CHECK(by(tier::semi_static) > 10000);
  CHECK(by(tier::interval) + by(tier::exact) < 0.01 * by(tier::semi_static));
}

// If the two sides at a corner of the square were divided alike, successive quadruples of sites
// there would lie on one circle up to rounding. Exact arithmetic would decide 137 predicates, in a
// third of the run's time.
TEST_CASE("guaranteed: sites on both sides of a symmetric corner are no exact ties") {
  const formula_field field = sized(swirl_field(24), 0.06);
  const mesh_outcome made = mesh_of(accepted(square()), field, with_size(true));
  CHECK(made.complete);
  CHECK(made.counters.at(predicate::edge_test, tier::exact) < 10);
  CHECK(audited(accepted(square()), made, with_size(true))
            .counters.at(predicate::edge_test, tier::exact) < 10);
}

// The sides of a narrow strip must be divided alike, or triangles between them have low angles.
TEST_CASE("guaranteed: parallel sides of a strip are divided at the same places") {
  domain d;
  add_ring(d, {{0, 0}, {4, 1}, {4, 1.01}, {0, 0.01}});
  const auto made = divide_segments(accepted(d), sized(identity_field(), 0.2), 0.9, 1000);
  REQUIRE(made.ok());
  const std::vector<point>&there = made.value().of_each[0].points,
        &back = made.value().of_each[2].points;
  REQUIRE(there.size() == back.size());
  for (std::size_t i = 0; i < there.size(); ++i) {
    const point& opposite = back[there.size() - 1 - i];
    CHECK(there[i].x == Approx(opposite.x).margin(1e-6));
  }
}

// Some gaps have no Voronoi vertex, if the metric varies by a factor along an edge. A search for
// their neighbours must not go on to ever farther sites, each refused by interval arithmetic: that
// takes 100 edge tests a site.
TEST_CASE("guaranteed: stars with gaps that have no vertex are made of near sites") {
  const formula_field field = sized(swirl_field(24), 0.2109);
  const mesh_outcome made = mesh_of(accepted(square()), field, with_size(true));
  CHECK(made.complete);
  const auto by = [&](tier t) { return made.counters.at(predicate::edge_test, t); };
  INFO(made.sites << " sites, " << by(tier::semi_static) << ", " << by(tier::interval));
  CHECK(by(tier::semi_static) < 50 * made.sites);
  CHECK(by(tier::interval) + by(tier::exact) < made.sites / 2);
}

TEST_CASE("guaranteed: jumps of the metric end quickly, with the place named") {
  const formula_field jump([](const point& q) {
    const double s = q.x < 0.1 ? 16 : 1600;
    return metric_tensor{s, 0, 16};
  });
  {
    mesh_options options = as_given(with_size(true));
    options.max_sites = 4000;
    const mesh_outcome made = mesh_of(accepted(square()), jump, options);
    INFO(ending_text(made));
    CHECK_FALSE(made.complete);
    CHECK(made.sites <= options.max_sites);
    const bool named = made.ended.steep || made.how() == ending::site_limit;
    CHECK(named);
  }
}

TEST_CASE("guaranteed: a jump by 1e4 in size ends with the reason") {
  const formula_field jump([](const point& q) {
    const double s = q.x < 0.8 ? 0.01 : 100;
    return metric_tensor{s, 0, s};
  });
  const mesh_outcome made = mesh_of(accepted(square()), jump, as_given(with_size(true)));
  INFO(ending_text(made));
  CHECK_FALSE(made.complete);
  CHECK(made.sites < 12000);
  CHECK(ending_text(made).find("bad triangles are left") != std::string::npos);
}

// In this metric every site is a neighbour of a fixed share of all others, so that a fill without a
// work limit takes minutes.
TEST_CASE("guaranteed: a metric too wild for sites to be spread ends by count, with the place") {
  const formula_field wild = sized(swirl_field(1e8), 10);
  const mesh_outcome one = mesh_of(accepted(square()), wild, as_given(with_size(true)));
  INFO(ending_text(one));
  CHECK_FALSE(one.complete);
  CHECK(one.sites == 4);
  CHECK(one.how() == ending::intolerable);
  CHECK(one.ended.how == ending::crowded);
  CHECK(ending_text(one).find("in the one wanted: the metric varies too fast for sites to be "
                              "spread: of ") != std::string::npos);
  CHECK(one.ended.stars_missing == 0);
}

// A domain 200 units long and 0.0002 high: every site is near most subsegments. The mesh delivered
// has no demands on angles and sizes, and says so.
TEST_CASE("guaranteed: a domain far thinner than its units are apart ends by count") {
  const mesh_outcome made =
      mesh_of(accepted(square()), sized(constant_field({1e8, 0, 1e-4}), 100), with_size(true));
  INFO(ending_text(made));
  CHECK_FALSE(made.complete);
  CHECK(made.sites < 20000);
  CHECK(made.how() == ending::one_metric);
  CHECK_FALSE(made.one_metric->has_demands);
  CHECK(ending_text(made).find("the most work that is done for so many sites") !=
        std::string::npos);
}

TEST_CASE("guaranteed: stars for which no work was left passed for stars that agree") {
  const domain d = accepted(square());
  const formula_field field = swirl_field(12);
  mesh_options options;
  options.keep_if_complete = true;
  tier_counters decided;
  const star_predicates_on<filtered_kernel> stars_on(decided);
  constexpr double no_work = 1e-12;
  const auto made = mesh_domain({stars_on, d, field, options, {}, no_work});
  REQUIRE(made.ok());
  INFO(ending_text(made.value()));
  CHECK(made.value().ended.stars_missing > 0);
  CHECK_FALSE(made.value().complete);
}

TEST_CASE("guaranteed: stars that were never made are counted where a run is stopped") {
  mesh_options options = with_size(true);
  options.stop = [] { return std::optional<std::string>("at once"); };
  const mesh_outcome made = mesh_of(accepted(square()), sized(identity_field(), 0.1), options);
  INFO(ending_text(made));
  CHECK(made.stopped);
  CHECK(made.ended.stars_missing == made.sites);
  CHECK(ending_text(made).find("were never made") != std::string::npos);
}

TEST_CASE("guaranteed: polygons of many short segments, with a size and without") {
  // Polygons: a regular one, whose corners are all on a circle, and a wavy one.
  const auto polygon = [](vertex_index n, double wave) {
    domain d;
    for (vertex_index i = 0; i < n; ++i) {
      const double t = 2 * std::numbers::pi * i / n, r = 1 + wave * std::sin(9 * t);
      d.vertices.push_back({r * std::cos(t), r * std::sin(t)});
      d.segments.push_back({i, (i + 1) % n, 1});
    }
    return accepted(d);
  };
  const auto check = [](const domain& d, bool limit_size, std::size_t most_sites,
                        double questions) {
    mesh_options options = with_size(limit_size);
    options.max_sites = 100000;
    const formula_field coarse([](const point&) { return metric_tensor{400, 0, 400}; });
    const mesh_outcome made = mesh_of(d, coarse, options);
    INFO(ending_text(made));
    CHECK(made.complete);
    CHECK(made.sites < most_sites);
    const auto asked =
        static_cast<double>(made.counters.at(predicate::orientation, tier::semi_static));
    CHECK(asked < questions * static_cast<double>(made.sites));
  };
  // Without sites spread inside first every vertex sees all others, and the number of orientation
  // tests grows with the square of the number of vertices.
  check(polygon(2500, 0), true, 16000, 1000);
  check(polygon(2500, 0.3), true, 12000, 1000);
  check(polygon(2500, 0.3), false, 8000, 5000);
  check(polygon(600, 0), false, 2500, 50000);
}

TEST_CASE(
    "guaranteed: thin metrics, in which edge tests are exact, are not given up for the work") {
  // The square stretched by `aspect` along a rotated axis, and the metric that undoes it.
  for (const double aspect : {1e2, 1e4, 1e6, 1e7})
    for (const double turn : {0.1, 0.7, 1.3}) {
      const double c = std::cos(turn), s = std::sin(turn), thin = 1 / (aspect * aspect);
      domain stretched = square();
      for (point& q : stretched.vertices) {
        const double along = aspect * (c * q.x + s * q.y), across = c * q.y - s * q.x;
        q = {c * along - s * across, s * along + c * across};
      }
      const metric_tensor m{100 * (c * c * thin + s * s), 100 * c * s * (thin - 1),
                            100 * (s * s * thin + c * c)};
      const formula_field undone([&m](const point&) { return m; });
      const mesh_outcome made = mesh_of(accepted(stretched), undone, with_size(true));
      INFO(aspect << ", turned by " << turn << ": " << ending_text(made));
      CHECK(made.complete);
      CHECK(made.sites < 700);
    }
}

TEST_CASE("guaranteed: the limit on sites is kept and named") {
  mesh_options options = with_size(true);
  const domain d = accepted(square());
  const formula_field fine = sized(swirl_field(3), 0.05);
  const auto needed = static_cast<double>(mesh_of(d, fine, options).sites);
  for (const std::size_t most : {4, 5, 100, 500, 1000}) {
    options.max_sites = most;
    const mesh_outcome made = mesh_of(d, fine, options);
    INFO(ending_text(made));
    CHECK_FALSE(made.complete);
    CHECK(made.sites <= most);
    CHECK(ending_text(made).find("limit of " + std::to_string(most)) != std::string::npos);
    if (most < 100) continue;
    // A limit on sites lengthens edges everywhere by one factor, with the angle bound met and all
    // stars in agreement. The run must neither fail where the segments alone need more sites than
    // allowed, nor make fine edges in one part of the domain and coarse ones elsewhere.
    CHECK(made.disagreeing == 0);
    CHECK(made.low_angle == 0);
    CHECK(made.too_large > 0);
    CHECK(made.ended.length_factor > 1);
    CHECK(made.sites > most / 4);
    CHECK(made.ended.sites_wanted == Approx(needed).epsilon(0.2));
    CHECK(made.result.sites[0].metric == fine.at(made.result.sites[0].position).value());
  }
}

TEST_CASE("guaranteed: a size that takes 4e14 triangles ends soon, and says so") {
  mesh_options options = with_size(true);
  options.max_sites = 5000;
  for (const double size : {1e-7, 1e-30, 1e-100}) {
    const mesh_outcome made = mesh_of(accepted(square()), sized(identity_field(), size), options);
    INFO(ending_text(made));
    CHECK_FALSE(made.complete);
    CHECK(made.sites <= options.max_sites);
    CHECK(made.sites > options.max_sites / 4);
    CHECK(made.disagreeing == 0);
    CHECK(made.ended.sites_wanted * size * size == Approx(4.6).epsilon(0.2));
  }
}

TEST_CASE(
    "guaranteed: a run stopped while filling wanted fewer sites than the limit it had reached") {
  mesh_options options = with_size(true);
  options.max_sites = 2000;
  const formula_field fine = sized(swirl_field(100), 1e-3);
  int asked = 0, most = 0;
  std::size_t length_factor = 0;
  options.stop = [&]() -> std::optional<std::string> {
    if (++asked <= most) return std::nullopt;
    return "enough";
  };
  for (most = 0; most < 12; ++most) {
    asked = 0;
    const mesh_outcome made = mesh_of(accepted(square()), fine, options);
    INFO(most << ": " << ending_text(made));
    CHECK(made.stopped);
    if (made.ended.length_factor == 1) continue;
    ++length_factor;
    CHECK((made.ended.sites_wanted == 0 || made.ended.sites_wanted > 2000));
    CHECK((ending_text(made).find("the size wanted takes") == std::string::npos) ==
          (made.ended.sites_wanted == 0));
  }
  CHECK(length_factor > 0);
}

TEST_CASE("guaranteed: far from the origin, sites a millionth apart") {
  domain d;
  add_ring(d, box_ring(1e8, 1e8, 1e8 + 1e-5, 1e8 + 1e-5));
  make_and_check(accepted(d), constant_field({1e12, 0, 1e12}), with_size(true));
}

TEST_CASE("guaranteed: a symmetric grid of given points, every circle through four of them") {
  domain d = square();
  for (int i = -3; i <= 3; ++i)
    for (int j = -3; j <= 3; ++j) d.vertices.push_back({i * 0.25, j * 0.25});
  for (const bool limit : {false, true}) {
    make_and_check(accepted(d), constant_field({16, 0, 16}), with_size(limit));
    make_and_check(accepted(d), constant_field({16, 0, 64}), with_size(limit));
  }
}

TEST_CASE(
    "guaranteed: a vertex beside a segment by less than roundings had tolerances tried down to 0") {
  // (0.3, 0.30000000000000010) is on the segment up to its last bit.
  domain d;
  add_ring(d, box_ring(0, 0, 0.4, 0.4));
  add_chain(d, {{0.4, 0.1}, {0, 0.30000000000000004}});
  d.vertices.push_back({0.30000000000000004, 0.3000000000000001});
  d.vertices.push_back({0.20000000000000004, 0.2});
  const mesh_outcome made = mesh_of(accepted(d), sized(identity_field(), 0.1), with_size(true));
  INFO(ending_text(made));
  CHECK(made.ended.tolerance > 0x1p-70);
  CHECK(made.disagreeing == 0);
  CHECK(made.low_angle <= 1);
}
