// SPDX-License-Identifier: MIT
#include "asterism/challenge/record_file.hpp"

#include <filesystem>
#include <fstream>
#include <ostream>

#include "asterism/core/number_text.hpp"
#include "asterism/kernels/batch_protocol.hpp"

namespace asterism::challenge {
namespace {

constexpr std::string_view class_mark = "# class ";
constexpr std::string_view answer_mark = "#= ";

// Returns the exact answer, by the filtered kernel, which always has one.
int exact_answer(const batch_record& record) { return ask(filtered_kernel(), record).value(); }

std::uint64_t text_bits(std::string_view text) {
  std::uint64_t bits = 0xcbf29ce484222325U;  // FNV-1a
  for (const char c : text) bits = (bits ^ static_cast<unsigned char>(c)) * 0x100000001b3U;
  return bits;
}

// Returns a line without its end of line and the blanks around it.
std::string_view trimmed(std::string_view line) {
  constexpr std::string_view blanks = " \t\r\v\f";
  const std::size_t first = line.find_first_not_of(blanks);
  if (first == std::string_view::npos) return {};
  return line.substr(first, line.find_last_not_of(blanks) - first + 1);
}

class file_reader {
 public:
  explicit file_reader(std::string path) : path_(std::move(path)) {}

  std::optional<error> take(std::string_view line) {
    ++line_number_;
    line = trimmed(line);
    if (line.starts_with(class_mark)) {
      begin_class(std::string(trimmed(line.substr(class_mark.size()))));
    } else if (line.starts_with(answer_mark)) {
      return check_answer(trimmed(line.substr(answer_mark.size())));
    } else if (const auto record = parse_record(line); !record) {
      return here(record.failure().message);
    } else if (record.value()) {
      add(*record.value(), line);
    }
    return std::nullopt;
  }

  std::vector<record_source> sources() && { return std::move(sources_); }

 private:
  error here(const std::string& message) const {
    return error{path_ + ":" + std::to_string(line_number_) + ": " + message,
                 error_code::malformed_file};
  }

  void begin_class(const std::string& name) {
    for (current_ = 0; current_ < sources_.size(); ++current_)
      if (sources_[current_].name == name) return;
    sources_.push_back({name, "records of " + path_, nullptr, {}});
  }

  void add(const batch_record& record, std::string_view line) {
    if (sources_.empty()) begin_class(std::filesystem::path(path_).stem().string());
    const std::string_view name = line.substr(0, line.find_first_of(" \t\v\f\r"));
    sources_[current_].listed.push_back(
        {*question_named(name), std::string(line), exact_answer(record)});
  }

  std::optional<error> check_answer(std::string_view given) const {
    if (sources_.empty() || sources_[current_].listed.empty())
      return here("an answer without a record");
    const std::string exact = std::to_string(sources_[current_].listed.back().answer);
    if (given == exact) return std::nullopt;
    return here("says " + internal::quoted_token(given) + ", the exact answer is " + exact);
  }

  std::string path_;
  std::size_t line_number_ = 0;
  std::vector<record_source> sources_;
  std::size_t current_ = 0;  // the class that records are added to
};

}  // namespace

record_source source_of(const input_class& made_by) {
  return {std::string(made_by.name), std::string(made_by.text), &made_by, {}};
}

result<std::vector<record_source>> read_records(const std::string& path) {
  std::error_code ignored;
  if (std::filesystem::is_directory(path, ignored))
    return error{path + ": is a directory, not a file of records", error_code::unreadable_file};
  std::ifstream in(path, std::ios::binary);
  if (!in) return error{path + ": cannot be opened for reading", error_code::unreadable_file};
  file_reader reader(path);
  for (std::string line; std::getline(in, line);)
    if (auto failure = reader.take(line)) return *failure;
  if (in.bad()) return error{path + ": reading failed", error_code::unreadable_file};
  return std::move(reader).sources();
}

std::vector<asked_record> records_of(const record_source& source, const question& asked,
                                     const record_choice& choice) {
  std::vector<asked_record> records;
  if (source.made_by == nullptr) {
    for (const asked_record& r : source.listed)
      if (r.asked.name == asked.name) records.push_back(r);
    return records;
  }
  random_source random(internal::mixed_bits(choice.seed ^ text_bits(source.name)) ^
                       text_bits(asked.name));
  for (std::size_t i = 0; i < choice.count; ++i) {
    batch_record record = draw_record(*source.made_by, asked.asked, random);
    if (asked.plain && asked.asked == predicate::in_circle) {
      record.numbers[0] = record.numbers[2] = 1;
      record.numbers[1] = 0;
    }
    records.push_back({asked, record_text(asked, record, choice.decimal), exact_answer(record)});
  }
  return records;
}

void write_records(std::ostream& out, const std::vector<record_source>& sources,
                   const std::vector<question>& questions, const record_choice& choice) {
  for (const record_source& source : sources) {
    out << class_mark << source.name << '\n';
    for (const question& asked : questions)
      for (const asked_record& r : records_of(source, asked, choice))
        out << r.text << '\n' << answer_mark << r.answer << '\n';
  }
}

}  // namespace asterism::challenge
