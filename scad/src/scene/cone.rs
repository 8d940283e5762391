//! A cone in plain `f64`, for pictures and measures: a tenth of the time of one whose every bit is right.

use crate::map::{Vector, length};
use scancsg::geom::Line;
use scancsg::span::{Crossing, Face, Span};

/// A cone along an axis of its frame. Face 0 is the cap at the lower end, 1 that at the upper one, 2 the wall.
#[derive(Debug)]
pub(super) struct Frustum {
    axis: usize,
    at: [f64; 2],
    ends: [f64; 2],
    lower: f64,
    /// How much the radius grows from the lower end to the upper one, for each unit.
    slope: f64,
}

impl Frustum {
    pub(super) const FACES: u16 = 3;

    pub(super) fn of(axis: usize, at: [f64; 2], radii: [f64; 2], ends: [f64; 2]) -> Self {
        let slope = (radii[1] - radii[0]) / (ends[1] - ends[0]);
        Self { axis, at, ends, lower: radii[0], slope }
    }

    /// A vector's coordinates across the axis, and along it.
    fn split(&self, vector: Vector) -> ([f64; 2], f64) {
        let Vector { x, y, z } = vector;
        match self.axis {
            0 => ([y, z], x),
            1 => ([x, z], y),
            _ => ([x, y], z),
        }
    }

    /// The part of a line that is inside.
    ///
    /// With q + t·m across the axis and a radius of R + t·R′ at the line's height, the wall is where
    /// |q + t·m|² = (R + t·R′)². The discriminant is |R·m − R′·q|² − (q × m)², in which no large squares cancel.
    pub(super) fn span(&self, line: &Line<f64>, first: Face) -> Option<Span<f64>> {
        let (origin, height) = self.split(line.origin);
        let (m, speed) = self.split(line.direction);
        let q = [origin[0] - self.at[0], origin[1] - self.at[1]];
        let [radius, growth] =
            [self.lower + self.slope * (height - self.ends[0]), self.slope * speed];
        let a = m[0] * m[0] + m[1] * m[1] - growth * growth;
        let b = q[0] * m[0] + q[1] * m[1] - radius * growth;
        let c = q[0] * q[0] + q[1] * q[1] - radius * radius;
        let [u, v] = [0, 1].map(|i| radius * m[i] - growth * q[i]);
        let k = q[0] * m[1] - q[1] * m[0];
        let discriminant = u * u + v * v - k * k;
        let inside = if a > 0.0 {
            // One nappe, met twice or not at all.
            if discriminant < 0.0 {
                return None;
            }
            let s = discriminant.sqrt() + b.abs();
            let [near, far] = if b > 0.0 { [-s / a, -c / s] } else { [c / s, s / a] };
            if radius + growth * (near + far) / 2.0 < 0.0 {
                return None;
            }
            [near, far]
        } else {
            // Steeper than the side, both nappes, each met once: the one towards which the radius grows.
            let s = discriminant.max(0.0).sqrt() + b.abs();
            let other = if a < 0.0 { s / a } else { f64::NEG_INFINITY };
            let [one, two] = if b > 0.0 { [-c / s, -other] } else { [other, c / s] };
            match () {
                () if growth > 0.0 => [one.max(two), f64::INFINITY],
                () if growth < 0.0 => [f64::NEG_INFINITY, one.min(two)],
                () => return None,
            }
        };
        let wall = first.offset(2);
        let mut span = Span {
            enter: Crossing { t: inside[0], face: wall },
            exit: Crossing { t: inside[1], face: wall },
        };
        if speed == 0.0 {
            // As for a box: one of two solids on either side of a plane has it.
            let [low, high] = self.ends.map(|end| end - height);
            if !(low <= 0.0 && 0.0 < high) {
                return None;
            }
        } else {
            let [low, high] = [0, 1].map(|i| Crossing {
                t: (self.ends[i] - height) / speed,
                face: first.offset(i as u16),
            });
            let [near, far] = if speed > 0.0 { [low, high] } else { [high, low] };
            if near.t > span.enter.t {
                span.enter = near;
            }
            if far.t < span.exit.t {
                span.exit = far;
            }
        }
        Span::new(span.enter, span.exit)
    }

    /// The normal of a face, at a point on it.
    pub(super) fn normal(&self, face: Face, at: Vector) -> Vector {
        let (across, _) = self.split(at);
        let away = [across[0] - self.at[0], across[1] - self.at[1]];
        let from_axis = away[0].hypot(away[1]).max(f64::MIN_POSITIVE);
        let (u, along) = match face.0 {
            0 => ([0.0; 2], -1.0),
            1 => ([0.0; 2], 1.0),
            _ => (away.map(|part| part / from_axis), -self.slope),
        };
        let normal = match self.axis {
            0 => Vector::new(along, u[0], u[1]),
            1 => Vector::new(u[0], along, u[1]),
            _ => Vector::new(u[0], u[1], along),
        };
        normal * (1.0 / length(normal))
    }
}

#[cfg(test)]
mod tests {
    use super::Frustum;
    use scancsg::geom::{Axis, Line, vec3};
    use scancsg::solid::{Cone, Solid};
    use scancsg::span::{Face, SpanList};

    /// Lines in all directions, along the axis and the side among them.
    #[test]
    fn spans_and_normals_are_those_of_the_exact_cone() -> Result<(), scancsg::solid::ConeError> {
        let steps = [-2.0, -1.0, -0.4, 0.0, 0.3, 1.0];
        let mut hits = 0;
        for (index, axis) in [Axis::X, Axis::Y, Axis::Z].into_iter().enumerate() {
            for radii in [[1.0, 0.25], [0.0, 1.5], [2.0, 1.0]] {
                let exact = Cone::<f64>::along(axis, [0.25, -0.5], radii, -1.0, 1.5)?;
                let plain = Frustum::of(index, [0.25, -0.5], radii, [-1.0, 1.5]);
                for d in steps.iter().flat_map(|x| steps.iter().map(move |y| (*x, *y))) {
                    for z in steps {
                        for from in steps {
                            let direction = vec3(d.0, d.1, z);
                            let line = Line {
                                origin: vec3(from * 0.7, 0.11, 0.33 - from * 0.2),
                                direction,
                            };
                            if direction.max_abs() == 0.0 {
                                continue;
                            }
                            let mut list = SpanList::<f64, 1>::new();
                            exact.spans(&line, Face(0), &mut list.stack());
                            let want = list.first().copied();
                            let got = plain.span(&line, Face(0));
                            let ends = |span: scancsg::span::Span<f64>| [span.enter, span.exit];
                            let (Some(want), Some(got)) = (want, got) else {
                                assert_eq!(want.is_some(), got.is_some(), "{line:?} {plain:?}");
                                continue;
                            };
                            hits += 1;
                            for (want, got) in ends(want).into_iter().zip(ends(got)) {
                                assert!((want.t - got.t).abs() < 1e-9, "{want:?} {got:?} {line:?}");
                                let at = line.at(got.t);
                                let [one, two] =
                                    [exact.normal(want.face, at), plain.normal(got.face, at)];
                                assert!((one - two).max_abs() < 1e-9, "{one:?} {two:?}");
                            }
                        }
                    }
                }
            }
        }
        assert!(hits > 3_000, "{hits}");
        Ok(())
    }
}
