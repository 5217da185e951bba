// SPDX-License-Identifier: MIT
// Measures the mesh again, in doubles, as the program's own reports do. This proves nothing.

const degrees = 180 / Math.PI;

// Returns a b - c d without loss of digits by cancellation. Both products are split into products
// of halves of 26 bits, which are exact.
function differenceOfProducts(a, b, c, d) {
  const left = a * b, right = c * d;
  return left - right + (roundingOf(a, b, left) - roundingOf(c, d, right));
}

function roundingOf(a, b, product) {
  const splitter = 134217729;
  const wideA = splitter * a, highA = wideA - (wideA - a), lowA = a - highA;
  const wideB = splitter * b, highB = wideB - (wideB - b), lowB = b - highB;
  return lowA * lowB - (product - highA * highB - lowA * highB - highA * lowB);
}

// Returns one tensor divided by its largest entry, so that nothing overflows or underflows, and the
// root of its determinant, which keeps its digits for thin tensors, too.
function scaledTensor(metrics, v) {
  const m11 = metrics[3 * v], m12 = metrics[3 * v + 1], m22 = metrics[3 * v + 2];
  const scale = Math.max(Math.abs(m11), Math.abs(m12), Math.abs(m22));
  const a = m11 / scale, b = m12 / scale, c = m22 / scale;
  return { a, b, c, root: Math.sqrt(Math.max(0, differenceOfProducts(a, c, b, b))), scale };
}

// Computes the nine angles of triangle t in degrees: angles[3 * from + corner] is the angle at
// `corner` in the metric of vertex `from`.
function nineAngles(mesh, t, angles = new Float64Array(9)) {
  const { positions: p, triangles } = mesh;
  const edges = mesh.scratch;  // from corner i to the next: x, y, longest component 1
  for (let i = 0; i < 3; ++i) {
    const from = 2 * triangles[3 * t + i], to = 2 * triangles[3 * t + (i + 1) % 3];
    const x = p[to] / 2 - p[from] / 2, y = p[to + 1] / 2 - p[from + 1] / 2;
    const scale = Math.max(Math.abs(x), Math.abs(y));
    edges[2 * i] = x / scale;
    edges[2 * i + 1] = y / scale;
  }
  for (let from = 0; from < 3; ++from) {
    const m = scaledTensor(mesh.metrics, triangles[3 * t + from]);
    for (let corner = 0; corner < 3; ++corner) {
      const before = (corner + 2) % 3;
      const ax = edges[2 * corner], ay = edges[2 * corner + 1];
      const bx = -edges[2 * before], by = -edges[2 * before + 1];
      const inner = m.a * ax * bx + m.b * (ax * by + ay * bx) + m.c * ay * by;
      const area = m.root * Math.abs(differenceOfProducts(ax, by, ay, bx));
      angles[3 * from + corner] = Math.atan2(area, inner) * degrees;
    }
  }
  return angles;
}

// Returns the length of the edge from v to w in v's metric.
function lengthFrom(mesh, v, w) {
  const { positions: p, metrics: m } = mesh;
  const x = p[2 * w] - p[2 * v], y = p[2 * w + 1] - p[2 * v + 1];
  const scale = Math.max(Math.abs(x), Math.abs(y)) || 1;
  const t = scaledTensor(m, v), a = x / scale, b = y / scale;
  const along = t.a * a + t.b * b;  // L^T e of the factorisation, whose squares only add
  const squared = t.a > 0 ? (along * along + t.root * t.root * b * b) / t.a : t.c * b * b;
  return scale * Math.sqrt(t.scale) * Math.sqrt(squared);
}

// Returns length over width of the metric's unit circle.
function metricAspect(metrics, v) {
  const t = scaledTensor(metrics, v);
  const mean = (t.a + t.c) / 2, spread = Math.hypot((t.a - t.c) / 2, t.b);
  return (mean + spread) / t.root;
}

