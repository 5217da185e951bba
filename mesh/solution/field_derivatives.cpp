// SPDX-License-Identifier: MIT
#include "asterism/mesh/solution/field_derivatives.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "asterism/core/number_text.hpp"
#include "asterism/mesh/solution/mean_moduli.hpp"
#include "asterism/mesh/solution/relative_error.hpp"

namespace asterism::internal {
namespace {

constexpr double most_second_derivative = 1e150;  // products of two are finite

bool are_below(const metric_tensor& h, double most) {
  return std::abs(h.m11) < most && std::abs(h.m12) < most && std::abs(h.m22) < most;
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

}  // namespace

result<field_derivatives> recovered_derivatives(const mesh& m, const mesh_links& links,
                                                const std::vector<nodal_values>& fields,
                                                const solution_metric_options& options) {
  const hessian_method method = options.hessian;
  field_derivatives found;
  for (const nodal_values* f : by_name(fields)) {
    auto hessian = recover_hessian(m, f->values, method);
    if (!hessian) return hessian.failure().at("field " + f->name);
    found.names.push_back(f->name);
    found.noise += hessian.value().noise;
    found.at_boundary += hessian.value().at_boundary;
    found.moduli.push_back(method == hessian_method::green
                               ? mean_moduli(m, links, hessian.value().at)
                               : hessian.value().at);
    found.recovered.push_back(std::move(hessian.value().at));
    if (options.relative) found.scales.push_back(scales_of_error(f->values, options.cutoff));
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
    for (std::size_t v = 0; v < f->at.size(); ++v)
      if (!are_below(f->at[v], most_second_derivative))
        return error{
            fmt::format("field {}: the second derivatives {} {} {} at vertex {} are "
                        "beyond what can be computed with",
                        f->name, format_number(f->at[v].m11), format_number(f->at[v].m12),
                        format_number(f->at[v].m22), v + 1)};
    found.names.push_back(f->name);
    found.moduli.push_back(f->at);
    found.recovered.push_back(f->at);
  }
  return found;
}

}  // namespace asterism::internal
