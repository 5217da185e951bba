// SPDX-License-Identifier: MIT
#include "asterism/mesh/domain/curve_chains.hpp"

#include <algorithm>
#include <set>
#include <utility>

#include "asterism/mesh/domain/message_names.hpp"

namespace asterism::internal {
namespace {

using vertex_pairs = std::set<std::pair<vertex_index, vertex_index>>;

vertex_pairs ends_of_segments(const domain& d) {
  vertex_pairs ends;
  for (const segment& s : d.segments) ends.insert(std::minmax(s.a, s.b));
  return ends;
}

// Returns the number of consecutive vertices of a chain that are joined by segments.
std::size_t joined(const std::vector<vertex_index>& chain, const vertex_pairs& ends) {
  std::size_t count = 0;
  for (std::size_t i = 0; i + 1 < chain.size(); ++i)
    count += ends.count(std::minmax(chain[i], chain[i + 1]));
  return count;
}

}  // namespace

std::optional<error> check_curve_chains(const domain& d) {
  if (d.curves.empty()) return std::nullopt;
  const domain_names names(d);
  const vertex_pairs ends = ends_of_segments(d);
  for (std::size_t c = 0; c < d.curves.size(); ++c) {
    const std::vector<vertex_index>& chain = d.curves[c].vertices;
    const bool is_divided = chain.size() >= 2 && d.curves[c].parameters.size() == chain.size() &&
                            !(chain.size() == 2 && chain[0] == chain[1]) &&
                            joined(chain, ends) == chain.size() - 1;
    if (!is_divided)
      return error{names.at_curve(c) + names.curve(c) +
                   " has no chords: curves are divided before a domain is put in order"};
  }
  return std::nullopt;
}

result<std::vector<domain_curve>> kept_curves(const domain& input,
                                              const std::vector<vertex_index>& first_alike,
                                              const std::vector<vertex_index>& renumbered,
                                              const domain& kept) {
  std::vector<domain_curve> curves;
  if (input.curves.empty()) return curves;
  const domain_names names(input);
  const vertex_pairs ends = ends_of_segments(kept);
  vertex_pairs taken;
  for (std::size_t c = 0; c < input.curves.size(); ++c) {
    domain_curve curve = input.curves[c];
    for (vertex_index& v : curve.vertices) v = renumbered[first_alike[v]];
    const std::size_t chords = joined(curve.vertices, ends);
    if (chords == 0)
      return error{names.at_curve(c) + names.curve(c) +
                   " has the domain on neither side, or is covered by other segments"};
    bool is_whole = chords == curve.vertices.size() - 1;
    for (std::size_t i = 0; i + 1 < curve.vertices.size(); ++i)
      is_whole =
          taken.insert(std::minmax(curve.vertices[i], curve.vertices[i + 1])).second && is_whole;
    if (!is_whole)
      return error{names.at_curve(c) + names.curve(c) +
                   " is covered or cut in part by other segments"};
    curve.segment = 0;
    curves.push_back(std::move(curve));
  }
  return curves;
}

}  // namespace asterism::internal
