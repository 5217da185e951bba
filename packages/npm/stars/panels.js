// SPDX-License-Identifier: MIT
//
// Writes the text beside the picture: the scene, whether stars agree and a witness if not, the
// chosen site, the question, and the tier that decided.
import { axesOf, warpOf } from './plane.js';
import { StarSet } from './star_set.js';

const TIERS = [['semiStatic', 'doubles with an error bound'], ['interval', 'intervals'], ['exact', 'exact numbers']];
const BOUNDS = [5, 10, 15, 20];
const MOST_WITNESSES = 12;
const element = (id) => document.getElementById(id);
const short = (x) => String(Number(x.toPrecision(4)));

const counted = (n, word) => `${n} ${word}${n === 1 ? '' : 's'}`;

function made(name, text, properties = {}) {
  return Object.assign(document.createElement(name), { textContent: text, ...properties });
}
function row(title, ...cells) {
  const line = document.createElement('tr');
  line.append(made('th', title), ...cells.map((cell) => made('td', cell)));
  return line;
}

export class Panels {
  constructor(page) {
    Object.assign(this, page);
    this.SCENES.forEach(({ title, figure }, i) => element('scene').append(made('option', figure ? `${figure}  ${title}` : title, { value: i })));
    element('scene').append(made('option', 'Your polygon', { value: -1, hidden: true }));
    Object.entries(this.FIELDS).forEach(([name, { title, words }]) => element('field').append(made('option', `${title}: ${words}`, { value: name })));
  }

  showScene(state) {
    const { scene } = state, isRefinable = state.set.boundary !== null || scene.id === 'stars';
    element('scene').value = scene.id === 'yours' ? -1 : state.sceneAt;
    element('scene-words').textContent = scene.words;
    const show = (id, is) => { element(id).hidden = !is; };
    show('field-setting', state.fieldName !== null);
    show('strength-setting', state.fieldName !== null && this.FIELDS[state.fieldName].hasStrength);
    show('bound-setting', isRefinable);
    show('strategy-setting', isRefinable);
    show('kind-setting', state.set.boundary === null);
    if (state.fieldName) element('field').value = state.fieldName;
    element('strength').value = state.strength;
    element('strength-value').textContent = state.strength;
    element('bound').replaceChildren(...(scene.bounds ?? BOUNDS).map((b) => made('option', `${b}°`, { value: b })));
    element('bound').value = state.angleBound;
    element('strategy').value = state.strategy;
    document.querySelectorAll('input[name="kind"]').forEach((input) => { input.checked = (input.value === 'naive') === state.isNaive; });
    Object.entries(state.layers).forEach(([name, is]) => { element(`layer-${name}`).checked = is; });
  }

  show(p, isSettled, counts) {
    element('play').textContent = p.isPlaying ? 'Pause' : 'Play';
    element('draw').textContent = p.mode === 'draw' ? 'Close the polygon' : 'Draw a polygon';
    element('draw').setAttribute('aria-pressed', p.mode === 'draw');
    this.showAgreement(p, isSettled);
    this.showSite(p);
    this.showQuestion(p);
    this.showTiers(counts);
    this.showWarps(p);
  }

