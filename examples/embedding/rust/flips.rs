// SPDX-License-Identifier: MIT
//
// flips SIZE ARITHMETIC: a host in Rust. A grid of SIZE^2 cells, its points moved a little, is made
// Delaunay in one metric by Lawson's flips. ARITHMETIC is exact or double: who says whether an edge is
// flipped. With exact signs the flips end, since each lowers the surface lifted to the metric's
// paraboloid; with rounded ones they may go round in circles, and the program stops after a bound.
//
// Prints flips, questions, nanoseconds a question, edges left that are not Delaunay and triangles
// inverted, both by the exact predicates. Exit status 1 if anything is wrong, 2 for bad usage.
mod predicates;
use predicates::{in_circle, orientation, Metric, Point, Refused};

/// (5, 2) and (2, 1) have length 1 in it and are at right angles: it sees the grid as squares, whose
/// four corners are on one circle, or nearly.
const METRIC: Metric = [5.0, -12.0, 29.0];

struct Mesh {
    points: Vec<Point>,
    corners: Vec<[usize; 3]>,
    /// The triangle across from each corner; NONE outside.
    beside: Vec<[usize; 3]>,
}

const NONE: usize = usize::MAX;

/// The same numbers on every machine (Numerical Recipes' generator, upper bits).
struct Random(u32);

impl Random {
    fn below(&mut self, n: u32) -> u32 {
        self.0 = self.0.wrapping_mul(1664525).wrapping_add(1013904223);
        (self.0 >> 8) % n
    }
}

fn grid(size: usize) -> Mesh {
    let mut random = Random(1);
    let at = |i: usize, j: usize| j * (size + 1) + i;
    let mut mesh = Mesh { points: vec![], corners: vec![], beside: vec![] };
    for j in 0..=size {
        for i in 0..=size {
            // Moved by a unit in the last place or two: lines and ellipses stay nearly common.
            let mut moved = |x: usize| {
                (x as f64 + 1.0) * (1.0 + (random.below(5) as f64 - 2.0) * f64::EPSILON)
            };
            mesh.points.push([moved(i), moved(j)]);
        }
    }
    for j in 0..size {
        for i in 0..size {
            mesh.corners.push([at(i, j), at(i + 1, j), at(i + 1, j + 1)]);
            mesh.corners.push([at(i, j), at(i + 1, j + 1), at(i, j + 1)]);
            let t = 2 * (j * size + i);
            let right = if i + 1 < size { t + 3 } else { NONE };
            let below = if j > 0 { t + 1 - 2 * size } else { NONE };
            let left = if i > 0 { t - 2 } else { NONE };
            let above = if j + 1 < size { t + 2 * size } else { NONE };
            mesh.beside.push([right, t + 1, below]);
            mesh.beside.push([above, left, t]);
        }
    }
    mesh
}

fn in_circle_of_doubles(m: &Metric, a: &Point, b: &Point, c: &Point, p: &Point) -> i32 {
    let square = |x: f64, y: f64| m[0] * x * x + 2.0 * m[1] * x * y + m[2] * y * y;
    let (ax, ay, bx, by) = (a[0] - p[0], a[1] - p[1], b[0] - p[0], b[1] - p[1]);
    let (cx, cy) = (c[0] - p[0], c[1] - p[1]);
    let det = square(ax, ay) * (bx * cy - by * cx) - square(bx, by) * (ax * cy - ay * cx)
        + square(cx, cy) * (ax * by - ay * bx);
    if det > 0.0 { 1 } else if det < 0.0 { -1 } else { 0 }
}

impl Mesh {
    fn triangle(&self, t: usize) -> [&Point; 3] {
        let c = self.corners[t];
        [&self.points[c[0]], &self.points[c[1]], &self.points[c[2]]]
    }

    /// The corner of t across from its neighbour s.
    fn across(&self, t: usize, s: usize) -> usize {
        (0..3).find(|&k| self.beside[t][k] == s).expect("neighbours know each other")
    }

    fn is_inside(&self, t: usize, p: usize, exact: bool) -> Result<bool, Refused> {
        let [a, b, c] = self.triangle(t);
        let p = &self.points[p];
        let sign = if exact {
            in_circle(&METRIC, a, b, c, p)?
        } else {
            in_circle_of_doubles(&METRIC, a, b, c, p)
        };
        Ok(sign > 0)
    }

