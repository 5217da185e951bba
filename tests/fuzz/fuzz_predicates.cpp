// SPDX-License-Identifier: MIT
//
// The fuzzer's target: one record, put to the filtered kernel, to intervals and to every part of
// the filtered kernel that can be asked alone; each certain answer against the exact kernel's. A
// difference prints itself as a test and aborts. The environment variable ASTERISM_FUZZ_COUNTS
// names a file that gets the numbers of records, per predicate.
#include <array>
#include <cstdio>
#include <cstdlib>
#include <iostream>

#include "asterism/kernels/exact_kernel.hpp"
#include "asterism/kernels/filtered_kernel.hpp"
#include "asterism/kernels/interval_kernel.hpp"
#include "asterism/kernels/replay.hpp"
#include "decode_record.hpp"
#include "parts_as_kernels.hpp"

namespace {

using namespace asterism;

std::array<unsigned long long, predicate_count> accepted{};

void write_counts() {
  const char* const name = std::getenv("ASTERISM_FUZZ_COUNTS");
  std::FILE* const out = name != nullptr ? std::fopen(name, "w") : nullptr;
  if (out == nullptr) return;
  for (std::size_t p = 0; p < predicate_count; ++p)
    (void)std::fprintf(out, "%-24s %12llu\n", predicate_names[p].data(), accepted[p]);
  (void)std::fclose(out);
}

template <class Kernel>
void expect_agreement(const char* kernel_type, const batch_record& record, int expected) {
  const uncertain_int answer = ask(Kernel(), record);
  if (!answer.certain() || answer.value() == expected) return;
  std::cerr << replay_test(kernel_type, record, expected, answer.value()) << std::flush;
  std::abort();
}

}  // namespace

extern "C" int LLVMFuzzerInitialize(int*, char***) {
  (void)std::atexit(write_counts);
  return 0;
}

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const auto record = fuzz::decode_record({data, size});
  if (!record) return 0;
  ++accepted[static_cast<std::size_t>(record->question)];
  const int expected = ask(exact_kernel(), *record).value();
  expect_agreement<filtered_kernel>("asterism::filtered_kernel", *record, expected);
  expect_agreement<interval_kernel>("asterism::interval_kernel", *record, expected);
  using namespace fuzz;
  expect_agreement<gap_of_v_kernel>("asterism::fuzz::gap_of_v_kernel", *record, expected);
  expect_agreement<gap_of_w_kernel>("asterism::fuzz::gap_of_w_kernel", *record, expected);
  expect_agreement<fixed_width_kernel>("asterism::fuzz::fixed_width_kernel", *record, expected);
  expect_agreement<block_of_rows_kernel>("asterism::fuzz::block_of_rows_kernel", *record, expected);
  expect_agreement<single_row_kernel>("asterism::fuzz::single_row_kernel", *record, expected);
  return 0;
}
