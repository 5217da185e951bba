// SPDX-License-Identifier: MIT
#include "decode_record.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>

#include "asterism/kernels/exact_kernel.hpp"

namespace asterism::fuzz {
namespace {

class byte_source {
 public:
  explicit byte_source(std::span<const std::uint8_t> bytes) : bytes_(bytes) {}

  std::uint8_t byte() {
    if (next_ == bytes_.size()) return 0;
    return bytes_[next_++];
  }
  double small_integer() { return static_cast<std::int8_t>(byte()); }
  int exponent() { return static_cast<std::int8_t>(byte()); }
  // Decodes any double, mostly one of ordinary size: exact arithmetic on numbers 2^1000 apart takes
  // a thousand times longer, and a fuzzer needs many cases a second.
  double raw() {
    const bool any_size = byte() % 16 == 0;
    std::uint64_t bits = 0;
    for (int k = 0; k < 8; ++k) bits = bits << 8U | byte();
    if (!any_size) {
      constexpr std::uint64_t exponent = 0x7FF0000000000000U, one = 0x3FF0000000000000U;
      const std::uint64_t size = (bits & 0x00F0000000000000U) >> 1U;  // 2^0 to 2^7
      bits = (bits & ~exponent) | (one + size);
    }
    return std::bit_cast<double>(bits);
  }

 private:
  std::span<const std::uint8_t> bytes_;
  std::size_t next_ = 0;
};

double neighbour(double x, bool up) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  return std::nextafter(x, up ? infinity : -infinity);
}

class decoder {
 public:
  decoder(byte_source& source, batch_record& record) : source_(source), record_(record) {}

  void add_coordinate() { add(coordinate()); }

  void add_metric() {
    const metric_tensor m = metric();
    add(m.m11);
    add(m.m12);
    add(m.m22);
  }

 private:
  void add(double number) { record_.numbers[count_++] = number; }

  double earlier() {
    const std::size_t which = source_.byte();
    return count_ == 0 ? 0 : record_.numbers[which % count_];
  }

  double coordinate() {
    switch (source_.byte() % 9) {
      case 0:
      case 1:
        return source_.small_integer();
      case 2:
        return source_.small_integer() / 16 + source_.small_integer();
      case 3:
        return earlier();
      case 4: {
        const bool up = source_.byte() % 2 == 0;
        return neighbour(earlier(), up);
      }
      case 5:
        return -earlier();
      case 6: {
        const double a = earlier(), b = earlier();
        return 0.5 * a + 0.5 * b;
      }
      case 7: {
        const int exponent = source_.exponent();
        const int step = source_.byte() % 16 == 0 ? 8 : 1;
        return std::ldexp(source_.small_integer(), step * exponent);
      }
      default:
        return source_.raw();
    }
  }

  // Returns the metric of an earlier site; the Euclidean one for the first site.
  metric_tensor earlier_metric() {
    const std::size_t sites = count_ / 5, which = source_.byte();
    return sites == 0 ? metric_tensor{1, 0, 1} : metric_at(record_, 5 * (which % sites) + 2);
  }

  metric_tensor metric() {
    switch (source_.byte() % 7) {
      case 0:
        return earlier_metric();
      case 1: {
        const metric_tensor m = earlier_metric();
        const int exponent = source_.exponent() / 4;
        return {std::ldexp(m.m11, exponent), std::ldexp(m.m12, exponent),
                std::ldexp(m.m22, exponent)};
      }
      case 2: {
        metric_tensor m = earlier_metric();
        const unsigned how = source_.byte();
        double& number = how % 3 == 0 ? m.m11 : how % 3 == 1 ? m.m12 : m.m22;
        number = neighbour(number, how % 2 == 0);
        return m;
      }
      case 3:
        return {source_.small_integer(), source_.small_integer(), source_.small_integer()};
      case 4: {
        const double a = source_.small_integer() / 4, b = source_.small_integer() / 4,
                     c = source_.small_integer() / 4;
        return {a * a, a * b, b * b + c * c};
      }
      case 5:
        return metric_through_origin();
      default: {
        const double a = source_.raw(), b = source_.raw();
        return {a, b, source_.raw()};
      }
    }
  }

  // Returns the site for which the origin is at squared distance beta, if that is exact: sites of
  // equal beta have bisectors through one point.
  metric_tensor metric_through_origin() {
    const double x = record_.numbers[count_ - 2], y = record_.numbers[count_ - 1];
    const double beta = source_.byte(), m12 = source_.small_integer(), m = source_.small_integer();
    if (x == 0) return {m, m12, beta / (y * y)};
    return {(beta - 2 * m12 * x * y - m * y * y) / (x * x), m12, m};
  }

  byte_source& source_;
  batch_record& record_;
  std::size_t count_ = 0;
};

bool is_accepted(const batch_record& record) {
  for (const double number : record.numbers)
    if (!std::isfinite(number)) return false;
  const exact_kernel kernel;
  if (record.question == predicate::in_circle && !kernel.is_positive_definite(metric_at(record, 0)))
    return false;
  const std::size_t sites = shape_of(record.question).sites;
  for (std::size_t i = 0; i < sites; ++i) {
    if (!kernel.is_positive_definite(site_at(record, i).metric)) return false;
    for (std::size_t j = 0; j < i; ++j)
      if (site_at(record, i).position == site_at(record, j).position) return false;
  }
  return true;
}

// Returns the number of binary orders of magnitude that the nonzero numbers span.
int spread(const batch_record& record) {
  int least = std::numeric_limits<int>::max(), most = std::numeric_limits<int>::min();
  for (const double number : record.numbers) {
    if (number == 0) continue;
    least = std::min(least, std::ilogb(number));
    most = std::max(most, std::ilogb(number));
  }
  return most < least ? 0 : most - least;
}

// True if exact arithmetic on the record takes less than a second. Widely spread records about
// sections of an arc take seconds, a thousand times the usual time. One in twenty-six of those
// drawn is kept.
bool is_affordable(const batch_record& record, unsigned lot) {
  constexpr int widest = 200;
  const bool about_sections =
      record.question == predicate::insertion_test || record.question == predicate::edge_test;
  return !about_sections || lot == 15 || spread(record) <= widest;
}

}  // namespace

std::optional<batch_record> decode_record(std::span<const std::uint8_t> bytes) {
  byte_source source(bytes);
  const unsigned first = source.byte();
  // The first byte keeps the meaning that it had before there was in_circle, which has the last
  // sixteen values.
  constexpr unsigned others = static_cast<unsigned>(predicate::in_circle), of_in_circle = 240;
  batch_record record{static_cast<predicate>(first >= of_in_circle ? others : first % others), {}};
  decoder numbers(source, record);
  const record_shape shape = shape_of(record.question);
  // Reads the metrics as coordinates: metrics that are nearly positive definite are wanted too.
  for (std::size_t k = 0; k < 3 * shape.metrics; ++k) numbers.add_coordinate();
  for (std::size_t k = 0; k < shape.sites; ++k) {
    numbers.add_coordinate();
    numbers.add_coordinate();
    numbers.add_metric();
  }
  for (std::size_t k = 0; k < 2 * shape.points; ++k) numbers.add_coordinate();
  if (!is_affordable(record, first / others) || !is_accepted(record)) return std::nullopt;
  return record;
}

}  // namespace asterism::fuzz
