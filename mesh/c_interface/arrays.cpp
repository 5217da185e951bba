// SPDX-License-Identifier: MIT
#include "asterism/mesh/c_interface/arrays.hpp"

#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <mutex>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "asterism/kernels/filtered_kernel.hpp"
#include "asterism/mesh/audit/audit.hpp"
#include "asterism/mesh/metric/interpolated_field.hpp"
#include "asterism/mesh/metric/make_metric_field.hpp"
#include "asterism/mesh/support/tensor_text.hpp"

namespace asterism::internal {
namespace {

// A metric field that calls a function of the caller. One call at a time: the caller may be an
// interpreter.
class called_field final : public metric_field {
 public:
  called_field(const asterism_metric& functions, double size)
      : single_(functions.function),
        batch_(functions.batch_function),
        context_(functions.context),
        divisor_(size * size) {}

  result<metric_tensor> at(const point& q) const override {
    std::array<double, 3> m{};
    {
      const std::lock_guard<std::mutex> alone(lock_);
      const auto known = remembered_.find({q.x, q.y});
      if (known != remembered_.end())
        m = known->second;
      else if (!ask(q, m))
        return error{"the metric's function failed at " + point_text(q)};
    }
    const metric_tensor tensor = {m[0] / divisor_, m[1] / divisor_, m[2] / divisor_};
    const bool finite =
        std::isfinite(tensor.m11) && std::isfinite(tensor.m12) && std::isfinite(tensor.m22);
    if (!finite || !filtered_kernel().is_positive_definite(tensor))
      return error{"the metric at " + point_text(q) + " is " + tensor_text({m[0], m[1], m[2]}) +
                   ", which is not positive definite"};
    return tensor;
  }

  // Calls the function for the places not known yet, each once. If the function fails, `at` finds
  // the place at fault.
  void expect(const std::function<std::vector<point>()>& places) const override {
    if (batch_ == nullptr) return;
    const std::lock_guard<std::mutex> alone(lock_);
    std::vector<double> asked;
    std::set<place> once;
    for (const point& q : places()) {
      if (remembered_.count({q.x, q.y}) != 0 || !once.insert({q.x, q.y}).second) continue;
      asked.insert(asked.end(), {q.x, q.y});
    }
    const std::size_t count = asked.size() / 2;
    std::vector<double> metrics(3 * count);
    if (count == 0 || batch_(context_, count, asked.data(), metrics.data()) != 0) return;
    for (std::size_t k = 0; k < count; ++k)
      remembered_[{asked[2 * k], asked[2 * k + 1]}] = {metrics[3 * k], metrics[3 * k + 1],
                                                       metrics[3 * k + 2]};
  }

 private:
  using place = std::pair<double, double>;

  bool ask(const point& q, std::array<double, 3>& m) const {
    if (single_ != nullptr) return single_(context_, q.x, q.y, m.data()) == 0;
    const std::array<double, 2> one = {q.x, q.y};
    return batch_(context_, 1, one.data(), m.data()) == 0;
  }

