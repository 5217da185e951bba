// SPDX-License-Identifier: MIT
//
// Doubles that propose and draw: metrics as ellipses, bisectors along rays, Voronoi vertices, wedges. None of
// it decides anything; what decides is asked of the predicates. A site is [x, y, m11, m12, m22].

export const squaredLength = (s, dx, dy) => s[2] * dx * dx + 2 * s[3] * dx * dy + s[4] * dy * dy;
export const squaredDistance = (s, x, y) => squaredLength(s, x - s[0], y - s[1]);

/** Semi-axes of the metric's unit circle, the longer first, and the direction of the longer. */
export function axesOf([m11, m12, m22]) {
  const mean = (m11 + m22) / 2, half = (m11 - m22) / 2, root = Math.hypot(half, m12);
  const least = Math.max((m11 * m22 - m12 * m12) / (mean + root), Number.MIN_VALUE);
  return { long: 1 / Math.sqrt(least), short: 1 / Math.sqrt(mean + root), angle: Math.atan2(-m12, -half) / 2 };
}

export function metricOfAxes({ long, short, angle }) {
  const a = 1 / (long * long), b = 1 / (short * short), c = Math.cos(angle), s = Math.sin(angle);
  return [a * c * c + b * s * s, (a - b) * c * s, a * s * s + b * c * c];
}

/** Applies a function to both eigenvalues. */
export function ofEigenvalues([m11, m12, m22], f) {
  const { long, short, angle } = axesOf([m11, m12, m22]);
  const a = f(1 / (long * long)), b = f(1 / (short * short)), c = Math.cos(angle), s = Math.sin(angle);
  return [a * c * c + b * s * s, (a - b) * c * s, a * s * s + b * c * c];
}

/** F with F^T F = M, as rows: where the metric's circles are round. */
export function warpOf(m11, m12, m22) {
  const root = Math.sqrt(m11), low = Math.sqrt(Math.max(m22 - m12 * m12 / m11, 0));
  return (x, y) => [root * x + m12 / root * y, low * y];
}

/** Real roots of a t^2 + b t + c, in order. */
function quadraticRoots(a, b, c) {
  if (a === 0) return b === 0 ? [] : [-c / b];
  const discriminant = b * b - 4 * a * c;
  if (!(discriminant >= 0)) return [];
  const q = -(b + (b < 0 ? -1 : 1) * Math.sqrt(discriminant)) / 2;
  const roots = q === 0 ? [0] : [q / a, c / q];
  return roots.sort((x, y) => x - y);
}

/** The least t > 0 where v + t u is on the bisector of v and w; infinite where the ray meets it nowhere. */
export function bisectorAlong(v, w, ux, uy) {
  const dx = w[0] - v[0], dy = w[1] - v[1];
  const linear = ux * (w[2] * dx + w[3] * dy) + uy * (w[3] * dx + w[4] * dy);
  const a = squaredLength(v, ux, uy) - squaredLength(w, ux, uy), c = -squaredLength(w, dx, dy);
  // Solves a t^2 + 2 linear t + c = 0 with c < 0 in 1 / t: the greatest root above 0 is the first
  // point on the ray.
  const discriminant = linear * linear - a * c;
  if (!(discriminant >= 0)) return Infinity;
  const root = Math.sqrt(discriminant);
  const reciprocal = linear >= 0 ? (linear + root) / -c : a / (root - linear);
  return reciprocal > 0 ? 1 / reciprocal : Infinity;
}

/** Points of the bisector of v and w that both see, along rays from v, in pieces. */
export function visibleArc(v, w, count = 360) {
  const pieces = [];
  let piece = null;
  const middle = Math.atan2(w[1] - v[1], w[0] - v[0]);
  for (let i = 0; i <= count; ++i) {
    // Samples more densely far out, where the ray is nearly parallel to the arc.
    const s = 2 * i / count - 1, angle = middle + Math.PI * (0.35 * s + 0.65 * s * s * s);
    const ux = Math.cos(angle), uy = Math.sin(angle), t = bisectorAlong(v, w, ux, uy);
    const x = v[0] + t * ux, y = v[1] + t * uy;
    const isSeen = t < 1e6 && Math.abs(bisectorAlong(w, v, x - w[0], y - w[1]) - 1) < 1e-6;
    if (!isSeen) piece = null;
    else if (piece) piece.push([x, y]);
    else pieces.push(piece = [[x, y]]);
  }
  return pieces.filter((p) => p.length > 1);
}

/** The part of a convex polygon where a x + b y > c. */
export function clipped(polygon, a, b, c) {
  const out = [];
  polygon.forEach(([x, y], i) => {
    const [x2, y2] = polygon[(i + 1) % polygon.length], here = a * x + b * y - c, there = a * x2 + b * y2 - c;
    if (here > 0) out.push([x, y]);
    if (here > 0 !== there > 0) out.push([x + (x2 - x) * here / (here - there), y + (y2 - y) * here / (here - there)]);
  });
  return out;
}

/** The wedge of v and w within a convex polygon. */
export function wedgeWithin(polygon, v, w) {
  const dx = w[0] - v[0], dy = w[1] - v[1];
  const vx = v[2] * dx + v[3] * dy, vy = v[3] * dx + v[4] * dy;
  const wx = w[2] * dx + w[3] * dy, wy = w[3] * dx + w[4] * dy;
  return clipped(clipped(polygon, vx, vy, vx * v[0] + vy * v[1]), -wx, -wy, -wx * w[0] - wy * w[1]);
}

