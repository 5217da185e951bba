// SPDX-License-Identifier: MIT
//
// Makes the file by which ParaView opens the pieces of a mesh as one.
#pragma once

#include <string>
#include <vector>

namespace asterism::internal {

// Returns a parallel VTK file (.pvtu) of these .vtu files, which are beside it, with the arrays
// that mesh/io/vtu.hpp writes.
std::string pvtu_text(const std::vector<std::string>& files);

}  // namespace asterism::internal
