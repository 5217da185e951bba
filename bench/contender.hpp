// SPDX-License-Identifier: MIT
//
// Benchmarks one contender over a list of questions. A list is made when it is first needed.
#pragma once

#include <benchmark/benchmark.h>

#include <functional>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "asterism/core/sign.hpp"

namespace asterism::bench {

inline int to_number(sign s) { return to_int(s); }
inline int to_number(bool b) { return static_cast<int>(b); }
template <class Answer>
int to_number(const uncertain<Answer>& a) {
  return a.certain() ? to_number(a.value()) : 2;
}

template <class List>
class lazy {
 public:
  template <class Make>
  explicit lazy(Make make) : content_(std::make_shared<content>(content{make, {}, false})) {}

  List& get() const {
    if (!content_->made) content_->list = content_->make();
    content_->made = true;
    return content_->list;
  }

 private:
  struct content {
    std::function<List()> make;
    List list;
    bool made;
  };
  std::shared_ptr<content> content_;
};

// `ask` answers one question as a number. An iteration asks the first `count` questions of the
// list, all if `count` is 0.
template <class Question, class Ask>
void add_contender(const std::string& name, const lazy<std::vector<Question>>& questions, Ask ask,
                   std::size_t count = 0) {
  benchmark::RegisterBenchmark(name.c_str(), [=](benchmark::State& state) {
    const std::vector<Question>& list = questions.get();
    const std::size_t asked = count == 0 ? list.size() : std::min(count, list.size());
    for (auto _ : state) {
      int sum = 0;
      for (std::size_t k = 0; k < asked; ++k) sum += ask(list[k]);
      benchmark::DoNotOptimize(sum);
    }
    state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(asked));
  });
}

}  // namespace asterism::bench
