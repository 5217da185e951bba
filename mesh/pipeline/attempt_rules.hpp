// SPDX-License-Identifier: MIT
//
// Lists the attempts at a mesh, in the order in which they are made. The table of
// docs/design/attempts.md is this list; a test compares them.
#pragma once

#include <array>
#include <cstddef>
#include <string_view>

#include "asterism/mesh/data/outcome.hpp"

namespace asterism::internal {

// One attempt at a mesh. Shares are parts of the work of one attempt, which is the limit of a run
// with a metric tolerance of 0; a run with a larger tolerance may do 1.6 times that work.
struct attempt_rule {
  mesh_attempt what;
  std::string_view name;
  std::string_view metric;   // that the mesh is made in
  double share_of_work;      // of one way, at most: of what is left of it
  double share_of_stars;     // of the work limit of stars for the number of sites; 0: unused
  std::string_view is_made;  // when
};

inline constexpr std::size_t attempt_count = 6;

inline constexpr std::array<attempt_rule, attempt_count> attempt_rules = {{
    {mesh_attempt::delivered_first, "delivered first", "delivered", 0.65, 0,
     "the metric comes on a mesh, or a number of vertices is wanted, and there is a size"},
    {mesh_attempt::requested_briefly, "requested, briefly", "requested", 0.6, 0.1,
     "not after the first; a mesh is not likely, or is known soon: few sites are wanted, the "
     "metric "
     "jumps or varies fast over an edge; not with a metric tolerance of 0"},
    {mesh_attempt::requested, "requested", "requested", 0.6, 0.5,
     "not after the second, unless that ended for want of work, few sites are wanted and the "
     "metric "
     "does not vary fast; with all the work of stars where no other metric may be delivered"},
    {mesh_attempt::delivered, "delivered", "delivered", 0.65, 0,
     "stars disagree or angles are low, and that is not for a limit on sites, sharp corners alone "
     "or an interrupt; not after the first"},
    {mesh_attempt::requested_again, "requested, again", "requested", 0.6, 0.5,
     "the second ended for want of work, and a tolerance above 0 is asked for"},
    {mesh_attempt::one_metric, "one metric", "one for all sites", 1, 1,
     "stars still disagree, or no sites could be spread, and no tolerance is asked for"},
}};

}  // namespace asterism::internal
