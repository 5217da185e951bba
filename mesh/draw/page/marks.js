// SPDX-License-Identifier: MIT
// The camera, and what is drawn above the mesh: the chosen triangle, places, ellipses.

// Makes what the page looks at: the middle in the mesh's coordinates, and pixels of the page a unit.
function makeCamera(mesh, holder) {
  const { box } = mesh;
  const clamp = (x, low, high) => Math.max(low, Math.min(high, x));
  const camera = {
    x: 0, y: 0, scale: 1, width: 1, height: 1, ratio: 1,
    fit() {
      camera.x = (box.x0 + box.x1) / 2;
      camera.y = (box.y0 + box.y1) / 2;
      camera.scale = 0.94 * Math.min(camera.width / (box.x1 - box.x0), camera.height / (box.y1 - box.y0));
    },
    measure() {
      const { width, height } = holder.getBoundingClientRect();
      camera.ratio = window.devicePixelRatio || 1;
      camera.width = Math.max(1, width);
      camera.height = Math.max(1, height);
    },
    toPage: (x, y) => ({ x: (x - camera.x) * camera.scale + camera.width / 2, y: camera.height / 2 - (y - camera.y) * camera.scale }),
    toMesh: (x, y) => ({ x: camera.x + (x - camera.width / 2) / camera.scale, y: camera.y - (y - camera.height / 2) / camera.scale }),
    sight() {
      const w = camera.width / camera.scale / 2, h = camera.height / camera.scale / 2;
      return { x0: camera.x - w, x1: camera.x + w, y0: camera.y - h, y1: camera.y + h };
    },
    keep() {
      const whole = Math.min(camera.width / (box.x1 - box.x0), camera.height / (box.y1 - box.y0));
      const finest = fixedRange / 8 / Math.max(box.x1 - box.x0, box.y1 - box.y0);
      camera.scale = clamp(camera.scale, whole / 4, finest);
      camera.x = clamp(camera.x, box.x0, box.x1);
      camera.y = clamp(camera.y, box.y0, box.y1);
    },
    zoom(factor, x = camera.width / 2, y = camera.height / 2) {
      const held = camera.toMesh(x, y);
      camera.scale *= factor;
      const now = camera.toMesh(x, y);
      camera.x += held.x - now.x;
      camera.y += held.y - now.y;
      camera.keep();
    },
    move(x, y) {
      camera.x -= x / camera.scale;
      camera.y += y / camera.scale;
      camera.keep();
    },
    // Looks at a box with room around it.
    show(target) {
      const room = 8, least = Math.max(box.x1 - box.x0, box.y1 - box.y0) * 1e-9;
      const w = Math.max(least, target.x1 - target.x0), h = Math.max(least, target.y1 - target.y0);
      camera.x = (target.x0 + target.x1) / 2;
      camera.y = (target.y0 + target.y1) / 2;
      camera.scale = Math.min(camera.width / w, camera.height / h) / room;
      camera.keep();
    },
  };
  return camera;
}

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
