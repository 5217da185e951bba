// SPDX-License-Identifier: MIT
// Shows texts, tables and charts beside the picture. Text from files is inserted as text, never as
// markup.

function make(tag, attributes = {}, ...children) {
  const made = document.createElementNS(["svg", "rect", "line", "text", "title"].includes(tag) ? "http://www.w3.org/2000/svg"
                                                                            : "http://www.w3.org/1999/xhtml", tag);
  for (const [name, value] of Object.entries(attributes)) made.setAttribute(name, value);
  made.append(...children.map((c) => (typeof c === "number" ? String(c) : c)));
  return made;
}

function table(heads, rows, caption) {
  const row = (cells, tag) => make("tr", {}, ...cells.map((cell, i) => {
    const { text = cell, kind = "", title } = cell?.text === undefined ? {} : cell;
    const head = tag === "th" ? { scope: "col" } : i === 0 ? { scope: "row" } : {};
    return make(i === 0 ? "th" : tag, { ...head, class: kind, ...(title === undefined ? {} : { title }) }, text);
  }));
  return make("table", { "aria-label": caption }, make("thead", {}, row(heads, "th")),
              make("tbody", {}, ...rows.map((cells) => row(cells, "td"))));
}

const full = (x) => (x === null || x === undefined ? "none" : typeof x === "number" ? String(Number(x.toPrecision(12))) : String(x));
// Returns an angle cut to some digits, not rounded: an angle below a bound never reads as the
// bound.
const angleText = (x, digits = 4) => String(Number((Math.floor(x * 10 ** digits) / 10 ** digits).toFixed(digits)));
const angleCell = (x, kind = "") => x === null || x === undefined ? "none" : { text: `${angleText(x)} degrees`, title: full(x), kind };
const angle = (x) => (x === null || x === undefined ? "none" : `${Number(x).toFixed(2)} degrees`);
// Returns a number with three digits, rounded up.
const upward = (x) => { const [digits, power] = x.toExponential(2).split("e"), up = Number(`${digits}e${power}`); return short(up >= x ? up : Number(`${(Number(digits) + 0.01).toFixed(2)}e${power}`)); };
const count = (n) => Number(n).toLocaleString("en-US");
// Returns a number as a whole one if it is at least 10,000, else with four digits.
const large = (x) => (x >= 1e4 && x < 1e15 ? count(Math.round(x)) : short(x));
const plural = (n, one, many = `${one}s`) => `${count(n)} ${n === 1 ? one : many}`;

// Returns the badge, its kind and one sentence; they claim no more than the certificate.
function verdictOf(facts, claim) {
  if (claim === null)
    return ["Not judged", "open", "There is no certificate with this page; the commands at its end judge the mesh."];
  if (!facts.is_of_this_mesh)
    return ["NOT the certificate's mesh", "bad", `The certificate is of a mesh with the fingerprint ${claim.mesh.fingerprint}.`];
  const { outcome, audit, asked } = claim;
  const bound = asked.angle_bound === null ? "no bound" : `${full(asked.angle_bound)} degrees`;
  const delivered = outcome.delivered && outcome.delivered.vertices_changed > 0;
  const where = delivered ? "in the metric delivered, which is not everywhere the one asked for" : "in the metric at its vertices";
  if (audit.certified && outcome.complete)
    return ["Certified", "good", `${bound}, ${where}: ${outcome.reason}.`];
  if (audit.certified && delivered)
    return ["Certified in the metric delivered, NOT complete", "open", `${bound}, ${where}: ${outcome.reason}.`];
  const first = groupFindings(audit).filter(({ follows }) => !follows)[0];
  return ["NOT certified", "bad", `${outcome.reason}${first ? `; first of all, ${first.words} (${count(first.number)})` : ""}.`];
}

