// SPDX-License-Identifier: MIT
#include "asterism/kernels/batch_protocol.hpp"

#include <algorithm>
#include <iomanip>
#include <istream>
#include <ostream>
#include <string>
#include <utility>
#include <vector>

#include "asterism/core/number_text.hpp"
#include "asterism/core/similar_name.hpp"

namespace asterism {
using namespace internal;
namespace {

constexpr std::string_view blanks = " \t\r\v\f";

std::string_view next_token(std::string_view& rest) {
  const std::size_t begin = std::min(rest.find_first_not_of(blanks), rest.size());
  const std::size_t end = std::min(rest.find_first_of(blanks, begin), rest.size());
  const std::string_view token = rest.substr(begin, end - begin);
  rest.remove_prefix(end);
  return token;
}

// Returns the number of a field: field 1 is the name, so number i (from 0) is field i + 2.
std::string field(std::size_t number) { return "field " + std::to_string(number + 2); }

// A predicate that a record names, and how many of its numbers the record leaves out: "incircle"
// leaves out the metric, which is then the identity.
struct named_predicate {
  predicate question;
  std::size_t implied = 0;  // numbers that the name stands for
};

error unknown_predicate(std::string_view name) {
  std::vector<std::string> known = {"orient2d", "incircle"};
  known.insert(known.end(), predicate_names.begin(), predicate_names.end());
  return error{"field 1: unknown predicate " + quoted_token(name) + did_you_mean(name, known)};
}

result<named_predicate> parse_name(std::string_view name) {
  if (name == "orient2d") return named_predicate{predicate::orientation};
  if (name == "incircle") return named_predicate{predicate::in_circle, 3};
  const auto found = std::find(predicate_names.begin(), predicate_names.end(), name);
  if (found == predicate_names.end()) return unknown_predicate(name);
  return named_predicate{static_cast<predicate>(found - predicate_names.begin())};
}

std::optional<error> check_sites(const batch_record& record) {
  const std::size_t sites = shape_of(record.question).sites;
  const filtered_kernel kernel;
  if (record.question == predicate::in_circle && !kernel.is_positive_definite(metric_at(record, 0)))
    return error{"fields 2-4: the metric is not positive definite"};
  for (std::size_t i = 0; i < sites; ++i) {
    if (!kernel.is_positive_definite(site_at(record, i).metric))
      return error{"fields " + std::to_string(5 * i + 4) + "-" + std::to_string(5 * i + 6) +
                   ": the metric of site " + std::to_string(i + 1) + " is not positive definite"};
  }
  for (std::size_t i = 0; i < sites; ++i)
    for (std::size_t j = i + 1; j < sites; ++j)
      if (site_at(record, i).position == site_at(record, j).position)
        return error{field(5 * j) + ": sites " + std::to_string(i + 1) + " and " +
                     std::to_string(j + 1) + " are at the same position"};
  return std::nullopt;
}

}  // namespace

result<std::optional<batch_record>> parse_record(std::string_view line) {
  const std::string_view name = next_token(line);
  if (name.empty() || name.front() == '#') return std::optional<batch_record>();
  const auto question = parse_name(name);
  if (!question) return question.failure();

  const std::size_t implied = question.value().implied;
  batch_record record{question.value().question, {}};
  if (implied > 0) record.numbers = {1, 0, 1};
  const std::size_t expected = numbers_of(record.question) - implied;
  for (std::size_t i = 0;; ++i) {
    const std::string_view token = next_token(line);
    if (token.empty() != (i == expected)) {
      const std::string wanted = std::string(name) + " takes " + std::to_string(expected);
      if (token.empty()) return error{wanted + " numbers, got " + std::to_string(i)};
      return error{field(i) + ": " + wanted + " numbers, found another: " + quoted_token(token)};
    }
    if (token.empty()) break;
    const auto number = parse_number(token);
    if (!number) return error{field(i) + ": " + number.failure().message};
    record.numbers[implied + i] = number.value();
  }
  if (const auto failure = check_sites(record)) return *failure;
  return std::optional<batch_record>(record);
}

uncertain_int batch_evaluator::filtered_answer(const batch_record& record, settled_by& how) {
  tier_counters decided;
  const uncertain_int result = ask(filtered_kernel(decided), record);
  const auto tier_decided = [&](tier t) { return decided.at(record.question, t) != 0; };
  how = tier_decided(tier::semi_static) ? settled_by::semi_static
        : tier_decided(tier::interval)  ? settled_by::interval
                                        : settled_by::exact;
  return result;
}

uncertain_int batch_evaluator::answer(const batch_record& record) {
  uncertain_int result;
  settled_by how = settled_by::undecided;
  switch (choice_) {
    case kernel_choice::filtered:
      result = filtered_answer(record, how);
      break;
    case kernel_choice::exact:
      result = ask(exact_kernel(), record);
      how = settled_by::exact;
      break;
    case kernel_choice::interval:
      result = ask(interval_kernel(), record);
      how = result.certain() ? settled_by::interval : settled_by::undecided;
      break;
    case kernel_choice::plain_double:
      result = ask(double_kernel(), record);
      how = settled_by::plain_double;
      break;
  }
  ++statistics_.answers;
  ++statistics_.settled[static_cast<std::size_t>(record.question)][static_cast<std::size_t>(how)];
  return result;
}

void batch_evaluator::answer_all(std::istream& in, std::ostream& out) {
  for (std::string line; std::getline(in, line);) {
    const auto record = parse_record(line);
    if (!record) {
      ++statistics_.errors;
      out << "error: " << record.failure().message << '\n';
    } else if (record.value()) {
      const uncertain_int result = answer(*record.value());
      if (result.certain())
        out << result.value() << '\n';
      else
        out << "?\n";
    }
    if (in.rdbuf()->in_avail() <= 0) out.flush();
  }
  out.flush();
}

void write_statistics(std::ostream& out, const batch_statistics& statistics) {
  out << std::left << std::setw(24) << "predicate" << std::right;
  for (const auto name : settled_by_names) out << std::setw(13) << name;
  out << '\n';
  for (std::size_t p = 0; p < predicate_count; ++p) {
    const auto& row = statistics.settled[p];
    if (std::all_of(row.begin(), row.end(), [](std::uint64_t n) { return n == 0; })) continue;
    out << std::left << std::setw(24) << predicate_names[p] << std::right;
    for (const auto count : row) out << std::setw(13) << count;
    out << '\n';
  }
  out << "answers " << statistics.answers << ", errors " << statistics.errors << '\n';
}

}  // namespace asterism
