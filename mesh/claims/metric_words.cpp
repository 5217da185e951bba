// SPDX-License-Identifier: MIT
#include "asterism/mesh/claims/metric_words.hpp"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <initializer_list>
#include <limits>
#include <optional>
#include <utility>

#include "asterism/core/number_text.hpp"

namespace asterism::internal {
namespace {

using words = std::map<std::string, std::string>;

constexpr std::array<const char*, 3> hessian_methods = {"l2", "green", "lsq"};
constexpr char separator =
    '\n';  // in no name of a field that a file can have, nor in a file's name

std::string joined(const std::vector<std::string>& all,
                   const std::string& between = std::string(1, separator)) {
  std::string text;
  for (const std::string& one : all) text += (text.empty() ? "" : between) + one;
  return text;
}

std::vector<std::string> split(const std::string& text) {
  std::vector<std::string> all;
  for (std::size_t begin = 0; begin < text.size();) {
    const std::size_t end = std::min(text.find(separator, begin), text.size());
    all.push_back(text.substr(begin, end - begin));
    begin = end + 1;
  }
  return all;
}

std::string optional_text(const std::optional<double>& x) { return x ? number_text(*x) : ""; }

// Reads words one after another, and remembers the first that is invalid.
class word_reader {
 public:
  explicit word_reader(const words& all) : all_(all) {}

  std::string text(const std::string& name) {
    const auto at = all_.find("adapt-" + name);
    if (at != all_.end()) return at->second == "none" ? "" : at->second;
    failed_ = "\"adapt-" + name + "\" is missing";
    return "";
  }
  std::optional<double> real(const std::string& name) {
    const std::string given = text(name);
    if (given.empty()) return std::nullopt;
    const auto value = parse_number(given);
    if (!value) failed_ = "\"adapt-" + name + "\": " + value.failure().message;
    return value ? std::optional(value.value()) : std::nullopt;
  }
  bool flag(const std::string& name) { return text(name) == "yes"; }
  bool has(const std::string& name) const { return all_.contains("adapt-" + name); }
  const std::optional<std::string>& failed() const { return failed_; }

