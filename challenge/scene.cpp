// SPDX-License-Identifier: MIT
#include "asterism/challenge/scene.hpp"

#include <charconv>
#include <cmath>

#include "asterism/kernels/exact_kernel.hpp"

namespace asterism::challenge {
namespace {

constexpr metric_tensor identity = {1, 0, 1};

bool is_finite(const site& s) {
  return std::isfinite(s.position.x) && std::isfinite(s.position.y) &&
         std::isfinite(s.metric.m11) && std::isfinite(s.metric.m12) && std::isfinite(s.metric.m22);
}

// Appends numbers to a record.
class record_numbers {
 public:
  explicit record_numbers(batch_record& record) : next_(record.numbers.begin()) {}

  void add(const point& p) {
    *next_++ = p.x;
    *next_++ = p.y;
  }
  void add(const metric_tensor& m) {
    for (const double number : {m.m11, m.m12, m.m22}) *next_++ = number;
  }
  void add(const site& s) {
    add(s.position);
    add(s.metric);
  }

 private:
  std::array<double, longest_record>::iterator next_;
};

void append_number(std::string& text, double number, bool decimal) {
  std::array<char, 40> digits{};
  const bool minus = std::signbit(number);
  const double size = std::fabs(number);
  char* const begin = digits.data();
  char* const end = begin + digits.size();
  const auto written = decimal ? std::to_chars(begin, end, size)
                               : std::to_chars(begin, end, size, std::chars_format::hex);
  text += minus ? " -" : " ";
  if (!decimal) text += "0x";
  text.append(begin, written.ptr);
}

}  // namespace

bool is_valid(const scene& s) {
  const exact_kernel kernel;
  if (!is_finite(site{s.at, s.tensor})) return false;
  for (std::size_t i = 0; i < s.sites.size(); ++i) {
    if (!is_finite(s.sites[i]) || !kernel.is_positive_definite(s.sites[i].metric)) return false;
    for (std::size_t j = 0; j < i; ++j)
      if (s.sites[i].position == s.sites[j].position) return false;
  }
  return true;
}

batch_record cut_record(predicate question, const scene& s) {
  batch_record record{question, {}};
  record_numbers numbers(record);
  if (question == predicate::is_positive_definite) {
    numbers.add(s.tensor);
  } else if (question == predicate::orientation) {
    numbers.add(s.sites[0].position);
    numbers.add(s.sites[1].position);
    numbers.add(s.at);
  } else if (question == predicate::in_circle) {
    numbers.add(s.sites[0].metric);
    for (const site& of : s.sites) numbers.add(of.position);
  } else {
    const record_shape shape = shape_of(question);
    for (std::size_t k = 0; k < shape.sites; ++k) numbers.add(s.sites[k]);
    if (shape.points > 0) numbers.add(s.at);
  }
  return record;
}

batch_record draw_record(const input_class& from, predicate question, random_source& random) {
  for (int attempts = 0; attempts < 10000; ++attempts)
    if (const scene s = from.attempt(random); is_valid(s)) return cut_record(question, s);
  // Returns the unit square, which is valid, if a class fails in all tries; none fails that often.
  const metric_tensor m = identity;
  return cut_record(question,
                    {{site{{0, 0}, m}, site{{1, 1}, m}, site{{1, 0}, m}, site{{0, 1}, m}}, {}, m});
}

std::string record_text(const question& asked, const batch_record& record, bool decimal) {
  std::string text(asked.name);
  const std::size_t first = asked.plain ? 3 * shape_of(asked.asked).metrics : 0;
  for (std::size_t i = first; i < numbers_of(asked.asked); ++i)
    append_number(text, record.numbers[i], decimal);
  return text;
}

}  // namespace asterism::challenge
