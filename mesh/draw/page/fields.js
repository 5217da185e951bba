// SPDX-License-Identifier: MIT
// Shows a solution on the mesh: values at the vertices, linear on each triangle.

// Scales from dark to light, with even steps for the eye and in print; and through white, for
// values of both signs.
const darkToLight = ramp([[68, 1, 84], [65, 68, 135], [42, 120, 142], [34, 168, 132], [122, 209, 81], [253, 231, 37]]);
const bothSigns = ramp([[30, 60, 150], [110, 150, 215], [245, 245, 245], [225, 130, 90], [150, 15, 35]]);

// Returns the scalars by which triangles can be coloured: a field of one component itself, the
// length and the components of a vector, the components of other fields.
function shownFields(mesh) {
  return mesh.shownFields ??= mesh.fields.flatMap(({ name, components, values }) => {
    if (components === 1) return [{ name, values }];
    const of = (act) => Float64Array.from({ length: mesh.vertices }, (_, v) => act(components * v));
    const parts = (components === 2 ? ["x", "y"] : ["xx", "xy", "yy"])
      .map((part, i) => ({ name: `${name}.${part}`, values: of((at) => values[at + i]) }));
    return components === 2 ? [{ name: `${name}, length`, values: of((at) => Math.hypot(values[at], values[at + 1])) }, ...parts] : parts;
  });
}

function rangeOf(values) {
  let low = Infinity, high = -Infinity;
  for (const x of values) {
    if (x < low) low = x;
    if (x > high) high = x;
  }
  return [low, high];
}

function fieldMode(mesh, { name, values }, meshes) {
  const title = `solution: ${name}`;
  const [low, high] = sharedRange(meshes, title, (m) => {
    const same = shownFields(m).find((field) => field.name === name);
    return same === undefined ? [Infinity, -Infinity] : rangeOf(same.values);
  });
  const signs = low < 0 && high > 0 && Math.min(-low, high) > 0.02 * (high - low), end = Math.max(-low, high);
  const [from, to] = signs ? [-end, end] : [low, high];
  const place = (x) => Math.max(0, Math.min(255, Math.round(255 * (x - from) / (to - from || 1))));
  const { triangles } = mesh, mean = (t) => (values[triangles[3 * t]] + values[triangles[3 * t + 1]] + values[triangles[3 * t + 2]]) / 3;
  return Object.assign(continuousMode(title, mean, from, to, signs ? bothSigns : darkToLight),
                       { isField: true, atVertex: (v) => place(values[v]), of: (t) => place(mean(t)) });
}

function fieldModes(mesh, meshes) {
  return shownFields(mesh).map((field) =>
    Object.assign(() => fieldMode(mesh, field, meshes), { label: `solution: ${field.name}`, isField: true }));
}

// Returns the value of a field at a point of triangle t.
function valueAt(mesh, values, t, point) {
  const { positions: p, triangles } = mesh, [a, b, c] = triangles.subarray(3 * t, 3 * t + 3);
  const area = (ux, uy, vx, vy) => ux * vy - uy * vx, x = (v) => p[2 * v] - point.x, y = (v) => p[2 * v + 1] - point.y;
  const parts = [[b, c], [c, a], [a, b]].map(([v, w]) => area(x(v), y(v), x(w), y(w))), whole = parts[0] + parts[1] + parts[2];
  if (whole === 0) return values[a];
  return (parts[0] * values[a] + parts[1] * values[b] + parts[2] * values[c]) / whole;
}
