// SPDX-License-Identifier: MIT
// Puts the page together.

function showFacts(facts) {
  element("badge").textContent = facts.certified ? "Certified" : "Not certified";
  element("badge").className = facts.certified ? "good" : "bad";
  element("why").textContent = facts.verdict;
  for (const [name, value] of facts.table) {
    const row = element("asked").insertRow();
    row.insertCell().textContent = name;
    row.insertCell().textContent = value;
  }
  const again = document.createElement(facts.repeat ? "code" : "p");
  again.textContent = facts.repeat || "The mesh was written without a certificate beside it.";
  element("again").append(again);
}

function numbersOfColour(name) {
  const probe = document.createElement("span");
  probe.style.color = `var(${name})`;
  document.body.append(probe);
  const numbers = getComputedStyle(probe).color.match(/[\d.]+/g).slice(0, 3).map((x) => x / 255);
  probe.remove();
  return numbers;
}

function makeStage(corners) {
  const canvas = element("canvas"), turning = makeTurning();
  const gl = canvas.getContext("webgl2", { antialias: true, preserveDrawingBuffer: true });
  const drawing = gl ? makeCardDrawing(gl, corners) : makePlainDrawing(canvas.getContext("2d"), corners);
  let asked = false;
  const stage = {
    canvas, turning, isOnCard: gl !== null, drawing,
    paint() {
      asked = false;
      const ratio = window.devicePixelRatio || 1;
      const width = Math.max(1, Math.round(canvas.clientWidth * ratio)), height = Math.max(1, Math.round(canvas.clientHeight * ratio));
      if (canvas.width !== width || canvas.height !== height) Object.assign(canvas, { width, height });
      const least = Math.min(width, height);
      drawing.paint({ ...turning, width, height, across: 0.95 * least / width, up: 0.95 * least / height,
        edges: element("edges").checked, paper: numbersOfColour("--card"), line: numbersOfColour("--edge") });
    },
    changed() {
      if (!asked) requestAnimationFrame(stage.paint);
      asked = true;
    },
  };
  return stage;
}

function showColours(stage, corners) {
  const mode = element("mode").value, legend = element("colours"), patches = new Set(corners.faces).size;
  stage.drawing.colour(coloursOf(corners, mode));
  legend.textContent = mode === "patch" ? `${patches} ${patches === 1 ? "patch" : "patches"}` : mode === "plain" ? "" : "0 ";
  if (mode !== "angle") return;
  const bar = document.createElement("span");
  bar.className = "angles";
  legend.append(bar, " 60 degrees, of flat triangles in space; not certified");
}

function keepTurning(stage) {
  let before = null;
  const step = (now) => {
    if (!element("turning").checked) { before = null; return; }
    if (before !== null) stage.turning.rotate(Math.min(now - before, 100) * 0.06, 0);
    before = now;
    stage.paint();
    requestAnimationFrame(step);
  };
  requestAnimationFrame(step);
}

function addControls(stage, corners) {
  const { canvas, turning, changed } = stage, box = element("turning");
  addPointers(canvas, turning, changed);
  const toggle = () => { box.checked = !box.checked; keepTurning(stage); };
  addKeys(canvas, turning, changed, toggle);
  box.addEventListener("change", () => keepTurning(stage));
  element("edges").addEventListener("change", changed);
  element("mode").addEventListener("change", () => { showColours(stage, corners); changed(); });
  element("nearer").addEventListener("click", () => { turning.enlarge(1.25); changed(); });
  element("farther").addEventListener("click", () => { turning.enlarge(0.8); changed(); });
  element("whole").addEventListener("click", () => { turning.reset(); changed(); });
  const root = document.documentElement, dark = window.matchMedia("(prefers-color-scheme: dark)");
  const isDark = () => root.dataset.theme ? root.dataset.theme === "dark" : dark.matches;
  const name = () => { element("theme").textContent = isDark() ? "Light" : "Dark"; };
  element("theme").addEventListener("click", () => { root.dataset.theme = isDark() ? "light" : "dark"; name(); changed(); });
  dark.addEventListener("change", () => { name(); changed(); });
  name();
  new ResizeObserver(changed).observe(canvas);
}

async function start() {
  const root = document.documentElement;
  try {
    const facts = readJson("facts");
    showFacts(facts);
    followHeader();
    const corners = makeCorners(await readArrays(facts));
    const stage = makeStage(corners);
    showColours(stage, corners);
    addControls(stage, corners);
    stage.paint();
    window.asterism = { facts, corners, stage };
    root.dataset.state = "ready";
  } catch (problem) {
    element("why").textContent = `This page could not be drawn: ${problem.message}`;
    root.dataset.state = "failed";
  }
}

start();
