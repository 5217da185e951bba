// SPDX-License-Identifier: MIT
// Puts the page together and answers keys and buttons.

// Largest number of triangles of all meshes together for which all are measured at the start, so
// that they can be compared.
const measuredAtOnce = 500000;

function addKeys(stage, canvas, actions) {
  const step = 60, { camera } = stage;
  const keys = {
    ArrowLeft: () => camera.move(step, 0), ArrowRight: () => camera.move(-step, 0),
    ArrowUp: () => camera.move(0, step), ArrowDown: () => camera.move(0, -step),
    "+": () => camera.zoom(1.5), "=": () => camera.zoom(1.5), "-": () => camera.zoom(1 / 1.5), 0: () => camera.fit(),
    Enter: () => actions.chooseAt(camera.width / 2, camera.height / 2), Escape: () => actions.choose(null),
    n: () => actions.next(1), p: () => actions.next(-1),
    ",": () => actions.frames.step(-1), ".": () => actions.frames.step(1),
  };
  canvas.addEventListener("keydown", (event) => {
    const act = keys[event.key] ?? keys[event.key.toLowerCase()];
    if (!act || event.ctrlKey || event.altKey || event.metaKey) return;
    event.preventDefault();
    act();
    stage.moved();
  });
}

// Returns the box of a triangle, or of the triangles around a vertex.
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

