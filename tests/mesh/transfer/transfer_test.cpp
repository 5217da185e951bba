// SPDX-License-Identifier: MIT
//
// Tests transfers: linear fields are kept to rounding, integrals are kept, bounded transfers make
// no new extrema, and no value is read across a gap.
#include "asterism/mesh/transfer/transfer.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <functional>
#include <utility>

#include "asterism/core/random.hpp"
#include "asterism/mesh/support/thread_limit.hpp"
#include "asterism/mesh/transfer/triangle_overlap.hpp"
#include "asterism/tests/mesh/io/sample_mesh.hpp"

using namespace asterism;
using namespace asterism::internal;
using tests::sample_mesh;

namespace {

constexpr std::array methods = {transfer_method::interpolate, transfer_method::project,
                                transfer_method::bounded};

// Returns nx x ny cells on [0,1]^2 with diagonals in one direction, without the cells for which
// `is_out` is true.
mesh grid(vertex_index nx, vertex_index ny,
          const std::function<bool(vertex_index, vertex_index)>& is_out = {}) {
  mesh m;
  std::vector<vertex_index> number((nx + 1) * (ny + 1), ~vertex_index{0});
  const auto at = [&](vertex_index i, vertex_index j) {
    vertex_index& v = number[j * (nx + 1) + i];
    if (v == ~vertex_index{0}) {
      v = static_cast<vertex_index>(m.sites.size());
      m.sites.push_back({{1.0 * i / nx, 1.0 * j / ny}, {1, 0, 1}});
    }
    return v;
  };
  for (vertex_index j = 0; j < ny; ++j)
    for (vertex_index i = 0; i < nx; ++i) {
      if (is_out && is_out(i, j)) continue;
      const vertex_index a = at(i, j), b = at(i + 1, j), c = at(i + 1, j + 1), d = at(i, j + 1);
      m.triangles.push_back({a, b, c});
      m.triangles.push_back({a, c, d});
    }
  return m;
}

solution scalar(const mesh& m, const std::function<double(const point&)>& f) {
  solution s;
  s.vertices = m.sites.size();
  s.fields.push_back({"u", field_kind::scalar, {}});
  for (const site& p : m.sites) s.fields[0].values.push_back(f(p.position));
  return s;
}

transferred_solution moved(const mesh& from, const solution& s, const mesh& to,
                           transfer_method how) {
  auto done = transfer_solution(from, s, to, how);
  INFO((done.ok() ? "" : done.failure().message));
  REQUIRE(done.ok());
  return std::move(done).value();
}

double greatest_difference(const mesh& m, const solution& s,
                           const std::function<double(const point&)>& f) {
  double greatest = 0;
  for (std::size_t v = 0; v < m.sites.size(); ++v)
    greatest = std::max(greatest, std::abs(s.fields[0].values[v] - f(m.sites[v].position)));
  return greatest;
}

double integral(const mesh& m, const solution& s) {
  double sum = 0;
  const std::vector<double>& u = s.fields[0].values;
  for (const triangle& t : m.triangles) {
    const point &p = m.sites[t[0]].position, &q = m.sites[t[1]].position,
                &r = m.sites[t[2]].position;
    sum +=
        ((q.x - p.x) * (r.y - p.y) - (q.y - p.y) * (r.x - p.x)) / 6 * (u[t[0]] + u[t[1]] + u[t[2]]);
  }
  return sum;
}

double bump(const point& q) {
  return 1 + std::exp(-200 * ((q.x - 0.4) * (q.x - 0.4) + (q.y - 0.6) * (q.y - 0.6)));
}
double step(const point& q) { return q.x + 0.3 * q.y < 0.6 ? -1 : 2; }

double area(const overlap& o) {
  double sum = 0;
  for (std::size_t k = 1; k + 1 < o.count; ++k) {
    const point &p = o.corners[0].at, &q = o.corners[k].at, &r = o.corners[k + 1].at;
    sum += ((q.x - p.x) * (r.y - p.y) - (q.y - p.y) * (r.x - p.x)) / 2;
  }
  return sum;
}

}  // namespace

TEST_CASE("a linear field is itself on any mesh, whatever the transfer") {
  const auto linear = [](const point& q) { return 3 - 2 * q.x + 5 * q.y; };
  for (const auto how : {transfer_method::interpolate, transfer_method::project}) {
    const mesh from = sample_mesh(11), to = sample_mesh(17);
    CHECK(greatest_difference(to, moved(from, scalar(from, linear), to, how).values, linear) <
          4e-14);
  }
  const mesh from = grid(20, 25), to = grid(20, 20);
  for (const auto how : {transfer_method::interpolate, transfer_method::project})
    CHECK(greatest_difference(to, moved(from, scalar(from, linear), to, how).values, linear) <
          4e-14);
}

