// SPDX-License-Identifier: MIT
#include "asterism/apps/memory_account.hpp"

#include <malloc.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <limits>
#include <new>

namespace {

// `operator new` can reach nothing else.
std::atomic<bool> is_counting = false;
std::atomic<std::int64_t> held = 0, most = std::numeric_limits<std::int64_t>::max();

// Returns the block, or nothing where there is no memory or no room under the limit.
void* take(std::size_t size, std::size_t alignment) {
  const bool counting = is_counting.load(std::memory_order_relaxed);
  const auto asked = static_cast<std::int64_t>(std::min<std::size_t>(size, std::size_t{1} << 62));
  if (counting &&
      held.load(std::memory_order_relaxed) + asked > most.load(std::memory_order_relaxed))
    return nullptr;
  void* const block =
      alignment <= __STDCPP_DEFAULT_NEW_ALIGNMENT__
          ? std::malloc(std::max<std::size_t>(size, 1))
          : std::aligned_alloc(alignment, (size + alignment - 1) / alignment * alignment);
  if (counting && block != nullptr)
    held.fetch_add(static_cast<std::int64_t>(malloc_usable_size(block)), std::memory_order_relaxed);
  return block;
}

void* take_or_throw(std::size_t size, std::size_t alignment) {
  void* const block = take(size, alignment);
  if (block == nullptr) throw std::bad_alloc();
  return block;
}

// A block from before the account was opened is counted as given back, too: the count may become
// negative, by what the program held then.
void give_back(void* block) {
  if (block != nullptr && is_counting.load(std::memory_order_relaxed))
    held.fetch_sub(static_cast<std::int64_t>(malloc_usable_size(block)), std::memory_order_relaxed);
  std::free(block);
}

constexpr std::size_t ordinary = __STDCPP_DEFAULT_NEW_ALIGNMENT__;

}  // namespace

// The forms for arrays, with sizes, and that do not throw call these.
void* operator new(std::size_t size) { return take_or_throw(size, ordinary); }
void* operator new(std::size_t size, std::align_val_t alignment) {
  return take_or_throw(size, static_cast<std::size_t>(alignment));
}
void operator delete(void* block) noexcept { give_back(block); }
void operator delete(void* block, std::size_t) noexcept { give_back(block); }
void operator delete(void* block, std::align_val_t) noexcept { give_back(block); }
void operator delete(void* block, std::size_t, std::align_val_t) noexcept { give_back(block); }

namespace asterism::apps {

memory_account::memory_account(double bytes) {
  // Memory the program takes besides while it runs: its code, as it comes to be used, and the
  // stacks of its threads. Measured; 3 to 4 megabytes.
  constexpr double of_its_own = 4e6, most_over = 1.05, largest = 0x1p62;
  // Under a limit that the program alone goes beyond, it can still say so.
  constexpr double least = 2e6;
  const double room = most_over * bytes - resident() - of_its_own;
  held = 0;
  most = static_cast<std::int64_t>(std::clamp(room, least, largest));
  is_counting = true;
}

memory_account::~memory_account() { is_counting = false; }

double memory_account::resident() {
  std::FILE* const status = std::fopen("/proc/self/statm", "r");
  if (status == nullptr) return 0;
  long size = 0, pages = 0;
  const bool read = std::fscanf(status, "%ld %ld", &size, &pages) == 2;
  std::fclose(status);
  return read ? static_cast<double>(pages) * static_cast<double>(sysconf(_SC_PAGESIZE)) : 0;
}

}  // namespace asterism::apps
