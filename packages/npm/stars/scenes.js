// SPDX-License-Identifier: MIT
//
// The scenes of the page: metric fields, and the thesis's figures as sites that can be dragged. The
// fields are drawn in doubles here. The mesher gets them as polynomials (docs/manual/metrics.md).
import { randomFrom, ofEigenvalues, metricOfAxes } from './plane.js';

// `at` takes the strength, and centre and half of the longer side of the domain's box.
const stretched = (tensor) => (k, [cx, cy, half] = [0, 0, 1]) => (x, y) => tensor(k, (x - cx) / half, (y - cy) / half);
export const FIELDS = {
  swirl: { title: 'swirl', words: 'stretched along circles', hasStrength: true, at: stretched((k, x, y) => [1 + k * x * x, k * x * y, 1 + k * y * y]) },
  sink: { title: 'sink', words: 'stretched along rays', hasStrength: true, at: stretched((k, x, y) => [1 + k * y * y, -k * x * y, 1 + k * x * x]) },
  identity: { title: 'everywhere round', words: 'the metric of the ruler', hasStrength: false, at: () => () => [1, 0, 1] },
};

/** A field from the sites' own ellipses: means of logarithms, the nearer the heavier. */
export function fieldOfSites(sites) {
  const logs = sites.map((s) => ofEigenvalues(s.slice(2), Math.log));
  return (x, y) => {
    const sum = [0, 0, 0];
    let weight = 0;
    for (let i = 0; i < sites.length; ++i) {
      const d = (sites[i][0] - x) ** 2 + (sites[i][1] - y) ** 2;
      if (d === 0) return sites[i].slice(2);
      const w = 1 / (d * d);
      weight += w;
      for (let k = 0; k < 3; ++k) sum[k] += w * logs[i][k];
    }
    return expOf(sum.map((s) => s / weight));
  };
}

// Returns the exponential of a symmetric matrix, positive definite or not.
function expOf([a, b, c]) {
  const mean = (a + c) / 2, half = (a - c) / 2, r = Math.hypot(half, b), e = Math.exp(mean);
  const even = e * Math.cosh(r), odd = r === 0 ? e : e * Math.sinh(r) / r;
  return [even + odd * half, odd * b, even - odd * half];
}

export const SQUARE = [[-1, -1], [1, -1], [1, 1], [-1, 1]];

function randomPoints(count, seed, reach = 0.94) {
  const random = randomFrom(seed);
  return Array.from({ length: count }, () => [reach * (2 * random() - 1), reach * (2 * random() - 1)]);
}

const thesisSquare = (field, strength, angleBound, strategy) => ({
  field: { name: field, strength }, polygon: SQUARE, points: randomPoints(10, 7), angleBound, strategy,
});

// Draws sites, each the farthest from earlier ones among many random places.
function spreadPoints(count, seed, width, height) {
  const random = randomFrom(seed), points = [];
  while (points.length < count) {
    let best = null, most = -1;
    for (let k = 0; k < 60; ++k) {
      const x = width * (2 * random() - 1), y = height * (2 * random() - 1);
      const apart = Math.min(9, ...points.map((p) => Math.hypot(p[0] - x, p[1] - y)));
      if (apart > most) most = apart, best = [x, y];
    }
    points.push(best);
  }
  return points;
}

function ownEllipses() {
  const random = randomFrom(21);
  return spreadPoints(22, 5, 1.35, 0.85).map(([x, y]) => [x, y, ...metricOfAxes(
    { long: 0.9 + 1.1 * random(), short: 0.5 + 0.3 * random(), angle: Math.atan2(y, x) + Math.PI / 2 + 1.1 * (random() - 0.5) })]);
}

const FOUR = [[-1, 0.1, 1, 0, 1], [1.1, 0, 1, 0, 1], [0.05, -0.95, 1, 0.2, 3], [0, 1, 3, -0.3, 1]];

