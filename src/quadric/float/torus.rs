//! Where a line is inside a torus.

use crate::geom::Line;
use crate::quadric::quartic::Torus;
use crate::quadric::{Ring, regular};
use crate::scalar::Float;
use crate::span::Span;

pub(in crate::quadric) fn torus<S: Float>(ring: &Ring<S>, line: &Line<S>) -> [Option<Span<S>>; 2] {
    let [center, axis, origin, direction] =
        [ring.center, ring.axis.vector(), line.origin, line.direction]
            .map(|v| v.to_array().map(S::into));
    let torus = Torus::new(center, axis, ring.radius.into(), ring.tube.into());
    regular(torus.chords(origin, direction).map(|chord| chord.map(|ends| ends.map(S::from_f64))))
}
