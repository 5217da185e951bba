// SPDX-License-Identifier: MIT
//
// Makes sorted lists without repetitions.
#pragma once

#include <algorithm>

namespace asterism::internal {

// Sorts the items and removes repetitions.
template <class Container>
void sort_unique(Container& items) {
  std::sort(items.begin(), items.end());
  items.erase(std::unique(items.begin(), items.end()), items.end());
}

}  // namespace asterism::internal
