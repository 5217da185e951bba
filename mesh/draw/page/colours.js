// SPDX-License-Identifier: MIT
// Colours triangles by a measure or a property: one of 256 colours for each.

const mix = (a, b, s) => a.map((x, i) => x + (b[i] - x) * s);
const ramp = (stops) => (s) => {
  const at = Math.max(0, Math.min(1, s)) * (stops.length - 1), i = Math.min(stops.length - 2, Math.floor(at));
  return mix(stops[i], stops[i + 1], at - i);
};
// Scale from red through yellow to blue. Eyes that confuse red and green distinguish it by
// lightness: dark, light, dark.
const badToGood = ramp([[165, 0, 38], [215, 90, 60], [253, 190, 110], [255, 250, 200], [171, 217, 233], [90, 150, 200], [49, 70, 149]]);
// The same scale without red, for values at the bound or above; values below it have a colour of
// their own.
const boundToGood = ramp([[253, 190, 110], [255, 250, 200], [171, 217, 233], [90, 150, 200], [49, 70, 149]]), belowBound = [185, 0, 45];
const lightToDark = ramp([[250, 247, 235], [220, 225, 170], [120, 190, 160], [50, 130, 150], [40, 70, 120], [30, 20, 70]]);
const distinct = [[102, 166, 214], [244, 165, 96], [120, 190, 120], [220, 120, 140], [170, 150, 210], [200, 180, 90],
                  [100, 190, 190], [210, 140, 200], [150, 170, 110], [190, 150, 130]];

const css = (rgb) => `rgb(${rgb.map(Math.round).join(",")})`;
const short = (x) => !Number.isFinite(x) ? String(x) : Math.abs(x) >= 1e5 || (x !== 0 && Math.abs(x) < 1e-3)
  ? x.toExponential(2) : String(Number(x.toPrecision(4)));

// Makes a mode of colours: its name, the colour of a number from 0 to 255, that number for each
// triangle, and the texts of the legend.
function continuousMode(name, value, low, high, colour, text = short) {
  return {
    name,
    colour: (i) => colour(i / 255),
    of: (t) => Math.max(0, Math.min(255, Math.round(255 * (value(t) - low) / (high - low || 1)))),
    legend: { low: text(low), high: text(high) },
    value,
  };
}

function namedMode(name, names, of) {
  const colours = names.map(([, colour]) => colour);
  return { name, colour: (i) => colours[i % colours.length], of, legend: { names } };
}

// Returns the value that a thousandth of the values exceed: the end of a scale that single outliers
// do not stretch.
function upperEnd(values) {
  const sorted = Float32Array.from(values).sort();
  return sorted[Math.floor((sorted.length - 1) * 0.999)] ?? 1;
}

function regionMode(mesh) {
  const all = [...new Set(mesh.regions)].sort((a, b) => a - b);
  const place = new Map(all.map((region, i) => [region, i % distinct.length]));
  const names = all.slice(0, distinct.length).map((region, i) => [`region ${region}`, distinct[i]]);
  return namedMode(all.length > distinct.length ? `region (colours repeat)` : "region", names,
                   (t) => place.get(mesh.regions[t]) ?? 0);
}

function disagreementMode(mesh) {
  const names = [["in the stars of all three vertices", [150, 185, 215]],
                 ["not in all three", [244, 165, 66]],
                 ["disagreeing: the stars have no triangle in common here", [200, 40, 40]]];
  const refused = new Uint8Array(mesh.count);
  for (const t of mesh.notOfStars) refused[t] = 1;
  return namedMode("who disagrees", names, (t) => t >= mesh.agreeing ? 2 : refused[t]);
}

// Makes the mode of least angles: a scale from the bound upwards, and one colour below it. Without
// a bound the scale begins at the least angle of all meshes.
function angleMode(mesh, bound, meshes) {
  const { least } = mesh.angles, name = "least angle (degrees)", worst = Math.min(...meshes.map((m) => m.angles?.worst.degrees ?? 60));
  if (bound === null || !(bound < 60)) return continuousMode(name, (t) => least[t], Math.min(59, Math.max(0, worst)), 60, badToGood);
  const below = least.reduce((n, x) => n + (x < bound), 0), scale = continuousMode(name, (t) => least[t], bound, 60, boundToGood);
  return {
    ...scale,
    colour: (i) => (i === 0 ? belowBound : boundToGood((i - 1) / 254)),
    of: (t) => (least[t] < bound ? 0 : 1 + Math.round(scale.of(t) * 254 / 255)),
    legend: { low: `${short(bound)}, the bound`, high: "60", mark: true, names: [[below === 0 ? "below it: none" : `below it: ${below.toLocaleString("en-US")}`, belowBound]] },
  };
}

