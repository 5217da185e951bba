// SPDX-License-Identifier: MIT
#include <algorithm>
#include <array>
#include <cctype>
#include <limits>
#include <map>
#include <numbers>
#include <optional>
#include <string_view>
#include <utility>

#include "asterism/core/number_text.hpp"
#include "asterism/mesh/metric/formula.hpp"
#include "asterism/mesh/support/one_line.hpp"

namespace asterism::internal {

namespace {

using operation = formula::operation;

struct named_operator {
  std::string_view sign;
  operation what;
  bool exchanged = false, negated = false;
};

struct named_function {
  std::string_view name;
  operation what;
  std::size_t arguments;  // unlimited: any number, at least one
  double constant = 0;
};

// Bounds the depth of the stack; formulas nested more deeply are refused.
constexpr int most_nested = 200;
constexpr std::size_t unlimited = std::numeric_limits<std::size_t>::max();
constexpr std::array<named_operator, 1> either_of = {{{"||", operation::disjunction}}};
constexpr std::array<named_operator, 1> both_of = {{{"&&", operation::conjunction}}};
constexpr std::array<named_operator, 6> comparisons = {{{"<=", operation::less_or_equal},
                                                        {">=", operation::less_or_equal, true},
                                                        {"==", operation::equal},
                                                        {"!=", operation::equal, false, true},
                                                        {"<", operation::less},
                                                        {">", operation::less, true}}};
constexpr std::array<named_operator, 2> sums = {
    {{"+", operation::add}, {"-", operation::subtract}}};
constexpr std::array<named_operator, 2> products = {
    {{"*", operation::multiply}, {"/", operation::divide}}};
constexpr std::array<named_function, 26> functions = {
    {{"sin", operation::sine, 1},
     {"cos", operation::cosine, 1},
     {"tan", operation::tangent, 1},
     {"asin", operation::arc_sine, 1},
     {"acos", operation::arc_cosine, 1},
     {"atan", operation::arc_tangent, 1},
     {"atan2", operation::angle, 2},
     {"sinh", operation::hyperbolic_sine, 1},
     {"cosh", operation::hyperbolic_cosine, 1},
     {"tanh", operation::hyperbolic_tangent, 1},
     {"asinh", operation::area_sine, 1},
     {"acosh", operation::area_cosine, 1},
     {"atanh", operation::area_tangent, 1},
     {"exp", operation::exponential, 1},
     {"ln", operation::logarithm, 1},
     {"log", operation::logarithm, 1},
     {"log2", operation::scaled_logarithm, 1, 2},
     {"log10", operation::scaled_logarithm, 1, 10},
     {"sqrt", operation::root, 1},
     {"abs", operation::absolute, 1},
     {"sign", operation::sign, 1},
     {"rint", operation::whole, 1},
     {"min", operation::lesser, unlimited},
     {"max", operation::greater, unlimited},
     {"sum", operation::total, unlimited},
     {"avg", operation::total, unlimited}}};

// Reads a formula from left to right, one function for each level of precedence. Each returns the
// number of the step that makes the value, or nothing after a failure.
class formula_reader {
 public:
  using step_number = std::optional<std::size_t>;

  explicit formula_reader(const std::string& text) : text_(text) {}

  result<formula> read() {
    skip_spaces();
    if (at_ == text_.size()) return error{"an expression is empty"};
    std::size_t values = 0;
    do {
      if (!choice()) return failure();
      ++values;
    } while (take(","));
    skip_spaces();
    if (at_ != text_.size()) return unexpected(), failure();
    if (values != 1)
      return error{"'" + text_ + "': one value is wanted, not " + std::to_string(values)};
    return formula{std::move(steps_)};
  }

