// SPDX-License-Identifier: MIT
#include "asterism/apps/surface_input.hpp"

#include "asterism/mesh/io/file_ending.hpp"
#include "asterism/mesh/surface/built_in_surfaces.hpp"
#include "asterism/mesh/surface_io/surface_json.hpp"

namespace asterism::apps {
using namespace internal;

result<surface> find_surface(const std::string& name) {
  if (auto known = built_in_surface(name)) return std::move(*known);
  if (!has_ending(name, ".json")) {
    std::string names;
    for (const std::string& known : built_in_surface_names()) names += known + ", ";
    return error{"surface " + name + ": " + names + "or a .json file of patches is wanted",
                 error_code::bad_option};
  }
  return read_surface(name);
}

}  // namespace asterism::apps
