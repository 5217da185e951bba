// SPDX-License-Identifier: MIT
// The picture on the page, redrawn once a frame at most and only when something changed.

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

// What is drawn above the mesh. An overlay with nothing on it is hidden: putting it on the page costs as much
// as one that is full.
function makeMarks(stage, mesh, corners) {
  const overlay = element("overlay"), context = overlay.getContext("2d"), { camera, places } = stage;
  return () => {
    context.setTransform(camera.ratio, 0, 0, camera.ratio, 0, 0);
    context.clearRect(0, 0, camera.width, camera.height);
    const drawn = element("ellipses").checked ? drawEllipses(context, camera, mesh, places) : { number: 0, scale: 0, longest: 0, gap: 0 };
    Object.assign(stage, { ellipses: drawn.number, longestEllipse: drawn.longest, ellipseGap: drawn.gap });
    showEllipses(drawn);
    showScale(camera);
    drawCorners(context, camera, mesh, corners, markPlace);
    drawCorners(context, camera, mesh, mesh.repairs.map(({ vertex }) => vertex), markPlace);
    if (stage.chosen?.triangle !== undefined) drawChosen(context, camera, mesh, stage.chosen.triangle);
    if (stage.chosen?.vertex !== undefined) drawCorners(context, camera, mesh, [stage.chosen.vertex], markInk);
    const empty = stage.ellipses === 0 && corners.length === 0 && mesh.repairs.length === 0 && stage.chosen === null;
    overlay.style.visibility = empty ? "hidden" : "";
  };
}

function makeStage(mesh, claim) {
  const canvas = element("canvas"), places = makeChunks(mesh);
  const view = makeView(canvas, mesh, places), camera = new Camera(mesh.box);
  const pictures = makePictures(mesh, places, view);
  const stage = { camera, places, view, pictures, chosen: null, ellipses: 0, get seconds() { return pictures.seconds; } };
  const corners = (claim?.audit.exempt_corners ?? []).map((n) => n - 1).filter((v) => v < mesh.vertices);
  const paintMarks = makeMarks(stage, mesh, corners);
  let settled = 0, going = false;
  const show = () => {
    pictures.show(camera, lookOfPage());
    paintMarks();
  };
  // The exact picture, at once.
  stage.paint = () => {
    clearTimeout(settled);
    pictures.paint(camera, lookOfPage());
    show();
  };
  const goOn = () => {
    going = pictures.busy;
    if (!going) return;
    if (pictures.step()) {
      show();
      pictures.startWhole(camera, lookOfPage());
    }
    requestAnimationFrame(goOn);
  };
  // The exact picture, a part of it each frame.
  stage.settle = () => {
    pictures.start(camera, lookOfPage());
    if (!going) goOn();
  };
  // While the view moves: the exact picture if it takes less than a frame, kept ones otherwise, and the
  // exact one as soon as the view rests.
  stage.move = () => {
    if (pictures.shows(camera)) return paintMarks();
    if (pictures.quick(camera)) return stage.paint();
    clearTimeout(settled);
    pictures.stop();
    show();
    settled = setTimeout(stage.settle, 150);
    return undefined;
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
  // The same view in other colours.
  stage.changed = soon(() => {
    pictures.outdate();
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
