// SPDX-License-Identifier: MIT
#include "asterism/mesh/metric/size_wishes.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "asterism/core/number_text.hpp"

namespace asterism {
using namespace internal;
namespace {

struct range {
  double low, high;
  const char* text;
};

constexpr range lengths = {1e-150, 1e150, "from 1e-150 to 1e150"};
constexpr range radii = {0, 1e150, "from 0 to 1e150"};
constexpr range growths = {1, 1e6, "from 1 to 1e6"};
constexpr range aspects = {1, 1e6, "from 1 to 1e6"};
constexpr range everywhere = {-std::numeric_limits<double>::max(),
                              std::numeric_limits<double>::max(), "finite"};

// Takes the numbers of a text one by one, and remembers the first invalid one.
class number_list {
 public:
  explicit number_list(std::string_view text) : rest_(text) {}

  bool is_empty() const { return ended_; }

  double take(const char* what, const range& allowed) {
    if (ended_) return fail(std::string(what) + " is missing");
    const std::size_t end = std::min(rest_.find(','), rest_.size());
    const std::string_view token = rest_.substr(0, end);
    ended_ = end == rest_.size();
    if (!ended_) rest_.remove_prefix(end + 1);
    const auto number = parse_number(token);
    if (!number) return fail(std::string(what) + ": " + number.failure().message);
    if (number.value() < allowed.low || number.value() > allowed.high)
      return fail(std::string(what) + ": " + quoted_token(token) + " is not " + allowed.text);
    return number.value();
  }

  double take_or(const char* what, const range& allowed, double otherwise) {
    return ended_ ? otherwise : take(what, allowed);
  }

  int take_whole(const char* what, double low, double high) {
    const double x = take(what, {low, high, "a whole number that there can be"});
    if (!failed_ && x != std::floor(x))
      return static_cast<int>(fail(std::string(what) + " is no whole number"));
    return failed_ ? 0 : static_cast<int>(x);
  }

  // Returns the error, if a number was invalid, or text is left over.
  std::optional<error> finish() const {
    if (failed_) return error{*failed_, error_code::bad_option};
    if (!ended_) return error{quoted_token(rest_) + " is too much", error_code::bad_option};
    return std::nullopt;
  }

 private:
  double fail(std::string what) {
    if (!failed_) failed_ = std::move(what);
    return 1;
  }

