// SPDX-License-Identifier: MIT
#include <catch2/catch.hpp>
#include <string>

#include "asterism/mesh/pieces/pieces_index.hpp"
#include "asterism/mesh/pieces/verify_pieces.hpp"
#include "pieces/cut_job.hpp"

using namespace asterism;
using namespace asterism::internal;

namespace {

pieces_index some_index() {
  const cut_job job = cut_into(3);
  pieces_index index;
  index.version = "0";
  index.metric = "swirl:6";
  index.options = {{"size", "0.1"}};
  index.angle_bound = 20;
  index.rounds = 1;
  index.original = job.shape;
  index.cut = job.cut;
  index.points = job.points;
  index.digests.assign(job.cut.edges.size(), 0);
  for (piece_index p = 0; p < 3; ++p) {
    piece_entry entry;
    entry.mesh = name_of_piece(p, 3, ".mesh");
    entry.certificate = name_of_piece(p, 3, ".certificate.json");
    index.pieces.push_back(entry);
  }
  return index;
}

}  // namespace

TEST_CASE("an index is read as it was written") {
  const std::string text = index_text(some_index());
  const auto read = parse_index(text, "index.json");
  REQUIRE(read);
  CHECK(index_text(read.value()) == text);
  CHECK(faults_of_index(read.value()).empty());
  for (const std::size_t length : {std::size_t{0}, std::size_t{1}, text.size() / 2})
    CHECK_FALSE(parse_index(text.substr(0, length), "index.json"));
  std::string edited = text;
  edited.replace(edited.find("0.1"), 3, "0.2");
  const auto refused = parse_index(edited, "index.json");
  REQUIRE_FALSE(refused);
  CHECK(refused.failure().message.find("edited") != std::string::npos);
  CHECK_FALSE(parse_index(std::string(100000, '['), "index.json"));
}

TEST_CASE("an index that is no JSON is refused by its line, not by its bytes") {
  const auto refused = parse_index("{\n\"pieces\": -0.\xa9}", "index.json");
  REQUIRE_FALSE(refused);
  CHECK(refused.failure().message == "index.json:2: this is not JSON");
}

TEST_CASE("an index that does not fit together is refused") {
  const pieces_index good = some_index();
  pieces_index bad = good;
  const auto first_cut = [&bad] {
    std::size_t e = 0;
    while (!bad.cut.edges[e].is_cut()) ++e;
    return e;
  };
  SECTION("a cut with one piece") { bad.cut.edges[first_cut()].right = no_piece; }
  SECTION("a cut with the same piece twice") {
    cut_edge& e = bad.cut.edges[first_cut()];
    e.right = e.left;
  }
  SECTION("a cut with two regions") { bad.cut.edges[first_cut()].right_region = 7; }
  SECTION("a cut of another marker") { bad.cut.edges[first_cut()].marker = 1; }
  SECTION("an edge twice") {
    bad.cut.edges.push_back(bad.cut.edges[first_cut()]);
    bad.points.emplace_back();
    bad.digests.push_back(0);
  }
  SECTION("a side of the domain with a piece outside") { bad.cut.edges.front().right = 1; }
  SECTION("a side of the domain without a piece") { bad.cut.edges.front().left = no_piece; }
  SECTION("a segment with a part missing") {
    bad.cut.edges.erase(bad.cut.edges.begin());
    bad.points.erase(bad.points.begin());
    bad.digests.erase(bad.digests.begin());
  }
  SECTION("a vertex moved") {
    bad.cut.vertices.back().x += 1e-6;
    bad.cut.vertices.front().x -= 1;
  }
  SECTION("a piece without an edge") {
    bad.pieces.push_back(bad.pieces.back());
    bad.cut.pieces = 4;
  }
  SECTION("files of another number") { std::swap(bad.pieces[0].mesh, bad.pieces[1].mesh); }
  CHECK_FALSE(faults_of_index(bad).empty());
  CHECK(faults_of_index(good).empty());
}

TEST_CASE("the rounds of a run are read as they were written") {
  const pieces_index index = some_index();
  const rounds_done done{"q", 2, 5, {0, 2}, index.points};
  const std::string text = rounds_text(done);
  const auto read = parse_rounds(text, index.cut.edges.size(), 3);
  REQUIRE(read);
  CHECK(read->question == "q");
  CHECK(read->rounds == 2);
  CHECK(read->made == 5);
  CHECK(read->next == done.next);
  CHECK(read->points == done.points);
  CHECK_FALSE(parse_rounds(text.substr(0, text.size() / 2), index.cut.edges.size(), 3));
  CHECK_FALSE(parse_rounds(text, index.cut.edges.size(), 2));
}