// Returns the ends of a scale over all meshes of the page, so that a colour means the same value in
// each.
function sharedRange(meshes, name, rangeOf) {
  const known = (meshes.ranges ??= new Map());
  if (!known.has(name)) {
    const ranges = meshes.filter(({ count }) => count > 0).map(rangeOf);
    known.set(name, [Math.min(...ranges.map(([low]) => low)), Math.max(...ranges.map(([, high]) => high))]);
  }
  return known.get(name);
}

// Makes a mode that shows the logarithm of a measure. It is computed when the mode is chosen.
function logarithmicMode(mesh, name, of, meshes) {
  const valuesOf = (m) => {
    const values = new Float32Array(m.count);
    for (let t = 0; t < m.count; ++t) values[t] = Math.log10(of(m, t));
    return values;
  };
  const values = valuesOf(mesh);
  const [low, high] = sharedRange(meshes, name, (m) => {
    const all = m === mesh ? values : valuesOf(m);
    return [all.reduce((a, b) => Math.min(a, b), Infinity), upperEnd(all)];
  });
  return continuousMode(name, (t) => values[t], low, Math.max(low + 0.1, high), lightToDark, (x) => short(10 ** x));
}

function findingMode(mesh, named) {
  const mode = namedMode("findings", [["no finding names it", [190, 205, 220]], ["a finding names it", belowBound]], (t) => (named.has(t) ? 1 : 0));
  return Object.assign(mode, { shownTriangles: [...named].slice(0, 100) });
}

// Returns the mode that is shown at first: findings if there are any, else a solution if there is
// one, else shapes of triangles, or sizes if the shapes are nearly round, or angles if the sizes
// are alike, too.
function firstMode(mesh, modes, named) {
  if (named.size > 0) return modes.length - 1;
  const solution = modes.findIndex((mode) => mode.isField);
  if (solution >= 0) return solution;
  const some = Math.max(1, Math.floor(mesh.count / 2000)), aspects = [], sizes = [];
  for (let t = 0; t < mesh.count; t += some) {
    aspects.push(triangleAspect(mesh, t));
    sizes.push(triangleSize(mesh, t));
  }
  const at = (values, s) => values.sort((a, b) => a - b)[Math.floor((values.length - 1) * s)] ?? 1;
  return at(aspects, 0.9) > 4 ? 1 : at(sizes, 0.95) > 3 * at(sizes, 0.05) ? 2 : 0;
}

// Makes all modes for which the mesh has values. Those that take long to compute are functions,
// called when they are chosen.
function makeModes(mesh, bound, claim, meshes) {
  if (mesh.count === 0) return Object.assign([namedMode("no triangles", [["a domain: its segments alone", [190, 205, 220]]], () => 0)], { first: 0 });
  const { least } = mesh.angles, modes = [angleMode(mesh, bound, meshes)];
  for (const [label, of] of [["aspect: length over width", triangleAspect], ["size: root of the area", triangleSize]])
    modes.push(Object.assign(() => logarithmicMode(mesh, label, of, meshes), { label }));
  modes.push(...fieldModes(mesh, meshes));
  if (mesh.regions.length > 0) modes.push(regionMode(mesh));
  if (mesh.distances.length > 0) {
    const values = new Float32Array(mesh.count);
    for (let t = 0; t < mesh.count; ++t)
      for (let i = 0; i < 3; ++i) values[t] = Math.max(values[t], mesh.distances[mesh.triangles[3 * t + i]]);
    modes.push(continuousMode("distance of the metric delivered from the one wanted", (t) => values[t], 0,
                              Math.max(0.01, upperEnd(values)), lightToDark,
                              (x) => `lengths changed by ${short(100 * (Math.exp(x) - 1))} %`));
  }
  modes.push(disagreementMode(mesh));
  if (bound !== null)
    modes.push(namedMode(`below the bound of ${bound} degrees`,
                         [["at the bound or above", [150, 185, 215]], ["below, as one of its vertices measures it", [200, 40, 40]]],
                         (t) => least[t] < bound ? 1 : 0));
  const named = claim === null || claim.audit.certified ? new Set() : trianglesWithFindings(claim.audit);
  if (named.size > 0) modes.push(findingMode(mesh, named));
  return Object.assign(modes, { first: firstMode(mesh, modes, named) });
}
