// SPDX-License-Identifier: MIT
#include "asterism/mesh/domain/repair_domain.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "asterism/core/elementary.hpp"
#include "asterism/core/number_text.hpp"
#include "asterism/mesh/domain/domain_values.hpp"
#include "asterism/mesh/domain/exact_lengths.hpp"
#include "asterism/mesh/domain/message_names.hpp"
#include "asterism/mesh/domain/repair_tally.hpp"
#include "asterism/mesh/domain/snapping.hpp"
#include "asterism/mesh/domain/trim_segments.hpp"

namespace asterism {
using namespace internal;
namespace {

// Returns the distance from a point to a segment in doubles, for the report.
double distance_to_segment(const point& v, const point& a, const point& b) {
  const double x = b.x - a.x, y = b.y - a.y, scale = std::max(std::abs(x), std::abs(y));
  const auto from = [&](const point& p) { return elementary::hypot(v.x - p.x, v.y - p.y); };
  if (!(scale > 0)) return from(a);
  const double u = x / scale, w = y / scale;
  const double t = ((v.x - a.x) * u + (v.y - a.y) * w) / (u * u + w * w) / scale;
  const double s = std::clamp(t, 0.0, 1.0);
  return from({a.x + s * x, a.y + s * y});
}

// Returns the polygons with each segment replaced by its pieces. `pieces` are in the order of the
// segments.
std::vector<domain_polygon> polygons_of_pieces(const domain& d,
                                               const std::vector<snapped_piece>& pieces) {
  std::vector<domain_polygon> made = d.polygons;
  for (domain_polygon& polygon : made)
    for (auto& ring : polygon.rings) {
      std::vector<std::uint32_t> parts;
      for (const std::uint32_t s : ring) {
        const auto [first, last] = std::equal_range(
            pieces.begin(), pieces.end(), snapped_piece{0, 0, s},
            [](const snapped_piece& p, const snapped_piece& q) { return p.source < q.source; });
        for (auto p = first; p != last; ++p)
          parts.push_back(static_cast<std::uint32_t>(p - pieces.begin()));
      }
      ring = std::move(parts);
    }
  return made;
}

class repairer {
 public:
  repairer(const domain& input, double distance, domain_repairs& report, const cancellation& stop)
      : input_(input), names_(input), distance_(distance), report_(report), stop_(stop) {
    report_ = {};
    report_.distance = distance;
  }

  result<domain> repair() {
    auto snapped = snap_segments(input_, distance_, stop_);
    if (!snapped) return snapped.failure().at(names_.at_start() + "repair");
    snapped_graph& graph = snapped.value();
    tell_joined(graph);
    tell_meetings(graph);
    tell_trimmed(graph, trim_segments(input_, graph));
    measure_moves(graph);
    domain repaired = assemble(graph);
    drop_holes(repaired);
    domain_repairs rest;
    auto checked = check_domain(repaired, &rest);
    if (checked) add(rest);
    return checked;
  }

 private:
  void tell_joined(const snapped_graph& graph);
  void tell_meetings(const snapped_graph& graph);
  void tell_trimmed(const snapped_graph& graph, const std::vector<snapped_piece>& trimmed);
  void measure_moves(const snapped_graph& graph);
  domain assemble(const snapped_graph& graph) const;
  void drop_holes(domain& repaired);
  void add(const domain_repairs& rest);

