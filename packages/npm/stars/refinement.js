// SPDX-License-Identifier: MIT
//
// The thesis's refinement (chapter 4), a step at a time, each step with words and marks for whoever watches:
// encroached sides are split, then a site is added for the worst triangle. Places are proposed in doubles;
// inside, encroachment and stars are exact questions to the predicates. Nothing proves that it ends.
import { squaredDistance, squaredLength, voronoiVertices, wedgeExits, leastAngle, randomFrom, warpOf } from './plane.js';

const STRATEGIES = { arcs: 'Voronoi arcs', darts: 'Poisson darts' };
const MOST_REJECTED = 100;  // failed darts in a row, after which sites may be nearer

export class Refinement {
  /** `field(x, y)` is the metric m11, m12, m22 at a place. */
  constructor(set, field, { angleBound, strategy = 'arcs', mostSites = 1200, seed = 1, name = String }) {
    Object.assign(this, { set, field, angleBound, strategy, mostSites, name });
    this.random = randomFrom(seed);
    this.sides = null;  // unknown
    this.newSites = [];
    this.newSides = [];
    this.spacing = this.firstSpacing();
    this.finest = this.spacing / 1024;
    this.steps = 0;
  }

  siteAt(x, y) { return [x, y, ...this.field(x, y)]; }

  // Least distance of sites: a part of the shortest distance in the mesh, halved when nothing else
  // helps.
  firstSpacing() {
    const { sites } = this.set, nearest = sites.map((s, v) => Math.min(
      ...sites.map((o, w) => v === w ? Infinity : Math.min(squaredDistance(s, o[0], o[1]), squaredDistance(o, s[0], s[1])))));
    nearest.sort((a, b) => a - b);
    return Math.sqrt(this.strategy === 'darts' ? nearest[nearest.length >> 1] / 4 : nearest[0] / 25);
  }

  /** Every bad triangle, the worst first: disputed ones, half turns, then low angles. */
  badTriangles() {
    const { set } = this, found = set.agreement(), bad = [];
    for (const { where, missingIn } of found.disputed) bad.push({ where, missingIn, rank: 0, degrees: 0 });
    for (const where of found.gaps) bad.push({ where, rank: 1, degrees: 0, isGap: true });
    for (const where of found.triangles) {
      const { degrees, corner } = leastAngle(where.map((v) => set.sites[v]));
      if (degrees >= this.angleBound) continue;
      // An angle between two sides at a corner of the domain cannot be improved.
      const v = where[corner];
      if (set.next.get(v) === where[(corner + 1) % 3] && set.previous.get(v) === where[(corner + 2) % 3]) continue;
      bad.push({ where, rank: 2, degrees });
    }
    return bad.sort((a, b) => a.rank - b.rank || a.degrees - b.degrees ||
      a.where[0] - b.where[0] || a.where[1] - b.where[1] || a.where[2] - b.where[2]);
  }

  encroaches(a, b, w) {
    const { set } = this, { sites } = set;
    return w !== a && w !== b && set.turn(a, b, w) > 0 && set.predicates.encroaches(sites[a], sites[b], sites[w]) &&
      (set.isConvex || set.sees(a, w) || set.sees(b, w));
  }
  encroachesAt(a, b, s) {
    const { set } = this, { sites } = set;
    return set.turnAt(a, b, s[0], s[1]) > 0 && set.predicates.encroaches(sites[a], sites[b], s);
  }

  /** A side that some site encroaches on; each pair is asked once. */
  encroachedSide() {
    const { set } = this;
    if (!this.sides) this.sides = [...set.next].map(([a, b]) => ({ a, b, asked: 0 }));
    for (const side of this.sides) {
      while (side.asked < set.sites.length) {
        const w = side.asked++;
        if (this.encroaches(side.a, side.b, w) && this.mayDivide(side)) return { side, w };
      }
    }
    return null;
  }
  mayDivide({ a, b }) {
    const { sites } = this.set;
    return squaredDistance(sites[a], sites[b][0], sites[b][1]) > 4 * this.finest ** 2 &&
      squaredDistance(sites[b], sites[a][0], sites[a][1]) > 4 * this.finest ** 2;
  }
  // Returns the point in which the side meets the bisector of its ends.
  middleOf({ a, b }) {
    const p = this.set.sites[a], q = this.set.sites[b], dx = q[0] - p[0], dy = q[1] - p[1];
    const fromA = Math.sqrt(squaredLength(p, dx, dy)), fromB = Math.sqrt(squaredLength(q, dx, dy)), t = fromB / (fromA + fromB);
    return this.siteAt(p[0] + t * dx, p[1] + t * dy);
  }
  divide(side) {
    const { a, b } = side, m = this.set.divide(a, b, this.middleOf(side));
    side.b = m, side.asked = 0;
    this.sides.push({ a: m, b, asked: 0 });
    return m;
  }

  // True if the site is farther than the spacing from all others, in both metrics.
  isFar(s) {
    const least = this.spacing ** 2;
    return this.set.sites.every((o) => squaredDistance(o, s[0], s[1]) > least && squaredDistance(s, o[0], o[1]) > least);
  }

  /** What came of a place: 'added', or why not. */
  tryPlace([x, y]) {
    if (!Number.isFinite(x) || !Number.isFinite(y) || !this.set.isInside(x, y)) return { what: 'outside' };
    const s = this.siteAt(x, y);
    if (!this.isFar(s)) return { what: 'near' };
    const encroached = this.sides.filter((side) => this.encroachesAt(side.a, side.b, s));
    if (encroached.length === 0) return { what: 'added', site: this.set.add(s) };
    const divided = encroached.find((side) => this.mayDivide(side));
    if (!divided) return { what: 'near' };
    const { a, b } = divided;
    return { what: 'divided', side: [a, b], site: this.divide(divided) };
  }

