//! The cylinder, seen from an eye.
//!
//! In a row, q = u × axis and m = d × axis are affine in the column, and so is k = u·m, because
//! all rays run through the eye. Both vectors are at right angles to the axis, so two coordinates
//! hold each of them.
//!
//! The columns that can meet the wall come from k as an affine number, but a pixel's k from its own q and
//! m, as they are rounded: then the three belong to one ray, which is a pixel's but for the rounding of
//! its point and direction, also where it is nearly parallel to the axis and m is small.

use super::{Cylinder, frame, set_common, wall_span};
use crate::geom::{Affine, Extent, PerspectiveRays, Vec3};
use crate::scalar::{Number, Real, Roots, Scalar};
use crate::scan::bounds::{PerspectiveBall, Silhouette, constant, extent};
use crate::scan::{Leaf, planes};
use crate::span::{Face, Span};

impl<S: Scalar> Leaf<PerspectiveRays<S>> for Cylinder<S> {
    type View = Option<PerspectiveView<S>>;
    type Row = Option<PerspectiveRow<S>>;
    type Spans = [Span<S>; 1];

    fn view(&self, rays: &PerspectiveRays<S>) -> Self::View {
        let axis = self.caps.normal.wide();
        let plane = &rays.plane;
        let inverse_distance = rays.inverse_distance;
        let [u, right, down] = plane.steps(self.wall.base.wide());
        let across = frame(axis);
        let flat = |moment: Vec3<S::Wide>| across.map(|side| side.dot(moment));
        let m = plane.forward.cross(axis);
        let [right, down] = [right, down].map(|step| {
            let moment = step.cross(axis);
            let k = step.dot_compensated(m) + inverse_distance * u.dot_compensated(moment);
            (flat(moment), k)
        });
        let at_eye = u.cross(axis) - m * rays.distance;
        let radius = self.wall.radius.wide();
        let (center, ball_radius) = self.bounding_ball();
        Some(PerspectiveView {
            moment: [flat(u.cross(axis)), right.0, down.0],
            turn: flat(m),
            reach: [u.dot_compensated(m), right.1, down.1],
            blur: ((radius + S::ROUNDING.wide()) * S::ROUNDING.wide()).sqrt(),
            eye_within: at_eye.length_squared() < radius * radius,
            caps: planes::PerspectiveView::new(&self.caps.normal, rays),
            ball: PerspectiveBall::new(center, ball_radius, rays),
        })
    }

    #[inline]
    fn is_in_rows(&self, view: &Self::View, rows: [i32; 2]) -> bool {
        view.as_ref().is_some_and(|view| view.ball.is_in_rows(rows))
    }

    #[inline(never)]
    fn row(&self, view: &Self::View, y: i32, columns: u32, row: &mut Self::Row) -> Extent {
        *row = None;
        let Some(view) = view else { return Extent::EMPTY };
        let [[q0, q1], [right0, right1], [down0, down1]] = view.moment;
        let [m0, m1] = view.turn;
        let axis = |q, m, right, down| {
            let offset = Affine::row([S::Wide::ZERO, right, down], y);
            (offset.above(q), offset.times(view.caps.inverse_distance).above(m))
        };
        let ((q0, m0), (q1, m1)) = (axis(q0, m0, right0, down0), axis(q1, m1, right1, down1));
        let reach = Affine::row(view.reach, y);
        // r|m| ≥ |k| with k off by `ROUNDING`, however small m is: (r + b)²m² + (r + b)b ≥ (r|m| + b)².
        let radius = self.wall.radius.plus(S::ROUNDING).wide();
        let wide = [m0.times(radius), m1.times(radius), constant(view.blur)];
        let silhouette = extent(&wide, &[reach], columns);
        let caps = planes::PerspectiveRow::new(&view.caps, y);
        *row = Some(PerspectiveRow { moment: [q0, q1], turn: [m0, m1], caps });
        silhouette.overlap(view.ball.extent(y, columns))
    }

    #[inline(always)]
    fn spans(&self, view: &Self::View, row: &Self::Row, x: i32, [span]: &mut [Span<S>; 1]) {
        *span = Span::NOWHERE;
        let (Some(view), Some(row)) = (view, row) else { return };
        let q = row.moment.map(|part| S::from_wide(part.at(x)));
        let m = row.turn.map(|part| S::unit(part.at(x)));
        let chord = match S::chord(self.wall.radius, [S::moment(q, m)], q, m) {
            Some(Roots::Between(enter, exit)) => [enter, exit],
            None => match self.nearly_along(view, row, x) {
                Some(chord) => chord,
                None => return,
            },
            _ => return,
        };
        let between = self.caps.perspective_roots(&row.caps, x);
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
}

impl<S: Scalar> Cylinder<S> {
    /// Where a ray is inside the wall that is nearly parallel to the axis, or exactly.
    ///
    /// In fixed point, a direction has less digits than what it is rounded from. These are enough for rays
    /// down to 2⁻¹⁸ radians.
    #[cold]
    #[inline(never)]
    fn nearly_along(
        &self,
        view: &PerspectiveView<S>,
        row: &PerspectiveRow<S>,
        x: i32,
    ) -> Option<[S; 2]> {
        if S::SHORTEST > S::ZERO {
            let sixteen = S::Wide::from_int(16);
            let q = row.moment.map(|part| S::from_wide(part.at(x)));
            let m = row.turn.map(|part| S::unit(part.at(x) * sixteen));
            match S::chord(self.wall.radius, [S::moment(q, m)], q, m) {
                Some(Roots::Between(enter, exit)) => {
                    return Some([enter, exit].map(|t| S::from_wide(t.wide() * sixteen)));
                }
                Some(_) => return None,
                None => {}
            }
        }
        view.eye_within.then_some([S::LOWEST, S::HIGHEST])
    }
}

/// A cylinder, seen from an eye: values in the middle of the picture and their steps.
#[derive(Debug, Clone, Copy)]
pub struct PerspectiveView<S: Scalar> {
    /// q.
    moment: [[S::Wide; 2]; 3],
    /// m in the middle; its steps are those of q times the convergence.
    turn: [S::Wide; 2],
    /// k.
    reach: [S::Wide; 3],
    /// √((r + b)b), where b is [`Scalar::ROUNDING`].
    blur: S::Wide,
    /// Whether the eye lies inside the infinite cylinder, and with it any ray along the axis.
    eye_within: bool,
    caps: planes::PerspectiveView<S>,
    ball: PerspectiveBall<S>,
}

/// A row of a cylinder, seen from an eye.
#[derive(Debug, Clone, Copy)]
pub struct PerspectiveRow<S: Scalar> {
    /// Two coordinates of q, and of m.
    moment: [Affine<S::Wide>; 2],
    turn: [Affine<S::Wide>; 2],
    caps: planes::PerspectiveRow<S>,
}
