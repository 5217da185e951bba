// SPDX-License-Identifier: MIT
//
// Bounds the work of an audit: where metrics vary wildly every site is tested against every other,
// in exact numbers that take milliseconds each. Counted, not timed, so that every audit of a mesh
// ends at the same place. Internal to the auditor.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "asterism/kernels/work_units.hpp"
#include "asterism/mesh/audit/context.hpp"
#include "asterism/mesh/support/work_weights.hpp"

namespace asterism::internal::audit_detail {

// Returns the greatest work of an audit of this number of sites, in units of
// kernels/work_units.hpp: four seconds and half a millisecond a site. An audit that certifies a
// mesh usually takes a fiftieth of it.
inline double most_audit_units(std::size_t sites) {
  constexpr double at_least = 4e5, for_each = 50, first_ones = 5000, for_more = 20;
  const auto n = static_cast<double>(sites);
  return at_least + for_each * (n < first_ones ? n : first_ones) +
         for_more * (n < first_ones ? 0 : n - first_ones);
}

// Returns the work of the decisions counted in a report, plus `looked_units` for operations that it
// does not count, in work units.
inline double audit_units(const audit_report& counted, double looked_units) {
  return work_units(counted.counters) + looked_units +
         work_weights::audited_pair *
             static_cast<double>(counted.star_pairs + counted.voronoi_pairs) +
         work_weights::audited_exact_pair * static_cast<double>(counted.voronoi_pairs_exact);
}

// Returns the work units that are left for the audit and for the run it belongs to, whichever are
// fewer; may be negative.
inline double units_left(const audit_context& context) {
  return std::min(context.share_of_work * most_audit_units(context.report.sites),
                  context.options.stop.units_left()) -
         audit_units(context.report, context.looked_units);
}

// Decides when a part of a check ends early for its work or for a stop. Used by one thread.
class audit_work_guard {
 public:
  audit_work_guard(const audit_context& context, audit_tally& tally)
      : stop_(context.options.stop), tally_(tally) {}

  // Adds work units of operations that no counter of the report shows.
  void count(double units) { tally_.looked_units += units; }

  // True once the part has used up its work, or the run is told to stop; it stays true then. Polls
  // the stop, which may read a clock, only after some work since the last poll.
  bool is_over() {
    constexpr std::size_t asked_between = 16, asked_between_polls = 64;
    constexpr double units_between_polls = 1000;  // ten milliseconds
    if (tally_.unfinished) return true;
    const std::uint64_t slow = tally_.part.counters.limb_products;
    if (++asked_ % asked_between != 0 && slow == slow_) return false;
    slow_ = slow;
    const double units = audit_units(tally_.part, tally_.looked_units);
    if (units > tally_.most_units) return tally_.unfinished = true;
    if (++looked_ % asked_between_polls != 0 && units < polled_at_ + units_between_polls)
      return false;
    polled_at_ = units;
    tally_.told = stop_.poll();
    return tally_.unfinished = tally_.told.has_value();
  }

 private:
  const cancellation& stop_;
  audit_tally& tally_;
  std::uint64_t slow_ = 0;
  std::size_t asked_ = 0, looked_ = 0;
  double polled_at_ = 0;
};

// Calls `check` as check_in_parallel does, within the work that is left for the audit. Each chunk
// gets an even share. A chunk that exceeds its share, as one star may need hundreds of times the
// work of another, is repeated with the work that the others did not use, in order. So the report
// does not depend on threads, and the total keeps to the limit. A check must write the same when
// repeated.
template <class Check>
void check_in_shares(audit_context& context, std::size_t count, const Check& check,
                     std::size_t chunk) {
  double left = units_left(context);
  std::vector<audit_tally> tallies = tallies_of(context, count, check, chunk, left);
  for (const audit_tally& tally : tallies) left -= audit_units(tally.part, tally.looked_units);
  for (std::size_t i = 0; i < tallies.size(); ++i) {
    if (!tallies[i].unfinished || !(left > 0) || context.options.stop.is_requested()) continue;
    audit_tally again;
    again.findings_kept = tallies[i].findings_kept;
    // Counts the work of the first try of a chunk, which is repeated now.
    const double done = audit_units(tallies[i].part, tallies[i].looked_units);
    again.looked_units = done;
    again.most_units = done + left;
    check(again, i * chunk, std::min(count, (i + 1) * chunk));
    left -= audit_units(again.part, again.looked_units) - done;
    tallies[i] = std::move(again);
  }
  for (audit_tally& tally : tallies) context.take(std::move(tally));
}

// Calls `check` as check_in_shares does, for successive parts of [0, count), until `ended` returns
// true, the audit is told to stop, or its work is used up. Returns whether everything was checked.
// The first parts are small, as a few stars may be enough to refuse a mesh; the place where the
// checks end does not depend on threads.
template <class Check, class Ended>
bool check_in_parts(audit_context& context, std::size_t count, const Check& check,
                    const Ended& ended) {
  constexpr std::size_t at_a_time = 128, most = 32 * at_a_time, first_part = 16, pieces = 16;
  std::size_t part = first_part;
  for (std::size_t first = 0, size = 0; first < count; first += size) {
    size = std::min(part, count - first);
    part = std::min(2 * part, most);
    const std::size_t chunk = std::clamp(size / pieces, std::size_t{1}, at_a_time);
    const auto in_part = [&](audit_tally& tally, std::size_t begin, std::size_t end) {
      check(tally, first + begin, first + end);
    };
    check_in_shares(context, size, in_part, chunk);
    if (ended() || context.unfinished) return false;
    if (!context.told) context.told = context.options.stop.poll();
    if (context.told) return false;
  }
  return true;
}

// Returns, as a sentence for a finding, why a check ended early.
inline std::string unfinished_text(const audit_context& context, const std::string& what) {
  const auto why = context.told ? context.told : context.options.stop.poll();
  return what + " were not all looked at: " +
         (why ? *why : "the most work that is done for so many sites was done");
}

}  // namespace asterism::internal::audit_detail