 private:
  const words& all_;
  std::optional<std::string> failed_;
};

std::string yes_or_no(bool is) { return is ? "yes" : "no"; }

}  // namespace

words words_of(const metric_request& request) {
  const solution_metric_options& w = request.wishes;
  words all = {{"mesh", request.mesh},
               {"solution", request.solution},
               {"metric", request.metric},
               {"fields", joined(request.fields)},
               {"intersect", joined(request.intersected)},
               {"implied", yes_or_no(request.implied)},
               {"hessian", hessian_methods[static_cast<std::size_t>(w.hessian)]},
               {"norm", w.norm ? number_text(*w.norm) : "inf"},
               {"vertices", optional_text(w.vertices)},
               {"complexity", optional_text(w.complexity)},
               {"error", optional_text(w.error)},
               {"hmin", number_text(w.least_size)},
               {"hmax", std::isfinite(w.greatest_size) ? number_text(w.greatest_size) : ""},
               {"aspect", number_text(w.aspect)},
               {"gradation", optional_text(w.gradation)},
               {"gradation-space", w.gradation_keeps_shape ? "metric" : "mixed"},
               {"isotropic", yes_or_no(w.isotropic)},
               {"step", optional_text(w.step)}};
  // Adds words for rarely used options; options that are not set are left out.
  if (!request.hessians.empty()) all["given-hessian"] = request.hessians;
  if (w.relative) all["relative"] = "yes";
  if (w.cutoff) all["cutoff"] = number_text(*w.cutoff);
  words named;
  for (auto& [name, text] : all) named["adapt-" + name] = text.empty() ? "none" : std::move(text);
  return named;
}

result<metric_request> request_of(const words& all) {
  word_reader read(all);
  metric_request request;
  request.mesh = read.text("mesh");
  request.solution = read.text("solution");
  request.metric = read.text("metric");
  request.fields = split(read.text("fields"));
  request.intersected = split(read.text("intersect"));
  request.implied = read.flag("implied");
  solution_metric_options& w = request.wishes;
  const std::string method = read.text("hessian");
  for (std::size_t i = 0; i < hessian_methods.size(); ++i)
    if (method == hessian_methods[i]) w.hessian = static_cast<hessian_method>(i);
  w.norm = read.text("norm") == "inf" ? std::nullopt : read.real("norm");
  w.vertices = read.real("vertices");
  w.complexity = read.real("complexity");
  w.error = read.real("error");
  w.least_size = read.real("hmin").value_or(0);
  w.greatest_size = read.real("hmax").value_or(std::numeric_limits<double>::infinity());
  w.aspect = read.real("aspect").value_or(w.aspect);
  w.gradation = read.real("gradation");
  w.gradation_keeps_shape = read.text("gradation-space") == "metric";
  w.isotropic = read.flag("isotropic");
  w.step = read.real("step");
  if (read.has("given-hessian")) request.hessians = read.text("given-hessian");
  w.relative = read.has("relative") && read.flag("relative");
  if (read.has("cutoff")) w.cutoff = read.real("cutoff");
  if (read.failed()) return error{*read.failed()};
  if (const auto carried = all.find("transfer-carried"); carried != all.end())
    request.carried = carried->second;
  return request;
}

words words_of(const solution_metric_report& r) {
  const std::array<std::pair<const char*, double>, 16> numbers = {
      {{"noise", r.share_noise},
       {"at-boundary", r.share_at_boundary},
       {"floored", r.share_floored},
       {"complexity-flat", r.complexity_at_least_density},
       {"complexity-at-longest", r.complexity_along_ridges},
       {"complexity-asked", r.complexity_asked},
       {"complexity-before-gradation", r.complexity_before_gradation},
       {"complexity-delivered", r.complexity_delivered},
       {"factor", r.factor},
       {"error-predicted", r.error_predicted},
       {"intersected", r.share_intersected},
       {"step-limited", r.share_step},
       {"clipped-by-hmin", r.share_least_size},
       {"clipped-by-hmax", r.share_greatest_size},
       {"clipped-by-aspect", r.share_aspect},
       {"graded", r.share_graded}}};
  words all;
  for (const auto& [name, value] : numbers) all[std::string("metric-") + name] = number_text(value);
  all["metric-fields"] = r.fields.empty() ? "none" : joined(r.fields);
  all["metric-steps"] = joined(r.steps, "; ");
  all["metric-flat-fields"] = std::to_string(r.flat_fields);
  all["metric-gradation-rounds"] = std::to_string(r.gradation_rounds);
  all["metric-gradation-ended"] = yes_or_no(r.gradation_ended);
  all["metric-reached"] = r.reached ? "yes" : r.reason;
  return all;
}

namespace {

constexpr double least_said = 0.0005;  // a smaller share is 0.0 %

// Lists properties, each with the share of vertices that have it: ", A at 1.0 % of the vertices, B
// at 2.0 %".
std::string shares_text(const char* begin,
                        std::initializer_list<std::pair<const char*, double>> shares) {
  std::string text;
  for (const auto& [what, share] : shares)
    if (share >= least_said)
      text += fmt::format("{}{} at {:.1f} %{}", text.empty() ? begin : ", ", what, 100 * share,
                          text.empty() ? " of the vertices" : "");
  return text;
}

// Says of how many fields the metric is made, and where their derivatives set no size.
std::string fields_text(const solution_metric_report& r) {
  if (r.fields.empty()) return "";
  std::string text = fmt::format("; {} field{}", r.fields.size(), r.fields.size() == 1 ? "" : "s");
  if (r.flat_fields > 0) text += fmt::format(", {} without second derivatives", r.flat_fields);
  return text + shares_text("; second derivatives are ",
                            {{"nothing but rounding", r.share_noise},
                             {"so small that a bound sets a size", r.share_floored}});
}

// Says which part of the complexity is where the solution is flat or straight.
std::string spent_text(const solution_metric_report& r) {
  std::string text;
  const auto part = [&text](double share, const char* where) {
    if (share >= least_said)
      text += fmt::format("{} {:.1f} % {}", text.empty() ? "; of the complexity" : ",", 100 * share,
                          where);
  };
  part(r.complexity_at_least_density, "where the solution is flat");
  part(r.complexity_along_ridges, "on edges as long as the domain");
  return text;
}

}  // namespace

std::string text_of(const solution_metric_report& r) {
  std::string text = fmt::format("complexity {:.6g}", r.complexity_delivered);
  if (r.complexity_asked > 0) text += fmt::format(" of {:.6g} asked for", r.complexity_asked);
  if (r.complexity_before_gradation != r.complexity_delivered)
    text += fmt::format(", {:.6g} before gradation", r.complexity_before_gradation);
  if (r.error_predicted > 0) text += fmt::format("; predicted error {:.3g}", r.error_predicted);
  text +=
      fields_text(r) + spent_text(r) +
      shares_text("; tensors changed by ", {{"intersection", r.share_intersected},
                                            {"step", r.share_step},
                                            {"hmin", r.share_least_size},
                                            {"hmax", r.share_greatest_size},
                                            {"aspect", r.share_aspect},
                                            {"gradation (how fast sizes grow)", r.share_graded}});
  if (!r.gradation_ended) text += "; gradation was ended before all edges kept to it";
  return text;
}

}  // namespace asterism::internal