function showVerdict(facts, claim) {
  const [badge, kind, why] = verdictOf(facts, claim);
  element("badge").textContent = badge;
  element("badge").className = kind;
  element("why").textContent = why.replace(/\.\.$/, ".");
  if (kind === "bad") element("numbers").prepend(element("s-places"));  // what is wrong comes first
}

// Where a mesh from elsewhere was judged, a size scales the metric, and 1 leaves it as it is.
const isFromElsewhere = (claim) => claim.asked.options.mesh !== undefined;
const hasSize = (claim) => ![undefined, "none", ...(isFromElsewhere(claim) ? ["1"] : [])].includes(claim.asked.options.size);

function metricRow(claim) {
  const { delivered } = claim.outcome, { metric, options } = claim.asked;
  const asked = isFromElsewhere(claim) && hasSize(claim) ? `${metric}, of which a length of 1 is ${options.size}` : metric;
  if (delivered && delivered.vertices_changed === 0) return ["Metric", asked, "as asked, at every vertex"];
  if (delivered)
    return ["Metric", asked, `another at ${plural(delivered.vertices_changed, "vertex", "vertices")}; at ${short(100 * delivered.beyond_tenth)} % of all some length differs by more than a tenth, at most ${short(Math.exp(delivered.greatest))} times`];
  return ["Metric", asked, "the tensors at the vertices"];
}

// Returns rows of a table: what was asked for, the certificate's values, and the values that this
// page measures.
function askedRows(facts, claim, mesh) {
  const { asked, outcome, audit, measured } = claim, options = asked.options;
  const least = Math.min(...[audit.worst_angle, audit.worst_collateral_angle, audit.worst_exempt_angle].map((x) => x ?? 180));
  const same = Math.abs(least - mesh.angles.worst.degrees) < 1e-6;
  const rows = [["Least angle", asked.angle_bound === null ? "none" : `${full(asked.angle_bound)} degrees`, angleCell(audit.worst_angle)]];
  if (audit.worst_exempt_angle !== null) rows.push(["of exempt corners", "", angleCell(audit.worst_exempt_angle)]);
  if (audit.worst_collateral_angle !== null) rows.push(["of collateral triangles", "", angleCell(audit.worst_collateral_angle)]);
  if (audit.angles_checked)
    rows.push(["Least of all, measured by this page", "", { text: `${angleText(mesh.angles.worst.degrees)} degrees, ${same ? "the same" : audit.certified ? "NOT the same" : "with triangles that were not judged"}`, title: full(mesh.angles.worst.degrees), kind: same || !audit.certified ? "" : "bad" }]);
  const delivered = options["size-delivered"];
  if (!isFromElsewhere(claim)) rows.push(["Size", options.size ?? "none", delivered && delivered !== options.size ? delivered : hasSize(claim) ? "as asked" : "not asked for"]);
  rows.push(["Vertices", options["max-sites"] ? `at most ${count(options["max-sites"])}` : "", count(claim.mesh.vertices)]);
  rows.push(["Triangles", "", count(claim.mesh.triangles)]);
  if (outcome.delivered)
    rows.push(["Complexity", large(outcome.delivered.complexity_wanted), large(outcome.delivered.complexity_delivered)]);
  else if (measured.metric_area !== undefined) rows.push(["Complexity", "", large(measured.metric_area)]);
  rows.push(metricRow(claim));
  if (measured.unit_edges !== undefined && hasSize(claim)) rows.push(["Edges of length 0.71 to 1.41", "", `${short(100 * measured.unit_edges)} %`]);
  rows.push(["Boundary off its segments", "", audit.largest_boundary_deviation === null ? "not known" : audit.largest_boundary_deviation === 0 ? "nowhere" : { text: `at most ${upward(audit.largest_boundary_deviation)}`, title: full(audit.largest_boundary_deviation) }]);
  if (audit.curves) rows.push(["Boundary off the curves", "", audit.curves.largest_distance === null ? "not known" : `at most ${upward(audit.curves.largest_distance)}; ${audit.curves.vertices} vertices on them, ${audit.curves.vertices_off} on chords`]);
  if (audit.voronoi !== "not asked") rows.push(["Dual of the Voronoi diagram", "yes", audit.voronoi]);
  rows.push(["Findings against it", "none", findingsInWords(audit)]);
  return rows.map((cells) => cells.slice(0, 3));
}

