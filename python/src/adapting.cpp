// SPDX-License-Identifier: MIT
//
// Makes the next mesh of an adaptation loop in one call: metric, mesh, and fields brought to it.
#include <pybind11/stl.h>

#include "asterism/mesh/claims/adaptation_words.hpp"
#include "asterism/mesh/io/solution_file.hpp"
#include "asterism/mesh/pipeline/adapt_to_metric.hpp"
#include "asterism/mesh/pipeline/adaptation_target.hpp"
#include "asterism/mesh/pipeline/periodic_continuation.hpp"
#include "asterism/mesh/pipeline/read_triangulation.hpp"
#include "asterism/mesh/solution/implied_metric.hpp"
#include "bindings.hpp"
#include "periodic_arguments.hpp"
#include "py_domain.hpp"
#include "py_mesh.hpp"
#include "solution_arguments.hpp"
#include "watched_run.hpp"

namespace asterism::python {
namespace {

// Holds everything that was asked for.
struct adapt_request {
  solution fields;                      // fields of which the metric is made
  std::vector<metric_tensor> given;     // a metric in place of fields
  std::vector<nodal_hessian> hessians;  // in place of fields
  bool implied = false;
  std::vector<std::vector<metric_tensor>> besides;
  solution carried;  // fields that are only transferred
  transfer_method how = transfer_method::interpolate;
  solution_metric_options wishes;
  mesh_adaptation_options options;
};

// Holds the results.
struct adapt_answer {
  solution_metric metric;
  adapted_mesh next;
  std::optional<transferred_solution> values;
  std::optional<std::string> missed;
};

keep_rule rule_of(const std::string& name) {
  if (name == "auto") return keep_rule::automatic;
  if (name == "never") return keep_rule::never;
  if (name == "always") return keep_rule::always;
  throw input_error("keep: 'auto', 'never' or 'always' is wanted, not '" + name + "'");
}

mesh_adaptation_options options_of(const keywords& given, const py::object& exact) {
  mesh_adaptation_options options;
  options.corner_angle = given.positive("corner_angle").value_or(options.corner_angle);
  if (options.corner_angle > 180)
    throw input_error("corner_angle: degrees above 0 and at most 180 are wanted");
  options.largest_boundary_distance = given.positive("hausd");
  options.boundary_part = given.positive("boundary_part");
  if (options.boundary_part && *options.boundary_part > 0.125)
    throw input_error("boundary_part: above 0 and at most 0.125 is wanted");
  options.chord_tolerance = given.positive("chord_tolerance");
  options.keep = rule_of(given.word("keep"));
  options.periodic = periodic_of(given);
  options.no_split_across = given.flag("no_split_across");
  options.refinement.metric_tolerance = given.from_zero("metric_tolerance");
  options.refinement.angle_bound = given.from_zero("angle_bound").value_or(20);
  if (!(options.refinement.angle_bound < 60))
    throw input_error("angle_bound: at least 0 and below 60 degrees is wanted");
  if (const auto most = given.count("max_sites", 3)) {
    options.refinement.max_sites = *most;
    options.keeps_site_limit = true;
  }
  if (exact.is_none()) {
    if (options.chord_tolerance)
      throw input_error("chord_tolerance: it is of the curves of a domain, and none is given");
    return options;
  }
  for (const char* const name : {"hausd", "corner_angle", "boundary_part"})
    if (given.has(name))
      throw input_error(std::string(name) +
                        ": it is of the boundary of the mesh, and a domain is given in its place");
  options.exact = exact.cast<const py_domain&>().shape;
  if (options.chord_tolerance && options.exact->curves.empty())
    throw input_error("chord_tolerance: the domain has no curves");
  return options;
}

result<solution_metric> metric_of(const mesh& m, const adapt_request& asked) {
  if (!asked.hessians.empty())
    return make_hessian_metric(m, asked.hessians, asked.wishes, asked.besides);
  if (asked.given.empty() && !asked.implied) {
    const auto fields = select_values(asked.fields, {});
    if (!fields) return fields.failure();
    if (const auto glued = internal::continued_across(m, asked.options.periodic))
      return make_glued_metric(m, *glued, fields.value(), asked.wishes, asked.besides);
    return make_solution_metric(m, fields.value(), asked.wishes, asked.besides);
  }
  if (!asked.implied) return shape_metric(m, asked.given, asked.wishes, asked.besides);
  const auto implied = implied_metric(m);
  if (!implied) return implied.failure();
  return shape_metric(m, implied.value(), asked.wishes, asked.besides);
}

// Describes the run for its certificate. In place of names of files it says that there were none.
void describe(const adapt_request& asked, const mesh& background, adapt_answer& made) {
  const std::string in_memory = "in memory";
  internal::metric_request request;
  request.mesh = in_memory;
  request.implied = asked.implied;
  (asked.given.empty() ? request.solution : request.metric) = asked.implied ? "" : in_memory;
  if (!asked.hessians.empty()) request.hessians = in_memory;
  for (std::size_t k = 0; k < asked.besides.size(); ++k) request.intersected.push_back(in_memory);
  request.wishes = asked.wishes;
  internal::describe_adaptation(made.next,
                                {request, background, made.metric.report, asked.options,
                                 asked.options.exact ? in_memory : std::string(),
                                 made.values ? &made.values->report : nullptr, asked.how});
}

result<adapt_answer> answer(const py_mesh& on, const adapt_request& asked, const cancellation& stop,
                            const progress_listener& progress) {
  mesh background = on.content;
  if (auto checked = internal::checked_triangulation(background, "mesh", slit_rule::joined);
      !checked)
    return checked.failure();
  auto metric = metric_of(background, asked);
  if (!metric) return metric.failure();
  adapt_answer made{std::move(metric).value(), {}, {}, {}};
  for (std::size_t v = 0; v < background.sites.size(); ++v)
    background.sites[v].metric = made.metric.tensors[v];
  mesh_adaptation_options options = asked.options;
  options.refinement.stop = stop;
  const internal::adaptation_wish wish{asked.wishes, made.metric.report, background.sites.size(),
                                       asked.given.empty() && !asked.implied};
  if (auto failed = internal::take_target(wish, "max_sites", options)) return *failed;
  auto next = adapt_to_metric({background, on.marks}, options, progress);
  if (!next) return next.failure();
  made.next = std::move(next).value();
  made.missed =
      internal::what_is_missed(made.next, made.metric.report, options.refinement.vertices);
  if (!asked.carried.fields.empty()) {
    if (made.next.made.outcome.result.triangles.empty())
      return error{"the run ended before there was a triangle to bring values to: " +
                   made.next.made.claim.reason};
    const mesh parted = part_cracks(made.next.made.outcome.result, made.next.cracks).content;
    auto values = transfer_solution(background, asked.carried, parted, asked.how);
    if (!values) return values.failure();
    made.values = std::move(values).value();
  }
  describe(asked, background, made);
  return made;
}

py_mesh packaged(certified_mesh made, const crack_markers& cracks, const physical_names& names) {
  py_mesh m;
  m.names = names;
  m.complete = made.outcome.complete;
  m.certified = made.certified();
  m.reason = made.claim.reason;
  m.angle_bound = made.claim.angle_bound.value_or(0);
  m.claim = std::move(made.claim);
  m.content = part_cracks(made.outcome.result, cracks).content;
  return m;
}

py::dict facts_of(const adapt_answer& made) {
  py::dict d;
  d["metric"] = dict_of(made.metric.report);
  d["kept"] = made.next.kept;
  d["boundary_vertices"] = made.next.boundary_vertices;
  d["boundary_kept"] = made.next.boundary_kept;
  d["boundary_distance"] = made.next.boundary_distance;
  d["reached"] = !made.missed.has_value();
  d["reason"] = made.missed.value_or(made.next.made.claim.reason);
  d["transfer"] = made.values ? py::object(dict_of(made.values->report)) : py::object(py::none());
  return d;
}

py::tuple adapt(const py_mesh& on, const named_fields& fields, const py::object& given,
                const named_fields& carried, const py::object& exact, const py::dict& more) {
  const keywords words(more);
  const std::size_t count = on.content.sites.size();
  adapt_request asked;
  asked.fields = solution_of(fields, count);
  asked.carried = solution_of(carried, count);
  asked.implied = words.flag("implied");
  if (!given.is_none()) asked.given = tensors_of(given, count, "metric");
  asked.hessians = hessians_of(words.object("hessians"), count);
  asked.besides = all_tensors_of(words.object("intersect"), count, "intersect");
  asked.how = way_of(words.word("how"));
  asked.wishes = wishes_of(words);
  asked.options = options_of(words, exact);
  watched_run watch(words);
  std::optional<result<adapt_answer>> done;
  {
    const py::gil_scoped_release unlocked;
    done = answer(on, asked, watch.stop(), watch.listener());
  }
  watch.errors().raise();
  adapt_answer made = value_or_raise(std::move(*done));
  const py::dict facts = facts_of(made);
  warn(made.next.made.outcome.result.notes);
  py::list values;
  if (made.values) values = arrays_of(made.values->values);
  return py::make_tuple(packaged(std::move(made.next.made), made.next.cracks, on.names),
                        array_of(made.metric.tensors), values, facts);
}

}  // namespace

void define_adapting(py::module_& m) {
  m.def("_adapt", &adapt, py::arg("mesh"), py::arg("fields"), py::arg("metric"), py::arg("carried"),
        py::arg("domain"), py::arg("more"));
}

}  // namespace asterism::python
