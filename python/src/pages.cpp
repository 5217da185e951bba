// SPDX-License-Identifier: MIT
//
// Makes pages about meshes, with fields, and with earlier meshes and domains.
#include "pages.hpp"

#include <pybind11/stl.h>

#include <tuple>
#include <utility>

#include "asterism/mesh/draw/outline.hpp"
#include "bindings.hpp"
#include "py_domain.hpp"
#include "slits.hpp"
#include "solution_arguments.hpp"

namespace asterism::python {
namespace {

// A label, a mesh or a domain, and the fields on it.
using given_frame = std::tuple<std::string, py::object, named_fields>;

report_frame frame_of(const given_frame& given) {
  const auto& [label, shown, fields] = given;
  report_frame frame;
  frame.label = label;
  frame.content = py::isinstance<py_domain>(shown)
                      ? internal::outline_of(shown.cast<const py_domain&>().shape)
                      : shown.cast<const py_mesh&>().content;
  frame.fields = solution_of(fields, frame.content.sites.size());
  return frame;
}

std::string page_of(const py_mesh& m, const py::dict& more) {
  const keywords given(more);
  report_facts facts = facts_of(m, given.word("title"));
  facts.label = given.word("label");
  facts.fields = solution_of(given.object("fields").cast<named_fields>(), m.content.sites.size());
  if (given.has("wanted"))
    facts.wanted = tensors_of(given.object("wanted"), m.content.sites.size(), "wanted");
  for (const given_frame& one : given.object("before").cast<std::vector<given_frame>>())
    facts.before.push_back(frame_of(one));
  const py::gil_scoped_release unlocked;
  const auto [shown, cracks] = joined(m.content);
  // A page has one vertex at each place, so it cannot show different values on both sides of a
  // slit.
  if (!cracks.empty()) {
    facts.fields = {};
    facts.wanted = {};
  }
  return value_or_raise(report_page(shown, facts));
}

}  // namespace

report_facts facts_of(const py_mesh& m, const std::string& title) {
  report_facts facts;
  facts.title = title;
  facts.claim = m.claim;
  if (m.claim)
    facts.claim_from = m.certified ? "As the run that made this mesh judged it."
                                   : "As its certificate has it, for mesh.verify() to audit again.";
  return facts;
}

void define_pages(py::module_& m) { m.def("_page", &page_of, py::arg("mesh"), py::arg("more")); }

}  // namespace asterism::python
