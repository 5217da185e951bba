// SPDX-License-Identifier: MIT
//
// Collects the facts that a command shows on a page about a mesh (mesh/draw/report.hpp).
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "asterism/mesh/data/metric_field.hpp"
#include "asterism/mesh/draw/report.hpp"

namespace asterism::apps {

// True if one of the outputs is a page.
bool has_page(const std::vector<std::filesystem::path>& outputs);

// Returns a command line that a POSIX shell splits into these words.
std::string shell_words(const std::vector<std::string>& words);

// Returns the command that judges again the mesh written to `outputs` with its certificate, quoted
// for a shell; where no .mesh is among them, a sentence that asks for one.
std::string repeating_command(const std::vector<std::filesystem::path>& outputs,
                              const std::filesystem::path& certificate);

// Returns the tensors that `field` has at the sites; none where it fails at one.
std::vector<metric_tensor> tensors_at_sites(const metric_field& field, const mesh& m);

}  // namespace asterism::apps
