// SPDX-License-Identifier: MIT
//
// The page: what is shown, what pointers and keys change, and the frames. All state is in `state`.
import { create } from '../asterism-predicates/api.mjs';
import { axesOf, metricOfAxes, squaredDistance } from './plane.js';
import { StarSet } from './star_set.js';
import { Refinement } from './refinement.js';
import { SCENES, FIELDS, fieldOfSites } from './scenes.js';
import { View } from './view.js';
import { Panels } from './panels.js';
import { MeshPanel } from './mesh_panel.js';

const LAYERS = [['ellipses', 'Ellipses'], ['cell', 'Cell'], ['wedge', 'Wedge and arc'], ['diagram', 'Voronoi diagram'],
                ['field', 'Field'], ['warp', 'As it sees'], ['tiers', 'Who decided']];
// Milliseconds of a frame that stars may use: a third of a quick frame; more of a slow one, which
// other work makes slow.
const budgetOf = (interval) => Math.max(6, Math.min(80, 0.4 * interval));
const isCalm = matchMedia('(prefers-reduced-motion: reduce)').matches;
const element = (id) => document.getElementById(id);

const state = {
  layers: Object.fromEntries(LAYERS.map(([name]) => [name, false])),
  set: null, scene: null, sceneAt: 0, fieldName: null, strength: 12, angleBound: 20, strategy: 'arcs', isNaive: false,
  selected: null, other: null, names: null, ellipseScale: 0.2, ellipsesOf: null,
  refinement: null, marks: null, markedAt: 0, isPlaying: false, nextStep: 0, mode: null, drawn: [], cursor: null, mesh: null,
};
let predicates, view, panels, meshPanel, isAsked = false, isInRow = false, lastFrame = 0, lastTold = 0, toldKey = '';

// --- Scenes.

const isBordered = () => state.set.boundary !== null;
const isFixed = (v) => state.set.next.has(v);
const nameOf = (v) => state.names?.[v] ?? String(v + 1);
function fieldAt() {
  if (state.scene.id !== 'yours') return FIELDS[state.fieldName].at(state.strength);
  const xs = state.polygon.map(([x]) => x), ys = state.polygon.map(([, y]) => y), sides = [xs, ys].map((all) => [Math.min(...all), Math.max(...all)]);
  return FIELDS[state.fieldName].at(state.strength, [...sides.map(([low, high]) => (low + high) / 2), Math.max(...sides.map(([low, high]) => (high - low) / 2))]);
}

function boxOfSites() {
  const { sites } = state.set, xs = sites.map((s) => s[0]), ys = sites.map((s) => s[1]);
  return [Math.min(...xs), Math.min(...ys), Math.max(...xs), Math.max(...ys)];
}
function showWhole() {
  const [left, bottom, right, top] = boxOfSites(), reach = state.layers.ellipses && !isBordered() ? reachOfEllipses() : 0;
  const spare = Math.max(0.06 * Math.max(right - left, top - bottom, 0.1), reach);
  view.show([left - spare, bottom - spare, right + spare, top + spare]);
}

const reachOfEllipses = () => state.ellipseScale * Math.max(...(state.ellipsesOf ?? [...state.set.sites.keys()]).map((v) => axesOf(state.set.sites[v].slice(2)).long));

// Returns the factor with which the sites' unit circles about fill the space that there is.
function fittingScale() {
  const { sites } = state.set, [left, bottom, right, top] = boxOfSites();
  const sizes = sites.map((s) => { const { long, short } = axesOf(s.slice(2)); return Math.sqrt(long * short); }).sort((a, b) => a - b);
  return 0.38 * Math.sqrt((right - left) * (top - bottom) / sites.length) / sizes[sizes.length >> 1];
}

function sitesOf(made) {
  if (made.sites) return { sites: made.sites, border: made.polygon ?? null };
  const field = fieldAt(), border = made.polygon ?? null;
  return { sites: [...(border ?? []), ...(made.points ?? [])].map(([x, y]) => [x, y, ...field(x, y)]), border };
}

