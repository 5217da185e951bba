// SPDX-License-Identifier: MIT
//
// Finds the domain that `verify` holds a mesh against.
#pragma once

#include <optional>
#include <string>

#include "asterism/apps/text/verify_question.hpp"
#include "asterism/core/result.hpp"

namespace asterism::apps {

// Reads the domain that --domain names, if any. Vertices given to the mesh beyond the domain's own,
// as random points are, belong to it when they lie inside. Curves are divided as the certificate
// says they were: it is measured how far the chords are from them.
//
// The domain is repaired where --repair-distance asks for it. Without that it is taken as it
// stands, if it can be: then a certificate of another, repaired domain is contradicted. A domain
// that cannot be taken as it stands is repaired as the certificate says.
result<asked_domain> find_domain(const verify_options& options, const mesh& subject,
                                 const std::optional<certificate>& claim);

// Returns "domain slot.poly as repaired by up to 0.4 (within 0.45, by the certificate)".
std::string text_of(const asked_domain& asked, const std::optional<certificate>& claim);

}  // namespace asterism::apps
