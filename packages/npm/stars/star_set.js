// SPDX-License-Identifier: MIT
//
// The stars of sites (the thesis, section 3.3), each made by its own site alone. Every sign is the predicates':
// orientations exact, the edge test exact, its ties broken alike from every side. Indices are those of `sites`.

/** Stars of sites that stand freely in the plane, or in a polygon whose corners and divided sides are sites. */
export class StarSet {
  /** `boundary` lists the sites along the polygon's border, counter-clockwise; null where there is none. */
  constructor(predicates, sites, boundary = null) {
    this.predicates = predicates;
    this.sites = sites.map((s) => [...s]);
    this.isNaive = false;
    this.setBoundary(boundary);
    this.makeAllAnew();
  }

  setBoundary(boundary) {
    this.boundary = boundary;
    this.next = new Map();
    this.previous = new Map();
    boundary?.forEach((v, i) => {
      const w = boundary[(i + 1) % boundary.length];
      this.next.set(v, w);
      this.previous.set(w, v);
    });
    this.isConvex = !boundary || boundary.every((v) => this.turn(this.previous.get(v), v, this.next.get(v)) >= 0);
  }

  makeAllAnew() {
    this.stars = this.sites.map(() => ({ ring: [], isClosed: true, isSettled: false }));
    this.stale = new Set(this.sites.keys());
    this.version = (this.version ?? 0) + 1;
  }

  // Returns 1 where u, v, w are counter-clockwise. orient2d has y downwards.
  turn(u, v, w) {
    const { sites } = this, a = sites[u], b = sites[v], c = sites[w];
    return -Math.sign(this.predicates.orient2d(a[0], a[1], b[0], b[1], c[0], c[1]));
  }
  turnAt(u, v, x, y) {
    const a = this.sites[u], b = this.sites[v];
    return -Math.sign(this.predicates.orient2d(a[0], a[1], b[0], b[1], x, y));
  }

  /** The four sites of the question whether w stands in the star of v between x and y. Naive stars ask it as if
   * all measured as v does: what is Delaunay in the plane where v's circles are round. */
  question(v, w, x, y) {
    const { sites } = this, centre = sites[v];
    const seen = (u) => this.isNaive ? [sites[u][0], sites[u][1], centre[2], centre[3], centre[4]] : sites[u];
    return [centre, seen(w), seen(x), seen(y)];
  }
  edgeTest(v, w, x, y) {
    if (this.isNaive) return this.predicates.edgeTest(...this.question(v, w, x, y));
    const { sites } = this;
    return this.predicates.edgeTest(sites[v], sites[w], sites[x], sites[y]);
  }

  isSubsegment(v, w) { return this.next.get(v) === w || this.next.get(w) === v; }

  /** True if nothing of the border is between v and w. Convex domains hide nothing. */
  sees(v, w) {
    if (this.isConvex || this.isSubsegment(v, w)) return true;
    for (const [a, b] of this.next) {
      if (a === v || a === w || b === v || b === w) continue;
      const ofA = this.turn(v, w, a), ofB = this.turn(v, w, b);
      if (ofA === 0 && ofB === 0) {
        if (this.isBetween(v, a, w) || this.isBetween(v, b, w)) return false;
      } else if (ofA * ofB <= 0 && this.turn(a, b, v) * this.turn(a, b, w) <= 0) return false;
    }
    // No border vertex next to v or w may be in the open segment from v to w.
    return [v, w].every((at) => [this.next.get(at), this.previous.get(at)].every((u) =>
      u === undefined || u === v || u === w || this.turn(v, w, u) !== 0 || !this.isBetween(v, u, w)));
  }
  // True if u, on the line of v and w, lies between them.
  isBetween(v, u, w) {
    const { sites } = this, k = sites[v][0] !== sites[w][0] ? 0 : 1;
    return (sites[v][k] < sites[u][k]) === (sites[u][k] < sites[w][k]);
  }
  // True if u and w, collinear with v, are in the same direction from it.
  isOneWay(v, u, w) {
    const { sites } = this, k = sites[v][0] !== sites[u][0] ? 0 : 1;
    return (sites[v][k] < sites[u][k]) === (sites[v][k] < sites[w][k]);
  }

