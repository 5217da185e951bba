// SPDX-License-Identifier: MIT
#include "asterism/mesh/pipeline/mesh_input.hpp"

#include <algorithm>
#include <utility>

#include "asterism/mesh/domain/built_in_domains.hpp"
#include "asterism/mesh/domain/divide_curves.hpp"
#include "asterism/mesh/metric/local_sizes.hpp"
#include "asterism/mesh/pipeline/layer_rows.hpp"

namespace asterism {
namespace {

scale_demand demand_of(const mesh_source& source, const mesh_options& options, double density,
                       const domain& d) {
  scale_demand wanted = source.scale;
  if (options.vertices) {
    wanted.size.reset();
    wanted.complexity = density * complexity_of_vertices(*options.vertices);
    wanted.vertices = options.vertices;
  }
  if (!wanted.size && !wanted.complexity && !wanted.sizes.is_empty())
    wanted.size = size_where_none_is_wished(wanted.sizes, d);
  return wanted;
}

result<scaled_metric> metric_on(const domain& d, const mesh_source& source,
                                const mesh_options& options, double density) {
  const field_of_size in_box = [&source, box = d.box()](double size) {
    return source.metric(size, box);
  };
  return make_scaled_metric(d, in_box, demand_of(source, options, density, d));
}

result<domain> divided(const mesh_source& source, const mesh_options& options, double density) {
  if (source.shape.curves.empty() || !(options.limit_size || source.chord_tolerance))
    return source.shape;
  curve_division chords;
  chords.chord_tolerance = source.chord_tolerance;
  chords.most_chords = options.max_sites;
  if (!options.limit_size) return divide_curves_anew(source.shape, chords);
  const auto rough = metric_on(source.shape, source, options, density);
  if (!rough) return rough.failure();
  chords.field = rough.value().field.get();
  return divide_curves_anew(source.shape, chords);
}

}  // namespace

result<mesh_input> prepare_mesh_input(const mesh_source& source, const mesh_options& options,
                                      double density) {
  auto shape = divided(source, options, density);
  if (!shape) return shape.failure();
  shape = add_random_points(std::move(shape).value(), source.random_points, options.seed);
  if (!shape) return shape.failure();
  const std::size_t given = shape.value().vertices.size();
  auto metric = metric_on(shape.value(), source, options, density);
  if (metric && !source.scale.sizes.layers.empty()) {
    const std::size_t room = options.max_sites - std::min(options.max_sites, given);
    shape =
        with_layer_rows(std::move(shape).value(), source.scale.sizes, *metric.value().field, room);
    if (!shape) return shape.failure();
    metric = metric_on(shape.value(), source, options, density);
  }
  if (!metric) return metric.failure();
  return mesh_input{std::move(shape).value(), std::move(metric).value(), given};
}

}  // namespace asterism
