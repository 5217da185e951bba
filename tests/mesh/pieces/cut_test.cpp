// SPDX-License-Identifier: MIT
#include <catch2/catch.hpp>
#include <cmath>
#include <map>
#include <set>
#include <vector>

#include "asterism/mesh/audit/divided_domain.hpp"
#include "pieces/cut_job.hpp"

using namespace asterism;
using namespace asterism::internal;

namespace {

std::vector<boundary_edge> parts_of(const domain_cut& cut, const domain& d) {
  std::vector<boundary_edge> parts;
  for (const cut_edge& e : cut.edges)
    if (!e.is_cut())
      parts.push_back({e.a, e.b, e.segment, e.marker, d.segments[e.segment].internal});
  return parts;
}

}  // namespace

TEST_CASE("the boundaries of all pieces add up to that of the domain") {
  for (const std::size_t pieces : {1, 2, 5, 9}) {
    const cut_job job = cut_into(pieces);
    std::map<std::pair<double, double>, std::map<std::pair<double, double>, int>> sum;
    const auto key = [](const point& q) { return std::pair{q.x, q.y}; };
    const auto add = [&](const point& a, const point& b) {
      ++sum[key(a)][key(b)];
      --sum[key(b)][key(a)];
    };
    for (piece_index p = 0; p < pieces; ++p) {
      const domain one = shape_of_piece(job.shape, job.cut, job.points, p).shape;
      for (const segment& s : one.segments)
        if (!s.internal) add(one.vertices[s.a], one.vertices[s.b]);
    }
    for (const cut_edge& e : job.cut.edges)
      if (!e.is_cut() && e.right == no_piece) add(job.cut.vertices[e.b], job.cut.vertices[e.a]);
    for (const auto& [from, to] : sum)
      for (const auto& [end, count] : to) CHECK(count == 0);
    for (const cut_edge& e : job.cut.edges) CHECK((!e.is_cut() || e.is_seam()));
    if (pieces == 1) CHECK(job.cut.edges.size() == job.shape.segments.size());
  }
}

TEST_CASE("a divided domain is audited as a boundary") {
  const cut_job job = cut_into(6);
  std::vector<boundary_edge> parts = parts_of(job.cut, job.shape);
  CHECK(audit_divided_domain(job.shape, job.shape.vertices, {}).certified == false);
  std::vector<point> vertices = job.cut.vertices;
  CHECK(audit_divided_domain(job.shape, vertices, parts).certified);

  SECTION("a part that is missing") {
    parts.pop_back();
    CHECK_FALSE(audit_divided_domain(job.shape, vertices, parts).certified);
  }
  SECTION("a part turned around") {
    std::swap(parts.front().a, parts.front().b);
    CHECK_FALSE(audit_divided_domain(job.shape, vertices, parts).certified);
  }
  SECTION("another marker") {
    parts.front().marker += 1;
    CHECK_FALSE(audit_divided_domain(job.shape, vertices, parts).certified);
  }
  SECTION("a point off its segment") {
    for (const boundary_edge& e : parts)
      if (e.b >= job.cut.given) {
        vertices[e.b].x += 1e-9;
        vertices[e.b].y += 1e-9;
        break;
      }
    CHECK_FALSE(audit_divided_domain(job.shape, vertices, parts).certified);
  }
}

TEST_CASE("pieces have about equal areas in the metric") {
  constexpr std::size_t pieces = 8;
  const cut_job job = cut_into(pieces, "swirl:12", 0.02);
  std::vector<double> triangles;
  for (piece_index p = 0; p < pieces; ++p) {
    const auto made = make_piece_mesh(shape_of_piece(job.shape, job.cut, job.points, p), *job.field,
                                      options_of_pieces());
    REQUIRE(made);
    CHECK(made.value().certified());
    triangles.push_back(static_cast<double>(made.value().outcome.triangles));
  }
  double sum = 0;
  for (const double t : triangles) sum += t;
  for (const double t : triangles) CHECK(std::abs(t * pieces / sum - 1) < 0.1);
}

TEST_CASE("what is too small to be cut is refused") {
  const domain d = square();
  const auto checked = check_domain(d);
  REQUIRE(checked);
  const auto field = make_metric_field("identity", d.box(), 1);
  REQUIRE(field);
  cut_wishes wishes;
  wishes.pieces = 100;
  const auto cut = cut_domain(checked.value(), *field.value(), wishes);
  REQUIRE_FALSE(cut);
  CHECK(cut.failure().message.find("--pieces 100") != std::string::npos);
}
