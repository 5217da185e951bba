// SPDX-License-Identifier: MIT
//
// Asterism's predicates in Rust: the C interface declared, and behind functions that are safe. Add a
// predicate by its line in kernels/c_api.h.
use std::os::raw::c_int;

extern "C" {
    fn asterism_orientation(p: *const f64, q: *const f64, r: *const f64, answer: *mut c_int) -> c_int;
    fn asterism_in_circle(
        metric: *const f64,
        a: *const f64,
        b: *const f64,
        c: *const f64,
        p: *const f64,
        answer: *mut c_int,
    ) -> c_int;
    fn asterism_version() -> c_int;
}

pub type Point = [f64; 2];
/// m11 m12 m22.
pub type Metric = [f64; 3];

/// Why a question was refused: the numbers of `asterism_status`.
#[derive(Debug, PartialEq)]
pub enum Refused {
    NotFinite,
    NotPositiveDefinite,
    Other(i32),
}

fn answered(status: c_int, answer: c_int) -> Result<i32, Refused> {
    match status {
        0 => Ok(answer),
        2 => Err(Refused::NotFinite),
        3 => Err(Refused::NotPositiveDefinite),
        other => Err(Refused::Other(other)),
    }
}

/// 1: r is on the left of the line from p to q; -1: on its right; 0: on it.
pub fn orientation(p: &Point, q: &Point, r: &Point) -> Result<i32, Refused> {
    let mut answer = 0;
    // The arrays live through the call, and nothing keeps their addresses.
    let status = unsafe { asterism_orientation(p.as_ptr(), q.as_ptr(), r.as_ptr(), &mut answer) };
    answered(status, answer)
}

/// 1: p is inside the circle of the metric through a, b, c, which turn left; -1: outside; 0: on it.
pub fn in_circle(m: &Metric, a: &Point, b: &Point, c: &Point, p: &Point) -> Result<i32, Refused> {
    let mut answer = 0;
    let status = unsafe {
        asterism_in_circle(m.as_ptr(), a.as_ptr(), b.as_ptr(), c.as_ptr(), p.as_ptr(), &mut answer)
    };
    answered(status, answer)
}

/// That of the library linked.
pub fn version() -> i32 {
    unsafe { asterism_version() }
}
