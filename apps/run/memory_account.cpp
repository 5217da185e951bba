// SPDX-License-Identifier: MIT
#include "asterism/apps/run/memory_account.hpp"

#include <fcntl.h>
#include <malloc.h>
#include <sys/mman.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <limits>
#include <new>

#include "asterism/apps/run/freed_memory.hpp"
#include "asterism/mesh/support/large_page_allocator.hpp"

namespace {

constexpr auto no_limit = std::numeric_limits<std::int64_t>::max();

// Global variables, since `operator new` can reach nothing else.
std::atomic<bool> is_counting = false;
std::atomic<std::int64_t> held = 0, most = no_limit;
std::atomic<std::int64_t> next_look = no_limit;  // when this much is held

// Resident memory of the program, in bytes; 0 where the system does not report it.
struct residence {
  double all = 0, of_files = 0;  // of files: code, and constants of the program and its libraries
};

// Reads without an allocation, since `operator new` calls it.
residence read_residence() {
  const int status = open("/proc/self/statm", O_RDONLY | O_CLOEXEC);
  if (status < 0) return {};
  std::array<char, 128> text{};
  const ssize_t length = read(status, text.data(), text.size() - 1);
  close(status);
  long size = 0, pages = 0, shared = 0;
  if (length <= 0 || std::sscanf(text.data(), "%ld %ld %ld", &size, &pages, &shared) != 3)
    return {};
  const auto page = static_cast<double>(sysconf(_SC_PAGESIZE));
  return {static_cast<double>(pages) * page, static_cast<double>(shared) * page};
}

// Computes the number of bytes that may be allocated: the limit less the other resident memory,
// which differs between machines: code that was used, and freed blocks that the allocator keeps.
// Reads the resident memory again after each further megabyte that is allocated.
class allowance {
 public:
  void begin(double bytes) {
    bytes_ = bytes;
    start_ = read_residence();
    renew(start_);
  }
  void look_again() { renew(read_residence()); }

 private:
  void renew(const residence& now) {
    // Bytes reserved for code that is not resident yet, and the stacks of threads. Measured: 3 to 4
    // megabytes.
    constexpr double to_come = 4e6, at_least = 1e6;
    // Least allowance in bytes: with it the program can still report that the limit is below the
    // program's own size.
    constexpr double least = 2e6, largest = 0x1p62;
    constexpr std::int64_t between_looks = 1 << 20;
    const std::int64_t then = held.load(std::memory_order_relaxed);
    const double spare = std::max(at_least, to_come - (now.of_files - start_.of_files));
    // Takes account of allocated memory that is not resident yet: parts of it were never written.
    const double kept =
        std::max(now.all - now.of_files - static_cast<double>(then), start_.all - start_.of_files);
    most =
        static_cast<std::int64_t>(std::clamp(bytes_ - now.of_files - kept - spare, least, largest));
    next_look = then + between_looks;
  }