  showAgreement({ set, isNaive }, isSettled) {
    const verdict = element('verdict'), found = set.agreement(), { nameOf } = this;
    const wrong = found.halfEdges.length + found.disputed.length + found.gaps.length + found.unsettled.length;
    verdict.className = !isSettled ? '' : wrong ? 'dispute' : 'agree';
    const triangles = `${counted(found.triangles.length, 'triangle')} in the stars of all three corners`;
    verdict.textContent = !isSettled ? `${set.stale.size} stars are being made` : wrong
      ? `They disagree: ${counted(found.halfEdges.length, 'edge')} in one star only, ${counted(found.disputed.length, 'triangle')} disputed; ${triangles}.`
      : `All ${set.sites.length} ${isNaive ? 'naive stars' : 'stars'} agree: ${triangles}.`;
    const lines = [
      ...found.halfEdges.map(([v, w]) => [v, w, `Edge ${nameOf(v)} ${nameOf(w)} is in the star of ${nameOf(v)}, not in that of ${nameOf(w)}`]),
      ...found.disputed.map(({ where, missingIn }) => [where.find((v) => !missingIn.includes(v)), missingIn[0],
        `Triangle ${where.map(nameOf).join(' ')} is not in the star of ${missingIn.map(nameOf).join(', nor of ')}`]),
      ...found.gaps.map(([v, x]) => [v, x, `The star of ${nameOf(v)} has a gap of half a turn`]),
      ...found.unsettled.map((v) => [v, null, `The star of ${nameOf(v)} did not settle: neighbours replace each other in a circle`])];
    const items = (isSettled ? lines.slice(0, MOST_WITNESSES) : []).map(([v, w, words]) => {
      const item = document.createElement('li');
      item.append(made('button', words, { type: 'button', onclick: () => this.choose(v, w) }));
      return item;
    });
    if (lines.length > MOST_WITNESSES && isSettled) items.push(made('li', `and ${lines.length - MOST_WITNESSES} more`));
    element('witnesses').replaceChildren(...items);
  }

  showSite({ set, selected, other, fieldName }) {
    const { nameOf, choose } = this;
    if (selected === null || selected >= set.sites.length)
      return element('site').replaceChildren(made('p', 'None. Click one, or press N in the picture.', { className: 'soft' }));
    const [x, y, ...metric] = set.sites[selected], { long, short: width, angle } = axesOf(metric), { ring } = set.stars[selected];
    const table = document.createElement('table');
    table.append(row('site', `${nameOf(selected)}${this.isFixed(selected) ? ', on the border' : ''}`), row('place', `${short(x)}, ${short(y)}`),
                 row('circle', `${long < 1.0001 * width ? `${short(long)}, round` : `${short(long)} by ${short(width)}, at ${Math.round(angle * 180 / Math.PI)}°`}${fieldName ? ', as the field says' : ''}`));
    const neighbours = made('div', '', { className: 'neighbours' });
    ring.forEach((w) => {
      const isMutual = set.stars[w].ring.includes(selected);
      const button = made('button', nameOf(w), { type: 'button', className: isMutual ? '' : 'half', onclick: () => choose(selected, other === w ? null : w) });
      button.setAttribute('aria-pressed', w === other);
      button.setAttribute('aria-label', `Neighbour ${nameOf(w)}${isMutual ? '' : `, who does not have ${nameOf(selected)}`}`);
      neighbours.append(button);
    });
    return element('site').replaceChildren(table, made('p', 'Its star, counter-clockwise; choose one to ask about the two:', { className: 'soft' }), neighbours);
  }

  showQuestion({ set, selected, other, isNaive }) {
    const at = element('question'), { nameOf } = this;
    if (selected === null || other === null || other === selected || other >= set.sites.length)
      return at.replaceChildren(made('p', 'Choose a neighbour of the chosen site.', { className: 'soft' }));
    const parts = [];
    for (const [v, w] of [[selected, other], [other, selected]]) {
      const why = set.whyNeighbour(v, w), has = set.stars[v].ring.includes(w);
      if (!why) {
        parts.push(made('p', `${nameOf(v)} need not ask: nothing stands in the way of ${nameOf(w)}, or a side of the domain does.`));
        continue;
      }
      const tier = TIERS.find(([name]) => name === why.tier)?.[1] ?? why.tier;
      parts.push(made('p', `${nameOf(v)} asks whether ${nameOf(w)} belongs between ${nameOf(why.x)} and ${nameOf(why.y)}: ${why.answer ? 'yes' : 'no'}, by ${tier}.`));
      if (has !== why.answer) parts.push(made('p', 'The star is being made.', { className: 'soft' }));
      if (v === selected) parts.push(made('pre', `edge_test ${why.sites.flat().join(' ')}`, { title: 'For asterism eval: the same question, asked of the program' }));
    }
    if (isNaive) parts.push(made('p', `Naive: each asks as if all measured as it does.`, { className: 'soft' }));
    else {
      const isIn = (q) => set.predicates.inWedge(set.sites[selected], set.sites[other], q);
      parts.push(made('p', `The middle between the two is ${isIn([0, 1].map((k) => (set.sites[selected][k] + set.sites[other][k]) / 2)) ? '' : 'not '}in their wedge.`, { className: 'soft' }));
    }
    return at.replaceChildren(...parts);
  }