function begin(made) {
  const { sites, border } = sitesOf(made);
  state.set = new StarSet(predicates, sites, border ? border.map((_, i) => i) : null);
  state.set.isNaive = state.isNaive;
  Object.assign(state, { refinement: null, marks: null, isPlaying: false, mode: null, drawn: [], mesh: null, names: made.names ?? null,
                         selected: made.selected ?? null, other: made.other ?? null, ellipsesOf: made.ellipsesOf ?? null });
  state.ellipseScale = made.ellipseScale ?? fittingScale();
  say('');
  predicates.resetCounters();
  state.set.settle(100);
  showWhole();
  invalidate();
}

function openScene(index, keep = {}) {
  state.sceneAt = (index + SCENES.length) % SCENES.length;
  const scene = SCENES[state.sceneAt], made = scene.make();
  state.scene = scene;
  Object.assign(state, { fieldName: made.field?.name ?? null, strength: made.field?.strength ?? 12, angleBound: made.angleBound ?? 20,
                         strategy: made.strategy ?? 'arcs', isNaive: made.isNaive ?? false, ...keep });
  Object.assign(state.layers, { tiers: false }, made.layers);
  begin(made);
  history.replaceState(null, '', `#${scene.id}`);
  panels.showScene(state);
}

/** A polygon of one's own, its corners counter-clockwise. */
function openPolygon(points) {
  state.scene = { id: 'yours', title: 'Your polygon', figure: '', words: 'Your polygon. Add sites by double-clicking, refine it here by the thesis, or mesh it with the program below.' };
  state.fieldName ??= 'swirl';
  Object.assign(state.layers, { tiers: false, cell: false, wedge: false, warp: false, diagram: false, field: true, ellipses: false });
  state.isNaive = false;
  state.polygon = points;
  begin({ polygon: points, points: [] });
  panels.showScene(state);
}
const reopen = (keep) => {
  if (state.scene.id === 'yours') {
    Object.assign(state, keep);
    openPolygon(state.polygon);
  } else openScene(state.sceneAt, { fieldName: state.fieldName, strength: state.strength, angleBound: state.angleBound, strategy: state.strategy, isNaive: state.isNaive, ...keep });
};

// --- Changes by hand.

function say(words, isAlert = false) {
  element('event').textContent = words;
  element('event').classList.toggle('bad', isAlert);
}
function hint(words) {
  element('hint').hidden = !words;
  element('hint').textContent = words ?? '';
}

function touched() {
  Object.assign(state, { refinement: null, marks: null, isPlaying: false, mesh: null });
  invalidate();
}
function moveTo(v, x, y) {
  const { set } = state, s = set.sites[v];
  if (isFixed(v) || set.sites.some((o, w) => w !== v && o[0] === x && o[1] === y)) return;
  if (isBordered() && !set.isInside(x, y)) return;
  set.move(v, [x, y, ...(state.fieldName ? fieldAt()(x, y) : s.slice(2))]);
  touched();
}
function setMetric(v, metric) {
  if (state.fieldName || !metric.every(Number.isFinite) || !predicates.isPositiveDefinite(metric)) return;
  state.set.move(v, [...state.set.sites[v].slice(0, 2), ...metric]);
  touched();
}
function addAt(x, y) {
  const { set } = state;
  if (set.sites.length >= 2000) return say('Two thousand sites are the most that this page takes.', true);
  if (set.sites.some((s) => s[0] === x && s[1] === y)) return undefined;
  if (isBordered() && !set.isInside(x, y)) return say('A site has to be inside the polygon.', true);
  const metric = state.fieldName ? fieldAt()(x, y) : fieldOfSites(set.sites)(x, y);
  state.selected = set.add([x, y, ...metric]);
  state.other = null;
  touched();
  return say(`Site ${nameOf(state.selected)} added.`);
}
function removeChosen() {
  const { set, selected } = state;
  if (selected === null) return say('Choose a site first.');
  if (isFixed(selected)) return say('The corners of the domain stay.', true);
  if (set.sites.length <= 3) return say('Three sites stay.', true);
  set.remove(selected);
  if (state.names) state.names = [...state.names].filter((_, v) => v !== selected);
  Object.assign(state, { selected: null, other: null, ellipsesOf: null });
  return touched();
}
function choose(v, other = null) {
  state.selected = v;
  state.other = other;
  invalidate();
}
function stepThrough(by) {
  const count = state.set.sites.length;
  choose(state.selected === null ? (by > 0 ? 0 : count - 1) : (state.selected + by + count) % count);
}
function nextNeighbour() {
  if (state.selected === null) return;
  const { ring } = state.set.stars[state.selected];
  if (ring.length) choose(state.selected, ring[(ring.indexOf(state.other) + 1) % ring.length]);
}