 private:
  // Notes what is wrong. The first failure counts.
  std::nullopt_t fail(std::string what, std::size_t at) {
    if (wrong_.empty()) {
      wrong_ = std::move(what);
      wrong_at_ = at;
    }
    return std::nullopt;
  }
  std::nullopt_t unexpected() {
    skip_spaces();
    if (at_ == text_.size()) return fail("something is missing at the end", at_);
    const std::size_t bytes = first_character_bytes(std::string_view(text_).substr(at_));
    return fail("unexpected '" + text_.substr(at_, bytes) + "'", at_);
  }
  error failure() const {
    return {"'" + text_ + "': " + wrong_ + " (position " + std::to_string(wrong_at_ + 1) + ")"};
  }

  step_number add(operation what, std::size_t first = 0, std::size_t second = 0,
                  std::size_t third = 0) {
    return number_of({what, 0, first, second, third});
  }
  step_number add_constant(double value, operation what = operation::constant,
                           std::size_t first = 0) {
    return number_of({what, value, first, 0, 0});
  }
  // Gives equal steps one number: so a product of equal factors is recognised as a square.
  std::size_t number_of(const formula::step& s) {
    const auto [place, is_new] = known_.emplace(s, steps_.size());
    if (is_new) steps_.push_back(s);
    return place->second;
  }

  void skip_spaces() {
    while (at_ < text_.size() && text_[at_] > 0 && text_[at_] <= ' ') ++at_;
  }
  bool take(std::string_view sign) {
    skip_spaces();
    if (text_.compare(at_, sign.size(), sign) != 0) return false;
    at_ += sign.size();
    return true;
  }
  bool begin_nested() {
    if (++depth_ <= most_nested) return true;
    fail("more than " + std::to_string(most_nested) + " levels", at_);
    return false;
  }

  // Reads a ? b : c, which groups from the right. A chain of choices is no deeper than one.
  step_number choice() {
    if (!begin_nested()) return std::nullopt;
    std::vector<std::array<std::size_t, 2>> cases;  // the condition and the value where it holds
    step_number last = disjunction();
    while (last && take("?")) {
      const step_number yes = choice();
      if (!yes) return std::nullopt;
      if (!take(":")) return unexpected();
      cases.push_back({*last, *yes});
      last = disjunction();
    }
    --depth_;
    for (; last && !cases.empty(); cases.pop_back())
      last = add(operation::choice, cases.back()[0], cases.back()[1], *last);
    return last;
  }

  step_number disjunction() { return left_to_right(&formula_reader::conjunction, either_of); }
  step_number conjunction() { return left_to_right(&formula_reader::comparison, both_of); }
  step_number comparison() { return left_to_right(&formula_reader::sum, comparisons); }
  step_number sum() { return left_to_right(&formula_reader::product, sums); }
  step_number product() { return left_to_right(&formula_reader::with_sign, products); }

  template <std::size_t Count>
  step_number left_to_right(step_number (formula_reader::*next)(),
                            const std::array<named_operator, Count>& operators) {
    step_number left = (this->*next)();
    while (left) {
      const named_operator* found = nullptr;
      for (const named_operator& o : operators)
        if (found == nullptr && take(o.sign)) found = &o;
      if (found == nullptr) return left;
      const step_number right = (this->*next)();
      if (!right) return std::nullopt;
      left = found->exchanged ? add(found->what, *right, *left) : add(found->what, *left, *right);
      // Makes `a != b` from 1 - (a == b).
      if (found->negated) left = add(operation::subtract, *add_constant(1), *left);
    }
    return std::nullopt;
  }

  step_number with_sign() {
    if (!begin_nested()) return std::nullopt;
    step_number made;
    if (take("-")) {
      made = with_sign();
      if (made) made = add(operation::negate, *made);
    } else {
      made = take("+") ? with_sign() : power();
    }
    --depth_;
    return made;
  }

  step_number power() {
    const step_number base = atom();
    if (!base || !take("^")) return base;
    const step_number exponent = with_sign();
    return exponent ? add(operation::power, *base, *exponent) : std::nullopt;
  }

