// SPDX-License-Identifier: MIT
//
// Defines a metric asked for by files: a mesh, a solution on it, and options. The same words make
// the metric for a run and, from its certificate, again for verify.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "asterism/core/result.hpp"
#include "asterism/mesh/audit/periodic_match.hpp"
#include "asterism/mesh/data/mesh.hpp"
#include "asterism/mesh/solution/solution_metric.hpp"

namespace asterism::internal {

struct metric_request {
  std::string mesh, solution;  // files; no solution where the mesh's own metric is wanted
  std::string metric;          // file of a metric in place of a solution
  // File of second derivatives that the metric is made of; a solution is then only transferred.
  std::string hessians = {};
  std::vector<std::string> fields;       // names; none: all scalars and vectors, or all tensors
  std::vector<std::string> intersected;  // files of metrics on the same mesh
  bool implied = false;                  // the mesh's own metric in place of a solution
  std::string carried = {};  // file of fields that come along and have no part in the metric
  // Pairs of periodic sides, by marker: second derivatives are recovered across them.
  std::vector<periodic_pair> periodic = {};
  solution_metric_options wishes;
  bool names_gradation = false;  // else the default of the source holds
  bool names_hessian = false, names_norm = false;
};

// True if the metric is made of second derivatives, recovered or given.
inline bool is_of_fields(const metric_request& request) {
  return !request.solution.empty() || !request.hessians.empty();
}

// Prefix of the names of fields that are only transferred: two files may have fields of one name.
inline constexpr const char* carried_prefix = "carried.";

// The result of a request: background mesh, metric and fields.
struct requested_metric {
  mesh background;  // with the metric at its vertices
  // The solution's fields, then those that are carried, with carried_prefix before their names.
  asterism::solution values;
  std::size_t own_fields = 0;  // of them, the solution's
  solution_metric_report report;
  std::vector<vertex_index> left_out = {};  // vertices of the file without a triangle, ascending
};

// Refuses a request for several metrics, for none, or for several numbers of vertices.
std::optional<error> check_sources(const metric_request& request);

// Returns what the metric is made of, as certificates name it: "solution u.sol".
std::string name_of(const metric_request& request);

// Reads the files and makes the metric. Sites of the background are numbered as in its file.
result<requested_metric> answer(const metric_request& request);

}  // namespace asterism::internal