    /// Replaces the edge between t, across from its corner k, and its neighbour by the other diagonal.
    fn flip(&mut self, t: usize, k: usize) {
        let s = self.beside[t][k];
        let l = self.across(s, t);
        let (p, q) = (self.corners[t][k], self.corners[s][l]);
        let (a, b) = (self.corners[t][(k + 1) % 3], self.corners[t][(k + 2) % 3]);
        let (beyond_b, beyond_a) = (self.beside[t][(k + 1) % 3], self.beside[t][(k + 2) % 3]);
        let (under_a, under_b) = (self.beside[s][(l + 1) % 3], self.beside[s][(l + 2) % 3]);
        // p a q and p q b; beside corner order: across from p, a, q and p, q, b.
        self.corners[t] = [p, a, q];
        self.beside[t] = [under_a, s, beyond_a];
        self.corners[s] = [p, q, b];
        self.beside[s] = [under_b, beyond_b, t];
        for (outer, old, new) in [(under_a, s, t), (beyond_b, t, s)] {
            if outer != NONE {
                let m = self.across(outer, old);
                self.beside[outer][m] = new;
            }
        }
    }

    /// Flips until no edge wants to. Returns flips and questions; fewer than wanted at the bound.
    fn make_delaunay(&mut self, exact: bool) -> Result<(usize, usize, bool), Refused> {
        let bound = 200 * self.corners.len();
        let mut waiting: Vec<usize> = (0..self.corners.len()).collect();
        let (mut flips, mut questions) = (0, 0);
        while let Some(t) = waiting.pop() {
            for k in 0..3 {
                let s = self.beside[t][k];
                if s == NONE {
                    continue;
                }
                let q = self.corners[s][self.across(s, t)];
                questions += 1;
                if self.is_inside(t, q, exact)? {
                    self.flip(t, k);
                    flips += 1;
                    waiting.push(s);
                    waiting.push(t);
                    break;
                }
            }
            if flips == bound {
                return Ok((flips, questions, false));
            }
        }
        Ok((flips, questions, true))
    }

    /// Edges that are not Delaunay and triangles that are inverted, exactly.
    fn faults(&self) -> Result<(usize, usize), Refused> {
        let (mut edges, mut inverted) = (0, 0);
        for t in 0..self.corners.len() {
            let [a, b, c] = self.triangle(t);
            inverted += usize::from(orientation(a, b, c)? <= 0);
            for &s in self.beside[t].iter().filter(|&&s| s != NONE && s > t) {
                let q = self.corners[s][self.across(s, t)];
                edges += usize::from(self.is_inside(t, q, true)?);
            }
        }
        Ok((edges, inverted))
    }
}

fn run(size: usize, exact: bool) -> Result<bool, Refused> {
    let mut mesh = grid(size);
    let start = std::time::Instant::now();
    let (flips, questions, ended) = mesh.make_delaunay(exact)?;
    let nanoseconds = start.elapsed().as_nanos() as f64 / questions as f64;
    let (edges, inverted) = mesh.faults()?;
    println!(
        "{}: {} triangles, {} flips{}, {} questions, {:.0} ns each, {} edges not Delaunay, {} inverted",
        if exact { "exact" } else { "double" },
        mesh.corners.len(),
        flips,
        if ended { "" } else { " (stopped)" },
        questions,
        nanoseconds,
        edges,
        inverted
    );
    Ok(ended && edges == 0 && inverted == 0)
}

fn refusals_are_told() -> bool {
    let nothing = [0.0, f64::NAN];
    orientation(&nothing, &[1.0, 0.0], &[0.0, 1.0]) == Err(Refused::NotFinite)
        && in_circle(&[1.0, 2.0, 1.0], &[0.0; 2], &[1.0, 0.0], &[0.0, 1.0], &[1.0; 2])
            == Err(Refused::NotPositiveDefinite)
}

fn main() {
    let words: Vec<String> = std::env::args().collect();
    let size = words.get(1).and_then(|w| w.parse().ok()).filter(|&n| (1..=3000).contains(&n));
    let exact = words.get(2).map(|w| w == "exact");
    let (size, exact) = match (size, exact) {
        (Some(size), Some(exact)) => (size, exact),
        _ => {
            eprintln!("flips SIZE exact|double (Asterism {})", predicates::version());
            std::process::exit(2);
        }
    };
    match run(size, exact) {
        Ok(well) if well && refusals_are_told() => {}
        Ok(_) => std::process::exit(1),
        Err(why) => {
            eprintln!("flips: a question was refused: {:?}", why);
            std::process::exit(1);
        }
    }
}