function gradient(s, x, y) {
  const dx = x - s[0], dy = y - s[1];
  return [2 * (s[2] * dx + s[3] * dy), 2 * (s[3] * dx + s[4] * dy)];
}

/** Newton's method for a point as near to a, b and c; null where it does not come to one. */
function polished(a, b, c, [x, y]) {
  for (let step = 0; step < 20; ++step) {
    const f = squaredDistance(a, x, y), g1 = f - squaredDistance(b, x, y), g2 = f - squaredDistance(c, x, y);
    const ga = gradient(a, x, y), gb = gradient(b, x, y), gc = gradient(c, x, y);
    const h1 = [ga[0] - gb[0], ga[1] - gb[1]], h2 = [ga[0] - gc[0], ga[1] - gc[1]];
    const det = h1[0] * h2[1] - h1[1] * h2[0];
    const mx = (g1 * h2[1] - g2 * h1[1]) / det, my = (g2 * h1[0] - g1 * h2[0]) / det;
    if (!Number.isFinite(mx) || !Number.isFinite(my)) break;
    x -= mx, y -= my;
  }
  const f = squaredDistance(a, x, y);
  const miss = Math.max(Math.abs(f - squaredDistance(b, x, y)), Math.abs(f - squaredDistance(c, x, y)));
  return miss <= 1e-9 * f ? [x, y] : null;
}

/** Points as near to all three sites, nearest first: where along some line through a both bisectors are hit at
 * once. Two hits closer than a 48th of half a turn may be missed, as a touching may. */
export function voronoiVertices(a, b, c) {
  const found = [];
  const add = (start) => {
    const p = polished(a, b, c, start);
    if (p && !found.some((q) => Math.hypot(p[0] - q[0], p[1] - q[1]) < 1e-7 * (1 + Math.hypot(...q)))) found.push(p);
  };
  const scale = Math.hypot(b[0] - a[0], b[1] - a[1]);
  // In s = 1 / t the bisector of a and w along a line is C s^2 - B s - A = 0.
  const along = (w, ux, uy) => {
    const dx = w[0] - a[0], dy = w[1] - a[1];
    return { A: squaredLength(a, ux, uy) - squaredLength(w, ux, uy), C: squaredLength(w, dx, dy),
             B: 2 * (ux * (w[2] * dx + w[3] * dy) + uy * (w[3] * dx + w[4] * dy)) };
  };
  const resultant = (angle) => {
    const ux = scale * Math.cos(angle), uy = scale * Math.sin(angle), p = along(b, ux, uy), q = along(c, ux, uy);
    const e = q.C * p.A - p.C * q.A, f = q.C * p.B - p.C * q.B, g = p.B * q.A - q.B * p.A;
    return e * e - f * g;
  };
  const samples = 48;
  let last = resultant(0);
  for (let i = 1; i <= samples; ++i) {
    let low = Math.PI * (i - 1) / samples, high = Math.PI * i / samples;
    const value = resultant(high), isPositive = last > 0;
    last = value;
    if (isPositive === value > 0) continue;
    for (let k = 0; k < 40; ++k) {
      const middle = (low + high) / 2;
      if (resultant(middle) > 0 === isPositive) low = middle;
      else high = middle;
    }
    const ux = Math.cos(low), uy = Math.sin(low), p = along(b, ux, uy);
    for (const s of quadraticRoots(p.C, -p.B, -p.A)) if (s !== 0) add([a[0] + ux / s, a[1] + uy / s]);
  }
  add([(a[0] + b[0] + c[0]) / 3, (a[1] + b[1] + c[1]) / 3]);
  return found.sort((p, q) => squaredDistance(a, ...p) - squaredDistance(a, ...q));
}

/** Points where the arc of v and w leaves their wedge. */
export function wedgeExits(v, w) {
  const exits = [];
  for (const [from, to] of [[v, w], [w, v]]) {
    const dx = to[0] - from[0], dy = to[1] - from[1];
    const nx = -(from[3] * dx + from[4] * dy), ny = from[2] * dx + from[3] * dy;
    for (const side of [1, -1]) {
      const t = bisectorAlong(from, to, side * nx, side * ny);
      if (t < Infinity) exits.push([from[0] + side * t * nx, from[1] + side * t * ny]);
    }
  }
  return exits;
}

/** The least of the nine angles of a triangle, in degrees: three corners as each of three sites measures them. */
export function leastAngle(sites) {
  let least = 180, corner = 0;
  for (const by of sites)
    for (let k = 0; k < 3; ++k) {
      const p = sites[k], q = sites[(k + 1) % 3], r = sites[(k + 2) % 3];
      const ux = q[0] - p[0], uy = q[1] - p[1], vx = r[0] - p[0], vy = r[1] - p[1];
      const dot = by[2] * ux * vx + by[3] * (ux * vy + uy * vx) + by[4] * uy * vy;
      const area = Math.sqrt(Math.max(by[2] * by[4] - by[3] * by[3], 0)) * Math.abs(ux * vy - uy * vx);
      const angle = Math.atan2(area, dot) * 180 / Math.PI;
      if (angle < least) least = angle, corner = k;
    }
  return { degrees: least, corner };
}

/** Whole numbers from a seed, the same everywhere (mulberry32), as doubles in [0, 1). */
export function randomFrom(seed) {
  let state = seed >>> 0;
  return () => {
    state = (state + 0x6d2b79f5) >>> 0;
    let t = state;
    t = Math.imul(t ^ (t >>> 15), t | 1);
    t ^= t + Math.imul(t ^ (t >>> 7), t | 61);
    return ((t ^ (t >>> 14)) >>> 0) / 4294967296;
  };
}
