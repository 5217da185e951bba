// SPDX-License-Identifier: MIT
//
// Holds what `verify` is asked, part by part, and where each part is from: an option, or, where
// that is not given, the certificate.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "asterism/mesh/audit/certificate.hpp"
#include "asterism/mesh/audit/curved_triangles.hpp"
#include "asterism/mesh/audit/verify.hpp"
#include "asterism/mesh/data/delivered_report.hpp"
#include "asterism/mesh/data/domain.hpp"
#include "asterism/mesh/data/mesh.hpp"

namespace asterism::apps {

// The options as given.
struct verify_options {
  std::filesystem::path mesh, certificate;
  std::optional<double> angle_bound;
  std::string domain;
  std::optional<double> repair_distance;
  bool number_regions = false;
  bool convex_hull = false;
  std::string metric;
  std::optional<double> size, gradation, metric_tolerance;
  bool prove_voronoi = false;
  std::vector<periodic_pair> periodic;  // sides to match, besides the certificate's
  bool all_findings = false, all_edges = false, json = false;
  bool tells_theorem = false;  // in the line of the verdict
  std::optional<double> max_seconds;
};

enum class asked_by { nobody, option, certificate };

// The name of who asked, for programs; empty for nobody.
std::string name_of(asked_by who);

// Returns ", by the certificate" where it was the certificate.
std::string by_text(asked_by who);

// The domain that a mesh is held against.
struct asked_domain {
  std::optional<domain> shape;  // that --domain names; none: the certificate's, or the mesh's own
  asked_by by = asked_by::nobody;
  std::string name;  // of --domain
  // The distance of a repair, and the greatest move of it, measured again.
  asked_by repaired_by = asked_by::nobody;
  double distance = 0, greatest_move = 0;
  std::vector<std::string> contradictions;
};

// Holds what was found about the metric of a mesh.
struct metric_answer {
  asked_by by = asked_by::nobody;
  std::string name;
  std::string filled_in;  // size and gradation that the certificate adds to what --metric names
  bool made = false;      // the metric asked for could be made again
  bool is_taken = false;  // the file has none, and the mesh is judged in the one asked for
  std::string why_not;    // else
  // How far the tensors are from the metric asked for; measured again where that was made, and else
  // what the certificate says. None where they are the same.
  std::optional<delivered_report> apart;
  asked_by tolerance_by = asked_by::nobody;  // also where what was asked is that there is none
  std::optional<double> tolerance;
  std::vector<std::string> contradictions;  // of the certificate
  std::vector<std::string> refusals;        // of what the options ask

  bool is_refused() const { return !contradictions.empty() || !refusals.empty(); }
};

// Everything that was asked, and the verdict.
struct judgement {
  asked_domain shape;
  metric_answer metric;
  verify_report verdict;
  std::string completed;                   // what is not of the file, for the verdict's line
  std::vector<std::string> side_refusals;  // sides that do not match, of those that options name
  asked_by bound_by = asked_by::nobody;
  double bound = 0;                                 // degrees
  std::optional<second_order_report> second_order;  // of the triangles in the file
  std::string frozen = {};  // what is said of triangles that were not adapted
};

}  // namespace asterism::apps
