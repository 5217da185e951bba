// SPDX-License-Identifier: MIT
#include "asterism/mesh/delivery/metric_delivery.hpp"

#include <cmath>
#include <limits>
#include <numbers>
#include <utility>
#include <vector>

#include "asterism/core/elementary.hpp"
#include "asterism/mesh/delivery/background.hpp"
#include "asterism/mesh/delivery/delivered_metric.hpp"
#include "asterism/mesh/delivery/domain_background.hpp"
#include "asterism/mesh/delivery/local_adaptation.hpp"
#include "asterism/mesh/domain/point_in_domain.hpp"
#include "asterism/mesh/metric/background_field.hpp"
#include "asterism/mesh/metric/background_metric.hpp"
#include "asterism/mesh/numerics/metric_length.hpp"
#include "asterism/mesh/numerics/scaled_tensor.hpp"
#include "asterism/mesh/refine/coarser_mesh.hpp"

namespace asterism::internal {
namespace {

// Number of vertices of a mesh whose edges have length 1, for each unit of its area.
constexpr double vertices_of_unit = 2 / std::numbers::sqrt3;

mesh in_frame(const unit_frame& frame, const mesh& m) {
  mesh image = m;
  for (site& s : image.sites) s = {frame.inward(s.position), frame.inward(s.metric)};
  return image;
}

// Returns the mesh with all tensors times 2^k; none if that is not exact.
std::optional<mesh> exactly_times_power_of_two(const mesh& m, int k) {
  mesh made = m;
  for (site& s : made.sites) {
    const metric_tensor before = s.metric;
    s.metric = times_power_of_two(before, k);
    if (!identical(times_power_of_two(s.metric, -k), before)) return std::nullopt;
  }
  return made;
}

// Returns the metric at the background's nodes. Shares the index of triangles of a field that is
// interpolated on this mesh in the same frame: building the index of a large mesh takes as long as
// reading the mesh.
background_metric metric_at_nodes(const mesh& background, const background_field* field) {
  if (field == nullptr) return background_metric(background);
  background_metric shared = field->without_size();
  std::vector<metric_tensor> tensors;
  tensors.reserve(background.sites.size());
  for (const site& s : background.sites) tensors.push_back(s.metric);
  shared.set_tensors(std::move(tensors));
  return shared;
}

}  // namespace

bool may_adapt(const mesh_options& options) {
  return options.strategy == refinement_strategy::fill && !options.tolerance;
}

metric_delivery::metric_delivery(const domain& d, const metric_field& field,
                                 const mesh_options& options)
    : field_(field),
      given_(background_of_domain(d, field)),
      options_(options),
      image_(d, field, options) {}

// Makes the coarse mesh and the background, once; returns false if there are none.
bool metric_delivery::prepare() {
  if (prepared_) return start_ && background_ != nullptr;
  prepared_ = true;
  start_ = coarse_mesh(image_.shape(), image_.field(), options_);
  if (!start_) return false;
  if (given_ != nullptr) {
    if (!image_.frame().is_identity()) made_background_ = in_frame(image_.frame(), *given_);
    background_ = made_background_ ? &*made_background_ : given_;
    return true;
  }
  constexpr double any_length = std::numeric_limits<double>::infinity();
  auto sampled = sample_field(image_.shape(), *start_, image_.field(), any_length, options_.stop);
  if (!sampled) return false;
  background_ = &made_background_.emplace(std::move(sampled->nodes));
  longest_ = sampled->longest;
  return true;
}

bool metric_delivery::is_first_choice() const {
  return options_.limit_size && !options_.keep_if_complete &&
         (given_ != nullptr || options_.vertices);
}

bool metric_delivery::varies_fast() {
  constexpr double most_that_is_met = 0.6;
  return options_.limit_size && given_ == nullptr && prepare() &&
         sampled_variation(*background_) > most_that_is_met;
}

bool metric_delivery::jumps() const {
  // Variation above which stars are expected to disagree: twice the greatest variation with which a
  // mesh in the wanted metric itself was made.
  constexpr double most_that_is_met = 3;
  constexpr std::size_t one_in = 200;
  return given_ != nullptr && sampled_variation(*given_, one_in) > most_that_is_met;
}

bool metric_delivery::wants_few_sites() const {
  constexpr int in_a_row = 24;
  constexpr double few = 30000;
  constexpr std::size_t most_vertices = 200;  // each place is held against all segments
  const domain& d = image_.shape();
  if (d.vertices.size() > most_vertices) return false;
  const bounding_box box = d.box();
  const point cell{(box.high.x - box.low.x) / in_a_row, (box.high.y - box.low.y) / in_a_row};
  std::vector<point> places;
  for (int i = 0; i < in_a_row; ++i)
    for (int k = 0; k < in_a_row; ++k) {
      const point q{box.low.x + (i + 0.5) * cell.x, box.low.y + (k + 0.5) * cell.y};
      if (contains(d, q)) places.push_back(q);
    }
  image_.field().expect([&places] { return places; });
  double roots = 0;
  for (const point& q : places) {
    const auto there = image_.field().at(q);
    if (!there) return false;
    roots += plain_root_of_determinant(there.value());
  }
  return vertices_of_unit * roots * cell.x * cell.y < few;
}

// Returns how often the number of sites is to be halved: until there is room for them, or, without
// a size, until there are about `few`.
std::optional<int> metric_delivery::halvings(double vertices, std::size_t few) const {
  constexpr double part_of_limit = 0.8;
  const double most = part_of_limit * static_cast<double>(options_.max_sites);
  if (!(vertices > 0) || !std::isfinite(vertices)) return std::nullopt;
  const double times = elementary::log2(vertices / static_cast<double>(few));
  if (!options_.limit_size) return static_cast<int>(std::lround(times));
  return std::max(0, static_cast<int>(std::ceil(elementary::log2(vertices / most))));
}

// Returns the metric wanted, divided by 2^halved. A formula is sampled as densely as the sites will
// be, unless the present samples suffice.
std::optional<background_metric> metric_delivery::wanted_in(
    const metric_field& coarser, int halved, const background_metric& sampled) const {
  constexpr double as_sites = 1;
  const bool is_formula = given_ == nullptr;
  if (halved == 0 && (!is_formula || longest_ <= as_sites)) return sampled;
  if (is_formula) {
    auto fine = sample_field(image_.shape(), *start_, coarser, as_sites, options_.stop);
    if (!fine) return std::nullopt;
    return background_metric(fine->nodes);
  }
  mesh background = *background_;
  const double factor = elementary::exp2(-halved);
  for (site& s : background.sites) s.metric = times(s.metric, factor);
  return background_metric(background);
}

std::optional<mesh_outcome> metric_delivery::make(std::size_t few) {
  if (!prepare()) return std::nullopt;
  const bool is_as_given = given_ != nullptr && image_.frame().is_identity();
  const background_metric sampled = metric_at_nodes(
      *background_, is_as_given ? dynamic_cast<const background_field*>(&field_) : nullptr);
  const auto halved = halvings(vertices_of_unit * sampled.complexity(), few);
  if (!halved) return std::nullopt;
  const coarser_field coarser(image_.field(), *halved);
  auto wanted = wanted_in(coarser, *halved, sampled);
  if (!wanted) return std::nullopt;
  const double count = *halved == 0 && options_.vertices ? static_cast<double>(*options_.vertices)
                                                         : vertices_of_unit * wanted->complexity();
  if (!(count < static_cast<double>(options_.max_sites))) return std::nullopt;
  auto made = adapt_by_local_changes({image_.shape(), coarser, options_, *start_, *wanted,
                                      given_ != nullptr, static_cast<std::size_t>(count)});
  if (!made) return std::nullopt;
  return in_given_units(std::move(*made), *halved);
}

// Scales all tensors by the power of two that brings their density nearest to the one wanted, where
// more than half of the sites have a tensor far from the wanted one, and where that brings them
// nearer. Where a metric turns by any angle from node to node, each clip of two crossed tensors
// makes both denser, as the coarser side takes more of the excess. Stars and angles stay the same
// to the last bit; edge lengths change by the same factor in both metrics.
void metric_delivery::bring_density_near(mesh_outcome& made) const {
  const delivered_report before = *made.delivered;
  const double power = elementary::log2(before.complexity_wanted / before.complexity_delivered);
  constexpr double most = 1000;  // a double has no more
  if (!(std::abs(power) < most)) return;
  const int k = static_cast<int>(std::lround(power));
  auto scaled = k == 0 ? std::nullopt : exactly_times_power_of_two(made.result, k);
  if (!scaled) return;
  auto compared = compare_with_wanted(*scaled, field_, options_.angle_bound, made.audited.get());
  if (!compared) return;
  const delivered_report& after = compared.value();
  if (!(after.median < before.median) || after.greatest > before.greatest) return;
  made.result = *std::move(scaled);
  made.audited.reset();
  made.delivered = std::move(compared).value();
  made.delivered->length_factor = before.length_factor * elementary::exp2(k / 2.0);
}

std::optional<mesh_outcome> metric_delivery::in_given_units(mesh_outcome made, int halved) {
  restore_lengths(halved, made);
  image_.outward(made);
  if (halved != 0 || !image_.frame().is_identity()) made.audited.reset();
  if (!made.complete) return made;
  const double length_factor = made.delivered->length_factor;
  auto compared =
      compare_with_wanted(made.result, field_, options_.angle_bound, made.audited.get());
  if (!compared) return std::nullopt;
  made.delivered = std::move(compared).value();
  made.delivered->length_factor = length_factor;
  if (made.delivered->median > most_median_distance) bring_density_near(made);
  if (options_.limit_size) report_coarser(halved, false, options_, made);
  return made;
}

}  // namespace asterism::internal
