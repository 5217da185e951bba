// SPDX-License-Identifier: MIT
#include "asterism/mesh/support/thread_pool.hpp"

#include <algorithm>
#include <atomic>
#include <cfenv>
#include <condition_variable>
#include <exception>
#include <mutex>
#include <thread>
#include <utility>
#include <vector>

#include "asterism/mesh/support/thread_limit.hpp"
#include "asterism/mesh/support/thread_state.hpp"

namespace asterism::internal {

// The threads that work on an outermost loop and on the loops inside it. All but the limit is
// guarded by the pool's lock.
struct loop_team {
  std::size_t limit = 1;
  std::size_t members = 1;
  std::vector<team_loop*> open = {};  // loops that have begun and not ended, outer ones first
};

struct team_loop {
  loop_team& of;
  team_loop* around;  // null for the outermost
  std::size_t count;
  loop_part part;
  const void* work;
  std::atomic<std::size_t> next = 0;
  std::atomic<std::size_t> helpers = 0;  // threads in it besides the one that began it
  std::exception_ptr failure = {};       // guarded by the pool's lock
};

namespace {

#ifndef ASTERISM_ONE_THREAD

bool has_work(const team_loop& l) { return l.next.load(std::memory_order_relaxed) < l.count; }

bool is_inside(const team_loop& l, const team_loop* outer) {
  const team_loop* at = &l;
  while (at != nullptr && at != outer) at = at->around;
  return at == outer;
}

class thread_pool {
 public:
  // Returns the pool of the process. It is never destroyed, since its threads wait in it until the
  // process ends.
  static thread_pool& instance() {
    static thread_pool& pool = *new thread_pool;
    return pool;
  }

  void run(team_loop& l) {
    thread_state& state = this_thread();
    const thread_state outside = state;
    open(l);
    state = {&l.of, l.around, l.of.limit, 0};
    work_on(l);
    finish(l);
    state = outside;
    if (l.failure) std::rethrow_exception(l.failure);
  }

 private:
  // Number of polls before a thread sleeps, one to two milliseconds. Waking takes some tens of
  // microseconds, and a pass of an adaptation begins loops that often.
  static constexpr int polls = 4000;

  void open(team_loop& l) {
    const std::lock_guard<std::mutex> alone(lock_);
    // The team is listed last: where memory ends before, nothing refers to it.
    l.of.open.push_back(&l);
    if (l.around == nullptr) {
      teams_.push_back(&l.of);
      begin_threads(l.of.limit - 1);
    }
    opened_.fetch_add(1, std::memory_order_relaxed);
    if (sleeping_ > 0) work_.notify_one();
    if (waiting_ > 0) ended_.notify_all();
  }

  // Fewer threads than wanted do as well, where the system or the memory has no more.
  void begin_threads(std::size_t wanted) {
    try {
      for (; threads_ < wanted; ++threads_) std::thread([this] { serve(); }).detach();
    } catch (const std::exception&) {
    }
  }

  // Works on parts until none is left. Parts get smaller towards the end, for threads to end it at
  // the same time.
  void work_on(team_loop& l) {
    team_loop*& inside = this_thread().inside;
    team_loop* const outer = std::exchange(inside, &l);
    const std::size_t share = 4 * l.of.limit;
    std::size_t begin = l.next.load(std::memory_order_relaxed);
    while (begin < l.count) {
      const std::size_t end = begin + std::max<std::size_t>(1, (l.count - begin) / share);
      if (!l.next.compare_exchange_weak(begin, end, std::memory_order_relaxed)) continue;
      try {
        l.part(l.work, begin, end);
      } catch (...) {
        const std::lock_guard<std::mutex> alone(lock_);
        if (!l.failure) l.failure = std::current_exception();
        l.next.store(l.count, std::memory_order_relaxed);
      }
      begin = l.next.load(std::memory_order_relaxed);
    }
    inside = outer;
  }

