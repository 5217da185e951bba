// SPDX-License-Identifier: MIT
//
// Carries a request to end a run early, polled by whatever takes long.
//
//   options.stop = [&]() -> std::optional<std::string> {
//     if (window.is_closed()) return "the window was closed";
//     return std::nullopt;
//   };
#pragma once

#include <concepts>
#include <functional>
#include <optional>
#include <string>
#include <type_traits>
#include <utility>

#include "asterism/core/export.h"

namespace asterism {

// Question that a run asks now and then: should it end, and why?
class ASTERISM_EXPORT cancellation {
 public:
  // Never asks for an end.
  cancellation() = default;
  // Takes any callable that returns why to end, in half a sentence, or nothing. It is called now
  // and then, from any thread of the run, and may be called again after it asked for an end.
  template <class Question>
  requires(!std::same_as<std::remove_cvref_t<Question>, cancellation> &&
           std::is_invocable_r_v<std::optional<std::string>, Question&>)
      cancellation(Question question)
      : question_(std::move(question)) {}

  // Returns why to end, or nothing.
  std::optional<std::string> poll() const { return question_ ? question_() : std::nullopt; }
  // True if the poll says to end.
  bool is_requested() const { return poll().has_value(); }

 private:
  std::function<std::optional<std::string>()> question_;
};

}  // namespace asterism
