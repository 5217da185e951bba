// SPDX-License-Identifier: MIT
#include "asterism/mesh/io/medit_solution.hpp"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <string>
#include <system_error>
#include <utility>

#include "asterism/core/number_text.hpp"
#include "asterism/kernels/filtered_kernel.hpp"
#include "asterism/mesh/io/file_ending.hpp"
#include "asterism/mesh/io/medit_binary.hpp"
#include "asterism/mesh/io/plain_lines.hpp"
#include "asterism/mesh/support/tensor_text.hpp"

namespace asterism::internal {

namespace {

using failure = std::optional<error>;

failure take_tensor(const text_scanner& source, std::size_t line, const metric_tensor& metric,
                    std::size_t v, mesh& m) {
  m.sites[v].metric = metric;
  if (filtered_kernel().is_positive_definite(metric)) return {};
  return source.failure(line,
                        fmt::format("the metric tensor {} of vertex {} is not positive definite",
                                    tensor_text(metric), v + 1));
}

// Reads a length h, which stands for the tensor I/h^2.
failure read_size(text_scanner& source, std::size_t v, mesh& m) {
  const word w = source.next();
  const auto size = to_number(source, w, "size at a vertex");
  if (!size.ok()) return size.failure();
  const double round = 1 / (size.value() * size.value());
  if (!(size.value() > 0) || !std::isfinite(round) || !(round > 0))
    return source.failure(w.line, fmt::format("vertex {}: a size is a positive length, not {}",
                                              v + 1, quoted_token(w.text)));
  m.sites[v].metric = {round, 0, round};
  return {};
}

failure read_sizes(text_scanner& source, mesh& m) {
  for (std::size_t v = 0; v < m.sites.size(); ++v)
    if (auto failed = read_size(source, v, m)) return failed;
  return {};
}

// Reads the tensors where each is on a line of its own, and returns true.
bool read_plain_tensors(text_scanner& source, mesh& m) {
  return take_plain_lines(source, m.sites.size(), [&m](std::size_t v, number_line& line) {
    metric_tensor& metric = m.sites[v].metric;
    return line.take(metric.m11) && line.take(metric.m12) && line.take(metric.m22) &&
           filtered_kernel().is_positive_definite(metric);
  });
}

// Sets `is_metric` to false for a file without a metric, if none is required.
failure read_tensors(text_scanner& source, int dimension, mesh& m, bool& is_metric) {
  const word w = source.next();
  const auto count = to_count(source, w, "SolAtVertices");
  if (!count.ok()) return count.failure();
  if (count.value() != m.sites.size())
    return source.failure(w.line, "SolAtVertices: " + std::to_string(count.value()) +
                                      " tensors for " + std::to_string(m.sites.size()) +
                                      " vertices");
  const word fields = source.next(), type = source.next();
  const bool is_one = fields.text == "1";
  if (!is_one || type.text != "3") {
    if (!std::exchange(is_metric, false)) return {};
    if (!is_one || type.text != "1")
      return source.failure(
          type.line, "SolAtVertices: '1 3' wanted, one symmetric tensor, or '1 1', one size, not " +
                         quoted_token(fields.text) + " " + quoted_token(type.text));
    is_metric = true;
    return read_sizes(source, m);
  }
  is_metric = true;
  if (dimension == 2 && read_plain_tensors(source, m)) return {};
  for (std::size_t v = 0; v < m.sites.size(); ++v) {
    std::array<double, 6> entries{1, 0, 1, 0, 0, 0};
    std::size_t line = 0;
    for (std::size_t i = 0; i < (dimension == 2 ? 3U : 6U); ++i) {
      const word entry = source.next();
      const auto value = to_number(source, entry, "entry of a tensor");
      if (!value.ok()) return value.failure();
      entries[i] = value.value();
      if (i == 0) line = entry.line;
    }
    if (auto failed = take_tensor(source, line, {entries[0], entries[1], entries[2]}, v, m))
      return failed;
  }
  return {};
}

// Reads the section. On entry `is_metric` states whether it must be a metric; on return, whether it
// is one.
failure read_sections(text_scanner& source, mesh& m, bool& is_metric) {
  const bool is_wanted = is_metric;
  const auto dimension = read_medit_header(source);
  if (!dimension.ok()) return dimension.failure();
  bool seen = false;
  while (true) {
    const word keyword = source.next();
    if (keyword.empty() || keyword.text == "End") break;
    if (keyword.text != "SolAtVertices" || seen)
      return source.failure(
          keyword.line, quoted_token(keyword.text) + " where one section SolAtVertices should be");
    seen = true;
    if (auto failed = read_tensors(source, dimension.value(), m, is_metric)) return failed;
    if (!is_metric && !is_wanted) return {};
  }
  if (!seen) return source.failure(source.line(), "there is no section SolAtVertices");
  return {};
}

failure read_bamg_metric(text_scanner& source, mesh& m) {
  const word w = source.next(), entries = source.next();
  const auto count = to_count(source, w, "number of vertices");
  if (!count.ok()) return count.failure();
  if (count.value() != m.sites.size())
    return source.failure(w.line, std::to_string(count.value()) + " tensors for " +
                                      std::to_string(m.sites.size()) + " vertices");
  if (entries.text != "1" && entries.text != "3")
    return source.failure(entries.line,
                          "1 or 3 numbers a vertex wanted, not " + quoted_token(entries.text));
  for (std::size_t v = 0; v < m.sites.size(); ++v) {
    std::array<double, 3> tensor{};
    const std::size_t wanted = entries.text == "1" ? 1 : 3;
    const word first = source.next();
    for (std::size_t i = 0; i < wanted; ++i) {
      const auto value = to_number(source, i == 0 ? first : source.next(), "entry of a tensor");
      if (!value.ok()) return value.failure();
      tensor[i] = value.value();
    }
    if (wanted == 1 && !(tensor[0] > 0))
      return source.failure(first.line,
                            "a length must be positive, not " + quoted_token(first.text));
    const double round = 1 / (tensor[0] * tensor[0]);
    const metric_tensor metric = wanted == 1 ? metric_tensor{round, 0, round}
                                             : metric_tensor{tensor[0], tensor[1], tensor[2]};
    if (auto failed = take_tensor(source, first.line, metric, v, m)) return failed;
  }
  const word more = source.next();
  if (!more.empty())
    return source.failure(more.line, quoted_token(more.text) + " after the last tensor");
  return {};
}

}  // namespace

result<int> read_medit_header(text_scanner& source, std::optional<double>* corner_bound) {
  const word first = source.next();
  if (first.text != "MeshVersionFormatted")
    return source.failure(first.line, first.empty() ? std::string("the file is empty")
                                                    : quoted_token(first.text) +
                                                          " where MeshVersionFormatted should be");
  const word number = source.next();
  const auto version = to_integer(source, number, "MeshVersionFormatted");
  if (!version.ok()) return version.failure();
  // Accepts the versions 0, which BAMG writes, and 4, which has wider numbers in binary files and
  // is the same as text.
  if (version.value() < 0 || version.value() > 4)
    return source.failure(
        number.line, "MeshVersionFormatted: " + quoted_token(number.text) + " is none of 0 to 4");
  word keyword = source.next();
  // Skips the keywords of BAMG, each with an angle, that precede Dimension in some geometries.
  while (keyword.text == "MaximalAngleOfCorner" || keyword.text == "AngleOfCornerBound") {
    const auto angle = to_number(source, source.next(), keyword.text);
    if (!angle.ok()) return angle.failure();
    if (corner_bound != nullptr) *corner_bound = angle.value();
    keyword = source.next();
  }
  if (keyword.text != "Dimension")
    return source.failure(keyword.line, quoted_token(keyword.text) + " where Dimension should be");
  const word size = source.next();
  const auto dimension = to_integer(source, size, "Dimension");
  if (!dimension.ok()) return dimension.failure();
  if (dimension.value() != 2 && dimension.value() != 3)
    return source.failure(size.line, "Dimension: " + quoted_token(size.text) + " is not 2");
  return static_cast<int>(dimension.value());
}

result<bool> read_medit_solution(const std::filesystem::path& path, mesh& m,
                                 const medit_read_options& options) {
  std::error_code status;
  if (options.without_solution ||
      (options.identity_without_solution && !std::filesystem::exists(path, status))) {
    for (site& s : m.sites) s.metric = {1, 0, 1};
    return false;
  }
  const auto text = read_medit_text(path);
  if (!text.ok()) return text.failure();
  text_scanner source(path.string(), text.value());
  bool is_metric = !options.identity_without_solution || !options.solution.empty();
  if (has_ending(path.string(), ".mtr")) {
    if (auto failed = read_bamg_metric(source, m)) return *failed;
    return true;
  }
  if (auto failed = read_sections(source, m, is_metric)) return *failed;
  if (!is_metric)
    for (site& s : m.sites) s.metric = {1, 0, 1};
  return is_metric;
}

bool holds_tensors(const std::filesystem::path& path) {
  const auto text = read_medit_text(path);
  if (!text) return false;
  text_scanner source(path.string(), text.value());
  if (!read_medit_header(source) || source.next().text != "SolAtVertices") return false;
  source.next();
  const word fields = source.next(), type = source.next();
  return fields.text == "1" && type.text == "3";
}

}  // namespace asterism::internal
