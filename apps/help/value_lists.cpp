// SPDX-License-Identifier: MIT
#include "asterism/apps/help/value_lists.hpp"

#include <fmt/format.h>

#include <string_view>

#include "asterism/apps/help/help_text.hpp"
#include "asterism/mesh/io/file_kinds.hpp"
#include "asterism/mesh/metric/make_metric_field.hpp"

namespace asterism::apps {
using namespace internal;
namespace {

// Width in columns of a manual page, which does not break lines of examples.
constexpr std::size_t columns = 100;

// Returns an entry of a list, its name and sentence; help breaks a long one below the sentence.
std::string entry(std::string_view what, std::string_view sentence) {
  return fmt::format("  {:<27} {}\n", what, sentence);
}

bool is_read_with_metric(const file_kind& kind) { return is_mesh_kind(kind) && kind.keeps.metric; }

std::string metrics() {
  std::string text;
  for (const metric_name& metric : metric_names())
    text += entry(fmt::format("{}{}", metric.name, metric.arguments), metric.sentence);
  return text;
}

std::string written_files() {
  std::string text;
  for (const file_kind& kind : file_kinds())
    if (is_written_kind(kind)) text += entry(kind.ending, kind.holds);
  return text;
}

}  // namespace

std::string mesh_values() {
  const std::string text =
      "DOMAIN  square ([-1,1]^2), airfoil (NACA 0012 in a box), a domain in a file (" +
      endings_of(is_domain_kind, "or") + "), or a mesh (" + endings_of(is_mesh_kind, "or") +
      "): what it covers, with all its vertices and boundary edges. A mesh that meets what is "
      "asked already stays as it is; to another, vertices are added.\n\n"
      "SPEC    by name:\n" +
      metrics() + "or a mesh with its metric (" + endings_of(is_read_with_metric, "or") +
      "): the tensors at its vertices, interpolated; or a .sol, a size or a tensor for each "
      "vertex of DOMAIN if that is a mesh, else of the mesh of the same name beside it.\n\n"
      "OUT     by extension:\n" +
      written_files();
  return wrapped(text, columns);
}

std::string convert_values() {
  const std::string text = "IN      a mesh (" + endings_of(is_mesh_kind, "or") +
                           "), with a .sol or .solb beside Medit's; or a domain, for a .poly\n\n"
                           "OUT     " +
                           endings_of(is_written_kind, "or") + "; of a domain .poly\n";
  return wrapped(text, columns);
}

}  // namespace asterism::apps
