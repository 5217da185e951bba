// SPDX-License-Identifier: MIT
//
// The worst angle of a mesh as summaries tell it.
#pragma once

#include <fmt/format.h>

#include <string>

namespace asterism::apps {

// `degrees` as an audit has it: 180 where no triangle is away from the exempt corners.
inline std::string worst_angle_text(double degrees) {
  if (degrees >= 180) return "no angle to judge";
  return fmt::format("worst angle {:.2f} degrees", degrees);
}

}  // namespace asterism::apps
