// SPDX-License-Identifier: MIT
#include <algorithm>
#include <catch2/catch.hpp>
#include <set>
#include <vector>

#include "pieces/cut_job.hpp"

using namespace asterism;
using namespace asterism::internal;

namespace {

struct ended_rounds {
  seam_points points;
  std::size_t rounds = 0, made = 0;
};

// Makes the pieces in rounds. `order` sorts the pieces of a round.
template <class Order>
ended_rounds rounds_of(const cut_job& job, seam_points points, const Order& order) {
  ended_rounds ended;
  std::set<piece_index> next;
  for (piece_index p = 0; p < job.cut.pieces; ++p) next.insert(p);
  std::vector<std::vector<seam_in_mesh>> asked(job.cut.pieces);
  while (!next.empty()) {
    REQUIRE(++ended.rounds < 20);
    std::vector<piece_index> turn(next.begin(), next.end());
    order(turn);
    for (auto& one : asked) one.clear();
    for (const piece_index p : turn) {
      ++ended.made;
      const piece_shape shape = shape_of_piece(job.shape, job.cut, points, p);
      const auto made = make_piece_mesh(shape, *job.field, options_of_pieces());
      REQUIRE(made);
      CHECK(made.value().certified());
      auto seams = seams_asked_for(job.cut, shape, p, made.value().outcome.result);
      REQUIRE(seams);
      asked[p] = std::move(seams).value();
    }
    std::vector<seam_in_mesh> all;
    for (const auto& one : asked) all.insert(all.end(), one.begin(), one.end());
    next.clear();
    for (const std::size_t e : unite_seams(all, points)) {
      next.insert(job.cut.edges[e].left);
      next.insert(job.cut.edges[e].right);
    }
  }
  ended.points = std::move(points);
  return ended;
}

}  // namespace

// Seams have fewer points than the pieces need, so that the pieces request more.
TEST_CASE("seams that pieces have to split are divided alike in the end, in any order") {
  const cut_job job = cut_into(4);
  seam_points sparse = job.points;
  for (std::size_t e = 0; e < sparse.size(); ++e)
    if (e % 2 == 0) sparse[e].clear();
  const auto forward = [](std::vector<piece_index>&) {};
  const auto backward = [](std::vector<piece_index>& turn) {
    std::reverse(turn.begin(), turn.end());
  };
  const ended_rounds one = rounds_of(job, sparse, forward);
  const ended_rounds other = rounds_of(job, sparse, backward);
  CHECK(one.rounds > 1);
  CHECK(one.made > job.cut.pieces);
  CHECK(one.rounds == other.rounds);
  CHECK(one.points == other.points);
  for (std::size_t e = 0; e < sparse.size(); ++e) {
    CHECK(one.points[e].size() >= sparse[e].size());
    if (!job.cut.edges[e].is_seam()) CHECK(one.points[e].empty());
  }
}

TEST_CASE("seams divided by length are asked for no more") {
  const cut_job job = cut_into(4);
  const ended_rounds ended = rounds_of(job, job.points, [](std::vector<piece_index>&) {});
  CHECK(ended.rounds == 1);
  CHECK(ended.points == job.points);
}

TEST_CASE("askings are united in order, and nothing there is taken away") {
  const auto at = [](double x) { return point{x, 0}; };
  seam_points points{{at(1), at(2)}, {}};
  const std::vector<seam_in_mesh> asked = {{0, {at(0.5), at(1), at(2)}},
                                           {0, {at(0.25), at(1), at(1.5), at(2), at(3)}}};
  CHECK(unite_seams(asked, points) == std::vector<std::size_t>{0});
  CHECK(points[0] == std::vector<point>{at(0.5), at(1), at(1.5), at(2), at(3)});
  CHECK(points[1].empty());
  CHECK(unite_seams({}, points).empty());
}

TEST_CASE("a mesh that left out a point of a seam is refused") {
  const cut_job job = cut_into(3);
  const piece_shape shape = shape_of_piece(job.shape, job.cut, job.points, 1);
  auto made = make_piece_mesh(shape, *job.field, options_of_pieces());
  REQUIRE(made);
  mesh& m = made.value().outcome.result;
  REQUIRE(seams_asked_for(job.cut, shape, 1, m));
  for (const boundary_edge& e : m.boundary)
    if (e.b >= m.given && shape.divisions[e.segment]) {
      m.sites[e.b].position.x += 1e-3;
      break;
    }
  const auto asked = seams_asked_for(job.cut, shape, 1, m);
  REQUIRE_FALSE(asked);
  CHECK(asked.failure().message.find("piece 2") != std::string::npos);
}