  /** Exact: true if the place is strictly within the polygon. */
  isInside(x, y) {
    let isIn = false;
    for (const [a, b] of this.next) {
      const p = this.sites[a], q = this.sites[b], turn = this.turnAt(a, b, x, y);
      const isInBox = Math.min(p[0], q[0]) <= x && x <= Math.max(p[0], q[0]) && Math.min(p[1], q[1]) <= y && y <= Math.max(p[1], q[1]);
      if (turn === 0 && isInBox) return false;
      if ((p[1] <= y) !== (q[1] <= y) && turn > 0 === q[1] > p[1]) isIn = !isIn;
    }
    return isIn;
  }
  emptyStar(v) {
    if (!this.next.has(v)) return { ring: [], isClosed: true, isSettled: false };
    return { ring: [this.next.get(v), this.previous.get(v)], isClosed: false, isSettled: false };
  }
  isForced(star, i) { return !star.isClosed && (i === 0 || i === star.ring.length - 1); }

  /** Where w would stand: { ray } on that of a neighbour, { gap } after a neighbour, or null outside. */
  locate(v, star, w) {
    const { ring } = star, count = ring.length;
    if (count === 0) return { gap: 0 };
    const side = new Array(count);
    for (let i = 0; i < count; ++i) {
      side[i] = this.turn(v, ring[i], w);
      if (side[i] === 0 && this.isOneWay(v, ring[i], w)) return { ray: i };
    }
    if (count === 1) return { gap: 0 };
    for (let i = 0; i < (star.isClosed ? count : count - 1); ++i) {
      const k = (i + 1) % count, turn = this.turn(v, ring[i], ring[k]);
      const isIn = turn > 0 ? side[i] > 0 && side[k] < 0 : turn < 0 ? side[i] > 0 || side[k] < 0 : side[i] > 0;
      if (isIn) return { gap: i };
    }
    return null;
  }

  /** INSERTIONTEST for w beyond or within the triangle of v and two neighbours, the second counter-clockwise. */
  accepts(v, w, x, y) {
    if (x === y || this.turn(v, x, y) <= 0) return true;
    if (this.turn(x, y, w) > 0) return true;
    if (this.isSubsegment(x, y)) return false;
    return this.edgeTest(v, w, x, y);
  }
  before(star, i) { return (i + star.ring.length - 1) % star.ring.length; }
  after(star, i) { return (i + 1) % star.ring.length; }
  stands(v, star, i) {
    const { ring } = star;
    if (this.isForced(star, i) || ring.length < 2) return true;
    return this.accepts(v, ring[i], ring[this.before(star, i)], ring[this.after(star, i)]);
  }

  removeBeside(v, star, w) {
    for (const step of [this.after, this.before])
      for (;;) {
        const i = step(star, star.ring.indexOf(w));
        if (star.ring[i] === w || this.stands(v, star, i)) break;
        star.ring.splice(i, 1);
      }
  }
  // Returns true if the star has changed.
  offer(v, star, w) {
    let where = this.locate(v, star, w), hasChanged = false;
    if (!where) return false;
    if (where.ray !== undefined) {
      const u = star.ring[where.ray];
      if (u === w || this.isForced(star, where.ray) || !this.isBetween(v, w, u)) return false;
      star.ring.splice(where.ray, 1);
      hasChanged = true;
      where = { gap: star.ring.length ? this.before(star, where.ray % star.ring.length) : 0 };
    }
    const { ring } = star;
    if (ring.length && !this.accepts(v, w, ring[where.gap], ring[this.after(star, where.gap)])) return hasChanged;
    if (!this.sees(v, w)) return hasChanged;
    ring.splice(ring.length ? where.gap + 1 : 0, 0, w);
    this.removeBeside(v, star, w);
    return true;
  }
  prune(v, star) {
    for (let i = 0, standing = 0; standing < star.ring.length;) {
      if (this.stands(v, star, i)) {
        ++standing;
        i = this.after(star, i);
      } else {
        star.ring.splice(i, 1);
        standing = 0;
        if (i >= star.ring.length) i = 0;
      }
    }
  }

