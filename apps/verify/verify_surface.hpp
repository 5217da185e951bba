// SPDX-License-Identifier: MIT
//
// Proves the certificate of a mesh of a surface again.
#pragma once

#include <optional>
#include <string>

namespace asterism::apps {

struct verify_options;

// Returns the status if the certificate named, or the one beside the mesh, is of a surface; nothing
// otherwise.
std::optional<int> verify_surface(const verify_options& options);

}  // namespace asterism::apps
