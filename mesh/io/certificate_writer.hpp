// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <nlohmann/json_fwd.hpp>
#include <vector>

#include "asterism/mesh/audit/certificate.hpp"
#include "asterism/mesh/io/file_output.hpp"

namespace asterism::internal {

// Gives the text of certificate_text(c) to a sink in pieces.
void write_certificate_text(const certificate& c, const byte_sink& put);

// Returns the certificate's file, which refers to the certificate.
output_file certificate_file(const std::filesystem::path& path, const certificate& c);

// Returns the matches of periodic sides, one object each.
nlohmann::ordered_json json_of(const std::vector<periodic_match>& matches);

// Returns every field of the certificate. The reader holds what it was given against what is
// written of it, so that no field passes unread.
nlohmann::ordered_json json_of(const certificate& c);

}  // namespace asterism::internal
