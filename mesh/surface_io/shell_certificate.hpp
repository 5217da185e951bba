// SPDX-License-Identifier: MIT
//
// Writes and reads the certificates of shells.
#pragma once

#include <string>
#include <string_view>

#include "asterism/core/result.hpp"
#include "asterism/mesh/data/surface_shell.hpp"
#include "asterism/mesh/surface_audit/shell_audit.hpp"

namespace asterism::internal {

// All claims about a shell, with the surface and the plane meshes, so that they can be proved again
// from this and the mesh in space.
struct shell_certificate {
  surface of;
  surface_shell shell;  // without points
  shell_question asked;
  shell_report report;
  bool complete = false;
  std::string reason;
};

std::string shell_certificate_text(const shell_certificate& c);
// True if the text begins like the certificate of a shell.
bool is_shell_certificate(std::string_view text);
result<shell_certificate> parse_shell_certificate(const std::string& text, const std::string& file);

}  // namespace asterism::internal
