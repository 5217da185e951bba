// SPDX-License-Identifier: MIT
//
// Holds a value or an error that says what is wrong and where. The library does not throw; what can
// fail because of its input returns a result.
#pragma once

#include <cstdio>
#include <cstdlib>
#include <string>
#include <utility>
#include <variant>

namespace asterism {

// Kind of input that was refused, for programs; the message says what was refused and where.
enum class error_code {
  invalid_input,    // none of the following, or not known more precisely
  bad_option,       // an option, or a name given for one, out of range
  bad_number,       // text that is no number, or one that is not finite
  unreadable_file,  // missing, not a regular file, or reading it failed
  unwritable_file,  // its directory is missing, or creating or writing it failed
  malformed_file,   // readable, and not what its format wants
  invalid_domain,   // segments, vertices, holes or regions that bound no domain
  invalid_metric,   // a specification of none, or no positive definite finite tensor at a point
  invalid_mesh      // indices out of range, or not a triangulation
};

// A failure because of input. It can be made from a sentence alone.
struct error {
  std::string message;  // for a person; names file, line, vertex or number where there is one
  error_code code = error_code::invalid_input;

  // Returns the same failure, its message after "place: ".
  error at(const std::string& place) const { return {place + ": " + message, code}; }
  // Returns the same failure with another code.
  error as(error_code other) const { return {message, other}; }
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
  // Requires ok(). Of a failure, writes its message to standard error and aborts.
  const T& value() const& { return *held(std::get_if<0>(&content_)); }
  T& value() & { return *held(std::get_if<0>(&content_)); }
  T&& value() && { return std::move(*held(std::get_if<0>(&content_))); }
  // Requires !ok().
  const error& failure() const { return std::get<1>(content_); }

 private:
  template <class Held>
  Held* held(Held* content) const {
    if (content != nullptr) return content;
    std::fprintf(stderr, "asterism: value() of a failure: %s\n",
                 std::get_if<1>(&content_)->message.c_str());
    std::abort();
  }

  std::variant<T, error> content_;
};

}  // namespace asterism
