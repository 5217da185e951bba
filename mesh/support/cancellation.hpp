// SPDX-License-Identifier: MIT
//
// Carries a request to end a run early, polled by long operations, and the account of the work that
// the run may still do.
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

// A question that a run asks from time to time: whether to end, and why; with the account of its
// work.
class ASTERISM_EXPORT cancellation {
 public:
  // Makes a question that never ends the run.
  cancellation() = default;
  // Takes any callable that returns the reason to end, in half a sentence, or nothing. It is called
  // from time to time, from any thread of the run, also after it asked for an end.
  template <class Question>
  requires(!std::same_as<std::remove_cvref_t<Question>, cancellation> &&
           std::is_invocable_r_v<std::optional<std::string>, Question&>)
      cancellation(Question question)
      : question_(std::move(question)) {}

  // Returns the reason to end, or nothing.
  std::optional<std::string> poll() const {
    if (auto why = told()) return why;
    if (units_left() > 0) return std::nullopt;
    return "the most work that is done for one run was done";
  }
  // True if the run is to end.
  bool is_requested() const { return poll().has_value(); }
  // Returns the answer of the callable alone, whatever work is left.
  std::optional<std::string> told() const { return question_ ? question_() : std::nullopt; }

  // Returns the same question with an account of work that ends the run when it is used up:
  // `units` of kernels/work_units.hpp (about ten microseconds each), and `for_site` for each site
  // of the largest mesh. Work is counted and not timed, so that a run ends at the same place
  // everywhere.
  cancellation with_work(double units, double for_each_site = 0) const {
    cancellation limited = *this;
    limited.account_ = std::make_shared<account>(account{units, for_each_site, 0, account_});
    return limited;
  }
  // Returns the same question with a part of the work that is left, for a step of the run;
  // unchanged if there is no account. Work of the step is charged to the whole as well.
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
  // Charges units of work to the account. Must be called from the thread that the run belongs to,
  // while no other thread polls; the same holds for expect().
  void charge(double units) const {
    for (account* a = account_.get(); a != nullptr; a = a->whole.get()) a->left -= units;
  }
  // Announces the number of sites: large meshes may take more work.
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
