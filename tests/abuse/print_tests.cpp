// SPDX-License-Identifier: MIT
//
// print_tests FILE: the tests that a difference would be reported as, one of each predicate, kernel
// and two classes of input, to be compiled and run as they are.
#include <cstdio>
#include <fstream>
#include <ostream>
#include <set>
#include <string>

#include "asterism/challenge/input_classes.hpp"
#include "asterism/kernels/exact_kernel.hpp"
#include "asterism/kernels/replay.hpp"

namespace {

using namespace asterism;

// Uses -2 as the wrong answer: no predicate returns it.
void print_all(std::ostream& out) {
  constexpr const char* kernels[] = {"asterism::filtered_kernel", "asterism::interval_kernel",
                                     "asterism::exact_kernel"};
  challenge::random_source random(11);
  std::set<std::string> printed;  // a record drawn twice would give two tests of one name
  for (const char* const kernel : kernels)
    for (const challenge::input_class& from : challenge::input_classes().first(2))
      for (std::size_t p = 0; p < predicate_count; ++p) {
        const batch_record record = draw_record(from, static_cast<predicate>(p), random);
        if (printed.insert(record_line(record)).second)
          out << replay_test(kernel, record, ask(exact_kernel(), record).value(), -2) << '\n';
      }
}

}  // namespace

int main(int argc, char** argv) {
  std::ofstream out(argc > 1 ? argv[1] : "");
  print_all(out);
  out.close();
  if (out.good()) return 0;
  (void)std::fprintf(stderr, "print_tests: cannot write %s\n", argc > 1 ? argv[1] : "a file");
  return 2;
}
