// SPDX-License-Identifier: MIT
#include "asterism/mesh/pipeline/make_mesh.hpp"

#include "asterism/mesh/pipeline/mesh_attempts.hpp"

namespace asterism {

result<mesh_outcome> make_mesh(const domain& d, const metric_field& field,
                               const mesh_options& options, const progress_listener& progress) {
  return internal::make_by_attempts(d, field, options, progress,
                                    internal::star_confirmation::by_mesher);
}

}  // namespace asterism
