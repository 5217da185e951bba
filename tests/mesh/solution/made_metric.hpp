// SPDX-License-Identifier: MIT
//
// Makes metrics of functions at the sites of a mesh.
#pragma once

#include <catch2/catch.hpp>
#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "asterism/mesh/solution/solution_metric.hpp"

namespace asterism::tests {

inline nodal_values field(const mesh& m, const std::string& name,
                          const std::function<double(const point&)>& f) {
  nodal_values made{name, {}};
  for (const site& s : m.sites) made.values.push_back(f(s.position));
  return made;
}

inline solution_metric made(const mesh& m, const std::vector<nodal_values>& fields,
                            const solution_metric_options& options) {
  auto metric = make_solution_metric(m, fields, options);
  REQUIRE(metric.ok());
  return std::move(metric).value();
}

}  // namespace asterism::tests
