// SPDX-License-Identifier: MIT
//
// Shewchuk's adaptive predicates as gmsh has them. scripts/make-challenge compiles this file
// together with Numeric/robustPredicates.cpp of Debian's source package, which is not copied here.
#include <algorithm>

#include "record_reader.hpp"

namespace robustPredicates {
double exactinit(int filter, double maxx, double maxy, double maxz);
double orient2d(double* pa, double* pb, double* pc);
double incircle(double* pa, double* pb, double* pc, double* pd);
}  // namespace robustPredicates

namespace {

bool answer(const std::string& name, std::vector<double> n, int& given) {
  double* const p = n.data();
  using namespace robustPredicates;
  if ((name == "orient2d" || name == "orientation") && n.size() == 6)
    given = challenge_adapter::sign_of(orient2d(p, p + 2, p + 4));
  else if (name == "incircle" && n.size() == 8)
    given = challenge_adapter::sign_of(incircle(p, p + 2, p + 4, p + 6));
  else
    return false;
  return true;
}

}  // namespace

int main() {
  robustPredicates::exactinit(0, 1, 1, 1);  // without a static filter, coordinates need no bound
  return challenge_adapter::answer_records(answer);
}