  const domain& input_;
  const domain_names names_;
  double distance_;
  domain_repairs& report_;
  const cancellation& stop_;
};

void repairer::tell_joined(const snapped_graph& graph) {
  repair_tally same(report_.merged_vertices), joined(report_.joined_vertices);
  for (std::size_t v = 0; v < graph.joined_to.size(); ++v) {
    const vertex_index w = graph.joined_to[v];
    if (w == v) continue;
    const bool is_same = input_.vertices[v] == input_.vertices[w];
    (is_same ? same : joined)
        .add(
            [&] { return names_.at_vertex(v); },
            [&] { return names_.vertex(v) + (is_same ? " is " : " becomes ") + names_.vertex(w); });
    if (!is_same) report_.places.push_back({"joined", input_.vertices[v]});
  }
  same.report("repeated vertices merged", report_.messages);
  joined.report("vertices joined that were nearer than " + format_number(distance_),
                report_.messages);
}

void repairer::tell_meetings(const snapped_graph& graph) {
  repair_tally bent(report_.bent_segments), crossings(report_.crossings);
  std::set<std::pair<vertex_index, std::size_t>> bent_before;
  std::set<std::tuple<vertex_index, std::size_t, std::size_t>> crossed_before;
  std::vector<repair_place> crossing_places;
  for (const snapped_meeting& m : graph.meetings) {
    const point& p = graph.vertices[m.vertex];
    const auto place = [&] { return names_.at_segment(m.source); };
    if (m.crossed) {
      if (!crossed_before.insert({m.vertex, m.source, m.other}).second) continue;
      crossings.add(place, [&] {
        return names_.segment(m.source) + " and " + names_.segment(m.other) +
               names_.line_of_segment(m.other) + " at " + coordinates(p);
      });
      crossing_places.push_back({"crossing", p});
    } else if (bent_before.insert({m.vertex, m.source}).second) {
      bent.add(place, [&] { return names_.segment(m.source) + " at " + coordinates(p); });
      report_.places.push_back({"bent", p});
    }
  }
  report_.places.insert(report_.places.end(), crossing_places.begin(), crossing_places.end());
  bent.report("segments made to go through vertices within " + format_number(distance_ / 2),
              report_.messages);
  crossings.report("crossings made vertices", report_.messages);
}

void repairer::tell_trimmed(const snapped_graph& graph, const std::vector<snapped_piece>& trimmed) {
  repair_tally tally(report_.trimmed_segments);
  for (const snapped_piece& p : trimmed) {
    tally.add([&] { return names_.at_segment(p.source); },
              [&] {
                return names_.segment(p.source) + ", which ended at " +
                       coordinates(graph.vertices[p.a]);
              });
    report_.places.push_back({"trimmed", graph.vertices[p.a]});
  }
  tally.report("segments cut off beyond the boundary that they cross", report_.messages);
}

void repairer::measure_moves(const snapped_graph& graph) {
  double& most = report_.greatest_move;
  for (const snapped_piece& p : graph.pieces) {
    const segment& s = input_.segments[p.source];
    for (const vertex_index v : {p.a, p.b})
      most = std::max(
          most, distance_to_segment(graph.vertices[v], input_.vertices[s.a], input_.vertices[s.b]));
  }
  for (std::size_t v = 0; v < graph.joined_to.size(); ++v) {
    const point &from = input_.vertices[v], &to = input_.vertices[graph.joined_to[v]];
    most = std::max(most, elementary::hypot(to.x - from.x, to.y - from.y));
  }
}

domain repairer::assemble(const snapped_graph& graph) const {
  domain made;
  made.name = input_.name;
  made.number_all_regions = input_.number_all_regions;
  made.holes = input_.holes;
  made.regions = input_.regions;
  std::vector<vertex_index> number(graph.vertices.size(), 0);
  for (vertex_index v = 0; v < graph.vertices.size(); ++v) {
    if (v < graph.joined_to.size() && graph.joined_to[v] != v) continue;
    number[v] = static_cast<vertex_index>(made.vertices.size());
    made.vertices.push_back(graph.vertices[v]);
  }
  for (const snapped_piece& p : graph.pieces)
    made.segments.push_back({number[p.a], number[p.b], input_.segments[p.source].marker});
  made.polygons = polygons_of_pieces(input_, graph.pieces);
  return made;
}

void repairer::drop_holes(domain& repaired) {
  repair_tally dropped(report_.dropped_holes);
  std::vector<point> kept;
  for (std::size_t h = 0; h < repaired.holes.size(); ++h) {
    const point& hole = repaired.holes[h];
    const bool is_near =
        std::any_of(repaired.segments.begin(), repaired.segments.end(), [&](const segment& s) {
          const point &a = repaired.vertices[s.a], &b = repaired.vertices[s.b];
          const double reach = 2 * distance_;  // what is farther in one coordinate is not near
          if (hole.x < std::min(a.x, b.x) - reach || hole.x > std::max(a.x, b.x) + reach ||
              hole.y < std::min(a.y, b.y) - reach || hole.y > std::max(a.y, b.y) + reach)
            return false;
          return are_nearer(hole, a, distance_) || are_nearer(hole, b, distance_) ||
                 is_beside(hole, a, b, distance_);
        });
    if (!is_near) {
      kept.push_back(hole);
      continue;
    }
    dropped.add([&] { return names_.at_hole(h); }, [&] { return names_.hole(h); });
    report_.places.push_back({"hole dropped", hole});
  }
  repaired.holes = std::move(kept);
  dropped.report(
      "hole points dropped that are nearer to a segment than " + format_number(distance_),
      report_.messages);
}

void repairer::add(const domain_repairs& rest) {
  report_.merged_vertices += rest.merged_vertices;
  report_.segments_without_length += rest.segments_without_length;
  report_.split_segments += rest.split_segments;
  report_.repeated_subsegments += rest.repeated_subsegments;
  report_.outer_subsegments += rest.outer_subsegments;
  report_.dropped_vertices += rest.dropped_vertices;
  report_.dropped_area_limits += rest.dropped_area_limits;
  report_.flat_rings += rest.flat_rings;
  report_.shared_parts += rest.shared_parts;
  report_.messages.insert(report_.messages.end(), rest.messages.begin(), rest.messages.end());
}

// Returns the least distance that the coordinates allow: 8 units in the last place of the largest
// one.
double least_distance(const domain& d) {
  double largest = std::numeric_limits<double>::min();
  for (const point& p : d.vertices) largest = std::max({largest, std::abs(p.x), std::abs(p.y)});
  return 8 * (largest - std::nextafter(largest, 0.0));
}

}  // namespace

result<domain> repair_domain(const domain& input, std::optional<double> distance,
                             domain_repairs* repairs, const cancellation& stop) {
  domain_repairs unasked;
  domain_repairs& report = repairs != nullptr ? *repairs : unasked;
  if (auto failed = check_domain_values(input)) return failed->as(error_code::invalid_domain);
  if (!input.curves.empty())
    return error{domain_names(input).at_curve(0) +
                     "a domain with curves is not repaired (--repair-domain): what moves would "
                     "leave its curve",
                 error_code::invalid_domain};
  const bounding_box box = input.box();
  const double side = std::max(box.high.x - box.low.x, box.high.y - box.low.y);
  const double least = least_distance(input);
  if (!(side <= 1e150))
    return error{domain_names(input).at_start() + "more than 1e150 wide, which is not repaired",
                 error_code::invalid_domain};
  if (distance && !(*distance > 0 && *distance <= 1e150))
    return error{"the distance of a repair must be positive, at most 1e150",
                 error_code::bad_option};
  if (distance && *distance < least)
    return error{"the distance of a repair must be at least " + format_number(least) +
                     " here: the coordinates have no finer steps",
                 error_code::bad_option};
  constexpr int finest = -40, step = 4, coarsest = -12;
  result<domain> repaired = error{};
  for (int power = finest; power <= coarsest; power += step) {
    const double chosen = distance ? *distance : std::max(least, std::ldexp(side, power));
    repaired = repairer(input, chosen, report, stop).repair();
    if (repaired || distance || stop.is_requested()) break;
  }
  if (repaired) return repaired;
  return error{repaired.failure().message + " (after repairs up to a distance of " +
                   format_number(report.distance) + ")",
               error_code::invalid_domain};
}

}  // namespace asterism