  placesFor({ where }) {
    const [p, q, r] = where.map((v) => this.set.sites[v]), isProper = new Set(where).size === 3;
    const vertices = isProper ? voronoiVertices(p, q, r) : [], exits = [];
    for (const [v, w] of [[p, q], [q, r], [r, p]]) if (v !== w) exits.push(...wedgeExits(v, w));
    return [...vertices.map((at) => ({ at, kind: 'a Voronoi vertex of the three' })),
            ...exits.map((at) => ({ at, kind: 'where a Voronoi arc leaves its wedge' }))];
  }
  dartAt({ where }) {
    const corners = where.map((v) => this.set.sites[v]), mean = [0, 1, 2, 3, 4].map((k) => (corners[0][k] + corners[1][k] + corners[2][k]) / 3);
    const farthest = Math.max(...corners.map((s) => squaredDistance(mean, s[0], s[1])));
    const radius = 1.5 * Math.sqrt(farthest * this.random()), turn = 2 * Math.PI * this.random();
    // The inverse of F maps a circle to the mean metric's unit ellipse.
    const f = warpOf(mean[2], mean[3], mean[4]), [f11] = f(1, 0), [f12, f22] = f(0, 1);
    const y = radius * Math.sin(turn) / f22, x = (radius * Math.cos(turn) - f12 * y) / f11;
    return { at: [mean[0] + x, mean[1] + y], kind: 'a dart' };
  }

  triangleWords({ where, missingIn, isGap, degrees }) {
    const names = where.map(this.name);
    if (isGap) return `The star of ${names[0]} has a gap of half a turn`;
    if (missingIn) return `Triangle ${names.join(' ')} is not in the star of ${missingIn.map(this.name).join(', nor of ')}`;
    return `Triangle ${names.join(' ')} has an angle of ${degrees.toFixed(1)}°`;
  }

  /** Makes stars of all sites, then does the next thing. Returns what it did: kind 'split', 'added', 'nearer',
   * 'done' or 'stuck', with words, and marks for the picture. */
  step() {
    const { set } = this;
    set.settle();
    ++this.steps;
    if (set.sites.length >= this.mostSites)
      return { kind: 'stuck', words: `Ended at ${set.sites.length} sites. The thesis does not promise an end, and here there is none in sight.` };
    const encroached = this.encroachedSide();
    if (encroached) {
      const { side, w } = encroached, words = `Side ${this.name(side.a)} ${this.name(side.b)} is encroached on by ${this.name(w)}: its cell reaches the side. Split where its ends are as near.`;
      const marks = { side: [side.a, side.b], by: w };
      return { kind: 'split', words, marks: { ...marks, site: this.divide(side) } };
    }
    const bad = this.badTriangles();
    if (bad.length === 0) {
      const { triangles } = set.agreement();
      return { kind: 'done', words: `All stars agree and no angle is below ${this.angleBound}°: ${set.sites.length} sites, ${triangles.length} triangles, ${this.steps - 1} steps.` };
    }
    return this.strategy === 'darts' ? this.throwDarts(bad) : this.tryArcs(bad);
  }

  report(triangle, kind, outcome, tried) {
    const marks = { triangle: triangle.where, site: outcome.site, tried, side: outcome.side };
    const begin = this.triangleWords(triangle);
    return outcome.what === 'added'
      ? { kind: 'added', words: `${begin}. A site goes to ${kind}.`, marks }
      : { kind: 'split', words: `${begin}. A site at ${kind} would encroach on side ${outcome.side.map(this.name).join(' ')}, which is split instead.`, marks };
  }

  tryArcs(bad) {
    for (const triangle of bad) {
      const tried = [];
      for (const { at, kind } of this.placesFor(triangle)) {
        const outcome = this.tryPlace(at);
        if (outcome.what === 'added' || outcome.what === 'divided') return this.report(triangle, kind, outcome, tried);
        tried.push({ at, why: outcome.what });
      }
    }
    return this.comeNearer(bad[0], `No place for any of ${bad.length} bad triangles is far enough from all sites.`, 0.5);
  }
  throwDarts(bad) {
    const tried = [];
    while (tried.length < MOST_REJECTED) {
      const triangle = bad[tried.length % bad.length], { at, kind } = this.dartAt(triangle), outcome = this.tryPlace(at);
      if (outcome.what === 'added' || outcome.what === 'divided')
        return this.report(triangle, tried.length ? `${kind}, after ${tried.length} rejected` : kind, outcome, tried);
      tried.push({ at, why: outcome.what });
    }
    return { ...this.comeNearer(bad[0], `${MOST_REJECTED} darts in a row were rejected.`, 0.8) };
  }
  comeNearer(triangle, why, factor) {
    if (this.spacing <= this.finest) return { kind: 'stuck', words: `${why} Stuck: the thesis's heuristic has no guarantee.`, marks: { triangle: triangle.where } };
    this.spacing = Math.max(this.finest, factor * this.spacing);
    return { kind: 'nearer', words: `${why} Sites may be nearer to each other now: ${this.spacing.toPrecision(2)}.`, marks: { triangle: triangle.where } };
  }
}

export { STRATEGIES };