function showAsked(facts, claim, mesh) {
  const holder = element("asked");
  if (claim === null)
    holder.replaceChildren(table(["", "Here"], [["Vertices", count(facts.vertices)], ["Triangles", count(facts.triangles)],
      ["Least angle, measured by this page", angleCell(mesh.angles.worst.degrees)]], "What there is"));
  else
    holder.replaceChildren(table(["", "Asked", "Delivered"], askedRows(facts, claim, mesh), "Asked and delivered"));
  if (facts.claim_from) holder.append(make("p", { class: "soft" }, facts.claim_from));
}

// Draws a bar chart, and adds its numbers as a table for readers who cannot see it. `bars` have a
// name, a number n, and `low` if they are below the bound.
function chart(holder, name, bars, ticks, mark) {
  const width = 420, height = 130, foot = 18, most = Math.max(1, ...bars.map((b) => b.n));
  const svg = make("svg", { viewBox: `0 0 ${width} ${height + foot}`, class: "chart", role: "img", "aria-label": name });
  const x = (i) => i * width / bars.length;
  bars.forEach((bar, i) => {
    const h = bar.n > 0 ? Math.max(1, bar.n / most * height) : 0;
    svg.append(make("rect", { x: x(i) + 0.5, y: height - h, width: width / bars.length - 1, height: h, class: bar.low ? "low" : "" },
                    make("title", {}, `${bar.name}: ${count(bar.n)}`)));
  });
  svg.append(make("line", { x1: 0, x2: width, y1: height, y2: height }));
  for (const [place, text] of ticks)
    svg.append(make("text", { x: Math.min(width - 2, place * width), y: height + 14, "text-anchor": place <= 0 ? "start" : place >= 1 ? "end" : "middle" }, text));
  if (mark !== null) svg.append(make("line", { x1: mark * width, x2: mark * width, y1: 0, y2: height, class: "bound" }));
  const rows = bars.filter((b) => b.n > 0).map((b) => [b.name, { text: count(b.n), kind: "n" }]);
  holder.replaceChildren(svg, make("details", {}, make("summary", {}, "The numbers"), table([name, { text: "Number", kind: "n" }], rows, name)));
}

function showAngles(mesh, bound) {
  if (mesh.count === 0) return element("angles").replaceChildren(make("p", {}, "There are no triangles."));
  const bars = [];
  for (let from = 0; from < 180; from += 3)
    bars.push({ name: `${from} to ${from + 3} degrees`, low: bound !== null && from + 3 <= bound,
                n: mesh.angles.bins.slice(from, from + 3).reduce((a, b) => a + b, 0) });
  const total = mesh.angles.bins.reduce((a, b) => a + b, 0);
  chart(element("angles"), "Angles, each as all three vertices measure it", bars,
        [[0, "0"], [60 / 180, "60"], [120 / 180, "120"], [1, "180 degrees"]], bound === null ? null : bound / 180);
  element("angles").append(make("p", {}, `${count(total)} angles: three of each triangle, each as its three vertices measure it. The least is ${angle(mesh.angles.worst.degrees)}${bound === null ? "" : `; the line is the bound, ${full(bound)} degrees`}.`));
  return undefined;
}

