// SPDX-License-Identifier: MIT
#include "asterism/mesh/solution/field_derivatives.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "asterism/mesh/numerics/metric_algebra.hpp"
#include "asterism/mesh/solution/computed_field.hpp"
#include "asterism/mesh/solution/mean_moduli.hpp"
#include "asterism/mesh/solution/relative_error.hpp"

namespace asterism::internal {
namespace {

// Returns the exponent of the power of two by which the values of a field are divided before their
// derivatives are computed, from their greatest modulus; 0 for moduli of ordinary size.
int power_of(double greatest) {
  constexpr int ordinary = 200;  // of 1023: room for squares, and for the sizes of triangles
  const int power = greatest > 0 ? std::ilogb(greatest) : 0;
  return std::abs(power) > ordinary ? power : 0;
}

int power_of(const std::vector<double>& values) {
  double greatest = 0;
  for (const double u : values) greatest = std::max(greatest, std::abs(u));
  return power_of(greatest);
}

int power_of(const std::vector<metric_tensor>& second) {
  double greatest = 0;
  for (const metric_tensor& h : second)
    greatest = std::max({greatest, std::abs(h.m11), std::abs(h.m12), std::abs(h.m22)});
  return power_of(greatest);
}

void divide(std::vector<double>& values, int power) {
  for (double& u : values) u = std::scalbn(u, -power);
}

void divide(std::vector<metric_tensor>& second, int power) {
  for (metric_tensor& h : second)
    h = {std::scalbn(h.m11, -power), std::scalbn(h.m12, -power), std::scalbn(h.m22, -power)};
}

template <class Field>
std::vector<const Field*> by_name(const std::vector<Field>& fields) {
  std::vector<const Field*> sorted;
  sorted.reserve(fields.size());
  for (const Field& f : fields) sorted.push_back(&f);
  std::sort(sorted.begin(), sorted.end(),
            [](const auto* a, const auto* b) { return a->name < b->name; });
  return sorted;
}

// Second derivatives of one field, as recovered and as moduli.
struct one_field {
  recovered_hessian recovered;
  std::vector<metric_tensor> moduli;
};

// Returns the tensors of which the metric is made: with the method `green` means of moduli over
// triangles. The mean is a plain one for a relative error, as in adaptmesh, and for fields computed
// in linear elements: their second derivatives have noise, and peaks of these are mostly noise,
// which the plain mean removes. Errors of solutions are 2 to 5 % less with it
// (docs/results/adaptation.md).
std::vector<metric_tensor> moduli_of(const mesh& m, const mesh_links& links,
                                     const std::vector<metric_tensor>& hessian, bool is_computed,
                                     const solution_metric_options& options) {
  if (options.hessian != hessian_method::green) return hessian;
  if (options.relative || is_computed) return mean_moduli(m, links, hessian);
  return mean_moduli_with_peaks(m, links, hessian, power_averaged(options.norm));
}

result<one_field> derivatives_of(const mesh& m, const mesh_links& links,
                                 const std::vector<double>& values, bool is_computed,
                                 const solution_metric_options& options) {
  auto hessian = recover_hessian(m, values, options.hessian);
  if (!hessian) return hessian.failure();
  one_field made{std::move(hessian).value(), {}};
  made.moduli = moduli_of(m, links, made.recovered.at, is_computed, options);
  return made;
}

// Keeps the values of the mesh's own vertices, equal for periodic partners but for the turn.
void take_own(const glued_mesh& glued, std::size_t own, one_field& found) {
  for (auto* tensors : {&found.recovered.at, &found.moduli}) {
    tensors->resize(own);
    for (const glued_vertices& one : glued.partners)
      (*tensors)[one.second] = turned((*tensors)[one.first], one.cosine, one.sine);
  }
  const auto& at = found.recovered.at;
  found.recovered.noise =
      static_cast<std::size_t>(std::count_if(at.begin(), at.end(), [](const metric_tensor& h) {
        return identical(h, {0, 0, 0});
      }));
  auto& means = found.recovered.means;
  std::erase_if(means, [own](vertex_index v) { return v >= own; });
  found.recovered.at_boundary = means.size();
}

result<one_field> glued_derivatives_of(const glued_mesh& glued, const mesh_links& links,
                                       const std::vector<double>& values, bool is_computed,
                                       const solution_metric_options& options) {
  std::vector<double> continued;
  continued.reserve(glued.origin.size());
  for (const vertex_index v : glued.origin) continued.push_back(values[v]);
  auto found = derivatives_of(glued.continued, links, continued, is_computed, options);
  if (found) take_own(glued, values.size(), found.value());
  return found;
}

}  // namespace

result<field_derivatives> recovered_derivatives(const mesh& m, const mesh_links& links,
                                                const std::vector<nodal_values>& fields,
                                                const solution_metric_options& options,
                                                const glued_mesh* glued) {
  const std::optional<mesh_links> beyond =
      glued != nullptr ? std::optional<mesh_links>(std::in_place, glued->continued) : std::nullopt;
  // True if it matters whether a field was computed: for the aspect, or for the mean.
  const bool is_judged = options.aspect == no_aspect_named ||
                         (options.hessian == hessian_method::green && !options.relative);
  field_derivatives found;
  for (const nodal_values* f : by_name(fields)) {
    found.powers.push_back(power_of(f->values));
    std::vector<double> divided;
    if (found.powers.back() != 0) divide(divided = f->values, found.powers.back());
    const std::vector<double>& values = divided.empty() ? f->values : divided;
    const bool is_whole = values.size() == m.sites.size();  // else its recovery says so
    const auto bound = is_judged && is_whole ? aspect_bound(m, links, values) : std::nullopt;
    const bool is_computed = bound.has_value();
    auto one = beyond && is_whole
                   ? glued_derivatives_of(*glued, *beyond, values, is_computed, options)
                   : derivatives_of(m, links, values, is_computed, options);
    if (!one) return one.failure().at("field " + f->name);
    if (options.aspect == no_aspect_named) found.aspects.push_back(bound);
    found.names.push_back(f->name);
    found.noise += one.value().recovered.noise;
    found.at_boundary += one.value().recovered.at_boundary;
    found.moduli.push_back(std::move(one.value().moduli));
    found.recovered.push_back(std::move(one.value().recovered.at));
    if (options.relative) found.scales.push_back(scales_of_error(values, options.cutoff));
  }
  return found;
}

result<field_derivatives> given_derivatives(const mesh& m,
                                            const std::vector<nodal_hessian>& fields) {
  field_derivatives found;
  for (const nodal_hessian* f : by_name(fields)) {
    if (f->at.size() != m.sites.size())
      return error{fmt::format("field {}: {} tensors for {} vertices", f->name, f->at.size(),
                               m.sites.size())};
    std::vector<metric_tensor> second = f->at;
    for (std::size_t v = 0; v < second.size(); ++v)
      if (!std::isfinite(second[v].m11) || !std::isfinite(second[v].m12) ||
          !std::isfinite(second[v].m22))
        return error{fmt::format("field {}: the second derivatives at vertex {} are not finite",
                                 f->name, v + 1)};
    found.powers.push_back(power_of(second));
    if (found.powers.back() != 0) divide(second, found.powers.back());
    found.names.push_back(f->name);
    found.moduli.push_back(second);
    found.recovered.push_back(std::move(second));
  }
  return found;
}

}  // namespace asterism::internal
