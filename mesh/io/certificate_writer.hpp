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

// Returns every field of the certificate as JSON. The reader compares its input with the JSON of
// the result, so that no field is ignored.
nlohmann::ordered_json json_of(const certificate& c);

}  // namespace asterism::internal
