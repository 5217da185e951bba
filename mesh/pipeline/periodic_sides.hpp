// SPDX-License-Identifier: MIT
//
// Finds two sides of a domain that are to have the same points, the map from one to the other, and
// the places on both that go together.
//
// A side is the line of the segments with one marker. The domain is on the left of both: the first
// from its start to its end matches the second from its end to its start. Where a translation, or a
// turn by quarters and a shift, of two doubles takes the corners of the one to those of the other
// exactly, every further place is chosen so that its image is exact, too. Otherwise places match
// that are at the same parameter of their segments.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "asterism/core/result.hpp"
#include "asterism/mesh/audit/periodic_match.hpp"
#include "asterism/mesh/data/domain.hpp"

namespace asterism::internal {

// A rigid map of one side to the other: a turn, given by its cosine and sine, then a shift. Exact
// for the corners of the sides if the turn is by quarters.
struct side_map {
  bool is_exact = false;
  double cosine = 1, sine = 0;
  point shift;

  point turned(const point& q) const {
    return {cosine * q.x - sine * q.y, sine * q.x + cosine * q.y};
  }
  // Returns the image, rounded.
  point image(const point& q) const {
    const point t = turned(q);
    return {t.x + shift.x, t.y + shift.y};
  }
};

// A station: a place on both sides. It is a vertex of the domain on one side, on both, or on
// neither.
struct side_station {
  point first, second;
  std::optional<vertex_index> first_vertex, second_vertex;
};

// A pair of straight parts of both sides between two consecutive stations: `first_from` to
// `first_to` matches `second_from` to `second_to`.
struct side_interval {
  vertex_index first_segment = 0, second_segment = 0;
  point first_from, first_to, second_from, second_to;
};

class periodic_sides {
 public:
  // Matches the two sides. Fails, with a sentence that names both markers, where they cannot match.
  static result<periodic_sides> find(const domain& d, const periodic_pair& markers);

  const std::vector<side_station>& stations() const { return stations_; }
  // Returns the parts of both sides between consecutive stations.
  const std::vector<side_interval>& intervals() const { return intervals_; }
  const side_map& map() const { return map_; }

  // Adds stations near these places of the first side between two stations, in their order. Returns
  // the number of new ones: places without room among the doubles are left out. The map is no
  // longer exact if no near place has an exact image.
  std::size_t insert(std::size_t interval, const std::vector<point>& places);
  // Returns the approximate place on the first side that matches a place on the second.
  point first_of(std::size_t interval, const point& on_second) const;

 private:
  friend class side_finder;
  side_station station_at(const side_interval& in, const point& place);

  side_map map_;
  std::vector<side_station> stations_;
  std::vector<side_interval> intervals_;
};

}  // namespace asterism::internal