  /** CONSTRUCTSTAR, from near to far, and again until nothing changes. */
  construct(v) {
    const { sites } = this, s = sites[v], order = [];
    for (let w = 0; w < sites.length; ++w) {
      if (w === v) continue;
      const dx = sites[w][0] - s[0], dy = sites[w][1] - s[1];
      order.push([s[2] * dx * dx + 2 * s[3] * dx * dy + s[4] * dy * dy, w]);
    }
    order.sort((a, b) => a[0] - b[0] || sites[a[1]][0] - sites[b[1]][0] || sites[a[1]][1] - sites[b[1]][1]);
    const star = this.emptyStar(v), count = order.length, mostRounds = 8;
    let refused = 0;
    for (let i = 0; i < mostRounds * count && refused < count; ++i) {
      const w = order[i % count][1];
      ++refused;
      if (star.ring.includes(w)) continue;
      if (this.offer(v, star, w)) {
        this.prune(v, star);
        refused = 0;
      }
    }
    star.isSettled = refused >= count;
    return star;
  }

  /** True if the star of v as it stands would change for w. */
  wouldAccept(v, w) {
    const star = this.stars[v], where = this.locate(v, star, w);
    if (!where) return false;
    if (where.ray !== undefined) {
      const u = star.ring[where.ray];
      return u !== w && !this.isForced(star, where.ray) && this.isBetween(v, w, u);
    }
    const { ring } = star;
    return (!ring.length || this.accepts(v, w, ring[where.gap], ring[this.after(star, where.gap)])) && this.sees(v, w);
  }

  // Marks the stars that contain w, or would accept it.
  markAround(w) {
    this.stars.forEach((star, v) => {
      if (v !== w && !this.stale.has(v) && (star.ring.includes(w) || this.wouldAccept(v, w))) this.stale.add(v);
    });
    this.stale.add(w);
    ++this.version;
  }

  move(w, site) {
    this.sites[w] = [...site];
    if (this.next.has(w)) {
      this.setBoundary(this.boundary);
      this.makeAllAnew();
    } else {
      this.markAround(w);
    }
  }
  add(site) {
    this.sites.push([...site]);
    this.stars.push(this.emptyStar(this.sites.length - 1));
    this.markAround(this.sites.length - 1);
    return this.sites.length - 1;
  }
  /** A site on the side from a to b, which it divides. */
  divide(a, b, site) {
    const m = this.sites.length, boundary = [...this.boundary];
    this.sites.push([...site]);
    boundary.splice(boundary.indexOf(a) + 1, 0, m);
    this.setBoundary(boundary);
    this.stars.push(this.emptyStar(m));
    // The stars of both ends begin at the new site.
    this.stale.add(a).add(b);
    this.markAround(m);
    return m;
  }
  /** Sites after it have their numbers less one. */
  remove(w) {
    const less = (v) => v > w ? v - 1 : v;
    const stale = new Set([...this.stale].filter((v) => v !== w).map(less));
    this.stars.forEach((star, v) => { if (v !== w && star.ring.includes(w)) stale.add(less(v)); });
    this.sites.splice(w, 1);
    this.stars.splice(w, 1);
    this.stars.forEach((star) => { star.ring = star.ring.filter((v) => v !== w).map(less); });
    if (this.boundary) this.setBoundary(this.boundary.map(less));
    this.stale = stale;
    ++this.version;
  }

