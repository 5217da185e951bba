// SPDX-License-Identifier: MIT
//
// Adds the option --periodic of `mesh` and `adapt`, and writes its results.
#pragma once

#include <CLI/CLI.hpp>
#include <iosfwd>
#include <vector>

#include "asterism/mesh/audit/certificate.hpp"

namespace asterism::apps {

// Adds the option, which may be given several times: two markers, A,B.
CLI::Option* add_periodic_option(CLI::App& app, std::vector<periodic_pair>& pairs);

// Writes a line for each pair of sides that match.
void write_periodic(std::ostream& out, const certificate& claim);

}  // namespace asterism::apps
