// SPDX-License-Identifier: MIT
//
// Counts repairs of one kind, and keeps a description of the first of them. Works inside
// check_domain.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace asterism::internal {

class repair_tally {
 public:
  explicit repair_tally(std::size_t& count) : count_(count) { count_ = 0; }

  // Adds a repair. `place` ("file:line: ") and `example` ("vertex 5") are called the first time.
  template <class Place, class Example>
  void add(const Place& place, const Example& example) {
    if (count_++ > 0) return;
    place_ = place();
    example_ = example();
  }
  // Appends "place: what: count, the first: example" if anything was counted.
  void report(const std::string& what, std::vector<std::string>& messages) const {
    if (count_ == 0) return;
    messages.push_back(place_ + what + ": " + std::to_string(count_) +
                       (count_ == 1 ? ", " : ", the first: ") + example_);
  }

 private:
  std::size_t& count_;
  std::string place_, example_;
};

}  // namespace asterism::internal