  // Waits for the helpers of a loop, and works on loops inside it meanwhile.
  void finish(team_loop& l) {
    for (int i = 0; i < polls && l.helpers.load(std::memory_order_acquire) > 0; ++i)
      std::this_thread::yield();
    std::unique_lock<std::mutex> alone(lock_);
    while (l.helpers.load(std::memory_order_relaxed) > 0) {
      if (team_loop* const other = find_loop(l.of, &l)) {
        help(*other, alone);
      } else {
        ++waiting_;
        ended_.wait(alone);
        --waiting_;
      }
    }
    l.of.open.erase(std::find(l.of.open.begin(), l.of.open.end(), &l));
    if (l.around == nullptr) teams_.erase(std::find(teams_.begin(), teams_.end(), &l.of));
  }

  // Returns a loop of the team with work left, inside `outer` if that is not null.
  static team_loop* find_loop(const loop_team& t, const team_loop* outer) {
    for (team_loop* const l : t.open)
      if (has_work(*l) && (outer == nullptr || is_inside(*l, outer))) return l;
    return nullptr;
  }

  // Works on a loop of another thread. Called and left with the lock.
  void help(team_loop& l, std::unique_lock<std::mutex>& alone) {
    l.helpers.fetch_add(1, std::memory_order_relaxed);
    alone.unlock();
    work_on(l);
    alone.lock();
    if (l.helpers.fetch_sub(1, std::memory_order_release) == 1) ended_.notify_all();
  }

  // Joins teams that have work, and rests where none has, until the process ends.
  void serve() {
    std::fesetenv(FE_DFL_ENV);  // the thread that began this one may be in another rounding mode
    std::unique_lock<std::mutex> alone(lock_);
    while (true) {
      const std::size_t seen = opened_.load(std::memory_order_relaxed);
      if (!join_team(alone)) rest(seen, alone);
    }
  }

  // Works for a team that has work and room, until it has no work left. Returns false if there is
  // none.
  bool join_team(std::unique_lock<std::mutex>& alone) {
    for (loop_team* const t : teams_) {
      team_loop* l = t->members < t->limit ? find_loop(*t, nullptr) : nullptr;
      if (l == nullptr) continue;
      ++t->members;
      this_thread() = {t, nullptr, t->limit, 0};
      // Wakes the next thread, which wakes another one: sooner than one after the other.
      if (t->members < t->limit && sleeping_ > 0) work_.notify_one();
      // The team and its loops last while the lock is held, since whoever began them needs it to
      // end them.
      for (; l != nullptr; l = find_loop(*t, nullptr)) help(*l, alone);
      --t->members;
      this_thread() = {};
      return true;
    }
    return false;
  }

  // Waits until a loop begins after `seen` ones.
  void rest(std::size_t seen, std::unique_lock<std::mutex>& alone) {
    alone.unlock();
    for (int i = 0; i < polls && opened_.load(std::memory_order_relaxed) == seen; ++i)
      std::this_thread::yield();
    alone.lock();
    if (opened_.load(std::memory_order_relaxed) != seen) return;
    ++sleeping_;
    work_.wait(alone);
    --sleeping_;
  }

  std::mutex lock_;
  std::condition_variable work_, ended_;
  std::vector<loop_team*> teams_;
  std::size_t threads_ = 0;              // that have been started
  std::size_t sleeping_ = 0;             // threads in work_
  std::size_t waiting_ = 0;              // threads in ended_
  std::atomic<std::size_t> opened_ = 0;  // number of loops so far
};

#endif

}  // namespace

void run_loop(std::size_t count, loop_part part, const void* work) {
#ifdef ASTERISM_ONE_THREAD
  part(work, 0, count);
#else
  const thread_state& state = this_thread();
  // A limit that was set inside of a loop makes a team of its own.
  const bool is_outermost = state.member_of == nullptr || state.limit != 0;
  loop_team own{thread_count()};
  team_loop l{is_outermost ? own : *state.member_of, is_outermost ? nullptr : state.inside, count,
              part, work};
  thread_pool::instance().run(l);
#endif
}

}  // namespace asterism::internal
