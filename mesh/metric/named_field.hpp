// SPDX-License-Identifier: MIT
//
// Describes a metric field that has a name: its arguments, a sentence about it, and its maker.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "asterism/mesh/data/bounding_box.hpp"
#include "asterism/mesh/metric/sized_field.hpp"

namespace asterism::internal {

// Arguments for the maker of a named field.
struct field_request {
  std::string_view specification;             // the whole, for messages
  std::optional<std::string_view> parameter;  // what follows the first colon
  bounding_box box;                           // of the domain
  double size = 1;                            // divides lengths
};

// Holds one row of the lists from which help, completion, the refusal of an unknown name and the
// manual are made. Arguments in brackets may be left out.
struct named_field {
  std::string_view name, arguments, sentence;
  made_field (*make)(const field_request& asked);
};

// Refuses the parameter of a field that has none.
inline error takes_no_parameter(const field_request& asked) {
  return bad_metric(asked.specification,
                    std::string(asked.specification.substr(0, asked.specification.find(':'))) +
                        " takes no parameter");
}

}  // namespace asterism::internal
