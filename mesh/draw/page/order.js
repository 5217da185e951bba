// SPDX-License-Identifier: MIT
// Puts triangles near each other into chunks, so that a view draws few triangles out of sight and a
// click searches few.

const chunkSize = 4096;  // triangles
const fixedRange = 2 ** 31 - 1;  // positions on the card: differences of two fit into its integers

// Returns the triangles in their order along a Z-shaped curve through their centroids.
function placesInOrder(mesh) {
  const { positions: p, triangles, box } = mesh, cells = 1024;
  const keys = new Uint32Array(mesh.count);
  const spread = (n) => {
    n = (n | n << 8) & 0x00ff00ff;
    n = (n | n << 4) & 0x0f0f0f0f;
    n = (n | n << 2) & 0x33333333;
    return (n | n << 1) & 0x55555555;
  };
  const cell = (x, from, to) => Math.max(0, Math.min(cells - 1, Math.floor((x - from) / (to - from) * cells)));
  for (let t = 0; t < mesh.count; ++t) {
    let x = 0, y = 0;
    for (let i = 0; i < 3; ++i) {
      x += p[2 * triangles[3 * t + i]] / 3;
      y += p[2 * triangles[3 * t + i] + 1] / 3;
    }
    keys[t] = spread(cell(x, box.x0, box.x1)) | spread(cell(y, box.y0, box.y1)) << 1;
  }
  const starts = new Uint32Array(cells * cells + 1);
  for (const key of keys) ++starts[key + 1];
  for (let i = 0; i < cells * cells; ++i) starts[i + 1] += starts[i];
  const order = new Uint32Array(mesh.count);
  for (let t = 0; t < mesh.count; ++t) order[starts[keys[t]]++] = t;
  return order;
}

function boxOfTriangles(mesh, order, from, to) {
  const { positions: p, triangles } = mesh;
  const box = { x0: Infinity, y0: Infinity, x1: -Infinity, y1: -Infinity };
  for (let k = from; k < to; ++k)
    for (let i = 0; i < 3; ++i) {
      const v = 2 * triangles[3 * order[k] + i];
      box.x0 = Math.min(box.x0, p[v]); box.x1 = Math.max(box.x1, p[v]);
      box.y0 = Math.min(box.y0, p[v + 1]); box.y1 = Math.max(box.y1, p[v + 1]);
    }
  return box;
}

// Divides the triangles into chunks: order[from .. to) are the triangles of one, `box` is their
// box.
function makeChunks(mesh) {
  const order = placesInOrder(mesh), chunks = [];
  for (let from = 0; from < mesh.count; from += chunkSize) {
    const to = Math.min(mesh.count, from + chunkSize);
    chunks.push({ from, to, box: boxOfTriangles(mesh, order, from, to) });
  }
  return { order, chunks };
}

const meet = (a, b) => a.x0 <= b.x1 && b.x0 <= a.x1 && a.y0 <= b.y1 && b.y0 <= a.y1;

// Returns positions as integers, counted from the box's corner: the graphics card subtracts them
// exactly, however close the view is.
function toFixed(mesh, numbers) {
  const { positions: p, box } = mesh, fixed = new Uint32Array(2 * numbers.length);
  const sx = fixedRange / (box.x1 - box.x0), sy = fixedRange / (box.y1 - box.y0);
  for (let k = 0; k < numbers.length; ++k) {
    fixed[2 * k] = Math.round((p[2 * numbers[k]] - box.x0) * sx);
    fixed[2 * k + 1] = Math.round((p[2 * numbers[k] + 1] - box.y0) * sy);
  }
  return fixed;
}

// Returns the triangle that contains the point, or -1. Of overlapping triangles it is the one drawn
// last.
function triangleAt(mesh, { order, chunks }, x, y) {
  const { positions: p, triangles } = mesh;
  const side = (v, w) => (p[2 * w] - p[2 * v]) * (y - p[2 * v + 1]) - (p[2 * w + 1] - p[2 * v + 1]) * (x - p[2 * v]);
  for (let c = chunks.length - 1; c >= 0; --c) {
    if (!meet(chunks[c].box, { x0: x, x1: x, y0: y, y1: y })) continue;
    for (let k = chunks[c].to - 1; k >= chunks[c].from; --k) {
      const t = order[k], [a, b, d] = triangles.subarray(3 * t, 3 * t + 3);
      const s = [side(a, b), side(b, d), side(d, a)];
      if (s.every((one) => one >= 0) || s.every((one) => one <= 0)) return t;
    }
  }
  return -1;
}

// Returns the vertices in sight, or null if there are more than `most`.
function verticesIn(mesh, { order, chunks }, sight, most) {
  const seen = new Set();
  for (const { from, to, box } of chunks) {
    if (!meet(box, sight)) continue;
    for (let k = from; k < to; ++k)
      for (let i = 0; i < 3; ++i) {
        const v = mesh.triangles[3 * order[k] + i], x = mesh.positions[2 * v], y = mesh.positions[2 * v + 1];
        if (x >= sight.x0 && x <= sight.x1 && y >= sight.y0 && y <= sight.y1) seen.add(v);
        if (seen.size > most) return null;
      }
  }
  return [...seen];
}
