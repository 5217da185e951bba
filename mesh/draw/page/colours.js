// SPDX-License-Identifier: MIT
// Turns what is known of each triangle into one of 256 colours.

const mix = (a, b, s) => a.map((x, i) => x + (b[i] - x) * s);
const ramp = (stops) => (s) => {
  const at = Math.max(0, Math.min(1, s)) * (stops.length - 1), i = Math.min(stops.length - 2, Math.floor(at));
  return mix(stops[i], stops[i + 1], at - i);
};
// From red through yellow to blue, told apart by those who see red and green alike: dark, light, dark.
const badToGood = ramp([[165, 0, 38], [215, 90, 60], [253, 190, 110], [255, 250, 200], [171, 217, 233], [90, 150, 200], [49, 70, 149]]);
const lightToDark = ramp([[250, 247, 235], [220, 225, 170], [120, 190, 160], [50, 130, 150], [40, 70, 120], [30, 20, 70]]);
const distinct = [[102, 166, 214], [244, 165, 96], [120, 190, 120], [220, 120, 140], [170, 150, 210], [200, 180, 90],
                  [100, 190, 190], [210, 140, 200], [150, 170, 110], [190, 150, 130]];

const css = (rgb) => `rgb(${rgb.map(Math.round).join(",")})`;
const short = (x) => !Number.isFinite(x) ? String(x) : Math.abs(x) >= 1e5 || (x !== 0 && Math.abs(x) < 1e-3)
  ? x.toExponential(2) : String(Number(x.toPrecision(4)));

// A mode has a name, colours, of(t) as a number from 0 to 255, and what its legend says.
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

// The greatest over all triangles, without the rarest thousandth, so that one triangle does not
// take all the colours.
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

// Every mode that the mesh has something to say in; what is costly is computed when it is chosen.
function makeModes(mesh, bound) {
  const { least } = mesh.angles;
  const modes = [continuousMode("worst angle (degrees)", (t) => least[t], 0, 60, badToGood)];
  modes.push(() => {
    const values = new Float32Array(mesh.count);
    for (let t = 0; t < mesh.count; ++t) values[t] = Math.log10(triangleAspect(mesh, t));
    return continuousMode("aspect: length over width", (t) => values[t], 0, Math.max(0.1, upperEnd(values)),
                          lightToDark, (x) => short(10 ** x));
  });
  modes[1].label = "aspect: length over width";
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
  return modes;
}