// --- Refinement.

function startRefinement() {
  if (state.refinement) return true;
  if (!isBordered()) {
    // Gives free sites a frame, and interpolates a field between them from their ellipses.
    const [left, bottom, right, top] = boxOfSites(), spare = 0.12 * Math.max(right - left, top - bottom);
    const frame = [[left - spare, bottom - spare], [right + spare, bottom - spare], [right + spare, top + spare], [left - spare, top + spare]];
    const field = state.fieldName ? fieldAt() : fieldOfSites(state.set.sites.slice());
    const sites = [...frame.map(([x, y]) => [x, y, ...field(x, y)]), ...state.set.sites];
    const { layers } = state;
    state.set = new StarSet(predicates, sites, [0, 1, 2, 3]);
    state.names = state.names ? ['', '', '', '', ...state.names] : null;
    if (state.ellipsesOf) state.ellipsesOf = state.ellipsesOf.map((v) => v + 4);
    Object.assign(state, { selected: null, other: null, isNaive: false });
    Object.assign(layers, { cell: false, wedge: false });
    state.ownField = field;
    showWhole();
  }
  const field = state.fieldName ? fieldAt() : state.ownField ?? fieldOfSites(state.set.sites.slice());
  state.set.isNaive = state.isNaive = false;
  state.refinement = new Refinement(state.set, field, { angleBound: state.angleBound, strategy: state.strategy, name: nameOf });
  panels.showScene(state);
  return true;
}
function refineStep() {
  startRefinement();
  const event = state.refinement.step();
  Object.assign(state, { marks: event.marks ?? null, markedAt: performance.now(), mesh: null });
  if (state.selected !== null && state.selected >= state.set.sites.length) choose(null);
  say(`${state.refinement.steps}. ${event.words}`, event.kind === 'stuck');
  if (event.kind === 'done' || event.kind === 'stuck') {
    state.isPlaying = false;
    state.marks = event.kind === 'done' ? null : state.marks;
    meshPanel.refined(state, event.kind === 'done');
  }
  invalidate();
  return event.kind;
}
function play(isQuick) {
  state.isPlaying = !state.isPlaying || isQuick;
  state.isQuick = isQuick;
  state.nextStep = 0;
  invalidate();
}
function runSteps(now) {
  if (!state.isPlaying || now < state.nextStep) return;
  const end = performance.now() + 30;
  do refineStep(); while (state.isPlaying && state.isQuick && performance.now() < end);
  state.nextStep = now + (state.isQuick ? 0 : isCalm ? 600 : Math.max(70, 420 - 6 * state.refinement.steps));
}

// --- Frames.

function handles() {
  const { selected, set } = state;
  if (selected === null || state.fieldName || isFixed(selected)) return null;
  const [x, y, ...metric] = set.sites[selected], { long, short, angle } = axesOf(metric), size = state.ellipseScale;
  return [[x + size * long * Math.cos(angle), y + size * long * Math.sin(angle)],
          [x - size * short * Math.sin(angle), y + size * short * Math.cos(angle)]];
}

