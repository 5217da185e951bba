// SPDX-License-Identifier: MIT
// Draws above the mesh: the chosen triangle, marked places, unit circles of the metric.

const mostEllipses = 2000;  // vertices in sight beyond which none has its circle drawn

// Colours of marks, which contrast with all colours of triangles on dark and on light pages.
const markInk = "#111111", markHalo = "#ffffff", markEllipse = "#8a0057", markPlace = "#c00020";

function strokeWithHalo(context, ink, width) {
  context.lineJoin = "round";
  context.strokeStyle = markHalo;
  context.lineWidth = width + 2.5;
  context.stroke();
  context.strokeStyle = ink;
  context.lineWidth = width;
  context.stroke();
}

// Chooses vertices at least `distance` pixels apart, those of lower number first.
function verticesApart(vertices, camera, mesh, distance) {
  const chosen = [], squares = new Map(), square = (x) => Math.floor(x / distance);
  for (const v of vertices.sort((a, b) => a - b)) {
    const at = camera.toPage(mesh.positions[2 * v], mesh.positions[2 * v + 1]), column = square(at.x), row = square(at.y);
    let free = true;
    for (let i = column - 1; i <= column + 1; ++i)
      for (let j = row - 1; j <= row + 1; ++j)
        for (const q of squares.get(`${i} ${j}`) ?? []) free &&= Math.hypot(q.x - at.x, q.y - at.y) >= distance;
    if (!free) continue;
    const key = `${column} ${row}`;
    squares.set(key, [...(squares.get(key) ?? []), at]);
    chosen.push({ v, at, circle: unitCircle(mesh.metrics, v) });
  }
  return chosen.filter(({ circle }) => Number.isFinite(circle.longest));
}

// Returns the distance, in pixels, of the two nearest of the chosen vertices.
function leastGap(chosen) {
  let least = Infinity;
  chosen.forEach(({ at }, i) => {
    for (let j = 0; j < i; ++j) least = Math.min(least, Math.hypot(at.x - chosen[j].at.x, at.y - chosen[j].at.y));
  });
  return least;
}

// Draws unit circles of vertices in sight, all to one scale, in which the longest does not reach
// its neighbours, as in pictures (-o NAME.png). The scale is 1, 2 or 5 times a power of ten, so it
// seldom changes while the view moves. Returns the number of circles, their scale, and in pixels
// the longest semi-axis and the gap between neighbours.
function drawEllipses(context, camera, mesh, places) {
  const vertices = verticesIn(mesh, places, camera.sight(), mostEllipses), none = { number: 0, scale: 0, longest: 0, gap: 0 };
  if (vertices === null) return { ...none, tooMany: true };
  const distance = Math.max(24, camera.width / 18), chosen = verticesApart(vertices, camera, mesh, distance);
  const longest = Math.max(...chosen.map(({ circle }) => circle.longest));
  if (!(longest > 0)) return none;
  const gap = Math.min(Math.max(distance, leastGap(chosen)), camera.width / 4);
  const scale = roundBelow(0.6 * gap / longest / camera.scale);
  for (const { at, circle } of chosen) {
    context.beginPath();
    context.ellipse(at.x, at.y, circle.longest * scale * camera.scale, Math.max(circle.shortest * scale * camera.scale, 0.4),
                    -circle.angle, 0, 2 * Math.PI);
    strokeWithHalo(context, markEllipse, 1.5);
  }
  return { number: chosen.length, scale, longest: longest * scale * camera.scale, gap };
}

function drawChosen(context, camera, mesh, t) {
  context.beginPath();
  for (let i = 0; i < 3; ++i) {
    const v = mesh.triangles[3 * t + i], at = camera.toPage(mesh.positions[2 * v], mesh.positions[2 * v + 1]);
    context.lineTo(at.x, at.y);
  }
  context.closePath();
  strokeWithHalo(context, markInk, 3);
  context.font = "bold 13px system-ui, sans-serif";
  context.fillStyle = markInk;
  context.strokeStyle = markHalo;
  for (let i = 0; i < 3; ++i) {
    const v = mesh.triangles[3 * t + i], at = camera.toPage(mesh.positions[2 * v], mesh.positions[2 * v + 1]);
    context.strokeText(String(v + 1), at.x + 5, at.y - 5);
    context.fillText(String(v + 1), at.x + 5, at.y - 5);
  }
}

function drawCorners(context, camera, mesh, vertices, colour) {
  drawPoints(context, camera, vertices.map((v) => ({ x: mesh.positions[2 * v], y: mesh.positions[2 * v + 1] })), colour);
}

function drawPoints(context, camera, points, colour) {
  for (const { x, y } of points) {
    const at = camera.toPage(x, y);
    context.beginPath();
    context.arc(at.x, at.y, 7, 0, 2 * Math.PI);
    strokeWithHalo(context, colour, 2);
  }
}

// Draws rings around triangles that are too small to see.
function drawRings(context, camera, mesh, triangles) {
  const least = 10;
  for (const t of triangles) {
    const corners = [0, 1, 2].map((i) => 2 * mesh.triangles[3 * t + i]).map((v) => camera.toPage(mesh.positions[v], mesh.positions[v + 1]));
    const x = (corners[0].x + corners[1].x + corners[2].x) / 3, y = (corners[0].y + corners[1].y + corners[2].y) / 3;
    if (Math.max(...corners.map((at) => Math.hypot(at.x - x, at.y - y))) > least) continue;
    context.beginPath();
    context.arc(x, y, least, 0, 2 * Math.PI);
    strokeWithHalo(context, markPlace, 2);
  }
}
