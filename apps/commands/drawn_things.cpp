// SPDX-License-Identifier: MIT
#include "asterism/apps/commands/drawn_things.hpp"

#include <utility>

#include "asterism/apps/base/notes.hpp"
#include "asterism/mesh/domain/divide_curves.hpp"
#include "asterism/mesh/draw/outline.hpp"
#include "asterism/mesh/io/fields_of_mesh.hpp"
#include "asterism/mesh/io/load_domain.hpp"
#include "asterism/mesh/io/read_mesh.hpp"
#include "asterism/mesh/io/solution_file.hpp"

namespace asterism::apps {
using namespace internal;
namespace {

// Returns the outline of a domain as its author wrote it: it is not checked, so that faults can be
// seen.
result<drawn_thing> read_domain(const std::string& name) {
  const auto loaded = load_domain(name);
  if (!loaded) return loaded.failure();
  if (auto failed = say_notes(loaded.value().origin.notes, {})) return *failed;
  const auto divided = divide_curves(loaded.value());
  if (!divided) return divided.failure();
  return drawn_thing{outline_of(divided.value())};
}

}  // namespace

bool is_drawn_as_domain(const std::string& name) { return !is_mesh_file(name); }

result<drawn_thing> read_drawn(const std::string& name,
                               const std::filesystem::path& solution_file) {
  if (is_drawn_as_domain(name)) {
    if (!solution_file.empty())
      return error{"--solution: " + name + " is a domain, which has no vertices of a mesh"};
    return read_domain(name);
  }
  auto read = read_mesh_file(name, {.identity_without_solution = true});
  if (!read) return read.failure();
  if (auto failed = say_notes(read.value().content.notes, {})) return *failed;
  auto fields = solution_file.empty()
                    ? fields_of_mesh(name, read.value())
                    : read_solution(solution_file, read.value().content, read.value().left_out);
  if (!fields) return fields.failure();
  if (auto failed = say_notes(fields.value().notes, {})) return *failed;
  return drawn_thing{std::move(read.value().content), std::move(fields).value(),
                     read.value().has_metric};
}

}  // namespace asterism::apps
