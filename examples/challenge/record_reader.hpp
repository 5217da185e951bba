// SPDX-License-Identifier: MIT
//
// Reads records of the batch protocol and writes the answers of a function: all of an adapter
// except its predicates.
#pragma once

#include <cstdlib>
#include <iostream>
#include <sstream>
#include <string>
#include <vector>

namespace challenge_adapter {

// Reads hexadecimal and decimal numbers alike, in the C locale.
inline std::vector<double> numbers_of(std::istringstream& rest) {
  std::vector<double> numbers;
  for (std::string word; rest >> word;) numbers.push_back(std::strtod(word.c_str(), nullptr));
  return numbers;
}

// Answers every line of standard input. `answer(name, numbers, given)` sets `given`, or returns
// false if it does not know the name with so many numbers.
template <class Answer>
int answer_records(Answer answer) {
  for (std::string line; std::getline(std::cin, line);) {
    std::istringstream words(line);
    std::string name;
    if (!(words >> name) || name.front() == '#') continue;
    int given = 0;
    if (answer(name, numbers_of(words), given))
      std::cout << given << '\n';
    else
      std::cout << "error: " << name << " is not known\n";
    if (std::cin.rdbuf()->in_avail() <= 0) std::cout.flush();
  }
  return 0;
}

// Returns the sign of a number, and zero for NaN.
inline int sign_of(double value) { return (value > 0) - (value < 0); }

}  // namespace challenge_adapter
