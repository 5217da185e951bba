// SPDX-License-Identifier: MIT
//
// Reads and writes questions as a file of records, with the answers beside them. A line "# class
// NAME" begins a class; a line "#= ANSWER" after a record holds its answer. Both are comments to
// the batch protocol, so such a file can be fed to any program as it is.
#pragma once

#include <cstdint>
#include <iosfwd>
#include <string>
#include <vector>

#include "asterism/challenge/input_classes.hpp"
#include "asterism/core/result.hpp"

namespace asterism::challenge {

// A question with numbers, its text, and the exact answer.
struct asked_record {
  question asked;
  std::string text;
  int answer;
};

// A class of input: its name, a sentence, and the origin of its records.
struct record_source {
  std::string name;
  std::string text;
  const input_class* made_by = nullptr;  // null: the records are listed
  std::vector<asked_record> listed;
};

// Returns the class as a source.
record_source source_of(const input_class& made_by);

// Reads the classes of a file. Records before any "# class" are of a class that is named after the
// file.
//
// Errors: the file cannot be read; a record that is refused; an answer that is not the exact one.
result<std::vector<record_source>> read_records(const std::string& path);

// Chooses records of a source.
struct record_choice {
  std::uint64_t seed = 1;
  std::size_t count = 100;  // of a class and question, where a class makes them
  bool decimal = false;     // the shortest decimals, in place of hexadecimal ones
};

// Returns the records of a source and a question. Generated records depend only on the names of
// class and question, and on the seed.
std::vector<asked_record> records_of(const record_source& source, const question& asked,
                                     const record_choice& choice);

// Writes the records of all sources and questions, with their answers.
void write_records(std::ostream& out, const std::vector<record_source>& sources,
                   const std::vector<question>& questions, const record_choice& choice);

}  // namespace asterism::challenge
