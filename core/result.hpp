// SPDX-License-Identifier: MIT
//
// A value or an error that says what is wrong and where. The library does not throw; what can fail
// because of its input returns a result.
#pragma once

#include <string>
#include <utility>
#include <variant>

namespace asterism {

// Why something failed. `message` is one sentence for a person and names file, line, vertex or
// number where there is one.
struct error {
  std::string message;
};

// Holds a value or an error, never both. Test it before value():
//
//   const auto read = read_medit("wing.mesh");
//   if (!read) return complain(read.failure().message);
//   use(read.value());
template <class T>
class [[nodiscard]] result {
 public:
  result(T value) : content_(std::move(value)) {}
  result(error failure) : content_(std::move(failure)) {}

  bool ok() const { return content_.index() == 0; }
  explicit operator bool() const { return ok(); }
  // Requires ok().
  const T& value() const& { return std::get<0>(content_); }
  T& value() & { return std::get<0>(content_); }
  T&& value() && { return std::get<0>(std::move(content_)); }
  // Requires !ok().
  const error& failure() const { return std::get<1>(content_); }

 private:
  std::variant<T, error> content_;
};

}  // namespace asterism