function showLengths(mesh) {
  const { bins, edges, unit } = mesh.lengths ??= measureLengths(mesh), bars = [];
  const text = (i) => short(2 ** (i / 12 - 3));
  for (let i = 0; i < bins.length; i += 2)
    bars.push({ name: i === 0 ? `below ${text(1)}` : i === 72 ? `above ${text(71)}` : `${text(i - 1)} to ${text(i + 1)}`, n: bins[i] + bins[i + 1] });
  chart(element("lengths"), "Edge lengths in the metric", bars, [[0, "1/8"], [1 / 3, "1/2"], [1 / 2, "1"], [2 / 3, "2"], [1, "8"]], null);
  element("lengths").append(make("p", {}, `${plural(edges, "edge")}, each as long as its two ends measure it in the mean; ${count(unit)} (${short(100 * unit / Math.max(1, edges))} %) from 0.71 to 1.41.`));
}

// Returns the places where the domain was repaired, as the certificate lists them ("what x y; what
// x y"), each with the vertex at it or nearest to it.
function repairsOf(claim, mesh) {
  const text = claim?.asked.options["repair-places"] ?? "none", p = mesh.positions, known = new Map();
  if (text === "none") return [];
  for (let v = mesh.vertices - 1; v >= 0; --v) known.set(`${p[2 * v]} ${p[2 * v + 1]}`, v);
  const nearest = (x, y) => {
    let best = 0;
    for (let v = 1; v < mesh.vertices; ++v)
      if (Math.hypot(p[2 * v] - x, p[2 * v + 1] - y) < Math.hypot(p[2 * best] - x, p[2 * best + 1] - y)) best = v;
    return best;
  };
  return text.split("; ").map((place) => {
    const [, what, x, y] = /^(.*) (\S+) (\S+)$/.exec(place), key = `${Number(x)} ${Number(y)}`;
    return { x: Number(x), y: Number(y), vertex: known.get(key) ?? nearest(Number(x), Number(y)), text: `${what} (${x}, ${y})` };
  });
}

// Returns the lists of places: each has a name, and items {triangle} or {vertex} with a text.
function listsOf(facts, claim, mesh) {
  const triangles = (numbers) => numbers.map((t) => ({ triangle: t, text: String(t + 1) }));
  const fromOne = (numbers = []) => triangles(numbers.map((n) => n - 1));
  const lists = [];
  const add = (name, items, long = false) => { if (items.length > 0) lists.push({ name, items, long }); };
  if (claim !== null && facts.is_of_this_mesh) {
    const { audit, outcome } = claim;
    groupFindings(audit).forEach(({ name, items, all }, rank) => lists.push({ name, items, all, long: true, closed: rank > 0 }));
    add("Low triangles: below the bound", fromOne(audit.low_triangles));
    add("Exempt corners of the domain, sharper than the bound", audit.exempt_corners.map((n) => ({ vertex: n - 1, text: `vertex ${n}` })));
    add("Triangles with an exempt angle", fromOne(audit.exempt_triangles));
    add("Collateral triangles: below the bound beside a sharp corner", fromOne(audit.collateral_triangles));
    add("Low triangles as the metric wanted measures them", fromOne(outcome.delivered?.low_triangles_as_wanted));
  }
  add("Repairs of the domain", mesh.repairs);
  add("Disagreeing triangles", triangles(Array.from({ length: facts.disagreeing }, (_, i) => facts.triangles + i)));
  add("Triangles not in the stars of all their vertices", triangles([...mesh.notOfStars]));
  const changed = [...mesh.distances.keys()].filter((v) => mesh.distances[v] > 0).sort((v, w) => mesh.distances[w] - mesh.distances[v] || v - w);
  add("Changed metrics, the most changed first", changed.map((v) => ({ vertex: v, text: `vertex ${v + 1}: ${short(Math.exp(mesh.distances[v]))} times` })));
  const least = mesh.angles.least, worst = [...leastOf(least, 10)];
  add("The ten smallest angles", worst.map((t) => ({ triangle: t, text: `${t + 1}: ${least[t].toFixed(2)}°` })));
  return lists;
}

