// SPDX-License-Identifier: MIT
// Holds how the surface is rotated, moved and scaled, and changes that by pointers and keys.

// Rows of a rotation matrix. The first view is from above and aside, z up.
const firstTurn = () => turned(turned([1, 0, 0, 0, 1, 0, 0, 0, 1], 2, -0.6), 0, -1.05);

// Returns the matrix m, rotated by an angle about an axis of the screen: 0 across, 1 up, 2 towards
// the eye.
function turned(m, axis, angle) {
  const c = Math.cos(angle), s = Math.sin(angle), i = (axis + 1) % 3, k = (axis + 2) % 3, to = m.slice();
  for (let n = 0; n < 3; ++n) {
    to[3 * i + n] = c * m[3 * i + n] - s * m[3 * k + n];
    to[3 * k + n] = s * m[3 * i + n] + c * m[3 * k + n];
  }
  return to;
}

function makeTurning() {
  const turning = {
    turn: firstTurn(), zoom: 1.3, x: 0, y: 0,
    rotate(dx, dy) { turning.turn = turned(turned(turning.turn, 1, dx * 0.008), 0, dy * 0.008); },
    move(dx, dy, size) { turning.x += 2 * dx / size; turning.y -= 2 * dy / size; },
    enlarge(by) { turning.zoom = Math.min(1000, Math.max(0.2, turning.zoom * by)); },
    reset() { Object.assign(turning, { turn: firstTurn(), zoom: 1.3, x: 0, y: 0 }); },
  };
  return turning;
}

const middleOf = (places) => ({
  x: places.reduce((sum, p) => sum + p.x, 0) / places.length,
  y: places.reduce((sum, p) => sum + p.y, 0) / places.length,
});
const spreadOf = (places) => places.length < 2 ? 0 : Math.hypot(places[0].x - places[1].x, places[0].y - places[1].y);

function addPointers(canvas, turning, changed) {
  const down = new Map();
  const here = (event) => ({ x: event.clientX, y: event.clientY });
  canvas.addEventListener("pointerdown", (event) => {
    down.set(event.pointerId, here(event));
    canvas.setPointerCapture(event.pointerId);
    canvas.focus({ preventScroll: true });
  });
  canvas.addEventListener("pointermove", (event) => {
    if (!down.has(event.pointerId)) return;
    const before = [...down.values()];
    down.set(event.pointerId, here(event));
    const after = [...down.values()], from = middleOf(before), to = middleOf(after);
    if (after.length === 1 && !event.shiftKey) turning.rotate(to.x - from.x, to.y - from.y);
    else turning.move(to.x - from.x, to.y - from.y, Math.min(canvas.clientWidth, canvas.clientHeight));
    if (spreadOf(before) > 0) turning.enlarge(spreadOf(after) / spreadOf(before));
    changed();
  });
  for (const name of ["pointerup", "pointercancel"])
    canvas.addEventListener(name, (event) => down.delete(event.pointerId));
  canvas.addEventListener("wheel", (event) => {
    event.preventDefault();
    turning.enlarge(Math.exp(-event.deltaY * (event.deltaMode === 1 ? 0.05 : 0.0015)));
    changed();
  }, { passive: false });
}

function addKeys(canvas, turning, changed, toggle) {
  const step = 12;
  const keys = {
    ArrowLeft: () => turning.rotate(-step, 0), ArrowRight: () => turning.rotate(step, 0),
    ArrowUp: () => turning.rotate(0, -step), ArrowDown: () => turning.rotate(0, step),
    "+": () => turning.enlarge(1.25), "=": () => turning.enlarge(1.25), "-": () => turning.enlarge(0.8),
    0: () => turning.reset(), t: toggle, T: toggle,
  };
  canvas.addEventListener("keydown", (event) => {
    const act = keys[event.key];
    if (!act || event.ctrlKey || event.altKey || event.metaKey) return;
    event.preventDefault();
    act();
    changed();
  });
}