// Returns a point of the arc that both ends dominate over both neighbours, in a triangle without
// either of them (definitions 4 to 6).
function goodPoint({ sites: [v, w, x, y] }) {
  const turn = (a, b, c) => (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
  const within = (q, p) => {
    const [a, b, c] = [turn(v, w, q), turn(w, p, q), turn(p, v, q)];
    return (a > 0 && b > 0 && c > 0) || (a < 0 && b < 0 && c < 0);
  };
  return (p) => !within(x, p) && !within(y, p) &&
    [x, y].every((by) => predicates.dominates(v, by, p) === 1 && predicates.dominates(w, by, p) === 1);
}

function tiersOfEdges() {
  const { set } = state;
  if (state.tiersOf?.version === set.version) return state.tiersOf.tiers;
  const tiers = new Map();
  set.stars.forEach(({ ring }, v) => ring.forEach((w) => {
    const why = set.whyNeighbour(v, w);
    if (why) tiers.set(v * 65536 + w, why.tier);
  }));
  state.tiersOf = { version: set.version, tiers };
  return tiers;
}

function picture(now) {
  const { set, selected, other } = state;
  const why = selected !== null && other !== null && other !== selected ? set.whyNeighbour(selected, other) : null;
  const isDrawing = state.mode === 'draw';
  return {
    ...state, why, isGood: why ? goodPoint(why) : null, fixed: isFixed, handles: handles(),
    field: state.fieldName ? fieldAt() : null, box: boxOfSites(),
    tiers: state.layers.tiers && set.stale.size === 0 ? tiersOfEdges() : null,
    age: isCalm ? 0 : Math.max(0, now - state.markedAt) / 700, mesh: isDrawing ? null : state.mesh,
    polygon: isDrawing ? { points: state.drawn, isClosed: false, cursor: state.cursor }
      : isBordered() && !state.mesh ? { points: set.boundary.map((v) => set.sites[v]), isClosed: true } : null,
  };
}

const keyOf = () => [state.set.version, state.selected, state.other, state.isNaive, state.mode, state.isPlaying].join();

function frame(now) {
  isAsked = false;
  const budget = budgetOf(isInRow ? now - lastFrame : 0);
  lastFrame = now;
  runSteps(now);
  const isSettled = state.set.settle(budget), p = picture(now);
  view.draw(p);
  const isFiner = state.layers.diagram && !state.mesh && isSettled && !pointers.size && view.diagram.goOn(budget);
  // Updates panels ten times a second, and at once when everything is constructed.
  const key = keyOf();
  if (key !== toldKey && (now - lastTold > 100 || (isSettled && !pointers.size && !state.isPlaying))) {
    panels.show(p, isSettled, predicates.counters().edgeTest);
    lastTold = now;
    toldKey = key;
  }
  document.documentElement.dataset.state = isSettled ? 'settled' : 'making';
  const isMoving = state.isPlaying || (state.marks && !isCalm && now - state.markedAt < 700) || key !== toldKey;
  if (!isSettled || isFiner || isMoving || (state.layers.diagram && !state.mesh && !view.diagram.isFinished)) invalidate();
  isInRow = isAsked;
}
function invalidate() {
  if (isAsked) return;
  isAsked = true;
  requestAnimationFrame(frame);
}

// --- Pointers.

const pointers = new Map();
let drag = null, pending = false;

function nearest(x, y, radius) {
  let best = null, least = radius;
  state.set.sites.forEach((s, v) => {
    const [px, py] = view.toPage(s[0], s[1]), d = Math.hypot(px - x, py - y);
    if (d < least) least = d, best = v;
  });
  return best;
}
const placeOf = (event) => {
  const box = view.canvas.getBoundingClientRect();
  return [event.clientX - box.left, event.clientY - box.top];
};

function pressed(event) {
  const [x, y] = placeOf(event), radius = event.pointerType === 'mouse' ? 13 : 26;
  view.canvas.focus({ preventScroll: true });
  view.canvas.setPointerCapture?.(event.pointerId);
  pointers.set(event.pointerId, [x, y]);
  if (pointers.size === 2) {
    drag = { kind: 'pinch' };
    return;
  }
  if (state.mode === 'draw' || state.mode === 'add') {
    drag = { kind: state.mode };
    return;
  }
  const handle = (handles() ?? []).findIndex(([hx, hy]) => { const [px, py] = view.toPage(hx, hy); return Math.hypot(px - x, py - y) < radius; });
  const v = state.mesh ? null : nearest(x, y, radius);
  if (handle >= 0 && (v === null || v === state.selected)) drag = { kind: 'handle', handle, axes: axesOf(state.set.sites[state.selected].slice(2)) };
  else if (v !== null) {
    const isNeighbour = state.selected !== null && v !== state.selected && state.set.stars[state.selected].ring.includes(v);
    drag = { kind: 'site', v, isNeighbour, from: [x, y], hasMoved: false };
    if (!isNeighbour) choose(v, v === state.selected ? state.other : null);
  } else drag = { kind: 'view', from: [x, y], hasMoved: false };
  invalidate();
}

function pinched(before, after) {
  const middle = (p) => [(p[0][0] + p[1][0]) / 2, (p[0][1] + p[1][1]) / 2], apart = (p) => Math.hypot(p[0][0] - p[1][0], p[0][1] - p[1][1]);
  const [x, y] = middle(after), [bx, by] = middle(before);
  view.centre[0] -= (x - bx) / view.scale;
  view.centre[1] += (y - by) / view.scale;
  if (apart(before) > 0) view.zoomAt(x, y, apart(after) / apart(before));
}

function draggedTo(x, y) {
  if (drag.kind === 'site') {
    if (!drag.hasMoved && Math.hypot(x - drag.from[0], y - drag.from[1]) < 4) return;
    if (!drag.hasMoved) choose(drag.v, drag.v === state.selected ? state.other : null);
    drag.hasMoved = true;
    moveTo(drag.v, ...view.toPlane(x, y));
  } else if (drag.kind === 'handle') {
    const s = state.set.sites[state.selected], [px, py] = view.toPlane(x, y), dx = px - s[0], dy = py - s[1];
    const length = Math.max(0.03, Math.min(6, Math.hypot(dx, dy) / state.ellipseScale)), turn = drag.handle === 0 ? 0 : Math.PI / 2;
    const angle = Math.atan2(dy, dx) - turn;
    setMetric(state.selected, metricOfAxes({ ...drag.axes, angle, [drag.handle === 0 ? 'long' : 'short']: length }));
  } else if (drag.kind === 'view') {
    if (Math.hypot(x - drag.from[0], y - drag.from[1]) > 3) drag.hasMoved = true;
    if (drag.last) {
      view.centre[0] -= (x - drag.last[0]) / view.scale;
      view.centre[1] += (y - drag.last[1]) / view.scale;
    }
    drag.last = [x, y];
    invalidate();
  }
}
// Moves at most once a frame, however many events the pointer reports.
function moved(event) {
  const at = placeOf(event);
  if (state.mode === 'draw') {
    state.cursor = view.toPlane(...at);
    invalidate();
  }
  if (!pointers.has(event.pointerId) || !drag) return;
  const before = [...pointers.values()];
  pointers.set(event.pointerId, at);
  if (drag.kind === 'pinch' && pointers.size === 2) {
    pinched(before, [...pointers.values()]);
    invalidate();
    return;
  }
  drag.at = at;
  if (pending) return;
  pending = true;
  requestAnimationFrame(() => {
    pending = false;
    if (drag?.at) draggedTo(...drag.at);
  });
}
function released(event) {
  if (!pointers.delete(event.pointerId) || !drag) return;
  const [x, y] = placeOf(event), { kind } = drag;
  if (drag.at && kind !== 'pinch') draggedTo(x, y);
  if (kind === 'draw') drawCorner(x, y);
  else if (kind === 'add') {
    state.mode = null;
    hint(null);
    addAt(...view.toPlane(x, y));
  } else if (kind === 'site' && !drag.hasMoved && drag.isNeighbour) choose(state.selected, state.other === drag.v ? null : drag.v);
  else if (kind === 'view' && !drag.hasMoved && !state.mesh) choose(null);
  drag = null;
  invalidate();
}

// --- A polygon drawn by hand.

function crosses(p, q, r, s) {
  const turn = (a, b, c) => Math.sign(predicates.orient2d(...a, ...b, ...c));
  const [a, b, c, d] = [turn(p, q, r), turn(p, q, s), turn(r, s, p), turn(r, s, q)];
  if (a * b < 0 && c * d < 0) return true;
  const on = (u, v, w, t) => t === 0 && Math.min(u[0], v[0]) <= w[0] && w[0] <= Math.max(u[0], v[0]) && Math.min(u[1], v[1]) <= w[1] && w[1] <= Math.max(u[1], v[1]);
  return on(p, q, r, a) || on(p, q, s, b) || on(r, s, p, c) || on(r, s, q, d);
}
/** Why the corners are no polygon, or the polygon, counter-clockwise. */
function polygonOf(points) {
  const count = points.length;
  if (count < 3) return { wrong: 'A polygon has three corners at least.' };
  if (count > 400) return { wrong: `${count} corners: this page takes 400.` };
  for (let i = 0; i < count; ++i) {
    const again = points.findIndex(([x, y], k) => k > i && x === points[i][0] && y === points[i][1]);
    if (again >= 0) return { wrong: `Corners ${i + 1} and ${again + 1} are one point.` };
  }
  for (let i = 0; i < count; ++i)
    for (let k = i + 1; k < count; ++k) {
      const [p, q, r, s] = [points[i], points[(i + 1) % count], points[k], points[(k + 1) % count]];
      const isBeside = k === i + 1 || (i === 0 && k === count - 1);
      if (isBeside && count > 3) {
        const [a, b, c] = k === i + 1 ? [p, q, s] : [r, s, q], isFlat = predicates.orient2d(...a, ...b, ...c) === 0;
        if (isFlat && (a[0] - b[0]) * (c[0] - b[0]) + (a[1] - b[1]) * (c[1] - b[1]) > 0) return { wrong: `The side after corner ${k + 1} goes back along the one before.` };
      } else if (!isBeside && crosses(p, q, r, s)) return { wrong: `The sides after corners ${i + 1} and ${k + 1} meet.` };
    }
  const area = points.reduce((sum, [x, y], i) => { const [u, v] = points[(i + 1) % count]; return sum + x * v - u * y; }, 0);
  if (count === 3 && predicates.orient2d(...points.flat()) === 0) return { wrong: 'The three corners are on a line.' };
  return { polygon: area > 0 ? points : [...points].reverse() };
}
function closePolygon(points) {
  const { wrong, polygon } = polygonOf(points);
  if (wrong) return say(wrong, true);
  state.mode = null;
  hint(null);
  openPolygon(polygon);
  return say(`Your polygon has ${polygon.length} corners.`);
}
function drawCorner(x, y) {
  const at = view.toPlane(x, y), [first] = state.drawn;
  if (first && state.drawn.length > 2 && Math.hypot(...view.toPage(...first).map((c, k) => c - [x, y][k])) < 18) return closePolygon(state.drawn);
  state.drawn.push(at.map((c) => Math.round(c * 1024) / 1024));
  return invalidate();
}
function startDrawing() {
  if (state.mode === 'draw') return state.drawn.length > 2 ? closePolygon(state.drawn) : stopDrawing();
  Object.assign(state, { mode: 'draw', drawn: [], cursor: null, selected: null, other: null, mesh: null, isPlaying: false });
  hint('Click the corners one after another; click the first again, or press Enter, to close.');
  view.canvas.focus({ preventScroll: true });
  return invalidate();
}
function stopDrawing() {
  Object.assign(state, { mode: null, drawn: [] });
  hint(null);
  invalidate();
}
function useCorners() {
  const lines = element('corners').value.split('\n').map((line) => line.trim()).filter(Boolean);
  const points = lines.map((line) => line.split(/[\s,;]+/).map(Number));
  const wrong = points.findIndex((p) => p.length !== 2 || !p.every(Number.isFinite));
  if (wrong >= 0) return say(`Line ${wrong + 1} of the corners is not two numbers: ${lines[wrong]}`, true);
  return closePolygon(points);
}

// --- Keys.

function turnEllipse(by) {
  const v = state.selected, axes = axesOf(state.set.sites[v].slice(2));
  setMetric(v, metricOfAxes({ ...axes, angle: axes.angle + by }));
}
function thinEllipse(by) {
  const v = state.selected, axes = axesOf(state.set.sites[v].slice(2)), aspect = Math.max(1, Math.min(30, axes.long / axes.short * by)), mean = Math.sqrt(axes.long * axes.short);
  setMetric(v, metricOfAxes({ angle: axes.angle, long: mean * Math.sqrt(aspect), short: mean / Math.sqrt(aspect) }));
}
function nudge(dx, dy, isFine) {
  const [x, y] = state.set.sites[state.selected], by = (isFine ? 1 : 8) / view.scale;
  moveTo(state.selected, x + by * dx, y + by * dy);
}
function pan(dx, dy) {
  view.centre[0] += 40 * dx / view.scale, view.centre[1] += 40 * dy / view.scale;
  invalidate();
}
const zoom = (by) => { view.zoomAt(view.width / 2, view.height / 2, by); invalidate(); };
const KEYS = {
  n: () => stepThrough(1), p: () => stepThrough(-1), o: nextNeighbour, r: refineStep, ' ': () => play(false),
  a: () => addAt(...view.centre), Delete: removeChosen, Backspace: removeChosen, '+': () => zoom(1.25), '=': () => zoom(1.25), '-': () => zoom(0.8),
  0: () => { showWhole(); invalidate(); }, Escape: () => (state.mesh ? leaveMesh() : choose(null)),
};
const OF_CHOSEN = {
  '[': () => turnEllipse(0.08), ']': () => turnEllipse(-0.08), ',': () => thinEllipse(1.1), '.': () => thinEllipse(1 / 1.1),
};
const ARROWS = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, 1], ArrowDown: [0, -1] };
function keyed(event) {
  if (event.ctrlKey || event.metaKey || event.altKey) return;
  const { key } = event, name = key.length === 1 ? key.toLowerCase() : key;
  if (state.mode === 'draw') {
    const act = { Escape: stopDrawing, Enter: () => closePolygon(state.drawn), Backspace: () => { state.drawn.pop(); invalidate(); } }[name];
    if (act) act();
    else return;
  } else if (ARROWS[name]) {
    const [dx, dy] = ARROWS[name];
    if (state.selected === null || isFixed(state.selected) || state.mesh) pan(dx, dy);
    else nudge(dx, dy, event.shiftKey);
  } else if (OF_CHOSEN[name] && state.selected !== null) OF_CHOSEN[name]();
  else if (KEYS[name]) KEYS[name]();
  else return;
  event.preventDefault();
}

