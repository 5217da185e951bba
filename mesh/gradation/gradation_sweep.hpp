// SPDX-License-Identifier: MIT
//
// Holds the metrics at the nodes of a gradation grid and sweeps over them until no node has to be
// refined for its neighbours any more.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "asterism/core/result.hpp"
#include "asterism/mesh/data/metric_field.hpp"
#include "asterism/mesh/gradation/gradation_grid.hpp"
#include "asterism/mesh/gradation/gradation_options.hpp"
#include "asterism/mesh/numerics/metric_algebra.hpp"

namespace asterism::internal {

class gradation_sweep {
 public:
  // Takes a field that it does not own, and a grid that has nodes already.
  gradation_sweep(const metric_field& field, gradation_grid& grid,
                  const gradation_options& options);

  struct node {
    metric_tensor given, now;
    tensor_logarithm given_log, now_log;
    // Times of the node's last change and of its last visit, counted in changes of any node.
    std::uint64_t changed = 1, visited = 0;
    bool altered = false;  // now differs from given
  };

  // Refines the grid for the field as given, then sweeps and refines in turn. Fails where the field
  // does, and when options.stop ended it.
  std::optional<error> run();

  const std::vector<node>& nodes() const { return nodes_; }
  // Returns a flag for each node: whether the given field may be used unchanged at it and around
  // it.
  std::vector<bool> kept() const;
  const gradation_report& report() const { return report_; }

 private:
  bool is_ended();
  std::optional<error> sample();
  std::optional<error> refine_given();
  std::size_t refine(bool by_given);
  bool is_resolved(const gradation_grid::cell& leaf, bool by_given) const;
  void connect();
  void sweep_until_settled();
  bool visit(std::uint32_t n);
  bool take_from_neighbours(std::uint32_t n);
  bool take_from_circle(std::uint32_t n);
  bool take(std::uint32_t n, const metric_tensor& other, const point& from, double slack);

  const metric_field& field_;
  gradation_grid& grid_;
  gradation_options options_;
  double sigma_;
  bounding_box box_;
  std::vector<node> nodes_;
  std::vector<std::uint32_t> first_neighbour_, neighbours_;  // those of n: [first[n], first[n + 1])
  std::uint64_t time_ = 1;
  std::size_t steps_ = 0;  // between which it is asked whether that is enough
  bool ended_ = false;
  gradation_report report_;
};

}  // namespace asterism::internal
