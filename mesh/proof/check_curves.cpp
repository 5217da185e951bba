// SPDX-License-Identifier: MIT
#include "asterism/mesh/proof/check_curves.hpp"

#include <algorithm>
#include <map>
#include <string>
#include <utility>

#include "asterism/core/number_text.hpp"
#include "asterism/mesh/proof/curve_distance.hpp"
#include "asterism/mesh/proof/proof_words.hpp"

namespace asterism::internal::proof_detail {
namespace {

using vertex_pair = std::pair<vertex_index, vertex_index>;

// Finds the chains of boundary edges between vertices of the domain, and removes those that are
// assigned to a curve.
class boundary_chains {
 public:
  boundary_chains(const plane& all, std::size_t given)
      : all_(all), given_(given), around_(all.subject.sites.size()) {
    for (const boundary_edge& e : all.subject.boundary) {
      around_[e.a].push_back(e.b);
      around_[e.b].push_back(e.a);
      marker_[std::minmax(e.a, e.b)] = e.marker;
    }
  }

  // Returns the chains that begin at a vertex and are not yet assigned to a curve.
  std::vector<std::vector<vertex_index>> from(vertex_index v) const {
    std::vector<std::vector<vertex_index>> found;
    for (const vertex_index beside : around_[v]) {
      if (marker_.count(std::minmax(v, beside)) == 0) continue;
      std::vector<vertex_index> chain = {v, beside};
      while (chain.back() >= given_ && around_[chain.back()].size() == 2) {
        const auto& ends = around_[chain.back()];
        chain.push_back(ends[0] == chain[chain.size() - 2] ? ends[1] : ends[0]);
      }
      found.push_back(std::move(chain));
    }
    return found;
  }

  bool has_marker(const std::vector<vertex_index>& chain, int marker) const {
    for (std::size_t i = 0; i + 1 < chain.size(); ++i) {
      const auto edge = marker_.find(std::minmax(chain[i], chain[i + 1]));
      if (edge == marker_.end() || edge->second != marker) return false;
    }
    return true;
  }

  void take(const std::vector<vertex_index>& chain) {
    for (std::size_t i = 0; i + 1 < chain.size(); ++i)
      marker_.erase(std::minmax(chain[i], chain[i + 1]));
  }

  std::vector<boundary_edge> rest() const {
    std::vector<boundary_edge> edges;
    for (const boundary_edge& e : all_.subject.boundary)
      if (marker_.count(std::minmax(e.a, e.b)) != 0) edges.push_back(e);
    return edges;
  }

  std::vector<point> points_of(const std::vector<vertex_index>& chain) const {
    std::vector<point> points;
    points.reserve(chain.size());
    for (const vertex_index v : chain) points.push_back(all_.position(v));
    return points;
  }

 private:
  const plane& all_;
  std::size_t given_;
  std::vector<std::vector<vertex_index>> around_;
  std::map<vertex_pair, int> marker_;  // of the edges that are of no curve yet
};

// Returns a chain between the curve's ends, with its marker, that is within the distance `most` of
// the curve; nothing if there is none.
std::optional<std::vector<vertex_index>> chain_along(const boundary_chains& chains,
                                                     const domain_curve& curve,
                                                     const vertex_pair& ends, int marker,
                                                     const rational& most) {
  for (auto& chain : chains.from(ends.first)) {
    if (chain.back() != ends.second || !chains.has_marker(chain, marker)) continue;
    const auto far = distance_from_chords(curve, chains.points_of(chain));
    if (far && *far <= most) return std::move(chain);
  }
  return std::nullopt;
}

// Checks the condition of theorem 7 on required vertices: all of them are vertices of the domain,
// and every vertex of the domain that is on no curve is required.
std::optional<error> check_required(const proof_question& asked, const std::vector<char>& on_curve,
                                    std::size_t given) {
  std::vector<char> required(given, 0);
  for (const vertex_index v : asked.required) {
    if (v >= given) return not_shown(vertex_number(v) + " is required, and none of the domain's");
    required[v] = 1;
  }
  for (std::size_t v = 0; v < given; ++v)
    if (required[v] == 0 && on_curve[v] == 0)
      return not_shown(vertex_number(v) + " is on no curve, and not required");
  return std::nullopt;
}

std::string curve_number(const domain& shape, std::size_t k) {
  const auto& numbers = shape.origin.curve_numbers;
  return std::to_string(k < numbers.size() ? numbers[k] : k + 1);
}

}  // namespace

result<straight_part> part_off_curves(const plane& all, const proof_question& asked,
                                      const std::vector<vertex_index>& number_of,
                                      std::size_t given) {
  const domain& shape = *asked.shape;
  boundary_chains chains(all, given);
  std::vector<char> replaced(shape.segments.size(), 0), on_curve(all.subject.sites.size(), 0);
  const rational most(asked.chord_tolerance);
  for (std::size_t k = 0; k < shape.curves.size(); ++k) {
    const domain_curve& curve = shape.curves[k];
    if (std::exchange(replaced.at(curve.segment), 1) != 0)
      return not_shown("a segment has two curves");
    const vertex_pair ends(number_of[curve.vertices.front()], number_of[curve.vertices.back()]);
    const auto chain = chain_along(chains, curve, ends, shape.segments[curve.segment].marker, most);
    if (!chain)
      return not_shown("no chords are along curve " + curve_number(shape, k) + " and within " +
                       number_text(asked.chord_tolerance) + " of it");
    chains.take(*chain);
    for (const vertex_index v : *chain) on_curve[v] = 1;
  }
  if (auto failed = check_required(asked, on_curve, given)) return *failed;
  straight_part rest{chains.rest(), {}};
  for (std::size_t s = 0; s < shape.segments.size(); ++s)
    if (replaced[s] == 0) rest.segments.push_back(shape.segments[s]);
  return rest;
}

}  // namespace asterism::internal::proof_detail
