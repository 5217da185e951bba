// SPDX-License-Identifier: MIT
//
// Draws sites, stars, cells, arcs and wedges on a canvas. Decides nothing.
import { axesOf, bisectorAlong, visibleArc, wedgeWithin, squaredLength, leastAngle } from './plane.js';
import { Diagram, paletteOf } from './diagram.js';

const COLOURS = ['paper', 'card', 'ink', 'soft', 'line', 'edge', 'accent', 'agree', 'agree-fill', 'dispute', 'dispute-fill',
                 'arc', 'wedge', 'wedge-line', 'good', 'site', 'ellipse', 'field', 'tier-0', 'tier-1', 'tier-2'];
const TIERS = ['semiStatic', 'interval', 'exact'];

export class View {
  constructor(canvas) {
    this.canvas = canvas;
    this.context = canvas.getContext('2d');
    this.centre = [0, 0];
    this.scale = 100;  // page pixels per unit
    this.diagram = new Diagram();
    this.readColours();
    this.resize();
  }

  readColours() {
    const style = getComputedStyle(document.documentElement);
    this.colours = Object.fromEntries(COLOURS.map((name) => [name, style.getPropertyValue(`--${name}`).trim()]));
    this.isDark = style.colorScheme === 'dark' || (style.colorScheme !== 'light' && matchMedia('(prefers-color-scheme: dark)').matches);
    this.palette = paletteOf(this.isDark);
    this.hatch = null;
  }
  resize() {
    const { width, height } = this.canvas.getBoundingClientRect();
    this.width = Math.max(1, Math.round(width));
    this.height = Math.max(1, Math.round(height));
    this.ratio = Math.min(window.devicePixelRatio || 1, 2);
    this.canvas.width = Math.round(this.width * this.ratio);
    this.canvas.height = Math.round(this.height * this.ratio);
  }
  /** The whole of a box in sight. */
  show([left, bottom, right, top]) {
    this.centre = [(left + right) / 2, (bottom + top) / 2];
    this.scale = 0.9 * Math.min(this.width / (right - left), this.height / (top - bottom));
  }
  toPage(x, y) { return [this.width / 2 + (x - this.centre[0]) * this.scale, this.height / 2 - (y - this.centre[1]) * this.scale]; }
  toPlane(x, y) { return [this.centre[0] + (x - this.width / 2) / this.scale, this.centre[1] - (y - this.height / 2) / this.scale]; }
  zoomAt(x, y, factor) {
    const [px, py] = this.toPlane(x, y);
    this.scale = Math.max(20, Math.min(1e5, this.scale * factor));
    this.centre = [px - (x - this.width / 2) / this.scale, py + (y - this.height / 2) / this.scale];
  }

  // --- Paths.

  trace(points, isClosed = false) {
    const { context } = this;
    points.forEach(([x, y], i) => {
      const [px, py] = this.toPage(x, y);
      if (i === 0) context.moveTo(px, py);
      else context.lineTo(px, py);
    });
    if (isClosed) context.closePath();
  }
  ellipse([x, y, ...metric], size) {
    const { long, short, angle } = axesOf(metric), [px, py] = this.toPage(x, y);
    this.context.moveTo(px + size * long * this.scale * Math.cos(angle), py - size * long * this.scale * Math.sin(angle));
    this.context.ellipse(px, py, size * long * this.scale, size * short * this.scale, -angle, 0, 2 * Math.PI);
  }
  stroke(colour, width, dash = []) {
    Object.assign(this.context, { strokeStyle: colour, lineWidth: width });
    this.context.setLineDash(dash);
    this.context.stroke();
    this.context.setLineDash([]);
  }
  fill(colour) {
    this.context.fillStyle = colour;
    this.context.fill();
  }
  path(draw) {
    this.context.beginPath();
    draw();
  }
  dots(places, radius) {
    for (const [x, y] of places) {
      const [px, py] = this.toPage(x, y);
      this.context.moveTo(px + radius, py);
      this.context.arc(px, py, radius, 0, 2 * Math.PI);
    }
  }
  hatching() {
    if (this.hatch) return this.hatch;
    const tile = document.createElement('canvas'), context = tile.getContext('2d');
    tile.width = tile.height = 8;
    Object.assign(context, { strokeStyle: this.colours.dispute, globalAlpha: 0.55, lineWidth: 1.4 });
    for (const shift of [-8, 0, 8]) {
      context.moveTo(shift, 8);
      context.lineTo(shift + 8, 0);
    }
    context.stroke();
    return this.hatch = this.context.createPattern(tile, 'repeat');
  }

  // --- The whole picture. picture() of main.js describes `p`.