TEST_CASE("integrals are kept where edges of both meshes nearly lie on one line") {
  splitmix64 random(7);
  const auto shaken = [&](mesh m) {
    for (site& p : m.sites)
      for (double* x : {&p.position.x, &p.position.y})
        if (*x > 0 && *x < 1) *x += random.real(-3e-16, 3e-16);
    return m;
  };
  const mesh from = grid(3, 3), to = shaken(grid(21, 21));
  const auto field = scalar(from, bump);
  for (const auto how : {transfer_method::project, transfer_method::bounded}) {
    const auto done = moved(from, field, to, how);
    CHECK(std::abs(integral(to, done.values) - integral(from, field)) < 1e-14);
  }
}

TEST_CASE("a constant is itself to the last bit or nearly so") {
  const mesh from = sample_mesh(9), to = sample_mesh(14);
  for (const auto how : methods) {
    const auto done = moved(from, scalar(from, [](const point&) { return 0.1; }), to, how);
    CHECK(greatest_difference(to, done.values, [](const point&) { return 0.1; }) <
          (how == transfer_method::interpolate ? 1e-300 : 1e-15));
  }
}

TEST_CASE("fifty transfers to and fro keep the integral to 1e-13") {
  const std::vector<std::pair<mesh, mesh>> pairs = {{grid(20, 25), grid(20, 20)},
                                                    {sample_mesh(20), sample_mesh(27)}};
  for (const auto& [a, b] : pairs)
    for (const auto how : {transfer_method::project, transfer_method::bounded})
      for (const auto& f : {bump, step}) {
        solution s = scalar(a, f);
        const double before = moved(a, s, a, how).report.components[0].integral_before;
        double after = before, low = 1e9, high = -1e9;
        for (int i = 0; i < 25; ++i) {
          s = moved(a, s, b, how).values;
          auto back = moved(b, s, a, how);
          after = back.report.components[0].integral_after;
          low = back.report.components[0].least_after;
          high = back.report.components[0].greatest_after;
          s = std::move(back.values);
        }
        CHECK(std::abs(after - before) <= 1e-13 * std::abs(before));
        if (how == transfer_method::bounded) {
          CHECK(low >= (f == step ? -1 : 1));
          CHECK(high <= 2);
        }
      }
}

TEST_CASE("a bounded transfer has no new extremum at any vertex, a projection of a step has") {
  const mesh from = sample_mesh(23), to = sample_mesh(31);
  const solution s = scalar(from, step);
  const auto bounded = moved(from, s, to, transfer_method::bounded).report.components[0],
             plain = moved(from, s, to, transfer_method::project).report.components[0];
  CHECK(bounded.least_after >= -1);
  CHECK(bounded.greatest_after <= 2);
  CHECK(plain.greatest_after > 2);
  CHECK(std::abs(bounded.integral_after - bounded.integral_before) < 1e-13);
}

TEST_CASE("a bounded transfer of a smooth field is nearly the projection") {
  const mesh from = sample_mesh(40), to = sample_mesh(33);
  const solution s = scalar(from, [](const point& q) { return std::sin(3 * q.x) * q.y; });
  const auto plain = moved(from, s, to, transfer_method::project).values.fields[0].values,
             bounded = moved(from, s, to, transfer_method::bounded).values.fields[0].values;
  double sum = 0;
  for (std::size_t v = 0; v < plain.size(); ++v) sum += std::abs(plain[v] - bounded[v]);
  CHECK(sum / static_cast<double>(plain.size()) < 2e-4);
}

TEST_CASE("nothing is read across a hole or a thin gap") {
  // Two plates with a gap of one cell between them, with value 0 below and 1 above; then a finer
  // mesh of the same domain.
  const auto plates = [](vertex_index n) {
    return grid(n, 1000, [](vertex_index, vertex_index j) { return j == 500; });
  };
  const mesh from = plates(3), to = plates(7);
  const solution s = scalar(from, [](const point& q) { return q.y < 0.5004 ? 0.0 : 1.0; });
  for (const auto how : methods)
    CHECK(greatest_difference(to, moved(from, s, to, how).values,
                              [](const point& q) { return q.y < 0.5004 ? 0.0 : 1.0; }) < 1e-15);
}

