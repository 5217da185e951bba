// SPDX-License-Identifier: MIT
//
// Reads the mesh that `verify` judges, in any format that has a reader and a writer.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "asterism/apps/text/verify_question.hpp"
#include "asterism/core/result.hpp"
#include "asterism/mesh/audit/certificate.hpp"
#include "asterism/mesh/data/domain.hpp"
#include "asterism/mesh/data/mesh.hpp"
#include "asterism/mesh/data/side_nodes.hpp"

namespace asterism::apps {

// A mesh, and the parts that its file had no place for.
struct judged_mesh {
  mesh content;
  bool has_metric = true;    // else the identity stands for one that is still to be found
  bool has_segments = true;  // else the format has no place for given vertices and inner segments
  std::size_t second_order = 0;   // elements of it
  std::vector<side_node> curved;  // nodes of their sides that are not the middles
  // The mesh as read, if frozen triangles were removed from `content`.
  std::optional<mesh> together = {};
  std::string frozen = {};  // what is said of them
  // Parts of the mesh that are not in its file, and were taken from elsewhere.
  bool took_metric = false, took_segments = false, took_regions = false;

  const mesh& whole() const { return together ? *together : content; }
};

// Reads the mesh. Medit's formats are taken unchanged; others are put in order by their readers,
// with notes. Slits are joined. Refuses formats without a reader: pictures, pages, .node.
result<judged_mesh> read_judged(const verify_options& options);

// Takes subsegments, markers and regions from the domain for a mesh whose format has no place for
// them. Returns the reason if they cannot be those of this mesh; none if nothing contradicts them,
// or the file has them.
std::optional<std::string> complete_segments(judged_mesh& subject, const domain& shape);

// Takes the metric of --metric, or else the certificate's, for a mesh whose file has none. Fails
// where neither can be made.
std::optional<error> complete_metric(judged_mesh& subject, const verify_options& options,
                                     const std::optional<certificate>& claim, const domain* shape);

// Returns "; not in the file and taken from the certificate: segments, markers"; empty for a mesh
// whose file has them.
std::string text_of_completion(const judged_mesh& subject, bool is_claimed);

}  // namespace asterism::apps
