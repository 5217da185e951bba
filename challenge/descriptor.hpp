// SPDX-License-Identifier: MIT
//
// Owns file descriptors, which it closes, and makes pipes from them.
#pragma once

#include <fcntl.h>
#include <unistd.h>

#include <array>

namespace asterism::challenge {

// A descriptor that is closed when the object is destroyed.
class descriptor {
 public:
  descriptor() = default;
  explicit descriptor(int number) : number_(number) {}
  ~descriptor() { close(); }
  descriptor(const descriptor&) = delete;
  descriptor& operator=(const descriptor&) = delete;

  int number() const { return number_; }
  bool open() const { return number_ >= 0; }
  void reset(int number) {
    close();
    number_ = number;
  }
  // Returns the descriptor and gives up its ownership.
  int release() {
    const int number = number_;
    number_ = -1;
    return number;
  }
  void close() {
    if (number_ >= 0) ::close(number_);
    number_ = -1;
  }

 private:
  int number_ = -1;
};

// The two ends of a pipe; neither is inherited by programs that are run.
struct channel {
  descriptor read, write;

  bool make() {
    std::array<int, 2> ends{};
    if (::pipe2(ends.data(), O_CLOEXEC) != 0) return false;
    read.reset(ends[0]);
    write.reset(ends[1]);
    return true;
  }
};

}  // namespace asterism::challenge