TEST_CASE("nothing is read across holes, slits, or from one part to another") {
  // A hole with corridors of one cell around it, a slit whose two sides have the same points twice,
  // and three parts side by side. Each side has a value of its own.
  const auto hole = [](vertex_index k) {
    return grid(20 * k, 20 * k, [k](vertex_index i, vertex_index j) {
      return (i >= 2 * k && i < 18 * k && j >= 2 * k && j < 18 * k) ||
             (i >= 9 * k && i < 11 * k && j >= 18 * k);
    });
  };
  const auto parts = [](vertex_index k) {
    return grid(5 * k, 7 * k, [k](vertex_index i, vertex_index) { return i / k % 2 == 1; });
  };
  const auto slit = [](vertex_index n) {
    mesh m = grid(n, 20, [](vertex_index, vertex_index j) { return j >= 10; });
    mesh above = grid(n, 20, [](vertex_index, vertex_index j) { return j < 10; });
    const auto base = static_cast<vertex_index>(m.sites.size());
    m.sites.insert(m.sites.end(), above.sites.begin(), above.sites.end());
    for (const triangle& t : above.triangles)
      m.triangles.push_back({t[0] + base, t[1] + base, t[2] + base});
    return m;
  };
  const auto by_part = [](const point& q) { return std::floor(2.5 * q.x + 0.25); };
  // The corridor below joins the two arms. At the gap above, the arms end.
  const auto by_arm = [](const point& q) {
    return q.y > 0.15 ? (q.x < 0.5 ? -1.0 : 1.0) : std::clamp(4 * q.x - 2, -1.0, 1.0);
  };
  for (const auto how : methods) {
    const mesh ring = hole(1), finer = hole(3);
    const auto around = moved(ring, scalar(ring, by_arm), finer, how);
    for (std::size_t v = 0; v < finer.sites.size(); ++v) {
      const point& q = finer.sites[v].position;
      if (q.y > 0.5) CHECK(std::abs(around.values.fields[0].values[v] - by_arm(q)) < 1e-12);
    }
    const mesh three = parts(2), many = parts(5);
    CHECK(greatest_difference(many, moved(three, scalar(three, by_part), many, how).values,
                              by_part) < 1e-14);
    // Both sides of the slit have the same coordinates. The component decides which side's value is
    // taken.
    const mesh two = slit(4), again = slit(9);
    solution s = scalar(two, [](const point&) { return 0.0; });
    for (std::size_t v = two.sites.size() / 2; v < two.sites.size(); ++v) s.fields[0].values[v] = 1;
    const auto halves = moved(two, s, again, how);
    for (std::size_t v = 0; v < again.sites.size(); ++v)
      CHECK(std::abs(halves.values.fields[0].values[v] - (v < again.sites.size() / 2 ? 0.0 : 1.0)) <
            1e-14);
  }
}

TEST_CASE("an internal segment is no wall: linear fields pass, jumps stay where they are") {
  const mesh from = tests::divided_mesh(12), to = tests::divided_mesh(17);
  const auto linear = [](const point& q) { return 2 + q.x - 3 * q.y; };
  for (const auto how : {transfer_method::interpolate, transfer_method::project})
    CHECK(greatest_difference(to, moved(from, scalar(from, linear), to, how).values, linear) <
          4e-14);
  for (const auto how : {transfer_method::project, transfer_method::bounded}) {
    const auto c = moved(from, scalar(from, step), to, how).report.components[0];
    CHECK(std::abs(c.integral_after - c.integral_before) < 1e-14);
  }
}

TEST_CASE("a vertex that rounding has put outside takes its value from its own side") {
  const auto plates = [](vertex_index n) {
    return grid(n, 1000, [](vertex_index, vertex_index j) { return j == 500; });
  };
  const mesh from = plates(3);
  mesh to = plates(7);
  std::size_t pushed = 0;
  for (site& v : to.sites)
    if (v.position.y == 500.0 / 1000) {  // more than half of it is in the gap
      v.position.y += 0.0006;
      ++pushed;
    }
  const solution s = scalar(from, [](const point& q) { return q.y < 0.5004 ? 0.0 : 1.0; });
  for (const auto how : methods) {
    const auto done = moved(from, s, to, how);
    CHECK(done.report.outside == pushed);
    CHECK(done.report.greatest_distance == Approx(0.0006));
    for (std::size_t v = 0; v < to.sites.size(); ++v)
      if (to.sites[v].position.y < 0.50065)
        CHECK(std::abs(done.values.fields[0].values[v]) < 1e-15);
  }
}

