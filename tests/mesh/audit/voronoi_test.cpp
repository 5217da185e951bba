// SPDX-License-Identifier: MIT
//
// Point 5 of the auditor. A mesh that it proves to be the dual of the Voronoi diagram is compared
// with the cells of single points; each refusal is compared with its reason.
#include <algorithm>
#include <array>
#include <catch2/catch.hpp>
#include <cmath>
#include <limits>
#include <map>
#include <set>
#include <utility>

#include "asterism/kernels/filtered_kernel.hpp"
#include "asterism/mesh/audit/audit.hpp"
#include "asterism/mesh/audit/voronoi_arc.hpp"
#include "asterism/mesh/audit/voronoi_exact.hpp"
#include "asterism/mesh/data/metric_field.hpp"
#include "asterism/mesh/domain/built_in_domains.hpp"
#include "asterism/mesh/domain/check_domain.hpp"
#include "asterism/mesh/io/load_domain.hpp"
#include "asterism/mesh/mesher.hpp"
#include "asterism/mesh/metric/make_metric_field.hpp"
#include "fixtures/audit_meshes.hpp"

using namespace asterism;
using namespace asterism::internal;
using namespace asterism::test;
using namespace asterism::internal::audit_detail;
using Catch::Contains;

namespace {

using vertex_number = asterism::vertex_index;

audit_report audit_voronoi(const mesh& m) {
  audit_options options;
  options.check_voronoi = true;
  return audit(m, options);
}

double squared_distance(const site& s, const point& q) {
  const double x = q.x - s.position.x, y = q.y - s.position.y;
  return s.metric.m11 * x * x + 2 * s.metric.m12 * x * y + s.metric.m22 * y * y;
}

mesh meshed_square(const std::string& metric, double size, double bound = 20) {
  const auto shape = check_domain(load_domain("square").value()).value();
  const auto field = make_metric_field(metric, shape.box(), size);
  mesh_options options;
  options.angle_bound = bound;
  options.limit_size = true;
  return make_mesh(shape, *field.value(), options).value().result;
}

using edge_set = std::set<std::pair<vertex_number, vertex_number>>;

edge_set edges_of(const mesh& m) {
  edge_set edges;
  for (const triangle& t : m.triangles)
    for (std::size_t i = 0; i < 3; ++i) {
      const auto a = t[i], b = t[(i + 1) % 3];
      edges.insert({std::min(a, b), std::max(a, b)});
    }
  return edges;
}

// Returns pairs of sites that own neighbouring points of a lattice over [-1,1]^2, in doubles.
// Leaves out points with a third site nearly as near: corners of cells, and roundings.
edge_set neighbours_seen(const mesh& m, int n) {
  std::vector<vertex_number> owner(static_cast<std::size_t>(n * n));
  const auto at = [&](int i, int j) -> vertex_number& {
    return owner[static_cast<std::size_t>(i + j * n)];
  };
  for (int j = 0; j < n; ++j)
    for (int i = 0; i < n; ++i) {
      const point q{-1 + (2 * i + 1.0) / n, -1 + (2 * j + 1.0) / n};
      for (vertex_number v = 1; v < m.sites.size(); ++v)
        if (squared_distance(m.sites[v], q) < squared_distance(m.sites[at(i, j)], q)) at(i, j) = v;
    }
  edge_set seen;
  for (int j = 1; j + 1 < n; ++j)
    for (int i = 1; i + 1 < n; ++i) {
      std::set<vertex_number> around;
      for (int y = j - 1; y <= j + 1; ++y)
        for (int x = i - 1; x <= i + 1; ++x) around.insert(at(x, y));
      if (around.size() == 2) seen.insert({*around.begin(), *around.rbegin()});
    }
  return seen;
}

// A grid of squares of side 2, cut along equal or alternating diagonals.
mesh square_grid(int n, bool alternating, point origin = {0, 0}) {
  std::vector<point> points;
  std::vector<triangle> triangles;
  for (int j = 0; j <= n; ++j)
    for (int i = 0; i <= n; ++i) points.push_back({origin.x + 2 * i, origin.y + 2 * j});
  const auto at = [&](int i, int j) { return static_cast<vertex_number>(i + j * (n + 1)); };
  for (int j = 0; j < n; ++j)
    for (int i = 0; i < n; ++i) {
      const auto a = at(i, j), b = at(i + 1, j), c = at(i + 1, j + 1), d = at(i, j + 1);
      const bool other = alternating && (i + j) % 2 == 0;
      triangles.push_back(other ? triangle{a, b, d} : triangle{a, b, c});
      triangles.push_back(other ? triangle{b, c, d} : triangle{a, c, d});
    }
  return make_mesh_of(points, triangles);
}

constexpr std::array voronoi_kinds = {
    finding_kind::voronoi_vertex_missing, finding_kind::voronoi_arc_reversed,
    finding_kind::voronoi_site_nearer, finding_kind::voronoi_boundary_encroached};

// Finds violations by the definition: exact numbers alone, every site against every arc.
std::map<finding_kind, std::size_t> judge_slowly(const mesh& m) {
  const filtered_kernel kernel;
  std::map<finding_kind, std::size_t> found;
  for (const finding_kind kind : voronoi_kinds) found[kind] = 0;
  const auto at = [&](vertex_number v) -> const site& { return m.sites[v]; };
  std::map<std::pair<vertex_number, vertex_number>, vertex_number> apex;
  std::map<std::pair<vertex_number, vertex_number>, bool> has_vertex;
  for (const triangle& t : m.triangles) {
    const bool there = exact_voronoi_arc(at(t[1]), at(t[2])).vertex(at(t[0])).has_value();
    found[finding_kind::voronoi_vertex_missing] += !there;
    for (std::size_t i = 0; i < 3; ++i) {
      const std::pair edge{t[i], t[(i + 1) % 3]};
      apex[edge] = t[(i + 2) % 3];
      has_vertex[edge] = there;
    }
  }
  for (const auto& [edge, left] : apex) {
    const auto [v, u] = edge;
    const std::pair reverse{u, v};
    const bool on_boundary = apex.count(reverse) == 0;
    if (on_boundary)
      for (vertex_number w = 0; w < m.sites.size(); ++w)
        found[finding_kind::voronoi_boundary_encroached] +=
            w != v && w != u && kernel.encroaches(at(v), at(u), at(w));
    if (!on_boundary && v < u) continue;  // the other end stands for this edge
    if (!has_vertex[edge] || (!on_boundary && !has_vertex[reverse])) continue;
    const exact_voronoi_arc arc(at(v), at(u));
    const auto to = arc.vertex(at(left)),
               from = on_boundary ? exact_voronoi_arc::on_segment() : arc.vertex(at(apex[reverse]));
    const sign order = exact_voronoi_arc::order(*to, *from);
    found[finding_kind::voronoi_arc_reversed] += order == sign::negative;
    if (order != sign::positive) continue;
    for (vertex_number w = 0; w < m.sites.size(); ++w) {
      if (w == v || w == u) continue;
      const arc_meeting meeting = arc.meeting_with(at(w), *from, *to);
      found[finding_kind::voronoi_site_nearer] += meeting.nearer || meeting.between;
    }
  }
  return found;
}

// Returns the mesh with its vertices in the opposite order and each triangle begun at another
// corner.
mesh renumbered(mesh m) {
  const auto last = static_cast<vertex_number>(m.sites.size() - 1);
  std::reverse(m.sites.begin(), m.sites.end());
  m.given = 0;
  for (triangle& t : m.triangles) t = {last - t[1], last - t[2], last - t[0]};
  for (boundary_edge& e : m.boundary) e.a = last - e.a, e.b = last - e.b;
  return m;
}

void scale(mesh& m, int exponent) {
  for (site& s : m.sites) {
    s.position = {std::ldexp(s.position.x, exponent), std::ldexp(s.position.y, exponent)};
    s.metric = {std::ldexp(s.metric.m11, -2 * exponent), std::ldexp(s.metric.m12, -2 * exponent),
                std::ldexp(s.metric.m22, -2 * exponent)};
  }
}

}  // namespace