function makeActions(stage, frames, bound) {
  let all = [], at = -1;
  const frame = () => frames.find(({ mesh }) => mesh === stage.mesh);
  const actions = {
    hover: makeHover(stage, bound),
    lists: (lists) => { all = lists.flatMap(({ items }) => items).filter((i) => i.triangle !== undefined || i.vertex !== undefined); },
    choose(item) {
      const { facts, claim, mesh } = frame();
      const there = item !== null && (item.triangle < mesh.count || item.vertex < mesh.vertices);
      stage.chosen = there ? item : null;
      showChosen(facts, claim, mesh, bound, stage.chosen);
      stage.marked();
    },
    go(item) {
      actions.choose(item);
      if (stage.chosen !== null) stage.camera.show(boxOfItem(stage.mesh, item));
      stage.moved();
    },
    chooseAt(x, y) {
      const point = stage.camera.toMesh(x, y), t = triangleAt(stage.mesh, stage.places, point.x, point.y);
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

// Makes the choice of colours. The name chosen stays when another mesh is shown that has a mode of
// that name.
function makeColouring(stage, frames, bound) {
  const choice = element("mode"), meshes = frames.map(({ mesh }) => mesh), nameOf = (mode) => (typeof mode === "function" ? mode.label : mode.name);
  let modes = [], wanted = null;
  const use = (changed) => {
    const i = Number(choice.value);
    if (typeof modes[i] === "function") modes[i] = modes[i]();
    stage.mode = modes[i];
    stage.view.setMode(modes[i]);
    showLegend(modes[i]);
    changed();
  };
  choice.addEventListener("change", () => {
    wanted = nameOf(modes[Number(choice.value)]);
    stage.pictures.outdate();
    use(stage.changed);
    for (const { scene } of frames) if (scene !== undefined) scene.colouredBy = scene === stage.scene ? wanted : null;
  });
  return (frame, changed) => {
    frame.modes ??= makeModes(frame.mesh, bound, frame.claim, meshes);
    modes = frame.modes;
    choice.replaceChildren(...modes.map((mode, i) => make("option", { value: i }, nameOf(mode))));
    const same = modes.findIndex((mode) => nameOf(mode) === wanted), value = same < 0 ? modes.first : same;
    choice.value = value;
    wanted ??= nameOf(modes[value]);  // the page's own mesh comes first
    if (frame.scene.colouredBy === nameOf(modes[value])) {
      stage.mode = modes[value];
      showLegend(modes[value]);
      return;
    }
    frame.scene.pictures.outdate();
    use(changed);
    frame.scene.colouredBy = nameOf(modes[value]);
  };
}

function addControls(stage, actions) {
  const { camera } = stage;
  const on = (id, act, then = stage.moved) => element(id).addEventListener("click", () => { act(); then(); });
  on("nearer", () => camera.zoom(1.5));
  on("farther", () => camera.zoom(1 / 1.5));
  on("whole", () => camera.fit());
  element("edges").addEventListener("change", stage.changed);
  element("ellipses").addEventListener("change", stage.marked);
  element("find").addEventListener("submit", () => {
    const t = Number(element("number").value) - 1;
    if (t >= 0 && t < stage.mesh.count) actions.go({ triangle: t });
  });
  const system = matchMedia("(prefers-color-scheme: dark)"), root = document.documentElement;
  const other = () => ((root.dataset.theme ?? (system.matches ? "dark" : "light")) === "dark" ? "light" : "dark");
  const name = () => { element("theme").textContent = other() === "dark" ? "Dark" : "Light"; };
  on("theme", () => { root.dataset.theme = other(); name(); }, stage.changed);
  system.addEventListener("change", () => { name(); stage.changed(); });
  name();
  new ResizeObserver(stage.resize).observe(element("stage"));
  addEventListener("hashchange", () => { const item = itemOfAddress(stage.mesh); if (item) actions.go(item); });
}

function measure(mesh) {
  mesh.angles ??= measureAngles(mesh);
  return mesh;
}

// Shows the charts, lists and texts about one mesh beside its picture.
function showNumbers({ facts, claim, mesh }, bound, actions) {
  element("canvas").setAttribute("aria-label", `The mesh: ${plural(mesh.vertices, "vertex", "vertices")}, ${plural(mesh.count, "triangle")}.`);
  element("number").max = mesh.count;
  showAngles(mesh, bound);
  const lists = listsOf(facts, claim, mesh);
  actions.lists(lists);
  showLists(lists, actions.go);
  actions.choose(null);
}

function showFrame(frames, i, stage, actions, page) {
  const frame = frames[i];
  measure(frame.mesh);
  frame.scene ??= makeScene(frame.mesh, frame.claim);
  stage.take(frame.scene);
  page.colour(frame, () => {});
  stage.refresh();
  showNumbers(frame, page.bound, actions);
  showLengths(frame.mesh);
  showCompared(frames, page.bound, (k) => actions.frames.go(k));
}

async function start() {
  const facts = readJson("facts"), claim = readJson("certificate");
  const bound = claim?.asked.angle_bound ?? null;
  showVerdict(facts, claim);
  followHeader();
  const frames = framesOf(facts, await readArrays(facts), claim), own = frames[frames.length - 1];
  const all = frames.reduce((n, { mesh }) => n + mesh.count, 0);
  for (const frame of frames) if (frame === own || all <= measuredAtOnce) measure(frame.mesh);
  own.scene = makeScene(own.mesh, own.claim);
  const stage = makeStage(own.scene), actions = makeActions(stage, frames, bound);
  const page = { bound, colour: makeColouring(stage, frames, bound) };
  page.colour(own, stage.changed);
  if (stage.mode.shownTriangles !== undefined || stage.mode.isField) element("ellipses").checked = false;  // they would hide what is shown
  stage.resize();
  stage.camera.fit();
  stage.paint();  // the first one makes the shaders ready
  stage.paint();
  actions.frames = makeFrameControl(frames, (i) => showFrame(frames, i, stage, actions, page));
  addPointers(stage, element("canvas"), actions);
  addKeys(stage, element("canvas"), actions);
  addControls(stage, actions);
  showAsked(facts, claim, own.mesh);
  showNumbers(own, bound, actions);
  showCompared(frames, bound, (k) => actions.frames.go(k));
  showAgain(facts, claim);
  const item = itemOfAddress(own.mesh);
  if (item) actions.go(item);
  showLengths(own.mesh);
  // Gives programs that drive the page access to its parts.
  window.asterism = { facts, claim, stage, actions, frames, get mesh() { return stage.mesh; } };
  document.documentElement.dataset.state = "ready";
}

start().catch((failure) => {
  element("badge").textContent = "This page could not be read";
  element("badge").className = "bad";
  element("why").textContent = String(failure?.message ?? failure);
  document.documentElement.dataset.state = "failed";
});
