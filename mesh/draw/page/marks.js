// SPDX-License-Identifier: MIT
// What is drawn above the mesh: the chosen triangle, places, ellipses.

const mostEllipses = 400;

// Colours that are seen on all those of the mesh, whether the page is dark or light.
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

// The unit circle of each vertex at a quarter of its size, so that those of neighbours stay apart: an
// edge of length 1 crosses both for a quarter of its way.
function drawEllipses(context, camera, mesh, places) {
  const vertices = verticesIn(mesh, places, camera.sight(), mostEllipses);
  if (vertices === null) return 0;
  context.strokeStyle = markEllipse;
  context.lineWidth = 1.5;
  for (const v of vertices) {
    const circle = unitCircle(mesh.metrics, v), at = camera.toPage(mesh.positions[2 * v], mesh.positions[2 * v + 1]);
    const long = circle.longest * camera.scale / 4, flat = circle.shortest * camera.scale / 4;
    if (!Number.isFinite(long) || long > 1e6) continue;
    context.beginPath();
    context.ellipse(at.x, at.y, long, Math.max(flat, 0.3), -circle.angle, 0, 2 * Math.PI);
    context.stroke();
  }
  return vertices.length;
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
  for (const v of vertices) {
    const at = camera.toPage(mesh.positions[2 * v], mesh.positions[2 * v + 1]);
    context.beginPath();
    context.arc(at.x, at.y, 7, 0, 2 * Math.PI);
    strokeWithHalo(context, colour, 2);
  }
}
