// SPDX-License-Identifier: MIT
#pragma once

namespace asterism::internal {

// Empties lists and frees their memory, which an assignment of {} to a vector would keep.
template <class... Lists>
void free_memory(Lists&... lists) {
  (Lists().swap(lists), ...);
}

}  // namespace asterism::internal
