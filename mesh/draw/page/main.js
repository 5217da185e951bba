// SPDX-License-Identifier: MIT
// Puts the page together and answers mouse, fingers and keys.

function readMesh(facts, arrays) {
  const mesh = {
    ...arrays, notOfStars: arrays.not_of_stars, vertices: facts.vertices,
    agreeing: facts.triangles, count: facts.triangles + facts.disagreeing,
    box: boxOf(arrays.positions), scratch: new Float64Array(6),
  };
  mesh.angles = measureAngles(mesh);
  return mesh;
}

function makeView(canvas, mesh, places) {
  const gl = canvas.getContext("webgl2", { antialias: false, alpha: false, preserveDrawingBuffer: true });
  return gl ? makeCardView(gl, mesh, places) : makePlainView(canvas.getContext("2d"), mesh, places);
}

function colourOf(name) {
  return getComputedStyle(document.documentElement).getPropertyValue(name);
}

const longestFrame = 1 / 40;  // seconds

// The picture, redrawn once a frame at most and only when something changed.
function makeStage(mesh, claim) {
  const canvas = element("canvas"), overlay = element("overlay"), context = overlay.getContext("2d");
  const places = makeChunks(mesh), view = makeView(canvas, mesh, places), camera = makeCamera(mesh, element("stage"));
  const stage = { camera, places, view, chosen: null, ellipses: 0, waiting: false, seconds: 0 };
  let painted = null, settled = 0;
  const corners = (claim?.audit.exempt_corners ?? []).map((n) => n - 1).filter((v) => v < mesh.vertices);
  const paintMesh = () => view.paint(camera, {
    edges: element("edges").checked, edge: numbersOfColour(colourOf("--edge")),
    paper: numbersOfColour(colourOf("--card")), ink: numbersOfColour(colourOf("--ink")),
  });
  const paintMarks = () => {
    context.setTransform(camera.ratio, 0, 0, camera.ratio, 0, 0);
    context.clearRect(0, 0, camera.width, camera.height);
    stage.ellipses = element("ellipses").checked ? drawEllipses(context, camera, mesh, places) : 0;
    drawCorners(context, camera, mesh, corners, markPlace);
    drawCorners(context, camera, mesh, mesh.repairs.map(({ vertex }) => vertex), markPlace);
    if (stage.chosen?.triangle !== undefined) drawChosen(context, camera, mesh, stage.chosen.triangle);
    if (stage.chosen?.vertex !== undefined) drawCorners(context, camera, mesh, [stage.chosen.vertex], markInk);
  };
  // A whole picture, and how long it takes.
  stage.paint = () => {
    const before = performance.now();
    paintMesh();
    view.finish();
    stage.seconds = (performance.now() - before) / 1000;
    painted = { x: camera.x, y: camera.y, scale: camera.scale };
    canvas.style.transform = "";
    paintMarks();
  };
  // While the view moves: where a picture takes longer than a frame, the last one is moved and
  // stretched instead, and a new one made as soon as the view rests.
  stage.move = () => {
    if (stage.seconds < longestFrame) return stage.paint();
    const corner = camera.toPage(painted.x - camera.width / 2 / painted.scale, painted.y + camera.height / 2 / painted.scale);
    canvas.style.transform = `translate(${corner.x}px,${corner.y}px) scale(${camera.scale / painted.scale})`;
    paintMarks();
    clearTimeout(settled);
    settled = setTimeout(stage.paint, 150);
    return undefined;
  };
  const soon = (act) => () => {
    if (stage.waiting) return;
    stage.waiting = true;
    requestAnimationFrame(() => { stage.waiting = false; act(); });
  };
  stage.changed = soon(stage.paint);
  stage.moved = soon(stage.move);
  stage.resize = () => {
    camera.measure();
    for (const one of [canvas, overlay]) {
      one.width = Math.round(camera.width * camera.ratio);
      one.height = Math.round(camera.height * camera.ratio);
    }
    stage.changed();
  };
  return stage;
}

function addPointer(stage, canvas, chooseAt) {
  let held = null, moved = 0;
  canvas.addEventListener("pointerdown", (event) => {
    held = { x: event.clientX, y: event.clientY };
    moved = 0;
    canvas.setPointerCapture(event.pointerId);
  });
  canvas.addEventListener("pointermove", (event) => {
    if (held === null) return;
    const x = event.clientX - held.x, y = event.clientY - held.y;
    moved += Math.abs(x) + Math.abs(y);
    held = { x: event.clientX, y: event.clientY };
    stage.camera.move(x, y);
    stage.moved();
  });
  canvas.addEventListener("pointerup", (event) => {
    const { left, top } = element("stage").getBoundingClientRect();
    if (held !== null && moved < 4) chooseAt(event.clientX - left, event.clientY - top);
    held = null;
  });
  canvas.addEventListener("pointercancel", () => { held = null; });
  canvas.addEventListener("wheel", (event) => {
    event.preventDefault();
    const { left, top } = element("stage").getBoundingClientRect();
    stage.camera.zoom(Math.exp(-event.deltaY / 400), event.clientX - left, event.clientY - top);
    stage.moved();
  }, { passive: false });
}

function addKeys(stage, canvas, actions) {
  const step = 60, { camera } = stage;
  const keys = {
    ArrowLeft: () => camera.move(step, 0), ArrowRight: () => camera.move(-step, 0),
    ArrowUp: () => camera.move(0, step), ArrowDown: () => camera.move(0, -step),
    "+": () => camera.zoom(1.5), "=": () => camera.zoom(1.5), "-": () => camera.zoom(1 / 1.5), 0: () => camera.fit(),
    Enter: () => actions.chooseAt(camera.width / 2, camera.height / 2), Escape: () => actions.choose(null),
    n: () => actions.next(1), p: () => actions.next(-1),
  };
  canvas.addEventListener("keydown", (event) => {
    const act = keys[event.key] ?? keys[event.key.toLowerCase()];
    if (!act || event.ctrlKey || event.altKey || event.metaKey) return;
    event.preventDefault();
    act();
    stage.moved();
  });
}

