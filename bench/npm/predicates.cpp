// SPDX-License-Identifier: MIT
//
// Questions for a comparison with WebAssembly, and the time that the native library takes for them:
//     predicates FOLDER
// writes FOLDER/NAME.bin, rows of four sites, for each kind of input, and prints NAME, route,
// predicate, nanoseconds of processor time a question and a sum of the answers.
// bench/npm/predicates.mjs reads the rows and prints the same of asterism-predicates.
#include <cmath>
#include <cstdio>
#include <ctime>
#include <fstream>
#include <numeric>
#include <string>
#include <vector>

#include "asterism/core/random.hpp"
#include "asterism/kernels/c_api.h"
#include "asterism/kernels/c_batch.h"

namespace {

using row = double[20];

void set(double* site, double x, double y, double m11, double m12, double m22) {
  site[0] = x, site[1] = y, site[2] = m11, site[3] = m12, site[4] = m22;
}

// A metric that rotates about the middle of the unit square, of aspect 13 at its border.
void smooth_site(double* site, double x, double y) {
  const double u = x - 0.5, v = y - 0.5;
  set(site, x, y, 1 + 12 * v * v, -12 * u * v, 1 + 12 * u * u);
}

std::vector<double> smooth(std::size_t rows) {
  asterism::internal::splitmix64 random(1);
  std::vector<double> numbers(20 * rows);
  for (std::size_t k = 0; k < rows; ++k) {
    double* const at = &numbers[20 * k];
    const double x = random.real(0, 1), y = random.real(0, 1);
    smooth_site(at, x, y);
    for (int i = 1; i < 4; ++i)
      smooth_site(at + 5 * i, x + random.real(-0.025, 0.025), y + random.real(-0.025, 0.025));
  }
  return numbers;
}

// Draws small integers, so that ties and touching are frequent. No two sites of a row have one
// position.
std::vector<double> ties(std::size_t rows) {
  asterism::internal::splitmix64 random(2);
  std::vector<double> numbers;
  while (numbers.size() < 20 * rows) {
    row at;
    bool distinct = true;
    for (int i = 0; i < 4; ++i) {
      set(at + 5 * i, random.integer(0, 7), random.integer(0, 7), random.integer(1, 3), 0,
          random.integer(1, 3));
      for (int j = 0; j < i; ++j)
        distinct &= at[5 * i] != at[5 * j] || at[5 * i + 1] != at[5 * j + 1];
    }
    if (distinct) numbers.insert(numbers.end(), at, at + 20);
  }
  return numbers;
}

double processor_nanoseconds() {
  timespec now{};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
  return 1e9 * static_cast<double>(now.tv_sec) + static_cast<double>(now.tv_nsec);
}

// Answers all rows and returns the sum of the answers. `best` receives the shortest time of five
// rounds.
template <class Answer>
long best_of_five(const Answer& answer, double& best) {
  long sum = 0;
  best = HUGE_VAL;
  for (int turn = 0; turn < 5; ++turn) {
    const double begin = processor_nanoseconds();
    sum = answer();
    best = std::fmin(best, processor_nanoseconds() - begin);
  }
  return sum;
}

struct asked {
  const char* name;
  asterism_predicate question;
};
constexpr asked questions[] = {
    {"orientation", ASTERISM_ORIENTATION}, {"compareDistance", ASTERISM_COMPARE_DISTANCE},
    {"dominates", ASTERISM_DOMINATES},     {"inWedge", ASTERISM_IN_WEDGE},
    {"encroaches", ASTERISM_ENCROACHES},   {"edgeTest", ASTERISM_EDGE_TEST}};

// A C function of many rows whose arguments are all columns of one table.
asterism_status ask_rows(asterism_predicate question, std::size_t n, const double* t,
                         signed char* to) {
  const asterism_rows a{t, 20}, b{t + 5, 20}, c{t + 10, 20}, d{t + 15, 20};
  switch (question) {
    case ASTERISM_ORIENTATION:
      return asterism_orientations(n, a, b, c, to, nullptr);
    case ASTERISM_COMPARE_DISTANCE:
      return asterism_compare_distances(n, a, b, c, to, nullptr);
    case ASTERISM_DOMINATES:
      return asterism_dominations(n, a, b, c, to, nullptr);
    case ASTERISM_IN_WEDGE:
      return asterism_in_wedges(n, a, b, c, to, nullptr);
    case ASTERISM_ENCROACHES:
      return asterism_encroachments(n, a, b, c, to, nullptr);
    default:
      return asterism_edge_tests(n, a, b, c, d, to, nullptr);
  }
}

void measure(const std::string& folder, const char* kind, const std::vector<double>& numbers) {
  std::ofstream(folder + "/" + kind + ".bin", std::ios::binary)
      .write(reinterpret_cast<const char*>(numbers.data()),
             static_cast<std::streamsize>(numbers.size() * sizeof(double)));
  const std::size_t rows = numbers.size() / 20;
  std::vector<signed char> answers(rows);
  for (const auto& [name, question] : questions) {
    double time = 0;
    const long one_by_one = best_of_five(
        [&, asking = question] {
          long sum = 0;
          for (std::size_t k = 0; k < rows; ++k) {
            const double* const at = &numbers[20 * k];
            const double* arguments[] = {at, at + 5, at + 10, at + 15};
            int answer = 0;
            asterism_ask(asking, arguments, &answer, nullptr);
            sum += answer;
          }
          return sum;
        },
        time);
    std::printf("%s one %s %.1f %ld\n", kind, name, time / static_cast<double>(rows), one_by_one);
    const long together = best_of_five(
        [&, asking = question] {
          ask_rows(asking, rows, numbers.data(), answers.data());
          return std::accumulate(answers.begin(), answers.end(), 0L);
        },
        time);
    std::printf("%s many %s %.1f %ld\n", kind, name, time / static_cast<double>(rows), together);
  }
}

}  // namespace

int main(int count, char** arguments) {
  if (count != 2) return 2;
  measure(arguments[1], "smooth", smooth(40000));
  measure(arguments[1], "ties", ties(10000));
}
