// SPDX-License-Identifier: MIT
// Responds to mouse, pen, fingers and wheel. One finger is left to the browser, which scrolls the
// page; two fingers move and zoom the mesh.

// Distance, in pixels, below which a gesture with one pointer is a tap.
const tapOf = (kind) => (kind === "touch" ? 10 : 4);

function middleAndSpread(held) {
  const [a, b = a] = held.values();
  return { x: (a.x + b.x) / 2, y: (a.y + b.y) / 2, spread: Math.hypot(a.x - b.x, a.y - b.y) };
}

// Moves and zooms the camera so that the points of the mesh under the pointers follow them.
function follow(camera, before, now) {
  if (before.spread > 0 && now.spread > 0) camera.zoom(now.spread / before.spread, before.x, before.y);
  camera.move(now.x - before.x, now.y - before.y);
}

function addPointers(stage, canvas, actions) {
  const held = new Map();
  let moved = 0, most = 0;
  const at = (event) => {
    const { left, top } = element("stage").getBoundingClientRect();
    return { x: event.clientX - left, y: event.clientY - top };
  };
  canvas.addEventListener("pointerdown", (event) => {
    if (held.size === 0) moved = most = 0;
    held.set(event.pointerId, at(event));
    most = Math.max(most, held.size);
    if (event.pointerType !== "touch") canvas.setPointerCapture(event.pointerId);
    actions.hover(null);
  });
  canvas.addEventListener("pointermove", (event) => {
    const last = held.get(event.pointerId), now = at(event);
    if (last === undefined) return event.pointerType === "touch" ? undefined : actions.hover(now);
    const before = middleAndSpread(held);
    moved += Math.abs(now.x - last.x) + Math.abs(now.y - last.y);
    held.set(event.pointerId, now);
    if (held.size > 2 || (event.pointerType === "touch" && held.size < 2)) return undefined;
    follow(stage.camera, before, middleAndSpread(held));
    return stage.moved();
  });
  const release = (event) => held.delete(event.pointerId);
  canvas.addEventListener("pointerup", (event) => {
    const { x, y } = at(event);
    if (release(event) && most === 1 && moved < tapOf(event.pointerType)) actions.chooseAt(x, y);
  });
  canvas.addEventListener("pointercancel", release);
  canvas.addEventListener("pointerleave", (event) => { if (event.pointerType === "touch") release(event); actions.hover(null); });
  // Keeps the browser from scrolling or zooming the page by two fingers.
  for (const kind of ["touchstart", "touchmove"])
    canvas.addEventListener(kind, (event) => { if (event.touches.length > 1 && event.cancelable) event.preventDefault(); }, { passive: false });
  canvas.addEventListener("wheel", (event) => {
    event.preventDefault();
    const { x, y } = at(event), pixels = event.deltaY * (event.deltaMode === 1 ? 33 : 1);
    // Browsers report a pinch on a touchpad as a wheel with the control key, in smaller steps.
    stage.camera.zoom(Math.exp(-pixels / (event.ctrlKey ? 100 : 400)), x, y);
    stage.moved();
  }, { passive: false });
}
