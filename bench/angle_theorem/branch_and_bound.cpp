// SPDX-License-Identifier: MIT
#include "branch_and_bound.hpp"

#include <vector>

namespace asterism::internal::angle_theorem {
namespace {

int widest(const configuration_box& box) {
  int k = 0;
  for (int i = 1; i < 4; ++i)
    if (box.high[i] - box.low[i] > box.high[k] - box.low[k]) k = i;
  return k;
}

// Not inlined into prove: its arithmetic must stay behind the change of the rounding mode.
[[gnu::noinline]] proof_attempt search(const hypotheses& given, std::int64_t most_boxes) {
  proof_attempt attempt;
  const double all = given.distortion_cap;
  std::vector<configuration_box> open = {{{-all, -all, -all, -all}, {all, all, all, all}}};
  while (!open.empty()) {
    const configuration_box box = open.back();
    const int k = widest(box);
    attempt.last = box;
    if (attempt.boxes == most_boxes || box.high[k] - box.low[k] < 0x1p-20) return attempt;
    open.pop_back();
    ++attempt.boxes;
    if (judge(box, given) != box_verdict::undecided) continue;
    const double middle = box.low[k] + (box.high[k] - box.low[k]) / 2;
    open.push_back(box);
    open.back().low[k] = middle;
    open.push_back(box);
    open.back().high[k] = middle;
  }
  attempt.proved = true;
  return attempt;
}

}  // namespace

proof_attempt prove(const hypotheses& given, std::int64_t most_boxes) {
  const floating_point_scope scope(rounding::upward);
  return search(given, most_boxes);
}

}  // namespace asterism::internal::angle_theorem
