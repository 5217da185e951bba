// SPDX-License-Identifier: MIT
#include "asterism/mesh/pipeline/given_hessians.hpp"

#include <algorithm>
#include <cstddef>

#include "asterism/core/number_text.hpp"
#include "asterism/mesh/io/solution_output.hpp"

namespace asterism::internal {
namespace {

nodal_hessian tensors_of(const solution_field& field) {
  nodal_hessian made{field.name, {}};
  for (std::size_t i = 0; i + 2 < field.values.size(); i += 3)
    made.at.push_back({field.values[i], field.values[i + 1], field.values[i + 2]});
  return made;
}

std::string kind_of(const solution_field& field) {
  return field.kind == field_kind::scalar ? "a scalar" : "a vector";
}

}  // namespace

result<given_hessians> read_hessians(const std::string& file, const mesh& m,
                                     const std::vector<vertex_index>& left_out,
                                     const std::vector<std::string>& names) {
  const auto read = read_fields(file, m, left_out);
  if (!read) return read.failure();
  const std::vector<solution_field>& fields = read.value().fields;
  std::string all;
  for (const solution_field& f : fields) all += (all.empty() ? "" : ", ") + quoted_token(f.name);
  for (const std::string& name : names) {
    const auto at = std::find_if(fields.begin(), fields.end(),
                                 [&](const solution_field& f) { return f.name == name; });
    if (at == fields.end())
      return error{file + ": there is no field " + quoted_token(name) +
                   (all.empty() ? "" : "; there are " + all)};
    if (at->kind != field_kind::tensor)
      return error{file + ": field " + quoted_token(name) + " is " + kind_of(*at) +
                   ", and second derivatives xx xy yy are wanted"};
  }
  given_hessians found{{}, read.value().notes};
  for (const solution_field& f : fields) {
    const bool is_named = std::find(names.begin(), names.end(), f.name) != names.end();
    if (f.kind == field_kind::tensor && (names.empty() || is_named))
      found.fields.push_back(tensors_of(f));
  }
  if (found.fields.empty())
    return error{file +
                 ": there is no symmetric tensor at the vertices in it, and second "
                 "derivatives xx xy yy are wanted"};
  return found;
}

}  // namespace asterism::internal
