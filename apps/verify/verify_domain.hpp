// SPDX-License-Identifier: MIT
//
// Reads the domain with which `verify` compares a mesh.
#pragma once

#include <optional>
#include <string>

#include "asterism/apps/text/verify_question.hpp"
#include "asterism/core/result.hpp"

namespace asterism::apps {

// Reads the domain that --domain names, if any. Vertices given to the mesh beyond the domain's own,
// as random points are, belong to it when they lie inside. Curves are divided as the certificate
// states, and the distance of the chords from them is measured.
//
// The domain is repaired where --repair-distance asks for it. Otherwise it is taken as it is, if it
// is valid: then a certificate of another, repaired domain is contradicted. A domain that is not
// valid is repaired as the certificate states.
result<asked_domain> find_domain(const verify_options& options, const mesh& subject,
                                 const std::optional<certificate>& claim);

// Returns "domain slot.poly as repaired by up to 0.4 (within 0.45, by the certificate)".
std::string text_of(const asked_domain& asked, const std::optional<certificate>& claim);

}  // namespace asterism::apps