  showTiers(counts) {
    const total = TIERS.reduce((sum, [name]) => sum + counts[name], 0) || 1, bars = made('div', '', { className: 'bars' });
    TIERS.forEach(([name, title], k) => {
      const bar = document.createElement('i');
      bar.style.cssText = !counts[name] ? 'visibility:hidden' : `width:${Math.max(counts[name] ? 2 : 0, 100 * Math.sqrt(counts[name] / total))}%;background:var(--tier-${k})`;
      bars.append(made('span', title), bar, made('span', counts[name].toLocaleString('en')));
    });
    element('tiers').replaceChildren(made('p', `${total === 1 ? 'No' : total.toLocaleString('en')} edge tests in this scene, decided by`, { className: 'soft' }), bars);
  }

  // Draws the plane in the frame in which a site's circle is round, with all sites, and with their
  // Delaunay triangulation if they are few.
  showWarps({ set, selected, other, layers }) {
    const shown = layers.warp ? [selected, other].filter((v, i, all) => v !== null && v < set.sites.length && all.indexOf(v) === i) : [];
    const figures = shown.map((v) => {
      const figure = document.createElement('figure'), canvas = document.createElement('canvas');
      canvas.width = canvas.height = 340;
      figure.append(canvas, made('figcaption', `as ${this.nameOf(v)} sees them`));
      this.drawWarp(canvas, set, v);
      return figure;
    });
    element('warps').replaceChildren(...figures);
  }
  drawWarp(canvas, set, v) {
    const style = getComputedStyle(document.documentElement), colour = (name) => style.getPropertyValue(`--${name}`).trim();
    const [x, y, m11, m12, m22] = set.sites[v], warp = warpOf(m11, m12, m22), context = canvas.getContext('2d'), size = canvas.width;
    const places = set.sites.map((s) => warp(s[0] - x, s[1] - y));
    const reach = Math.max(...places.map(([px, py]) => Math.max(Math.abs(px), Math.abs(py)))), scale = 0.42 * size / reach;
    const at = ([px, py]) => [size / 2 + scale * px, size / 2 - scale * py];
    const line = (p, q) => { context.moveTo(...at(p)); context.lineTo(...at(q)); };
    const seen = new StarSet(set.predicates, set.sites.length <= 24 ? set.sites.map((s) => [s[0], s[1], m11, m12, m22]) : set.sites);
    seen.isNaive = true;
    if (set.sites.length > 24) seen.stale = new Set([v]);
    seen.settle();
    Object.assign(context, { lineWidth: 2, strokeStyle: colour('edge'), lineCap: 'round' });
    context.beginPath();
    seen.stars.forEach(({ ring }, u) => ring.forEach((w) => { if (u < w || u === v) line(places[u], places[w]); }));
    context.stroke();
    Object.assign(context, { lineWidth: 4.5, strokeStyle: colour('accent') });
    context.beginPath();
    seen.stars[v].ring.forEach((w) => line(places[v], places[w]));
    context.stroke();
    context.beginPath();
    context.arc(size / 2, size / 2, Math.min(scale * 0.5, size / 5), 0, 2 * Math.PI);
    Object.assign(context, { lineWidth: 2, strokeStyle: colour('arc') });
    context.stroke();
    context.font = 'italic 600 26px Palatino, Georgia, serif';
    places.forEach((place, u) => {
      const [px, py] = at(place);
      context.beginPath();
      context.arc(px, py, u === v ? 8 : 5.5, 0, 2 * Math.PI);
      context.fillStyle = colour(u === v ? 'accent' : 'site');
      context.fill();
      if (places.length <= 24) {
        context.fillStyle = colour('ink');
        context.fillText(this.nameOf(u), Math.min(px + 10, size - 22), Math.max(py - 9, 24));
      }
    });
  }
}
