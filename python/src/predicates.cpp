// SPDX-License-Identifier: MIT
//
// The predicates over arrays: one call of the batch functions, without the interpreter's lock. The
// package's own functions, which ask in batches that can be interrupted, have their descriptions.
#include <array>
#include <new>
#include <utility>
#include <vector>

#include "arguments.hpp"
#include "asterism/kernels/c_batch.h"
#include "bindings.hpp"

namespace asterism::python {
namespace {

struct argument {
  const char* name;
  py::ssize_t width;
};

// Returns the number of rows of all tables. One row stands for any number, as numpy broadcasts.
std::size_t common_rows(const std::vector<number_table>& tables) {
  std::size_t rows = 1;
  bool found = false;
  for (const number_table& t : tables) {
    if (t.rows() == 1) continue;
    if (found && t.rows() != rows)
      throw input_error("arguments of " + std::to_string(rows) + " and " +
                        std::to_string(t.rows()) + " rows");
    rows = t.rows();
    found = true;
  }
  return rows;
}

py::object with_counts(py::object answers, const asterism_batch_report& report, bool counts) {
  if (!counts) return answers;
  py::dict tiers;
  tiers["semi_static"] = report.by_semi_static;
  tiers["interval"] = report.by_interval;
  tiers["exact"] = report.by_exact;
  return py::make_tuple(std::move(answers), std::move(tiers));
}

// Answers each row of the tables by call(count, rows, answers, report), a batch function.
template <class Call>
py::object answer(const std::vector<number_table>& tables, bool counts, const Call& call) {
  const std::size_t rows = common_rows(tables);
  py::array_t<signed char> answers(static_cast<py::ssize_t>(rows));
  signed char* const to = answers.mutable_data();
  asterism_batch_report report{};
  asterism_status status = ASTERISM_OK;
  {
    const py::gil_scoped_release unlocked;
    status = call(rows, to, &report);
  }
  bool single = true;
  for (const number_table& t : tables) single = single && t.is_single();
  if (status == ASTERISM_OUT_OF_MEMORY) throw std::bad_alloc();
  if (status != ASTERISM_OK) {
    const std::string where = !single && report.failed_row < rows
                                  ? "row " + std::to_string(report.failed_row) + ": "
                                  : "";
    throw input_error(where + asterism_status_message(status));
  }
  if (single) return with_counts(py::int_(static_cast<int>(to[0])), report, counts);
  return with_counts(std::move(answers), report, counts);
}

template <std::size_t... Index, class Function>
asterism_status call_rows(std::index_sequence<Index...>, Function* function,
                          const std::vector<number_table>& tables, std::size_t rows,
                          signed char* answers, asterism_batch_report* report) {
  return function(rows, tables[Index].every()..., answers, report);
}

template <std::size_t>
using an_object = py::object;

template <std::size_t... Index, class Function>
void define(py::module_& m, const char* name, Function* function,
            const std::array<argument, sizeof...(Index)>& arguments,
            std::index_sequence<Index...> all) {
  m.def((std::string("_") + name).c_str(),
        [function, arguments, all](const an_object<Index>&... given, bool counts) {
          std::vector<number_table> tables;
          (tables.emplace_back(given, arguments[Index].width, arguments[Index].name), ...);
          return answer(tables, counts, [&](std::size_t rows, signed char* to, auto* report) {
            return call_rows(all, function, tables, rows, to, report);
          });
        },
        py::arg(arguments[Index].name)..., py::kw_only(), py::arg("counts") = false);
}

template <std::size_t Count, class Function>
void define(py::module_& m, const char* name, Function* function, const argument (&given)[Count]) {
  std::array<argument, Count> arguments;
  for (std::size_t k = 0; k < Count; ++k) arguments[k] = given[k];
  define(m, name, function, arguments, std::make_index_sequence<Count>());
}

constexpr py::ssize_t point = 2, tensor = 3, site = 5;

}  // namespace

void define_predicates(py::module_& m) {
  define(m, "orientation", asterism_orientations, {{"p", point}, {"q", point}, {"r", point}});
  define(m, "is_positive_definite", asterism_are_spd, {{"metric", tensor}});
  define(m, "in_circle", asterism_in_circles,
         {{"metric", tensor}, {"a", point}, {"b", point}, {"c", point}, {"p", point}});
  define(m, "compare_distance", asterism_compare_distances,
         {{"v", site}, {"w", site}, {"q", point}});
  define(m, "in_wedge", asterism_in_wedges, {{"v", site}, {"w", site}, {"q", point}});
  define(m, "dominates", asterism_dominations, {{"v", site}, {"w", site}, {"p", point}});
  define(m, "voronoi_vertex_count", asterism_voronoi_vertex_counts,
         {{"u", site}, {"v", site}, {"w", site}});
  define(m, "arc_intersection_count", asterism_arc_intersection_counts,
         {{"v", site}, {"w", site}, {"x", site}});
  define(m, "encroaches", asterism_encroachments, {{"a", site}, {"b", site}, {"w", site}});
  define(m, "insertion_test", asterism_insertion_tests,
         {{"v", site}, {"w", site}, {"x", site}, {"y", site}});
  define(m, "edge_test", asterism_edge_tests, {{"v", site}, {"w", site}, {"x", site}, {"y", site}});
}

}  // namespace asterism::python
