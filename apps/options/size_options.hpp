// SPDX-License-Identifier: MIT
//
// Adds the options for local sizes and bounds on all sizes.
#pragma once

#include <CLI/CLI.hpp>
#include <memory>
#include <string>
#include <vector>

#include "asterism/apps/base/mesh_job.hpp"

namespace asterism::apps {

// Sizes as written on the command line: names of regions and markers are not yet replaced by
// numbers.
struct worded_size {
  std::string option, kind, text;
};

// Adds --hmin, --hmax and --aspect.
void add_size_bounds(CLI::App& app, double& least, double& greatest, double& aspect,
                     const std::string& on_least);

// Adds the options. The list is filled while the command line is parsed.
void add_size_options(CLI::App& app, mesh_job& job, std::vector<worded_size>& worded);

// Enters the sizes into the job, names as the domain's file has them. Throws CLI::ValidationError
// for a text that is no size, and for names that the file does not have.
void take_sizes(mesh_job& job, const std::vector<worded_size>& worded);

}  // namespace asterism::apps