TEST_CASE("without being asked for there is no verdict, and none of what is no triangulation") {
  patch p = make_patch(4);
  CHECK(audit(p.m, {}).voronoi == voronoi_verdict::not_asked);
  p.m.triangles.pop_back();
  CHECK(audit_voronoi(p.m).voronoi == voronoi_verdict::not_reached);
}

TEST_CASE("a Delaunay triangulation is the dual of its diagram, decided without exact numbers") {
  const patch p = make_patch(8);
  const audit_report report = audit_voronoi(p.m);
  INFO(kinds(report));
  CHECK(report.voronoi == voronoi_verdict::proved);
  CHECK(report.certified);
  CHECK(report.voronoi_pairs > 500);
  CHECK(report.voronoi_pairs_exact == 0);
}

TEST_CASE("meshes of metrics that turn are duals, and points looked at one by one say so too") {
  for (const char* metric : {"identity", "swirl:3", "swirl:12", "sink:12"}) {
    const mesh m = meshed_square(metric, 0.35);
    const audit_report report = audit_voronoi(m);
    INFO(metric << '\n' << kinds(report));
    REQUIRE(report.voronoi == voronoi_verdict::proved);
    CHECK(report.voronoi_pairs_exact * 50 <= report.voronoi_pairs);
    const edge_set edges = edges_of(m), seen = neighbours_seen(m, 320);
    CHECK(seen.size() > edges.size() / 2);
    for (const auto& edge : seen) CHECK(edges.count(edge) == 1);
  }
}