  double bytes_ = 0;
  residence start_;
};

allowance allowed;

bool may_hold(std::size_t more) {
  const auto asked = static_cast<std::int64_t>(std::min<std::size_t>(more, std::size_t{1} << 62));
  const std::int64_t then = held.load(std::memory_order_relaxed) + asked;
  if (then > next_look.load(std::memory_order_relaxed)) allowed.look_again();
  return then <= most.load(std::memory_order_relaxed);
}

// Asks the system for large pages, where it has them on request: the first access to each page
// takes one to ten microseconds, and data read in random order needs a page to be found for each
// access. Asks for all of a block that is aligned to such pages
// (mesh/support/large_page_allocator). Asks for the first half of another large one, too, where
// freed blocks are given back: the other half of a list that has grown may never be touched, and
// the page in which it begins would be resident, which is 2 % of all at a million triangles. Where
// freed blocks are kept, most lists lie in memory that is resident already, and a new large page
// can take the system more time than it saves (docs/results/profile.md). Where a system has no such
// pages, the request fails without effect.
void ask_for_large_pages([[maybe_unused]] void* block, [[maybe_unused]] std::size_t size,
                         [[maybe_unused]] std::size_t alignment) {
#ifdef MADV_HUGEPAGE
  constexpr std::size_t large = 4 << 20, very_large = 32 << 20;
  constexpr std::uintptr_t page = 4096;
  const bool is_for_pages = alignment >= asterism::internal::large_page;
  if (!is_for_pages && (size < large || asterism::apps::keeps_freed_blocks())) return;
  const std::size_t asked = is_for_pages || size >= very_large ? size : size / 2;
  const std::uintptr_t beyond = reinterpret_cast<std::uintptr_t>(block) % page;
  const std::size_t to_page = beyond == 0 ? 0 : page - beyond;
  madvise(static_cast<char*>(block) + to_page, asked - to_page, MADV_HUGEPAGE);
#endif
}

// Allocates exactly the size asked for: aligned_alloc() wants multiples of the alignment, which
// would take two large pages for one.
void* allocate(std::size_t size, std::size_t alignment) {
  if (alignment <= __STDCPP_DEFAULT_NEW_ALIGNMENT__) return std::malloc(size);
  void* block = nullptr;
  return posix_memalign(&block, alignment, size) == 0 ? block : nullptr;
}

// Returns the block; null if there is no memory, or too little below the limit.
void* take(std::size_t size, std::size_t alignment) {
  const bool counting = is_counting.load(std::memory_order_relaxed);
  if (counting && !may_hold(size)) return nullptr;
  void* const block = allocate(std::max<std::size_t>(size, 1), alignment);
  if (block == nullptr) return block;
  if (counting)
    held.fetch_add(static_cast<std::int64_t>(malloc_usable_size(block)), std::memory_order_relaxed);
  else
    ask_for_large_pages(block, size, alignment);
  return block;
}

void* take_or_throw(std::size_t size, std::size_t alignment) {
  void* const block = take(size, alignment);
  if (block == nullptr) throw std::bad_alloc();
  return block;
}

// Counts a freed block from before the account was opened as given back, too: the count may become
// negative, by the memory that the program held then.
void give_back(void* block) {
  if (block != nullptr && is_counting.load(std::memory_order_relaxed))
    held.fetch_sub(static_cast<std::int64_t>(malloc_usable_size(block)), std::memory_order_relaxed);
  std::free(block);
}

constexpr std::size_t ordinary = __STDCPP_DEFAULT_NEW_ALIGNMENT__;

}  // namespace

// Replaces all forms of `operator new`: by default the other forms call these, but the run-time
// library of a sanitizer has its own, whose blocks cannot be freed here.
void* operator new(std::size_t size) { return take_or_throw(size, ordinary); }
void* operator new[](std::size_t size) { return take_or_throw(size, ordinary); }
void* operator new(std::size_t size, std::align_val_t alignment) {
  return take_or_throw(size, static_cast<std::size_t>(alignment));
}
void* operator new[](std::size_t size, std::align_val_t alignment) {
  return take_or_throw(size, static_cast<std::size_t>(alignment));
}
void* operator new(std::size_t size, const std::nothrow_t&) noexcept {
  return take(size, ordinary);
}
void* operator new[](std::size_t size, const std::nothrow_t&) noexcept {
  return take(size, ordinary);
}
void* operator new(std::size_t size, std::align_val_t alignment, const std::nothrow_t&) noexcept {
  return take(size, static_cast<std::size_t>(alignment));
}
void* operator new[](std::size_t size, std::align_val_t alignment, const std::nothrow_t&) noexcept {
  return take(size, static_cast<std::size_t>(alignment));
}

void operator delete(void* block) noexcept { give_back(block); }
void operator delete[](void* block) noexcept { give_back(block); }
void operator delete(void* block, std::size_t) noexcept { give_back(block); }
void operator delete[](void* block, std::size_t) noexcept { give_back(block); }
void operator delete(void* block, std::align_val_t) noexcept { give_back(block); }
void operator delete[](void* block, std::align_val_t) noexcept { give_back(block); }
void operator delete(void* block, std::size_t, std::align_val_t) noexcept { give_back(block); }
void operator delete[](void* block, std::size_t, std::align_val_t) noexcept { give_back(block); }
void operator delete(void* block, const std::nothrow_t&) noexcept { give_back(block); }
void operator delete[](void* block, const std::nothrow_t&) noexcept { give_back(block); }
void operator delete(void* block, std::align_val_t, const std::nothrow_t&) noexcept {
  give_back(block);
}
void operator delete[](void* block, std::align_val_t, const std::nothrow_t&) noexcept {
  give_back(block);
}

namespace asterism::apps {

memory_account::memory_account(double bytes) {
  constexpr double most_over = 1.05;
  held = 0;
  allowed.begin(most_over * bytes);
  is_counting = true;
}

memory_account::~memory_account() { is_counting = false; }

double memory_account::resident() { return read_residence().all; }

}  // namespace asterism::apps