function leastOf(values, n) {
  let limit = Infinity;
  const kept = [];
  for (let t = 0; t < values.length; ++t) {
    if (!(values[t] < limit)) continue;
    kept.push(t);
    kept.sort((a, b) => values[a] - values[b] || a - b);
    if (kept.length > n) kept.pop();
    if (kept.length === n) limit = values[kept[n - 1]];
  }
  return kept;
}

function showLists(lists, go) {
  const holder = element("places");
  holder.replaceChildren();
  if (lists.length === 0) holder.append(make("p", {}, "None."));
  for (const { name, items, all = items.length, long, closed = false } of lists) {
    const list = make("ul", { class: long ? "list long" : "list" });
    // Adds a few items at first, and more on demand. The lists do not scroll by themselves: on a
    // telephone that would keep a finger from scrolling the page.
    const more = (from, most) => {
      items.slice(from, from + most).forEach((item) => {
        const button = make("button", { type: "button", ...(item.title === undefined ? {} : { title: item.title }) }, item.text);
        button.addEventListener("click", () => go(item));
        list.append(make("li", {}, button));
      });
      if (from + most >= items.length) return;
      const next = make("button", { type: "button" }, `${count(items.length - from - most)} more`);
      const entry = make("li", {}, next);
      next.addEventListener("click", () => { entry.remove(); more(from + most, 100); });
      list.append(entry);
    };
    more(0, long ? 5 : 40);
    const number = all > items.length ? `${count(items.length)} of ${count(all)}` : count(items.length);
    holder.append(make("details", items.length <= 20 && !closed ? { open: "" } : {}, make("summary", {}, `${name} (${number})`), list));
  }
}

// Makes a table of positions and tensors with seven digits; the title of a cell has all digits.
function tensorTable(mesh, corners) {
  const { positions: p, metrics: m } = mesh, circles = corners.map((v) => unitCircle(m, v));
  const row = (name, of) => [name, ...corners.map((v) => ({ text: Number(of(v).toPrecision(7)), kind: "n", title: of(v) }))];
  const words = (name, of) => [name, ...circles.map((circle) => ({ text: of(circle), kind: "n" }))];
  return table(["Vertex", ...corners.map((v) => ({ text: v + 1, kind: "n" }))], [
    row("x", (v) => p[2 * v]), row("y", (v) => p[2 * v + 1]),
    ...shownFields(mesh).slice(0, 12).map(({ name, values }) => row(name, (v) => values[v])),
    row("m11", (v) => m[3 * v]), row("m12", (v) => m[3 * v + 1]), row("m22", (v) => m[3 * v + 2]),
    words("unit circle, length", (circle) => short(2 * circle.longest)),
    words("and width", (circle) => short(2 * circle.shortest)),
    words("lies at", (circle) => `${(((circle.angle * degrees) % 180 + 180) % 180).toFixed(1)}°`),
  ], "Positions and metric tensors");
}

function angleTable(mesh, t, corners, bound) {
  const nine = nineAngles(mesh, t);
  return table(["Measured by", ...corners.map((v) => ({ text: `at ${v + 1}`, kind: "n" }))],
               corners.map((v, from) => [`vertex ${v + 1}`, ...corners.map((_, corner) => {
                 const x = nine[3 * from + corner];
                 return { text: `${x.toFixed(4)}°`, kind: bound !== null && x < bound ? "n low" : "n" };
               })]), "The nine angles");
}

// Returns the sentences of the certificate that name the triangle, or two of its vertices.
function witnessesOf(claim, t, corners) {
  if (claim === null) return [];
  return claim.audit.witnesses.filter((sentence) => {
    if (new RegExp(`triangle ${t + 1}\\b`).test(sentence)) return true;
    return corners.filter((v) => new RegExp(`\\b${v + 1}\\b`).test(sentence.replace(/\([^)]*\)/g, ""))).length >= 2;
  });
}

