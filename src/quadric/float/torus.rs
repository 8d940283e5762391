//! Where a line is inside a torus.

use crate::geom::Line;
use crate::quadric::quartic::ReadyTorus;
use crate::quadric::{Ring, regular};
use crate::scalar::Float;
use crate::span::Span;

pub(in crate::quadric) fn ready_torus<S: Float>(ring: &Ring<S>) -> ReadyTorus<S> {
    let [center, axis] = [ring.center, ring.axis.vector()].map(|v| v.to_array().map(S::into));
    ReadyTorus::new(center, axis, ring.radius.into(), ring.tube.into())
}

pub(in crate::quadric) fn torus<S: Float>(
    torus: &ReadyTorus<S>,
    line: &Line<S>,
) -> [Option<Span<S>>; 2] {
    let [origin, direction] = [line.origin, line.direction].map(|v| v.to_array().map(S::into));
    regular(torus.chords(origin, direction).map(|chord| chord.map(|ends| ends.map(S::from_f64))))
}
