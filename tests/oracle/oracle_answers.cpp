// SPDX-License-Identifier: MIT
//
// Answers records of the batch protocol by the oracle: one integer a line, or "-" for a tie of
// edge_test that the oracle does not decide. Takes milliseconds a record, seconds for some.
#include <iostream>
#include <optional>
#include <string>

#include "asterism/kernels/batch_protocol.hpp"
#include "oracle.hpp"

namespace asterism::oracle {
namespace {

std::optional<int> answer(const batch_record& r) {
  const auto s = [&r](std::size_t which) { return site_at(r, which); };
  switch (r.question) {
    case predicate::orientation:
      return to_int(orientation(point_at(r, 0), point_at(r, 2), point_at(r, 4)));
    case predicate::is_positive_definite:
      return is_positive_definite(metric_at(r, 0)) ? 1 : 0;
    case predicate::compare_distance:
      return to_int(compare_distance(s(0), s(1), point_at(r, 10)));
    case predicate::in_wedge:
      return in_wedge(s(0), s(1), point_at(r, 10)) ? 1 : 0;
    case predicate::dominates:
      return to_int(dominates(s(0), s(1), point_at(r, 10)));
    case predicate::voronoi_vertex_count:
      return voronoi_vertex_count(s(0), s(1), s(2));
    case predicate::arc_intersection_count:
      return arc_intersection_count(s(0), s(1), s(2));
    case predicate::encroaches:
      return encroaches(s(0), s(1), s(2)) ? 1 : 0;
    case predicate::insertion_test:
      return insertion_test(s(0), s(1), s(2), s(3)) ? 1 : 0;
    case predicate::edge_test:
      if (const auto yes = edge_test(s(0), s(1), s(2), s(3))) return *yes ? 1 : 0;
      return std::nullopt;
    case predicate::in_circle:
      return to_int(in_circle(metric_at(r, 0), point_at(r, 3), point_at(r, 5), point_at(r, 7),
                              point_at(r, 9)));
  }
  return std::nullopt;
}

}  // namespace
}  // namespace asterism::oracle

int main() {
  for (std::string line; std::getline(std::cin, line);) {
    const auto record = asterism::parse_record(line);
    if (!record) {
      std::cerr << "oracle_answers: " << record.failure().message << '\n';
      return 2;
    }
    if (!record.value()) continue;
    const auto given = asterism::oracle::answer(*record.value());
    std::cout << (given ? std::to_string(*given) : "-") << std::endl;
  }
  return 0;
}