function leaveMesh() {
  state.mesh = null;
  invalidate();
}

// --- Start.

function listen() {
  const { canvas } = view, on = (id, what, does) => element(id).addEventListener(what, does);
  canvas.addEventListener('pointerdown', pressed);
  canvas.addEventListener('pointermove', moved);
  canvas.addEventListener('pointerup', released);
  canvas.addEventListener('pointercancel', released);
  canvas.addEventListener('dblclick', (event) => { if (!state.mode && !state.mesh) addAt(...view.toPlane(...placeOf(event))); });
  canvas.addEventListener('wheel', (event) => { event.preventDefault(); view.zoomAt(...placeOf(event), Math.exp(-event.deltaY / 500)); invalidate(); }, { passive: false });
  canvas.addEventListener('keydown', keyed);
  new ResizeObserver(() => { view.resize(); showWhole(); invalidate(); }).observe(element('stage'));
  on('step', 'click', refineStep);
  on('play', 'click', () => play(false));
  on('end', 'click', () => play(true));
  on('again', 'click', () => reopen({}));
  on('add', 'click', () => { state.mode = 'add'; hint('Click where the site shall be.'); });
  on('remove', 'click', removeChosen);
  on('whole', 'click', () => { showWhole(); invalidate(); });
  on('earlier', 'click', () => openScene(state.sceneAt - 1));
  on('later', 'click', () => openScene(state.sceneAt + 1));
  on('scene', 'change', (event) => openScene(Number(event.target.value)));
  on('field', 'change', (event) => reopen({ fieldName: event.target.value }));
  on('strength', 'input', (event) => { state.strength = Number(event.target.value); refield(); });
  on('bound', 'change', (event) => { state.angleBound = Number(event.target.value); state.refinement = null; });
  on('strategy', 'change', (event) => { state.strategy = event.target.value; state.refinement = null; });
  on('draw', 'click', startDrawing);
  on('use-corners', 'click', useCorners);
  document.querySelectorAll('input[name="kind"]').forEach((input) => input.addEventListener('change', () => {
    state.isNaive = state.set.isNaive = input.value === 'naive';
    state.set.makeAllAnew();
    touched();
  }));
  on('theme', 'click', () => {
    document.documentElement.dataset.theme = view.isDark ? 'light' : 'dark';
    recolour();
  });
  matchMedia('(prefers-color-scheme: dark)').addEventListener('change', recolour);
}
function recolour() {
  view.readColours();
  toldKey = '';
  invalidate();
}
// Keeps the sites in the new field. Removes sites that refinement added for another field.
function refield() {
  if (state.refinement) return reopen({});
  const field = fieldAt();
  state.set.sites = state.set.sites.map(([x, y]) => [x, y, ...field(x, y)]);
  state.set.makeAllAnew();
  panels.showScene(state);
  return touched();
}