// Returns the semi-axes of the unit circle, longest first, and the direction of the longest.
function unitCircle(metrics, v) {
  const t = scaledTensor(metrics, v);
  const mean = (t.a + t.c) / 2, spread = Math.hypot((t.a - t.c) / 2, t.b);
  const greatest = mean + spread, unit = 1 / Math.sqrt(t.scale);
  return {
    longest: unit * Math.sqrt(greatest) / t.root,
    shortest: unit / Math.sqrt(greatest),
    angle: 0.5 * Math.atan2(2 * t.b, t.a - t.c) + Math.PI / 2,
  };
}

// Returns length over width of a triangle in the plane: its longest edge over the height on that
// edge.
function triangleAspect(mesh, t) {
  const { positions: p, triangles } = mesh;
  let longest = 0;
  const at = [0, 1, 2].map((i) => 2 * triangles[3 * t + i]);
  for (let i = 0; i < 3; ++i)
    longest = Math.max(longest, Math.hypot(p[at[(i + 1) % 3]] - p[at[i]], p[at[(i + 1) % 3] + 1] - p[at[i] + 1]));
  const twice = differenceOfProducts(p[at[1]] - p[at[0]], p[at[2] + 1] - p[at[0] + 1],
                                     p[at[1] + 1] - p[at[0] + 1], p[at[2]] - p[at[0]]);
  return longest * longest / Math.abs(twice);
}

// Returns the root of the area of a triangle in the plane.
function triangleSize(mesh, t) {
  const { positions: p, triangles } = mesh, [a, b, c] = [0, 1, 2].map((i) => 2 * triangles[3 * t + i]);
  return Math.sqrt(Math.abs(differenceOfProducts(p[b] - p[a], p[c + 1] - p[a + 1], p[b + 1] - p[a + 1], p[c] - p[a])) / 2);
}

// Returns the least of the nine angles of each triangle, the number of angles in each degree, and
// the least angle of the mesh.
function measureAngles(mesh) {
  const least = new Float32Array(mesh.count), bins = new Float64Array(180);
  const nine = new Float64Array(9);
  const worst = { degrees: Infinity, triangle: -1 };
  for (let t = 0; t < mesh.count; ++t) {
    nineAngles(mesh, t, nine);
    let smallest = Infinity;
    for (let i = 0; i < 9; ++i) {
      if (nine[i] < smallest) smallest = nine[i];
      const bin = Math.floor(nine[i]);
      if (bin >= 0) bins[Math.min(179, bin)] += 1;
    }
    least[t] = smallest;
    if (smallest < worst.degrees) Object.assign(worst, { degrees: smallest, triangle: t });
  }
  return { least, bins, worst };
}

// Measures each edge once, by the mean of the lengths in both ends' metrics. Returns counts by the
// logarithm of the length, the number of edges, and the number of unit edges.
function measureLengths(mesh) {
  const keys = new Float64Array(3 * mesh.agreeing);
  for (let t = 0, k = 0; t < mesh.agreeing; ++t)
    for (let i = 0; i < 3; ++i, ++k) {
      const v = mesh.triangles[3 * t + i], w = mesh.triangles[3 * t + (i + 1) % 3];
      keys[k] = Math.min(v, w) * mesh.vertices + Math.max(v, w);
    }
  keys.sort();
  const bins = new Float64Array(lengthBins.count + 2);
  let edges = 0, unit = 0;
  for (let k = 0; k < keys.length; ++k) {
    if (k > 0 && keys[k] === keys[k - 1]) continue;
    const v = Math.floor(keys[k] / mesh.vertices), w = keys[k] - v * mesh.vertices;
    const length = (lengthFrom(mesh, v, w) + lengthFrom(mesh, w, v)) / 2;
    ++edges;
    if (length >= Math.SQRT1_2 && length <= Math.SQRT2) ++unit;
    bins[lengthBins.of(length)] += 1;
  }
  return { bins, edges, unit };
}

// Bins of lengths from 1/8 to 8, twelve an octave; the first and the last bin count lengths outside
// of this range.
const lengthBins = {
  count: 72,
  of: (length) => {
    const step = Math.floor(12 * (Math.log2(length) + 3)) + 1;
    return Number.isFinite(step) ? Math.max(0, Math.min(73, step)) : length > 1 ? 73 : 0;
  },
};
