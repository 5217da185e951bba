// SPDX-License-Identifier: MIT
// Puts the page together and answers keys and buttons.

function readMesh(facts, arrays) {
  const mesh = {
    ...arrays, notOfStars: arrays.not_of_stars, vertices: facts.vertices,
    agreeing: facts.triangles, count: facts.triangles + facts.disagreeing,
    box: boxOf(arrays.positions), scratch: new Float64Array(6),
  };
  mesh.angles = measureAngles(mesh);
  return mesh;
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
    hover: makeHover(stage, mesh, bound),
    lists: (lists) => { all = lists.flatMap(({ items }) => items).filter((i) => i.triangle !== undefined || i.vertex !== undefined); },
    choose(item) {
      const there = item !== null && (item.triangle < mesh.count || item.vertex < mesh.vertices);
      stage.chosen = there ? item : null;
      showChosen(facts, claim, mesh, bound, stage.chosen);
      stage.marked();
    },
    go(item) {
      actions.choose(item);
      if (stage.chosen !== null) stage.camera.show(boxOfItem(mesh, item));
      stage.moved();
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

function addModes(stage, mesh, bound, claim) {
  const modes = makeModes(mesh, bound, claim), choice = element("mode");
  modes.forEach((mode, i) => choice.append(make("option", { value: i }, typeof mode === "function" ? mode.label : mode.name)));
  const show = () => {
    const i = Number(choice.value);
    if (typeof modes[i] === "function") modes[i] = modes[i]();
    stage.mode = modes[i];
    stage.view.setMode(modes[i]);
    showLegend(modes[i]);
    stage.changed();
  };
  choice.value = modes.first;
  choice.addEventListener("change", show);
  show();
}

function addControls(stage, mesh, actions) {
  const { camera } = stage;
  const on = (id, act, then = stage.moved) => element(id).addEventListener("click", () => { act(); then(); });
  on("nearer", () => camera.zoom(1.5));
  on("farther", () => camera.zoom(1 / 1.5));
  on("whole", () => camera.fit());
  element("edges").addEventListener("change", stage.changed);
  element("ellipses").addEventListener("change", stage.marked);
  element("find").addEventListener("submit", () => {
    const t = Number(element("number").value) - 1;
    if (t >= 0 && t < mesh.count) actions.go({ triangle: t });
  });
  const system = matchMedia("(prefers-color-scheme: dark)"), root = document.documentElement;
  const other = () => ((root.dataset.theme ?? (system.matches ? "dark" : "light")) === "dark" ? "light" : "dark");
  const name = () => { element("theme").textContent = other() === "dark" ? "Dark" : "Light"; };
  on("theme", () => { root.dataset.theme = other(); name(); }, stage.changed);
  system.addEventListener("change", () => { name(); stage.changed(); });
  name();
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
  addModes(stage, mesh, bound, facts.is_of_this_mesh ? claim : null);
  stage.resize();
  stage.camera.fit();
  stage.paint();  // the first one makes the shaders ready
  stage.paint();
  addPointers(stage, element("canvas"), actions);
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