  std::string_view rest_;
  bool ended_ = false;
  std::optional<std::string> failed_;
};

constexpr double least_number = std::numeric_limits<int>::min(),
                 greatest_number = std::numeric_limits<int>::max();

// Reads H[,GROWTH] into a wish whose place was read, and adds it. Returns the error of the place,
// else that of the size.
template <class Wish>
std::optional<error> add_sized(std::vector<Wish>& all, Wish one, const number_list& place,
                               number_list size, const char* name = "H") {
  one.size = size.take(name, lengths);
  one.growth = size.take_or("GROWTH", growths, usual_growth);
  all.push_back(one);
  auto failed = place.finish();
  return failed ? failed : size.finish();
}

std::optional<error> add_at(size_wishes& all, number_list place, number_list size) {
  size_at one;
  one.centre.x = place.take("X", everywhere);
  one.centre.y = place.take("Y", everywhere);
  one.radius = place.take("R", radii);
  return add_sized(all.at, one, place, std::move(size));
}

std::optional<error> add_box(size_wishes& all, number_list place, number_list size) {
  size_in_box one;
  one.box.low.x = place.take("X0", everywhere);
  one.box.low.y = place.take("Y0", everywhere);
  one.box.high.x = place.take("X1", everywhere);
  one.box.high.y = place.take("Y1", everywhere);
  if (one.box.low.x > one.box.high.x) std::swap(one.box.low.x, one.box.high.x);
  if (one.box.low.y > one.box.high.y) std::swap(one.box.low.y, one.box.high.y);
  return add_sized(all.boxes, one, place, std::move(size));
}

std::optional<error> add_in(size_wishes& all, number_list place, number_list size) {
  size_in_region one;
  one.region = place.take_whole("REGION", least_number, greatest_number);
  return add_sized(all.regions, one, place, std::move(size));
}

std::optional<error> add_near(size_wishes& all, number_list place, number_list size) {
  size_near one;
  one.marker = place.take_whole("MARKER", least_number, greatest_number);
  return add_sized(all.near, one, place, std::move(size), "H0");
}

std::optional<error> add_layers(size_wishes& all, number_list place, number_list size) {
  boundary_layers one;
  constexpr double most_layers = 10000;
  one.marker = place.take_whole("MARKER", least_number, greatest_number);
  one.first_height = size.take("H0", lengths);
  one.growth = size.take("GROWTH", growths);
  if (!size.is_empty()) one.layers = size.take_whole("N", 1, most_layers);
  all.layers.push_back(one);
  auto failed = place.finish();
  return failed ? failed : size.finish();
}

std::optional<error> add_bound(double& bound, const range& allowed, std::string_view text) {
  number_list values(text);
  bound = values.take("the bound", allowed);
  return values.finish();
}

std::optional<error> add_kind(size_wishes& all, std::string_view kind, std::string_view values) {
  if (kind == "hmin") return add_bound(all.least, lengths, values);
  if (kind == "hmax") return add_bound(all.greatest, lengths, values);
  if (kind == "aspect") return add_bound(all.aspect, aspects, values);
  const std::size_t colon = values.find(':');
  if (colon == std::string_view::npos)
    return error{quoted_token(values) + " has no ':' before the size", error_code::bad_option};
  const number_list place(values.substr(0, colon)), size(values.substr(colon + 1));
  if (kind == "at") return add_at(all, place, size);
  if (kind == "box") return add_box(all, place, size);
  if (kind == "in") return add_in(all, place, size);
  if (kind == "near") return add_near(all, place, size);
  if (kind == "layers") return add_layers(all, place, size);
  return error{quoted_token(kind) + " is no kind of size", error_code::bad_option};
}

// Returns the syntax of the values of a kind of wish; empty if the value is one number.
std::string_view form_of(std::string_view kind) {
  if (kind == "at") return "X,Y,R:H[,GROWTH]";
  if (kind == "box") return "X0,Y0,X1,Y1:H[,GROWTH]";
  if (kind == "in") return "REGION:H[,GROWTH]";
  if (kind == "near") return "MARKER:H0[,GROWTH]";
  return kind == "layers" ? "MARKER:H0,GROWTH[,N]" : "";
}

std::optional<error> add(size_wishes& all, std::string_view kind, std::string_view values) {
  auto failed = add_kind(all, kind, values);
  const std::string_view form = form_of(kind);
  if (failed && !form.empty()) failed->message += "; " + std::string(form) + " is wanted";
  return failed;
}

// Returns the numbers, separated by commas, with the digits that read back to the same doubles.
std::string list_of(std::initializer_list<double> numbers) {
  std::string text;
  for (const double x : numbers) {
    if (!text.empty()) text += ',';
    text += number_text(x);
  }
  return text;
}

}  // namespace

bool size_wishes::is_empty() const {
  const size_wishes none;
  return at.empty() && boxes.empty() && regions.empty() && near.empty() && layers.empty() &&
         least == none.least && greatest == none.greatest && aspect == none.aspect;
}

result<size_wishes> with_wish(size_wishes all, std::string_view kind, std::string_view values) {
  if (auto failed = add(all, kind, values)) return *failed;
  return all;
}

std::string text_of(const size_wishes& wishes) {
  std::vector<std::string> parts;
  for (const size_at& w : wishes.at)
    parts.push_back(fmt::format("at {}:{}", list_of({w.centre.x, w.centre.y, w.radius}),
                                list_of({w.size, w.growth})));
  for (const size_in_box& w : wishes.boxes)
    parts.push_back(fmt::format("box {}:{}",
                                list_of({w.box.low.x, w.box.low.y, w.box.high.x, w.box.high.y}),
                                list_of({w.size, w.growth})));
  for (const size_in_region& w : wishes.regions)
    parts.push_back(fmt::format("in {}:{}", w.region, list_of({w.size, w.growth})));
  for (const size_near& w : wishes.near)
    parts.push_back(fmt::format("near {}:{}", w.marker, list_of({w.size, w.growth})));
  for (const boundary_layers& w : wishes.layers)
    parts.push_back(fmt::format("layers {}:{}{}", w.marker, list_of({w.first_height, w.growth}),
                                w.layers ? fmt::format(",{}", *w.layers) : ""));
  const size_wishes none;
  if (wishes.least != none.least) parts.push_back("hmin " + number_text(wishes.least));
  if (wishes.greatest != none.greatest) parts.push_back("hmax " + number_text(wishes.greatest));
  if (wishes.aspect != none.aspect) parts.push_back("aspect " + number_text(wishes.aspect));
  return parts.empty() ? "none" : fmt::format("{}", fmt::join(parts, "; "));
}

result<size_wishes> size_wishes_of(std::string_view text) {
  size_wishes all;
  if (text == "none") return all;
  while (true) {
    const std::size_t end = text.find("; ");
    const std::string_view part = text.substr(0, end);
    const std::size_t space = std::min(part.find(' '), part.size());
    const std::string_view values = space < part.size() ? part.substr(space + 1) : "";
    if (auto failed = add(all, part.substr(0, space), values))
      return failed->at(quoted_token(part));
    if (end == std::string_view::npos) return all;
    text.remove_prefix(end + 2);
  }
}

}  // namespace asterism