  draw(p) {
    const { context, colours } = this;
    context.setTransform(this.ratio, 0, 0, this.ratio, 0, 0);
    context.fillStyle = colours.card;
    context.fillRect(0, 0, this.width, this.height);
    context.lineJoin = context.lineCap = 'round';
    if (p.layers.diagram) this.drawDiagram(p);
    if (p.layers.field && p.field) this.drawField(p);
    if (p.mesh) this.drawMesh(p.mesh);
    else this.drawStars(p);
    if (p.marks) this.drawMarks(p);
    if (p.polygon) this.drawPolygon(p.polygon);
    if (!p.mesh) this.drawSites(p);
  }

  drawDiagram({ set }) {
    this.diagram.ask(set.sites, this, set.version, this.palette);
    this.context.imageSmoothingEnabled = true;
    const { canvas, pixel } = this.diagram;
    this.context.drawImage(canvas, 0, 0, canvas.width * pixel, canvas.height * pixel);
  }

  drawField({ field, box }) {
    const [left, bottom, right, top] = box, count = 9, size = 0.42 * (right - left) / count;
    this.path(() => {
      for (let i = 0; i < count; ++i)
        for (let k = 0; k < count; ++k) {
          const x = left + (i + 0.5) * (right - left) / count, y = bottom + (k + 0.5) * (top - bottom) / count;
          this.ellipse([x, y, ...field(x, y)], size);
        }
    });
    this.fill(this.colours.field.replace(/..$/, '2a'));
    this.stroke(this.colours.field, 1.2);
  }

  drawStars(p) {
    const { set, layers } = p, { sites } = set, { colours } = this, agreed = set.agreement();
    this.path(() => agreed.triangles.forEach((t) => this.trace(t.map((v) => sites[v]), true)));
    if (!layers.diagram) this.fill(colours['agree-fill']);
    if (agreed.disputed.length) {
      this.path(() => agreed.disputed.forEach(({ where }) => this.trace(where.map((v) => sites[v]), true)));
      this.fill(colours['dispute-fill']);
      this.fill(this.hatching());
    }
    if (layers.cell && p.selected !== null) this.drawCell(p);
    if (layers.wedge && p.selected !== null && p.other !== null) this.drawWedge(p);
    this.drawEdges(p, agreed);
    if (p.selected !== null) this.drawChosenStar(p);
    if (layers.wedge && p.selected !== null && p.other !== null) this.drawArc(p);
  }

  // Each star draws its half of an edge, up to the bisector, so that an edge in one star only has
  // one half.
  drawEdges({ set, layers, tiers }, agreed) {
    const { sites } = set, { colours } = this, width = sites.length > 120 ? 1 : 1.5, byTier = [[], [], []];
    const middle = (v, w) => {
      const p = sites[v], q = sites[w], dx = q[0] - p[0], dy = q[1] - p[1];
      const fromV = Math.sqrt(squaredLength(p, dx, dy)), fromW = Math.sqrt(squaredLength(q, dx, dy)), t = fromW / (fromV + fromW);
      return [p[0] + t * dx, p[1] + t * dy];
    };
    this.path(() => set.stars.forEach(({ ring }, v) => ring.forEach((w) => {
      const tier = layers.tiers && tiers ? tiers.get(v * 65536 + w) : undefined;
      if (tier) byTier[TIERS.indexOf(tier)].push([v, w]);
      else if (v < w && set.stars[w].ring.includes(v)) this.trace([sites[v], sites[w]]);
    })));
    this.stroke(colours.edge, width);
    byTier.forEach((pairs, k) => {
      this.path(() => pairs.forEach(([v, w]) => this.trace([sites[v], middle(v, w)])));
      this.stroke(colours[`tier-${k}`], k === 0 ? width : width + 1.2);
    });
    if (!agreed.halfEdges.length) return;
    this.path(() => agreed.halfEdges.forEach(([v, w]) => this.trace([sites[v], middle(v, w)])));
    this.stroke(colours.dispute, width + 1.3);
    this.path(() => agreed.halfEdges.forEach(([v, w]) => this.trace([middle(v, w), sites[w]])));
    this.stroke(colours.dispute, 1, [2, 5]);
  }

  drawChosenStar({ set, selected, other }) {
    const { sites } = set, { colours } = this, { ring } = set.stars[selected];
    this.path(() => [...set.trianglesOf(selected)].forEach((t) => this.trace(t.map((v) => sites[v]), true)));
    this.context.globalAlpha = 0.13;
    this.fill(colours.accent);
    this.context.globalAlpha = 1;
    this.path(() => ring.forEach((w) => this.trace([sites[selected], sites[w]])));
    this.stroke(colours.accent, 2.4);
    if (!ring.includes(other)) return;
    this.path(() => this.trace([sites[selected], sites[other]]));
    this.stroke(colours.good, 4);
  }

