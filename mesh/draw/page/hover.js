// SPDX-License-Identifier: MIT
// Shows the triangle under the mouse, and a bar for the scale of the picture.

function hoverText(mesh, t, bound, point) {
  const nine = nineAngles(mesh, t), least = Math.min(...nine), greatest = Math.max(...nine);
  return [`Triangle ${count(t + 1)}`,
          `angles ${angleText(least)}° to ${greatest.toFixed(2)}°${bound !== null && least < bound ? ", below the bound" : ""}`,
          `length over width ${short(triangleAspect(mesh, t))}`,
          ...shownFields(mesh).slice(0, 4).map(({ name, values }) => `${name} ${short(valueAt(mesh, values, t, point))}`)];
}

// Makes a function that shows a box beside the mouse, at most once a frame.
function makeHover(stage, bound) {
  const box = element("hover");
  let place = null, waiting = false;
  const show = () => {
    waiting = false;
    const point = place && stage.camera.toMesh(place.x, place.y);
    const { mesh } = stage, t = place === null ? -1 : triangleAt(mesh, stage.places, point.x, point.y);
    box.hidden = t < 0;
    if (t < 0) return;
    box.replaceChildren(...[...hoverText(mesh, t, bound, point), `at ${point.x.toPrecision(5)}, ${point.y.toPrecision(5)}`]
      .map((line, i) => make(i === 0 ? "strong" : "span", {}, line)));
    const right = place.x > stage.camera.width / 2, low = place.y > stage.camera.height / 2;
    box.style.left = right ? "" : `${place.x + 14}px`;
    box.style.right = right ? `${stage.camera.width - place.x + 14}px` : "";
    box.style.top = low ? "" : `${place.y + 14}px`;
    box.style.bottom = low ? `${stage.camera.height - place.y + 14}px` : "";
  };
  return (at) => {
    place = at;
    if (!waiting) requestAnimationFrame(show);
    waiting = true;
  };
}

// Returns the greatest number of the form 1, 2 or 5 times a power of ten that is at most x.
function roundBelow(x) {
  const power = 10 ** Math.floor(Math.log10(x));
  return [5, 2, 1].find((n) => n * power <= x * (1 + 1e-12)) * power;
}

function showScale(camera) {
  const length = roundBelow(Math.min(140, camera.width / 3) / camera.scale), bar = element("scale");
  bar.style.width = `${length * camera.scale}px`;
  bar.textContent = short(length);
}
