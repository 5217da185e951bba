// SPDX-License-Identifier: MIT
//
// Proves again what the certificate of a mesh of a surface says.
#pragma once

#include <optional>
#include <string>

namespace asterism::apps {

struct verify_options;

// Returns the status if the certificate named, or the one beside the mesh, is of a surface; nothing
// if it is not, or there is none.
std::optional<int> verify_surface(const verify_options& options);

}  // namespace asterism::apps