// Box of a triangle, or around a vertex of the triangles at it.
function boxOfItem(mesh, item) {
  const around = item.triangle !== undefined ? [item.triangle] : trianglesAt(mesh, item.vertex);
  return around.length > 0 ? boxOfTriangles(mesh, around, 0, around.length)
    : boxOf(mesh.positions.subarray(2 * item.vertex, 2 * item.vertex + 2));
}

function trianglesAt(mesh, v) {
  const found = [];
  for (let k = 0; k < 3 * mesh.count; ++k) if (mesh.triangles[k] === v) found.push(Math.floor(k / 3));
  return found;
}

function itemOfAddress(mesh) {
  const [, kind, number] = /^#(triangle|vertex)=(\d+)$/.exec(location.hash) ?? [];
  const index = Number(number) - 1, most = kind === "triangle" ? mesh.count : mesh.vertices;
  return kind && index >= 0 && index < most ? { [kind]: index } : null;
}

function makeActions(stage, mesh, told) {
  const { facts, claim, bound } = told;
  let all = [], at = -1;
  const actions = {
    lists: (lists) => { all = lists.flatMap(({ items }) => items).filter((i) => i.triangle !== undefined || i.vertex !== undefined); },
    choose(item) {
      const there = item !== null && (item.triangle < mesh.count || item.vertex < mesh.vertices);
      stage.chosen = there ? item : null;
      showChosen(facts, claim, mesh, bound, stage.chosen);
      stage.changed();
    },
    go(item) {
      actions.choose(item);
      if (stage.chosen !== null) stage.camera.show(boxOfItem(mesh, item));
      stage.changed();
    },
    chooseAt(x, y) {
      const point = stage.camera.toMesh(x, y), t = triangleAt(mesh, stage.places, point.x, point.y);
      actions.choose(t < 0 ? null : { triangle: t });
    },
    next(step) {
      if (all.length === 0) return;
      at = at < 0 ? (step > 0 ? 0 : all.length - 1) : (at + step + all.length) % all.length;
      actions.go(all[at]);
    },
  };
  return actions;
}

function addModes(stage, mesh, bound) {
  const modes = makeModes(mesh, bound), choice = element("mode");
  modes.forEach((mode, i) => choice.append(make("option", { value: i }, typeof mode === "function" ? mode.label : mode.name)));
  const show = () => {
    const i = Number(choice.value);
    if (typeof modes[i] === "function") modes[i] = modes[i]();
    stage.view.setMode(modes[i]);
    showLegend(modes[i]);
    stage.changed();
  };
  choice.addEventListener("change", show);
  show();
}

function addControls(stage, mesh, actions) {
  const { camera } = stage;
  const on = (id, act) => element(id).addEventListener("click", () => { act(); stage.changed(); });
  on("nearer", () => camera.zoom(1.5));
  on("farther", () => camera.zoom(1 / 1.5));
  on("whole", () => camera.fit());
  for (const id of ["edges", "ellipses"]) element(id).addEventListener("change", stage.changed);
  element("find").addEventListener("submit", () => {
    const t = Number(element("number").value) - 1;
    if (t >= 0 && t < mesh.count) actions.go({ triangle: t });
  });
  on("theme", () => {
    const root = document.documentElement, dark = matchMedia("(prefers-color-scheme: dark)").matches;
    root.dataset.theme = (root.dataset.theme ?? (dark ? "dark" : "light")) === "dark" ? "light" : "dark";
  });
  matchMedia("(prefers-color-scheme: dark)").addEventListener("change", stage.changed);
  new ResizeObserver(stage.resize).observe(element("stage"));
  addEventListener("hashchange", () => { const item = itemOfAddress(mesh); if (item) actions.go(item); });
}

async function start() {
  const facts = readJson("facts"), claim = readJson("certificate");
  const bound = claim?.asked.angle_bound ?? null;
  showVerdict(facts, claim);
  const mesh = readMesh(facts, await readArrays(facts));
  mesh.repairs = repairsOf(facts.is_of_this_mesh ? claim : null, mesh);
  const stage = makeStage(mesh, facts.is_of_this_mesh ? claim : null);
  const actions = makeActions(stage, mesh, { facts, claim, bound });
  element("canvas").setAttribute("aria-label", `The mesh: ${plural(mesh.vertices, "vertex", "vertices")}, ${plural(mesh.count, "triangle")}.`);
  element("number").max = mesh.count;
  addModes(stage, mesh, bound);
  stage.resize();
  stage.camera.fit();
  stage.paint();  // the first one makes the shaders ready
  stage.paint();
  addPointer(stage, element("canvas"), actions.chooseAt);
  addKeys(stage, element("canvas"), actions);
  addControls(stage, mesh, actions);
  showAsked(facts, claim, mesh);
  showAngles(mesh, bound);
  const lists = listsOf(facts, claim, mesh);
  actions.lists(lists);
  showLists(lists, actions.go);
  showAgain(facts, claim);
  const item = itemOfAddress(mesh);
  if (item) actions.go(item);
  mesh.lengths = measureLengths(mesh);
  showLengths(mesh);
  window.asterism = { facts, claim, mesh, stage, actions };  // for whoever drives the page
  document.documentElement.dataset.state = "ready";
}

start().catch((failure) => {
  element("badge").textContent = "This page could not be read";
  element("badge").className = "bad";
  element("why").textContent = String(failure?.message ?? failure);
  document.documentElement.dataset.state = "failed";
});