  asterism_metric_function single_;
  asterism_metric_batch_function batch_;
  void* context_;
  double divisor_;
  mutable std::mutex lock_;
  mutable std::map<place, std::array<double, 3>> remembered_;
};

using made_field = result<std::unique_ptr<metric_field>>;

made_field sampled_field(const asterism_metric& metric, double size) {
  if (metric.vertices == nullptr || metric.tensors == nullptr || metric.triangles == nullptr)
    return error{"the metric's mesh has no vertices, tensors or triangles"};
  const auto background =
      mesh_of({metric.vertex_count, metric.vertices, 2}, {metric.vertex_count, metric.tensors, 3},
              {metric.triangle_count, metric.triangles});
  if (!background) return error{"the metric's mesh: " + background.failure().message};
  audit_options options;
  options.check_stars = false;
  options.angle_bound = 0;
  options.first_number = background.value().first_number;
  const audit_report found = audit(background.value().subject, options);
  if (!found.certified)
    return error{"the metric's mesh is no triangulation: " + found.findings.at(0).witness};
  return make_interpolated_field(background.value().subject, size);
}

// Adds the curves. divide_curves refuses the ones that are invalid as curves.
std::optional<error> add_curves(const asterism_domain& arrays, domain& d) {
  for (std::size_t k = 0; k < arrays.curve_count; ++k) {
    const std::string name = "curve " + std::to_string(k);
    const unsigned s = arrays.curve_segments[k];
    if (s >= d.segments.size())
      return error{name + " is of segment " + std::to_string(s) + " of " +
                   std::to_string(d.segments.size())};
    const int kind = arrays.curve_kinds != nullptr ? arrays.curve_kinds[k] : ASTERISM_CUBIC;
    if (kind < ASTERISM_CUBIC || kind > ASTERISM_CLOCKWISE_ARC)
      return error{name + " is of kind " + std::to_string(kind) + ", which there is not"};
    const double* const at = arrays.curve_points + 4 * k;
    domain_curve curve;
    curve.kind = kind == ASTERISM_CUBIC ? curve_kind::cubic : curve_kind::arc;
    if (curve.kind == curve_kind::cubic) curve.control = {{{at[0], at[1]}, {at[2], at[3]}}};
    if (curve.kind == curve_kind::arc) curve.centre = {at[0], at[1]};
    curve.clockwise = kind == ASTERISM_CLOCKWISE_ARC;
    curve.vertices = {d.segments[s].a, d.segments[s].b};
    curve.parameters = {0, 1};
    curve.segment = s;
    d.origin.curve_numbers.push_back(k);
    d.curves.push_back(std::move(curve));
  }
  return std::nullopt;
}

}  // namespace

result<domain> domain_of(const asterism_domain& arrays) {
  const auto missing = [](std::size_t count, const void* array) {
    return count > 0 && array == nullptr;
  };
  if (missing(arrays.vertex_count, arrays.vertices) ||
      missing(arrays.segment_count, arrays.segments) || missing(arrays.hole_count, arrays.holes) ||
      missing(arrays.region_count, arrays.regions) ||
      missing(arrays.region_count, arrays.region_numbers) ||
      missing(arrays.curve_count, arrays.curve_segments) ||
      missing(arrays.curve_count, arrays.curve_points))
    return error{"an array of the domain is null although its count is not 0"};
  if (arrays.vertex_count > std::numeric_limits<vertex_index>::max())
    return error{"the domain has too many vertices"};
  domain d;
  d.origin.first_number = 0;
  const auto point_at = [](const double* numbers, std::size_t k) {
    return point{numbers[2 * k], numbers[2 * k + 1]};
  };
  for (std::size_t k = 0; k < arrays.vertex_count; ++k)
    d.vertices.push_back(point_at(arrays.vertices, k));
  for (std::size_t k = 0; k < arrays.segment_count; ++k)
    d.segments.push_back({arrays.segments[2 * k], arrays.segments[2 * k + 1],
                          arrays.segment_markers != nullptr ? arrays.segment_markers[k] : 0});
  for (std::size_t k = 0; k < arrays.hole_count; ++k) d.holes.push_back(point_at(arrays.holes, k));
  for (std::size_t k = 0; k < arrays.region_count; ++k)
    d.regions.push_back({point_at(arrays.regions, k), arrays.region_numbers[k]});
  if (auto refused = add_curves(arrays, d)) return *refused;
  return d;
}

made_field field_of(const asterism_metric& metric, const bounding_box& box) {
  const bool is_called = metric.function != nullptr || metric.batch_function != nullptr;
  const int kinds = (metric.specification != nullptr) + is_called + (metric.triangle_count > 0);
  if (kinds != 1)
    return error{"the metric must be one of a specification, a function and a mesh with tensors"};
  const double size = metric.size == 0 ? 1 : metric.size;
  if (!(size > 0 && std::isfinite(size)))
    return error{"the metric's size must be positive and finite"};
  if (metric.specification != nullptr) return make_metric_field(metric.specification, box, size);
  if (metric.triangle_count > 0) return sampled_field(metric, size);
  std::unique_ptr<metric_field> field = std::make_unique<called_field>(metric, size);
  return made_field(std::move(field));
}

result<adopted_mesh> mesh_of(const number_rows& places, const number_rows& tensors,
                             const triangle_rows& triangles) {
  if (places.count > std::numeric_limits<vertex_index>::max())
    return error{"the mesh has too many vertices"};
  mesh m;
  for (std::size_t k = 0; k < places.count; ++k) {
    const double* const at = places.first + k * places.stride;
    const double* const tensor = tensors.first + k * tensors.stride;
    m.sites.push_back({{at[0], at[1]}, {tensor[0], tensor[1], tensor[2]}});
  }
  m.given = static_cast<vertex_index>(places.count);
  for (std::size_t k = 0; k < triangles.count; ++k) {
    const unsigned* const corners = triangles.first + 3 * k;
    m.triangles.push_back({corners[0], corners[1], corners[2]});
  }
  constexpr int first_number = 0;
  return adopt_mesh(std::move(m), region_edges::segments, slit_rule::joined, first_number);
}

}  // namespace asterism::internal