  // Draws the cell that the star implies: along each ray up to the first bisector with a neighbour,
  // open beyond sight.
  drawCell({ set, selected, other }) {
    const { sites } = set, v = sites[selected], { ring } = set.stars[selected], count = 360;
    if (ring.length === 0) return;
    const reach = 2 * Math.hypot(this.width, this.height) / this.scale, pieces = [];
    const outline = [];
    let last = null;
    for (let i = 0; i <= count; ++i) {
      const angle = 2 * Math.PI * i / count, ux = Math.cos(angle), uy = Math.sin(angle);
      let least = reach, by = null;
      for (const w of ring) {
        const t = bisectorAlong(v, sites[w], ux, uy);
        if (t < least) least = t, by = w;
      }
      const at = [v[0] + least * ux, v[1] + least * uy];
      outline.push(at);
      if (last && by !== null && last.by === by) last.points.push(at);
      else {
        if (last && by !== null && last.by !== null) last.points.push(at);
        pieces.push(last = { by, points: [at] });
      }
    }
    const { context, colours } = this;
    this.path(() => this.trace(outline, true));
    context.globalAlpha = 0.14;
    this.fill(colours.arc);
    context.globalAlpha = 1;
    this.path(() => pieces.forEach(({ by, points }) => { if (by !== null && by !== other) this.trace(points); }));
    this.stroke(colours.arc, 2);
    this.path(() => pieces.forEach(({ by, points }) => { if (by !== null && by === other) this.trace(points); }));
    this.stroke(colours.arc, 3.5);
  }

  sightBox() {
    const [left, top] = this.toPlane(-10, -10), [right, bottom] = this.toPlane(this.width + 10, this.height + 10);
    return [[left, bottom], [right, bottom], [right, top], [left, top]];
  }
  drawWedge({ set, selected, other }) {
    const wedge = wedgeWithin(this.sightBox(), set.sites[selected], set.sites[other]);
    this.path(() => this.trace(wedge, true));
    this.fill(this.colours.wedge);
    this.stroke(this.colours['wedge-line'], 1.2, [7, 4]);
  }
  // Draws the arc that both ends see, and the part that both dominate over the neighbours beside.
  drawArc({ set, selected, other, why, isGood }) {
    const v = set.sites[selected], w = set.sites[other], pieces = visibleArc(v, w, 400);
    this.path(() => pieces.forEach((piece) => this.trace(piece)));
    this.stroke(this.colours.arc, 2.2);
    if (!why) return;
    this.path(() => pieces.forEach((piece) => {
      let good = [];
      for (const at of piece) {
        if (isGood(at)) good.push(at);
        else {
          if (good.length > 1) this.trace(good);
          good = [];
        }
      }
      if (good.length > 1) this.trace(good);
    }));
    this.stroke(this.colours.good, 6);
  }

  drawSites(p) {
    const { set, selected, other, layers, names, fixed } = p, { sites } = set, { colours, context } = this;
    const isSmall = sites.length > 120, radius = isSmall ? 2.4 : 4;
    if (layers.ellipses) {
      const shown = p.ellipsesOf ? p.ellipsesOf.filter((v) => v < sites.length) : [...sites.keys()];
      this.path(() => shown.forEach((v) => this.ellipse(sites[v], p.ellipseScale)));
      this.stroke(colours.ellipse, 1.4);
    }
    if (selected !== null && (layers.ellipses || p.handles)) {
      this.path(() => this.ellipse(sites[selected], p.ellipseScale));
      this.stroke(colours.accent, 2);
      for (const [x, y] of p.handles ?? []) {
        const [px, py] = this.toPage(x, y);
        this.path(() => context.rect(px - 5, py - 5, 10, 10));
        this.fill(colours.card);
        this.stroke(colours.accent, 2);
      }
    }
    this.path(() => this.dots(sites.filter((_, v) => v !== selected && !fixed(v)), radius));
    this.fill(colours.site);
    this.path(() => sites.forEach(([x, y], v) => {
      if (!fixed(v)) return;
      const [px, py] = this.toPage(x, y), half = radius - 1;
      context.rect(px - half, py - half, 2 * half, 2 * half);
    }));
    this.fill(colours.edge);
    if (other !== null && other < sites.length) {
      this.path(() => this.dots([sites[other]], radius + 2.5));
      this.fill(colours.good);
    }
    if (selected !== null) {
      this.path(() => this.dots([sites[selected]], radius + 3));
      this.fill(colours.accent);
      this.stroke(colours.card, 2);
    }
    this.drawNames(p, names);
  }
  drawNames({ set, selected, other }, names) {
    const { context, colours } = this;
    context.font = 'italic 600 19px "Iowan Old Style", Palatino, Georgia, serif';
    const shown = names ? [...set.sites.keys()] : [selected, other].filter((v) => v !== null);
    if (!names) context.font = '600 12px system-ui, sans-serif';
    context.fillStyle = colours.ink;
    Object.assign(context, { strokeStyle: colours.card, lineWidth: 4 });
    for (const v of shown) {
      if (!set.sites[v]) continue;
      const [px, py] = this.toPage(set.sites[v][0], set.sites[v][1]), text = names?.[v] ?? String(v + 1);
      context.strokeText(text, px + 9, py - 9);
      context.fillText(text, px + 9, py - 9);
    }
  }

