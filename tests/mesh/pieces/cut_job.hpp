// SPDX-License-Identifier: MIT
//
// A domain that is cut into pieces, for several tests.
#pragma once

#include <catch2/catch.hpp>
#include <memory>
#include <utility>

#include "asterism/mesh/domain/built_in_domains.hpp"
#include "asterism/mesh/domain/check_domain.hpp"
#include "asterism/mesh/metric/make_metric_field.hpp"
#include "asterism/mesh/pieces/domain_cut.hpp"
#include "asterism/mesh/pieces/piece_mesh.hpp"
#include "asterism/mesh/pieces/piece_shape.hpp"
#include "asterism/mesh/pieces/seam_points.hpp"

namespace asterism::internal {

// The square with a hole and a segment inside, as check_domain returns it.
inline domain holed_square() {
  domain d = square();
  const auto add = [&d](std::initializer_list<point> ring, bool closed, int marker) {
    const auto first = static_cast<vertex_index>(d.vertices.size());
    d.vertices.insert(d.vertices.end(), ring);
    const auto end = static_cast<vertex_index>(d.vertices.size());
    for (vertex_index v = first; v + 1 < end; ++v) d.segments.push_back({v, v + 1, marker});
    if (closed) d.segments.push_back({end - 1, first, marker});
  };
  add({{-0.6, -0.5}, {-0.2, -0.5}, {-0.3, -0.1}}, true, 5);
  add({{0.1, 0.3}, {0.6, 0.7}}, false, 6);
  d.holes.push_back({-0.4, -0.4});
  const auto checked = check_domain(d);
  REQUIRE(checked);
  return checked.value();
}

struct cut_job {
  domain shape;
  std::unique_ptr<metric_field> field;
  domain_cut cut;
  seam_points points;
};

inline cut_job cut_into(std::size_t pieces, const char* metric = "swirl:6", double size = 0.1) {
  cut_job job;
  job.shape = holed_square();
  auto field = make_metric_field(metric, job.shape.box(), size);
  REQUIRE(field);
  job.field = std::move(field).value();
  cut_wishes wishes;
  wishes.pieces = pieces;
  auto cut = cut_domain(job.shape, *job.field, wishes);
  REQUIRE(cut);
  job.cut = std::move(cut).value();
  auto points = divide_seams(job.shape, job.cut, *job.field);
  REQUIRE(points);
  job.points = std::move(points).value();
  return job;
}

inline mesh_options options_of_pieces() {
  mesh_options options;
  options.limit_size = true;
  options.metric_tolerance = 0;
  return options;
}

}  // namespace asterism::internal
