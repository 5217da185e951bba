// SPDX-License-Identifier: MIT
//
// Carries a request to end a run early, polled by whatever takes long, and the account of the work
// that the run may still do.
//
//   options.stop = [&]() -> std::optional<std::string> {
//     if (window.is_closed()) return "the window was closed";
//     return std::nullopt;
//   };
#pragma once

#include <algorithm>
#include <concepts>
#include <cstddef>
#include <functional>
#include <limits>
#include <memory>
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
  std::optional<std::string> poll() const {
    if (auto why = told()) return why;
    if (units_left() > 0) return std::nullopt;
    return "the most work that is done for one run was done";
  }
  // True if the poll says to end.
  bool is_requested() const { return poll().has_value(); }
  // Returns what the question alone says, whatever work is left.
  std::optional<std::string> told() const { return question_ ? question_() : std::nullopt; }

  // Returns the same question with an account of work, of which it says to end when it is used up:
  // so many units of kernels/work_units.hpp (about ten microseconds each), and so many for each
  // site of the largest mesh. Work is counted and not timed, so that a run ends at the same place
  // everywhere.
  cancellation with_work(double units, double for_each_site = 0) const {
    cancellation limited = *this;
    limited.account_ = std::make_shared<account>(account{units, for_each_site, 0, account_});
    return limited;
  }
  // Returns the same with a part of what is left, for a step of the run; the same if there is no
  // account. What the step is charged is taken off the whole.
  cancellation part(double share) const {
    if (!account_) return *this;
    cancellation limited = with_work(share * units_left(), share * account_->for_each_site);
    limited.account_->sites = account_->sites;
    return limited;
  }
  // Returns the units of work that are left, which may be negative; infinite without an account.
  double units_left() const {
    double least = std::numeric_limits<double>::infinity();
    for (const account* a = account_.get(); a != nullptr; a = a->whole.get())
      least = std::min(least, a->left);
    return least;
  }
  // Takes units of work off the account. Only for the thread that the run belongs to, while no
  // other one polls; and so is expect().
  void charge(double units) const {
    for (account* a = account_.get(); a != nullptr; a = a->whole.get()) a->left -= units;
  }
  // Tells how many sites there are: large meshes may take more work.
  void expect(std::size_t sites) const {
    for (account* a = account_.get(); a != nullptr; a = a->whole.get()) {
      if (sites <= a->sites) continue;
      a->left += a->for_each_site * static_cast<double>(sites - a->sites);
      a->sites = sites;
    }
  }

 private:
  struct account {
    double left = 0, for_each_site = 0;
    std::size_t sites = 0;           // of the largest mesh so far
    std::shared_ptr<account> whole;  // of which this one is a part; null if none
  };

  std::function<std::optional<std::string>()> question_;
  std::shared_ptr<account> account_;
};

}  // namespace asterism