  /** Makes stale stars anew for so many milliseconds; true if none is left. */
  settle(milliseconds = Infinity, now = () => performance.now()) {
    if (this.stale.size === 0) return true;
    const end = now() + milliseconds;
    for (const v of this.stale) {
      this.stars[v] = this.construct(v);
      this.stale.delete(v);
      if (now() > end) break;
    }
    ++this.version;
    return this.stale.size === 0;
  }

  *trianglesOf(v) {
    const { ring, isClosed } = this.stars[v];
    for (let i = 0; i < ring.length - (isClosed ? 0 : 1); ++i) {
      const x = ring[i], y = ring[(i + 1) % ring.length];
      if (x !== y && this.turn(v, x, y) > 0) yield [v, x, y];
    }
  }
  hasTriangle(v, x, y) {
    const { ring, isClosed } = this.stars[v], i = ring.indexOf(x);
    if (i < 0 || (!isClosed && i === ring.length - 1)) return false;
    return ring[(i + 1) % ring.length] === y && this.turn(v, x, y) > 0;
  }

  /** Definition 9: triangles of all three stars and of fewer, edges of one end's star alone, sites without a
   * settled star, and, in a polygon, gaps of half a turn. */
  agreement() {
    if (this.agreed?.version === this.version) return this.agreed;
    const triangles = [], disputed = [], halfEdges = [], gaps = [], seen = new Set();
    this.stars.forEach((star, v) => {
      for (const w of star.ring) if (!this.stars[w].ring.includes(v)) halfEdges.push([v, w]);
      for (const [, x, y] of this.trianglesOf(v)) {
        const turned = v < x && v < y ? [v, x, y] : x < y ? [x, y, v] : [y, v, x], key = turned.join();
        if (seen.has(key)) continue;
        seen.add(key);
        const holds = [this.hasTriangle(v, x, y), this.hasTriangle(x, y, v), this.hasTriangle(y, v, x)];
        if (holds.every(Boolean)) triangles.push(turned);
        else disputed.push({ where: turned, missingIn: [v, x, y].filter((_, i) => !holds[i]) });
      }
      if (this.boundary) gaps.push(...this.gapsOf(v));
    });
    const unsettled = this.stars.flatMap((star, v) => star.isSettled ? [] : [v]);
    const agree = disputed.length + halfEdges.length + gaps.length + unsettled.length === 0;
    return this.agreed = { version: this.version, triangles, disputed, halfEdges, gaps, unsettled, agree };
  }
  // Returns gaps of half a turn or more: v and the two neighbours.
  gapsOf(v) {
    const { ring, isClosed } = this.stars[v], gaps = [];
    if (ring.length < 2) return [[v, ring[0] ?? v, ring[0] ?? v]];
    for (let i = 0; i < ring.length - (isClosed ? 0 : 1); ++i) {
      const x = ring[i], y = ring[(i + 1) % ring.length];
      if (this.turn(v, x, y) <= 0) gaps.push([v, x, y]);
    }
    return gaps;
  }

  /** The question of the edge from v to w as v asks it: between which neighbours, the answer and the tier; null
   * where v has no triangle to divide and nothing is asked. */
  whyNeighbour(v, w) {
    const star = this.stars[v], at = star.ring.indexOf(w);
    let x, y;
    if (at >= 0) {
      if (this.isForced(star, at)) return null;
      x = star.ring[this.before(star, at)], y = star.ring[this.after(star, at)];
    } else {
      const where = this.locate(v, star, w);
      if (!where || where.gap === undefined || star.ring.length < 2) return null;
      x = star.ring[where.gap], y = star.ring[this.after(star, where.gap)];
    }
    if (x === y || this.turn(v, x, y) <= 0 || this.turn(x, y, w) > 0 || this.isSubsegment(x, y)) return null;
    const sites = this.question(v, w, x, y);
    return { v, w, x, y, sites, ...this.predicates.explain('edgeTest', ...sites) };
  }
}
