// SPDX-License-Identifier: MIT
//
// Writes messages into the buffer of a C program.
#pragma once

#include <algorithm>
#include <cstddef>
#include <string>

#include "asterism/core/result.hpp"
#include "asterism/kernels/c_api.h"

namespace asterism::internal {

// Buffer of the caller, which is made empty first; a buffer of size 0 is never written to.
class message_buffer {
 public:
  message_buffer(char* text, std::size_t capacity)
      : text_(capacity > 0 ? text : nullptr), capacity_(capacity) {
    write("");
  }
  void write(const std::string& sentence) const {
    if (text_ == nullptr) return;
    const std::size_t length = std::min(sentence.size(), capacity_ - 1);
    std::copy_n(sentence.data(), length, text_);
    text_[length] = '\0';
  }
  asterism_status refuse(const error& failure) const {
    write(failure.message);
    return ASTERISM_REFUSED;
  }

 private:
  char* text_;
  std::size_t capacity_;
};

}  // namespace asterism::internal
