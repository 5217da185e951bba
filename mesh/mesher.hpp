// SPDX-License-Identifier: MIT
//
// Includes the mesher, all of it: domains, metric fields, a mesh with its certificate, files; and
// the adaptation loop: solutions, their Hessians and metrics, the next mesh, a solution brought to
// it.
#pragma once

#include "asterism/mesh/audit/audit.hpp"               // IWYU pragma: export
#include "asterism/mesh/audit/verify.hpp"              // IWYU pragma: export
#include "asterism/mesh/data/domain.hpp"               // IWYU pragma: export
#include "asterism/mesh/data/mesh.hpp"                 // IWYU pragma: export
#include "asterism/mesh/data/mesh_marks.hpp"           // IWYU pragma: export
#include "asterism/mesh/data/metric_field.hpp"         // IWYU pragma: export
#include "asterism/mesh/data/options.hpp"              // IWYU pragma: export
#include "asterism/mesh/data/outcome.hpp"              // IWYU pragma: export
#include "asterism/mesh/data/solution.hpp"             // IWYU pragma: export
#include "asterism/mesh/domain/built_in_domains.hpp"   // IWYU pragma: export
#include "asterism/mesh/domain/check_domain.hpp"       // IWYU pragma: export
#include "asterism/mesh/io/load_domain.hpp"            // IWYU pragma: export
#include "asterism/mesh/io/solution_file.hpp"          // IWYU pragma: export
#include "asterism/mesh/io/write_mesh.hpp"             // IWYU pragma: export
#include "asterism/mesh/metric/local_sizes.hpp"        // IWYU pragma: export
#include "asterism/mesh/metric/make_metric_field.hpp"  // IWYU pragma: export
#include "asterism/mesh/pipeline/adapt_to_metric.hpp"  // IWYU pragma: export
#include "asterism/mesh/pipeline/certified_mesh.hpp"   // IWYU pragma: export
#include "asterism/mesh/pipeline/layer_rows.hpp"       // IWYU pragma: export
#include "asterism/mesh/pipeline/make_mesh.hpp"        // IWYU pragma: export
#include "asterism/mesh/pipeline/outcome_text.hpp"     // IWYU pragma: export
#include "asterism/mesh/solution/hessian.hpp"          // IWYU pragma: export
#include "asterism/mesh/solution/implied_metric.hpp"   // IWYU pragma: export
#include "asterism/mesh/solution/solution_metric.hpp"  // IWYU pragma: export
#include "asterism/mesh/transfer/transfer.hpp"         // IWYU pragma: export