TEST_CASE("a flipped edge runs backwards") {
  patch p = make_patch(4);
  const std::size_t t = 2 * (1 + 1 * 4);
  p.m.triangles[t] = {p.at(1, 1), p.at(2, 1), p.at(2, 2)};
  p.m.triangles[t + 1] = {p.at(1, 1), p.at(2, 2), p.at(1, 2)};
  const audit_report report = audit_voronoi(p.m);
  CHECK(report.voronoi == voronoi_verdict::refused);
  CHECK(found(report, finding_kind::voronoi_arc_reversed));
  CHECK_THAT(witnesses(report, finding_kind::voronoi_arc_reversed),
             Contains("runs backwards") || Contains("run backwards"));
}

TEST_CASE("a triangle whose Voronoi vertex is not seen by its corners is named") {
  mesh m = make_mesh_of({{0, 0}, {4, 0}, {0, 4}}, {{0, 1, 2}});
  m.sites[0].metric = {1, 0.9, 1};
  m.sites[1].metric = {1, -0.9, 9};
  m.sites[2].metric = {100, 0, 0.1};
  const audit_report report = audit_voronoi(m);
  CHECK(report.voronoi == voronoi_verdict::refused);
  CHECK_THAT(witnesses(report, finding_kind::voronoi_vertex_missing),
             Contains("triangle 1 of vertex 1 (0, 0)"));
}

TEST_CASE("an obtuse triangle has its vertex beyond the boundary, and a site that encroaches") {
  const mesh m = make_mesh_of({{0, 0}, {8, 0}, {4, 1}, {4, 9}}, {{0, 1, 2}, {1, 3, 2}, {3, 0, 2}});
  const audit_report report = audit_voronoi(m);
  CHECK(report.voronoi == voronoi_verdict::refused);
  CHECK_THAT(witnesses(report, finding_kind::voronoi_arc_reversed),
             Contains("is beyond boundary edge"));
  CHECK_THAT(witnesses(report, finding_kind::voronoi_boundary_encroached),
             Contains("vertex 3 (4, 1) encroaches on boundary edge"));
}

TEST_CASE("a right angle at the boundary is allowed: its Voronoi vertex is on the edge") {
  const audit_report report = audit_voronoi(square_grid(1, false));
  INFO(kinds(report));
  CHECK(report.voronoi == voronoi_verdict::proved);
}

TEST_CASE("a site reaches over its neighbour between Voronoi vertices, farther from all of them") {
  // The middle site's distance grows slowest along one axis. There its cell reaches beyond the
  // cells of its neighbours, though every corner of a cell is nearer to the cell's owner.
  mesh m = square_grid(8, true);
  const vertex_number middle = 4 + 4 * 9;
  m.sites[middle].metric = {0.05, 0, 2};
  const audit_report report = audit_voronoi(m);
  INFO(kinds(report));
  CHECK(report.voronoi == voronoi_verdict::refused);
  CHECK_FALSE(found(report, finding_kind::voronoi_vertex_missing));
  CHECK_FALSE(found(report, finding_kind::voronoi_arc_reversed));
  CHECK_THAT(witnesses(report, finding_kind::voronoi_site_nearer),
             Contains("vertex 41 (8, 8) is nearer to a point of the Voronoi arc between vertex 42 "
                      "(10, 8) and vertex 43 (12, 8)"));
  // The middle site is nearer at the point between, and not at the corners.
  CHECK(squared_distance(m.sites[middle], {11, 8}) < squared_distance(m.sites[41], {11, 8}));
  CHECK(squared_distance(m.sites[middle], {11, 9}) > squared_distance(m.sites[41], {11, 9}));
}

