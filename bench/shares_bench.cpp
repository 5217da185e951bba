// SPDX-License-Identifier: MIT
//
// How often plain doubles are wrong, and which tier decides: counted, not timed, over every input
// class and, for the plot, over closeness to the place where the answer changes. There the time of
// a question is measured as well, the median of interleaved rounds. JSON on standard output.
#include <algorithm>
#include <chrono>
#include <exception>
#include <iostream>
#include <nlohmann/json.hpp>
#include <string>

#include "asterism/kernels/double_kernel.hpp"
#include "asterism/kernels/exact_kernel.hpp"
#include "asterism/kernels/filtered_kernel.hpp"
#include "inputs.hpp"

namespace asterism::bench {

namespace {

using json = nlohmann::ordered_json;  // keeps the order of registration

constexpr std::size_t pointwise_count = 4000, edge_count = 400;

// Counts wrong answers of the double kernel, and the tiers that decided, among `questions`.
template <class Question, class Ask>
json count(predicate which, const std::vector<Question>& questions, Ask ask) {
  const double_kernel plain;
  const exact_kernel exact;
  tier_counters decided;
  const filtered_kernel filtered(decided);
  std::size_t wrong = 0, filtered_wrong = 0;
  for (const Question& q : questions) {
    const auto truth = ask(exact, q);
    wrong += ask(plain, q) != truth ? 1 : 0;
    filtered_wrong += ask(filtered, q) != truth ? 1 : 0;
  }
  json result = {
      {"questions", questions.size()}, {"double wrong", wrong}, {"filtered wrong", filtered_wrong}};
  for (std::size_t t = 0; t < tier_count; ++t)
    result["tiers"][std::string(tier_names[t])] = decided.at(which, static_cast<tier>(t));
  return result;
}

constexpr auto ask_orientation = [](const auto& k, const line_question& q) {
  return k.orientation(q[0], q[1], q[2]);
};
constexpr auto ask_compare_distance = [](const auto& k, const point_question& q) {
  return k.compare_distance(q.v, q.w, q.q);
};
constexpr auto ask_in_wedge = [](const auto& k, const point_question& q) {
  return k.in_wedge(q.v, q.w, q.q);
};
constexpr auto ask_dominates = [](const auto& k, const point_question& q) {
  return k.dominates(q.v, q.w, q.q);
};
constexpr auto ask_edge_test = [](const auto& k, const edge_question& q) {
  return k.edge_test(q[0], q[1], q[2], q[3]);
};

json count_class(input_class which) {
  const auto bisector = point_questions(which, border::bisector, pointwise_count);
  const auto wedge = point_questions(which, border::wedge, pointwise_count);
  const auto lines = line_questions(which, pointwise_count);
  json result;
  result["orientation"] = count(predicate::orientation, lines, ask_orientation);
  result["compare_distance"] = count(predicate::compare_distance, bisector, ask_compare_distance);
  result["in_wedge"] = count(predicate::in_wedge, wedge, ask_in_wedge);
  result["dominates"] = count(predicate::dominates, bisector, ask_dominates);
  result["edge_test, equal metrics"] =
      count(predicate::edge_test, circle_questions(which, pointwise_count), ask_edge_test);
  result["edge_test"] =
      count(predicate::edge_test, edge_questions(which, edge_count), ask_edge_test);
  return result;
}

// Returns nanoseconds per question, the median of rounds in which both kernels take turns.
template <class Question, class Ask>
json time_both(const std::vector<Question>& questions, Ask ask) {
  constexpr std::size_t rounds = 7;
  const double_kernel plain;
  const filtered_kernel filtered;
  std::array<std::vector<double>, 2> times;
  int sum = 0;
  const auto time = [&](const auto& kernel, std::vector<double>& into) {
    const auto start = std::chrono::steady_clock::now();
    for (const Question& q : questions) sum += static_cast<int>(ask(kernel, q));
    const std::chrono::duration<double, std::nano> taken = std::chrono::steady_clock::now() - start;
    into.push_back(taken.count() / static_cast<double>(questions.size()));
  };
  for (std::size_t round = 0; round < rounds; ++round) {
    time(plain, times[0]);
    time(filtered, times[1]);
  }
  for (auto& list : times) std::sort(list.begin(), list.end());
  // Uses the sum, so that the calls are not optimised away.
  return {{"double", times[0][rounds / 2]}, {"filtered", times[1][rounds / 2]}, {"sum", sum}};
}

template <class Question, class Ask>
json at_closeness(predicate which, int bits, const std::vector<Question>& questions, Ask ask) {
  json result = count(which, questions, ask);
  result["bits"] = bits;
  result["nanoseconds"] = time_both(questions, ask);
  return result;
}

// Draws questions at a relative distance of 2^-bits from a change of the answer.
json count_by_closeness() {
  json result = {{"compare_distance", json::array()},
                 {"edge_test, equal metrics", json::array()},
                 {"edge_test", json::array()}};
  for (int bits = 4; bits <= 52; bits += 3) {
    const double closeness = std::ldexp(1.0, -bits);
    result["compare_distance"].push_back(at_closeness(
        predicate::compare_distance, bits, point_questions_near(border::bisector, closeness, 2000),
        ask_compare_distance));
    result["edge_test, equal metrics"].push_back(at_closeness(
        predicate::edge_test, bits, circle_questions_near(closeness, 1000), ask_edge_test));
    result["edge_test"].push_back(at_closeness(predicate::edge_test, bits,
                                               edge_questions_near(closeness, 200), ask_edge_test));
  }
  return result;
}

int run_all() {
  json result;
  for (const named_class& c : input_classes)
    result["classes"].push_back({{"name", c.name}, {"predicates", count_class(c.which)}});
  result["closeness"] = count_by_closeness();
  std::cout << result.dump(1) << '\n';
  return std::cout.good() ? 0 : 1;
}

}  // namespace

}  // namespace asterism::bench

int main() try { return asterism::bench::run_all(); } catch (const std::exception& failure) {
  std::cerr << "shares_bench: " << failure.what() << '\n';
  return 1;
}
