// SPDX-License-Identifier: MIT
#include "asterism/mesh/pipeline/periodic_division.hpp"

#include <algorithm>
#include <map>
#include <utility>

#include "asterism/mesh/fill/segment_division.hpp"
#include "asterism/mesh/numerics/metric_algebra.hpp"
#include "asterism/mesh/numerics/triangle_quality.hpp"

namespace asterism::internal {
namespace {

// Metric field along the first side, at least as fine in every direction as that on either side.
class finer_of_sides final : public metric_field {
 public:
  finer_of_sides(const metric_field& field, const side_map& map) : field_(field), map_(map) {}

  result<metric_tensor> at(const point& q) const override {
    const auto here = field_.at(q), there = field_.at(map_.image(q));
    if (!here) return here;
    if (!there) return there;
    const metric_tensor back = turned(there.value(), map_.cosine, -map_.sine);
    return identical(here.value(), back) ? here : intersection(here.value(), back);
  }

 private:
  const metric_field& field_;
  const side_map& map_;
};

// Points of a mesh on each segment, from the segment's start to its end.
using points_on_segment = std::vector<std::vector<point>>;

points_on_segment points_between(const domain& d, const mesh& m) {
  std::vector<std::map<vertex_index, vertex_index>> next(d.segments.size());
  for (const boundary_edge& e : m.boundary) next[e.segment][e.a] = e.b;
  points_on_segment found(d.segments.size());
  for (std::size_t s = 0; s < d.segments.size(); ++s)
    for (auto step = next[s].find(d.segments[s].a);
         step != next[s].end() && step->second != d.segments[s].b;
         step = next[s].find(step->second)) {
      found[s].push_back(m.sites[step->second].position);
      if (found[s].size() > next[s].size()) break;
    }
  return found;
}

}  // namespace

std::optional<error> divide_by_length(const metric_field& field, double unit, std::size_t most,
                                      periodic_sides& sides) {
  domain line;
  for (const side_station& station : sides.stations()) line.vertices.push_back(station.first);
  for (vertex_index i = 0; i < sides.intervals().size(); ++i) line.segments.push_back({i, i + 1});
  const side_map map = sides.map();
  const auto divided =
      divide_segments(line, finer_of_sides(field, map), unit * longest_subsegment_of_fill, most);
  if (!divided) return divided.failure();
  if (divided.value().of_each.empty()) return std::nullopt;
  for (std::size_t i = line.segments.size(); i-- > 0;) {
    const std::vector<point>& points = divided.value().of_each[i].points;
    if (points.size() > 2) sides.insert(i, {points.begin() + 1, points.end() - 1});
  }
  return std::nullopt;
}

periodic_division::periodic_division(const domain& d, const std::vector<periodic_sides>& all)
    : shape_(d), given_(static_cast<vertex_index>(d.vertices.size())), between_(d.segments.size()) {
  shape_.origin.vertex_lines.clear();
  shape_.origin.segment_lines.clear();
  add_vertices(all);
  divide(d);
}

// Numbers the stations. The stations of a second side come in the order opposite to its segments.
// So the list of each segment there, whose numbers ascend, is reversed once.
void periodic_division::add_vertices(const std::vector<periodic_sides>& all) {
  for (const periodic_sides& sides : all) {
    const std::vector<side_station>& stations = sides.stations();
    std::vector<std::array<vertex_index, 2>>& vertices =
        station_vertices_.emplace_back(stations.size());
    for (std::size_t i = 0; i < stations.size(); ++i) {
      const side_station& station = stations[i];
      const auto place = [this](const std::optional<vertex_index>& given, const point& q) {
        if (given) return *given;
        shape_.vertices.push_back(q);
        return static_cast<vertex_index>(shape_.vertices.size() - 1);
      };
      vertices[i] = {place(station.first_vertex, station.first),
                     place(station.second_vertex, station.second)};
      if (!station.first_vertex)
        between_[sides.intervals()[i].first_segment].push_back(vertices[i][0]);
      if (!station.second_vertex)
        between_[sides.intervals()[i].second_segment].push_back(vertices[i][1]);
    }
    for (const side_interval& in : sides.intervals()) {
      std::vector<vertex_index>& along = between_[in.second_segment];
      if (along.size() > 1 && along.front() < along.back())
        std::reverse(along.begin(), along.end());
    }
  }
}

void periodic_division::divide(const domain& d) {
  shape_.segments.clear();
  for (vertex_index s = 0; s < d.segments.size(); ++s) {
    segment part = d.segments[s];
    for (const vertex_index v : between_[s]) {
      part.b = v;
      shape_.segments.push_back(part);
      segment_of_.push_back(s);
      part.a = v;
    }
    part.b = d.segments[s].b;
    shape_.segments.push_back(part);
    segment_of_.push_back(s);
  }
}

std::size_t periodic_division::take_splits(const mesh& m, std::vector<periodic_sides>& all) const {
  const points_on_segment found = points_between(shape_, m);
  std::map<std::pair<vertex_index, vertex_index>, std::size_t> segment_at;  // by its start and end
  for (std::size_t s = 0; s < shape_.segments.size(); ++s)
    segment_at[{shape_.segments[s].a, shape_.segments[s].b}] = s;
  std::size_t added = 0;
  for (std::size_t p = 0; p < all.size(); ++p) {
    const std::vector<std::array<vertex_index, 2>>& at = station_vertices_[p];
    for (std::size_t i = at.size() - 1; i-- > 0;) {
      std::vector<point> places = found[segment_at.at({at[i][0], at[i + 1][0]})];
      if (places.empty()) {
        places = found[segment_at.at({at[i + 1][1], at[i][1]})];
        std::reverse(places.begin(), places.end());
        for (point& q : places) q = all[p].first_of(i, q);
      }
      if (!places.empty()) added += all[p].insert(i, places);
    }
  }
  return added;
}

void periodic_division::restore(mesh_outcome& made) const {
  mesh& m = made.result;
  m.given = given_;
  for (boundary_edge& e : m.boundary) e.segment = segment_of_[e.segment];
  made.splits += shape_.vertices.size() - given_;
  made.audited.reset();
}

}  // namespace asterism::internal