TEST_CASE("cocircular sites tie: equal distance is allowed, however the squares are cut") {
  for (const bool alternating : {false, true}) {
    const mesh m = square_grid(6, alternating);
    const audit_report report = audit_voronoi(m);
    INFO(kinds(report));
    CHECK(report.voronoi == voronoi_verdict::proved);
    CHECK(report.voronoi_pairs_exact == 0);
  }
}

TEST_CASE("cells that share a whole line are no dual, though no site is nearer to any of it") {
  // On x = 0 the sites of three columns are equally far, as each measures. There the cells of the
  // first column meet those of the third, though the second column is between.
  std::vector<point> points;
  for (const double x : {-2.0, -1.0, 1.0})
    for (int j = 0; j <= 6; ++j) points.push_back({x, static_cast<double>(j)});
  std::vector<triangle> triangles;
  for (vertex_number k : {0u, 7u})
    for (vertex_number j = k; j < k + 6; ++j) {
      triangles.push_back({j, j + 7, j + 1});
      triangles.push_back({j + 7, j + 8, j + 1});
    }
  mesh m = make_mesh_of(points, triangles);
  for (vertex_number j = 0; j < 7; ++j) m.sites[j].metric = {0.25, 0, 1};
  const audit_report report = audit_voronoi(m);
  INFO(kinds(report));
  CHECK(report.certified);
  CHECK(report.voronoi == voronoi_verdict::refused);
  CHECK_THAT(witnesses(report, finding_kind::voronoi_site_nearer), Contains("is as near to"));
}

TEST_CASE("a site that touches a Voronoi vertex from elsewhere is refused") {
  // The middle (3, 3) of a square is exactly as far from the site at (6, 4) as from its corners.
  mesh m = square_grid(4, false);
  m.sites[3 + 2 * 5].metric = {0.25, -0.25, 1.25};
  CHECK(squared_distance(m.sites[3 + 2 * 5], {3, 3}) ==
        squared_distance(m.sites[2 + 2 * 5], {3, 3}));
  const audit_report report = audit_voronoi(m);
  INFO(kinds(report));
  CHECK(report.voronoi == voronoi_verdict::refused);
  CHECK_THAT(witnesses(report, finding_kind::voronoi_site_nearer),
             Contains("vertex 14 (6, 4) is as near to the Voronoi vertex of triangle"));
  // With the site a little farther from the middle the mesh is a dual.
  m.sites[3 + 2 * 5].metric = {0.265625, -0.265625, 1.328125};
  CHECK(audit_voronoi(m).voronoi == voronoi_verdict::proved);
}

TEST_CASE("a site may touch a boundary edge in its own Voronoi vertex alone") {
  // The angle across from the boundary edge is right, so that the Voronoi vertex is the edge's
  // middle.
  const mesh right = make_mesh_of({{0, 0}, {2, 0}, {1, 1}}, {{0, 1, 2}});
  const audit_report own = audit_voronoi(right);
  INFO(kinds(own));
  CHECK(own.voronoi == voronoi_verdict::proved);
  // The angle is obtuse: the site is nearer to a part of the edge than the edge's ends are.
  mesh beside = make_mesh_of({{0, 0}, {4, 0}, {1, 1}, {2, 4}}, {{0, 1, 2}, {1, 3, 2}, {3, 0, 2}});
  const audit_report touching = audit_voronoi(beside);
  CHECK(touching.voronoi == voronoi_verdict::refused);
}

TEST_CASE("ties of sites whose metrics differ are exact ones") {
  // Mirror images in both axes: the centre is equally far from all four.
  mesh one = make_mesh_of({{-1, -1}, {1, -1}, {1, 1}, {-1, 1}}, {{0, 1, 2}, {0, 2, 3}});
  mesh other = make_mesh_of({{-1, -1}, {1, -1}, {1, 1}, {-1, 1}}, {{0, 1, 3}, {1, 2, 3}});
  for (mesh* m : {&one, &other})
    for (site& s : m->sites) s.metric = {1, 0.25 * s.position.x * s.position.y, 1.5};
  for (const mesh* m : {&one, &other}) {
    const audit_report report = audit_voronoi(*m);
    INFO(kinds(report));
    CHECK(report.voronoi == voronoi_verdict::proved);
    CHECK(report.exact_decisions > 0);
  }
  // After a move by one unit in the last place exactly one diagonal is right.
  for (const double moved : {std::nextafter(1.0, 0.0), std::nextafter(1.0, 2.0)}) {
    one.sites[2].position.y = other.sites[2].position.y = moved;
    const auto by_one = audit_voronoi(one).voronoi, by_other = audit_voronoi(other).voronoi;
    CHECK((by_one == voronoi_verdict::proved) != (by_other == voronoi_verdict::proved));
  }
}

