// SPDX-License-Identifier: MIT
// Holds the picture on the page. It is redrawn at most once a frame, and only when something has
// changed.

function makeView(canvas, mesh, places) {
  const gl = canvas.getContext("webgl2", { antialias: false, alpha: false, preserveDrawingBuffer: true });
  return gl ? makeCardView(gl, mesh, places) : makePlainView(canvas.getContext("2d"), mesh, places);
}

function colourOf(name) {
  return getComputedStyle(document.documentElement).getPropertyValue(name);
}

const lookOfPage = () => ({
  edges: element("edges").checked, edge: numbersOfColour(colourOf("--edge")),
  paper: numbersOfColour(colourOf("--card")), ink: numbersOfColour(colourOf("--ink")),
});

// Prepares one mesh for drawing: chunks, view, kept pictures, exempt corners.
function makeScene(mesh, claim) {
  const places = makeChunks(mesh), view = makeView(element("canvas"), mesh, places);
  const corners = (claim?.audit.exempt_corners ?? []).map((n) => n - 1).filter((v) => v < mesh.vertices);
  return { mesh, places, view, pictures: makePictures(mesh, places, view), corners };
}

// Makes the function that draws marks above the mesh. An overlay without marks is hidden: to
// compose an empty one takes as long as a full one.
function makeMarks(stage) {
  const overlay = element("overlay"), context = overlay.getContext("2d"), { camera } = stage;
  return () => {
    const { mesh, places, corners } = stage.scene;
    context.setTransform(camera.ratio, 0, 0, camera.ratio, 0, 0);
    context.clearRect(0, 0, camera.width, camera.height);
    const drawn = element("ellipses").checked ? drawEllipses(context, camera, mesh, places) : { number: 0, scale: 0, longest: 0, gap: 0 };
    Object.assign(stage, { ellipses: drawn.number, longestEllipse: drawn.longest, ellipseGap: drawn.gap });
    showEllipses(drawn);
    showScale(camera);
    drawCorners(context, camera, mesh, corners, markPlace);
    drawPoints(context, camera, mesh.repairs, markPlace);
    const small = stage.mode?.shownTriangles ?? [];
    drawRings(context, camera, mesh, small);
    if (stage.chosen?.triangle !== undefined) drawChosen(context, camera, mesh, stage.chosen.triangle);
    if (stage.chosen?.vertex !== undefined) drawCorners(context, camera, mesh, [stage.chosen.vertex], markInk);
    const empty = stage.ellipses === 0 && corners.length === 0 && mesh.repairs.length === 0 && small.length === 0 && stage.chosen === null;
    overlay.style.visibility = empty ? "hidden" : "";
  };
}

// Makes the stage, which shows one scene at a time, all of them by the same camera.
function makeStage(scene) {
  const canvas = element("canvas"), camera = new Camera(scene.mesh.box);
  const stage = {
    camera, scene, chosen: null, ellipses: 0,
    get mesh() { return stage.scene.mesh; }, get places() { return stage.scene.places; }, get view() { return stage.scene.view; },
    get pictures() { return stage.scene.pictures; }, get seconds() { return stage.pictures.seconds; },
  };
  const paintMarks = makeMarks(stage);
  let settled = 0, going = false, looks = 0;  // changes of colours so far
  const show = () => {
    stage.pictures.show(camera, lookOfPage());
    paintMarks();
  };
  // Draws the exact picture at once.
  stage.paint = () => {
    clearTimeout(settled);
    stage.pictures.paint(camera, lookOfPage());
    show();
  };
  const goOn = () => {
    going = stage.pictures.busy;
    if (!going) return;
    if (stage.pictures.step()) {
      show();
      stage.pictures.startWhole(camera, lookOfPage());
    }
    requestAnimationFrame(goOn);
  };
  // Draws the exact picture, a part of it in each frame.
  stage.settle = () => {
    stage.pictures.start(camera, lookOfPage());
    if (!going) goOn();
  };
  // Shows a changed view: the exact picture if it takes less than a frame, else kept ones until the
  // view rests and the exact one is drawn.
  stage.move = () => {
    if (stage.pictures.shows(camera)) return paintMarks();
    if (stage.pictures.quick(camera)) return stage.paint();
    clearTimeout(settled);
    stage.pictures.stop();
    show();
    settled = setTimeout(stage.settle, 150);
    return undefined;
  };
  // Selects another scene; the view stays.
  stage.take = (next) => {
    clearTimeout(settled);
    stage.pictures.stop();
    Object.assign(stage, { scene: next, chosen: null });
  };
  // Shows the scene's kept picture, or draws it anew if the view or the colours have changed.
  stage.refresh = () => {
    const kept = stage.scene.look === looks && stage.pictures.shows(camera);
    stage.scene.look = looks;
    return kept ? show() : stage.paint();
  };
  const soon = (act) => {
    let waiting = false;
    return () => {
      if (waiting) return;
      waiting = true;
      requestAnimationFrame(() => { waiting = false; act(); });
    };
  };
  stage.moved = soon(stage.move);
  stage.marked = soon(paintMarks);
  // Redraws the same view after a change of colours.
  stage.changed = soon(() => {
    stage.scene.look = ++looks;
    stage.pictures.outdate();
    stage.settle();
    paintMarks();
  });
  stage.resize = () => {
    camera.measure(element("stage"));
    const width = Math.round(camera.width * camera.ratio), height = Math.round(camera.height * camera.ratio);
    if (canvas.width === width && canvas.height === height) return;
    for (const one of [canvas, element("overlay")]) Object.assign(one, { width, height });
    stage.move();
  };
  return stage;
}