  step_number atom() {
    skip_spaces();
    if (at_ == text_.size()) return unexpected();
    const auto c = static_cast<unsigned char>(text_[at_]);
    if (std::isdigit(c) != 0 || c == '.') return written_number();
    if (take("(")) {
      const step_number inside = choice();
      if (!inside || take(")")) return inside;
      return unexpected();
    }
    return is_of_name(c) ? named() : unexpected();
  }

  step_number written_number() {
    const std::size_t begin = at_;
    const auto digits = [&] {
      while (at_ < text_.size() && std::isdigit(static_cast<unsigned char>(text_[at_])) != 0) ++at_;
    };
    digits();
    if (at_ < text_.size() && text_[at_] == '.') ++at_;
    digits();
    if (at_ < text_.size() && (text_[at_] == 'e' || text_[at_] == 'E')) {
      ++at_;
      if (at_ < text_.size() && (text_[at_] == '+' || text_[at_] == '-')) ++at_;
      digits();
    }
    const auto value = parse_number(std::string_view(text_).substr(begin, at_ - begin));
    return value ? add_constant(value.value()) : fail(value.failure().message, begin);
  }

  static bool is_of_name(unsigned char c) { return std::isalnum(c) != 0 || c == '_'; }

  step_number named() {
    const std::size_t begin = at_;
    while (at_ < text_.size() && is_of_name(static_cast<unsigned char>(text_[at_]))) ++at_;
    const std::string_view name = std::string_view(text_).substr(begin, at_ - begin);
    for (const named_function& f : functions)
      if (f.name == name) return function(f, begin);
    if (name == "x") return add(operation::x);
    if (name == "y") return add(operation::y);
    if (name == "pi") return add_constant(std::numbers::pi);
    if (name == "e") return add_constant(std::numbers::e);
    return fail("unknown name \"" + std::string(name) + "\"", begin);
  }

  // Reads the arguments of a function, whose name begins at `begin`.
  step_number function(const named_function& f, std::size_t begin) {
    if (!take("(")) return unexpected();
    std::vector<std::size_t> arguments;
    if (!take(")")) {
      do {
        const step_number argument = choice();
        if (!argument) return std::nullopt;
        arguments.push_back(*argument);
      } while (take(","));
      if (!take(")")) return unexpected();
    }
    const std::size_t count = arguments.size();
    if (count == 0 || (f.arguments != unlimited && count != f.arguments))
      return fail(
          "the number of arguments of " + std::string(f.name) + " is not " + std::to_string(count),
          begin);
    if (f.arguments == unlimited) return folded(f, arguments);
    return number_of({f.what, f.constant, arguments[0], count > 1 ? arguments[1] : 0, 0});
  }

  step_number folded(const named_function& f, const std::vector<std::size_t>& arguments) {
    std::size_t all = arguments[0];
    for (std::size_t i = 1; i < arguments.size(); ++i) all = *add(f.what, all, arguments[i]);
    if (f.name != "avg") return all;
    const step_number count = add_constant(static_cast<double>(arguments.size()));
    return add(operation::divide, all, *count);
  }

  const std::string& text_;
  std::size_t at_ = 0;
  int depth_ = 0;
  std::string wrong_;
  std::size_t wrong_at_ = 0;
  std::vector<formula::step> steps_;
  std::map<formula::step, std::size_t> known_;  // the numbers of the steps
};

// Returns the position of an `=` that is no part of a comparison: an assignment.
std::size_t find_assignment(const std::string& text) {
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (text[i] != '=') continue;
    if (i + 1 < text.size() && text[i + 1] == '=') {
      ++i;
    } else if (i == 0 || (text[i - 1] != '<' && text[i - 1] != '>' && text[i - 1] != '!')) {
      return i;
    }
  }
  return std::string::npos;
}

}  // namespace

result<formula> formula::read(const std::string& text) {
  if (const std::size_t at = find_assignment(text); at != std::string::npos)
    return error{"'" + text + "': assignments are not allowed (position " + std::to_string(at + 1) +
                 ")"};
  return formula_reader(text).read();
}

}  // namespace asterism::internal
