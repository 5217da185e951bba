// SPDX-License-Identifier: MIT
//
// The options of `adapt`, and what a run of it has made before the files are written.
#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "asterism/apps/job/frozen.hpp"
#include "asterism/apps/options/proof_output.hpp"
#include "asterism/mesh/claims/metric_request.hpp"
#include "asterism/mesh/data/mesh.hpp"
#include "asterism/mesh/data/side_nodes.hpp"
#include "asterism/mesh/pipeline/adapt_to_metric.hpp"
#include "asterism/mesh/transfer/transfer.hpp"

namespace asterism::apps {

struct adapt_job {
  internal::metric_request request;
  std::string domain;
  mesh_adaptation_options options;
  transfer_method how = transfer_method::interpolate;
  std::vector<std::filesystem::path> outputs;
  std::filesystem::path values, carried,
      certificate;  // the solution, and what is carried, on the new mesh
  std::filesystem::path proof;
  std::optional<double> chord_tolerance, max_seconds;
  std::vector<std::string> frozen;  // regions, by number or name
  bool convex_hull = false;         // of the domain's vertices, as segments
  std::size_t threads = 0;
  int order = 1;  // of the triangles in files that hold second ones
  bool quiet = false, json = false;
  bool strict = false;  // what readers change is refused
};

// The mesh, metric, solution and reports of a run, before they are written.
struct adapted {
  internal::requested_metric wanted;
  adapted_mesh next;
  std::optional<transferred_solution> values;
  std::optional<std::size_t> vertices_wanted;  // none where the metric alone says how many
  proof_output proof = {};
  std::vector<side_node> curved = {};  // of triangles of second order
  // The part outside frozen regions, with its metric, and the whole mesh that is written.
  mesh rest = {}, together = {};
  frozen_facts frozen = {};
  std::size_t border_split = 0;  // edges, where no way was found to leave them whole

  bool has_frozen() const { return !frozen.regions.empty(); }
  const mesh& written() const { return has_frozen() ? together : next.made.outcome.result; }
  const mesh& background() const { return has_frozen() ? rest : wanted.background; }
};

}  // namespace asterism::apps
