// SPDX-License-Identifier: MIT
//
// The fill before refinement, within the limit on sites: where the size wanted takes more, the
// domain is meshed with longer edges, all by the same factor, and the outcome says so.
#pragma once

#include <functional>

#include "asterism/core/result.hpp"
#include "asterism/mesh/data/options.hpp"
#include "asterism/mesh/data/outcome.hpp"
#include "asterism/mesh/fill/fill.hpp"
#include "asterism/mesh/metric/unit_frame.hpp"

namespace asterism::internal {

struct budgeted_filling {
  filled_domain proposed;  // in `frame`
  unit_frame frame;
  int halvings = 0;  // of the number of sites: lengths wanted are 2^(halvings / 2) as long
};

// Fills the domain for the strategies that begin so, in the image that `frame` or a coarser one
// makes of it; for the others nothing is proposed. The metric is divided by the least power of two
// with which the fill leaves a fifth of the sites for refinement, as far as that can be foretold.
// Fails as fill() does.
result<budgeted_filling> fill_within_budget(
    const unit_frame& frame, const domain& d, const metric_field& field,
    const mesh_options& options, const std::function<void(const mesh_progress&)>& progress);

// Where the fill was given up and the outcome, of the given vertices alone, is not complete, its
// reason says so, with the place.
void report_crowded(const budgeted_filling& filled, mesh_outcome& outcome);

// With halvings, turns the outcome of a coarser fill into one of what was asked: not complete, with
// the triangles that are too large counted and the size that was delivered. How many sites would
// have been wanted is told from those there are, unless the fill was stopped and more were to come.
void report_coarser(int halvings, bool fill_stopped, const mesh_options& options,
                    mesh_outcome& outcome);

}  // namespace asterism::internal
