// SPDX-License-Identifier: MIT
//
// Holds the question of `verify`, part by part, and the source of each part: an option, or, where
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

// Options of the command line, as given.
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

// Returns the source of a part as a word for programs; empty if there is none.
std::string name_of(asked_by who);

// Returns ", by the certificate" for a part that came from the certificate; else an empty text.
std::string by_text(asked_by who);

// The domain with which a mesh is compared.
struct asked_domain {
  std::optional<domain> shape;  // that --domain names; none: the certificate's, or the mesh's own
  asked_by by = asked_by::nobody;
  std::string name;  // of --domain
  // Distance within which the domain was repaired, and the greatest move of a vertex, measured
  // again.
  asked_by repaired_by = asked_by::nobody;
  double distance = 0, greatest_move = 0;
  std::vector<std::string> contradictions;
};

// Results on the metric of a mesh.
struct metric_answer {
  asked_by by = asked_by::nobody;
  std::string name;
  std::string filled_in;  // size and gradation that the certificate adds to what --metric names
  bool made = false;      // the metric asked for could be made again
  bool is_taken = false;  // the file has none, and the mesh is judged in the one asked for
  std::string why_not;    // else
  // Distance of the tensors from the metric asked for: measured again if that metric was made, else
  // as the certificate states. None where they are equal.
  std::optional<delivered_report> apart;
  asked_by tolerance_by = asked_by::nobody;  // also where what was asked is that there is none
  std::optional<double> tolerance;
  std::vector<std::string> contradictions;  // of the certificate
  std::vector<std::string> refusals;        // of what the options ask

  bool is_refused() const { return !contradictions.empty() || !refusals.empty(); }
};

// All parts of the question, and the verdict.
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
