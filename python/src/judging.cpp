// SPDX-License-Identifier: MIT
//
// Runs of the auditor, without the interpreter's lock.
#include <pybind11/stl.h>

#include "arguments.hpp"
#include "asterism/mesh/audit/audit.hpp"
#include "asterism/mesh/audit/verify.hpp"
#include "asterism/mesh/pipeline/foreign_mesh.hpp"
#include "bindings.hpp"
#include "py_mesh.hpp"
#include "slits.hpp"

namespace asterism::python {
namespace {

// Returns the auditor's findings as Python objects.
py::dict findings_of(const audit_report& audit) {
  py::list witnesses;
  for (const audit_finding& f : audit.findings)
    witnesses.append(py::make_tuple(
        std::string(finding_kind_names[static_cast<std::size_t>(f.kind)]), f.witness));
  py::dict d;
  d["sites"] = audit.sites;
  d["triangles"] = audit.triangles;
  d["worst_angle"] = audit.worst().degrees;
  d["low_triangles"] = audit.refused_triangles();
  d["exempt_corners"] = audit.exempt_corners;
  d["findings"] = witnesses;
  return d;
}

double bound_in(const keywords& given) {
  const double bound = given.from_zero("angle_bound").value_or(20);
  if (!(bound < 60)) throw input_error("angle_bound: at least 0 and below 60 degrees is wanted");
  return bound;
}

py::dict verify_mesh(const py_mesh& m, const py::dict& more) {
  const keywords given(more);
  std::optional<certificate> claim = m.claim;
  if (given.has("certificate"))
    claim = value_or_raise(parse_certificate(given.word("certificate"), "certificate"));
  audit_options options;
  if (given.has("angle_bound")) options.angle_bound = bound_in(given);
  verify_report report;
  {
    const py::gil_scoped_release unlocked;
    report = verify(joined(m.content).first, claim, options);
  }
  py::dict d = findings_of(report.audit);
  d["verified"] = report.verified;
  d["contradictions"] = system_texts(report.contradictions);
  return d;
}

py::dict certify_mesh(const py_mesh& m, const py::dict& more) {
  const keywords given(more);
  const double angle_bound = bound_in(given);
  const bool prove_voronoi = given.flag("voronoi");
  certify_report report;
  {
    const py::gil_scoped_release unlocked;
    const auto adopted =
        value_or_raise(adopt_mesh(m.content, region_edges::as_listed, slit_rule::joined));
    report = certify(adopted, angle_bound, prove_voronoi);
  }
  py::dict d = findings_of(report.audit);
  d["certified"] = report.certified();
  d["inverted"] = report.inverted;
  d["in_stars"] = report.in_stars;
  d["not_in_all_stars"] = report.not_in_all;
  d["below_bound"] = report.below_bound;
  d["edges"] = report.edges;
  d["unit_edges"] = report.unit_edges;
  d["voronoi"] = std::string(voronoi_verdict_names[static_cast<std::size_t>(report.audit.voronoi)]);
  return d;
}

}  // namespace

void define_judging(py::module_& m) {
  m.def("_verify", &verify_mesh, py::arg("mesh"), py::arg("more"));
  m.def("_certify", &certify_mesh, py::arg("mesh"), py::arg("more"));
}

}  // namespace asterism::python