function showChosen(facts, claim, mesh, bound, item) {
  const holder = element("chosen");
  if (item === null) return holder.replaceChildren(make("p", {}, "None chosen."));
  if (item.triangle === undefined) {
    holder.replaceChildren(make("p", {}, `Vertex ${item.vertex + 1}${item.vertex < facts.given ? ", given" : ""}.`), tensorTable(mesh, [item.vertex]));
    if (mesh.distances.length > 0) holder.append(make("p", {}, distanceText(mesh.distances[item.vertex])));
    return undefined;
  }
  const t = item.triangle, corners = [...mesh.triangles.subarray(3 * t, 3 * t + 3)];
  element("number").value = t + 1;
  const kind = t >= mesh.agreeing ? "disagreeing" : mesh.regions.length > 0 ? `region ${mesh.regions[t]}` : "region 1";
  const said = witnessesOf(claim, t, corners);
  holder.replaceChildren(
    make("p", {}, `Triangle ${count(t + 1)} of vertices ${corners.map((v) => v + 1).join(", ")}; ${kind}; least angle ${angle(mesh.angles.least[t])}; length over width ${short(triangleAspect(mesh, t))}.`),
    angleTable(mesh, t, corners, bound), tensorTable(mesh, corners),
    make("p", {}, "Edges: " + corners.map((v, i) => {
      const w = corners[(i + 1) % 3];
      return `${v + 1}-${w + 1} ${short((lengthFrom(mesh, v, w) + lengthFrom(mesh, w, v)) / 2)}`;
    }).join(", ") + "."),
    make("p", {}, said.length > 0 ? "Witnesses:" : "No finding names it."), ...said.map((s) => make("p", { class: "bad" }, s)));
  if (mesh.distances.length > 0)
    holder.append(make("p", {}, "Metric delivered at its vertices: " + corners.map((v) => distanceText(mesh.distances[v])).join("; ") + "."));
  return undefined;
}

const distanceText = (d) => d === 0 ? "as wanted, to the last bit" : `lengths up to ${short(Math.exp(d))} times those wanted`;

function showAgain(facts, claim) {
  const holder = element("again");
  holder.replaceChildren(table(["", "Fingerprint"], [["This mesh", { text: facts.fingerprint, kind: "hash" }],
    ...(claim === null ? [] : [["The certificate's mesh", { text: claim.mesh.fingerprint, kind: "hash" }], ["The metric asked for", { text: claim.asked.options["metric-fingerprint"] ?? "none", kind: "hash" }]])], "Fingerprints"));
  if (facts.repeat) holder.append(make("p", {}, "This page measures and does not prove. The proof is repeated, by exact arithmetic, by"), make("pre", {}, facts.repeat));
  holder.append(make("p", { class: "soft" }, `Made by asterism ${facts.program}. Vertices and triangles are counted from 1, as in the .mesh file.`));
}

function showLegend(mode) {
  const { low, high, names = [], mark = false } = mode.legend, parts = [];
  const box = ([text, colour]) => make("span", {}, make("span", { class: "box", style: `background:${css(colour)}` }), text);
  if (low !== undefined) {
    const stops = Array.from({ length: 9 }, (_, i) => css(mode.colour(Math.round((mark ? 1 : 0) + i * (mark ? 254 : 255) / 8)))).join(",");
    parts.push(make("span", {}, mode.name), make("span", { class: mark ? "mark" : "" }, low),
      make("span", { class: "bar", role: "img", "aria-label": `colours from ${low} to ${high}`, style: `background:linear-gradient(to right,${stops})` }), make("span", {}, high));
  }
  element("colours").replaceChildren(...parts, ...names.map(box));
}

function showEllipses({ number, scale, tooMany }) {
  const told = tooMany ? `Ellipses: none while more than ${count(mostEllipses)} vertices are in sight` : number === 0 ? "" : `Ellipses: the metric's unit circles, ${scale === 1 ? "in their own size" : `${short(scale)} times their size`}`;
  if (element("scaled").textContent !== told) element("scaled").textContent = told;
}
