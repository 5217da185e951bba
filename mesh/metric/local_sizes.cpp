// SPDX-License-Identifier: MIT
#include "asterism/mesh/metric/local_sizes.hpp"

#include <algorithm>
#include <optional>
#include <set>
#include <string>
#include <utility>

#include "asterism/core/number_text.hpp"
#include "asterism/mesh/domain/point_in_domain.hpp"
#include "asterism/mesh/metric/sized_field.hpp"
#include "asterism/mesh/metric/wall_layers.hpp"
#include "asterism/mesh/numerics/metric_bounds.hpp"
#include "asterism/mesh/search/place_tree.hpp"
#include "asterism/mesh/support/first_numbers.hpp"

namespace asterism {
using namespace internal;
namespace {

// A region with a size for its inside. Sizes outside grow from its border, which is listed among
// the places.
struct sized_region {
  inside_index inside;
  double size;
};

class locally_sized_field : public metric_field {
 public:
  locally_sized_field(std::unique_ptr<metric_field> base, wall_layers layers, place_tree places,
                      std::vector<sized_region> regions, const size_bounds& bounds)
      : base_(std::move(base)),
        layers_(std::move(layers)),
        places_(std::move(places)),
        regions_(std::move(regions)),
        bounds_(bounds) {}

  result<metric_tensor> at(const point& q) const override {
    const auto base = base_->at(q);
    if (!base) return base;
    size_bounds here = bounds_;
    here.greatest = std::max(std::min(bounds_.greatest, size_at(q)), bounds_.least);
    std::uint8_t unused = 0;
    return checked_tensor(q, bounded(layers_.added_to(base.value(), q), here, unused));
  }
  void expect(const std::function<std::vector<point>()>& places) const override {
    base_->expect(places);
  }

 private:
  double size_at(const point& q) const {
    double size = places_.least_at(q).size;
    for (const sized_region& r : regions_)
      if (r.size < size && r.inside.contains(q)) size = r.size;
    return size;
  }

  std::unique_ptr<metric_field> base_;
  wall_layers layers_;
  place_tree places_;
  std::vector<sized_region> regions_;
  size_bounds bounds_;
};

error no_marker(const domain& d, int marker) {
  std::set<int> there;
  for (const segment& s : d.segments) there.insert(s.marker);
  return {"no segment has the marker " + std::to_string(marker) +
              "; the markers there are: " + first_numbers(there),
          error_code::bad_option};
}

error no_region(const domain& d, int region) {
  std::set<int> there;
  for (const segment& s : d.segments) {
    there.insert(s.left_region);
    if (s.internal) there.insert(s.right_region);
  }
  return {"there is no region " + std::to_string(region) +
              "; the regions there are: " + first_numbers(there),
          error_code::bad_option};
}

void add_places_without_shape(const size_wishes& wishes, std::vector<sized_place>& places) {
  for (const size_at& w : wishes.at)
    places.push_back({w.centre, w.centre, w.radius, false, w.size, w.growth - 1});
  for (const size_in_box& w : wishes.boxes)
    places.push_back({w.box.low, w.box.high, 0, true, w.size, w.growth - 1});
}

void add_border(const domain& d, const size_in_region& w, std::vector<sized_place>& places) {
  for (const segment& s : d.segments)
    if (s.left_region == w.region || (s.internal && s.right_region == w.region))
      places.push_back({d.vertices[s.a], d.vertices[s.b], 0, false, w.size, w.growth - 1});
}

std::optional<error> add_boundary(const domain& d, const size_near& w,
                                  std::vector<sized_place>& places) {
  const std::size_t before = places.size();
  for (const segment& s : d.segments)
    if (s.marker == w.marker)
      places.push_back({d.vertices[s.a], d.vertices[s.b], 0, false, w.size, w.growth - 1});
  if (places.size() == before) return no_marker(d, w.marker);
  return std::nullopt;
}

}  // namespace

double size_where_none_is_wished(const size_wishes& wishes, const domain& d) {
  const bounding_box box = d.box();
  return std::min(wishes.greatest, std::max(box.high.x - box.low.x, box.high.y - box.low.y));
}

result<std::unique_ptr<metric_field>> with_local_sizes(std::unique_ptr<metric_field> base,
                                                       const domain& d, const size_wishes& wishes) {
  if (wishes.is_empty()) return base;
  if (!(wishes.least < wishes.greatest))
    return error{"hmin " + number_text(wishes.least) + " is not less than hmax " +
                     number_text(wishes.greatest),
                 error_code::bad_option};
  std::vector<sized_place> places;
  add_places_without_shape(wishes, places);
  for (const size_near& w : wishes.near)
    if (auto failed = add_boundary(d, w, places)) return *failed;
  std::vector<sized_region> regions;
  for (const size_in_region& w : wishes.regions) {
    add_border(d, w, places);
    regions.push_back({inside_index(d, w.region), w.size});
    if (regions.back().inside.is_empty()) return no_region(d, w.region);
  }
  wall_layers layers(d, wishes.layers);
  for (std::size_t i = 0; i < wishes.layers.size(); ++i)
    if (!layers.found()[i]) return no_marker(d, wishes.layers[i].marker);
  return std::unique_ptr<metric_field>(std::make_unique<locally_sized_field>(
      std::move(base), std::move(layers), place_tree(std::move(places)), std::move(regions),
      size_bounds{wishes.least, wishes.greatest, wishes.aspect}));
}

}  // namespace asterism
