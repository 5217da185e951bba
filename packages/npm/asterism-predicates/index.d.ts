// SPDX-License-Identifier: MIT
//
// y points UPWARDS: "left" and "counter-clockwise" are those of a mathematician's drawing, not those of
// a screen. The two functions of robust-predicates keep their own convention, told there.
//
// Every answer is exact for the doubles given. A number that is not finite, a metric of a site that is
// not positive definite and two sites at one position are refused with a RangeError; arguments of the
// wrong shape with a TypeError.

/** x, y. */
export type Point = ArrayLike<number>;
/** m11, m12, m22 of a symmetric matrix. The distance of u and v is sqrt((u - v)^T M (u - v)). */
export type Metric = ArrayLike<number>;
/** x, y, m11, m12, m22: a point and the metric by which it measures. */
export type Site = ArrayLike<number>;
export type Sign = -1 | 0 | 1;

/** Arguments as lists, or all of their numbers one after another: `f([0, 0], [1, 0], [0, 1])` is
 * `f(0, 0, 1, 0, 0, 1)`. */
export interface Question<Arguments extends unknown[], Answer> {
  (...given: Arguments): Answer;
  (...numbers: number[]): Answer;
}

/** One table an argument, a row for each question, its numbers side by side; a table of one row stands
 * for itself in every question. Answers are those of the function for one question, yes and no as 1 and 0. */
export type Batch<Tables extends Float64Array[]> = (...tables: Tables) => Int8Array;

type T = Float64Array;

export interface Predicates {
  /** 1: r lies to the left of the line from p to q (counter-clockwise, y upwards); -1: right; 0: on it. */
  readonly orientation: Question<[p: Point, q: Point, r: Point], Sign>;
  /** True if the metric is positive definite. */
  readonly isPositiveDefinite: Question<[metric: Metric], boolean>;
  /** -1: v is nearer to q, each by its own metric; 1: w; 0: q is on their bisector. */
  readonly compareDistance: Question<[v: Site, w: Site, q: Point], Sign>;
  /** True if q is strictly in the wedge of v and w. */
  readonly inWedge: Question<[v: Site, w: Site, q: Point], boolean>;
  /** 1: v dominates p over w; -1: w over v; 0: neither. */
  readonly dominates: Question<[v: Site, w: Site, p: Point], Sign>;
  /** How many points are equally near to u, v, w: 0 to 4, or -1 for infinitely many. */
  readonly voronoiVertexCount: Question<[u: Site, v: Site, w: Site], number>;
  /** How many points of the visible arc of v, w are as near to x: 0 to 4, or -1 for infinitely many. */
  readonly arcIntersectionCount: Question<[v: Site, w: Site, x: Site], number>;
  /** True if w is nearer than a and than b somewhere on the open segment ab. */
  readonly encroaches: Question<[a: Site, b: Site, w: Site], boolean>;
  /** True if w may stand in the star of v between its neighbours x and y. */
  readonly insertionTest: Question<[v: Site, w: Site, x: Site, y: Site], boolean>;
  /** The same with ties broken alike from every side: what a mesh generator should ask. */
  readonly edgeTest: Question<[v: Site, w: Site, x: Site, y: Site], boolean>;
  /** 1: p lies in the ellipse through a, b, c that is a circle in the metric, if a, b, c turn
   * counter-clockwise (y upwards); -1: outside; 0: on it. The other way round if they turn clockwise. */
  readonly inCircle: Question<[metric: Metric, a: Point, b: Point, c: Point, p: Point], Sign>;

  readonly orientations: Batch<[p: T, q: T, r: T]>;
  readonly arePositiveDefinite: Batch<[metric: T]>;
  readonly compareDistances: Batch<[v: T, w: T, q: T]>;
  readonly inWedges: Batch<[v: T, w: T, q: T]>;
  readonly dominations: Batch<[v: T, w: T, p: T]>;
  readonly voronoiVertexCounts: Batch<[u: T, v: T, w: T]>;
  readonly arcIntersectionCounts: Batch<[v: T, w: T, x: T]>;
  readonly encroachments: Batch<[a: T, b: T, w: T]>;
  readonly insertionTests: Batch<[v: T, w: T, x: T, y: T]>;
  readonly edgeTests: Batch<[v: T, w: T, x: T, y: T]>;
  readonly inCircles: Batch<[metric: T, a: T, b: T, c: T, p: T]>;

  /** orient2d of robust-predicates, with its sign: NEGATIVE where a, b, c turn counter-clockwise with y
   * upwards. The sign is exact, the value twice the area of the triangle within rounding. NaN, and never
   * a guess, where a number is not finite. */
  readonly orient2d: (ax: number, ay: number, bx: number, by: number, cx: number, cy: number) => number;
  /** incircle of robust-predicates, with its sign: positive where d lies in the circle of a, b, c that
   * turn counter-clockwise with y upwards. NaN where a number is not finite. */
  readonly incircle: (ax: number, ay: number, bx: number, by: number, cx: number, cy: number,
                      dx: number, dy: number) => number;

  /** The answer of a predicate, and the tier that decided. */
  readonly explain: (predicate: PredicateName, ...given: (ArrayLike<number> | number)[]) =>
    { answer: number | boolean; tier: Tier };
  /** How many questions each tier decided since the start, by predicate; orient2d counts as orientation,
   * incircle as inCircle. */
  readonly counters: () => Record<PredicateName, Record<Tier, number>>;
  readonly resetCounters: () => void;
  /** The version of the library in the module. */
  readonly version: string;
}

/** semiStatic: doubles with an error bound; interval: doubles that enclose; exact: whole numbers. */
export type Tier = 'semiStatic' | 'interval' | 'exact';
export type PredicateName = 'orientation' | 'isPositiveDefinite' | 'compareDistance' | 'inWedge' | 'dominates' |
  'voronoiVertexCount' | 'arcIntersectionCount' | 'encroaches' | 'insertionTest' | 'edgeTest' | 'inCircle';

export declare const orientation: Predicates['orientation'];
export declare const isPositiveDefinite: Predicates['isPositiveDefinite'];
export declare const compareDistance: Predicates['compareDistance'];
export declare const inWedge: Predicates['inWedge'];
export declare const dominates: Predicates['dominates'];
export declare const voronoiVertexCount: Predicates['voronoiVertexCount'];
export declare const arcIntersectionCount: Predicates['arcIntersectionCount'];
export declare const encroaches: Predicates['encroaches'];
export declare const insertionTest: Predicates['insertionTest'];
export declare const edgeTest: Predicates['edgeTest'];
export declare const inCircle: Predicates['inCircle'];
export declare const orientations: Predicates['orientations'];
export declare const arePositiveDefinite: Predicates['arePositiveDefinite'];
export declare const compareDistances: Predicates['compareDistances'];
export declare const inWedges: Predicates['inWedges'];
export declare const dominations: Predicates['dominations'];
export declare const voronoiVertexCounts: Predicates['voronoiVertexCounts'];
export declare const arcIntersectionCounts: Predicates['arcIntersectionCounts'];
export declare const encroachments: Predicates['encroachments'];
export declare const insertionTests: Predicates['insertionTests'];
export declare const edgeTests: Predicates['edgeTests'];
export declare const inCircles: Predicates['inCircles'];
export declare const orient2d: Predicates['orient2d'];
export declare const incircle: Predicates['incircle'];
export declare const explain: Predicates['explain'];
export declare const counters: Predicates['counters'];
export declare const resetCounters: Predicates['resetCounters'];
export declare const version: Predicates['version'];
