// SPDX-License-Identifier: MIT
//
// Reads the domain and the metric that the command line names, and writes the mesh: the part that
// the three methods share.
#pragma once

#include <asterism/mesh/mesher.hpp>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "triangulation.hpp"

namespace baselines {

// A metric field whose answers need not be checked one by one: it keeps the first failure, which is
// reported at the end.
class metric {
 public:
  explicit metric(std::unique_ptr<asterism::metric_field> field) : field_(std::move(field)) {}
  metric_tensor at(const point& p) const;
  const std::optional<asterism::error>& failure() const { return failure_; }

 private:
  std::unique_ptr<asterism::metric_field> field_;
  mutable std::optional<asterism::error> failure_;
};

// Makes the field that `--metric` names: as for `asterism mesh`, a formula's name or NAME.mesh with
// the tensors of NAME.sol at its vertices.
asterism::result<std::unique_ptr<asterism::metric_field>> make_field(
    const std::string& specification, const asterism::bounding_box& box, double size);

// Returns the length of a displacement.
double length(const metric_tensor& m, double dx, double dy);
// Returns the mean of tensors, entry by entry, with equal weights.
metric_tensor mean(const std::vector<metric_tensor>& tensors);
// Cuts a segment into parts of equal length in the metric, as near to 1 as a whole number of parts
// allows. Returns the points strictly inside. `parts` is the number of intervals of the
// integration.
std::vector<point> equal_pieces(const metric& field, const point& a, const point& b, int parts);

// Holds a triangulation with a tensor at each vertex.
struct metric_mesh {
  triangulation net;
  std::vector<metric_tensor> tensor;
  const metric* field;
  index fixed = 0;  // vertices with lower numbers are on the border or the domain's own

  // Returns the length of an edge: the mean over the metrics of its two ends.
  double length(index v, index w) const;
  // Evaluates the tensors of new vertices.
  void measure_new();
  void measure_again(index v) { tensor[v] = field->at(net.points()[v]); }
};

// Holds what the command line names.
struct job {
  asterism::domain domain;
  std::unique_ptr<metric> field;
  std::string output;
  std::map<std::string, std::string> options;  // options of the method
};

// Changes the mesh, and returns in a few words how that ended.
using method = std::function<asterism::result<std::string>(
    metric_mesh&, const std::map<std::string, std::string>&)>;

// Does what `PROGRAM DOMAIN --metric SPEC --size H -o OUT.mesh` asks for: the border is cut in
// equal pieces and triangulated, the method goes on from there, the mesh is written with its
// metric. DOMAIN is one polygon without holes; SPEC as for `asterism mesh`. `own` are options of
// the method, each with a value. Returns the exit status: 0, or 2 if anything was refused.
int run(int count, const char* const* words, const std::set<std::string>& own,
        const method& method_of_program);

}  // namespace baselines