TEST_CASE("numbers whose products have no double are refused") {
  mesh from = grid(4, 4), to = grid(3, 3);
  const solution s = scalar(from, bump);
  for (mesh* const m : {&from, &to})
    for (site& at : m->sites) at.position = {at.position.x * 1e160, at.position.y * 1e160};
  for (const auto how : methods) {
    const auto done = transfer_solution(from, s, to, how);
    REQUIRE_FALSE(done.ok());
    CHECK(done.failure().message.find("is not finite") != std::string::npos);
  }
}

TEST_CASE("a part that the old mesh does not touch is refused") {
  const mesh from = grid(4, 4);
  mesh to = grid(3, 3);
  const auto base = static_cast<vertex_index>(to.sites.size());
  for (const point& q : {point{5, 5}, point{6, 5}, point{5, 6}}) to.sites.push_back({q, {1, 0, 1}});
  to.triangles.push_back({base, base + 1, base + 2});
  const auto done = transfer_solution(from, scalar(from, bump), to, transfer_method::project);
  REQUIRE_FALSE(done.ok());
  CHECK(done.failure().message.find("vertex 17 of the new mesh") == 0);
}

TEST_CASE("all kinds of fields are transferred, component by component") {
  const mesh from = sample_mesh(8), to = sample_mesh(9);
  solution s = scalar(from, bump);
  s.fields.push_back({"v", field_kind::vector, {}});
  s.fields.push_back({"t", field_kind::tensor, {}});
  for (const site& p : from.sites) {
    for (const double x : {p.position.x, p.position.y}) s.fields[1].values.push_back(x);
    for (const double x : {1.0, p.position.x, 2.0}) s.fields[2].values.push_back(x);
  }
  const auto done = moved(from, s, to, transfer_method::project);
  REQUIRE(done.report.components.size() == 6);
  CHECK(done.report.components[2].name == "v.y");
  for (std::size_t v = 0; v < to.sites.size(); ++v) {
    CHECK(done.values.fields[1].values[2 * v] == Approx(to.sites[v].position.x).margin(1e-13));
    CHECK(done.values.fields[2].values[3 * v + 1] == Approx(to.sites[v].position.x).margin(1e-13));
  }
  s.fields[1].values.pop_back();
  CHECK_FALSE(transfer_solution(from, s, to, transfer_method::project).ok());
}

namespace {

mesh times(mesh m, int power) {
  for (site& s : m.sites)
    s.position = {std::scalbn(s.position.x, power), std::scalbn(s.position.y, power)};
  return m;
}

solution times(solution s, int power) {
  for (double& u : s.fields[0].values) u = std::scalbn(u, power);
  return s;
}

}  // namespace

TEST_CASE("a transfer scaled by powers of two is the same, scaled, as far as doubles go") {
  const mesh from = grid(7, 7), to = grid(9, 9);
  const solution u = scalar(from, bump);
  const std::pair<int, int> scales[] = {{498, 0},   {-498, 0},    {0, 990},   {0, -990},
                                        {250, 500}, {-250, -500}, {498, 20},  {-498, 900},
                                        {30, 299},  {-400, -400}, {31, -300}, {500, -1000}};
  for (const transfer_method how : methods) {
    const transferred_solution ordinary = moved(from, u, to, how);
    for (const auto& [of_places, of_values] : scales) {
      CAPTURE(static_cast<int>(how), of_places, of_values);
      const auto far =
          moved(times(from, of_places), times(u, of_values), times(to, of_places), how);
      CHECK(far.values.fields[0].values == times(ordinary.values, of_values).fields[0].values);
      CHECK(far.report.area_after == std::scalbn(ordinary.report.area_after, 2 * of_places));
      CHECK(far.report.components[0].integral_after ==
            std::scalbn(ordinary.report.components[0].integral_after, 2 * of_places + of_values));
    }
  }
}

