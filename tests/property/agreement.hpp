// SPDX-License-Identifier: MIT
//
// Puts one question to every kernel and to the oracle, over many generated cases.
#pragma once

#include <catch2/catch.hpp>
#include <iostream>
#include <span>
#include <string>

#include "asterism/core/sign.hpp"
#include "asterism/kernels/double_kernel.hpp"
#include "asterism/kernels/exact_kernel.hpp"
#include "asterism/kernels/filtered_kernel.hpp"
#include "asterism/kernels/interval_kernel.hpp"
#include "generators.hpp"

namespace asterism::property {

// A build in which each case takes a hundred times longer may ask for a part of the cases.
#ifndef ASTERISM_SHARE_OF_CASES
#define ASTERISM_SHARE_OF_CASES 1
#endif

// Calls question(sites, random) `per_kind` times for each kind of generators.hpp.
template <class Question>
void for_each_case(int per_kind, Question question) {
  for (const kind& k : kinds()) {
    random_source random(0x5eed);
    for (int i = 0; i < per_kind; i += ASTERISM_SHARE_OF_CASES) {
      const four_sites sites = draw(k, random);
      question(sites, random);
    }
  }
}

inline int as_int(sign s) { return to_int(s); }
inline int as_int(bool b) { return b ? 1 : 0; }
inline int as_int(int i) { return i; }

// Reports only failures: Catch's own macros would take most of the time. The record is printed by
// itself, since Catch breaks long lines.
inline void report_failure(const std::string& replay, const std::string& what) {
  std::cerr << what << ": " << replay << '\n';
  FAIL_CHECK(what);
}

inline void expect(bool holds, const std::string& replay, const std::string& what) {
  if (!holds) report_failure(replay, what);
}

template <class T>
void expect_equal(T expected, T answer, const std::string& replay, const std::string& who) {
  if (expected != answer)
    report_failure(replay, who + " answers " + std::to_string(as_int(answer)) + ", expected " +
                               std::to_string(as_int(expected)));
}

// `ask(kernel)` puts the question to one kernel.
template <class T, class Ask>
void expect_agreement(T expected, Ask ask, const std::string& replay) {
  static const filtered_kernel filtered;
  expect_equal<T>(expected, ask(exact_kernel()), replay, "exact");
  expect_equal<T>(expected, ask(filtered), replay, "filtered");
  const uncertain<T> enclosed = ask(interval_kernel());
  if (enclosed.certain()) expect_equal<T>(expected, enclosed.value(), replay, "interval");
  (void)ask(double_kernel());  // may be wrong, but must return
}

}  // namespace asterism::property