TEST_CASE("scaled by powers of two, stretched and moved far away the verdict is the same") {
  for (const int exponent : {-400, -60, 60, 400}) {
    patch p = make_patch(5);
    scale(p.m, exponent);
    const audit_report report = audit_voronoi(p.m);
    INFO(exponent << '\n' << kinds(report));
    CHECK(report.voronoi == voronoi_verdict::proved);
    CHECK(report.voronoi_pairs_exact == 0);
  }
  const audit_report flat = audit_voronoi(stretched(make_patch(5), 0x1p-20).m);
  CHECK(flat.voronoi == voronoi_verdict::proved);
  const audit_report far = audit_voronoi(square_grid(5, true, {1e8, -1e8}));
  CHECK(far.voronoi == voronoi_verdict::proved);
}

TEST_CASE("enclosed vertices and arcs never contradict exact ones") {
  splitmix64 random(4711);
  int decided = 0, asked = 0, nearer = 0, vertices = 0;
  for (int round = 0; round < 400; ++round) {
    const double strength = 0.1 + 0.9 * (round % 4);
    const auto make_site = [&](double x, double y) -> site {
      return {{x + random.real(-0.2, 0.2), y + random.real(-0.2, 0.2)},
              random_metric(random, strength)};
    };
    const site v = make_site(0, 0), u = make_site(1, 0), x = make_site(0.5, 0.8),
               y = make_site(0.5, -0.8);
    const exact_voronoi_arc exact(v, u);
    const auto to = exact.vertex(x), from = exact.vertex(y);
    const auto enclosed_to = enclose_voronoi_vertex(v, u, x);
    INFO("round " << round);
    if (enclosed_to) {
      ++vertices;
      REQUIRE(to);
      const offset same = exact.enclose(*to);
      CHECK(std::abs(same.x.value() - enclosed_to->x.value()) <=
            same.x.error() + enclosed_to->x.error());
      CHECK(std::abs(same.y.value() - enclosed_to->y.value()) <=
            same.y.error() + enclosed_to->y.error());
    }
    if (!to || !from || exact_voronoi_arc::order(*to, *from) != sign::positive) continue;
    const enclosed_arc arc(v, u, exact.enclose(*from), exact.enclose(*to));
    for (int other = 0; other < 12; ++other) {
      const double r = 2.5 * std::sqrt(random.real(0, 1)), a = random.real(-3.2, 3.2);
      const site w = other == 0   ? x
                     : other == 1 ? y
                                  : make_site(0.5 + r * std::cos(a), r * std::sin(a));
      const uncertain_bool quick = arc.is_nearer(w, other == 1, other == 0);
      const arc_meeting meeting = exact.meeting_with(w, *from, *to);
      const bool slow = meeting.nearer;
      ++asked;
      decided += quick.certain();
      nearer += slow;
      if (quick.certain()) CHECK(quick.value() == slow);
      if (quick.certainly(false)) CHECK_FALSE(meeting.between);
    }
  }
  CHECK(vertices > 200);
  CHECK(nearer > asked / 20);
  CHECK(decided > asked * 97 / 100);
}

TEST_CASE(
    "verdicts are those of the definition without any shortcut, however vertices are numbered") {
  splitmix64 random(99);
  int proved = 0, refused = 0;
  for (int round = 0; round < 10; ++round) {
    const double strength = 0.15 * round;
    patch p = make_patch(3, 0.1);
    for (site& s : p.m.sites) s.metric = random_metric(random, strength);
    INFO("round " << round);
    const audit_report report = audit_voronoi(p.m);
    REQUIRE(report.voronoi != voronoi_verdict::not_reached);
    const auto slow = judge_slowly(p.m);
    INFO(kinds(report));
    for (const finding_kind kind : voronoi_kinds)
      CHECK(report.found[static_cast<std::size_t>(kind)] == slow.at(kind));
    (report.voronoi == voronoi_verdict::proved ? proved : refused) += 1;
    const audit_report turned = audit_voronoi(renumbered(p.m));
    for (const finding_kind kind : voronoi_kinds)
      CHECK(turned.found[static_cast<std::size_t>(kind)] == slow.at(kind));
  }
  CHECK(proved >= 3);
  CHECK(refused >= 3);
}