TEST_CASE("a transfer far from the origin is the same as one beside it, to the last bit") {
  const mesh from = grid(16, 4), to = grid(8, 32);
  const solution u = scalar(from, bump);
  const auto moved_by = [](mesh m, double x, double y) {
    for (site& s : m.sites) s.position = {s.position.x + x, s.position.y + y};
    return m;
  };
  const double far = std::ldexp(1.0, 40);  // so that places are multiples of 2^-12
  for (const transfer_method how : methods)
    for (const auto& [x, y] : {std::pair{far, 0.0}, std::pair{-far, far}, std::pair{1.0, -2.0}}) {
      CAPTURE(static_cast<int>(how), x, y);
      const auto near = moved(from, u, to, how);
      const auto there = moved(moved_by(from, x, y), u, moved_by(to, x, y), how);
      if (x > 0 && y >= 0) CHECK(there.values.fields[0].values == near.values.fields[0].values);
      CHECK(there.report.partly_covered == 0);
      CHECK(there.report.pieces == near.report.pieces);
      if (how == transfer_method::interpolate) continue;
      const auto& one = there.report.components[0];
      CHECK(std::abs(one.integral_after - one.integral_before) < 1e-14);
    }
}

TEST_CASE("areas and integrals that no double holds are refused, by name") {
  const mesh m = grid(4, 4);
  const solution u = scalar(m, bump);
  const mesh wide = times(m, 540), less_wide = times(m, 400);
  for (const transfer_method how : methods) {
    const auto area = transfer_solution(wide, u, wide, how);
    REQUIRE_FALSE(area.ok());
    CHECK(area.failure().message.find("the area of a mesh is not finite") == 0);
    const auto integral = transfer_solution(less_wide, times(u, 400), less_wide, how);
    REQUIRE_FALSE(integral.ok());
    CHECK(integral.failure().message.find("the integral of field 'u' is not finite") == 0);
  }
}

TEST_CASE("common parts add up to the triangle, and degenerate positions are no exception") {
  splitmix64 random(11);
  const auto coordinate = [&] { return static_cast<double>(random.below(5)); };
  const auto one = [&] {
    while (true) {
      const point a{coordinate(), coordinate()}, b{coordinate(), coordinate()},
          c{coordinate(), coordinate()};
      const double twice = (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
      if (twice > 0) return std::array{a, b, c};
    }
  };
  for (int i = 0; i < 20000; ++i) {
    const auto p = one(), q = one();
    const numbered_triangle old_one{{0, 1, 2}, p}, new_one{{0, 1, 2}, q};
    const overlap there = common_part(old_one, new_one, overlap_signs(old_one, new_one)),
                  back = common_part(new_one, old_one, overlap_signs(new_one, old_one));
    INFO("pair " << i);
    CHECK(area(there) == Approx(area(back)).margin(1e-12));
    CHECK(area(there) >= -1e-14);
    // The square [0,4]^2, cut in four parts around the middle of the new triangle: the integrals
    // over the parts add up.
    double sum = 0;
    const std::array<point, 4> square = {{{0, 0}, {4, 0}, {4, 4}, {0, 4}}};
    for (std::size_t k = 0; k < 4; ++k) {
      const numbered_triangle part{{0, 1, 2}, {square[k], square[(k + 1) % 4], {2, 2}}};
      sum += area(common_part(part, new_one, overlap_signs(part, new_one)));
    }
    const double whole =
        ((q[1].x - q[0].x) * (q[2].y - q[0].y) - (q[1].y - q[0].y) * (q[2].x - q[0].x)) / 2;
    CHECK(sum == Approx(whole).margin(1e-12));
  }
}

TEST_CASE("a corner on the line of an edge that nearly lies on its own edge is where it is") {
  // Cell of a grid of sixteenths below its diagonal. The second corner of the other triangle is a
  // unit in the last place inside, its third one exactly on the diagonal.
  const numbered_triangle cell{{0, 1, 2}, {{{0.75, 0.375}, {0.8125, 0.375}, {0.8125, 0.4375}}}};
  const numbered_triangle inside{{0, 1, 2},
                                 {{{0x1.8ee00d72611b2p-1, 0x1.8d87f90eb9b04p-2},
                                   {0x1.8fd481c3260ecp-1, 0x1.9fa903864c1d7p-2},
                                   {0x1.886a29fa9adf4p-1, 0x1.90d453f535be8p-2}}}};
  const overlap common = common_part(cell, inside, overlap_signs(cell, inside));
  REQUIRE(common.count == 3);
  for (const point& corner : inside.at)
    CHECK(std::any_of(common.corners.begin(), common.corners.begin() + 3,
                      [&](const overlap_corner& c) { return c.at == corner; }));
}

TEST_CASE("values are the same for any number of threads") {
  const mesh from = sample_mesh(90), to = sample_mesh(101);
  const solution s = scalar(from, bump);
  for (const auto how : methods) {
    const auto many = moved(from, s, to, how);
    const internal::thread_limit one(1);
    CHECK(many.values.fields[0].values == moved(from, s, to, how).values.fields[0].values);
  }
}
