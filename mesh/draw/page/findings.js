// SPDX-License-Identifier: MIT
// Puts findings about a mesh into plain words, and sorts them: causes before findings that may
// follow from them.

// Kinds of findings in the order in which they are shown: words, and true if the kind may follow
// from a finding about a triangle nearby.
const findingKinds = {
  index_out_of_range: ["numbers of vertices that do not exist"],
  not_finite: ["numbers that are not finite"],
  metric_not_positive_definite: ["metrics that measure no length: not positive definite"],
  empty_mesh: ["no triangle at all"],
  invalid_option: ["questions that cannot be answered"],
  repeated_position: ["vertices at the same point"],
  repeated_corner: ["triangles or boundary edges that name a vertex twice"],
  repeated_triangle: ["triangles that are there twice"],
  orientation: ["triangles that turn clockwise or are flat"],
  disagreeing_triangles: ["triangles on which their vertices disagree"],
  given_changed: ["given vertices that are not the domain's"],
  boundary_contact: ["boundary edges that cross or touch"],
  repeated_boundary: ["boundary edges that are there twice"],
  boundary_inside: ["boundary edges with triangles on both sides"],
  boundary_without_triangle: ["boundary edges without a triangle", true],
  unmatched_edge: ["edges with a triangle on one side alone, not on the boundary", true],
  repeated_edge: ["edges that two triangles run the same way", true],
  open_boundary: ["places where the boundary does not close", true],
  broken_fan: ["vertices that triangles do not surround once", true],
  wrong_winding: ["boundary that does not enclose its inside once", true],
  unused_vertex: ["vertices in no triangle", true],
  segment_not_covered: ["segments of the domain that boundary edges do not follow", true],
  marker_changed: ["boundary edges with another marker than their segment"],
  side_changed: ["edges inside that should be boundary, or the reverse"],
  boundary_deviation: ["vertices off their segment of the boundary"],
  curve_deviation: ["boundary off its curve"],
  wrong_region: ["triangles of another region than they say"],
  angle_below_bound: ["angles below the bound"],
  collateral_angle_below_bound: ["angles below the bound beside sharp corners"],
  exemption_not_proven: ["corners not proved to be sharp"],
  nothing_judged: ["too little left to judge: most triangles are exempt"],
  star_neighbour_rejected: ["neighbours that a star would not accept again"],
  star_site_missing: ["vertices that a star would accept and does not have"],
  stopped: ["stars not looked at"],
  voronoi_vertex_missing: ["triangles without a Voronoi vertex"],
  voronoi_arc_reversed: ["Voronoi vertices in the wrong order"],
  voronoi_site_nearer: ["vertices too near to a Voronoi edge"],
  voronoi_boundary_encroached: ["vertices too near to a boundary edge"],
};

// Returns the first triangle that a sentence names, or else the first vertex.
function placeOf(sentence) {
  const triangle = /triangle (\d+)/.exec(sentence), vertex = /vert(?:ex|ices) (\d+)/.exec(sentence);
  if (triangle) return { triangle: Number(triangle[1]) - 1 };
  return vertex ? { vertex: Number(vertex[1]) - 1 } : {};
}

// Returns a sentence of the certificate, "kind: sentence", without the kind and without
// coordinates.
function plainSentence(witness) {
  const text = witness.replace(/^\w+: /, "").replace(/ \(-?[\d.][^()]*\)/g, "").replace(/, vertex (?=\d)/g, ", ")
    .replace(/of vertex (?=\d+, \d+, )/g, "of vertices ").replace(/\d+\.\d{6,}/g, (x) => angleText(Number(x)));
  return text[0].toUpperCase() + text.slice(1);
}

// Returns the findings grouped by kind: {name, items, all, words, number, follows}. `all` is the
// number that the certificate states; it names only the first findings of a kind.
function groupFindings(audit) {
  const order = Object.keys(findingKinds), groups = new Map();
  for (const witness of audit.witnesses) {
    const kind = /^(\w+): /.exec(witness)?.[1] ?? "", [words, follows = false] = findingKinds[kind] ?? [kind.replaceAll("_", " ")];
    if (!groups.has(kind)) groups.set(kind, { kind, words, follows, items: [] });
    groups.get(kind).items.push({ text: plainSentence(witness), title: witness, ...placeOf(witness) });
  }
  const rank = ({ kind }) => (order.indexOf(kind) + 1) || order.length + 1;
  const sorted = [...groups.values()].sort((a, b) => rank(a) - rank(b));
  const caused = sorted.some(({ follows }) => !follows);
  return sorted.map(({ kind, words, follows, items }) => {
    const all = audit.findings[kind] ?? items.length;
    return { name: `${follows && caused ? "Findings that may follow from those" : "Findings"}: ${words}`, items, all, words, number: count(all), follows: follows && caused };
  });
}

// Returns the number of findings of each kind, in words, for the table.
function findingsInWords(audit) {
  const order = Object.keys(findingKinds);
  return Object.entries(audit.findings).sort(([a], [b]) => order.indexOf(a) - order.indexOf(b))
    .map(([kind, n]) => `${count(n)} ${findingKinds[kind]?.[0] ?? kind.replaceAll("_", " ")}`).join("; ") || "none";
}

// Returns the triangles that findings name, without findings that may follow from others.
function trianglesWithFindings(audit) {
  const groups = groupFindings(audit);
  return new Set(groups.flatMap(({ items, follows }) => (follows ? [] : items)).map(({ triangle }) => triangle).filter((t) => t !== undefined));
}
