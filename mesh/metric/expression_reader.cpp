// SPDX-License-Identifier: MIT
#include <array>
#include <cctype>
#include <map>
#include <numbers>
#include <string_view>
#include <utility>

#include "asterism/core/number_text.hpp"
#include "asterism/mesh/metric/expression_enclosure.hpp"

namespace asterism::internal {

// Reads a formula from left to right, one function for each level of precedence. Each returns the
// number of the step that makes the value; nothing where the text is not in the language.
class formula_reader {
 public:
  using step_number = std::optional<std::size_t>;
  using operation = expression_enclosure::operation;

  explicit formula_reader(const std::string& text) : text_(text) {}

  std::optional<std::vector<expression_enclosure::step>> read() {
    const step_number all = choice();
    skip_spaces();
    if (!all || at_ != text_.size()) return std::nullopt;
    return std::move(steps_);
  }

 private:
  struct named_operator {
    std::string_view sign;
    operation what;
    bool exchanged, negated;
  };
  struct named_function {
    std::string_view name;
    operation what;
    double factor;  // of a logarithm
  };

  step_number add(operation what, std::size_t first = 0, std::size_t second = 0,
                  std::size_t third = 0) {
    return number_of({what, 0, first, second, third});
  }
  step_number add_constant(double value, operation what = operation::constant,
                           std::size_t first = 0) {
    return number_of({what, value, first, 0, 0});
  }
  // Gives equal steps one number: so a product of equal factors is recognised as a square.
  std::size_t number_of(const expression_enclosure::step& s) {
    const auto [place, is_new] = known_.emplace(s, steps_.size());
    if (is_new) steps_.push_back(s);
    return place->second;
  }

  void skip_spaces() {
    while (at_ < text_.size() && (text_[at_] == ' ' || text_[at_] == '\t')) ++at_;
  }
  bool take(std::string_view sign) {
    skip_spaces();
    if (text_.compare(at_, sign.size(), sign) != 0) return false;
    at_ += sign.size();
    return true;
  }

  // Reads a ? b : c, which groups from the right.
  step_number choice() {
    if (++depth_ > most_nested) return std::nullopt;
    const step_number condition = disjunction();
    if (!condition || !take("?")) {
      --depth_;
      return condition;
    }
    const step_number yes = choice();
    if (!yes || !take(":")) return std::nullopt;
    const step_number no = choice();
    --depth_;
    return no ? add(operation::choice, *condition, *yes, *no) : std::nullopt;
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
    if (++depth_ > most_nested) return std::nullopt;
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
    if (at_ == text_.size()) return std::nullopt;
    const auto c = static_cast<unsigned char>(text_[at_]);
    if (std::isdigit(c) != 0 || c == '.') return written_number();
    if (take("(")) {
      const step_number inside = choice();
      return inside && take(")") ? inside : std::nullopt;
    }
    return std::isalpha(c) != 0 ? named() : std::nullopt;
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
    return value ? add_constant(value.value()) : std::nullopt;
  }

  step_number named() {
    const std::size_t begin = at_;
    while (at_ < text_.size() &&
           (std::isalnum(static_cast<unsigned char>(text_[at_])) != 0 || text_[at_] == '_'))
      ++at_;
    const std::string_view name = std::string_view(text_).substr(begin, at_ - begin);
    if (take("(")) return function(name);
    if (name == "x") return add(operation::x);
    if (name == "y") return add(operation::y);
    if (name == "pi") return add_constant(std::numbers::pi);
    if (name == "e") return add_constant(std::numbers::e);
    return std::nullopt;
  }

  step_number function(std::string_view name) {
    std::vector<std::size_t> arguments;
    do {
      const step_number argument = choice();
      if (!argument) return std::nullopt;
      arguments.push_back(*argument);
    } while (take(","));
    if (!take(")")) return std::nullopt;
    for (const named_function& f : functions)
      if (f.name == name)
        return arguments.size() == 1 ? add_constant(f.factor, f.what, arguments[0]) : std::nullopt;
    for (const named_function& f : of_several)
      if (f.name == name) return folded(f.what, arguments, name == "avg");
    return std::nullopt;
  }

  step_number folded(operation what, const std::vector<std::size_t>& arguments, bool is_mean) {
    std::size_t all = arguments[0];
    for (std::size_t i = 1; i < arguments.size(); ++i) all = *add(what, all, arguments[i]);
    if (!is_mean) return all;
    const step_number count = add_constant(static_cast<double>(arguments.size()));
    return add(operation::divide, all, *count);
  }

  // Bounds the depth of the stack; formulas nested more deeply are refused.
  static constexpr int most_nested = 200;
  static constexpr std::array<named_operator, 1> either_of = {
      {{"||", operation::disjunction, false, false}}};
  static constexpr std::array<named_operator, 1> both_of = {
      {{"&&", operation::conjunction, false, false}}};
  static constexpr std::array<named_operator, 6> comparisons = {
      {{"<=", operation::less_or_equal, false, false},
       {">=", operation::less_or_equal, true, false},
       {"==", operation::equal, false, false},
       {"!=", operation::equal, false, true},
       {"<", operation::less, false, false},
       {">", operation::less, true, false}}};
  static constexpr std::array<named_operator, 2> sums = {
      {{"+", operation::add, false, false}, {"-", operation::subtract, false, false}}};
  static constexpr std::array<named_operator, 2> products = {
      {{"*", operation::multiply, false, false}, {"/", operation::divide, false, false}}};
  static constexpr std::array<named_function, 14> functions = {
      {{"sin", operation::sine, 1},
       {"cos", operation::cosine, 1},
       {"tan", operation::tangent, 1},
       {"atan", operation::arc_tangent, 1},
       {"sinh", operation::hyperbolic_sine, 1},
       {"cosh", operation::hyperbolic_cosine, 1},
       {"tanh", operation::hyperbolic_tangent, 1},
       {"exp", operation::exponential, 1},
       {"ln", operation::logarithm, 1},
       {"log", operation::logarithm, 1},
       {"log2", operation::scaled_logarithm, 2},
       {"log10", operation::scaled_logarithm, 10},
       {"sqrt", operation::root, 1},
       {"abs", operation::absolute, 1}}};
  static constexpr std::array<named_function, 4> of_several = {{{"min", operation::lesser, 1},
                                                                {"max", operation::greater, 1},
                                                                {"sum", operation::add, 1},
                                                                {"avg", operation::add, 1}}};

  const std::string& text_;
  std::size_t at_ = 0;
  int depth_ = 0;
  std::vector<expression_enclosure::step> steps_;
  std::map<expression_enclosure::step, std::size_t> known_;  // the numbers of the steps
};

std::optional<expression_enclosure> expression_enclosure::parse(const std::string& text) {
  auto steps = formula_reader(text).read();
  if (!steps) return std::nullopt;
  expression_enclosure made;
  made.steps_ = std::move(*steps);
  return made;
}

}  // namespace asterism::internal