function makeLayers() {
  for (const [name, title] of LAYERS) {
    const label = document.createElement('label'), input = document.createElement('input'), span = document.createElement('span');
    Object.assign(input, { type: 'checkbox', id: `layer-${name}` });
    span.textContent = title;
    input.addEventListener('change', () => { state.layers[name] = input.checked; toldKey = ''; invalidate(); });
    label.append(input, span);
    element('layers').append(label);
  }
}

function bytesOf(id) {
  const text = element(id).textContent.trim();
  return Uint8Array.from(atob(text), (c) => c.charCodeAt(0));
}
/** A module in this file: base64 of gzip. */
async function moduleOf(id) {
  if (!element(id)) return null;
  const stream = new Blob([bytesOf(id)]).stream().pipeThrough(new DecompressionStream('gzip'));
  return new Uint8Array(await new Response(stream).arrayBuffer());
}

async function start() {
  predicates = await create(await moduleOf('predicates-module'));
  element('version').textContent = predicates.version;
  makeLayers();
  view = new View(element('canvas'));
  panels = new Panels({ SCENES, FIELDS, nameOf, choose, isFixed, squaredDistance });
  meshPanel = new MeshPanel({ state, element, moduleOf, say, showMesh: (mesh) => { state.mesh = mesh; state.isPlaying = false; showBox(mesh); invalidate(); }, leaveMesh,
                              domain: domainOf, metric: metricSpecification, predicates });
  listen();
  const asked = SCENES.findIndex(({ id }) => id === location.hash.slice(1));
  openScene(Math.max(asked, 0));
  window.asterismStars = { state, view, predicates, openScene, closePolygon, refineStep, choose, moveTo, meshPanel, isTold: () => !isAsked && keyOf() === toldKey };
}
function showBox({ sites }) {
  const box = [Infinity, Infinity, -Infinity, -Infinity];
  for (let i = 0; i < sites.length; i += 5)
    for (const k of [0, 1]) box[k] = Math.min(box[k], sites[i + k]), box[k + 2] = Math.max(box[k + 2], sites[i + k]);
  view.show(box);
}
// Returns the polygon as it was before refinement divided its sides, with the scene's points
// inside, or null without one.
function domainOf() {
  const made = state.scene.id === 'yours' ? { polygon: state.polygon } : SCENES[state.sceneAt].make();
  if (!made.polygon) return null;
  const count = made.polygon.length;
  return { points: [...made.polygon, ...(made.points ?? [])], segments: made.polygon.map((_, i) => [i, (i + 1) % count]) };
}
function metricSpecification() {
  if (!state.fieldName) return null;
  return FIELDS[state.fieldName].hasStrength ? `${state.fieldName}:${state.strength}` : state.fieldName;
}

start().catch((failure) => {
  document.documentElement.dataset.state = 'failed';
  element('verdict').textContent = `The page could not begin: ${failure.message}`;
  throw failure;
});