/** In the order of the list. `layers` are those that are shown; others stay as they are. */
export const SCENES = [
  { id: 'stars', title: 'Drag sites and their ellipses', figure: '',
    words: 'Every site measures distances by its own ellipse, and makes its own star from that. Drag a site; choose one and pull its ellipse by the two handles. Where two stars disagree, the edge has one half only.',
    make: () => ({ sites: ownEllipses(), selected: 4, layers: { ellipses: true, diagram: true, cell: true, wedge: false, warp: false } }) },
  { id: 'figure-3-2', title: 'Four sites', figure: '3.2',
    words: 'The thesis begins with four sites and the circles of c and of d. Which diagonal should the four have, ab or cd?',
    make: () => ({ sites: FOUR, names: 'abcd', selected: 2, other: 3, ellipseScale: 0.5, ellipsesOf: [2, 3],
                   layers: { ellipses: true, diagram: false, cell: false, wedge: false, warp: false } }) },
  { id: 'figure-3-3', title: 'As c and d see them', figure: '3.3',
    words: 'Each site warps the plane until its own circles are round, and triangulates there as Delaunay would. Naive stars made so contradict each other: cd is in the star of d, not in that of c. Switch to the insertion test, and all four make one choice.',
    make: () => ({ sites: FOUR, names: 'abcd', selected: 2, other: 3, ellipseScale: 0.5, ellipsesOf: [2, 3], isNaive: true,
                   layers: { ellipses: true, diagram: false, cell: false, wedge: false, warp: true } }) },
  { id: 'wedge', title: 'Wedge and arc', figure: '3.4-3.7',
    words: 'The wedge of two sites is where both see the other less than 90 degrees away. The insertion test asks for a point of their Voronoi arc that both dominate over the neighbours beside: the thick part of the arc.',
    make: () => ({ sites: FOUR, names: 'abcd', selected: 0, other: 1, ellipseScale: 0.4,
                   layers: { ellipses: true, diagram: false, cell: true, wedge: true, warp: false } }) },
  { id: 'figure-5-1', title: 'The swirl', figure: '5.1', words: 'A metric field: an ellipse at every place, here stretched along circles around the middle. Pull the strength K.',
    make: () => ({ ...thesisSquare('swirl', 12, 20, 'arcs'), layers: { field: true, ellipses: false, diagram: false, cell: false, wedge: false, warp: false } }) },
  { id: 'figure-5-2', title: 'The sink', figure: '5.2', words: 'The other field of the thesis: stretched along rays towards the middle.',
    make: () => ({ ...thesisSquare('sink', 12, 20, 'arcs'), layers: { field: true, ellipses: false, diagram: false, cell: false, wedge: false, warp: false } }) },
  ...[['5.3', 'swirl', 'arcs', [5, 10, 15, 20]], ['5.4', 'sink', 'arcs', [5, 10, 15, 20]],
      ['5.5', 'swirl', 'darts', [5, 10]], ['5.6', 'sink', 'darts', [5, 10]]].map(([figure, field, strategy, bounds]) => ({
    id: `figure-${figure.replace('.', '-')}`, figure, bounds,
    title: `${field === 'swirl' ? 'Swirl' : 'Sink'}, ${strategy === 'arcs' ? 'by Voronoi arcs' : 'by Poisson darts'}`,
    words: strategy === 'arcs'
      ? 'A square with ten random points. Press refine: encroached sides are split, then the worst triangle gets a site at a Voronoi vertex of its three corners, or where an arc leaves its wedge, until all stars agree and no angle is too small.'
      : 'The same, with darts thrown around the bad triangles. A dart becomes a site if it is far enough from all others.',
    make: () => ({ ...thesisSquare(field, strategy === 'arcs' ? 12 : 3, bounds.at(-1), strategy),
                   layers: { field: false, ellipses: false, diagram: false, cell: false, wedge: false, warp: false } }) })),
  { id: 'two-hundred', title: 'Two hundred sites', figure: '', words: 'Two hundred sites in a swirl, without a border. Drag one: the stars around it are made anew at every frame, exactly.',
    make: () => ({ field: { name: 'swirl', strength: 3 }, points: spreadPoints(200, 11, 1.45, 0.95), layers: { ellipses: true, diagram: false, cell: true, wedge: false, warp: false, field: false } }) },
  { id: 'ties', title: 'Ties: a grid', figure: '', words: 'Every four neighbours of a grid are on one circle: doubles cannot tell which diagonal, exact numbers see a tie, and the rule for ties gives all stars the same answer. Look at what decided.',
    make: () => ({ sites: Array.from({ length: 49 }, (_, i) => [(i % 7 - 3) / 4, (Math.floor(i / 7) - 3) / 4, 1, 0, 1]),
                   selected: 24, layers: { ellipses: false, diagram: false, cell: true, wedge: false, warp: false, tiers: true } }) },
];