  drawPolygon({ points, isClosed, cursor }) {
    this.path(() => this.trace(isClosed || !cursor ? points : [...points, cursor], isClosed));
    this.stroke(this.colours.ink, isClosed ? 2.2 : 1.8, isClosed ? [] : [6, 4]);
    if (isClosed) return;
    this.path(() => this.dots(points, 4.5));
    this.fill(this.colours.accent);
  }

  // Marks what the last step of refinement tested, and its new site with a growing ring.
  drawMarks({ set, marks, age }) {
    const { sites } = set, { colours, context } = this;
    if (marks.triangle?.every((v) => v < sites.length)) {
      this.path(() => this.trace(marks.triangle.map((v) => sites[v]), true));
      this.stroke(colours.dispute, 3);
    }
    if (marks.side) {
      this.path(() => this.trace(marks.side.map((v) => sites[v])));
      this.stroke(colours.good, 4);
    }
    for (const { at } of marks.tried ?? []) {
      const [px, py] = this.toPage(...at);
      this.path(() => [[1, 1], [1, -1]].forEach(([dx, dy]) => {
        context.moveTo(px - 4 * dx, py - 4 * dy);
        context.lineTo(px + 4 * dx, py + 4 * dy);
      }));
      this.stroke(colours.soft, 1.5);
    }
    if (marks.site === undefined || !sites[marks.site]) return;
    context.globalAlpha = Math.max(0.25, 1 - age);
    this.path(() => this.dots([sites[marks.site]], 7 + 26 * Math.min(1, age)));
    this.stroke(colours.good, 3);
    context.globalAlpha = 1;
    this.path(() => this.dots([sites[marks.site]], 7));
    this.stroke(colours.good, 2.5);
  }

  // Draws a finished mesh, given as arrays of sites (five numbers) and triangles, coloured by the
  // least angle.
  drawMesh({ sites, triangles, shades }) {
    const { context, colours } = this, count = triangles.length / 3;
    const [left, top] = this.toPlane(0, 0), [right, bottom] = this.toPlane(this.width, this.height);
    const shown = [];
    for (let t = 0; t < count; ++t) {
      let [x0, x1, y0, y1] = [Infinity, -Infinity, Infinity, -Infinity];
      for (let k = 0; k < 3; ++k) {
        const v = 5 * triangles[3 * t + k];
        x0 = Math.min(x0, sites[v]), x1 = Math.max(x1, sites[v]), y0 = Math.min(y0, sites[v + 1]), y1 = Math.max(y1, sites[v + 1]);
      }
      if (x1 >= left && x0 <= right && y1 >= bottom && y0 <= top) shown.push(t);
    }
    const corners = (t) => [0, 1, 2].map((k) => sites.subarray(5 * triangles[3 * t + k], 5 * triangles[3 * t + k] + 2));
    for (let shade = 0; shade < 6; ++shade) {
      this.path(() => shown.forEach((t) => { if (shades[t] === shade) this.trace(corners(t), true); }));
      context.globalAlpha = 0.07 + 0.085 * shade;
      this.fill(colours.agree);
      context.globalAlpha = 1;
    }
    this.path(() => shown.forEach((t) => this.trace(corners(t), true)));
    this.stroke(colours.edge, shown.length > 4000 ? 0.35 : 0.8);
  }
}

/** Of each triangle, from 0 (low) to 5, its least angle by ten degrees. */
export function shadesOf(sites, triangles) {
  const shades = new Uint8Array(triangles.length / 3);
  for (let t = 0; t < shades.length; ++t) {
    const three = [0, 1, 2].map((k) => sites.subarray(5 * triangles[3 * t + k], 5 * triangles[3 * t + k] + 5));
    shades[t] = Math.min(5, Math.floor(leastAngle(three).degrees / 10));
  }
  return shades;
}
