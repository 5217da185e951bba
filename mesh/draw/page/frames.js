// SPDX-License-Identifier: MIT
// Shows several meshes on one page, the page's own last: before and after a change, or the rounds
// of a loop.

const mostButtons = 3;  // meshes that have a button each; more have a slider
const framesASecond = 2;

function fieldsOf(told, arrays) {
  return (told ?? []).map(({ name, components, array }) => ({ name, components, values: arrays[array] }));
}

// Returns a frame for each mesh: its arrays, label and facts. All have one box, so that a place in
// the picture is the same in each.
function framesOf(facts, arrays, claim) {
  const part = (prefix, told) => {
    const named = (name) => arrays[prefix + name];
    return {
      positions: named("positions"), metrics: named("metrics"), triangles: named("triangles"), regions: named("regions"),
      boundary: named("boundary"), markers: named("markers"), inside: named("inside"), distances: named("distances"),
      notOfStars: named("not_of_stars"), fields: fieldsOf(told.fields, arrays), vertices: told.vertices, given: told.given,
      agreeing: told.triangles, count: told.triangles + told.disagreeing, scratch: new Float64Array(6), repairs: [],
    };
  };
  const all = (facts.frames ?? []).map((told, i) => ({ label: told.label, facts: told, claim: null, mesh: part(`frame${i}.`, told) }));
  const own = facts.is_of_this_mesh ? claim : null;
  all.push({ label: facts.label, facts, claim: own, mesh: part("", facts) });
  const boxes = all.map(({ mesh }) => boxOf(mesh.positions));
  const box = { x0: Math.min(...boxes.map((b) => b.x0)), y0: Math.min(...boxes.map((b) => b.y0)),
                x1: Math.max(...boxes.map((b) => b.x1)), y1: Math.max(...boxes.map((b) => b.y1)) };
  for (const { mesh } of all) Object.assign(mesh, { box, repairs: repairsOf(own, mesh) });
  return all;
}

// Adds buttons for a few meshes, or for more a slider that can play them in turn. Calls `show` with
// the number of a mesh, from 0.
function makeFrameControl(frames, show) {
  const holder = element("frames"), last = frames.length - 1;
  let at = last, playing = 0;
  const control = { tell: () => {}, step: () => {}, get shown() { return at; } };
  if (last === 0) return control;
  holder.hidden = element("frame-keys").hidden = element("s-compared").hidden = false;
  const go = (i) => {
    at = (i + frames.length) % frames.length;
    show(at);
    control.tell();
  };
  control.go = go;
  control.step = (by) => go(at + by);
  if (frames.length <= mostButtons) {
    const buttons = frames.map(({ label }, i) => {
      const button = make("button", { type: "button" }, label);
      button.addEventListener("click", () => go(i));
      return button;
    });
    holder.append(...buttons);
    control.tell = () => buttons.forEach((button, i) => button.setAttribute("aria-pressed", String(i === at)));
  } else {
    const slider = make("input", { type: "range", id: "frame", min: 1, max: frames.length, step: 1, "aria-label": "Which mesh" });
    const name = make("output", { id: "framed", for: "frame" }), play = make("button", { type: "button", id: "play" }, "Play");
    const stop = () => { clearInterval(playing); playing = 0; play.textContent = "Play"; };
    slider.addEventListener("input", () => { stop(); go(Number(slider.value) - 1); });
    play.addEventListener("click", () => {
      if (playing) return stop();
      if (at === last) go(0);
      play.textContent = "Stop";
      playing = setInterval(() => { if (at === last) stop(); else go(at + 1); }, 1000 / framesASecond);
      return undefined;
    });
    holder.append(play, slider, name);
    control.tell = () => { slider.value = at + 1; name.textContent = frames[at].label; };
  }
  control.tell();
  return control;
}

// Shows a table with a line for each mesh: counts, and angles if the mesh has been measured.
function showCompared(frames, bound, go) {
  if (frames.length === 1) return;
  const rows = frames.map(({ label, mesh }, i) => {
    const name = make("button", { type: "button" }, label);
    name.addEventListener("click", () => go(i));
    const { angles } = mesh, low = angles && bound !== null ? angles.least.reduce((n, x) => n + (x < bound), 0) : null;
    const least = !angles ? "" : mesh.count === 0 ? "none" : `${angleText(angles.worst.degrees, 2)}°`;
    return [name, { text: count(mesh.vertices), kind: "n" }, { text: count(mesh.count), kind: "n" }, { text: least, kind: low ? "n low" : "n" },
            { text: low === null ? "" : count(low), kind: low ? "n low" : "n" }];
  });
  const heads = ["", "Vertices", "Triangles", "Least angle", "Below"].map((text, i) => (i === 0 ? "" : { text, kind: "n" }));
  element("compared").replaceChildren(table(heads, rows, "The meshes of this page"),
    make("p", { class: "soft" }, "Angles as each mesh's own metric measures them, by this page, and triangles with one below the bound. The verdict is about the last alone."));
}
