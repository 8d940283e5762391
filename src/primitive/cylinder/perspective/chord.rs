//! Chords: where a ray from an eye meets the wall, from its own vectors.
//!
//! In a row, q = u × axis and m = d × axis are affine in the column, and so is k = u·m, because
//! all rays run through the eye. Both vectors are at right angles to the axis, so two coordinates
//! hold each of them.
//!
//! The columns that can meet the wall come from k as an affine number, but a pixel's k from its own q and
//! m, as they are rounded: then the three belong to one ray, which is a pixel's but for the rounding of
//! its point and direction, also where it is nearly parallel to the axis and m is small.

use super::super::{Cylinder, frame, set_common, wall_span};
use crate::geom::{Affine, Extent, PerspectiveRays, Vec3};
use crate::scalar::{Number, Real, Roots, Scalar};
use crate::scan::bounds::{PerspectiveBall, Silhouette, constant, extent};
use crate::scan::planes;
use crate::span::{Face, Span};

impl<S: Scalar> ChordView<S> {
    pub(super) fn new(cylinder: &Cylinder<S>, rays: &PerspectiveRays<S>) -> Self {
        let Cylinder { wall, caps } = cylinder;
        let axis = caps.normal.wide();
        let plane = &rays.plane;
        let inverse_distance = rays.inverse_distance;
        let [u, right, down] = plane.steps(wall.base.wide());
        let across = frame(axis);
        let flat = |moment: Vec3<S::Wide>| across.map(|side| side.dot(moment));
        let m = plane.forward.cross(axis);
        let [right, down] = [right, down].map(|step| {
            let moment = step.cross(axis);
            let k = step.dot_compensated(m) + inverse_distance * u.dot_compensated(moment);
            (flat(moment), k)
        });
        let at_eye = u.cross(axis) - m * rays.distance;
        let radius = wall.radius.wide();
        let (center, ball_radius) = cylinder.bounding_ball();
        Self {
            moment: [flat(u.cross(axis)), right.0, down.0],
            turn: flat(m),
            reach: [u.dot_compensated(m), right.1, down.1],
            blur: ((radius + S::ROUNDING.wide()) * S::ROUNDING.wide()).sqrt(),
            eye_within: at_eye.length_squared() < radius * radius,
            caps: planes::PerspectiveView::new(&caps.normal, rays),
            ball: PerspectiveBall::new(center, ball_radius, rays),
        }
    }

    #[inline]
    pub(super) fn is_in_rows(&self, rows: [i32; 2]) -> bool {
        self.ball.is_in_rows(rows)
    }

    pub(super) fn row(&self, y: i32) -> ChordRow<S> {
        let [[q0, q1], [right0, right1], [down0, down1]] = self.moment;
        let [m0, m1] = self.turn;
        let axis = |q, m, right, down| {
            let offset = Affine::row([S::Wide::ZERO, right, down], y);
            (offset.above(q), offset.times(self.caps.inverse_distance).above(m))
        };
        let ((q0, m0), (q1, m1)) = (axis(q0, m0, right0, down0), axis(q1, m1, right1, down1));
        let caps = planes::PerspectiveRow::new(&self.caps, y);
        ChordRow { moment: [q0, q1], turn: [m0, m1], caps }
    }

    /// The columns of a row.
    pub(super) fn extent(&self, row: &ChordRow<S>, radius: S, y: i32, columns: u32) -> Extent {
        let [m0, m1] = row.turn;
        let reach = Affine::row(self.reach, y);
        // r|m| ≥ |k| with k off by `ROUNDING`, however small m is: (r + b)²m² + (r + b)b ≥ (r|m| + b)².
        let radius = radius.plus(S::ROUNDING).wide();
        let wide = [m0.times(radius), m1.times(radius), constant(self.blur)];
        extent(&wide, &[reach], columns).overlap(self.ball.extent(y, columns))
    }
}

impl<S: Scalar> ChordRow<S> {
    /// Sets a ray's span to that of the cylinder, if there is one.
    #[inline(always)]
    pub(super) fn set_span(
        &self,
        cylinder: &Cylinder<S>,
        eye_within: bool,
        x: i32,
        span: &mut Span<S>,
    ) {
        let Cylinder { wall, caps } = cylinder;
        let q = self.moment.map(|part| S::from_wide(part.at(x)));
        let m = self.turn.map(|part| S::unit(part.at(x)));
        let chord = match S::chord(wall.radius, [S::moment(q, m)], q, m) {
            Some(Roots::Between(enter, exit)) => [enter, exit],
            None => match self.nearly_along(wall.radius, eye_within, x) {
                Some(chord) => chord,
                None => return,
            },
            _ => return,
        };
        let between = caps.perspective_roots(&self.caps, x);
        match between.roots {
            // For each order in its place: the faces are constants.
            Roots::Between(low, high) if between.upwards => {
                set_common(span, chord, [low, high], [Face(0), Face(1)]);
            }
            Roots::Between(low, high) => {
                set_common(span, chord, [high, low], [Face(1), Face(0)]);
            }
            Roots::Everywhere => {
                let [enter, exit] = chord;
                *span = wall_span(enter, exit).unwrap_or(Span::NOWHERE);
            }
            Roots::Outside => {}
        }
    }

    /// Where a ray is inside the wall that is nearly parallel to the axis, or exactly.
    ///
    /// In fixed point, a direction has less digits than what it is rounded from. These are enough for rays
    /// down to 2⁻¹⁸ radians.
    #[cold]
    #[inline(never)]
    fn nearly_along(&self, radius: S, eye_within: bool, x: i32) -> Option<[S; 2]> {
        if S::SHORTEST > S::ZERO {
            let sixteen = S::Wide::from_int(16);
            let q = self.moment.map(|part| S::from_wide(part.at(x)));
            let m = self.turn.map(|part| S::unit(part.at(x) * sixteen));
            match S::chord(radius, [S::moment(q, m)], q, m) {
                Some(Roots::Between(enter, exit)) => {
                    return Some([enter, exit].map(|t| S::from_wide(t.wide() * sixteen)));
                }
                Some(_) => return None,
                None => {}
            }
        }
        eye_within.then_some([S::LOWEST, S::HIGHEST])
    }
}

/// A cylinder, seen from an eye: values in the middle of the picture and their steps.
#[derive(Debug, Clone, Copy)]
pub struct ChordView<S: Scalar> {
    /// q.
    moment: [[S::Wide; 2]; 3],
    /// m in the middle; its steps are those of q times the convergence.
    turn: [S::Wide; 2],
    /// k.
    reach: [S::Wide; 3],
    /// √((r + b)b), where b is [`Scalar::ROUNDING`].
    blur: S::Wide,
    /// Whether the eye lies inside the infinite cylinder, and with it any ray along the axis.
    pub(super) eye_within: bool,
    caps: planes::PerspectiveView<S>,
    ball: PerspectiveBall<S>,
}

/// A row of a cylinder, seen from an eye.
#[derive(Debug, Clone, Copy)]
pub struct ChordRow<S: Scalar> {
    /// Two coordinates of q, and of m.
    pub(super) moment: [Affine<S::Wide>; 2],
    pub(super) turn: [Affine<S::Wide>; 2],
    pub(super) caps: planes::PerspectiveRow<S>,
}
