//! Where a line is inside a torus.

use super::lines::{bits, unit_bits};
use crate::geom::Line;
use crate::quadric::quartic::ReadyTorus;
use crate::quadric::{Ring, regular};
use crate::scalar::{Double, FixedPoint, integer};
use crate::span::Span;

/// The parameters on the grid: different numbers also where both round to the same.
fn rounded<S: FixedPoint>(ends: [f64; 2]) -> [S; 2] {
    let [enter, exit] = ends.map(|t| t * (1u64 << S::BITS) as f64);
    let nearest = |t: f64| Double::from(t).nearest();
    let [mut first, mut last] = [enter, exit].map(nearest);
    if first == last {
        first = nearest(0.5 * (enter + exit) - 0.5);
        last = first.saturating_add(1);
    }
    [first, last].map(|t| S::from_bits(integer::narrow(t)))
}

fn exact(v: [i64; 3]) -> [f64; 3] {
    v.map(|coordinate| coordinate as f64)
}

pub(in crate::quadric) fn ready_torus<S: FixedPoint>(ring: &Ring<S>) -> ReadyTorus<S> {
    let axis = unit_bits::<S>(ring.axis.vector());
    let [radius, tube] = [ring.radius, ring.tube].map(|length| f64::from(length.to_bits()));
    ReadyTorus::new(exact(bits(ring.center)), exact(axis), radius, tube)
}

pub(in crate::quadric) fn torus<S: FixedPoint>(
    torus: &ReadyTorus<S>,
    line: &Line<S>,
) -> [Option<Span<S>>; 2] {
    let [origin, direction] = [line.origin, line.direction].map(|v| exact(bits(v)));
    regular(torus.chords(origin, direction).map(|chord| chord.map(rounded)))
}
