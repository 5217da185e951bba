// SPDX-License-Identifier: MIT
#include "asterism/kernels/replay.hpp"

#include <bit>
#include <cstdint>
#include <cstdio>

namespace asterism {
namespace {

std::string hexadecimal(double number) {
  std::array<char, 40> buffer{};
  (void)std::snprintf(buffer.data(), buffer.size(), "%a", number);
  return buffer.data();
}

std::string list(const batch_record& record, std::size_t first, std::size_t count) {
  std::string text = "{";
  for (std::size_t k = first; k < first + count; ++k)
    text.append(k == first ? "" : ", ").append(hexadecimal(record.numbers[k]));
  return text + "}";
}

std::string arguments(const batch_record& record) {
  const record_shape shape = shape_of(record.question);
  const std::size_t first_point = 3 * shape.metrics + 5 * shape.sites;
  std::string text;
  const auto append = [&text](const std::string& argument) {
    text.append(text.empty() ? "" : ",\n      ").append(argument);
  };
  for (std::size_t k = 0; k < shape.metrics; ++k) append(list(record, 3 * k, 3));
  for (std::size_t k = 0; k < shape.sites; ++k)
    append(std::string("{")
               .append(list(record, 5 * k, 2))
               .append(", ")
               .append(list(record, 5 * k + 2, 3))
               .append("}"));
  for (std::size_t k = 0; k < shape.points; ++k) append(list(record, first_point + 2 * k, 2));
  return text;
}

// Hashes the bits by FNV-1a.
std::uint32_t hash(const batch_record& record) {
  std::uint32_t value = 2166136261U;
  for (const double number : record.numbers)
    for (auto bits = std::bit_cast<std::uint64_t>(number); bits != 0; bits >>= 8U)
      value = (value ^ static_cast<std::uint32_t>(bits & 0xFFU)) * 16777619U;
  return value;
}

}  // namespace

std::string record_line(const batch_record& record) {
  std::string text(predicate_names[static_cast<std::size_t>(record.question)]);
  for (std::size_t k = 0; k < numbers_of(record.question); ++k)
    text.append(" ").append(hexadecimal(record.numbers[k]));
  return text;
}

std::string replay_test(std::string_view kernel_type, const batch_record& record, int expected,
                        int answered) {
  const std::string_view name = predicate_names[static_cast<std::size_t>(record.question)];
  const std::string_view method =
      record.question == predicate::is_positive_definite ? "is_positive_definite" : name;
  std::array<char, 16> key{};
  (void)std::snprintf(key.data(), key.size(), "%08x", static_cast<unsigned>(hash(record)));
  std::string text = "// ";
  text.append(record_line(record)).append("\n// answered ").append(std::to_string(answered));
  text.append("\nTEST_CASE(\"").append(name).append(", case ").append(key.data());
  text.append("\", \"[replay]\") {\n  const ").append(kernel_type).append(" kernel;\n");
  text.append("  const auto answer = asterism::as_integer(kernel.")
      .append(method)
      .append("(\n      ");
  text.append(arguments(record)).append("));\n");
  text.append("  if (answer.certain()) CHECK(answer.value() == ");
  text.append(std::to_string(expected)).append(");\n}\n");
  return text;
}

}  // namespace asterism
